#include "lower/transform/coarsen.h"

#include "ir/effects.h"
#include "ir/walk.h"
#include "lower/analysis/long_quotients.h"
#include "lower/analysis/number.h"
#include "lower/build/copy_statements.h"
#include "lower/expand/dispatch.h"

#include <algorithm>
#include <deque>
#include <unordered_map>

namespace gliftc::lower {

using namespace ir;

namespace {

bool is_store(const Stmt& stmt) { return stmt.op == StmtOp::store || stmt.op == StmtOp::image_store; }

}  // namespace

bool has_store(const Program& program, const Stmt& stmt) {
    const auto has = [&](StmtId id) { return has_store(program, program.stmts[id]); };
    return is_store(stmt) || std::ranges::any_of(stmt.body, has) || std::ranges::any_of(stmt.otherwise, has);
}

namespace {

/// Kernels with more loads or nodes have enough to do with one element, and two would take too many registers.
constexpr std::size_t most_loads = 16, most_of_one = 600;

/// The same of kernels whose elements share loads: of four elements together.
constexpr std::size_t fewest_shared = 8, most_shared_loads = 80, most_of_four = 8000;

/// Whether a function, or one that it calls, has a loop: then one element is work enough for an invocation, and
/// lavapipe limits the iterations that an invocation may execute.
bool has_loop(const Program& program, FunctionId function, std::unordered_map<FunctionId, bool>& known) {
    if (const auto found = known.find(function); found != known.end()) return found->second;
    const auto& body = program.functions[function].body;
    bool found = false;
    for_each_statement(program, body, [&](const Stmt& stmt) {
        found = found || stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_;
    });
    for_each_expression(program, body, [&](ExprId id) {
        const Expr& node = program.exprs[id];
        found = found || (node.op == Op::call && has_loop(program, node.function, known));
    });
    known.emplace(function, found);
    return found;
}

/// Finds whether several elements may be computed before any is stored.
class Eligibility {
public:
    explicit Eligibility(Context& context) : cx(context), numbers_(context) {}

    StoredLast of(const std::vector<StmtId>& body) {
        if (cx.kernel.grouped() || cx.kernel.items != 1) return {};
        for (StmtId id : body) {
            const Stmt& stmt = cx.p.stmts[id];
            if (has_store(cx.p, stmt)) visit_store(stmt);
            else visit(stmt);
        }
        return {fits_ && stores_, loads_, nodes_, quotients_};
    }

private:
    /// Accepts straight-line code and ifs. After a store, expressions that load must be fixed (Numbers::is_fixed).
    void visit(const Stmt& stmt) {
        fits_ = fits_ && (stmt.op == StmtOp::let || stmt.op == StmtOp::assign || stmt.op == StmtOp::if_ ||
                          stmt.op == StmtOp::block);
        for_each_root(stmt, [&](ExprId root) {
            visit(root);
            fits_ = fits_ && (!stores_ || !changes_by_stores(root));
        });
        for (StmtId id : stmt.body) visit(cx.p.stmts[id]);
        for (StmtId id : stmt.otherwise) visit(cx.p.stmts[id]);
    }

    /// The value of a store outside of ifs is evaluated before any store. Addresses, conditions and all that is inside
    /// an if are evaluated later, when other elements may have stored, so they must not depend on memory that is
    /// written, nor on mutable locals.
    void visit_store(const Stmt& stmt) {
        fits_ = fits_ && (is_store(stmt) || stmt.op == StmtOp::if_);
        for_each_root(stmt, [&](ExprId root) {
            visit(root);
            const bool is_kept = is_store(stmt) && root == stmt.value;
            fits_ = fits_ && (is_kept ? !stores_ || !changes_by_stores(root) : numbers_.is_fixed(root));
        });
        stores_ = true;
        for (StmtId id : stmt.body) visit_inside(cx.p.stmts[id]);
        for (StmtId id : stmt.otherwise) visit_inside(cx.p.stmts[id]);
    }

    void visit_inside(const Stmt& stmt) {
        fits_ = fits_ && (is_store(stmt) || stmt.op == StmtOp::if_ || stmt.op == StmtOp::let);
        fits_ = fits_ && (stmt.op != StmtOp::let || !cx.p.locals[stmt.local].is_mutable);
        for_each_root(stmt, [&](ExprId root) {
            visit(root);
            fits_ = fits_ && numbers_.is_fixed(root);
        });
        for (StmtId id : stmt.body) visit_inside(cx.p.stmts[id]);
        for (StmtId id : stmt.otherwise) visit_inside(cx.p.stmts[id]);
    }

    void visit(ExprId root) {
        fits_ = fits_ && numbers_.is_pure(root);
        for_each_node(cx.p, root, seen_, [&](ExprId id) { visit(cx.p.exprs[id]); });
    }

    bool changes_by_stores(ExprId root) { return numbers_.has_load(root) && !numbers_.is_fixed(root); }

    void visit(const Expr& node) {
        ++nodes_;
        quotients_ += is_long_quotient(cx, node);
        loads_ += is_load(node.op);
        fits_ = fits_ && node.op != Op::builtin;
        if (node.op == Op::call) fits_ = fits_ && !writes_what_it_reads() && !has_loop(cx.p, node.function, has_loop_);
    }

    /// Whether some binding is both read and written: functions may load from any binding.
    bool writes_what_it_reads() const {
        return std::ranges::any_of(cx.pass.bindings,
                                   [](const PassBinding& binding) { return binding.access == Access::read_write; });
    }

    Context& cx;
    Numbers numbers_;
    IdSet<Expr> seen_;
    std::unordered_map<FunctionId, bool> has_loop_;  ///< what has_loop found
    bool fits_ = true, stores_ = false;
    std::size_t loads_ = 0, nodes_ = 0, quotients_ = 0;
};

/// Whether the value of a delayed store needs no `let`, since it cannot change until the store is executed.
bool keeps(const Context& cx, ExprId value, bool ends_in_stores) {
    const Expr& node = cx.p.exprs[value];
    if (node.op != Op::local) return is_trivial(cx, value);
    return ends_in_stores || !cx.p.locals[node.local].is_mutable;
}

/// How neighbour reads of one element are those of the next element along y.
struct Sharing {
    std::size_t loads = 0;  ///< of one element
    std::size_t more = 0;   ///< that each further element needs
};

using NearValues = std::vector<Expander::NearValue>;

/// A neighbour at offset (x, y + 1) of one element is the neighbour at (x, y) of the next one.
const Expander::NearValue* in_next_row(const NearValues& near, const Expander::NearValue& one) {
    std::vector<std::int64_t> offset = one.offset;
    ++offset[1];
    const auto is_same = [&](const Expander::NearValue& other) {
        return other.root == one.root && other.offset == offset;
    };
    const auto found = std::ranges::find_if(near, is_same);
    return found == near.end() ? nullptr : &*found;
}

Sharing sharing_of(const Context& cx, const NearValues& near) {
    if (cx.pass.rank < 2) return {near.size(), near.size()};
    const auto is_new = [&](const Expander::NearValue& one) { return in_next_row(near, one) == nullptr; };
    return {near.size(), static_cast<std::size_t>(std::ranges::count_if(near, is_new))};
}

class Coarsening {
public:
    Coarsening(Context& context, std::uint32_t count) : cx(context), count_(count) {}

    /// Loads that elements share are made for the first of them.
    Coarsened run(const std::vector<StmtId>& body, const Expander& made) {
        const auto computes = [&](StmtId id) { return !has_store(cx.p, cx.p.stmts[id]); };
        ends_in_stores_ = std::ranges::is_partitioned(body, computes);
        const Sharing sharing = sharing_of(cx, made.near_values);
        const bool shares = sharing.more < sharing.loads;
        for (std::uint32_t number = 1; number < count_; ++number) copies_.emplace_back(cx, next_address(number));
        std::vector<StmtId> stores;
        for (StmtId id : body) add(id, stores);
        for (std::uint32_t number = 1; number < count_; ++number) {
            if (shares) {
                share_rows(number, made.near_values);
                share_guards(number, made.row_guards);
            }
            std::vector<StmtId> next_stores;
            for (StmtId id : body) add(copies_[number - 1].of(id), next_stores);
            if (shares) next_stores = {where_there_is_one(number, next_stores)};
            stores.insert(stores.end(), next_stores.begin(), next_stores.end());
        }
        result_.insert(result_.end(), stores.begin(), stores.end());
        return {std::move(result_), copies_.front().of(in_range_condition(cx)), elements_};
    }

    Coarsened run_in_turn(const std::vector<StmtId>& body) {
        StatementCopy& second = copies_.emplace_back(cx, next_address(1));
        result_.insert(result_.end(), body.begin(), body.end());
        std::vector<StmtId> again;
        for (StmtId id : body) again.push_back(second.of(id));
        result_.push_back(where_there_is_one(1, again));
        return {std::move(result_), second.of(in_range_condition(cx)), elements_};
    }

private:
    LocalId let(std::string_view name, ExprId value, Span span) {
        const LocalId local = cx.new_local(name, cx.build.type(value), span);
        cx.definitions[local] = value;
        Stmt stmt = statement(StmtOp::let, span);
        stmt.local = local;
        stmt.value = value;
        result_.push_back(cx.add(std::move(stmt)));
        return local;
    }

    /// The address of element `number`: in one dimension a workgroup's width further, so that the lanes of a subgroup
    /// still access consecutive elements; else in the next row. If there is no such element, the address of the first.
    ExprId next_address(std::uint32_t number) {
        const ExprId address = cx.build.local(cx.pass.address);
        if (cx.pass.rank == 1) {
            elements_ = {count_, 1, 1};
            return next_of("next", address, number * cx.pass.group[0], cx.size);
        }
        elements_ = {1, count_, 1};
        Operands parts;
        for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) parts.push_back(cx.build.component(address, axis));
        parts[1] = next_of("next_y", parts[1], number, cx.build.component(cx.size, 1));
        return cx.build.construct(cx.kernel.domain_type, std::move(parts));
    }

    ExprId next_of(std::string_view name, ExprId at, std::uint32_t step, ExprId size) {
        const ExprId next = cx.build.add(at, cx.build.uint(step));
        const ExprId is_inside = cx.build.binary(BinaryOp::less, next, size);
        has_next_.push_back(cx.build.local(let("has_next", is_inside, cx.kernel.span)));
        return cx.build.local(let(name, cx.build.select(has_next_.back(), next, at), cx.kernel.span));
    }

    /// The expression of element `number`.
    ExprId of(std::uint32_t number, ExprId id) { return number == 0 ? id : copies_[number - 1].of(id); }

    /// Neighbours of the element that are neighbours of the one before are loaded once.
    void share_rows(std::uint32_t number, const NearValues& near) {
        for (const Expander::NearValue& one : near)
            if (const auto* found = in_next_row(near, one))
                copies_[number - 1].replace(one.value, of(number - 1, found->value));
    }

    /// Replaces the element's guards of reads at offsets that are positive along y by those of the first element's
    /// reads some rows further. Where the element does not exist, its code has the first one's address, and these
    /// guards test another row than the one that is read. That is harmless, since this code then stores nothing.
    void share_guards(std::uint32_t number, const std::vector<Expander::RowGuard>& guards) {
        for (const Expander::RowGuard& guard : guards) {
            const ExprId distance = cx.build.uint(static_cast<std::uint64_t>(guard.distance + number));
            copies_[number - 1].replace(
                guard.condition, cx.build.binary(BinaryOp::less, cx.build.add(guard.at, distance), guard.extent));
        }
    }

    /// The statements of element `number` under the condition that there is such an element. Where all elements are
    /// computed before the first store (run), the stores need the condition only if loads are shared: otherwise the
    /// element is a copy of the first where there is none, and storing it again changes nothing.
    StmtId where_there_is_one(std::uint32_t number, const std::vector<StmtId>& statements) {
        Stmt stmt = statement(StmtOp::if_, cx.p.stmts[statements.front()].span);
        stmt.value = has_next_[number - 1];
        stmt.body = statements;
        return cx.add(std::move(stmt));
    }

    /// Adds a statement; stores are put into `stores` instead, to come after all elements are computed.
    void add(StmtId id, std::vector<StmtId>& stores) {
        if (!has_store(cx.p, cx.p.stmts[id])) return result_.push_back(id);
        stores.push_back(with_named_value(cx, id, ends_in_stores_, result_));
    }

    Context& cx;
    std::uint32_t count_;               ///< of elements
    std::deque<StatementCopy> copies_;  ///< of the second element, the third, …
    std::vector<StmtId> result_;
    std::vector<ExprId> has_next_;  ///< whether they exist
    std::array<std::uint32_t, 3> elements_{};
    bool ends_in_stores_ = true;  ///< only statements with stores follow the first store in the body
};

/// How many elements an invocation takes, of at most `most`. Four if each needs less than half of the loads of the
/// first one.
std::uint32_t elements_for(const StoredLast& last, const Sharing& sharing, std::uint32_t most) {
    const std::size_t others = last.loads - std::min(last.loads, sharing.loads);
    const std::size_t loads_of_four = last.loads + 3 * (sharing.more + others);
    const std::size_t size = last.nodes + nodes_of_long_quotient * last.quotients;
    const bool is_shared = most >= 4 && sharing.loads >= fewest_shared && 2 * sharing.more < sharing.loads;
    if (is_shared && loads_of_four <= most_shared_loads && 4 * size <= most_of_four) return 4;
    return last.loads <= most_loads && last.nodes <= most_of_one ? 2 : 1;
}

}  // namespace

StoredLast stored_last(Context& cx, const std::vector<StmtId>& body) { return Eligibility(cx).of(body); }

StmtId with_named_value(Context& cx, StmtId id, bool ends_in_stores, std::vector<StmtId>& before) {
    Stmt stmt = cx.p.stmts[id];
    if (!is_store(stmt) || keeps(cx, stmt.value, ends_in_stores)) return id;
    const KernelParam& param = cx.kernel.params[cx.pass.bindings[stmt.slot].place.root];
    Stmt let = statement(StmtOp::let, stmt.span);
    let.local = cx.new_local((*cx.p.names)[param.name], cx.build.type(stmt.value), stmt.span);
    let.value = stmt.value;
    cx.definitions[let.local] = stmt.value;
    stmt.value = cx.build.local(let.local);
    before.push_back(cx.add(std::move(let)));
    return cx.add(std::move(stmt));
}

Coarsened coarsened(Context& cx, const std::vector<StmtId>& body, const Expander& made, std::uint32_t most) {
    const StoredLast last = stored_last(cx, body);
    if (!last.holds) return {};
    const std::uint32_t count = elements_for(last, sharing_of(cx, made.near_values), most);
    return count == 1 ? Coarsened{} : Coarsening(cx, count).run(body, made);
}

Coarsened coarsened_in_turn(Context& cx, const std::vector<StmtId>& body) {
    return Coarsening(cx, 2).run_in_turn(body);
}

bool is_coarsened(const Pass& pass) {
    return variant_for(pass, Devices::shaders).assumes.elements != pass.plain().assumes.elements;
}

}  // namespace gliftc::lower
