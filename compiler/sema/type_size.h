// How large a type may be: its values are made, copied and compared number by number.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

inline constexpr std::uint64_t most_numbers = 65536;

/// The numbers that a value of the type consists of; the types that it is made of have no more than most_numbers.
std::uint64_t numbers_in(const ir::Program& program, ir::TypeId type);

/// "uint[65536][2] holds 131072 numbers, a type 65536 at most".
std::string too_many_numbers(const std::string& type, std::uint64_t numbers);

}  // namespace gliftc::sema
