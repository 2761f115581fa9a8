// Kernels lowered on several threads: each thread adds nodes to a branch of the program, which sees the program's own
// and leaves them as they are. Afterwards the nodes are moved into the program, kernel by kernel, so that nothing
// depends on which thread did what.
#pragma once

#include "ir/pass.h"
#include "lower/compact.h"

#include <vector>

namespace gliftc::lower {

struct Branch {
    /// The trunk outlives it, and stays as it is until the branch has nothing more to add.
    explicit Branch(const ir::Program& trunk);
    Branch(const Branch&) = delete;

    Names names;
    ir::Program program;
    // What its own names and types are in the trunk, where that has been asked; those before the first are the trunk's.
    const std::uint32_t first_name, first_type;
    std::vector<Name> trunk_names;
    std::vector<ir::TypeId> trunk_types;
};

/// The nodes that a branch made between two marks. Of those that are not the trunk's they name each other alone.
struct Growth {
    Branch* branch = nullptr;
    Mark begin, end;
};

/// Moves the nodes into the trunk, and gives the forms, which name them, the new ids.
void graft(ir::Program& trunk, const Growth& growth, ir::Lowered::Forms& forms);

}  // namespace gliftc::lower
