// Replaces each guarded_load, a load with the condition under which it is allowed, in one of two ways.
//
// By a select: a safe address is loaded from without a branch, and a select replaces the value where the condition does
// not hold. CPUs can then vectorise. By a branch, for elements that are neither scalars nor vectors, and in kernels
// with a group: in these a select would wait for the load before the next barrier, while a load under a branch, which
// GPUs turn into a predicate, is waited for only at its first use.
//
// Needs: bodies after "share" and "drop_dead". Guarantees: no guarded_load is left; the same values.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> guard(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
