// Replaces each guarded_load, a load with the condition under which it is allowed, in one of two ways. (If its
// condition is a constant, it is replaced by a plain load, or by the value that it gives where loading is not allowed.)
//
// By a select: the load is executed without a branch, from a safe address if the condition does not hold, and a select
// then replaces its value. CPUs can vectorise this. By a branch, for elements that are neither scalars nor vectors, and
// in kernels with a group: there a select, which uses the loaded value at once, would wait for the load before the next
// barrier, while a load under a branch, which GPUs turn into a predicate, is waited for only at the first use of the
// value.
//
// Needs: bodies after "share" and "drop_dead". Guarantees: no guarded_load is left; the same values.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> guard(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
