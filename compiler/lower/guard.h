// Guarded loads become loads of memory, in one of two ways.
//
// As a choice: what lies at a safe address is loaded without a branch, and a select gives what the load gives outside.
// CPUs then do several at a time. As a branch, in kernels with a group and for elements that are structs: a select
// would wait for the load before the next barrier, but nothing waits for a load under a branch, which GPUs make a
// predicate, before its value is used.
//
// Needs: shared bodies without dead lets. Guarantees: no guarded_load is left; the same values.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> guard(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
