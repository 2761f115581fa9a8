// Statements, each on lines of its own, with the source line that it came from.
#include "base/concat.h"
#include "emit/glsl/printer.h"
#include "ir/levels.h"

#include <stdexcept>

namespace gliftc::glsl {

using ir::Expr;
using ir::ExprId;
using ir::Stmt;
using ir::StmtId;
using ir::StmtOp;

namespace {

constexpr std::size_t line_length = 110;

/// The best place to break a line before `limit`: of the spaces after a comma or before + - * / & | && || ? : < or >,
/// the last one at the lowest depth of brackets. Spaces at most 12 characters after `from` do not count. npos if there
/// is no such space.
std::size_t break_point(const std::string& text, std::size_t from, std::size_t limit) {
    std::size_t best = std::string::npos;
    int depth = 0, best_depth = 1000;
    for (std::size_t i = from; i < limit && i < text.size(); ++i) {
        char c = text[i];
        if (c == '(' || c == '[' || c == '{') ++depth;
        if (c == ')' || c == ']' || c == '}') --depth;
        bool after_comma = c == ' ' && i > 0 && text[i - 1] == ',';
        bool before_operator =
            c == ' ' && i + 2 < text.size() &&
            std::string_view("+-*/&|?:<>").find(text[i + 1]) != std::string_view::npos &&
            (text[i + 2] == ' ' || (text[i + 3] == ' ' && (text[i + 2] == '&' || text[i + 2] == '|')));
        if (i > from + 12 && (after_comma || before_operator) && depth <= best_depth) {
            best_depth = depth;
            best = i;
        }
    }
    return best;
}

std::string statement_end(const std::string& text) { return text + ";"; }

/// The assignment as text: `x += y` in place of `x = x + y`, and likewise for the other operators.
std::string assignment(Printer& p, const Stmt& stmt) {
    std::string target = print(p, stmt.target, Level::postfix);
    const Expr& value = p.program.exprs[stmt.value];
    std::string text = print_any(p, stmt.value);
    if (value.op != ir::Op::binary || p.program.exprs[value.operands[0]].type != value.type)
        return target + " = " + text;
    const bool begins_so = text.starts_with(target) && text.size() > target.size() && text[target.size()] == ' ';
    if (!begins_so) return target + " = " + text;
    for (const char* sign : {"+", "-", "*", "/", "%", "<<", ">>", "&", "|", "^"}) {
        const std::string head = concat(target, " ", sign, " ");
        if (!text.starts_with(head)) continue;
        std::string right = print_any(p, value.operands[1]);
        if (text == head + right || text == head + "(" + right + ")") return target + " " + sign + "= " + right;
        return target + " " + sign + "= " + text.substr(head.size());
    }
    return target + " = " + text;
}

/// Whether the value's left operand is the assignment's target, as `x += y` requires.
bool is_left_whole(Printer& p, const Stmt& stmt) {
    const Expr& value = p.program.exprs[stmt.value];
    if (value.op != ir::Op::binary) return false;
    return print_any(p, value.operands[0]) == print(p, stmt.target, Level::postfix);
}

/// Notes the lower bound of a local whose value is max(…, constant), and the upper bound of a uint.
void note_bounds_of_let(Printer& p, const Stmt& stmt) {
    const Expr& value = p.program.exprs[stmt.value];
    if (const std::uint64_t most = largest(p, stmt.value); most < UINT32_MAX)
        p.bounds[stmt.local] = {0, static_cast<std::int64_t>(most) + 1};
    if (value.op != ir::Op::intrinsic || value.intrinsic != ir::Intrinsic::max) return;
    const Expr& low = p.program.exprs[value.operands[1]];
    if (low.op == ir::Op::constant && p.program.types.is_integer(value.type))
        p.bounds[stmt.local] = {static_cast<std::int64_t>(low.bits), INT64_MAX};
}

/// Whether the let declares a constant array.
bool is_table(const Printer& p, const Stmt& stmt) {
    const ir::Local& local = p.program.locals[stmt.local];
    return !local.is_mutable && p.program.types.kind(local.type) == ir::TypeKind::array && stmt.value &&
           is_constant(p, stmt.value);
}

std::string value_of_let(Printer& p, const Stmt& stmt) {
    if (stmt.uninitialized) return "";
    return " = " + (stmt.value ? print_any(p, stmt.value) : zero(p, p.program.locals[stmt.local].type));
}

void print_let(Printer& p, const Stmt& stmt) {
    const ir::Local& local = p.program.locals[stmt.local];
    const std::string value = value_of_let(p, stmt);
    std::string name = p.names.declare((*p.program.names)[local.name]);
    p.local_names[stmt.local] = name;
    if (stmt.value && !local.is_mutable) note_bounds_of_let(p, stmt);
    line(p, (is_table(p, stmt) ? "const " : "") + declaration(p, local.type, name) + value + ";");
}

void print_block(Printer& p, const std::vector<StmtId>& body) {
    p.names.enter();
    ++p.indent;
    print_body(p, body);
    --p.indent;
    p.names.leave();
}

void print_if(Printer& p, const Stmt& stmt, const std::string& before) {
    line(p, before + "if (" + print_any(p, stmt.value) + ") {");
    print_block(p, stmt.body);
    if (stmt.otherwise.empty()) return line(p, "}");
    const Stmt& only = p.program.stmts[stmt.otherwise[0]];
    if (stmt.otherwise.size() == 1 && only.op == StmtOp::if_) return print_if(p, only, "} else ");
    line(p, "} else {");
    print_block(p, stmt.otherwise);
    line(p, "}");
}

/// Whether the expression obviously has the same value in each iteration of a loop.
bool is_steady(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    switch (expr.op) {
    case ir::Op::constant:
    case ir::Op::parameter: return true;
    case ir::Op::local: return !p.program.locals[expr.local].is_mutable;
    case ir::Op::swizzle:
    case ir::Op::field: return is_steady(p, expr.operands[0]);
    default: return false;
    }
}

void note_bounds(Printer& p, const Stmt& stmt) {
    const Expr& low = p.program.exprs[stmt.value];
    const Expr& high = p.program.exprs[stmt.limit];
    if (low.op != ir::Op::constant) return;
    const std::uint64_t most = largest(p, stmt.limit);
    if (high.op != ir::Op::constant && most == UINT32_MAX) return;
    const std::uint64_t limit = high.op == ir::Op::constant ? high.bits : most;
    p.bounds[stmt.local] = {static_cast<std::int64_t>(low.bits), static_cast<std::int64_t>(limit)};
}

void print_for(Printer& p, const Stmt& stmt) {
    const ir::Local& local = p.program.locals[stmt.local];
    const std::string& wanted = (*p.program.names)[local.name];
    p.names.enter();
    std::string low = print_any(p, stmt.value), high = print(p, stmt.limit, Level::shift);
    std::string name = p.names.declare(wanted);
    p.local_names[stmt.local] = name;
    note_bounds(p, stmt);
    std::string type = type_text(p, local.type), first = type + " " + name + " = " + low;
    if (!is_steady(p, stmt.limit)) {
        std::string end = p.names.declare(name + "_end");
        first += ", " + end + " = " + print_any(p, stmt.limit);
        high = end;
    }
    std::string test = round_test(p, stmt);
    if (stmt.unrolled) p.extensions.insert("GL_EXT_control_flow_attributes");
    line(p, std::string(stmt.unrolled ? "[[unroll]] " : "") + "for (" + first + "; " +
                (test.empty() ? "" : test + " && ") + name + " < " + high + "; ++" + name + ") {");
    print_block(p, stmt.body);
    line(p, "}");
    p.names.leave();
}

void print_while(Printer& p, const Stmt& stmt) {
    std::string test = round_test(p, stmt);
    line(p, "while (" +
                (test.empty() ? print_any(p, stmt.value) : test + " && " + print(p, stmt.value, Level::bit_or)) +
                ") {");
    print_block(p, stmt.body);
    line(p, "}");
}

/// Whether several invocations of a workgroup store parts of sums, of which one says that they are there.
bool stores_parts(const ir::Pass& pass) {
    const bool has_rows = variant_for(pass, ir::Devices::shaders).assumes.elements[1] != 1;
    return std::ranges::any_of(pass.sum_orders(),
                               [&](const ir::SumOrder& order) { return order.axis != 0 || has_rows; });
}

/// The kinds of memory that barriers order, as GLSL's storage semantics: workgroup memory; in kernels with a group, or
/// with sums whose parts several invocations store, also buffers, if the kernel both reads and writes one, and images,
/// likewise.
std::string memory_of_barriers(const Printer& p) {
    bool buffers = false, images = false;
    if (!p.program.kernels[p.pass.kernel].grouped() && !stores_parts(p.pass)) return "gl_StorageSemanticsShared";
    for (const ir::PassBinding& binding : p.pass.bindings)
        if (binding.access == ir::Access::read_write)
            (binding.shape == ir::MemoryShape::buffer ? buffers : images) = true;
    return std::string(buffers ? "gl_StorageSemanticsBuffer | " : "") + (images ? "gl_StorageSemanticsImage | " : "") +
           "gl_StorageSemanticsShared";
}

/// One call orders execution and memory: a separate fence beside a barrier makes a pass up to a fifth slower on an
/// H200.
std::string barrier_text(Printer& p) {
    const std::string memory = memory_of_barriers(p);
    if (memory == "gl_StorageSemanticsShared") return "barrier();";
    p.extensions.insert("GL_KHR_memory_scope_semantics");
    return "controlBarrier(gl_ScopeWorkgroup, gl_ScopeWorkgroup, " + memory + ", gl_SemanticsAcquireRelease);";
}

/// Whether the statement only declares, assigns or evaluates a value of an empty type: then it is not printed.
bool is_about_nothing(const Printer& p, const Stmt& stmt) {
    if (stmt.op == StmtOp::let) return is_empty(p.program, p.program.locals[stmt.local].type);
    if (stmt.op == StmtOp::assign) return is_empty(p.program, p.program.exprs[stmt.target].type);
    return stmt.op == StmtOp::evaluate && is_empty(p.program, p.program.exprs[stmt.value].type);
}

}  // namespace

std::string file_name(std::string_view path) {
    std::size_t slash = path.find_last_of('/');
    return std::string(slash == std::string_view::npos ? path : path.substr(slash + 1));
}

void line(Printer& p, std::string text) {
    std::string margin(static_cast<std::size_t>(p.indent) * 4, ' ');
    std::size_t from = 0;
    while (text.size() - from + margin.size() > line_length && text.compare(0, 2, "//") != 0) {
        std::size_t at = break_point(text, from, from + line_length - margin.size());
        if (at == std::string::npos) break;
        p.out.append(margin).append(text, from, at - from) += '\n';
        if (from == 0) margin += "    ";
        from = at + 1;
    }
    p.out.append(margin).append(text, from) += '\n';
}

void mark_line(Printer& p, Span span) {
    if (!span) return;
    std::uint32_t number = p.sources.line_of(span);
    std::string file = file_name(p.sources[span.file].path);
    if (p.options.lines == LineMarks::directives) {
        p.out += "#line " + std::to_string(number) + " \"" + file + "\"\n";
        return;
    }
    if (p.last_line && p.last_line.file == span.file && p.last_line_number == number) return;
    p.last_line = span;
    p.last_line_number = number;
    line(p, "// " + file + ":" + std::to_string(number));
}

void print_value_of_let(Printer& p, const Stmt& stmt) {
    const std::string value = is_about_nothing(p, stmt) || is_table(p, stmt) ? "" : value_of_let(p, stmt);
    if (value.empty()) return;
    mark_line(p, stmt.span);
    line(p, p.local_names.at(stmt.local) + value + ";");
}

void print_body(Printer& p, const std::vector<StmtId>& body) {
    for (StmtId id : body) print_statement(p, id);
}

void print_statement(Printer& p, StmtId id) {
    const Stmt& stmt = p.program.stmts[id];
    if (is_about_nothing(p, stmt)) return;
    if (stmt.op != StmtOp::block) mark_line(p, stmt.span);
    switch (stmt.op) {
    case StmtOp::let: return print_let(p, stmt);
    case StmtOp::assign:
        if (is_left_whole(p, stmt)) return line(p, statement_end(assignment(p, stmt)));
        return line(p, print(p, stmt.target, Level::postfix) + " = " + print_any(p, stmt.value) + ";");
    case StmtOp::if_: return print_if(p, stmt, "");
    case StmtOp::for_: return print_for(p, stmt);
    case StmtOp::while_: return print_while(p, stmt);
    case StmtOp::break_: return line(p, "break;");
    case StmtOp::continue_: return line(p, "continue;");
    case StmtOp::return_: return line(p, stmt.value ? "return " + print_any(p, stmt.value) + ";" : "return;");
    case StmtOp::block:
        line(p, "{");
        print_block(p, stmt.body);
        return line(p, "}");
    case StmtOp::evaluate: return line(p, print_any(p, stmt.value) + ";");
    case StmtOp::barrier: return line(p, barrier_text(p));
    case StmtOp::subgroup_barrier: return line(p, subgroup_barrier(p, memory_of_barriers(p)));
    case StmtOp::store:
    case StmtOp::image_store: return print_store(p, stmt);
    case StmtOp::atomic: return line(p, atomic_text(p, stmt));
    case StmtOp::discard: return line(p, "discard;");
    case StmtOp::print: return print_message(p, stmt);
    case StmtOp::report: return line(p, report_text(p, stmt));
#define STRUCTURE_STATEMENT(name) case StmtOp::name:
#define HOST_STATEMENT(name) case StmtOp::name:
#define CPU_STATEMENT(name) case StmtOp::name:
#include "ir/statements.def"
        break;
    }
    ir::misplaced(stmt.op, "emit/glsl: a lowered pass");
}

}  // namespace gliftc::glsl
