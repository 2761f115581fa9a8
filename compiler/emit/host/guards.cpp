#include "emit/host/guards.h"

#include "base/concat.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>
#include <unordered_map>

namespace gliftc::host {

namespace {

using ir::BinaryOp;
using ir::Expr;
using ir::ExprId;
using ir::LocalId;
using ir::Op;
using ir::Stmt;
using ir::StmtId;
using ir::StmtOp;

constexpr std::uint64_t most_uint = UINT32_MAX;

/// What a uint is in all rounds: `terms`, which are the same in each, and a number of the loops'.
struct Reach {
    std::vector<ExprId> terms;
    std::uint64_t least = 0, most = 0;  ///< of the number
    std::uint64_t step = 0;             ///< the numbers lie multiples of it apart; 0: there is one

    bool is_number() const { return terms.empty() && step == 0; }
};

/// That elements base + [begin, end) lie before an extent.
struct Fit {
    std::string base;  ///< empty: zero
    std::string extent;
    std::uint64_t begin = 0, end = 0;
};

/// What stands for conditions.
struct Tests {
    std::vector<Fit> fits;  ///< of one base and extent: one
    std::vector<std::string> others;
    bool in_rounds = false;  ///< some of them stands for many rounds

    void add(const Fit& fit);
    void add(const Tests& more);
    std::vector<std::string> texts() const;
};

class Finder {
public:
    Finder(cpp::Printer& printer, const ir::Pass& lowered) : p(printer), program(printer.program), pass(lowered) {}

    void walk(const std::vector<StmtId>& statements);
    Tests tests;
    std::set<ExprId> conditions;

private:
    void declare(const Stmt& stmt);
    void visit(ExprId id);
    bool stands_for(ExprId condition, Tests& wanted);
    bool stands_for_less(ExprId at, ExprId extent, std::uint64_t count, Tests& wanted);
    bool stands_for_multiple(ExprId remainder, ExprId of, Tests& wanted);
    std::optional<Reach> reach_of(ExprId id) const;
    std::optional<Reach> reach_of_binary(const Expr& node) const;
    std::optional<std::uint64_t> number(ExprId id) const;
    std::string text_of(const std::vector<ExprId>& terms);

    cpp::Printer& p;
    const ir::Program& program;
    const ir::Pass& pass;
    std::unordered_map<LocalId, Reach> locals_;
    std::set<LocalId> truths_;  ///< names of conditions that were found
};

std::string plus(const std::string& base, std::uint64_t number) {
    if (base.empty()) return std::to_string(number) + "u";
    return number == 0 ? base : concat(base, " + ", std::to_string(number), "u");
}

void Tests::add(const Fit& fit) {
    for (Fit& known : fits) {
        if (known.base != fit.base || known.extent != fit.extent) continue;
        known.begin = std::min(known.begin, fit.begin);
        known.end = std::max(known.end, fit.end);
        return;
    }
    fits.push_back(fit);
}

void Tests::add(const Tests& more) {
    for (const Fit& fit : more.fits) add(fit);
    for (const std::string& other : more.others)
        if (std::ranges::find(others, other) == others.end()) others.push_back(other);
}

std::vector<std::string> Tests::texts() const {
    std::vector<std::string> result;
    for (const Fit& fit : fits)
        result.push_back(concat("glift::host::fits(", plus(fit.base, fit.begin), ", ",
                                std::to_string(fit.end - fit.begin), "u, ", fit.extent, ")"));
    result.insert(result.end(), others.begin(), others.end());
    return result;
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
    if (node.op == Op::parameter || (node.op == Op::local && node.local == pass.address)) return Reach{{id}, 0, 0, 0};
    if (node.op == Op::binary) return reach_of_binary(node);
    if (node.op != Op::local) return std::nullopt;
    const auto local = locals_.find(node.local);
    return local == locals_.end() ? std::nullopt : std::optional(local->second);
}

std::string Finder::text_of(const std::vector<ExprId>& terms) {
    std::string text;
    for (ExprId term : terms) text += (text.empty() ? "" : " + ") + cpp::print(p, term, cpp::Level::sum);
    return text;
}

/// at + count <= extent, without wrapping.
bool Finder::stands_for_less(ExprId at, ExprId extent, std::uint64_t count, Tests& wanted) {
    const std::optional<Reach> reach = reach_of(at);
    if (!reach || program.exprs[extent].op != Op::parameter || reach->most + count > most_uint) return false;
    wanted.add(Fit{text_of(reach->terms), cpp::print_any(p, extent), reach->least, reach->most + count});
    wanted.in_rounds = wanted.in_rounds || reach->step != 0;
    return true;
}

/// at % of == rest: the same in all rounds where these lie multiples apart, even if sums wrap.
bool Finder::stands_for_multiple(ExprId remainder, ExprId of, Tests& wanted) {
    const Expr& node = program.exprs[remainder];
    if (node.op != Op::binary || node.binary != BinaryOp::remainder) return false;
    const std::optional<Reach> at = reach_of(node.operands[0]);
    const std::optional<std::uint64_t> width = number(node.operands[1]), rest = number(of);
    if (!at || !width || !rest || !std::has_single_bit(*width) || at->step % *width != 0) return false;
    wanted.others.push_back(concat("(", plus(text_of(at->terms), at->least), ") % ", std::to_string(*width),
                                   "u == ", std::to_string(*rest), "u"));
    return true;
}

bool Finder::stands_for(ExprId condition, Tests& wanted) {
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
    tests.add(wanted);
}

/// Takes note of what a let or a loop declares.
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

/// Which lets are read where conditions hold.
class Reads {
public:
    Reads(const ir::Program& whole, const std::set<ExprId>& true_ones) : program(whole), conditions(true_ones) {}

    /// From the last to the first: what reads a let stands behind it.
    void walk(const std::vector<StmtId>& statements);
    std::set<LocalId> unread;

private:
    void visit(ExprId id);
    bool is_plain(ExprId id) const;

    const ir::Program& program;
    const std::set<ExprId>& conditions;
    std::set<LocalId> read_;
};

/// Whether nobody misses the value where nobody reads it: arithmetic and loads alone.
bool Reads::is_plain(ExprId id) const {
    const Expr& node = program.exprs[id];
    const bool is_plain_node = node.op != Op::call && node.op != Op::intrinsic;
    return is_plain_node && std::ranges::all_of(node.operands, [&](ExprId operand) { return is_plain(operand); });
}

void Reads::visit(ExprId id) {
    if (!id || conditions.contains(id)) return;
    const Expr& node = program.exprs[id];
    if (node.op == Op::local) read_.insert(node.local);
    const bool is_chosen = node.op == Op::select && conditions.contains(node.operands[0]);
    if (is_chosen) return visit(node.operands[1]);
    for (ExprId operand : node.operands) visit(operand);
}

void Reads::walk(const std::vector<StmtId>& statements) {
    for (std::size_t i = statements.size(); i-- > 0;) {
        const Stmt& stmt = program.stmts[statements[i]];
        if (stmt.op == StmtOp::let && stmt.value && !read_.contains(stmt.local) && is_plain(stmt.value)) {
            unread.insert(stmt.local);
            continue;
        }
        if (!stmt.value || !conditions.contains(stmt.value)) walk(stmt.otherwise);
        walk(stmt.body);
        for (ExprId expr : {stmt.value, stmt.target, stmt.limit}) visit(expr);
        for (ExprId argument : stmt.arguments) visit(argument);
    }
}

}  // namespace

Guards find_guards(cpp::Printer& p, const ir::Pass& pass, const std::vector<StmtId>& statements) {
    Finder finder(p, pass);
    finder.walk(statements);
    Reads reads(p.program, finder.conditions);
    if (!finder.conditions.empty()) reads.walk(statements);
    return {finder.tests.texts(), std::move(finder.conditions), std::move(reads.unread)};
}

}  // namespace gliftc::host
