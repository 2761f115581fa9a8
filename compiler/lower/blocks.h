// What is known of the blocks that a kernel visits.
#pragma once

#include "lower/context.h"

#include <optional>

namespace gliftc::lower {

/// Of the invocation's address: the kernel's, or {position, block} where blocks are visited.
TypeId iteration_type(Context& cx);

/// The structure that declares the blocks which the kernel visits.
ir::Place block_owner(const Context& cx);

/// The number of a block's elements, where that is a constant.
std::optional<std::uint64_t> block_volume(const Context& cx);

/// As many blocks as two axes of a dispatch take on every device.
constexpr std::uint64_t most_blocks = 65535ull * 65535ull;

}  // namespace gliftc::lower
