// The functions that every target has: one line each in intrinsics.def.
#pragma once

#include <cstdint>
#include <string_view>

namespace gliftc::ir {

enum class Intrinsic : std::uint8_t {
#define INTRINSIC(name, signature, exactness) name,
#include "ir/intrinsics.def"
#undef INTRINSIC
};

/// Whether results may differ between devices (docs/language.md, "Accuracy").
enum class Exactness : std::uint8_t { exact, inexact };

std::string_view name_of(Intrinsic intrinsic);
std::string_view signature_of(Intrinsic intrinsic);
Exactness exactness_of(Intrinsic intrinsic);

/// Whether it takes values of other invocations, so that it must stay where control flow is as it was written.
bool is_collective(Intrinsic intrinsic);
/// Of a quad of fragments: a derivative.
bool is_derivative(Intrinsic intrinsic);

}  // namespace gliftc::ir
