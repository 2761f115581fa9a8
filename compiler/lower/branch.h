// Kernels lowered on several threads: each thread adds nodes to a branch of the program, which sees the program's own
// and leaves them as they are. Afterwards the nodes become the program's, kernel by kernel, so that nothing depends on
// which thread did what. Expressions and statements stay where they are, and change hands by the block.
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
    // What its own names and types are in the trunk, as far as it has been grafted; those before the first are the
    // trunk's.
    const std::uint32_t first_name, first_type;
    std::vector<Name> trunk_names;
    std::vector<ir::TypeId> trunk_types;
};

/// What a branch made for one kernel, and where that is in the trunk. Of the nodes that are not the trunk's they name
/// each other alone.
struct Growth {
    Branch* branch = nullptr;
    Mark begin, end;
    std::uint32_t names = 0, types = 0;  ///< of the branch in the end
    Mark to;
};

/// Readies the program for branches.
void ready_for_branches(ir::Program& trunk);

/// Lets `make` add to the branch what belongs together.
template <class Make> Growth grown(Branch& branch, Make&& make) {
    const Mark begin(branch.program);
    make();
    branch.program.exprs.fill_block();
    branch.program.stmts.fill_block();
    const Mark end(branch.program);
    return {&branch, begin, end, branch.names.size(), branch.program.types.size(), end};
}

/// Gives the nodes to the trunk. One growth after the other, in the order of the kernels; each branch's in the order in
/// which it made them.
void graft(ir::Program& trunk, Growth& growth);

/// Gives the grafted nodes, and the forms, which name them, the trunk's ids. Different growths on different threads.
void settle(ir::Program& trunk, const Growth& growth, ir::Lowered::Forms& forms);

}  // namespace gliftc::lower
