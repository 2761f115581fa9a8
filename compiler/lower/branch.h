// For lowering kernels on several threads (pipeline.cpp). The program is the trunk, of which each thread has a branch:
// a program that sees the trunk's nodes, which no thread changes meanwhile, and adds its own. Afterwards the branches'
// nodes are moved to the trunk in the order of the kernels ("grafted"), so that the result does not depend on which
// thread did what. Expressions and statements are not copied: the arenas hand over whole blocks of memory.
#pragma once

#include "ir/pass.h"
#include "lower/compact.h"

#include <vector>

namespace gliftc::lower {

struct Branch {
    /// The trunk must outlive the branch, and must not change until the branch has added its last node.
    explicit Branch(const ir::Program& trunk);
    Branch(const Branch&) = delete;

    Names names;
    ir::Program program;
    // Names and types with ids below first_name and first_type are the trunk's own. For those that the branch added,
    // trunk_names and trunk_types have the trunk's ids, as far as they have been grafted.
    const std::uint32_t first_name, first_type;
    std::vector<Name> trunk_names;
    std::vector<ir::TypeId> trunk_types;
};

/// The nodes that a branch made for one kernel: those from `begin` to `end`. They refer only to each other and to nodes
/// of the trunk. After grafting they are in the trunk from `to` on.
struct Growth {
    Branch* branch = nullptr;
    Mark begin, end;
    std::uint32_t names = 0, types = 0;  ///< how many names and types the branch had at `end`
    Mark to;
};

/// Prepares the program for branches: fills up the last blocks of its arenas of expressions and statements, so that
/// those that branches add begin new blocks. Called once before the branches are made.
void ready_for_branches(ir::Program& trunk);

/// Calls `make`, which lowers one kernel in the branch, and returns the range of nodes that this added. Fills up the
/// last blocks of expressions and statements, since graft() moves whole blocks.
template <class Make> Growth grown(Branch& branch, Make&& make) {
    const Mark begin(branch.program);
    make();
    branch.program.exprs.fill_block();
    branch.program.stmts.fill_block();
    const Mark end(branch.program);
    return {&branch, begin, end, branch.names.size(), branch.program.types.size(), end};
}

/// Moves the growth's nodes to the trunk and sets growth.to. Called for one growth at a time, in the order of the
/// kernels, which is also the order in which each branch made its growths.
void graft(ir::Program& trunk, Growth& growth);

/// Replaces the branch's ids in the grafted nodes, and in the forms that refer to them, by the trunk's. Different
/// growths may be settled on different threads.
void settle(ir::Program& trunk, const Growth& growth, ir::Lowered::Forms& forms);

}  // namespace gliftc::lower
