// Kernels without a group whose elements run a loop in lockstep (lower/host/lockstep.h): a loop over the runs of a row,
// and for each `invocations` a loop over the elements of a run. A local that is kept is an array with an element for
// each of them, from which each such loop takes it, and to which it returns it.
#include "base/concat.h"
#include "emit/cpp/host/rows.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::host {

using ir::Stmt;
using ir::StmtId;
using ir::StmtOp;

namespace {

bool sets(const ir::Program& program, const std::vector<StmtId>& statements, ir::LocalId local) {
    bool found = false;
    ir::for_each_statement(program, statements, [&](const Stmt& stmt) {
        found = found || (stmt.op == StmtOp::let && stmt.local == local) ||
                (stmt.op == StmtOp::assign && ir::place_of(program, stmt.target).local == local);
    });
    return found;
}

bool declares(const ir::Program& program, const std::vector<StmtId>& statements, ir::LocalId local) {
    return std::ranges::any_of(
        statements, [&](StmtId id) { return program.stmts[id].op == StmtOp::let && program.stmts[id].local == local; });
}

/// Whether a statement outside of `invocations` uses the local.
bool is_used_outside(const ir::Program& program, const std::vector<StmtId>& statements, ir::LocalId local) {
    return std::ranges::any_of(statements, [&](StmtId id) {
        const Stmt& stmt = program.stmts[id];
        bool is_used = false;
        ir::for_each_root(stmt, [&](ir::ExprId root) { is_used = is_used || ir::mentions(program, root, local); });
        return is_used || (stmt.op != StmtOp::invocations && is_used_outside(program, stmt.body, local));
    });
}

}  // namespace

/// The first element of the row if the condition of the access's index, a select, holds; else the first of as many
/// copies of the other element.
std::string Rows::chosen_row(const RowAccess& access) {
    const ir::Operands operands = program.exprs[access.index].operands;
    const std::string& data = body.binding_names[access.binding];
    const std::string copies = p.names.declare(data + "_copies");
    p.out.line(concat("glift::host::Copies<", cpp::storage_text(p.globals, pass.bindings[access.binding].element), "> ",
                      copies, ";"));
    return concat(copies, ".unless(", cpp::print_any(p, operands[0]), ", ", data, " + ",
                  cpp::print(p, operands[1], cpp::Level::postfix), ", ", data, " + ",
                  cpp::print(p, operands[2], cpp::Level::postfix), ")");
}

/// A loop over the elements of the run.
void Rows::print_element_of_run(const std::vector<StmtId>& statements, const std::string& run) {
    const std::vector<RowAccess> accesses = row_accesses(program, statements);
    body.row_pointers.clear();
    p.marked_line = 0;
    p.names.enter();
    if (!accesses.empty()) {
        p.out.open("");
        print_row_pointers(statements, accesses, run + ".begin");
    }
    IdSet<ir::Local> read;
    for (const auto& [local, name] : kept_names) read.insert(local);
    const std::vector<StmtId> live = without_unused(statements, read);
    p.out.line("GLIFT_INDEPENDENT");
    p.out.open("for (std::size_t i = 0; i < " + run + ".count; ++i)");
    if (read.contains(pass.address)) print_address(run + ".begin + static_cast<uint>(i)");
    p.marked_line = 0;
    p.names.enter();
    for (const auto& [local, name] : kept_names) {
        if (declares(program, live, local) || !ir::mentions(program, live, local)) continue;
        p.out.line(concat(sets(program, live, local) ? "" : "const ",
                          cpp::type_text(p.globals, program.locals[local].type), " ", cpp::declare_local(p, local),
                          " = ", name, ".at(i);"));
    }
    cpp::print_statements(p, live);
    for (const auto& [local, name] : kept_names)
        if (sets(program, live, local)) p.out.line(concat(name, ".set(i, ", p.local_names.at(local), ");"));
    p.names.leave();
    p.out.close();
    if (!accesses.empty()) p.out.close();
    p.names.leave();
}

void Rows::print_run(const Stmt& stmt, const std::string& run, const std::function<void(const Stmt&)>& print_other) {
    if (stmt.op == StmtOp::cut) {
        p.out.line(concat(run, ".cut(", cpp::print_any(p, stmt.value), ", ", cpp::print_any(p, stmt.limit), ");"));
    } else if (stmt.op == StmtOp::keep) {
        const ir::Local& local = program.locals[stmt.local];
        std::string& name = kept_names[stmt.local];
        name = p.names.declare((*program.names)[local.name] + "_of_run");
        p.out.line(concat("glift::host::Kept<", cpp::type_text(p.globals, local.type), "> ", name, ";"));
    } else if (stmt.op == StmtOp::invocations) {
        if (!stmt.body.empty()) print_element_of_run(stmt.body, run);
    } else {
        print_other(stmt);
    }
}

/// A loop over the runs of elements with x in [begin, end).
void Rows::print_runs(const ir::Variant& variant, const std::string& begin, const std::string& end) {
    has_runs = true;
    kept_names.clear();
    body.item_pointers.clear();
    p.names.enter();
    const std::string run = p.names.declare("run");
    p.out.open(concat("for (glift::host::Run ", run, "(", begin, ", ", end, "); ", run, ".count != 0; ", run, ".next(",
                      end, "))"));
    if (is_used_outside(program, variant.body, pass.address)) print_address(run + ".begin");
    const std::function<void(const Stmt&)> print_other = p.outer_statement;
    p.outer_statement = [&](const Stmt& stmt) { print_run(stmt, run, print_other); };
    cpp::print_statements(p, variant.body);
    p.outer_statement = print_other;
    p.out.close();
    p.names.leave();
}

}  // namespace gliftc::host
