// What is known of the blocks that a kernel visits.
#pragma once

#include "lower/context.h"
#include "lower/number.h"

#include <optional>
#include <vector>

namespace gliftc::lower {

/// Of the invocation's address: the kernel's, or {position, block} where blocks are visited.
TypeId iteration_type(Context& cx);

/// The structure that declares the blocks which the kernel visits.
ir::Place block_owner(const Context& cx);

/// The number of a block's elements, where that is a constant.
std::optional<std::uint64_t> block_volume(const Context& cx);

/// Its size along each axis, where that is constant.
std::optional<std::vector<std::uint32_t>> block_widths(const Context& cx);

/// As many blocks as two axes of a dispatch take on every device.
constexpr std::uint64_t most_blocks = 65535ull * 65535ull;

/// How many elements of a block an invocation of a shader takes, where the body allows it: what the block decides is
/// computed by each invocation. One where blocks do not divide so.
std::uint32_t elements_in_block(std::uint64_t volume);

/// Which values are the same for all elements of a block, and do not change in the pass.
class BlockValues {
public:
    explicit BlockValues(Context& context) : cx(context), numbers_(context) {}

    bool has(ExprId id);
    /// Whether the statement names such a value. Of another `let` the local is noted, in order.
    bool has(const ir::Stmt& stmt);

private:
    Context& cx;
    Numbers numbers_;
    IdSet<ir::Local> varying_;
};

}  // namespace gliftc::lower
