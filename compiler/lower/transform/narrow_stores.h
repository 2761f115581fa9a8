// A store of a struct becomes stores of those members that may differ from what the element holds.
//
// A member is left out if the stored value is what an earlier load from the same binding and address gave, and nothing
// can have written that member of that element since. This is so in two cases:
//
// - No store of the body changes the member, in any element: each stores what was loaded from its own address. By
//   induction over the stores of all invocations, the member then keeps the value that it had before the pass, whatever
//   the order of the stores and whatever addresses are equal (`next` and `address` of a coarsened body, say).
// - No store between the load and this one may change the member of the binding or of a binding that may alias it
//   (PassBinding::one_place). Other invocations do not write the element: the language has no invocation write what
//   another one reads or writes (docs/reference/language.md, "Aliasing"), except by updates and by
//   coherent access. The pass leaves bindings with either alone.
//
// Bindings that are no aliases by one_place do not lead to the same element: passes that move loads rely on this, too.
//
// Needs: expressions are trees. Guarantees: memory has the same contents after each statement that replaces a store.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> narrow_stores(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
