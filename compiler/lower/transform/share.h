// Common subexpression elimination: expressions that are used more than once in a scope become named locals before
// their first use, and uses of a `let` whose value an earlier local has use that local.
//
// Needs: statements of memory operations, whose expressions may share nodes. Guarantees: expressions can be printed as
// trees, since a value that is used more than once is in a local, unless it is short (is_trivial), uniform, or may not
// be computed once for all its uses; nothing is moved past a write that it depends on, and no load is moved out of a
// condition.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// `facts` are conditions that are known to hold throughout the body; inside an `if`, its condition is known, too.
std::vector<StmtId> share(Context& cx, const std::vector<StmtId>& body, const std::vector<ExprId>& facts);

/// Undoes share() for locals that it or the pass `guard` made and that are used only once, and in no deeper loop: the
/// value replaces the use, if it cannot change within the pass.
std::vector<StmtId> merge_single_uses(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
