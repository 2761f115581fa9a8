// What is known of an expression's type before it is checked: whether it has one of its own, or takes one from its
// context.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// In the order in which the parts of an expression are checked: each tells those after it their type.
enum class Typing : std::uint8_t {
    own,      // something in it has a type
    literal,  // literals without suffixes, and operators and choices over them
    none,     // `none` alone
};
Typing typing_of(const Context&, ast::ExprId);

/// A literal, or operators and choices over literals: its context chooses the type.
inline bool is_flexible(const Context& c, ast::ExprId id) { return typing_of(c, id) == Typing::literal; }

/// An argument that is checked once its parameter's type is known.
bool waits_for_parameter(const Context&, ast::ExprId);

/// The type of a flexible expression where nothing chooses another: int or float, or an optional of it.
ir::TypeId own_type(Context&, ast::ExprId literal);

/// What an operand may take from the type that is wanted of its operator's result: operators work on values, whether
/// the result becomes an optional or is left on a device.
ir::TypeId operand_hint(const ir::Types&, ir::TypeId wanted);

/// Whether a value of type `from` becomes one of type `to` by itself: the same type, or an optional of it.
bool becomes(const ir::Types&, ir::TypeId from, ir::TypeId to);

/// Whether a value of the type is an optional or has one among its parts.
bool holds_optional(const ir::Program&, ir::TypeId);

}  // namespace gliftc::sema
