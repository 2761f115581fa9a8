// Builders of IR nodes.
#pragma once

#include "ir/ir.h"

namespace gliftc::sema {

inline ir::ExprId add(ir::Program& p, ir::Op op, ir::TypeId type, Span span, ir::Operands operands = {}) {
    ir::Expr expr;
    expr.op = op;
    expr.type = type;
    expr.span = span;
    expr.operands = std::move(operands);
    return p.exprs.add(std::move(expr));
}

inline ir::ExprId make_uint(ir::Program& p, std::uint32_t value, Span span) {
    ir::ExprId id = add(p, ir::Op::constant, p.types.uint, span);
    p.exprs[id].bits = value;
    return id;
}

inline ir::ExprId make_bool(ir::Program& p, bool value, Span span) {
    ir::ExprId id = add(p, ir::Op::constant, p.types.bool_, span);
    p.exprs[id].bits = value;
    return id;
}

inline ir::ExprId make_local(ir::Program& p, ir::LocalId local, Span span) {
    ir::ExprId id = add(p, ir::Op::local, p.locals[local].type, span);
    p.exprs[id].local = local;
    return id;
}

inline ir::ExprId make_binary(ir::Program& p, ir::BinaryOp op, ir::TypeId type, ir::ExprId a, ir::ExprId b, Span span) {
    ir::ExprId id = add(p, ir::Op::binary, type, span, {a, b});
    p.exprs[id].binary = op;
    return id;
}

inline ir::ExprId make_swizzle(ir::Program& p, ir::ExprId vector, std::uint8_t lane, Span span) {
    ir::ExprId id = add(p, ir::Op::swizzle, p.types.scalar_of(p.exprs[vector].type), span, {vector});
    p.exprs[id].lanes[0] = lane;
    return id;
}

inline ir::StmtId add(ir::Program& p, ir::StmtOp op, Span span) {
    ir::Stmt stmt;
    stmt.op = op;
    stmt.span = span;
    return p.stmts.add(std::move(stmt));
}

inline ir::LocalId add_local(ir::Program& p, Name name, ir::TypeId type, Span span, bool is_mutable = false) {
    return p.locals.add(
        {.name = name, .type = type, .span = span, .is_mutable = is_mutable, .storage = ir::Storage::value});
}

}  // namespace gliftc::sema
