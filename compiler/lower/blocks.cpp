// Kernels over blocks. An invocation's `address` is {position in its block, number of the block}. What follows from the
// number comes first, then the test whether the element is there, then the body.
#include "ir/chain.h"
#include "ir/evaluate.h"
#include "lower/expand.h"

#include <algorithm>
#include <string>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint64_t two_to_32 = 1ull << 32;

}  // namespace

Place block_owner(const Context& cx) {
    const Place place{*cx.kernel.space, {}};
    return *blocks_of(cx.p, cx.structure_at(place), place);
}

std::optional<std::uint64_t> block_volume(const Context& cx) {
    const auto extent = evaluate(cx.p, cx.structure_at(block_owner(cx)).blocks->extent);
    if (!extent) return std::nullopt;
    std::uint64_t volume = 1;
    for (const Lane& lane : extent->lanes) volume = std::min(volume * lane.bits, two_to_32);
    return volume;
}

/// {positions, blocks}: what the host knows of them, or at most.
ExprId Expander::visited_size() {
    const Place owner = block_owner(cx);
    const Blocks& blocks = *cx.structure_at(owner).blocks;
    Frame frame;
    frame.places = {canonical(owner)};
    return inside(std::move(frame), [&] {
        const ExprId extent = value_of(blocks.extent);
        ExprId volume = make.component(extent, 0);
        for (std::uint32_t axis = 1; axis < p.types.components(make.type(extent)); ++axis)
            volume = make.multiply(volume, make.component(extent, axis));
        const ExprId count = blocks.bound ? value_of(blocks.bound) : make.uint(most_blocks);
        return make.construct(iteration_type(cx), {volume, count});
    });
}

/// What a function of the blocks' owner gives.
Pair Expander::of_owner(FunctionId function, std::vector<Pair> arguments) {
    Frame frame;
    frame.places = {block_owner(cx)};
    frame.prefix = cx.name_of(frame.places[0]);
    return within([&] {
        if (inline_sizes_.of(function)) return inlined(function, std::move(arguments), std::move(frame));
        return call_instance(function, std::move(arguments), std::move(frame));
    });
}

/// What the value is multiplied by: the other factor, where that is this number. A block that begins at such a product
/// begins at a multiple of its size.
ExprId Expander::quotient_of(ExprId value, std::uint64_t divisor) {
    const Expr* node = &p.exprs[value];
    if (node->op == Op::local)
        if (const ExprId* definition = cx.definitions.find(node->local)) node = &p.exprs[*definition];
    if (divisor == 1) return value;
    if (node->op != Op::binary || node->binary != BinaryOp::multiply) return {};
    for (std::size_t i : {0u, 1u})
        if (make.bits_of(node->operands[i]) == divisor) return node->operands[1 - i];
    return {};
}

/// One axis of the address of an element: that of the block's first one, and the offset in the block. Numbers of blocks
/// are kept below 2^32 / size, so that no address of a block wraps: what lies beyond is in no domain.
ExprId Expander::address_along(std::uint32_t axis, ExprId first, ExprId size, ExprId offset) {
    const std::string name = std::string("block_") + "xyzw"[axis];
    const auto width = make.bits_of(size);
    const ExprId number = width && *width != 0 ? quotient_of(first, *width) : ExprId{};
    if (number) {
        const LocalId local = let(name, number, span_);
        const std::uint64_t most = two_to_32 / *width - 1;
        make.limits[local] = most;
        if (*width != 1)
            block_.is_there = make.both(block_.is_there,
                                        make.binary(BinaryOp::less_equal, make.local(local), make.uint(most)));
        return make.add(make.multiply(make.local(local), size), offset);
    }
    const ExprId begin = make.local(let(name + "_begin", first, span_));
    const ExprId last = make.binary(BinaryOp::subtract, make.add(begin, size), make.uint(1));
    block_.is_there = make.both(block_.is_there, make.binary(BinaryOp::greater_equal, last, begin));
    return make.add(begin, offset);
}

/// Works out what the block's number decides, and from it the element's address.
void Expander::enter_block() {
    const Blocks& blocks = *cx.structure_at(block_owner(cx)).blocks;
    const ExprId invocation = make.local(cx.pass.address);
    const LocalId position = let("in_block", make.component(invocation, 0), span_);
    block_.position = position;
    if (const auto volume = block_volume(cx); volume && *volume != 0) make.limits[position] = *volume - 1;
    const Pair first = of_owner(blocks.first, {{make.component(invocation, 1), {}}});
    block_.is_there = first.has;
    Frame frame;
    frame.places = {canonical(block_owner(cx))};
    block_.size = inside(std::move(frame), [&] { return value_of(blocks.extent); });
    const std::uint32_t axes = p.types.components(cx.kernel.domain_type);
    ExprId rest = make.local(position);
    Operands parts;
    for (std::uint32_t axis = 0; axis < axes; ++axis) {
        const ExprId width = make.component(block_.size, axis);
        const bool is_last = axis + 1 == axes;
        const ExprId offset = is_last ? rest : make.binary(BinaryOp::remainder, rest, width);
        parts.push_back(address_along(axis, make.component(first.value, axis), width, offset));
        if (!is_last) rest = make.binary(BinaryOp::divide, rest, width);
    }
    block_.address = parts.size() == 1 ? parts[0] : make.construct(cx.kernel.domain_type, std::move(parts));
}

/// The address of the element in the structure whose blocks are visited.
ExprId Expander::visited_address() {
    if (block_.address) return block_.address;
    Block made = collect([&] { enter_block(); });
    prelude_.insert(prelude_.end(), made.begin(), made.end());
    return block_.address;
}

ExprId Expander::origin_of(std::uint32_t root) {
    const TypeId type = cx.structure_at({root, {}}).domain_type;
    return cx.parameter_expr(
        cx.parameter(ParameterSource::origin, cx.name_of({root, {}}) + "_origin", type, root));
}

/// From the beginning of what is visited.
ExprId Expander::relative_address() {
    const ExprId address = visited_address();
    return cx.is_direct() ? address : make.binary(BinaryOp::subtract, address, origin_of(*cx.kernel.space));
}

/// The address of a parameter's own element: ranges may begin elsewhere.
ExprId Expander::address_in_block(std::uint32_t root) {
    const std::uint32_t space = *cx.kernel.space;
    const ExprId address = visited_address();
    if (cx.is_direct() || root == space) return address;
    return make.add(address, make.binary(BinaryOp::subtract, origin_of(root), origin_of(space)));
}

/// Whether the element is visited: its block is there, and it lies in the range, which lies in the domain.
ExprId Expander::is_element_there() {
    const std::uint32_t space = *cx.kernel.space;
    const ExprId address = visited_address();
    const ExprId inside = cx.is_direct() ? all_less(address, domain_of({space, {}}))
                                         : all_less(relative_address(), range_size(space));
    return make.both(block_.is_there, inside);
}

}  // namespace gliftc::lower
