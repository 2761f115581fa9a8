// Thread coarsening in kernels over blocks: an invocation of a shader takes several elements of a block, a workgroup's
// width apart. Each invocation computes the values that depend on the block alone: once for all its elements.
//
// For blocks all of whose elements are visited, devices that skip branches run separate code, if several elements may
// load before any of them is stored. It has no loop over the elements, which lie at constant distances from the
// invocation's first one. A loop that stores before it loads again would wait for memory in every iteration.
#include "ir/walk.h"
#include "lower/analysis/block_values.h"
#include "lower/build/copy_statements.h"
#include "lower/expand/blocks.h"
#include "lower/expand/dispatch.h"
#include "lower/transform/coarsen.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

/// Limits for the loads and nodes of all elements together that load before any of them is stored: more would take too
/// many registers.
constexpr std::size_t most_loads_together = 64, most_nodes_together = 4096;

/// Whether the statements may be the body of a loop over elements: they have no returns, and no loops, whose iterations
/// would be multiplied by those of the loop around them.
bool may_be_looped(const Context& cx, const std::vector<StmtId>& body) {
    bool may = true;
    for_each_statement(cx.p, body, [&](const Stmt& stmt) {
        may = may && stmt.op != StmtOp::return_ && stmt.op != StmtOp::for_ && stmt.op != StmtOp::while_;
    });
    return may;
}

/// A body, divided into the `let`s whose values depend on the block alone and the other statements, for each element.
struct Parts {
    std::vector<StmtId> of_block, of_element;
    ExprId holds;  ///< the value of the `evaluate` that Expander::visited_block makes with Guards::block: whether the
                   ///< statements after it are valid; absent: there is none, or it depends on the element
};

Parts divided(Context& cx, const std::vector<StmtId>& body) {
    Parts parts;
    BlockValues values(cx);
    for (StmtId id : body) {
        const Stmt& stmt = cx.p.stmts[id];
        const bool is_condition =
            !parts.holds && stmt.op == StmtOp::evaluate && cx.build.type(stmt.value) == cx.p.types.bool_;
        if (is_condition && values.has(stmt.value)) parts.holds = stmt.value;
        else (values.has(stmt) ? parts.of_block : parts.of_element).push_back(id);
    }
    return parts;
}

class BlockCoarsening {
public:
    BlockCoarsening(Context& context, std::uint64_t volume, std::uint32_t elements)
        : cx(context), volume_(volume), elements_(elements), width_(context.pass.group[0]) {}

    /// A loop over the invocation's elements. `body` tests whether an element is visited.
    StmtId loop_over(const std::vector<StmtId>& body) {
        Stmt loop = statement(StmtOp::for_, cx.kernel.span);
        loop.local = cx.new_local("turn", cx.p.types.uint, cx.kernel.span);
        loop.value = cx.build.uint(0);
        loop.limit = cx.build.uint(elements_);
        loop.unrolled = true;
        const ExprId step = cx.build.multiply(cx.build.local(loop.local), cx.build.uint(width_));
        StatementCopy copy(cx, address_at(cx.build.add(first_position(), step)));
        for (StmtId id : body) loop.body.push_back(copy.of(id));
        return cx.add(std::move(loop));
    }

    /// The code for all elements of the invocation, without a loop. It takes groups of `together` elements: all
    /// elements of a group load before any of them is stored.
    std::vector<StmtId> whole(const std::vector<StmtId>& body, std::uint32_t together) {
        Stmt first = statement(StmtOp::let, cx.kernel.span);
        first.local = cx.new_local("first", cx.p.types.uint, cx.kernel.span);
        first.value = first_position();
        cx.build.limits[first.local] = volume_ - std::uint64_t{elements_ - 1} * width_ - 1;
        cx.definitions[first.local] = first.value;
        const ExprId start = cx.build.local(first.local);
        result_ = {cx.add(std::move(first))};
        for (std::uint32_t turn = 0; turn < elements_; turn += together) {
            std::vector<StmtId> stores;
            for (std::uint32_t i = turn; i < turn + together; ++i) {
                const ExprId at = cx.build.add(start, cx.build.uint(i * width_));
                StatementCopy copy(cx, address_at(at));
                for (StmtId id : body) add(copy, id, at, stores);
            }
            result_.insert(result_.end(), stores.begin(), stores.end());
        }
        return std::move(result_);
    }

private:
    ExprId first_position() { return cx.build.component(cx.build.local(cx.pass.address), 0); }

    ExprId address_at(ExprId position) {
        const ExprId address = cx.build.local(cx.pass.address);
        return cx.build.construct(cx.build.type(address), {position, cx.build.component(address, 1)});
    }

    /// Adds a copy of the statement for the element at position `at`. The position is substituted as a sum wherever it
    /// is used, so that quotients and remainders of it fold.
    void add(StatementCopy& copy, StmtId id, ExprId at, std::vector<StmtId>& stores) {
        const Stmt& stmt = cx.p.stmts[id];
        if (stmt.op == StmtOp::let && stmt.value && stmt.value == first_of(stmt.value) &&
            !cx.p.locals[stmt.local].is_mutable)
            return copy.replace(stmt.local, at);
        const StmtId made = copy.of(id);
        if (!has_store(cx.p, cx.p.stmts[made])) return result_.push_back(made);
        stores.push_back(with_named_value(cx, made, false, result_));
    }

    /// The value itself if it is the invocation's position in the block, else absent.
    ExprId first_of(ExprId value) const {
        const Expr& node = cx.p.exprs[value];
        const bool is_position = node.op == Op::swizzle && !cx.p.types.is_vector(node.type) && node.lanes[0] == 0 &&
                                 cx.p.exprs[node.operands[0]].op == Op::local &&
                                 cx.p.exprs[node.operands[0]].local == cx.pass.address;
        return is_position ? value : ExprId{};
    }

    Context& cx;
    std::uint64_t volume_;
    std::uint32_t elements_, width_;
    std::vector<StmtId> result_;
};

/// How many elements may load before any of them is stored; one: there is no gain.
std::uint32_t elements_together(const StoredLast& body, std::uint32_t elements) {
    if (!body.holds) return 1;
    const auto is_much = [&](std::uint32_t together) {
        return together * body.loads > most_loads_together || together * body.nodes > most_nodes_together;
    };
    while (elements > 1 && is_much(elements)) elements /= 2;
    return elements;
}

}  // namespace

Coarsened coarsened_in_block(Context& cx, const std::vector<StmtId>& body, const std::vector<StmtId>& whole) {
    const std::optional<std::uint64_t> volume = block_volume(cx);
    const std::uint32_t elements = volume ? elements_in_block(*volume) : 1;
    if (elements == 1 || !may_be_looped(cx, body)) return {};
    BlockCoarsening coarsening(cx, *volume, elements);
    Parts any = divided(cx, body);
    Coarsened made;
    made.elements = {elements, 1, 1};
    made.in_range = in_range_condition(cx);
    made.body = std::move(any.of_block);
    const StmtId loop = coarsening.loop_over(any.of_element);
    const Parts parts = divided(cx, whole);
    const std::uint32_t together = parts.holds ? elements_together(stored_last(cx, parts.of_element), elements) : 1;
    if (together == 1) {
        made.body.push_back(loop);
        return made;
    }
    made.body.insert(made.body.end(), parts.of_block.begin(), parts.of_block.end());
    Stmt choice = statement(StmtOp::if_, cx.kernel.span);
    choice.value = cx.build.both(cx.build.builtin(Builtin::skips_branches, cx.p.types.bool_), parts.holds);
    choice.body = coarsening.whole(parts.of_element, together);
    choice.otherwise = {loop};
    made.body.push_back(cx.add(std::move(choice)));
    return made;
}

}  // namespace gliftc::lower
