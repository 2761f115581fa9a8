// Kernels over blocks visit the elements of blocks that a structure declares (ir::Blocks), such as resident pages. Here
// is what the compiler knows of these blocks.
#pragma once

#include "lower/context.h"

#include <optional>
#include <vector>

namespace gliftc::lower {

/// The type of the invocation's address: in a kernel over blocks uint2, {position in the block, number of the block};
/// in any other kernel its domain type.
TypeId iteration_type(Context& cx);

/// The place of the structure that declares the blocks which the kernel visits.
ir::Place block_owner(const Context& cx);

/// The number of elements of a block, or 2^32 if it is larger; absent if the size of a block is not a constant.
std::optional<std::uint64_t> block_volume(const Context& cx);

/// The size of a block along each axis; absent if it is not a constant.
std::optional<std::vector<std::uint32_t>> block_widths(const Context& cx);

/// The largest number of blocks that a kernel visits: every device allows that many workgroups along two axes of a
/// dispatch.
constexpr std::uint64_t most_blocks = 65535ull * 65535ull;

/// How many elements of a block of `volume` elements an invocation of a shader takes, where the body allows it. Each
/// invocation computes the values that depend on the block alone, so with several elements fewer invocations do. The
/// result is the largest of 8, 4 and 2 that divides the volume into at least 64 invocations whose number is a multiple
/// of 32 (of 256, if it is larger than 256); 1 if none of them does.
std::uint32_t elements_in_block(std::uint64_t volume);

}  // namespace gliftc::lower
