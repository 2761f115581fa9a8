// Garbage collection of nodes after a kernel has been lowered. Each step of lowering makes new nodes, so that in the
// end most nodes are unreachable from the lowered passes. Once they are removed, the next kernel reuses their memory,
// which is still in the caches.
#pragma once

#include "ir/pass.h"

#include <span>

namespace gliftc::lower {

/// How many nodes of each kind a program had at one time.
struct Mark {
    explicit Mark(const ir::Program& program)
        : exprs(program.exprs.size()), stmts(program.stmts.size()), locals(program.locals.size()),
          functions(program.functions.size()) {}
    std::uint32_t exprs, stmts, locals, functions;
};

/// Removes expressions and statements made after `mark` that cannot be reached from the passes or from functions made
/// after it. The others keep their order and get ids without gaps. Needs: nothing else refers to nodes made after the
/// mark.
void compact(ir::Program& program, const Mark& mark, std::span<ir::Pass* const> passes);

}  // namespace gliftc::lower
