// Expander: `s.load(a)` and `s.store(a, x)`, which access rows of four elements that are consecutive along x (single
// elements, if their number is not a multiple of four). Elements of one to three 32-bit numbers that are also
// consecutive in a buffer are accessed as vectors of four numbers, if all rows begin at a multiple of four elements and
// lie in the domain, if physical addresses have 32 bits (in wide passes, sums and products have 64), and if loads are
// of an `in` parameter; else one by one. A row of four elements of N numbers each is N such vectors. If there is one
// row of four scalars of a one-dimensional structure, and it is known to begin at such a multiple, it is loaded without
// a test that all of it is in the domain: shaders may read a buffer up to the next multiple of 16 bytes
// (vulkan_memory.h), and the host device pads its memory, too (host_memory.cpp). Selects then replace the elements
// beyond the domain.
#include "ir/chain.h"
#include "lower/analysis/polynomial.h"
#include "lower/analysis/unroll.h"
#include "lower/expand/expand.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

/// Makes the statements of `body` for each row: in a loop over the rows, if there are several. The loop has an unroll
/// hint for shaders if there are at most unroll_limit rows: once it is unrolled, arrays of elements can be in registers
/// and all loads can be issued before the first is waited for.
template <class Body> void Expander::for_each_row(const Rows& rows, Body&& body) {
    if (rows.count == 1) return body(build.uint(0));
    Stmt loop = statement(StmtOp::for_, span_);
    loop.local = cx.new_local("row", p.types.uint, span_);
    loop.value = build.uint(0);
    loop.limit = build.uint(rows.count);
    loop.body = collect([&] { body(build.local(loop.local)); });
    loop.unrolled = rows.count <= unroll_limit;
    append(std::move(loop));
}

ExprId Expander::item_of(const Rows& rows, ExprId items, ExprId row, std::uint32_t lane) {
    Expr item;
    item.op = Op::index;
    item.type = cx.structure_at(rows.place).element;
    item.operands = {items, build.add(build.multiply(row, build.uint(rows.width)), build.uint(lane))};
    return p.exprs.add(std::move(item));
}

Expander::Rows Expander::rows_of(const Place& place, ExprId address, ExprId step, TypeId array) {
    Rows rows;
    rows.place = place;
    rows.name = cx.name_of(place);
    rows.first = named(rows.name + "_first", address);
    rows.at = named(rows.name + "_virtual", from_origin(place, rows.first));
    const std::uint32_t items = p.types[array].count;
    rows.width = items % row_width == 0 ? row_width : 1;
    rows.count = items / rows.width;
    rows.step = step ? named(rows.name + "_step", step) : build.uint(rows.width);
    return rows;
}

/// The address `distance` elements further along x.
ExprId Expander::further(ExprId address, ExprId distance) {
    const TypeId type = build.type(address);
    const std::uint32_t axes = p.types.components(type);
    if (axes == 1) return build.add(address, distance);
    Operands offset{distance};
    while (offset.size() < axes) offset.push_back(build.uint(0));
    return build.add(address, build.construct(type, std::move(offset)));
}

/// The address of element `lane` of a row.
ExprId Expander::address_in(const Rows& rows, ExprId row, std::uint32_t lane) {
    return further(rows.first, build.add(build.multiply(row, rows.step), build.uint(lane)));
}

/// Whether rows can be accessed as vectors: there are four elements in each, of one, two or three 32-bit numbers (four
/// are a vector by themselves), in a buffer, and every address is mapped, to physical addresses that advance like
/// virtual ones. Of physical addresses of 64 bits this is not known.
bool Expander::lie_in_vectors(const Rows& rows) {
    const Structure& structure = cx.structure_at(rows.place);
    if (structure.kind != StructureKind::stored || rows.width != row_width || !is_total(structure)) return false;
    const Memory& memory = root_memory(p, structure);
    if (!p.types.is_scalar(memory.element) && !p.types.is_vector(memory.element)) return false;
    const TypeId number = p.types.scalar_of(memory.element);
    const bool is_word = number == p.types.uint || number == p.types.int_ || number == p.types.float_;
    if (memory.shape != MemoryShape::buffer || !is_word || p.types.components(memory.element) == row_width)
        return false;
    bool neighbours = true;
    Polynomials polynomials(cx, numbers_);
    const auto same = [&](ExprId one, ExprId other) {
        if (numbers_.of(one) == numbers_.of(other)) return true;
        if (build.type(one) != p.types.uint) return false;
        const Polynomial *a = polynomials.of(one), *b = polynomials.of(other);
        return a != nullptr && b != nullptr && *a == *b;
    };
    Block made = collect([&] {
        Pair first = translated(rows.place, rows.at, "probe");
        neighbours = !first.has;
        for (ExprId distance : {build.uint(1), build.uint(row_width - 1), rows.step}) {
            Pair next = translated(rows.place, further(rows.at, distance), "probe");
            neighbours = neighbours && !next.has && same(next.value, build.add(first.value, distance));
        }
    });
    return neighbours && made.empty();
}

/// Whether a physical address is known to be a multiple of four.
bool Expander::is_at_vector(ExprId physical) {
    if (build.type(physical) != p.types.uint) return false;
    Polynomials polynomials(cx, numbers_);
    const Polynomial* terms = polynomials.of(physical);
    // Where invocations take several elements each, `address` is a multiple of their number.
    const ValueNumber own = numbers_.of(build.local(cx.pass.address));
    return terms != nullptr && std::all_of(terms->begin(), terms->end(), [&](const Term& term) {
               const bool is_own = std::find(term.product.begin(), term.product.end(), own) != term.product.end();
               return term.factor % row_width == 0 || (is_own && cx.pass.items % row_width == 0);
           });
}

/// Whether there is only one row, of one vector, in a structure with one axis, and the row's physical address is known
/// to be a multiple of four.
bool Expander::is_whole_vector(const Rows& rows, ExprId physical) {
    return rows.count == 1 && parts_of(rows) == 1 && build.type(rows.first) == p.types.uint && is_at_vector(physical);
}

/// The distance in addresses from the first element to one past the last element, if it is a constant, and so small
/// that nothing overflows.
std::optional<std::uint64_t> Expander::span_of(const Rows& rows) {
    if (rows.count == 1) return row_width;
    constexpr std::uint64_t largest = 1u << 24;
    const std::optional<std::uint64_t> step = build.bits_of(rows.step);
    if (!step || *step > largest / rows.count) return std::nullopt;
    return *step * (rows.count - 1) + row_width;
}

/// The condition that all rows are in the domain and begin at multiples of four elements.
ExprId Expander::are_vectors(const Rows& rows, ExprId physical) {
    const auto at_vector = [&](ExprId offset) {
        return build.binary(BinaryOp::equal, build.binary(BinaryOp::remainder, offset, build.uint(row_width)),
                            build.uint(0));
    };
    ExprId domain = domain_of(rows.place);
    const std::uint32_t axes = p.types.components(build.type(rows.first));
    const auto on_axis = [&](ExprId address, std::uint32_t axis) {
        return axes == 1 ? address : build.component(address, axis);
    };
    ExprId size = on_axis(domain, 0), first = on_axis(rows.first, 0);
    ExprId left = build.binary(BinaryOp::subtract, size, first);
    const std::optional<std::uint64_t> span = span_of(rows);
    ExprId one = build.both(build.binary(BinaryOp::less, first, size),
                            build.binary(BinaryOp::greater_equal, left, build.uint(span.value_or(row_width))));
    for (std::uint32_t axis = 1; axis < axes; ++axis)
        one = build.both(one, build.binary(BinaryOp::less, on_axis(rows.first, axis), on_axis(domain, axis)));
    if (!(span && rows.count > 1 && is_at_vector(physical))) one = build.both(one, at_vector(physical));
    if (rows.count == 1) return one;
    if (span) return build.both(one, at_vector(rows.step));
    // Compared by a quotient, since the product of rows and step may overflow.
    ExprId room = build.binary(BinaryOp::divide, build.binary(BinaryOp::subtract, left, build.uint(row_width)),
                               build.uint(rows.count - 1));
    return build.both(one, build.both(build.binary(BinaryOp::less_equal, rows.step, room), at_vector(rows.step)));
}

/// The index, in vectors, of vector `part` of a row.
ExprId Expander::vector_at(const Rows& rows, ExprId first_vector, ExprId row, std::uint32_t part) {
    ExprId apart =
        build.multiply(build.binary(BinaryOp::divide, rows.step, build.uint(row_width)), build.uint(parts_of(rows)));
    return build.add(build.add(first_vector, build.multiply(row, apart)), build.uint(part));
}

/// The number of vectors of a row: as many as an element has numbers, since a row has four elements.
std::uint32_t Expander::parts_of(const Rows& rows) { return p.types.components(cx.structure_at(rows.place).element); }

/// The index of the first vector of the first row, whose first element is at `physical`.
ExprId Expander::first_vector(const Rows& rows, ExprId physical) {
    ExprId row = build.binary(BinaryOp::divide, physical, build.uint(row_width));
    return named(rows.name + "_vector", build.multiply(row, build.uint(parts_of(rows))));
}

/// Scalar `i` of a row, taken from the row's vectors.
ExprId Expander::number_in(const std::vector<ExprId>& vectors, std::uint32_t i) {
    return build.component(vectors[i / row_width], i % row_width);
}

/// Element `lane` of a row, put together from the row's vectors.
ExprId Expander::element_in(const Rows& rows, const std::vector<ExprId>& vectors, std::uint32_t lane) {
    const std::uint32_t parts = parts_of(rows);
    if (parts == 1) return number_in(vectors, lane);
    Operands numbers;
    for (std::uint32_t i = 0; i < parts; ++i) numbers.push_back(number_in(vectors, lane * parts + i));
    return build.construct(cx.structure_at(rows.place).element, std::move(numbers));
}

/// Vector `part` of a row, put together from the row's elements.
ExprId Expander::vector_of(const Rows& rows, ExprId items, ExprId row, std::uint32_t part) {
    const std::uint32_t parts = parts_of(rows);
    Operands four;
    for (std::uint32_t i = part * row_width; i < (part + 1) * row_width; ++i) {
        ExprId item = item_of(rows, items, row, i / parts);
        four.push_back(parts == 1 ? item : build.component(item, i % parts));
    }
    return build.construct(p.types.vector(p.types.scalar_of(cx.structure_at(rows.place).element), row_width),
                           std::move(four));
}

ExprId Expander::several(const Expr& node) {
    Place place = resolved(node.place);
    const TypeId element = cx.structure_at(place).element;
    ExprId address = value_of(node.operands[0]);
    ExprId step = node.operands.size() > 1 ? value_of(node.operands[1]) : ExprId{};
    const Rows rows = rows_of(place, address, step, node.type);
    ExprId items = build.local(variable(rows.name + "_items", node.type, build.zero(node.type)));
    const auto set = [&](ExprId row, std::uint32_t lane, ExprId value) {
        Stmt stmt = statement(StmtOp::assign, span_);
        stmt.target = item_of(rows, items, row, lane);
        stmt.value = value;
        append(std::move(stmt));
    };
    const auto one_by_one = [&](ExprId row) {
        for (std::uint32_t lane = 0; lane < rows.width; ++lane)
            set(row, lane, read(place, address_in(rows, row, lane), rows.name + std::to_string(lane)));
    };
    const bool is_read_only = cx.kernel.params[place.root].direction == Direction::in;
    if (!is_read_only || !lie_in_vectors(rows)) {
        for_each_row(rows, one_by_one);
        return items;
    }
    ExprId physical = named(rows.name + "_at", translated(place, rows.at, rows.name).value);
    const std::uint32_t slot = binding(place, Access::read);
    cx.pass.bindings[slot].in_rows = true;
    const auto vector = [&](ExprId index) {
        Expr load;
        load.op = Op::load;
        load.type = p.types.vector(p.types.scalar_of(element), row_width);
        load.slot = slot;
        load.operands = {index};
        return build.local(let(rows.name + "_four", p.exprs.add(std::move(load)), span_));
    };
    if (is_whole_vector(rows, physical)) {
        ExprId inside = named(rows.name + "_inside", inside_domain(place, rows.first));
        const std::vector<ExprId> four{vector(build.select(inside, first_vector(rows, physical), build.uint(0)))};
        ExprId otherwise = otherwise_of(place);
        for (std::uint32_t lane = 0; lane < row_width; ++lane)
            set(build.uint(0), lane,
                build.select(inside_domain(place, address_in(rows, build.uint(0), lane)), number_in(four, lane),
                             otherwise));
        return items;
    }
    // One branch around all rows, not one for each, so that loads need not wait for conditions.
    Block vectors = collect([&] {
        ExprId first = first_vector(rows, physical);
        for_each_row(rows, [&](ExprId row) {
            std::vector<ExprId> vectors;
            for (std::uint32_t part = 0; part < parts_of(rows); ++part)
                vectors.push_back(vector(vector_at(rows, first, row, part)));
            for (std::uint32_t lane = 0; lane < row_width; ++lane) set(row, lane, element_in(rows, vectors, lane));
        });
    });
    append_if(are_vectors(rows, physical), std::move(vectors), collect([&] { for_each_row(rows, one_by_one); }));
    return items;
}

void Expander::write_several(const Stmt& stmt) {
    Place place = resolved(stmt.place);
    const TypeId array = build.type(stmt.value);
    ExprId address = value_of(stmt.target);
    ExprId step = stmt.arguments.empty() ? ExprId{} : value_of(stmt.arguments[0]);
    const Rows rows = rows_of(place, address, step, array);
    ExprId items = named(rows.name + "_items", value_of(stmt.value));
    const auto one_by_one = [&](ExprId row) {
        for (std::uint32_t lane = 0; lane < rows.width; ++lane) {
            ExprId next = named(rows.name + "_address", address_in(rows, row, lane));
            check_range(place, next, Access::write, stmt.span);
            Pair physical = written(place, named(rows.name + "_virtual", from_origin(place, next)), rows.name);
            store(place, physical, inside_domain(place, next), stmt, item_of(rows, items, row, lane));
        }
    };
    if (!lie_in_vectors(rows)) return for_each_row(rows, one_by_one);
    ExprId physical = named(rows.name + "_at", translated(place, rows.at, rows.name).value);
    Block vectors = collect([&] {
        const std::uint32_t slot = binding(place, Access::write);
        cx.pass.bindings[slot].in_rows = true;
        ExprId first = first_vector(rows, physical);
        for_each_row(rows, [&](ExprId row) {
            for (std::uint32_t part = 0; part < parts_of(rows); ++part) {
                Stmt made = statement(StmtOp::store, stmt.span);
                made.slot = slot;
                made.target = vector_at(rows, first, row, part);
                made.value = vector_of(rows, items, row, part);
                append(std::move(made));
            }
        });
    });
    append_if(are_vectors(rows, physical), std::move(vectors), collect([&] { for_each_row(rows, one_by_one); }));
}

}  // namespace gliftc::lower
