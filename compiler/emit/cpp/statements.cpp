// Statements and whole functions as C++.
#include "base/concat.h"
#include "emit/cpp/mentions.h"
#include "emit/cpp/printer.h"
#include "ir/effects.h"

#include <algorithm>
#include <sstream>

namespace gliftc::cpp {

namespace {

using ir::BinaryOp;
using ir::Expr;
using ir::ExprId;
using ir::Op;
using ir::Stmt;
using ir::StmtOp;

/// "+=" and the like where `a = a op b` may be written so; else empty.
std::string_view compound_of(BinaryOp op) {
    switch (op) {
    case BinaryOp::multiply: return " *= ";
    case BinaryOp::add: return " += ";
    case BinaryOp::subtract: return " -= ";
    case BinaryOp::bit_and: return " &= ";
    case BinaryOp::bit_xor: return " ^= ";
    case BinaryOp::bit_or: return " |= ";
    case BinaryOp::divide:
    case BinaryOp::remainder:
    case BinaryOp::shift_left:
    case BinaryOp::shift_right:
    case BinaryOp::less:
    case BinaryOp::less_equal:
    case BinaryOp::greater:
    case BinaryOp::greater_equal:
    case BinaryOp::equal:
    case BinaryOp::not_equal:
    case BinaryOp::logical_and:
    case BinaryOp::logical_or: return "";
    }
    return "";
}

/// The target of an assignment, as an lvalue: print() would convert vectors of bools from the type that memory has to
/// that of values.
std::string print_target(Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    if (expr.op != Op::field && expr.op != Op::index && expr.op != Op::swizzle) return print_any(p, id);
    const ir::TypeId whole = p.program.exprs[expr.operands[0]].type;
    const std::string base = print_target(p, expr.operands[0]);
    if (expr.op == Op::field) {
        return base + "." + p.globals.field_names[p.program.types[whole].struct_][expr.slot];
    }
    if (!p.program.types.is_vector(whole) && expr.op == Op::swizzle) return print_any(p, id);
    if (expr.op == Op::swizzle) return base + "." + "xyzw"[expr.lanes[0]];
    const Expr& index = p.program.exprs[expr.operands[1]];
    if (index.op == Op::constant && p.program.types.is_vector(whole) && index.bits < 4)
        return base + "." + "xyzw"[index.bits];
    return base + "[" + print_any(p, expr.operands[1]) + "]";
}

void print_assign(Printer& p, const Stmt& stmt) {
    const Expr& target = p.program.exprs[stmt.target];
    const std::uint32_t lanes = target.op == Op::swizzle ? p.program.types.components(target.type) : 1;
    if (lanes > 1) {
        std::string list;
        for (std::uint32_t i = 0; i < lanes; ++i) list += (i ? ", " : "") + std::to_string(target.lanes[i]);
        p.out.line("glift::assign_swizzle<" + list + ">(" + print_target(p, target.operands[0]) + ", " +
                   print_any(p, stmt.value) + ");");
        return;
    }
    const std::string left = print_target(p, stmt.target);
    const Expr& value = p.program.exprs[stmt.value];
    if (value.op == Op::binary && !compound_of(value.binary).empty() && print_any(p, value.operands[0]) == left) {
        p.out.line(concat(left, compound_of(value.binary), print_any(p, value.operands[1]), ";"));
        return;
    }
    p.out.line(concat(left, " = ", print_any(p, stmt.value), ";"));
}

/// Whether the local is an element of an array (Printer::outer_local): the array has an element for each invocation of
/// a workgroup, or for each pixel of a block.
bool is_outer(const Printer& p, ir::LocalId local) { return p.outer_local && !p.outer_local(local).empty(); }

/// `mark` stands before the declaration.
void print_let(Printer& p, const Stmt& stmt, const char* mark) {
    const ir::Local& local = p.program.locals[stmt.local];
    const bool outer = is_outer(p, stmt.local);
    // In C++ the name is in scope in its own initialiser, where it hides others. So it is entered into p.names before
    // the initialiser is printed.
    const std::string name = outer ? "" : declare_local(p, stmt.local);
    const std::string value = stmt.value ? print_any(p, stmt.value) : "";
    if (outer) {
        if (stmt.uninitialized) return;
        const ir::TypeKind kind = p.program.types.kind(local.type);
        const bool has_parts = kind == ir::TypeKind::array || kind == ir::TypeKind::struct_;
        if (!stmt.value && has_parts) p.out.line("glift::reset(" + p.outer_local(stmt.local) + ");");
        else p.out.line(p.outer_local(stmt.local) + " = " + (stmt.value ? value : "{}") + ";");
        return;
    }
    p.out.line(concat(mark, local.is_mutable ? "" : "const ", type_text(p.globals, local.type), " ", name,
                      stmt.value           ? " = "
                      : stmt.uninitialized ? ""
                                           : "{}",
                      value, ";"));
}

bool is_constant(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    return expr.op == Op::constant ||
           (expr.op == Op::construct &&
            std::ranges::all_of(expr.operands, [&](ExprId operand) { return is_constant(p, operand); }));
}

/// Whether a `let` is a constant that no later statement mentions: it was used at compile time only (in a type, a
/// generic argument, another constant), in the branch that a constant condition excludes, or not at all.
bool is_used_up(const Printer& p, const std::vector<ir::StmtId>& body, std::size_t at) {
    const Stmt& stmt = p.program.stmts[body[at]];
    if (stmt.op != StmtOp::let || !stmt.value || p.program.locals[stmt.local].is_mutable || is_outer(p, stmt.local))
        return false;
    return is_constant(p, stmt.value) && !mentions(p.program, {body.begin() + at + 1, body.end()}, stmt.local);
}

bool is_array(const Printer& p, ir::TypeId type) { return p.program.types.kind(type) == ir::TypeKind::array; }

/// Whether an immutable `let` copies an array variable that is not mentioned afterwards: then it is printed as a
/// reference, not as a copy.
bool is_name(const Printer& p, const std::vector<ir::StmtId>& body, std::size_t at) {
    const Stmt& stmt = p.program.stmts[body[at]];
    if (stmt.op != StmtOp::let || !stmt.value || p.program.locals[stmt.local].is_mutable) return false;
    const Expr& value = p.program.exprs[stmt.value];
    if (value.op != Op::local || !is_array(p, value.type) || is_outer(p, stmt.local)) return false;
    return !mentions(p.program, {body.begin() + at + 1, body.end()}, value.local);
}

void print_name(Printer& p, const Stmt& let) {
    mark_line(p, let.span);
    const std::string name = declare_local(p, let.local);
    const std::string value = print_any(p, let.value);
    const ir::TypeId type = p.program.locals[let.local].type;
    p.out.line(concat("const ", type_text(p.globals, type), "& ", name, " = ", value, ";"));
}

void print_nested(Printer& p, const std::vector<ir::StmtId>& body) {
    p.names.enter();
    print_statements(p, body);
    p.names.leave();
}

void print_if(Printer& p, const Stmt& stmt) {
    p.out.open("if (" + print_any(p, stmt.value) + ")");
    print_nested(p, stmt.body);
    const Stmt* rest = &stmt;
    while (!rest->otherwise.empty()) {
        const Stmt& next = p.program.stmts[rest->otherwise[0]];
        if (rest->otherwise.size() == 1 && next.op == StmtOp::if_) {
            p.out.dedent();
            p.out.open("} else if (" + print_any(p, next.value) + ")");
            print_nested(p, next.body);
            rest = &next;
            continue;
        }
        p.out.dedent();
        p.out.open("} else");
        print_nested(p, rest->otherwise);
        break;
    }
    p.out.close();
}

/// Whether a loop's limit can be evaluated before each iteration, since it cannot change.
bool is_steady(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    return expr.op == Op::constant || expr.op == Op::parameter ||
           (expr.op == Op::local && !p.program.locals[expr.local].is_mutable);
}

void print_for(Printer& p, const Stmt& stmt) {
    p.names.enter();
    const std::string type = type_text(p.globals, p.program.locals[stmt.local].type);
    const std::string name = declare_local(p, stmt.local);
    const std::string first = print_any(p, stmt.value), limit = print(p, stmt.limit, Level::shift);
    if (is_steady(p, stmt.limit)) {
        p.out.open("for (" + type + " " + name + " = " + first + "; " + name + " < " + limit + "; ++" + name + ")");
    } else {
        const std::string end = p.names.declare(name + "_end");
        p.out.open("for (" + type + " " + name + " = " + first + ", " + end + " = " + print_any(p, stmt.limit) + "; " +
                   name + " < " + end + "; ++" + name + ")");
    }
    print_nested(p, stmt.body);
    p.out.close();
    p.names.leave();
}

void print_return(Printer& p, const Stmt& stmt) {
    if (p.print_return) p.print_return(stmt.value);
    else if (stmt.value) p.out.line("return " + print_any(p, stmt.value) + ";");
    else p.out.line("return;");
}

}  // namespace

std::string declare_local(Printer& p, ir::LocalId local) {
    std::string name = p.names.declare((*p.program.names)[p.program.locals[local].name]);
    p.local_names[local] = name;
    return name;
}

std::string file_name(const Sources& sources, std::uint32_t file) {
    const std::string& path = sources[file].path;
    const std::size_t slash = path.rfind('/');
    return in_line(path.substr(slash == std::string::npos ? 0 : slash + 1));
}

std::string place_text(const Sources& sources, Span span) {
    return span ? concat(file_name(sources, span.file), ":", std::to_string(sources.line_of(span))) : "";
}

std::string source_text(const Sources& sources, Span span) {
    std::istringstream words(std::string(sources[span.file].text.substr(span.begin, span.end - span.begin)));
    std::string text;
    for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
    return text;
}

void mark_line(Printer& p, Span span) {
    if (!span) return;
    const std::uint32_t line = p.globals.sources.line_of(span);
    if (span.file == p.marked_file && line == p.marked_line) return;
    p.marked_file = span.file;
    p.marked_line = line;
    p.out.line(concat("// ", file_name(p.globals.sources, span.file), ":", std::to_string(line)));
}

void print_statements(Printer& p, const std::vector<ir::StmtId>& body) {
    for (std::size_t i = 0; i < body.size(); ++i) {
        if (is_used_up(p, body, i)) continue;
        const Stmt& stmt = p.program.stmts[body[i]];
        if (is_name(p, body, i)) {
            print_name(p, stmt);
        } else if (stmt.op == StmtOp::let && p.marks_unused) {
            mark_line(p, stmt.span);
            print_let(p, stmt, unused_mark(p.program, {body.begin() + i + 1, body.end()}, stmt.local));
        } else {
            print_statement(p, body[i]);
        }
    }
}

void print_statement(Printer& p, ir::StmtId id) {
    const Stmt& stmt = p.program.stmts[id];
    if (stmt.op != StmtOp::block && stmt.op != StmtOp::release && stmt.op != StmtOp::subgroup_barrier)
        mark_line(p, stmt.span);
    switch (stmt.op) {
    case StmtOp::let: return print_let(p, stmt, "");
    case StmtOp::assign: return print_assign(p, stmt);
    case StmtOp::if_: return print_if(p, stmt);
    case StmtOp::for_: return print_for(p, stmt);
    case StmtOp::while_:
        p.out.open("while (" + print_any(p, stmt.value) + ")");
        print_nested(p, stmt.body);
        return p.out.close();
    case StmtOp::break_: return p.out.line("break;");
    case StmtOp::continue_: return p.out.line("continue;");
    case StmtOp::return_: return print_return(p, stmt);
    case StmtOp::block:
        if (stmt.body.empty()) return;
        p.out.open("");
        print_nested(p, stmt.body);
        return p.out.close();
    case StmtOp::evaluate: return p.out.line(print_any(p, stmt.value) + ";");
    case StmtOp::subgroup_barrier: return;  // on the host device a subgroup has one invocation
    case StmtOp::print:
    case StmtOp::barrier:
#define STRUCTURE_STATEMENT(name) case StmtOp::name:
#define HOST_STATEMENT(name) case StmtOp::name:
#define MEMORY_STATEMENT(name) case StmtOp::name:
#define CPU_STATEMENT(name) case StmtOp::name:
#include "ir/statements.def"
        break;
    }
    p.outer_statement(stmt);
}

bool is_pure(const ir::Program& program, ir::FunctionId id) {
    bool pure = true;
    const ir::Function& function = program.functions[id];
    ir::for_each_statement(program, function.body, [&](const Stmt& stmt) {
        if (stmt.op == StmtOp::store || stmt.op == StmtOp::image_store || stmt.op == StmtOp::atomic ||
            stmt.op == StmtOp::report || stmt.op == StmtOp::print)
            pure = false;
    });
    ir::for_each_expression(program, function.body, [&](ir::ExprId node) {
        const ir::Expr& expr = program.exprs[node];
        if (is_load(expr.op) || expr.op == Op::parameter || expr.op == Op::builtin || expr.op == Op::invocation)
            pure = false;
        if (expr.op == Op::local && program.locals[expr.local].storage == ir::Storage::shared) pure = false;
        if (expr.op == Op::call && !is_pure(program, expr.function)) pure = false;
    });
    return pure;
}

void require_function(Globals& globals, ir::FunctionId id) {
    if (globals.function_names.contains(id)) return;
    const ir::Function& function = globals.program.functions[id];
    if (!function.extern_name.empty()) {
        globals.function_names[id] = function.extern_name;
        return;
    }
    const std::string name = globals.function_names[id] = declare_function(globals, id);
    Printer p(globals);
    std::string parameters;
    std::vector<std::string> structures;
    for (ir::StructureId structure : function.structures) {
        structures.push_back(p.names.declare("self"));
        parameters += (parameters.empty() ? "" : ", ") + ("const " + globals.structure_names[structure]) + "& " +
                      structures.back();
    }
    p.outer_expression = [&](const Expr& expr) -> Text {
        if (expr.place.root >= structures.size()) return {"{}"};
        return structure_property(globals, expr, function.structures[expr.place.root],
                                  structures[expr.place.root] + ".");
    };
    for (ir::LocalId local : function.params) {
        const ir::TypeId of = globals.program.locals[local].type;
        std::string type = type_text(globals, of);
        if (is_array(p, of)) type = "const " + type + "&";
        parameters += (parameters.empty() ? "" : ", ") + (unused_mark(globals.program, function.body, local) + type) +
                      " " + declare_local(p, local);
    }
    if (function.span) p.out.line("// " + place_text(globals.sources, function.span) + ": " + function.display);
    p.out.open("inline " + type_text(globals, function.result) + " " + name + "(" + parameters + ")");
    p.marked_file = function.span.file;
    p.marked_line = function.span ? globals.sources.line_of(function.span) : 0;
    print_statements(p, function.body);
    p.out.close();
    globals.functions += p.out.take() + "\n";
}

}  // namespace gliftc::cpp
