// A structure as a program would make it, with given values: how many bytes its memories have.
#pragma once

#include "ir/ir.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gliftc {

/// One memory of a structure that is made, or of a structure that it makes. Levels and layers of another image
/// (ir::Memory::part) have no bytes of their own, and are not listed.
struct MadeMemory {
    std::string path;                    ///< `pages.wanted.data`
    std::optional<std::uint64_t> bytes;  ///< absent: not known, mostly since it depends on structures that are
                                         ///< passed to the constructor
    /// `elements of field` or `table of field`, where the translator of the structure with the path `field` (`it`: the
    /// structure that is made) reads tables; empty for the memories of other structures.
    std::string role;
};

struct MadeStructure {
    std::string arguments;  ///< as text
    std::vector<MadeMemory> memories;
};

/// The structure made with these numbers: the scalars of all values that its constructor takes, in order. Absent if the
/// numbers do not fit; `problem` then says why.
std::optional<MadeStructure> made_with(const ir::Program& program, const ir::Structure& structure,
                                       const std::vector<double>& numbers, std::string& problem);

}  // namespace gliftc
