#include "ir/reader.h"
#include "ir/spelling.h"
#include "ir/walk.h"

namespace gliftc::ir {

/// The local with this name, made at its first declaration: a name is one local throughout a pass, even if two bodies
/// declare it.
LocalId Reader::declared(const std::string& called, Local local) {
    auto [found, is_new] = locals_.try_emplace(called);
    if (is_new) {
        local.name = p.names->intern(called.substr(0, called.find('.')));
        found->second = p.locals.add(std::move(local));
    }
    return found->second;
}

std::vector<StmtId> Reader::block() {
    expect("{");
    std::vector<StmtId> body = statements();
    expect("}");
    return body;
}

/// Reads statements up to a closing brace, or to the next section of the pass.
std::vector<StmtId> Reader::statements() {
    std::vector<StmtId> body;
    while (!at("}") && !at("block\n") && !at("body") && !at("vertex") && !at("fragment") && !at("prologue"))
        body.push_back(p.stmts.add(statement()));
    return body;
}

Stmt Reader::let(bool is_mutable, bool is_temporary) {
    Stmt stmt;
    stmt.op = StmtOp::let;
    const std::string called = name();
    expect(":");
    const TypeId type = this->type();
    if (accept("=")) {
        if (accept("uninitialized")) stmt.uninitialized = true;
        else stmt.value = expr();
    }
    expect(";");
    stmt.local = declared(called, {.type = type, .is_mutable = is_mutable, .is_temporary = is_temporary});
    return stmt;
}

Stmt Reader::conditional() {
    Stmt stmt;
    stmt.op = StmtOp::if_;
    stmt.value = expr();
    stmt.body = block();
    if (accept("else")) stmt.otherwise = block();
    return stmt;
}

Stmt Reader::counted_loop() {
    Stmt stmt;
    stmt.op = StmtOp::for_;
    const std::string called = name();
    expect(":");
    stmt.local = declared(called, {.type = type()});
    expect("in");
    stmt.value = operand();
    expect("..");
    stmt.limit = operand();
    stmt.body = block();
    return stmt;
}

/// Reads the rest of: load_rows(binding, first, array); or store_rows(binding, first, array);
Stmt Reader::move_of_rows(StmtOp op) {
    Stmt stmt = memory_statement(op, Combine::replace);
    if (op == StmtOp::load_rows) std::swap(stmt.target, stmt.value);
    return stmt;
}

/// Reads the rest of: copy_row(binding, first, array[index], count);
Stmt Reader::copy_of_row() {
    Stmt stmt;
    stmt.op = StmtOp::copy_row;
    expect("(");
    const auto found = bindings_.find(name());
    if (found == bindings_.end()) fail("no such binding before this");
    stmt.slot = found->second;
    for (ExprId* part : {&stmt.value, &stmt.target, &stmt.limit}) {
        expect(",");
        *part = expr();
    }
    expect(")");
    expect(";");
    return stmt;
}

/// Reads the rest of: cut(value, limit);
Stmt Reader::cut() {
    Stmt stmt;
    stmt.op = StmtOp::cut;
    expect("(");
    stmt.value = expr();
    expect(",");
    stmt.limit = expr();
    expect(")");
    expect(";");
    return stmt;
}

/// Reads the rest of: print(message, words); or print(message);
Stmt Reader::print() {
    Stmt stmt;
    stmt.op = StmtOp::print;
    expect("(");
    stmt.slot = static_cast<std::uint32_t>(number());
    if (accept(",")) stmt.value = expr();
    expect(")");
    expect(";");
    return stmt;
}

/// Reads the rest of: keep var name: type; where `let` or `tmp` may stand in place of `var`.
Stmt Reader::keep() {
    const bool is_mutable = accept("var"), is_temporary = !is_mutable && accept("tmp");
    if (!is_mutable && !is_temporary) expect("let");
    Stmt stmt = let(is_mutable, is_temporary);
    stmt.op = StmtOp::keep;
    return stmt;
}

/// Reads the rest of: image_store(binding, at, value); or atomic_add(binding[at], value); (or another atomic_… or
/// row_update_…), with the element's x in column_update_…, or report(binding, address); or report(view, address); where
/// `view` is this word and no binding. For move_of_rows(), the rest of load_rows or store_rows.
Stmt Reader::memory_statement(StmtOp op, Combine combine) {
    Stmt stmt;
    stmt.op = op;
    stmt.combine = combine;
    expect("(");
    if (op == StmtOp::report && accept("view")) {
        stmt.slot = no_binding;
    } else {
        const auto found = bindings_.find(name());
        if (found == bindings_.end()) fail("no such binding before this");
        stmt.slot = found->second;
    }
    const bool is_update = op == StmtOp::atomic || op == StmtOp::row_update || op == StmtOp::column_update;
    expect(is_update ? "[" : ",");
    stmt.target = expr();
    if (is_update) expect("]");
    if (op != StmtOp::report) {
        expect(",");
        stmt.value = expr();
    }
    if (op == StmtOp::column_update) {
        expect(",");
        stmt.limit = expr();
    }
    expect(")");
    expect(";");
    return stmt;
}

/// The fields that lead from an element of memory to a member of it, outermost first.
std::vector<std::uint32_t> Reader::path_of(ExprId member) {
    std::vector<std::uint32_t> path;
    for (const Expr* node = &p.exprs[member]; node->op != Op::load && node->op != Op::row_load;
         node = &p.exprs[node->operands[0]]) {
        if (node->op != Op::field) fail("a store changes an element or a member of one, not a part of a member");
        path.insert(path.begin(), node->slot);
    }
    return path;
}

/// Reads an assignment, a store (a load, or a member of one, on the left of '='), or an expression that is evaluated
/// for its effect.
Stmt Reader::assignment() {
    Stmt stmt;
    const ExprId first = expr();
    if (accept("=")) {
        const Expr& target = place_of(p, first);
        const bool is_store = target.op == Op::load || target.op == Op::row_load;
        if (is_store) stmt.path = path_of(first);
        stmt.op = target.op == Op::row_load ? StmtOp::row_store : is_store ? StmtOp::store : StmtOp::assign;
        stmt.slot = is_store ? target.slot : 0;
        stmt.target = is_store ? target.operands[0] : first;
        stmt.value = expr();
    } else {
        stmt.op = StmtOp::evaluate;
        stmt.value = first;
    }
    expect(";");
    return stmt;
}

/// Reads the rest of a statement that is a single keyword.
Stmt Reader::simple(StmtOp op) {
    Stmt stmt;
    stmt.op = op;
    expect(";");
    return stmt;
}

Stmt Reader::statement() {
    if (accept("let")) return let(false, false);
    if (accept("tmp")) return let(false, true);
    if (accept("var")) return let(true, false);
    if (accept("if")) return conditional();
    if (accept("for")) return counted_loop();
    if (accept("unrolled")) {
        expect("for");
        Stmt stmt = counted_loop();
        stmt.unrolled = true;
        return stmt;
    }
    if (accept("while")) {
        Stmt stmt;
        stmt.op = StmtOp::while_;
        stmt.value = expr();
        stmt.body = block();
        return stmt;
    }
    if (at("{")) {
        Stmt stmt;
        stmt.op = StmtOp::block;
        stmt.body = block();
        return stmt;
    }
    if (accept("return")) {
        Stmt stmt;
        stmt.op = StmtOp::return_;
        if (!at(";")) stmt.value = expr();
        expect(";");
        return stmt;
    }
    if (accept("break")) return simple(StmtOp::break_);
    if (accept("continue")) return simple(StmtOp::continue_);
    if (accept("discard")) return simple(StmtOp::discard);
    if (accept("barrier()")) return simple(StmtOp::barrier);
    if (accept("subgroupBarrier()")) return simple(StmtOp::subgroup_barrier);
    if (accept("print")) return print();
    if (accept("keep")) return keep();
    if (accept("invocations")) {
        Stmt stmt;
        stmt.op = StmtOp::invocations;
        stmt.body = block();
        return stmt;
    }
    if (accept("copy_row")) return copy_of_row();
    if (accept("cut")) return cut();
    if (accept("load_rows")) return move_of_rows(StmtOp::load_rows);
    if (accept("store_rows")) return move_of_rows(StmtOp::store_rows);
    if (accept("image_store")) return memory_statement(StmtOp::image_store, Combine::replace);
    if (accept("report")) return memory_statement(StmtOp::report, Combine::replace);
    for (std::uint8_t i = 0; i <= static_cast<std::uint8_t>(Combine::bit_xor); ++i) {
        const auto combine = static_cast<Combine>(i);
        if (accept(concat("atomic_", spelling(combine)))) return memory_statement(StmtOp::atomic, combine);
        if (accept(concat("row_update_", spelling(combine)))) return memory_statement(StmtOp::row_update, combine);
        if (accept(concat("column_update_", spelling(combine))))
            return memory_statement(StmtOp::column_update, combine);
    }
    return assignment();
}

}  // namespace gliftc::ir
