// Several elements with consecutive addresses at once. Where they also follow each other in memory they move as vectors
// of four, if they begin at such a vector and all lie inside; else one by one.
#include "lower/expand.h"

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint32_t row_width = 4;

}  // namespace

/// Whether elements from the virtual address on are neighbours in a buffer of 32-bit numbers, whatever the address.
bool Expander::lies_in_rows(const Place& place, ExprId address, std::uint32_t count) {
    const Structure& structure = cx.structure_at(place);
    if (structure.kind != StructureKind::stored || count % row_width != 0 || !is_total(structure)) return false;
    const Memory& memory = structure.memories[structure.via_memory];
    bool is_word = memory.element == p.types.uint || memory.element == p.types.int_ || memory.element == p.types.float_;
    if (memory.shape != MemoryShape::buffer || !is_word) return false;
    bool neighbours = true;
    Block made = collect([&] {
        Pair first = translated(place, address, "probe");
        neighbours = !first.has;
        for (std::uint32_t k : {1u, count - 1}) {
            Pair next = translated(place, make.add(address, make.uint(k)), "probe");
            neighbours =
                neighbours && !next.has && numbers_.of(next.value) == numbers_.of(make.add(first.value, make.uint(k)));
        }
    });
    return neighbours && made.empty();
}

/// Whether all of the row is inside and it begins at a vector.
ExprId Expander::is_aligned_row(const Place& place, ExprId address, ExprId physical, std::uint32_t count) {
    ExprId size = domain_of(place);
    ExprId inside = make.both(
        make.binary(BinaryOp::less, address, size),
        make.binary(BinaryOp::greater_equal, make.binary(BinaryOp::subtract, size, address), make.uint(count)));
    ExprId rest = make.binary(BinaryOp::remainder, physical, make.uint(row_width));
    return make.both(inside, make.binary(BinaryOp::equal, rest, make.uint(0)));
}

ExprId Expander::several(const Expr& node) {
    Place place = resolved(node.place);
    const std::string name = cx.name_of(place);
    const TypeId element = cx.structure_at(place).element;
    const std::uint32_t count = p.types[node.type].count;
    ExprId address = named(name + "_first", value_of(node.operands[0]));
    ExprId at = named(name + "_virtual", from_origin(place, address));
    LocalId items = variable(name + "_items", node.type, make.zero(node.type));
    const auto item = [&](std::uint32_t k) {
        Expr index;
        index.op = Op::index;
        index.type = element;
        index.operands = {make.local(items), make.uint(k)};
        return p.exprs.add(std::move(index));
    };
    const auto set = [&](std::uint32_t k, ExprId value) {
        Stmt stmt = statement(StmtOp::assign, span_);
        stmt.target = item(k);
        stmt.value = value;
        append(std::move(stmt));
    };
    const auto one_by_one = [&] {
        for (std::uint32_t k = 0; k < count; ++k)
            set(k, read(place, make.add(address, make.uint(k)), name + std::to_string(k)));
    };
    const bool is_read_only = cx.kernel.params[place.root].direction == Direction::in;
    if (!is_read_only || !lies_in_rows(place, at, count)) {
        one_by_one();
        return make.local(items);
    }
    ExprId physical = named(name + "_at", translated(place, at, name).value);
    // Vectors are loaded without a branch, so that many loads are in flight: the first one of the memory where it is
    // for nothing. Every buffer has room for one.
    ExprId is_row = named(name + "_is_row", is_aligned_row(place, address, physical, count));
    const std::uint32_t slot = binding(place, cx.structure_at(place).via_memory, Access::read);
    cx.pass.bindings[slot].in_rows = true;
    ExprId first = named(name + "_row", make.binary(BinaryOp::divide, physical, make.uint(row_width)));
    for (std::uint32_t k = 0; k < count; k += row_width) {
        Expr load;
        load.op = Op::load;
        load.type = p.types.vector(element, row_width);
        load.slot = slot;
        load.operands = {make.select(is_row, make.add(first, make.uint(k / row_width)), make.uint(0))};
        ExprId vector = make.local(let(name + "_four", p.exprs.add(std::move(load)), span_));
        for (std::uint32_t lane = 0; lane < row_width; ++lane) set(k + lane, make.component(vector, lane));
    }
    append_if(make.negate(is_row), collect(one_by_one), {});
    return make.local(items);
}

void Expander::write_several(const Stmt& stmt) {
    Place place = resolved(stmt.place);
    const std::string name = cx.name_of(place);
    const TypeId array = make.type(stmt.value), element = p.types[array].element;
    const std::uint32_t count = p.types[array].count;
    ExprId address = named(name + "_first", value_of(stmt.target));
    ExprId at = named(name + "_virtual", from_origin(place, address));
    ExprId items = named(name + "_items", value_of(stmt.value));
    const auto item = [&](std::uint32_t k) {
        Expr index;
        index.op = Op::index;
        index.type = element;
        index.operands = {items, make.uint(k)};
        return p.exprs.add(std::move(index));
    };
    const auto one_by_one = [&] {
        for (std::uint32_t k = 0; k < count; ++k) {
            ExprId next = make.add(address, make.uint(k));
            check_range(place, next, Access::write, stmt.span);
            Pair physical = translated(place, named(name + "_virtual", from_origin(place, next)), name);
            ExprId guard = is_total(cx.structure_at(place)) ? inside_domain(place, next) : ExprId{};
            store(place, physical, guard, stmt, item(k));
        }
    };
    if (!lies_in_rows(place, at, count)) return one_by_one();
    ExprId physical = named(name + "_at", translated(place, at, name).value);
    Block row = collect([&] {
        const std::uint32_t slot = binding(place, cx.structure_at(place).via_memory, Access::write);
        cx.pass.bindings[slot].in_rows = true;
        ExprId first = named(name + "_row", make.binary(BinaryOp::divide, physical, make.uint(row_width)));
        for (std::uint32_t k = 0; k < count; k += row_width) {
            Stmt made = statement(StmtOp::store, stmt.span);
            made.slot = slot;
            made.target = make.add(first, make.uint(k / row_width));
            made.value =
                make.construct(p.types.vector(element, row_width), {item(k), item(k + 1), item(k + 2), item(k + 3)});
            append(std::move(made));
        }
    });
    append_if(is_aligned_row(place, address, physical, count), std::move(row), collect(one_by_one));
}

}  // namespace gliftc::lower
