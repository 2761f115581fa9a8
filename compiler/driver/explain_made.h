// What `gliftc explain --made` says: the memories of a structure with given arguments.
#pragma once

#include "driver/compile.h"
#include "driver/made.h"

#include <string>
#include <vector>

namespace gliftc {

struct ExplainedMade {
    std::string name;
    MadeStructure made;

    std::uint64_t bytes() const;  ///< the sum for the memories whose sizes are known
};

/// The structures that the calls, texts of the form `Name(numbers)`, make, in the order of the calls. If something is
/// wrong with one of the calls, the result is empty and `problem` says what is wrong.
std::vector<ExplainedMade> explained_made(const Compilation& compilation, const std::vector<std::string>& calls,
                                          std::string& problem);

/// 1536 as `1.5 KiB`.
std::string bytes_text(std::uint64_t bytes);

}  // namespace gliftc
