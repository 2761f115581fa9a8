#include "ir/intrinsics.h"

#include <array>
#include <cstddef>

namespace gliftc::ir {

namespace {

struct Row {
    std::string_view name, signature;
    Exactness exactness;
};

constexpr Row rows[] = {
#define INTRINSIC(name, signature, exactness) {#name, signature, Exactness::exactness},
#include "ir/intrinsics.def"
#undef INTRINSIC
};

}  // namespace

std::string_view name_of(Intrinsic intrinsic) { return rows[static_cast<std::size_t>(intrinsic)].name; }
std::string_view signature_of(Intrinsic intrinsic) { return rows[static_cast<std::size_t>(intrinsic)].signature; }
Exactness exactness_of(Intrinsic intrinsic) { return rows[static_cast<std::size_t>(intrinsic)].exactness; }

bool is_collective(Intrinsic intrinsic) { return signature_of(intrinsic).back() == '*' || is_derivative(intrinsic); }
bool is_derivative(Intrinsic intrinsic) { return signature_of(intrinsic).back() == '+'; }

}  // namespace gliftc::ir
