// The limits on types and parameters: docs/reference/language.md, "Limits".
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

inline constexpr std::uint64_t most_scalars = 65536;

/// The number of members of a struct that SPIR-V allows.
inline constexpr std::size_t most_fields = 16383;

/// SPIR-V allows 255 parameters of a function, and 255 indices in an access, one for each level of a type. Both limits
/// are lower, since the compiler adds parameters and levels.
inline constexpr std::size_t most_parameters = 100;
inline constexpr std::uint32_t most_levels = 200;

/// The levels of nesting in a type: 0 for scalars, vectors and matrices, one more than its elements or fields have for
/// an array, a struct or an optional.
std::uint32_t levels_of(const ir::Program& program, ir::TypeId type);

/// The number of scalars in a value of the type, with one more for each optional. The types of its elements and fields
/// must have at most most_scalars each, so that the sum does not overflow.
std::uint64_t scalars_in(const ir::Program& program, ir::TypeId type);

/// "uint[65536][2] has 131072 scalars, the limit is 65536".
std::string too_many_scalars(const std::string& type, std::uint64_t scalars);

}  // namespace gliftc::sema
