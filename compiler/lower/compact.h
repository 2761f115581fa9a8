// Garbage collection of nodes after a kernel has been lowered. Each step of lowering makes new nodes, so that in the
// end nine of ten are unreachable from any pass; once they are removed, the next kernel reuses memory that is in the
// caches.
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

/// Removes expressions and statements made after `mark` that neither the passes nor functions made after it refer to.
/// The others keep their order and get ids without gaps. Needs: nothing else refers to nodes made after the mark.
void compact(ir::Program& program, const Mark& mark, std::span<ir::Pass* const> passes);

}  // namespace gliftc::lower
