// Scalar replacement of aggregates: a local that holds a struct becomes a local for each member that is used, where the
// struct is loaded from memory and some of its members are not used. Only the used ones are then loaded.
//
// Nested structs are split in turn. A local stays whole if a use needs all of it: an argument of a call, a store of the
// whole struct.
//
// Needs: expressions are trees. Guarantees: all values stay the same. Members are loaded where the struct was, in the
// order of their declaration.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> split_structs(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
