// Expander: neighbour reads across block borders, in kernels over blocks (blocks.h). A neighbour at a constant offset
// that is along no axis longer than a block lies in the invocation's own block or in an adjacent one. The neighbour's
// physical address is computed for each of these blocks, and the access selects one of the addresses. This is done only
// if all loads that compute the addresses, such as look-ups in a page table, depend on the block alone (where they are
// at an address divided by the block size, quotients.cpp folds that to the block's number), if blocks are known to
// begin at multiples of their size, and if the structure is known to map no address outside of its domain. Unlike a
// halo (halos.cpp) this makes no copy, for which shaders would need a barrier, and also works for memory that the pass
// writes.
#include "ir/effects.h"
#include "lower/expand/blocks.h"
#include "lower/expand/expand.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

namespace gliftc::lower {

using namespace ir;

namespace {

bool is_in_reach(const std::vector<std::int64_t>& offset, const std::vector<std::uint32_t>& widths) {
    for (std::size_t axis = 0; axis < widths.size(); ++axis)
        if (std::abs(offset[axis]) > std::int64_t{widths[axis]}) return false;
    return true;
}

}  // namespace

/// Works out where a neighbour at `offset` along `axis` lies (see Way), once for each parameter, axis and offset.
const Expander::Way& Expander::way_along(std::uint32_t root, std::uint32_t axis, std::int64_t offset) {
    const auto [found, is_new] = block_.ways.try_emplace({root, axis, offset});
    Way& way = found->second;
    if (!is_new) return way;
    const std::uint32_t width = (*block_widths(cx))[axis];
    const ExprId own = block_.axes[axis].offset;
    const std::uint64_t distance = static_cast<std::uint64_t>(std::abs(offset));
    way.name = std::string("_") + "xyzw"[axis] + (offset < 0 ? "m" : "p");
    const std::string name = way.name.substr(1) + std::to_string(distance);
    const Block made = collect([&] {
        way.next = next_block(root, width, axis, offset < 0 ? -1 : 1);
        way.offset = own;
        way.crosses = build.truth(true);
        if (distance == width) return;
        const std::uint64_t moved = offset < 0 ? width - distance : distance;
        const ExprId sum = build.add(own, build.uint(moved));
        const LocalId local = let("in_block_" + name, build.binary(BinaryOp::remainder, sum, build.uint(width)), span_);
        build.limits[local] = width - 1;
        way.offset = build.local(local);
        way.crosses = named(name + "_crosses",
                            offset < 0 ? build.binary(BinaryOp::less, own, build.uint(distance))
                                       : build.binary(BinaryOp::greater_equal, own, build.uint(width - distance)));
    });
    prelude_.insert(prelude_.end(), made.begin(), made.end());
    if (guards_ != Guards::block) return way;
    // All of the own block is in the domain; the adjacent block may be cut off by the domain's end.
    way.inside = way.next.exists;
    if (offset > 1) way.inside = build.both(way.inside, build.binary(BinaryOp::less, way.offset, way.next.room));
    return way;
}

/// Whether the value depends on a load or call that cannot be made once per block, because it depends on the element or
/// the pass may change its result; or on a mutable local, which may hold the value of such a load.
bool Expander::is_loaded_by_element(ExprId id) {
    const Expr& node = p.exprs[id];
    if (node.op == Op::local) {
        if (p.locals[node.local].is_mutable) return true;
        const ExprId* definition = cx.definitions.find(node.local);
        return definition != nullptr && is_loaded_by_element(*definition);
    }
    const bool loads = is_load(node.op) || node.op == Op::call;
    if (loads && !(is_of_block(id) && numbers_.is_fixed(id))) return true;
    return std::ranges::any_of(node.operands, [&](ExprId operand) { return is_loaded_by_element(operand); });
}

/// The physical address for the virtual `address` of a neighbour in one candidate block; absent if computing it needs
/// loads or calls that cannot be made once per block (is_loaded_by_element): each element would then have to make them
/// for every candidate block.
std::optional<Pair> Expander::place_in_block(const Place& place, ExprId address, const std::string& name) {
    Pair physical;
    Block made = collect([&] {
        const std::vector<Fact> known = std::exchange(known_, {{numbers_.of(inside_domain(place, address))}});
        physical = inside(Frame{}, [&] { return translated(place, address, name); });
        known_ = known;
        bool asked = false;
        physical.has = without_inside(place.root, physical.has, address, asked);
    });
    if (is_loaded_by_element(physical.value) || (physical.has && is_loaded_by_element(physical.has)))
        return std::nullopt;
    prelude_.insert(prelude_.end(), made.begin(), made.end());
    return physical;
}

/// A select between two values. If both are constructions (Op::construct), or binary operations that differ in one
/// operand only, the select is pushed inwards to the operands that differ.
ExprId Expander::chosen(ExprId condition, ExprId yes, ExprId no) {
    if (numbers_.of(yes) == numbers_.of(no)) return no;
    const Expr a = p.exprs[yes], b = p.exprs[no];
    const bool is_alike = a.op == b.op && a.type == b.type && a.operands.size() == b.operands.size() &&
                          (a.op == Op::construct || (a.op == Op::binary && a.binary == b.binary));
    if (!is_alike) return build.select(condition, yes, no);
    Operands operands;
    unsigned differ = 0;
    for (std::size_t i = 0; i < a.operands.size(); ++i) {
        const bool is_same = numbers_.of(a.operands[i]) == numbers_.of(b.operands[i]);
        if (!is_same && build.type(a.operands[i]) != build.type(b.operands[i])) return build.select(condition, yes, no);
        differ += is_same ? 0 : 1;
    }
    if (a.op == Op::binary && differ > 1) return build.select(condition, yes, no);
    for (std::size_t i = 0; i < a.operands.size(); ++i)
        operands.push_back(chosen(condition, a.operands[i], b.operands[i]));
    return build.again(a, std::move(operands));
}

/// The physical address of a neighbour. `at` has the components of its address along the axes that are done; recursion
/// over the axes adds the others, for the own and for the adjacent block. Absent if place_in_block gives none for one
/// of the blocks.
std::optional<Pair> Expander::choose_block(const Place& place, const Ways& ways, Beside at) {
    const std::size_t axis = at.address.size();
    if (axis == ways.size()) {
        const ExprId address =
            axis == 1 ? at.address[0] : build.construct(cx.kernel.domain_type, std::move(at.address));
        std::optional<Pair> found = place_in_block(place, address, at.name);
        if (found && at.is_own) found->has = without_block_tests(found->has);
        return found;
    }
    const OwnBlock::Axis& own = block_.axes[axis];
    const Way* way = ways[axis];
    Beside stay = at;
    stay.address.push_back(build.add(own.begin, way == nullptr ? own.offset : way->offset));
    if (way == nullptr) return choose_block(place, ways, std::move(stay));
    Beside next = std::move(at);
    next.address.push_back(build.add(way->next.begin, way->offset));
    next.name += way->name;
    next.is_own = false;
    std::optional<Pair> here;
    if (!build.is_true(way->crosses) && !(here = choose_block(place, ways, std::move(stay)))) return here;
    std::optional<Pair> there = choose_block(place, ways, std::move(next));
    if (!there) return there;
    there->has = build.both(way->inside, there->has);
    if (!here) return there;
    Pair result{chosen(way->crosses, there->value, here->value), {}};
    if (there->has || here->has) {
        const ExprId yes = there->has ? there->has : build.truth(true), no = here->has ? here->has : build.truth(true);
        result.has = chosen(way->crosses, yes, no);
    }
    return result;
}

/// The physical address of the neighbour at an offset; absent: the caller translates its virtual address.
std::optional<Pair> Expander::beside(const Place& place, const std::vector<std::int64_t>& offset) {
    if (!block_.is_of_kernel || !(cx.is_direct() || place.root == *cx.kernel.space)) return std::nullopt;
    const auto widths = block_widths(cx);
    if (!widths || !is_in_reach(offset, *widths)) return std::nullopt;
    // If an invocation takes one element, two candidate blocks are worth their look-ups, four or more are not.
    const auto axes = std::ranges::count_if(offset, [](std::int64_t part) { return part != 0; });
    if (axes > 1 && elements_in_block(*block_volume(cx)) == 1) return std::nullopt;
    centre(place.root);  // so that its statements come before those of this neighbour, which may use them
    // Called after `centre`, so that bindings are added in the same order whatever may_map_outside returns.
    if (!is_at_multiples() || may_map_outside(place.root)) return std::nullopt;
    Ways ways;
    for (std::uint32_t axis = 0; axis < offset.size(); ++axis)
        ways.push_back(offset[axis] == 0 ? nullptr : &way_along(place.root, axis, offset[axis]));
    std::optional<Pair> found = choose_block(place, ways, {{}, cx.name_of(place), true});
    if (found && guards_ != Guards::block) found->has = build.both(near_guard(place.root, offset), found->has);
    return found;
}

}  // namespace gliftc::lower
