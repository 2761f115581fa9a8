// Expander: kernels over blocks. An invocation's `address` is {position in its block, number of the block}. The code
// first computes addresses from this, then tests whether the element is visited (with Guards::block: whether all
// elements of the block are), and then has the body.
#include "lower/expand/blocks.h"

#include "ir/chain.h"
#include "ir/evaluate.h"
#include "lower/expand/expand.h"

#include <algorithm>
#include <string>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint64_t two_to_32 = 1ull << 32;

}  // namespace

TypeId iteration_type(Context& cx) {
    return cx.kernel.space ? cx.p.types.vector(cx.p.types.uint, 2) : cx.kernel.domain_type;
}

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

std::optional<std::vector<std::uint32_t>> block_widths(const Context& cx) {
    const auto extent = evaluate(cx.p, cx.structure_at(block_owner(cx)).blocks->extent);
    if (!extent) return std::nullopt;
    std::vector<std::uint32_t> widths;
    for (const Lane& lane : extent->lanes) widths.push_back(static_cast<std::uint32_t>(lane.bits));
    return widths;
}

std::uint32_t elements_in_block(std::uint64_t volume) {
    constexpr std::uint32_t most = 8, least_width = 64, most_width = 256, subgroup = 32;
    const auto divides = [&](std::uint32_t elements) {
        const std::uint64_t width = volume / elements;
        return volume % elements == 0 && width >= least_width &&
               width % (width > most_width ? most_width : subgroup) == 0;
    };
    std::uint32_t elements = most;
    while (elements > 1 && !divides(elements)) elements /= 2;
    return elements;
}

/// The size of the iteration, {positions in a block, number of blocks}, for the host: an upper bound where the number
/// of blocks is known only on the device.
ExprId Expander::visited_size() {
    const Place owner = block_owner(cx);
    const Blocks& blocks = *cx.structure_at(owner).blocks;
    Frame frame;
    frame.places = {canonical(owner)};
    return inside(std::move(frame), [&] {
        const ExprId extent = value_of(blocks.extent);
        ExprId volume = build.component(extent, 0);
        for (std::uint32_t axis = 1; axis < p.types.components(build.type(extent)); ++axis)
            volume = build.multiply(volume, build.component(extent, axis));
        const ExprId count = blocks.bound ? value_of(blocks.bound) : build.uint(most_blocks);
        return build.construct(iteration_type(cx), {volume, count});
    });
}

/// Calls a function of the structure that declares the blocks.
Pair Expander::of_owner(FunctionId function, std::vector<Pair> arguments) {
    Frame frame;
    frame.places = {block_owner(cx)};
    frame.prefix = cx.name_of(frame.places[0]);
    return within([&] {
        if (inline_sizes_.of(function)) return inlined(function, std::move(arguments), std::move(frame));
        return call_instance(function, std::move(arguments), std::move(frame));
    });
}

/// x, where the value is written as x * divisor (divisor 1: the value itself) or is a constant multiple of the divisor;
/// absent otherwise. A block that begins at such a value begins at a multiple of its size, and x is its number along
/// the axis.
ExprId Expander::quotient_of(ExprId value, std::uint64_t divisor) {
    const Expr* node = &p.exprs[value];
    if (const auto bits = build.bits_of(value); bits && *bits % divisor == 0) return build.uint(*bits / divisor);
    if (node->op == Op::local)
        if (const ExprId* definition = cx.definitions.find(node->local)) node = &p.exprs[*definition];
    if (divisor == 1) return value;
    if (node->op != Op::binary || node->binary != BinaryOp::multiply) return {};
    for (std::size_t i : {0u, 1u})
        if (build.bits_of(node->operands[i]) == divisor) return node->operands[1 - i];
    return {};
}

/// The addresses of a block along one axis. A block with an address of 2^32 or more, which lies outside every domain,
/// counts as nonexistent, so that no address of a block wraps around.
Expander::OwnBlock::Axis Expander::block_along(std::uint32_t axis, ExprId first, ExprId size) {
    const std::string name = std::string("block_") + "xyzw"[axis];
    const auto width = build.bits_of(size);
    const ExprId number = width && *width != 0 ? quotient_of(first, *width) : ExprId{};
    OwnBlock::Axis along;
    if (number) {
        const LocalId local = let(name, number, span_);
        along.most = two_to_32 / *width - 1;
        along.number = build.local(local);
        build.limits[local] = along.most;
        if (*width != 1)
            block_.is_there =
                build.both(block_.is_there, build.binary(BinaryOp::less_equal, along.number, build.uint(along.most)));
        along.begin = build.multiply(along.number, size);
        along.last = build.add(along.begin, build.uint(*width - 1));
        return along;
    }
    along.begin = build.local(let(name + "_begin", first, span_));
    along.last = build.binary(BinaryOp::subtract, build.add(along.begin, size), build.uint(1));
    block_.is_there = build.both(block_.is_there, build.binary(BinaryOp::greater_equal, along.last, along.begin));
    return along;
}

/// Computes the block's first address from its number, and the element's address from that and its position.
void Expander::enter_block() {
    const Blocks& blocks = *cx.structure_at(block_owner(cx)).blocks;
    const ExprId invocation = build.local(cx.pass.address);
    const LocalId position = let("in_block", build.component(invocation, 0), span_);
    block_.position = position;
    if (const auto volume = block_volume(cx); volume && *volume != 0) build.limits[position] = *volume - 1;
    const Pair first = of_owner(blocks.first, {{build.component(invocation, 1), {}}});
    block_.is_there = first.has;
    Frame frame;
    frame.places = {canonical(block_owner(cx))};
    block_.size = inside(std::move(frame), [&] { return value_of(blocks.extent); });
    const std::uint32_t axes = p.types.components(cx.kernel.domain_type);
    ExprId rest = build.local(position);
    Operands parts, last;
    for (std::uint32_t axis = 0; axis < axes; ++axis) {
        const ExprId width = build.component(block_.size, axis);
        const bool is_last = axis + 1 == axes;
        OwnBlock::Axis along = block_along(axis, build.component(first.value, axis), width);
        along.offset = is_last ? rest : build.binary(BinaryOp::remainder, rest, width);
        parts.push_back(build.add(along.begin, along.offset));
        last.push_back(along.last);
        if (!is_last) rest = build.binary(BinaryOp::divide, rest, width);
        block_.axes.push_back(along);
    }
    const auto whole = [&](Operands& of) {
        return of.size() == 1 ? of[0] : build.construct(cx.kernel.domain_type, std::move(of));
    };
    block_.address = whole(parts);
    block_.last = whole(last);
}

/// Whether the visited block is known to begin at a multiple of its size along each axis. Then so do the blocks around
/// it, and the domain begins at a border between blocks.
bool Expander::is_at_multiples() {
    visited_address();
    return std::ranges::all_of(block_.axes, [](const OwnBlock::Axis& axis) { return bool(axis.number); });
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
    return cx.parameter_expr(cx.parameter(ParameterSource::origin, cx.name_of({root, {}}) + "_origin", type, root));
}

/// The element's address relative to the origin of the visited range.
ExprId Expander::relative_address() {
    const ExprId address = visited_address();
    return cx.is_direct() ? address : build.binary(BinaryOp::subtract, address, origin_of(*cx.kernel.space));
}

/// The address of the current element in the structure of another parameter, whose range may have another origin. With
/// Guards::block the origins are equal, so that block borders are the same and the block is looked up once.
ExprId Expander::address_in_block(std::uint32_t root) {
    const std::uint32_t space = *cx.kernel.space;
    const ExprId address = visited_address();
    if (cx.is_direct() || root == space) return address;
    if (guards_ == Guards::block) {
        require_equal_origin(root);
        return address;
    }
    return build.add(address, build.binary(BinaryOp::subtract, origin_of(root), origin_of(space)));
}

/// The condition that the element is visited: its block exists, and the element lies in the range (in the direct form
/// the domain).
ExprId Expander::is_element_there() {
    const std::uint32_t space = *cx.kernel.space;
    const ExprId address = visited_address();
    const ExprId inside =
        cx.is_direct() ? all_less(address, domain_of({space, {}})) : all_less(relative_address(), range_size(space));
    return build.both(block_.is_there, inside);
}

/// The condition that all elements of the block are visited.
ExprId Expander::is_block_there() {
    const std::uint32_t space = *cx.kernel.space;
    visited_address();
    if (cx.is_direct()) return build.both(block_.is_there, all_less(block_.last, domain_of({space, {}})));
    const ExprId origin = origin_of(space), size = range_size(space);
    const ExprId last = build.binary(BinaryOp::subtract, block_.last, origin);
    const ExprId extent =
        build.binary(BinaryOp::subtract, block_.size, build.construct(build.type(origin), {build.uint(1)}));
    const ExprId first = build.binary(BinaryOp::subtract, last, extent);
    return build.both(block_.is_there, build.both(all_less(first, size), all_less(last, size)));
}

/// Whether nothing in the expression depends on the element's position in its block; builtins and mutable locals are
/// taken to depend on it. (Loads in the expression may still give other values after a store.)
bool Expander::is_of_block(ExprId id) {
    const Expr& node = p.exprs[id];
    if (node.op == Op::builtin || (node.op == Op::local && p.locals[node.local].is_mutable)) return false;
    if (node.op == Op::local) {
        if (node.local == block_.position || node.local == cx.pass.address) return false;
        const ExprId* definition = cx.definitions.find(node.local);
        return definition == nullptr || is_of_block(*definition);
    }
    if (node.op == Op::swizzle && p.exprs[node.operands[0]].op == Op::local &&
        p.exprs[node.operands[0]].local == cx.pass.address)
        return !p.types.is_vector(node.type) && node.lanes[0] == 1;
    return std::ranges::all_of(node.operands, [&](ExprId operand) { return is_of_block(operand); });
}

/// With Guards::block: the condition without those of its conjuncts that are the same for the whole block; these are
/// added to block_.holds, which is tested once a block.
ExprId Expander::without_block_tests(ExprId condition) {
    if (!condition || guards_ != Guards::block) return condition;
    if (is_of_block(condition)) {
        block_.holds = build.both(block_.holds, condition);
        return {};
    }
    const Expr node = p.exprs[condition];
    if (node.op != Op::binary || node.binary != BinaryOp::logical_and) return condition;
    return build.both(without_block_tests(node.operands[0]), without_block_tests(node.operands[1]));
}

/// Whether the statement gives an immutable local a pure value that depends on the block alone: it may come before the
/// test whether the element is visited.
bool Expander::is_value_of_block(StmtId id) {
    const Stmt& stmt = p.stmts[id];
    return stmt.op == StmtOp::let && stmt.value && !p.locals[stmt.local].is_mutable && is_of_block(stmt.value) &&
           numbers_.is_pure(stmt.value);
}

/// The prelude and the body, with the condition under which they are valid. Without Guards::block: an `if` whose
/// condition is that the element is visited; only those values of the prelude that depend on the block alone stand
/// before it, all else is inside. With Guards::block: the prelude; an `evaluate` whose value is the condition that all
/// elements of the block are visited and block_.holds is true; the statements that fill the halos; the body.
Expander::Block Expander::visited_block(Block body) {
    return collect([&] {
        if (guards_ != Guards::block) {
            Block rest;
            for (StmtId id : prelude_) (is_value_of_block(id) ? *out_ : rest).push_back(id);
            rest.insert(rest.end(), body.begin(), body.end());
            return append_if(is_element_there(), std::move(rest), {});
        }
        out_->insert(out_->end(), prelude_.begin(), prelude_.end());
        const Block copies = collect([&] {
            for (Halo& halo : halos) fill(halo);
        });
        Stmt holds = statement(StmtOp::evaluate, span_);
        holds.value = build.both(is_block_there(), block_.holds);
        append(std::move(holds));
        out_->insert(out_->end(), copies.begin(), copies.end());
        out_->insert(out_->end(), body.begin(), body.end());
    });
}

}  // namespace gliftc::lower
