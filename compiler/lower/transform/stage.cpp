#include "lower/transform/stage.h"

#include "ir/effects.h"
#include "ir/walk.h"
#include "lower/analysis/staged_loads.h"
#include "lower/build/copy_statements.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <utility>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint32_t rounds_in_line = 256;    ///< that are staged together, of kernels in one dimension
constexpr std::uint32_t rounds_in_space = 32;    ///< in more
constexpr std::uint32_t most_bytes = 16 * 1024;  ///< of workgroup memory, which every device has
constexpr std::uint32_t elements_of_column = 4;
constexpr std::size_t most_nodes = 160;  ///< of a round of one element, if an invocation takes several

struct Tile : StagedLoad {
    LocalId array;
};

class Staging {
public:
    Staging(Context& context, StagedLoop found) : cx(context), build(context.build), loop_(std::move(found)) {}

    /// Takes the loads for which there is memory. False: there are none.
    bool choose() {
        made_.group = cx.pass.group;
        rounds_ = cx.pass.rank == 1 ? rounds_in_line : rounds_in_space;
        const auto is_same_in_column = [](const StagedLoad& load) { return (load.axes >> 1 & 1) == 0; };
        if (cx.pass.rank > 1 && std::ranges::any_of(loop_.loads, is_same_in_column) && is_short())
            made_.elements[1] = elements_of_column;
        std::uint32_t bytes = 0;
        for (const StagedLoad& load : loop_.loads) {
            const std::uint32_t more = length(load) * 4 * cx.p.types.components(cx.p.exprs[load.nodes[0]].type);
            if (bytes + more > most_bytes) continue;
            bytes += more;
            tiles_.push_back({load, {}});
        }
        return !tiles_.empty();
    }

    std::vector<PassStaged> summary() const {
        std::vector<PassStaged> result;
        for (const Tile& tile : tiles_) result.push_back({tile.binding, rounds_, count(tile)});
        return result;
    }

    SeveralElements run() {
        for (Tile& tile : tiles_) allocate(tile);
        measure();
        for (std::uint32_t i = 0; i < made_.elements[1]; ++i) begin_element(i);
        for (Element& element : elements_)
            for (StmtId id : loop_.before) made_.body.push_back(element.copy.of(id));
        add_loop();
        for (Element& element : elements_) {
            std::vector<StmtId> last;
            for (StmtId id : loop_.after) last.push_back(element.copy.of(id));
            made_.body.push_back(where(element.exists, std::move(last)));
        }
        return std::move(made_);
    }

private:
    /// An element of the invocation: where it does not exist, the first element of the range stands for it.
    struct Element {
        Element(Context& context, ExprId test, ExprId address) : exists(test), copy(context, address) {}
        ExprId exists;
        StatementCopy copy;
    };

    bool is_short() const {
        std::size_t nodes = 0;
        for_each_expression(cx.p, cx.p.stmts[loop_.loop].body, [&](ExprId) { ++nodes; });
        return nodes <= most_nodes;
    }

    /// How many elements the workgroup has along the axis.
    std::uint32_t width(std::uint32_t axis) const { return cx.pass.group[axis] * made_.elements[axis]; }

    /// The number of entries of the load's tile: one for each round and for each address along the load's axes.
    std::uint32_t count(const StagedLoad& load) const {
        std::uint32_t entries = rounds_;
        for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis)
            if (load.axes >> axis & 1) entries *= width(axis);
        return entries;
    }

    /// In the tile, entries of consecutive x are consecutive. If invocations fill it by rounds, rows are one entry
    /// longer, so that those of consecutive rounds are in different banks of workgroup memory.
    std::uint32_t row(const StagedLoad& load) const { return width(0) + (load.is_row ? 0 : 1); }
    std::uint32_t length(const StagedLoad& load) const {
        return load.axes & 1 ? count(load) / width(0) * row(load) : count(load);
    }

    // Statements.

    const Stmt& loop() const { return cx.p.stmts[loop_.loop]; }
    void barrier(std::vector<StmtId>& to) { to.push_back(cx.add(statement(StmtOp::barrier, loop().span))); }
    StmtId assign(ExprId target, ExprId value) {
        Stmt stmt = statement(StmtOp::assign, loop().span);
        stmt.target = target;
        stmt.value = value;
        return cx.add(std::move(stmt));
    }
    StmtId where(ExprId condition, std::vector<StmtId> body, std::vector<StmtId> otherwise = {}) {
        Stmt stmt = statement(StmtOp::if_, loop().span);
        stmt.value = condition;
        stmt.body = std::move(body);
        stmt.otherwise = std::move(otherwise);
        return cx.add(std::move(stmt));
    }
    ExprId named(std::string_view name, ExprId value, std::vector<StmtId>& to) {
        Stmt stmt = statement(StmtOp::let, loop().span);
        stmt.local = cx.new_local(name, build.type(value), stmt.span);
        stmt.value = value;
        cx.definitions[stmt.local] = value;
        const ExprId local = build.local(stmt.local);
        to.push_back(cx.add(std::move(stmt)));
        return local;
    }
    /// A loop over the numbers from 0 to `limit`; `body` adds the statements of one.
    StmtId loop_to(std::string_view variable, ExprId limit,
                   const std::function<void(ExprId, std::vector<StmtId>&)>& body) {
        Stmt stmt = statement(StmtOp::for_, loop().span);
        stmt.local = cx.new_local(variable, cx.p.types.uint, stmt.span);
        stmt.value = build.uint(0);
        stmt.limit = limit;
        std::vector<StmtId> statements;
        body(build.local(stmt.local), statements);
        stmt.body = std::move(statements);
        return cx.add(std::move(stmt));
    }

    ExprId less(ExprId a, ExprId b) { return build.binary(BinaryOp::less, a, b); }
    ExprId minus(ExprId a, ExprId b) { return build.binary(BinaryOp::subtract, a, b); }
    ExprId quotient(ExprId a, std::uint32_t b) { return build.binary(BinaryOp::divide, a, build.uint(b)); }
    ExprId remainder(ExprId a, std::uint32_t b) { return build.binary(BinaryOp::remainder, a, build.uint(b)); }
    ExprId component(ExprId address, std::uint32_t axis) {
        return cx.pass.rank == 1 ? address : build.component(address, axis);
    }
    ExprId address_of(Operands parts) {
        return cx.pass.rank == 1 ? parts[0] : build.construct(cx.p.locals[cx.pass.address].type, std::move(parts));
    }

    void allocate(Tile& tile) {
        const TypeId element = cx.p.exprs[tile.nodes[0]].type;
        tile.array = cx.new_local(cx.pass.bindings[tile.binding].name + "_tile",
                                  cx.p.types.array(element, length(tile)), loop().span, true);
        cx.p.locals[tile.array].storage = Storage::shared;
        cx.pass.shared.push_back(tile.array);
    }

    // Elements.

    /// Computes the invocation's place in the workgroup, and how many elements the range has from the workgroup's first
    /// one on.
    void measure() {
        lane_ = build.builtin(Builtin::local_index, cx.p.types.uint);
        std::uint32_t before = 1;
        for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) {
            const std::uint32_t group = cx.pass.group[axis];
            ExprId at = quotient(lane_, before);
            if (axis + 1 < cx.pass.rank) at = remainder(at, group);
            at = build.multiply(at, build.uint(made_.elements[axis]));
            before *= group;
            const ExprId address = component(build.local(cx.pass.address), axis), size = component(cx.size, axis);
            const std::string name = cx.pass.rank == 1 ? "" : std::string("_") + "xyz"[axis];
            at_.push_back(named("own" + name, at, made_.body));
            first_.push_back(named("first" + name, minus(address, at_.back()), made_.body));
            const ExprId left = build.select(less(first_.back(), size), minus(size, first_.back()), build.uint(0));
            left_.push_back(named("left" + name, left, made_.body));
        }
    }

    /// Compares distances, since the address of an element that does not exist may exceed 32 bits.
    ExprId exists(const std::vector<ExprId>& distances) {
        ExprId all;
        for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis)
            if (distances[axis]) all = build.both(all, less(distances[axis], left_[axis]));
        return all;
    }

    void begin_element(std::uint32_t number) {
        std::vector<ExprId> distances = at_;
        if (number != 0) distances[1] = build.add(distances[1], build.uint(number));
        const ExprId exists = named("exists", this->exists(distances), made_.body);
        Operands parts;
        for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) {
            ExprId part = component(build.local(cx.pass.address), axis);
            if (axis == 1) part = build.add(part, build.uint(number));
            parts.push_back(build.select(exists, part, build.uint(0)));
        }
        elements_.emplace_back(cx, exists, named("at", address_of(std::move(parts)), made_.body));
    }

    // The loop.

    void add_loop() {
        // The range is the same for all elements: the first one's locals have it.
        Stmt loop = this->loop();
        loop.value = elements_.front().copy.of(loop.value);
        loop.limit = elements_.front().copy.of(loop.limit);
        const bool begins_at_zero = build.bits_of(loop.value) == std::uint64_t{0};
        const ExprId from = minus(loop.limit, loop.value), zero = build.uint(0);
        const ExprId all = begins_at_zero ? loop.limit : build.select(less(loop.value, loop.limit), from, zero);
        const ExprId rest = build.intrinsic(Intrinsic::min, cx.p.types.uint, {remainder(all, rounds_), build.uint(1)});
        const ExprId steps = build.add(quotient(all, rounds_), rest);
        cx.name(steps, "steps");
        made_.body.push_back(loop_to("step", steps, [&](ExprId step, std::vector<StmtId>& body) {
            const ExprId done = build.multiply(step, build.uint(rounds_));
            const ExprId begin = named("begin", build.add(loop.value, done), body);
            const ExprId most =
                build.intrinsic(Intrinsic::min, cx.p.types.uint, {minus(loop.limit, begin), build.uint(rounds_)});
            const ExprId count = named("count", most, body);
            barrier(body);
            for (const Tile& tile : tiles_) fill(tile, begin, count, body);
            barrier(body);
            // Compilers unroll the loop only if they know its length.
            const ExprId is_whole = build.binary(BinaryOp::equal, count, build.uint(rounds_));
            const StmtId whole = loop_to("round", build.uint(rounds_), [&](ExprId round, std::vector<StmtId>& inner) {
                execute(build.add(begin, round), round, inner);
            });
            const StmtId part = StatementCopy(cx, build.local(cx.pass.address)).of(whole);
            cx.p.stmts[part].limit = count;
            body.push_back(where(is_whole, {whole}, {part}));
        }));
    }

    /// One round of each element.
    void execute(ExprId number, ExprId round, std::vector<StmtId>& to) {
        const std::string_view name = (*cx.p.names)[cx.p.locals[loop().local].name];
        const ExprId variable = named(name, number, to);
        for (std::uint32_t i = 0; i < elements_.size(); ++i) {
            StatementCopy& copy = elements_[i].copy;
            copy.replace(loop().local, variable);
            for (const Tile& tile : tiles_) {
                const ExprId value = build.index(build.local(tile.array), number_of(tile, own_entry(round, i)));
                for (ExprId node : tile.nodes) copy.replace(node, value);
            }
            for (StmtId id : loop().body) to.push_back(copy.of(id));
        }
    }

    // Tiles. Consecutive invocations fill entries of consecutive x, if these have consecutive elements, else of
    // consecutive rounds.

    /// What an entry is for: a round, and distances from the workgroup's first element along each of the load's axes.
    struct Entry {
        ExprId round;
        std::vector<ExprId> distances;
    };

    ExprId number_of(const Tile& tile, const Entry& entry) {
        ExprId outer;
        for (std::uint32_t axis = cx.pass.rank; axis-- > 1;) {
            const ExprId at = entry.distances[axis];
            if ((tile.axes >> axis & 1) == 0) continue;
            outer = outer ? build.add(build.multiply(outer, build.uint(width(axis))), at) : at;
        }
        ExprId number = outer ? build.add(build.multiply(outer, build.uint(rounds_)), entry.round) : entry.round;
        if (tile.axes & 1) number = build.add(build.multiply(number, build.uint(row(tile))), entry.distances[0]);
        return number;
    }

    /// What the invocation's element `number` reads.
    Entry own_entry(ExprId round, std::uint32_t number) {
        Entry entry{round, at_};
        if (number != 0) entry.distances[1] = build.add(at_[1], build.uint(number));
        return entry;
    }

    /// What the invocation with this number, of count(tile), fills.
    Entry entry_to_fill(const Tile& tile, ExprId number) {
        Entry entry{{}, std::vector<ExprId>(cx.pass.rank)};
        std::uint32_t left = count(tile);
        const auto take = [&](std::uint32_t width) {
            left /= width;
            const ExprId part = left == 1 ? number : remainder(number, width);
            number = quotient(number, width);
            return part;
        };
        if (!tile.is_row) entry.round = take(rounds_);
        if (tile.axes & 1) entry.distances[0] = take(width(0));
        if (tile.is_row) entry.round = take(rounds_);
        for (std::uint32_t axis = 1; axis < cx.pass.rank; ++axis)
            if (tile.axes >> axis & 1) entry.distances[axis] = take(width(axis));
        return entry;
    }

    void fill(const Tile& tile, ExprId begin, ExprId count, std::vector<StmtId>& to) {
        const std::uint32_t all = this->count(tile), group = cx.pass.group[0] * cx.pass.group[1] * cx.pass.group[2];
        const auto load = [&](ExprId number, std::vector<StmtId>& body) {
            std::vector<StmtId> inner;
            load_entry(tile, number, begin, count, inner);
            if (all % group == 0) return void(body.insert(body.end(), inner.begin(), inner.end()));
            body.push_back(where(less(number, build.uint(all)), std::move(inner)));
        };
        if (all <= group) return load(lane_, to);
        const std::uint32_t turns = (all + group - 1) / group;
        const StmtId filling = loop_to("turn", build.uint(turns), [&](ExprId turn, std::vector<StmtId>& body) {
            load(named("entry", build.add(build.multiply(turn, build.uint(group)), lane_), body), body);
        });
        cx.p.stmts[filling].unrolled = turns <= elements_of_column;
        to.push_back(filling);
    }

    /// Entries of rounds or of elements that do not exist get the value of others.
    void load_entry(const Tile& tile, ExprId number, ExprId begin, ExprId count, std::vector<StmtId>& to) {
        const Entry entry = entry_to_fill(tile, number);
        const ExprId is_there = named("is_there", build.both(less(entry.round, count), exists(entry.distances)), to);
        Operands parts;
        for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) {
            const ExprId distance = entry.distances[axis];
            const ExprId part = distance ? build.add(first_[axis], distance) : first_[axis];
            parts.push_back(distance ? build.select(is_there, part, build.uint(0)) : build.uint(0));
        }
        StatementCopy copy(cx, address_of(std::move(parts)));
        const ExprId round = build.add(begin, build.select(is_there, entry.round, build.uint(0)));
        copy.replace(loop().local, named((*cx.p.names)[cx.p.locals[loop().local].name], round, to));
        const ExprId value =
            named(cx.pass.bindings[tile.binding].name + "_loaded", copy.with_definitions(tile.nodes[0]), to);
        to.push_back(assign(build.index(build.local(tile.array), number_of(tile, entry)), value));
    }

    Context& cx;
    Builder& build;
    StagedLoop loop_;
    std::vector<Tile> tiles_;
    std::deque<Element> elements_;
    SeveralElements made_;
    std::uint32_t rounds_ = 0;  ///< that are staged together
    ExprId lane_;
    std::vector<ExprId> at_;     ///< the invocation's first element along each axis, from the workgroup's first one
    std::vector<ExprId> first_;  ///< the address of the workgroup's first element
    std::vector<ExprId> left_;   ///< how many elements the range has from there on
};

}  // namespace

std::optional<SeveralElements> staged(Context& cx, const std::vector<StmtId>& body) {
    if (cx.kernel.grouped() || cx.kernel.space || cx.kernel.raster || cx.kernel.items != 1 || cx.pass.rank > 3)
        return {};
    // Workgroups that wait for one another must not wait for elements that an invocation takes later.
    if (std::ranges::any_of(cx.pass.bindings, &PassBinding::coherent)) return {};
    StagedLoop found = StagedLoads(cx).of(body);
    if (found.loads.empty()) return {};
    Staging staging(cx, std::move(found));
    if (!staging.choose()) return {};
    cx.pass.staged = staging.summary();
    return staging.run();
}

}  // namespace gliftc::lower
