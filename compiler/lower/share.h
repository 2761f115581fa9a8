// Computes what is equal once: expressions that are used more than once in a scope become named locals before their
// first use, and lets that repeat an earlier one become that one.
//
// Needs: low-level statements, whose expressions may share nodes. Guarantees: expressions are trees small enough to
// print; nothing is moved past a write that it depends on, and no load is moved out of a condition.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// Conditions that hold on the whole body may be given; inside an if, its own is known too.
std::vector<StmtId> share(Context& cx, const std::vector<StmtId>& body, const std::vector<ExprId>& facts);

/// Puts the values of locals that share() made back where they are used, if that is one place and in no deeper loop.
std::vector<StmtId> merge_single_uses(Context& cx, const std::vector<StmtId>& body);

/// Drops lets that nothing uses.
std::vector<StmtId> drop_dead(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
