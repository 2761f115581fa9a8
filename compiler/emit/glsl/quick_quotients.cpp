#include "emit/glsl/quick_quotients.h"

#include "ir/intrinsics.h"
#include "ir/walk.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

namespace gliftc::glsl {

using namespace ir;

namespace {

/// With fewer quotients the code that tests them one by one is short enough.
constexpr std::size_t fewest_quotients = 4, rounds_of_loop = 8;

/// Whether a second evaluation gives the same, and is allowed to come under an if.
bool is_repeatable(const Program& program, ExprId root) {
    bool holds = true;
    for_each_node(program, root, [&](ExprId id) {
        const Expr& node = program.exprs[id];
        const bool has_effect =
            node.op == Op::intrinsic && signature_of(node.intrinsic).find_first_of("@*+") != std::string_view::npos;
        holds = holds && node.op != Op::call && !has_effect;
    });
    return holds;
}

/// Whether the expression does not depend on quotients: it bounds the rounds of a loop, which must end where quotients
/// are wrong.
bool is_known_before(const Program& program, ExprId root) {
    bool holds = true;
    for_each_node(program, root, [&](ExprId id) { holds = holds && program.exprs[id].op != Op::local; });
    return holds;
}

/// Whether the statement can be executed twice. Not a while, which might not end where quotients are wrong.
bool is_repeatable(const Printer& p, StmtId id) {
    const Program& program = p.program;
    const Stmt& stmt = program.stmts[id];
    bool holds = true;
    for_each_root(stmt, [&](ExprId root) { holds = holds && is_repeatable(program, root); });
    const auto are_repeatable = [&](const auto& body) {
        return std::ranges::all_of(body, [&](StmtId inner) { return is_repeatable(p, inner); });
    };
    switch (stmt.op) {
    case StmtOp::let: return holds;
    case StmtOp::assign: {
        for_each_node(program, stmt.target, [&](ExprId node) {
            const Expr& part = program.exprs[node];
            holds = holds && (part.op != Op::local || program.locals[part.local].storage != Storage::shared);
        });
        return holds;
    }
    case StmtOp::if_:
    case StmtOp::block: return holds && are_repeatable(stmt.body) && are_repeatable(stmt.otherwise);
    case StmtOp::for_:
        return holds && is_known_before(program, stmt.value) && is_known_before(program, stmt.limit) &&
               are_repeatable(stmt.body);
    case StmtOp::break_:
    case StmtOp::continue_: return true;
    default: return false;
    }
}

std::size_t quotients_of(const Printer& p, const std::vector<StmtId>& body) {
    std::size_t count = 0;
    for (StmtId id : body) {
        const Stmt& stmt = p.program.stmts[id];
        for_each_root(stmt, [&](ExprId root) {
            for_each_node(p.program, root, [&](ExprId node) {
                const Expr& expr = p.program.exprs[node];
                if (is_quick_quotient(p, expr)) count += p.program.types.components(expr.type);
            });
        });
        const std::vector<StmtId> inner(stmt.body.begin(), stmt.body.end());
        const std::vector<StmtId> otherwise(stmt.otherwise.begin(), stmt.otherwise.end());
        count += (stmt.op == StmtOp::for_ ? rounds_of_loop : 1) * quotients_of(p, inner) + quotients_of(p, otherwise);
    }
    return count;
}

/// Declares the address anew, so that compilers do not know that it is the same: else they keep what they have loaded
/// and computed for the statements that come again, which takes too many registers.
void print_address_again(Printer& p) {
    const Local& local = p.program.locals[p.pass.address];
    const std::string address = p.local_names.at(p.pass.address);
    const std::string name = p.names.declare((*p.program.names)[local.name]);
    const std::string x = "gl_GlobalInvocationID.x";  // x * (x + 1) is even
    line(p, declaration(p, local.type, name) + " = " + address + " + (" + x + " * (" + x + " + 1u) & 1u);");
    p.local_names[p.pass.address] = name;
}

/// Prints the statements once more, where the locals that `after` uses are declared already.
void print_again(Printer& p, const std::vector<StmtId>& body, const std::vector<StmtId>& after) {
    std::unordered_set<LocalId> used;
    for_each_expression(p.program, after, [&](ExprId id) {
        if (p.program.exprs[id].op == Op::local) used.insert(p.program.exprs[id].local);
    });
    const std::string address = p.local_names.at(p.pass.address);
    p.names.enter();
    ++p.indent;
    print_address_again(p);
    for (StmtId id : body) {
        const Stmt& stmt = p.program.stmts[id];
        const bool is_declared = stmt.op == StmtOp::let && used.contains(stmt.local);
        if (!is_declared) print_statement(p, id);
        else print_value_of_let(p, stmt);
    }
    --p.indent;
    p.names.leave();
    p.local_names[p.pass.address] = address;
}

}  // namespace

void print_main_body(Printer& p, const std::vector<StmtId>& body) {
    const auto end = std::ranges::find_if_not(body, [&](StmtId id) { return is_repeatable(p, id); });
    const std::vector<StmtId> first(body.begin(), end), after(end, body.end());
    const bool is_kernel = p.pass.kernel && !p.raster() && !p.program.kernels[p.pass.kernel].grouped();
    if (!is_kernel || p.options.rounding != Rounding::correct || quotients_of(p, first) < fewest_quotients)
        return print_body(p, body);
    p.has_quick_quotients = true;
    print_body(p, first);
    p.has_quick_quotients = false;
    line(p, "if (!has_usual_quotients) {");
    print_again(p, first, after);
    line(p, "}");
    print_body(p, after);
}

}  // namespace gliftc::glsl
