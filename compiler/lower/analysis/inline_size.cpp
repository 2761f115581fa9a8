#include "lower/analysis/inline_size.h"

#include "ir/walk.h"
#include "lower/analysis/unroll.h"

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::size_t inline_limit = 4000;  ///< nodes that inlining one call may make, loops unrolled
constexpr std::uint64_t inline_rounds = 64;

/// Whether an index in an assignment's target is a constant once the function is inlined: it is computed by operators
/// and conversions from constants and from variables of `loops`, which inlining unrolls.
bool is_known_index(const Program& p, ExprId id, const std::vector<LocalId>& loops) {
    bool known = true;
    for_each_node(p, id, [&](ExprId part) {
        const Expr& node = p.exprs[part];
        if (node.op == Op::local) {
            bool is_loop = false;
            for (LocalId loop : loops) is_loop = is_loop || loop == node.local;
            known = known && is_loop;
        } else if (node.op != Op::constant && node.op != Op::binary && node.op != Op::convert && node.op != Op::unary) {
            known = false;
        }
    });
    return known;
}

bool has_known_target(const Program& p, ExprId target, const std::vector<LocalId>& loops) {
    const Expr& node = p.exprs[target];
    if (node.op == Op::local) return true;
    if (node.op == Op::index && !is_known_index(p, node.operands[1], loops)) return false;
    return has_known_target(p, node.operands[0], loops);
}

}  // namespace

std::optional<std::size_t> InlineSizes::of(FunctionId id) {
    if (auto found = sizes_.find(id); found != sizes_.end()) return found->second;
    const Function& function = p.functions[id];
    std::vector<LocalId> loops;
    const std::optional<std::size_t> size = function.extern_name.empty() ? of(function.body, loops) : std::nullopt;
    return sizes_[id] = size;
}

std::size_t InlineSizes::of_value(ExprId root) {
    std::size_t size = 0;
    for_each_node(p, root, [&](ExprId id) {
        ++size;
        const Expr& node = p.exprs[id];
        if (node.op == Op::call && !p.functions[node.function].is_statements()) size += of(node.function).value_or(0);
    });
    return size;
}

/// The size of an `if`. `rest`: if a side contains a return, the statements after the `if`, which inlining appends to
/// both sides; else empty.
std::optional<std::size_t> InlineSizes::of_both(const Stmt& stmt, const Statements& rest, Loops& loops) {
    Statements yes(stmt.body.begin(), stmt.body.end()), no(stmt.otherwise.begin(), stmt.otherwise.end());
    for (Statements* side : {&yes, &no}) side->insert(side->end(), rest.begin(), rest.end());
    const std::optional<std::size_t> one = of(yes, loops);
    if (!one) return std::nullopt;
    const std::optional<std::size_t> other = of(no, loops);
    if (!other) return std::nullopt;
    return *one + *other;
}

std::optional<std::size_t> InlineSizes::of_loop(const Stmt& stmt, Loops& loops) {
    auto rounds = rounds_of(p, stmt.value, stmt.limit);
    if (!rounds || rounds->count > inline_rounds || leaves_loop(p, stmt.body) || returns(p, stmt.body))
        return std::nullopt;
    loops.push_back(stmt.local);
    auto inner = of(stmt.body, loops);
    loops.pop_back();
    if (!inner) return std::nullopt;
    return *inner * static_cast<std::size_t>(rounds->count);
}

std::optional<std::size_t> InlineSizes::of(const Statements& body, Loops& loops) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Stmt& stmt = p.stmts[body[i]];
        for_each_root(stmt, [&](ExprId root) { size += of_value(root); });
        std::optional<std::size_t> inner = 0;
        bool has_rest = false;
        switch (stmt.op) {
        case StmtOp::let: break;
        case StmtOp::return_: return size > inline_limit ? std::nullopt : std::optional(size);
        case StmtOp::assign:
            if (!has_known_target(p, stmt.target, loops)) return std::nullopt;
            break;
        case StmtOp::if_:
            has_rest = returns(p, stmt.body) || returns(p, stmt.otherwise);
            inner = of_both(stmt,
                            has_rest ? Statements(body.begin() + static_cast<std::ptrdiff_t>(i) + 1, body.end())
                                     : Statements(),
                            loops);
            break;
        case StmtOp::block: inner = of(stmt.body, loops); break;
        case StmtOp::for_: inner = of_loop(stmt, loops); break;
        default: return std::nullopt;
        }
        if (!inner) return std::nullopt;
        size += *inner;
        if (size > inline_limit) return std::nullopt;
        if (has_rest) return size;
    }
    return size;
}

}  // namespace gliftc::lower
