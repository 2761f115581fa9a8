// Makes the statements that transformations need.
#pragma once

#include "lower/context.h"

#include <string_view>
#include <vector>

namespace gliftc::lower {

/// Makes statements with one source location.
class Statements {
public:
    Statements(Context& context, Span span) : cx(context), span_(span) {}

    StmtId barrier() { return cx.add(statement(StmtOp::barrier, span_)); }

    StmtId assign(ExprId target, ExprId value) {
        ir::Stmt stmt = statement(StmtOp::assign, span_);
        stmt.target = target;
        stmt.value = value;
        return cx.add(std::move(stmt));
    }

    /// Stores into a buffer; `index` as index_of (lower/expand/memory.h) makes it.
    StmtId store(std::uint32_t slot, ExprId index, ExprId value) {
        ir::Stmt stmt = statement(StmtOp::store, span_);
        stmt.slot = slot;
        stmt.target = index;
        stmt.value = value;
        return cx.add(std::move(stmt));
    }

    StmtId evaluate(ExprId value) {
        ir::Stmt stmt = statement(StmtOp::evaluate, span_);
        stmt.value = value;
        return cx.add(std::move(stmt));
    }

    StmtId where(ExprId condition, std::vector<StmtId> body, std::vector<StmtId> otherwise = {}) {
        ir::Stmt stmt = statement(StmtOp::if_, span_);
        stmt.value = condition;
        stmt.body = std::move(body);
        stmt.otherwise = std::move(otherwise);
        return cx.add(std::move(stmt));
    }

    /// Declares a local with this value; adds the `let` to `body`.
    ExprId let(std::string_view name, ExprId value, std::vector<StmtId>& body) {
        return cx.build.local(declare(name, value, false, body));
    }
    LocalId variable(std::string_view name, ExprId value, std::vector<StmtId>& body) {
        return declare(name, value, true, body);
    }

    /// A loop over the numbers up to `limit`; `body` makes the statements of one.
    template <class Body> StmtId loop(std::string_view variable, ExprId limit, Body body) {
        ir::Stmt stmt = statement(StmtOp::for_, span_);
        stmt.local = cx.new_local(variable, cx.p.types.uint, span_);
        stmt.value = cx.build.uint(0);
        stmt.limit = limit;
        stmt.body = body(cx.build.local(stmt.local));
        return cx.add(std::move(stmt));
    }

    /// An array in workgroup memory.
    LocalId workgroup_array(std::string_view name, TypeId element, std::uint32_t count) {
        const LocalId local = cx.new_local(name, cx.p.types.array(element, count), span_, true);
        cx.p.locals[local].storage = ir::Storage::shared;
        cx.pass.shared.push_back(local);
        return local;
    }

private:
    LocalId declare(std::string_view name, ExprId value, bool is_mutable, std::vector<StmtId>& body) {
        ir::Stmt stmt = statement(StmtOp::let, span_);
        stmt.local = cx.new_local(name, cx.build.type(value), span_, is_mutable);
        stmt.value = value;
        if (!is_mutable) cx.definitions[stmt.local] = value;
        const LocalId local = stmt.local;
        body.push_back(cx.add(std::move(stmt)));
        return local;
    }

    Context& cx;
    Span span_;
};

}  // namespace gliftc::lower
