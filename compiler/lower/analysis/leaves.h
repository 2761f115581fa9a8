// The leaves of a type: of a struct the members that are not structs themselves, at any depth, in their order (an empty
// struct has none); of another type the whole value, which is one leaf.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

bool is_struct(const ir::Program& p, TypeId type);

std::uint32_t leaves_in(const ir::Program& p, TypeId type);

/// The index of the first leaf of a struct's field among the struct's leaves.
std::uint32_t first_leaf(const ir::Program& p, TypeId type, std::uint32_t slot);

/// An expression without the fields around it, and where these lead to.
struct MemberOf {
    ExprId whole;
    std::uint32_t first = 0;  ///< index of the expression's first leaf among those of `whole`
};
MemberOf member_of(const ir::Program& p, ExprId id);

}  // namespace gliftc::lower
