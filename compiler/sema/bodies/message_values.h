// How values look in messages: the text of a type, with a placeholder for each scalar (glift::MessageFormat), and the
// words that hold the scalars.
#pragma once

#include "sema/bodies/body.h"

#include <string>

namespace gliftc::sema {

/// The type's text, such as `{{x: {f}, y: {f}}`; absent if values of the type cannot be printed.
std::optional<std::string> message_text(const ir::Program&, ir::TypeId);

/// The number of words of a value of the type.
std::uint64_t message_words(const ir::Program&, ir::TypeId);

/// Appends the uints that hold the value's scalars, in the order of message_text(). The value stands in each of them.
void add_words(ir::Program&, ir::ExprId value, ir::Operands& words);

}  // namespace gliftc::sema
