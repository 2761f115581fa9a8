#include "lower/host/version_loops.h"

#include "lower/build/rewrite.h"
#include "lower/transform/dead.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint64_t most_uint = UINT32_MAX;

/// The terms of a sum: parameters, and the invocation's address.
using Terms = std::vector<ExprId>;

/// The values that a uint takes over all iterations: the sum of `terms` plus a number between `least` and `most`.
struct Reach {
    Terms terms;
    std::uint64_t least = 0, most = 0;
    std::uint64_t step = 0;  ///< the numbers differ by multiples of it; 0: there is only one

    bool is_number() const { return terms.empty() && step == 0; }
};

/// The test that base + end <= extent, which implies that the indices base + begin to base + end - 1 are below extent.
struct Fit {
    Terms base;
    ExprId extent;
    std::uint64_t begin = 0, end = 0;
};

/// The test that (base + number) % width == rest.
struct Multiple {
    Terms base;
    std::uint64_t number = 0, width = 1, rest = 0;
};

/// The tests before the loops, which imply the guards inside.
struct Tests {
    std::vector<Fit> fits;  ///< at most one for a base and extent: their ranges are united
    std::vector<Multiple> multiples;
    bool in_rounds = false;  ///< some test implies a guard for many iterations, so that versioning pays
};

class Finder {
public:
    explicit Finder(Context& context) : cx(context), program(context.p) {}

    void walk(const std::vector<StmtId>& statements);
    ExprId condition() const;
    std::unordered_set<ExprId> conditions;  ///< the guards that condition() implies

private:
    void declare(const Stmt& stmt);
    void visit(ExprId id);
    bool stands_for(ExprId condition, Tests& wanted) const;
    bool stands_for_less(ExprId at, ExprId extent, std::uint64_t count, Tests& wanted) const;
    bool stands_for_multiple(ExprId remainder, ExprId of, Tests& wanted) const;
    std::optional<Reach> reach_of(ExprId id) const;
    std::optional<Reach> reach_of_binary(const Expr& node) const;
    std::optional<std::uint64_t> number(ExprId id) const;
    bool is_same(ExprId a, ExprId b) const;
    bool is_same(const Terms& a, const Terms& b) const;
    void add(Tests& to, const Fit& fit) const;
    void add(Tests& to, const Multiple& multiple) const;
    ExprId sum_of(const Terms& terms, std::uint64_t number) const;

    Context& cx;
    const Program& program;
    Tests tests_;
    std::unordered_map<LocalId, Reach> locals_;  ///< the values that locals take
    std::unordered_set<LocalId> truths_;         ///< locals whose value is one of `conditions`
};

/// Whether two parameters or locals are the same.
bool Finder::is_same(ExprId a, ExprId b) const {
    const Expr &one = program.exprs[a], &other = program.exprs[b];
    return one.op == other.op && one.slot == other.slot && one.local == other.local;
}

bool Finder::is_same(const Terms& a, const Terms& b) const {
    return std::ranges::equal(a, b, [&](ExprId one, ExprId other) { return is_same(one, other); });
}

void Finder::add(Tests& to, const Fit& fit) const {
    for (Fit& known : to.fits) {
        if (!is_same(known.base, fit.base) || !is_same(known.extent, fit.extent)) continue;
        known.begin = std::min(known.begin, fit.begin);
        known.end = std::max(known.end, fit.end);
        return;
    }
    to.fits.push_back(fit);
}

void Finder::add(Tests& to, const Multiple& multiple) const {
    const auto is_known = [&](const Multiple& known) {
        return is_same(known.base, multiple.base) && known.number == multiple.number && known.width == multiple.width &&
               known.rest == multiple.rest;
    };
    if (std::ranges::none_of(to.multiples, is_known)) to.multiples.push_back(multiple);
}

ExprId Finder::sum_of(const Terms& terms, std::uint64_t number) const {
    ExprId sum;
    for (ExprId term : terms) sum = sum ? cx.build.add(sum, term) : term;
    if (!sum) return cx.build.uint(number);
    return number == 0 ? sum : cx.build.add(sum, cx.build.uint(number));
}

/// The conjunction of all tests; absent: there are none. Its sums wrap around only if a sum in a guard does. Its
/// differences never do, since extent >= count is tested before extent - count is computed.
ExprId Finder::condition() const {
    Builder& build = cx.build;
    ExprId all;
    for (const Fit& fit : tests_.fits) {
        const ExprId count = build.uint(fit.end - fit.begin), begin = sum_of(fit.base, fit.begin);
        all = build.both(all, build.binary(BinaryOp::greater_equal, fit.extent, count));
        all = build.both(
            all, build.binary(BinaryOp::less_equal, begin, build.binary(BinaryOp::subtract, fit.extent, count)));
    }
    for (const Multiple& of : tests_.multiples) {
        const ExprId rest = build.binary(BinaryOp::remainder, sum_of(of.base, of.number), build.uint(of.width));
        all = build.both(all, build.binary(BinaryOp::equal, rest, build.uint(of.rest)));
    }
    return all;
}

std::optional<Reach> sum(const Reach& a, const Reach& b) {
    Reach result = a;
    result.terms.insert(result.terms.end(), b.terms.begin(), b.terms.end());
    result.least += b.least;
    result.most += b.most;
    result.step = std::gcd(a.step, b.step);
    if (result.most > most_uint) return std::nullopt;
    return result;
}

std::optional<Reach> product(const Reach& a, std::uint64_t factor) {
    if (factor == 1) return a;
    if (!a.terms.empty() || a.most * factor > most_uint) return std::nullopt;
    return Reach{{}, a.least * factor, a.most * factor, a.step * factor};
}

std::optional<std::uint64_t> Finder::number(ExprId id) const {
    const std::optional<Reach> reach = reach_of(id);
    return reach && reach->is_number() ? std::optional(reach->least) : std::nullopt;
}

std::optional<Reach> Finder::reach_of_binary(const Expr& node) const {
    const std::optional<Reach> a = reach_of(node.operands[0]), b = reach_of(node.operands[1]);
    if (!a || !b) return std::nullopt;
    if (node.binary == BinaryOp::add) return sum(*a, *b);
    if (node.binary == BinaryOp::multiply && b->is_number()) return product(*a, b->least);
    if (node.binary == BinaryOp::multiply && a->is_number()) return product(*b, a->least);
    return std::nullopt;
}

std::optional<Reach> Finder::reach_of(ExprId id) const {
    const Expr& node = program.exprs[id];
    if (node.type != program.types.uint) return std::nullopt;
    if (node.op == Op::constant) return Reach{{}, node.bits, node.bits, 0};
    if (node.op == Op::parameter || (node.op == Op::local && node.local == cx.pass.address))
        return Reach{{id}, 0, 0, 0};
    if (node.op == Op::binary) return reach_of_binary(node);
    if (node.op != Op::local) return std::nullopt;
    const auto local = locals_.find(node.local);
    return local == locals_.end() ? std::nullopt : std::optional(local->second);
}

/// Adds the test that implies at + count <= extent, without wrapping, in all iterations; false if there is none.
bool Finder::stands_for_less(ExprId at, ExprId extent, std::uint64_t count, Tests& wanted) const {
    const std::optional<Reach> reach = reach_of(at);
    if (!reach || program.exprs[extent].op != Op::parameter || reach->most + count > most_uint) return false;
    add(wanted, Fit{reach->terms, extent, reach->least, reach->most + count});
    wanted.in_rounds = wanted.in_rounds || reach->step != 0;
    return true;
}

/// Adds the test that implies `remainder` == `of` in all iterations, where `remainder` is at % width; false if there is
/// no such test. The remainder is the same in all iterations if `at` changes by multiples of width, a power of two,
/// even if sums wrap around.
bool Finder::stands_for_multiple(ExprId remainder, ExprId of, Tests& wanted) const {
    const Expr& node = program.exprs[remainder];
    if (node.op != Op::binary || node.binary != BinaryOp::remainder) return false;
    const std::optional<Reach> at = reach_of(node.operands[0]);
    const std::optional<std::uint64_t> width = number(node.operands[1]), rest = number(of);
    if (!at || !width || !rest || !std::has_single_bit(*width) || at->step % *width != 0) return false;
    add(wanted, Multiple{at->terms, at->least, *width, *rest});
    return true;
}

bool Finder::stands_for(ExprId condition, Tests& wanted) const {
    const Expr& node = program.exprs[condition];
    if (node.op != Op::binary) return false;
    const ExprId left = node.operands[0], right = node.operands[1];
    if (node.binary == BinaryOp::logical_and) return stands_for(left, wanted) && stands_for(right, wanted);
    if (node.binary == BinaryOp::less) return stands_for_less(left, right, 1, wanted);
    if (node.binary == BinaryOp::equal) return stands_for_multiple(left, right, wanted);
    const Expr& rest = program.exprs[left];
    const bool is_rest = rest.op == Op::binary && rest.binary == BinaryOp::subtract;
    if (node.binary != BinaryOp::greater_equal || !is_rest) return false;
    const std::optional<std::uint64_t> count = number(right);
    return count && stands_for_less(rest.operands[1], rest.operands[0], *count, wanted);
}

void Finder::visit(ExprId id) {
    if (!id) return;
    const Expr& node = program.exprs[id];
    if (node.op == Op::local && truths_.contains(node.local)) conditions.insert(id);
    if (node.op != Op::binary || node.type != program.types.bool_) {
        for (ExprId operand : node.operands) visit(operand);
        return;
    }
    Tests wanted;
    if (!stands_for(id, wanted) || !wanted.in_rounds) return;
    conditions.insert(id);
    for (const Fit& fit : wanted.fits) add(tests_, fit);
    for (const Multiple& multiple : wanted.multiples) add(tests_, multiple);
}

/// Notes the values that the local of a `let` or a loop takes.
void Finder::declare(const Stmt& stmt) {
    if (stmt.op == StmtOp::let && stmt.value && !program.locals[stmt.local].is_mutable) {
        if (std::optional<Reach> reach = reach_of(stmt.value)) locals_[stmt.local] = std::move(*reach);
    } else if (stmt.op == StmtOp::for_) {
        const std::optional<std::uint64_t> first = number(stmt.value), limit = number(stmt.limit);
        if (first && limit && *first < *limit)
            locals_[stmt.local] = {{}, *first, *limit - 1, *limit - *first > 1 ? 1u : 0u};
    }
}

void Finder::walk(const std::vector<StmtId>& statements) {
    for (StmtId id : statements) {
        const Stmt& stmt = program.stmts[id];
        declare(stmt);
        visit(stmt.value);
        if (stmt.op == StmtOp::let && conditions.contains(stmt.value) && !program.locals[stmt.local].is_mutable)
            truths_.insert(stmt.local);
        visit(stmt.target);
        walk(stmt.body);
        if (!conditions.contains(stmt.value)) walk(stmt.otherwise);
    }
}

/// Makes the version of the statements in which the guards are known to be true.
class Rewriting {
public:
    Rewriting(Context& context, const std::unordered_set<ExprId>& true_ones) : cx(context), conditions_(true_ones) {}

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        result.reserve(body.size());
        for (StmtId id : body) {
            const Stmt& stmt = cx.p.stmts[id];
            Builder::Parts parts = visited_parts(stmt, [&](ExprId part) { return visit(part); });
            parts.body = run(stmt.body);
            parts.otherwise = run(stmt.otherwise);
            result.push_back(cx.build.again(id, std::move(parts)));
        }
        return result;
    }

private:
    ExprId visit(ExprId id) {
        if (conditions_.contains(id)) return cx.build.truth(true);
        const Expr& node = cx.p.exprs[id];
        Operands operands;
        for (ExprId operand : node.operands) operands.push_back(visit(operand));
        return operands == node.operands ? id : cx.build.again(node, std::move(operands));
    }

    Context& cx;
    const std::unordered_set<ExprId>& conditions_;
};

}  // namespace

std::vector<StmtId> version_loops(Context& cx, const std::vector<StmtId>& body) {
    Finder finder(cx);
    finder.walk(body);
    Stmt versions = statement(StmtOp::if_, {});
    versions.value = finder.condition();
    if (!versions.value) return body;
    versions.body = drop_dead(cx, Rewriting(cx, finder.conditions).run(body));
    versions.otherwise = body;
    return {cx.add(std::move(versions))};
}

}  // namespace gliftc::lower
