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

    std::uint64_t bytes() const;  ///< of the memories that are known
};

/// Of each `Name(numbers)`; what is wrong with one of them is the `problem`.
std::vector<ExplainedMade> explained_made(const Compilation& compilation, const std::vector<std::string>& calls,
                                          std::string& problem);

/// 1536 as `1.5 KiB`.
std::string bytes_text(std::uint64_t bytes);

}  // namespace gliftc
