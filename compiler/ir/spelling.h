// The spellings of operators, builtins and other enumerators in the text of the IR (print.h, read.h). Some are also
// used in messages, generated C++, reflection (JSON) and the output of `gliftc explain`.
#pragma once

#include "ir/pass.h"

#include <string_view>

namespace gliftc::ir {

std::string_view spelling(BinaryOp op);
std::string_view spelling(UnaryOp op);
std::string_view spelling(Invocation id);
std::string_view spelling(Builtin id);
std::string_view spelling(Combine combine);
std::string_view spelling(Form form);
std::string_view spelling(Access access);
std::string_view spelling(MemoryShape shape);
std::string_view spelling(Format format);
std::string_view spelling(Compare compare);
std::string_view spelling(Topology topology);
std::string_view spelling(Cull cull);
std::string_view spelling(DepthTest test);
std::string_view spelling(Blend blend);
std::string_view spelling(Interpolation interpolation);

/// The enumerator with this spelling; absent if there is none. `last` is the enumeration's last one.
template <class Enum> std::optional<Enum> spelled(std::string_view text, Enum last) {
    for (std::uint8_t i = 0; i <= static_cast<std::uint8_t>(last); ++i)
        if (spelling(static_cast<Enum>(i)) == text) return static_cast<Enum>(i);
    return std::nullopt;
}

}  // namespace gliftc::ir
