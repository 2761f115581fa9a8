// Expander: neighbour reads in kernels over blocks, on the host device. The elements that are read by `near` from a
// block and around it are copied to a local array once per block, and the code for an element reads this copy, at
// constant distances from the element's own index in it. Each adjacent block that the offsets reach is looked up once,
// if translating its addresses only takes loads that depend on the block alone (where they are at an address divided by
// the block size, quotients.cpp folds that to the block's number). Blocks must be known to begin at multiples of their
// size: of others, adjacent ones may be cut off by the domain's begin.
// This is known as ghost cells in block-structured grids, and as block-local storage in Taichi.
#include "lower/expand/halos.h"

#include "ir/chain.h"
#include "lower/expand/blocks.h"
#include "lower/expand/expand.h"

#include <algorithm>
#include <string>

namespace gliftc::lower {

using namespace ir;

namespace {

/// most_numbers: limit for the scalars in the copies of a pass together, so that they stay in the first or second level
/// cache.
/// least_volume: smaller blocks mostly have more elements around them than in them, so that a copy does not pay.
constexpr std::uint64_t most_numbers = 1u << 15, least_volume = 8;

/// Whether the pass reads the memory of the structure at the place and neither writes it nor accesses it as coherent
/// memory.
bool is_only_read(const Context& cx, const Place& of) {
    const Place place = root_of(cx.p, cx.structure_at(of), of);
    const auto& bindings = cx.pass.bindings;
    const auto found = std::ranges::find_if(bindings, [&](const PassBinding& one) { return one.place == place; });
    return found != bindings.end() && std::ranges::all_of(bindings, [&](const PassBinding& other) {
               return other.one_place != found->one_place || (other.access == Access::read && !other.coherent);
           });
}

bool is_centre(const std::vector<std::int64_t>& offset) {
    return std::ranges::all_of(offset, [](std::int64_t part) { return part == 0; });
}

/// The blocks that an offset may reach, as steps from the own block: along each axis 0, or 1 or -1 on the offset's
/// side.
std::set<std::vector<int>> steps_of(const std::vector<std::int64_t>& offset) {
    std::set<std::vector<int>> steps{{}};
    for (std::int64_t part : offset) {
        std::set<std::vector<int>> longer;
        for (const std::vector<int>& step : steps)
            for (int next : {0, part < 0 ? -1 : part > 0 ? 1 : 0}) {
                longer.insert(step);
                auto node = longer.extract(step);
                node.value().push_back(next);
                longer.insert(std::move(node));
            }
        steps = std::move(longer);
    }
    return steps;
}

/// How far the offsets that reach the block at `step` (from the own one) go beyond the own block along an axis.
std::uint32_t thickness(const std::set<std::vector<std::int64_t>>& offsets, const std::vector<int>& step,
                        std::size_t axis) {
    std::int64_t most = 0;
    for (const auto& offset : offsets)
        if (steps_of(offset).contains(step)) most = std::max(most, offset[axis] * step[axis]);
    return static_cast<std::uint32_t>(most);
}

Halo halo_of_block(std::uint32_t root, const std::vector<std::uint32_t>& block,
                   const std::set<std::vector<std::int64_t>>& offsets) {
    Halo halo;
    halo.root = root;
    halo.block = block;
    halo.below.resize(block.size());
    halo.extent = block;
    std::set<std::vector<int>> steps;
    for (const auto& offset : offsets) steps.merge(steps_of(offset));
    for (const std::vector<int>& step : steps) {
        Halo::Part part{step, {}, {}};
        for (std::size_t axis = 0; axis < block.size(); ++axis) {
            const std::uint32_t count = step[axis] == 0 ? block[axis] : thickness(offsets, step, axis);
            part.low.push_back(step[axis] < 0 ? block[axis] - count : 0);
            part.count.push_back(count);
        }
        halo.parts.push_back(std::move(part));
    }
    for (std::size_t axis = 0; axis < block.size(); ++axis) {
        std::int64_t low = 0, high = 0;
        for (const auto& offset : offsets) {
            low = std::min(low, offset[axis]);
            high = std::max(high, offset[axis]);
        }
        halo.below[axis] = static_cast<std::uint32_t>(-low);
        halo.extent[axis] += static_cast<std::uint32_t>(high - low);
    }
    return halo;
}

/// Whether all offsets end in the block or in an adjacent one.
bool are_in_reach(const std::set<std::vector<std::int64_t>>& offsets, const std::vector<std::uint32_t>& block) {
    return std::ranges::all_of(offsets, [&](const auto& offset) {
        for (std::size_t axis = 0; axis < block.size(); ++axis)
            if (offset[axis] > block[axis] || -offset[axis] > block[axis]) return false;
        return true;
    });
}

}  // namespace

std::vector<Halo> halos_of(Context& cx, const NearOffsets& offsets) {
    std::vector<Halo> halos;
    const auto volume = block_volume(cx);
    if (!volume || *volume < least_volume || *volume > most_numbers) return halos;
    const std::vector<std::uint32_t> block = *block_widths(cx);
    std::uint64_t numbers = 0;
    for (const auto& [root, of] : offsets) {
        const Place place{root, {}};
        const Structure& structure = cx.structure_at(place);
        const TypeId element = structure.element;
        const bool is_number = cx.p.types.is_scalar(element) || cx.p.types.is_vector(element);
        const bool is_stored = !structure.at && !is_computed(cx.p, structure) && is_only_read(cx, place);
        if (!is_number || cx.p.types.scalar_of(element) == cx.p.types.bool_ || !is_stored) continue;
        if (std::ranges::all_of(of, is_centre) || !are_in_reach(of, block)) continue;
        Halo halo = halo_of_block(root, block, of);
        const std::uint64_t more = std::uint64_t{halo.elements()} * cx.p.types.components(element);
        if (numbers + more > most_numbers) continue;
        numbers += more;
        halos.push_back(std::move(halo));
    }
    return halos;
}

Halo* Expander::halo_of(std::uint32_t root) {
    const auto found = std::ranges::find(halos, root, &Halo::root);
    return found == halos.end() ? nullptr : &*found;
}

/// Reads the neighbour at an offset from the copy.
ExprId Expander::in_halo(Halo& halo, const std::vector<std::int64_t>& offset) {
    const TypeId element = cx.structure_at({halo.root, {}}).element;
    if (!halo.copy) {
        const std::string name = cx.name_of({halo.root, {}}) + "_around";
        const TypeId type = p.types.array(element, halo.elements());
        halo.copy = cx.new_local(name, type, cx.kernel.params[halo.root].span, true);
        Block made = collect([&] {
            ExprId at;
            std::uint32_t pitch = 1;
            for (std::size_t axis = 0; axis < halo.block.size(); ++axis) {
                const ExprId along = build.multiply(block_.axes[axis].offset, build.uint(pitch));
                at = at ? build.add(at, along) : along;
                pitch *= halo.extent[axis];
            }
            halo.at = named(name + "_at", at);
        });
        prelude_.insert(prelude_.end(), made.begin(), made.end());
    }
    std::int64_t distance = 0, pitch = 1;
    for (std::size_t axis = 0; axis < halo.block.size(); ++axis) {
        distance += (halo.below[axis] + offset[axis]) * pitch;
        pitch *= halo.extent[axis];
    }
    const ExprId at = build.add(halo.at, build.uint(static_cast<std::uint64_t>(distance)));
    return build.index(build.local(halo.copy), at);
}

/// The adjacent block along one axis; for step 0 the own one, with `begin` alone. If the adjacent block does not exist,
/// `begin` is that of the own block, so that looking it up is harmless. Blocks must begin at multiples of their size.
Expander::NextBlock Expander::next_block(std::uint32_t root, std::uint32_t width, std::uint32_t axis, int step) {
    const OwnBlock::Axis& own = block_.axes[axis];
    if (step == 0) return {own.begin, {}, {}};
    NextBlock next;
    const ExprId size = build.uint(width), one = build.uint(1);
    const std::string name = std::string("block_") + "xyzw"[axis] + (step < 0 ? "_before" : "_after");
    if (step > 0) {
        const ExprId domain = build.component(domain_of({root, {}}), axis);
        next.room = named(name + "_room", build.binary(BinaryOp::subtract, domain, build.add(own.last, one)));
        next.exists = build.both(build.binary(BinaryOp::greater, next.room, build.uint(0)),
                                 build.binary(BinaryOp::less, own.number, build.uint(own.most)));
    } else {
        next.exists = build.binary(BinaryOp::greater_equal, own.number, one);
    }
    next.exists = named(name + "_exists", next.exists);
    const ExprId moved = build.binary(step < 0 ? BinaryOp::subtract : BinaryOp::add, own.number, one);
    const LocalId number = let(name, build.select(next.exists, moved, own.number), span_);
    build.limits[number] = own.most;
    next.begin = build.multiply(build.local(number), size);
    return next;
}

bool Expander::depends_on(ExprId id, const std::vector<LocalId>& locals) {
    const Expr& node = p.exprs[id];
    if (node.op == Op::local) {
        if (p.locals[node.local].is_mutable || std::ranges::find(locals, node.local) != locals.end()) return true;
        const ExprId* definition = cx.definitions.find(node.local);
        return definition != nullptr && depends_on(*definition, locals);
    }
    return std::ranges::any_of(node.operands, [&](ExprId operand) { return depends_on(operand, locals); });
}

namespace {

/// Divides a conjunction into those of its parts for which `asks` is true and the others.
template <class Asks> void divide(Builder& build, ExprId condition, ExprId& yes, ExprId& no, const Asks& asks) {
    if (!condition) return;
    const Expr node = build.p.exprs[condition];
    const bool holds = asks(condition);
    if (!holds && node.op == Op::binary && node.binary == BinaryOp::logical_and) {
        divide(build, node.operands[0], yes, no, asks);
        divide(build, node.operands[1], yes, no, asks);
        return;
    }
    ExprId& to = holds ? yes : no;
    to = build.both(to, condition);
}

}  // namespace

/// Makes the loops' variables for a part, and from them each element's address in its structure and index in the copy.
/// Adds to found.all the condition that the domain does not end within the part.
Expander::Copied Expander::places_of(const Halo& halo, const Halo::Part& part, Neighbours& found) {
    Copied copied;
    copied.name = cx.name_of({halo.root, {}});
    Operands parts;
    std::uint32_t pitch = 1;
    for (std::uint32_t axis = 0; axis < part.step.size(); ++axis) {
        const int step = part.step[axis];
        const std::uint32_t count = part.count[axis];
        if (step != 0) copied.name += std::string("_") + "xyzw"[axis] + (step < 0 ? "m" : "p");
        const NextBlock& next = found.axes[axis][static_cast<std::size_t>(step + 1)];
        copied.exists = build.both(copied.exists, next.exists);
        const LocalId local = cx.new_local(std::string(1, "xyzw"[axis]), p.types.uint, span_);
        build.limits[local] = count - 1;
        const ExprId round = count == 1 ? build.uint(0) : build.local(local);
        copied.loops.push_back(local);
        ExprId limit = build.uint(count);
        if (step > 0 && count > 1) {  // the domain may end within the adjacent block
            found.all = build.both(found.all, build.binary(BinaryOp::greater_equal, next.room, limit));
            limit = build.intrinsic(Intrinsic::min, p.types.uint, {limit, next.room});
        }
        copied.limits.push_back(limit);
        parts.push_back(build.add(next.begin, build.add(round, build.uint(part.low[axis]))));
        const std::int64_t begin =
            std::int64_t{part.low[axis]} + step * std::int64_t{halo.block[axis]} + halo.below[axis];
        const ExprId along = build.add(round, build.uint(static_cast<std::uint64_t>(begin)));
        const ExprId term = build.multiply(along, build.uint(pitch));
        copied.index = copied.index ? build.add(copied.index, term) : term;
        pitch *= halo.extent[axis];
    }
    copied.address = parts.size() == 1 ? parts[0] : build.construct(cx.kernel.domain_type, std::move(parts));
    return copied;
}

/// The physical address of the copied element. Of the statements that compute it, pure `let`s that do not depend on the
/// loops are appended here, before the loops; the others are put into `inner`.
Pair Expander::looked_up(const Halo& halo, const Copied& copied, Block& inner) {
    const Place place{halo.root, {}};
    Pair physical;
    const Block made = collect([&] {
        known_.push_back({numbers_.of(inside_domain(place, copied.address))});
        physical = translated(place, copied.address, copied.name);
        known_.pop_back();
        bool asked = false;
        physical.has = without_inside(halo.root, physical.has, copied.address, asked);
    });
    for (StmtId id : made) {
        const Stmt& stmt = p.stmts[id];
        const bool is_of_block = stmt.op == StmtOp::let && stmt.value && !p.locals[stmt.local].is_mutable &&
                                 !depends_on(stmt.value, copied.loops) && numbers_.is_pure(stmt.value);
        (is_of_block ? *out_ : inner).push_back(id);
    }
    return physical;
}

/// The loops over a part, around `body`.
Expander::Block Expander::loops_over(const Halo::Part& part, const Copied& copied, Block body) {
    for (std::size_t axis = 0; axis < copied.loops.size(); ++axis) {
        if (part.count[axis] == 1) continue;
        Stmt loop = statement(StmtOp::for_, span_);
        loop.local = copied.loops[axis];
        loop.value = build.uint(0);
        loop.limit = copied.limits[axis];
        loop.body = std::move(body);
        body = {cx.add(std::move(loop))};
    }
    return body;
}

/// Looks up a block, and makes the statements that copy a part of it, under the condition that the block exists.
void Expander::copy_from(const Halo& halo, const Halo::Part& part, Neighbours& found) {
    const Copied copied = places_of(halo, part, found);
    Block inner;
    const Pair physical = looked_up(halo, copied, inner);
    ExprId is_there = copied.exists, of_element;
    divide(build, physical.has, is_there, of_element, [&](ExprId id) { return !depends_on(id, copied.loops); });
    if (is_there) is_there = named(copied.name + "_found", is_there);
    found.all = of_element ? build.truth(false) : build.both(found.all, is_there);
    const Block assigned = collect([&] {
        Stmt one = statement(StmtOp::assign, span_);
        one.target = build.index(build.local(halo.copy), copied.index);
        one.value = load({halo.root, {}}, physical.value);
        append(std::move(one));
    });
    Block body = collect([&] {
        out_->insert(out_->end(), inner.begin(), inner.end());
        append_where(of_element, assigned);
    });
    const Block copies = collect([&] { append_where(is_there, loops_over(part, copied, std::move(body))); });
    found.copies.insert(found.copies.end(), copies.begin(), copies.end());
}

/// Appends the statements under a condition; an absent one is true.
void Expander::append_where(ExprId condition, Block statements) {
    if (condition && !build.is_true(condition)) return append_if(condition, std::move(statements), {});
    out_->insert(out_->end(), statements.begin(), statements.end());
}

/// Adds to block_.holds that the parameter's range has the same origin as the range whose blocks are visited. Otherwise
/// block borders differ, and the variant for whole blocks does not apply.
void Expander::require_equal_origin(std::uint32_t root) {
    if (cx.is_direct() || root == *cx.kernel.space) return;
    if (std::ranges::find(equal_origins_, root) != equal_origins_.end()) return;
    equal_origins_.push_back(root);
    const ExprId own = origin_of(root), of_space = origin_of(*cx.kernel.space);
    for (std::uint32_t axis = 0; axis < p.types.components(build.type(own)); ++axis)
        block_.holds = build.both(
            block_.holds, build.binary(BinaryOp::equal, build.component(own, axis), build.component(of_space, axis)));
}

/// A loop that sets all elements of a copy to one value.
StmtId Expander::every_element(const Halo& halo, ExprId value) {
    Stmt loop = statement(StmtOp::for_, span_);
    loop.local = cx.new_local("i", p.types.uint, span_);
    loop.value = build.uint(0);
    loop.limit = build.uint(halo.elements());
    Stmt one = statement(StmtOp::assign, span_);
    one.target = build.index(build.local(halo.copy), build.local(loop.local));
    one.value = value;
    loop.body = {cx.add(std::move(one))};
    return cx.add(std::move(loop));
}

/// Appends the statements that declare and fill a halo's copy, for blocks all of whose elements are visited.
void Expander::fill(const Halo& halo) {
    if (!halo.copy) return;
    const Place place{halo.root, {}};
    require_equal_origin(halo.root);
    Stmt array = statement(StmtOp::let, span_);
    array.local = halo.copy;
    array.uninitialized = true;
    append(std::move(array));
    Neighbours found;
    for (std::uint32_t axis = 0; axis < halo.block.size(); ++axis) {
        std::array<NextBlock, 3> steps;
        for (int step : {-1, 0, 1}) {
            const bool is_reached =
                std::ranges::any_of(halo.parts, [&](const Halo::Part& part) { return part.step[axis] == step; });
            if (is_reached)
                steps[static_cast<std::size_t>(step + 1)] = next_block(halo.root, halo.block[axis], axis, step);
        }
        found.axes.push_back(steps);
    }
    for (const Halo::Part& part : halo.parts) copy_from(halo, part, found);
    Stmt copies = statement(StmtOp::block, span_);
    copies.body = collect([&] {
        if (found.all && !build.is_true(found.all))
            append_if(build.negate(found.all), {every_element(halo, otherwise_of(place))}, {});
        out_->insert(out_->end(), found.copies.begin(), found.copies.end());
    });
    append(std::move(copies));
}

}  // namespace gliftc::lower
