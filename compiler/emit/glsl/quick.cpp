// Bodies with many quotients. Drivers put the code of `divide` (division.cpp) in the place of each call, and most of it
// is for operands that are very large, very small or no numbers: with many quotients the code no longer fits the
// device's instruction cache. So the body is printed twice. The first time quotients are computed by quick_divide, which
// is correct for ordinary operands and notes in quotients_hold if it may not be. The second body, with `divide`, runs
// where that is false, and begins again.
#include "emit/glsl/printer.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::glsl {

using ir::Expr;
using ir::ExprId;
using ir::Op;
using ir::Stmt;
using ir::StmtId;
using ir::StmtOp;

namespace {

/// With fewer quotients one body with `divide` is as fast.
constexpr std::uint32_t fewest_quotients = 4;

bool is_store(const Stmt& stmt) { return stmt.op == StmtOp::store || stmt.op == StmtOp::image_store; }

bool has_store(const Printer& p, StmtId id) {
    bool found = false;
    ir::for_each_statement(p.program, {id}, [&](const Stmt& stmt) { found = found || is_store(stmt); });
    return found;
}

std::uint32_t quotients_of(const Printer& p, const std::vector<StmtId>& body) {
    std::uint32_t count = 0;
    ir::for_each_expression(p.program, body, [&](ExprId id) {
        if (has_quick_form(p, p.program.exprs[id])) count += p.program.types.components(p.program.exprs[id].type);
    });
    return count;
}

/// Whether the statements can be executed twice with the same result: they change nothing but locals and, after all
/// loads of memory that they write, memory; and they end whatever the values of quotients are.
bool may_repeat(const Printer& p, const std::vector<StmtId>& body) {
    bool may = true;
    ir::for_each_statement(p.program, body, [&](const Stmt& stmt) {
        const bool is_plain = is_store(stmt) || stmt.op == StmtOp::let || stmt.op == StmtOp::assign ||
                              stmt.op == StmtOp::if_ || stmt.op == StmtOp::block;
        const bool is_bounded = stmt.op == StmtOp::for_ && is_constant(p, stmt.value) && is_constant(p, stmt.limit);
        may = may && (is_plain || is_bounded);
    });
    ir::for_each_expression(p.program, body, [&](ExprId id) {
        const Expr& node = p.program.exprs[id];
        const bool is_atomic = node.op == Op::intrinsic && ir::signature_of(node.intrinsic)[0] == '@';
        may = may && node.op != Op::call && !is_atomic;
    });
    return may;
}

std::vector<StmtId>::const_iterator first_store(const Printer& p) {
    return std::ranges::find_if(p.body(), [&](StmtId id) { return has_store(p, id); });
}

}  // namespace

bool has_quick_form(const Printer& p, const Expr& expr) {
    const ir::Types& types = p.program.types;
    return expr.op == Op::binary && expr.binary == ir::BinaryOp::divide && corrects_division(p, expr.type) &&
           types.scalar_of(expr.type) == types.float_ && !types.is_matrix(expr.type) &&
           !is_power_of_two(p, expr.operands[1]);
}

bool has_quick_body(const Printer& p) {
    const bool is_kernel = p.pass.kernel && p.raster() == nullptr && !p.program.kernels[p.pass.kernel].grouped();
    if (!is_kernel || quotients_of(p, p.body()) < fewest_quotients || !may_repeat(p, p.body())) return false;
    const std::vector<StmtId> last(first_store(p), p.body().end());
    const auto is_written = [](const ir::PassBinding& binding) { return binding.access == ir::Access::read_write; };
    return quotients_of(p, last) == 0 || std::ranges::none_of(p.pass.bindings, is_written);
}

void print_quick_body(Printer& p) {
    const std::vector<StmtId> first(p.body().begin(), first_store(p)), last(first_store(p), p.body().end());
    need(p, Helper::quick_divide, p.program.types.float_);
    line(p, "quotients_hold = !exact_division;");
    line(p, "if (quotients_hold) {");
    p.names.enter();
    ++p.indent;
    p.divides_quickly = true;
    print_body(p, first);
    line(p, "if (quotients_hold) {");
    ++p.indent;
    print_body(p, last);
    --p.indent;
    line(p, "}");
    p.divides_quickly = false;
    --p.indent;
    p.names.leave();
    line(p, "}");
}

}  // namespace gliftc::glsl
