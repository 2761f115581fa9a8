#include "lower/transform/tile.h"

#include "ir/walk.h"
#include "lower/analysis/transposed.h"
#include "lower/build/copy_statements.h"
#include "lower/build/statements.h"
#include "lower/expand/dispatch.h"

#include <algorithm>
#include <utility>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint32_t side = 32;               ///< of a tile
constexpr std::uint32_t elements = 4;            ///< that an invocation takes
constexpr std::uint32_t most_bytes = 16 * 1024;  ///< of workgroup memory, which every device has

struct Tile : TransposedAccess {
    LocalId array;
    LocalId is_written;  ///< of a store that does not depend on the address alone: an array of uints, 1 or 0
};

class Tiling {
public:
    Tiling(Context& context, TransposedAccesses& accesses) : cx(context), build(context.build), accesses_(accesses) {}

    /// Takes the accesses for whose tiles there is memory. False: there are none.
    bool choose(const std::vector<TransposedAccess>& found) {
        std::uint32_t bytes = 0;
        for (const TransposedAccess& access : found) {
            const std::uint32_t more = side * side * (access.bytes + (needs_flags(access) ? 4 : 0));
            if (bytes + more > most_bytes) continue;
            bytes += more;
            tiles_.push_back({access, {}, {}});
        }
        return !tiles_.empty();
    }

    std::vector<PassTile> summary() const {
        std::vector<PassTile> result;
        for (const Tile& tile : tiles_) result.push_back({tile.binding, tile.axis, tile.is_store()});
        return result;
    }

    SeveralElements run(const std::vector<StmtId>& body) {
        axis_ = tiles_.front().axis;
        made_.group[0] = side;
        made_.group[axis_] = side / elements;
        made_.elements[axis_] = elements;
        for (Tile& tile : tiles_) allocate(tile);
        measure();
        std::vector<StmtId> all = std::exchange(made_.body, {});
        exchange_through_tiles(body);
        std::vector<StmtId> tiled = std::exchange(made_.body, {});
        take_elements_plainly(body);
        // Where branches are not skipped (on lavapipe), workgroup memory is no faster than other memory.
        const ExprId is_faster = build.builtin(Builtin::skips_branches, cx.p.types.bool_);
        all.push_back(where(is_faster, std::move(tiled), std::exchange(made_.body, {})));
        made_.body = std::move(all);
        return std::move(made_);
    }

private:
    /// The position of an element in the tile, along x and along the tile's other axis.
    struct Position {
        ExprId x, other;
    };
    /// An element of the range, if it exists: the tile may extend beyond the range.
    struct Element {
        Position position;
        ExprId exists;
        ExprId address;  ///< that of the first element of the range if the element does not exist
    };

    bool needs_flags(const TransposedAccess& access) const {
        const auto is_of_address = [&](const Condition& of) { return accesses_.is_of_address(of.value); };
        return !std::ranges::all_of(access.conditions, is_of_address);
    }

    // Statements.

    Statements statements(Span span) { return {cx, span}; }
    void barrier() { made_.body.push_back(statements(cx.kernel.span).barrier()); }
    StmtId assign(Span span, ExprId target, ExprId value) { return statements(span).assign(target, value); }
    StmtId where(ExprId condition, std::vector<StmtId> body, std::vector<StmtId> otherwise = {}) {
        return statements(cx.kernel.span).where(condition, std::move(body), std::move(otherwise));
    }
    ExprId named(Span span, std::string_view name, ExprId value, std::vector<StmtId>& into) {
        return statements(span).let(name, value, into);
    }
    ExprId named(std::string_view name, ExprId value) { return named(cx.kernel.span, name, value, made_.body); }
    ExprId less(ExprId a, ExprId b) { return build.binary(BinaryOp::less, a, b); }

    void allocate(Tile& tile) {
        const std::string& name = cx.pass.bindings[tile.binding].name;
        tile.array = workgroup_array(name + "_tile", cx.pass.bindings[tile.binding].element);
        if (needs_flags(tile)) tile.is_written = workgroup_array(name + "_is_written", cx.p.types.uint);
    }

    LocalId workgroup_array(std::string_view name, TypeId element) {
        const LocalId local = cx.new_local(name, cx.p.types.array(element, side * side), cx.kernel.span, true);
        cx.p.locals[local].storage = Storage::shared;
        cx.pass.shared.push_back(local);
        return local;
    }

    // Elements.

    /// Computes where the invocation's elements are in the tile, and how much of the tile is in the range.
    void measure() {
        const TypeId uint3 = cx.p.types.vector(cx.p.types.uint, 3);
        const auto lane = [&](std::uint32_t axis) {
            return build.component(build.builtin(Builtin::local_id, uint3), axis);
        };
        const ExprId address = build.local(cx.pass.address);
        column_ = named("column", lane(0));
        row_ = named("row", build.multiply(lane(axis_), build.uint(elements)));
        Operands parts;
        for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) parts.push_back(build.component(address, axis));
        parts[0] = build.binary(BinaryOp::subtract, parts[0], column_);
        parts[axis_] = build.binary(BinaryOp::subtract, parts[axis_], row_);
        first_ = named("first", build.construct(build.type(address), std::move(parts)));
        StatementCopy copy(cx, first_);
        const ExprId is_inside = named("is_inside", copy.of(in_range_condition(cx)));
        // Compares positions in the tile, since the address of an element that does not exist may exceed 32 bits.
        const auto left = [&](std::uint32_t axis) {
            const ExprId after =
                build.binary(BinaryOp::subtract, build.component(cx.size, axis), build.component(first_, axis));
            return build.select(is_inside, after, build.uint(0));
        };
        width_ = named("width", left(0));
        height_ = named("height", left(axis_));
    }

    Position own(std::uint32_t number) { return {column_, build.add(row_, build.uint(number))}; }
    Position exchanged(std::uint32_t number) { return {build.add(row_, build.uint(number)), column_}; }

    Element element_at(Position position) {
        Operands parts;
        for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) parts.push_back(build.component(first_, axis));
        parts[0] = build.add(parts[0], position.x);
        parts[axis_] = build.add(parts[axis_], position.other);
        const TypeId type = build.type(first_);
        const ExprId address = build.construct(type, std::move(parts));
        const ExprId exists = named("exists", build.both(less(position.x, width_), less(position.other, height_)));
        return {position, exists, named("at", build.select(exists, address, build.zero(type)))};
    }

    /// The elements that the invocation loads and stores with x and the tile's other axis exchanged.
    const std::vector<Element>& exchanged_elements() {
        for (std::uint32_t i = 0; exchanged_.size() < elements; ++i) exchanged_.push_back(element_at(exchanged(i)));
        return exchanged_;
    }

    /// The number of an element's entry in the tile. Within each row, entries are permuted by the number of the row:
    /// both a row and a column of the tile are spread over all banks of workgroup memory.
    ExprId entry(Position at) {
        const ExprId column = build.binary(BinaryOp::bit_xor, at.x, at.other);
        return build.add(build.multiply(at.other, build.uint(side)), column);
    }
    ExprId entry_of(LocalId array, ExprId entry) { return build.index(build.local(array), entry); }

    void exchange_through_tiles(const std::vector<StmtId>& body) {
        const bool has_loads = !std::ranges::all_of(tiles_, &Tile::is_store);
        if (has_loads) {
            load_tiles();
            barrier();
        }
        take_elements(body);
        if (std::ranges::any_of(tiles_, &Tile::is_store)) {
            barrier();
            store_tiles();
        }
    }

    /// Executes the body as it is written for each of the invocation's elements.
    void take_elements_plainly(const std::vector<StmtId>& body) {
        for (std::uint32_t i = 0; i < elements; ++i) {
            const Element element = element_at(own(i));
            StatementCopy copy(cx, element.address);
            std::vector<StmtId> statements;
            for (StmtId id : body) statements.push_back(copy.of(id));
            made_.body.push_back(where(element.exists, std::move(statements)));
        }
    }

    void load_tiles() {
        std::vector<StmtId> writes;
        for (const Element& element : exchanged_elements()) {
            StatementCopy copy(cx, element.address);
            const ExprId entry = named("entry", this->entry(element.position));
            for (const Tile& tile : tiles_) {
                if (tile.is_store()) continue;
                const std::string name = cx.pass.bindings[tile.binding].name + "_loaded";
                const ExprId value = named(name, copy.with_definitions(tile.loads[0]));
                writes.push_back(assign(cx.kernel.span, entry_of(tile.array, entry), value));
            }
        }
        made_.body.insert(made_.body.end(), writes.begin(), writes.end());
    }

    void store_tiles() {
        for (const Element& element : exchanged_elements()) {
            StatementCopy copy(cx, element.address);
            const ExprId entry = named("entry", this->entry(element.position));
            std::vector<StmtId> stores;
            for (const Tile& tile : tiles_)
                if (tile.is_store()) stores.push_back(store(tile, copy, entry));
            made_.body.push_back(where(element.exists, std::move(stores)));
        }
    }

    StmtId store(const Tile& tile, StatementCopy& copy, ExprId entry) {
        ExprId condition;
        if (tile.is_written) {
            condition = build.binary(BinaryOp::not_equal, entry_of(tile.is_written, entry), build.uint(0));
        } else {
            for (const Condition& of : tile.conditions) {
                const ExprId value = copy.with_definitions(of.value);
                condition = build.both(condition, of.is_true ? value : build.negate(value));
            }
        }
        Stmt stmt = cx.p.stmts[tile.store];
        stmt.target = copy.with_definitions(stmt.target);
        stmt.value = entry_of(tile.array, entry);
        const StmtId made = cx.add(std::move(stmt));
        return condition ? where(condition, {made}) : made;
    }

    // The invocation's own elements.

    void take_elements(const std::vector<StmtId>& body) {
        entry_ = cx.new_local("entry", cx.p.types.uint, cx.kernel.span);
        divide(body);
        std::vector<StmtId> writes, rest;
        for (std::uint32_t i = 0; i < elements; ++i) {
            const Element element = element_at(own(i));
            const ExprId entry = named("entry", this->entry(element.position));
            StatementCopy copy(cx, element.address);
            copy.replace(entry_, entry);
            for (const Tile& tile : tiles_)
                for (ExprId load : tile.loads) copy.replace(load, entry_of(tile.array, entry));
            for (StmtId id : hoisted_) made_.body.push_back(copy.of(id));
            for (StmtId id : writes_) writes.push_back(copy.of(id));
            std::vector<StmtId> statements;
            for (const Tile& tile : tiles_)
                if (tile.is_written)
                    statements.push_back(assign(cx.kernel.span, entry_of(tile.is_written, entry), build.uint(0)));
            for (StmtId id : rest_) statements.push_back(copy.of(id));
            if (!statements.empty()) rest.push_back(where(element.exists, std::move(statements)));
        }
        made_.body.insert(made_.body.end(), writes.begin(), writes.end());
        made_.body.insert(made_.body.end(), rest.begin(), rest.end());
    }

    /// Hoists `let`s of values that cannot change, conditions that load, and the values of tiles' stores: they can run
    /// at any address of the range, and run for all elements of the invocation before the rest does, so that their
    /// loads overlap.
    void divide(const std::vector<StmtId>& body) {
        for (StmtId id : body)
            if (const StmtId made = rewritten(id)) take(made);
    }

    void take(StmtId id) {
        const Stmt stmt = cx.p.stmts[id];
        const bool may_be_hoisted = this->may_be_hoisted(stmt.value);
        if (may_be_hoisted && stmt.op == StmtOp::let && !cx.p.locals[stmt.local].is_mutable)
            return hoisted_.push_back(id);
        if (stmt.op == StmtOp::let) unhoisted_.insert(stmt.local);
        if (!may_be_hoisted || stmt.op != StmtOp::if_ || !accesses_.has_load(stmt.value)) return rest_.push_back(id);
        const ExprId condition = named(stmt.span, "test", stmt.value, hoisted_);
        rest_.push_back(build.again(id, {stmt.target, condition, stmt.limit, stmt.body, stmt.otherwise}));
    }

    bool may_be_hoisted(ExprId value) {
        bool result = value && accesses_.is_fixed(value);
        if (!result) return false;
        for_each_node(cx.p, value, [&](ExprId node) {
            const Expr& local = cx.p.exprs[node];
            result = result && (local.op != Op::local || !unhoisted_.contains(local.local));
        });
        return result;
    }

    /// The statement with stores to tiles in place of those to memory; absent if nothing is left of it.
    StmtId rewritten(StmtId id) {
        const auto tile = std::ranges::find_if(tiles_, [&](const Tile& one) { return one.store == id; });
        if (tile != tiles_.end()) return tile_store(*tile);
        const Stmt stmt = cx.p.stmts[id];
        if (stmt.body.empty() && stmt.otherwise.empty()) return id;
        Builder::Parts parts{stmt.target, stmt.value, stmt.limit, rewritten(stmt.body), {}};
        parts.otherwise = rewritten(stmt.otherwise);
        if (parts.body.empty() && parts.otherwise.empty()) return {};
        return build.again(id, std::move(parts));
    }

    std::vector<StmtId> rewritten(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        for (StmtId id : body) {
            if (const StmtId made = rewritten(id)) result.push_back(made);
            const Stmt& stmt = cx.p.stmts[id];
            if (stmt.op == StmtOp::let) unhoisted_.insert(stmt.local);
        }
        return result;
    }

    /// The store of the invocation's element to the tile. If the source stores all elements, their values are written
    /// to the tile whether the address is guarded or not: absent.
    StmtId tile_store(const Tile& tile) {
        const Stmt stmt = cx.p.stmts[tile.store];
        const ExprId entry = build.local(entry_);
        if (!tile.is_conditional && !tile.is_written && may_be_hoisted(stmt.value)) {
            const std::string name = cx.pass.bindings[tile.binding].name + "_value";
            const ExprId value = is_trivial(cx, stmt.value) ? stmt.value : named(stmt.span, name, stmt.value, hoisted_);
            writes_.push_back(assign(stmt.span, entry_of(tile.array, entry), value));
            return {};
        }
        const StmtId written = assign(stmt.span, entry_of(tile.array, entry), stmt.value);
        if (!tile.is_written) return written;
        Stmt both = statement(StmtOp::block, stmt.span);
        both.body = {written, assign(stmt.span, entry_of(tile.is_written, entry), build.uint(1))};
        return cx.add(std::move(both));
    }

    Context& cx;
    Builder& build;
    TransposedAccesses& accesses_;
    std::vector<Tile> tiles_;
    SeveralElements made_;
    std::uint32_t axis_ = 1;  ///< the tile's axis besides x
    ExprId column_, row_;     ///< the position in the tile of the invocation's first element, along x and axis_
    ExprId first_;            ///< the address of the tile's first element
    ExprId width_, height_;   ///< how many elements the range has along x and axis_ from the tile's first one on
    std::vector<Element> exchanged_;
    LocalId entry_;                ///< stands for the entry of an element in the statements that are copied for each
    std::vector<StmtId> hoisted_;  ///< run first, for all elements
    std::vector<StmtId> writes_;   ///< to tiles: run next
    std::vector<StmtId> rest_;     ///< run last, for elements that exist
    IdSet<Local> unhoisted_;       ///< locals that statements which are not hoisted declare
};

}  // namespace

std::optional<SeveralElements> tiled(Context& cx, const std::vector<StmtId>& body) {
    if (cx.kernel.grouped() || cx.kernel.space || cx.kernel.raster || cx.kernel.items != 1) return {};
    if (cx.pass.rank < 2 || cx.pass.rank > 3) return {};
    const auto is_near = [](const KernelParam& param) { return param.pattern == Pattern::near; };
    if (std::ranges::any_of(cx.kernel.params, is_near)) return {};
    if (std::ranges::any_of(cx.pass.bindings, &PassBinding::coherent)) return {};
    TransposedAccesses accesses(cx);
    Tiling tiling(cx, accesses);
    if (!tiling.choose(accesses.of(body))) return {};
    cx.pass.tiles = tiling.summary();
    return tiling.run(body);
}

}  // namespace gliftc::lower
