// The functions that are built into the language: one line each in intrinsics.def.
#pragma once

#include <cstdint>
#include <string_view>

namespace gliftc::ir {

enum class Intrinsic : std::uint8_t {
#define INTRINSIC(name, signature, exactness) name,
#include "ir/intrinsics.def"
#undef INTRINSIC
};

/// Whether results may differ between devices (docs/reference/language.md, "Accuracy").
enum class Exactness : std::uint8_t { exact, exact_for_integers, inexact };

std::string_view name_of(Intrinsic intrinsic);
std::string_view signature_of(Intrinsic intrinsic);
Exactness exactness_of(Intrinsic intrinsic);

/// Whether the result depends on which other invocations execute the operation, or on their values (subgroup
/// operations, derivatives), so that the operation must not be moved into or out of a branch.
bool is_collective(Intrinsic intrinsic);
/// Whether it is a derivative: a difference between the fragments of a quad.
bool is_derivative(Intrinsic intrinsic);

}  // namespace gliftc::ir
