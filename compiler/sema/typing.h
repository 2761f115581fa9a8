// Whether an expression has a type of its own or takes one from its context, found before it is checked.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// In the order in which operands are checked: earlier ones determine the types of later ones.
enum class Typing : std::uint8_t {
    own,      // some operand has a type
    literal,  // literals without suffixes, and operators and choices over them
    none,     // `none` alone
};
Typing typing_of(const Context&, ast::ExprId);

/// A literal, or operators and conditionals over literals: its context determines the type.
inline bool is_flexible(const Context& c, ast::ExprId id) { return typing_of(c, id) == Typing::literal; }

/// Whether an argument is checked only once its parameter's type is known.
bool waits_for_parameter(const Context&, ast::ExprId);

/// The default type of a flexible expression: int or float, or an optional of it.
ir::TypeId own_type(Context&, ast::ExprId literal);

/// The hint for an operand, from the type expected of the result, without `optional` or `device`: operators work on
/// values.
ir::TypeId operand_hint(const ir::Types&, ir::TypeId wanted);

/// Whether `from` converts implicitly to `to`: the same type, or an optional of it.
bool becomes(const ir::Types&, ir::TypeId from, ir::TypeId to);

/// Whether the type is or contains an optional.
bool holds_optional(const ir::Program&, ir::TypeId);

}  // namespace gliftc::sema
