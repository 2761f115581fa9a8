#include "ir/evaluate.h"
#include "ir/printer.h"
#include "ir/spelling.h"

namespace gliftc::ir {

void Printer::body(const std::vector<StmtId>& body) {
    ++indent_;
    for (StmtId id : body) stmt(p.stmts[id]);
    --indent_;
}

void Printer::nested(const std::string& head, const std::vector<StmtId>& statements) {
    line(head);
    body(statements);
}

/// var: mutable; tmp: immutable, made by a pass of lower/ for a value that is used more than once; let: any other.
std::string Printer::declaration(LocalId id) {
    const Local& of = p.locals[id];
    return (of.is_mutable ? "var " : of.is_temporary ? "tmp " : "let ") + local(id) + ": " + type(of.type);
}

void Printer::let(const Stmt& stmt) {
    std::string text = declaration(stmt.local);
    if (stmt.value) text += " = " + expr(stmt.value);
    else if (stmt.uninitialized) text += " = uninitialized";
    line(text + ";");
}

// long: a case for each statement
void Printer::stmt(const Stmt& stmt) {
    switch (stmt.op) {
    case StmtOp::let: let(stmt); break;
    case StmtOp::assign: line(expr(stmt.target) + " = " + expr(stmt.value) + ";"); break;
    case StmtOp::if_:
        nested("if " + expr(stmt.value) + " {", stmt.body);
        if (!stmt.otherwise.empty()) nested("} else {", stmt.otherwise);
        line("}");
        break;
    case StmtOp::for_: {
        const std::string head = (stmt.unrolled ? "unrolled for " : "for ") + local(stmt.local) + ": " +
                                 type(p.locals[stmt.local].type) + " in ";
        nested(head + operand(stmt.value) + ".." + operand(stmt.limit) + " {", stmt.body);
        line("}");
        break;
    }
    case StmtOp::while_:
        nested("while " + expr(stmt.value) + " {", stmt.body);
        line("}");
        break;
    case StmtOp::break_: line("break;"); break;
    case StmtOp::continue_: line("continue;"); break;
    case StmtOp::return_: line(stmt.value ? "return " + expr(stmt.value) + ";" : "return;"); break;
    case StmtOp::block:
        nested("{", stmt.body);
        line("}");
        break;
    case StmtOp::evaluate: line(expr(stmt.value) + ";"); break;
    case StmtOp::print:
        line("print(" + std::to_string(stmt.slot) + (stmt.value ? ", " + expr(stmt.value) : "") + ");");
        break;
    case StmtOp::barrier: line("barrier();"); break;
    case StmtOp::subgroup_barrier: line("subgroupBarrier();"); break;
    case StmtOp::set_element: line(place(stmt.place) + field(stmt) + " = " + expr(stmt.value) + ";"); break;
    case StmtOp::write:
        line(place(stmt.place) + "[" + expr(stmt.target) + "] = " + expr(stmt.value) + ";" +
             (stmt.combine == Combine::replace ? "" : "  // " + std::string(spelling(stmt.combine))));
        break;
    case StmtOp::store:
        line(binding(stmt.slot) + "[" + expr(stmt.target) + "]" + member(stmt) + " = " + expr(stmt.value) + ";");
        break;
    case StmtOp::image_store:
        line("image_store(" + binding(stmt.slot) + ", " + expr(stmt.target) + ", " + expr(stmt.value) + ");");
        break;
    case StmtOp::atomic:
        line("atomic_" + std::string(spelling(stmt.combine)) + "(" + binding(stmt.slot) + "[" + expr(stmt.target) +
             "], " + expr(stmt.value) + ");");
        break;
    case StmtOp::discard: line("discard;"); break;
    case StmtOp::report:
        line("report(" + (stmt.slot == no_binding ? "view" : binding(stmt.slot)) + ", " + expr(stmt.target) + ");");
        break;
#define HOST_STATEMENT(name) case StmtOp::name:
#include "ir/statements.def"
        host_stmt(stmt);
        break;
#define CPU_STATEMENT(name) case StmtOp::name:
#include "ir/statements.def"
        cpu_stmt(stmt);
        break;
    }
}

/// The member of an element that a store changes, as it stands behind the element; nothing if it changes all of it.
/// The fields that a set_element writes, if it does not write whole elements.
std::string Printer::field(const Stmt& stmt) const {
    if (stmt.path.empty()) return "";
    std::string text;
    TypeId type = p.structures[kernel_->params[stmt.place.root].structure].element;
    for (std::uint32_t slot : stmt.path) {
        const StructField& field = p.structs[p.types[type].struct_].fields[slot];
        text += "." + name(field.name);
        type = field.type;
    }
    return text;
}

std::string Printer::member(const Stmt& stmt) const {
    std::string text;
    for_each_step(p, *pass_, stmt,
                  [&](std::uint32_t slot, StructId of) { text += "." + name(p.structs[of].fields[slot].name); });
    return text;
}

void Printer::cpu_stmt(const Stmt& stmt) {
    switch (stmt.op) {
    case StmtOp::row_store:
        line(binding(stmt.slot) + ".row[" + expr(stmt.target) + "]" + member(stmt) + " = " + expr(stmt.value) + ";");
        break;
    case StmtOp::row_update:
        line("row_update_" + std::string(spelling(stmt.combine)) + "(" + binding(stmt.slot) + "[" + expr(stmt.target) +
             "], " + expr(stmt.value) + ");");
        break;
    case StmtOp::column_update:
        line("column_update_" + std::string(spelling(stmt.combine)) + "(" + binding(stmt.slot) + "[" +
             expr(stmt.target) + "], " + expr(stmt.value) + ", " + expr(stmt.limit) + ");");
        break;
    case StmtOp::load_rows:
        line("load_rows(" + binding(stmt.slot) + ", " + expr(stmt.value) + ", " + expr(stmt.target) + ");");
        break;
    case StmtOp::store_rows:
        line("store_rows(" + binding(stmt.slot) + ", " + expr(stmt.target) + ", " + expr(stmt.value) + ");");
        break;
    case StmtOp::copy_row:
        line("copy_row(" + binding(stmt.slot) + ", " + expr(stmt.value) + ", " + expr(stmt.target) + ", " +
             expr(stmt.limit) + ");");
        break;
    case StmtOp::cut: line("cut(" + expr(stmt.value) + ", " + expr(stmt.limit) + ");"); break;
    case StmtOp::keep: line("keep " + declaration(stmt.local) + ";"); break;
    default: nested("invocations {", stmt.body); line("}");
    }
}

void Printer::host_stmt(const Stmt& stmt) {
    switch (stmt.op) {
    case StmtOp::temp:
        line((stmt.uninitialized ? "uninitialized temp " : "temp ") + local(stmt.local) + " = " +
             to_text(p, p.locals[stmt.local].type) + "(" + list(stmt.arguments) + ");");
        break;
    case StmtOp::release: {
        std::string text = "release";
        for (LocalId id : stmt.locals) text += " " + local(id);
        line(text + ";");
        break;
    }
    case StmtOp::arms:
        nested("where " + expr(stmt.value) + " {", stmt.body);
        if (!stmt.otherwise.empty()) nested("} elsewhere {", stmt.otherwise);
        line("}");
        break;
    case StmtOp::dispatch:
        line("dispatch " + name(p.kernels[stmt.kernel()].name) + "(" + list(stmt.arguments) + ");");
        break;
    case StmtOp::expect: line("expect(" + expr(stmt.value) + ");"); break;
    case StmtOp::expect_near: line("expect_near(" + list(stmt.arguments) + ");"); break;
    case StmtOp::expect_same: line("expect_same(" + list(stmt.arguments) + ");"); break;
    case StmtOp::replace: line("replace " + place(stmt.place) + " by " + local(stmt.local) + ";"); break;
    default: line("host " + expr(stmt.target) + " = " + expr(stmt.value) + ";"); break;
    }
}

void Printer::function(FunctionId id) {
    const Function& of = p.functions[id];
    std::string text = "fn " + (pass_ ? function_name(id) : of.display.empty() ? name(of.name) : of.display) + "(";
    for (std::size_t i = 0; i < of.params.size(); ++i)
        text += (i ? ", " : "") + local(of.params[i]) + ": " + type(p.locals[of.params[i]].type);
    nested(text + ") -> " + type(of.result) + " {", of.body);
    line("}");
}

}  // namespace gliftc::ir
