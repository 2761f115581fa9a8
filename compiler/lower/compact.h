// Takes out of the program what only led to a pass. Each step of lowering makes nodes anew, so that nine of ten belong
// to no pass in the end; without them the next kernel is lowered in memory that is in the caches already.
#pragma once

#include "ir/pass.h"

#include <span>

namespace gliftc::lower {

/// How many nodes there were at one time.
struct Mark {
    explicit Mark(const ir::Program& program)
        : exprs(program.exprs.size()), stmts(program.stmts.size()), locals(program.locals.size()),
          functions(program.functions.size()) {}
    std::uint32_t exprs, stmts, locals, functions;
};

/// Of the expressions and statements made after `mark` only those stay that the passes or functions made after it name.
/// Their order stays, their ids become smaller. Needs: nothing else refers to nodes made after the mark.
void compact(ir::Program& program, const Mark& mark, std::span<ir::Pass* const> passes);

}  // namespace gliftc::lower
