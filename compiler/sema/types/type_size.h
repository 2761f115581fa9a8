// The limit on the number of scalars in a type.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

inline constexpr std::uint64_t most_scalars = 65536;

/// The number of scalars in a value of the type, with one more for each optional. The types of its elements and fields
/// must have at most most_scalars each, so that the sum does not overflow.
std::uint64_t scalars_in(const ir::Program& program, ir::TypeId type);

/// "uint[65536][2] has 131072 scalars, the limit is 65536".
std::string too_many_scalars(const std::string& type, std::uint64_t scalars);

}  // namespace gliftc::sema
