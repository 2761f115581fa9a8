// Whether an expression has a type of its own or takes one from its context, found before it is checked.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// In the order in which operands are checked: earlier ones determine the types of later ones.
enum class Typing : std::uint8_t {
    own,      // has a type by itself: a name, a call, a comparison, a logical operation, a literal with a suffix, an
              // operator or choice with such an operand; also `{…}`
    literal,  // a literal without suffix, or operators and choices over such literals, or over these and `none`
    none,     // `none`, or operators and choices over nothing else
};
Typing typing_of(const Context&, ast::ExprId);

/// Whether the expression is made of literals without suffix, so that its context determines its type.
inline bool is_flexible(const Context& c, ast::ExprId id) { return typing_of(c, id) == Typing::literal; }

/// Whether an argument is checked only once its parameter's type is known: one made of literals without suffix, `none`,
/// or a braced list.
bool waits_for_parameter(const Context&, ast::ExprId);

/// The default type of a flexible expression: int or float, or an optional of it.
ir::TypeId own_type(Context&, ast::ExprId literal);

/// The type hint for an operand, given the type expected of the result: that type without `optional` and `device`,
/// since operators work on plain values.
ir::TypeId operand_hint(const ir::Types&, ir::TypeId wanted);

/// Whether `from` converts implicitly to `to`: `to` is the same type, an optional of it, or an optional of such an
/// optional.
bool becomes(const ir::Types&, ir::TypeId from, ir::TypeId to);

/// Whether the type is or contains an optional.
bool holds_optional(const ir::Program&, ir::TypeId);
/// Of a parameter or result of a method whose type the language fixes: reports the type that is written, if it is
/// another one. Absent `written`: none is.
void check_fixed_type(Context&, const Env&, ast::ExprId written, ir::TypeId fixed);
/// Whether elements of memory can be of the type: it holds no optionals, no structs without fields, and is not void.
bool memory_holds(const ir::Program&, ir::TypeId);

/// Whether the type is an optional or an array of optionals, which `what` cannot be; reports it then.
bool is_refused_optional(Context&, ir::TypeId, std::string_view what, Span);

}  // namespace gliftc::sema
