// `==` and `!=` of structs: expanded member by member to comparisons of scalars, enums and vectors.
#include "sema/bodies/order.h"
#include "sema/pipelines/values.h"

namespace gliftc::sema {

namespace {

/// The number of comparisons of scalars or vectors that `==` of two values of the type takes.
std::uint64_t comparisons(const ir::Program& p, ir::TypeId id) {
    const ir::Type& type = p.types[id];
    switch (type.kind) {
    case ir::TypeKind::struct_: {
        std::uint64_t count = 0;
        for (const ir::StructField& field : p.structs[type.struct_].fields) count += comparisons(p, field.type);
        return count;
    }
    case ir::TypeKind::array: return type.count * comparisons(p, type.element);
    case ir::TypeKind::matrix: return type.count;
    case ir::TypeKind::optional: return 1 + comparisons(p, type.element);
    default: return 1;
    }
}

ir::ExprId make_both(ir::Program& p, ir::ExprId a, ir::ExprId b, Span span) {
    if (!a) return b;
    return make_binary(p, ir::BinaryOp::logical_and, p.types.bool_, a, b, span);
}

ir::ExprId make_equal(ir::Program& p, ir::ExprId left, ir::ExprId right, Span span) {
    const ir::TypeId id = p.exprs[left].type;
    const ir::Type type = p.types[id];
    ir::ExprId all;
    auto part = [&](ir::Op op, ir::TypeId of, ir::ExprId whole) { return add(p, op, of, span, {whole}); };
    switch (type.kind) {
    case ir::TypeKind::struct_:
        for (std::uint32_t i = 0; i < p.structs[type.struct_].fields.size(); ++i) {
            ir::TypeId field = p.structs[type.struct_].fields[i].type;
            ir::ExprId a = part(ir::Op::field, field, left), b = part(ir::Op::field, field, right);
            p.exprs[a].slot = p.exprs[b].slot = i;
            all = make_both(p, all, make_equal(p, a, b, span), span);
        }
        return all ? all : make_bool(p, true, span);
    case ir::TypeKind::array:
    case ir::TypeKind::matrix: {
        ir::TypeId element = type.kind == ir::TypeKind::matrix ? p.types.vector(type.element, type.rows) : type.element;
        for (std::uint32_t i = 0; i < type.count; ++i) {
            ir::ExprId at = make_uint(p, i, span);
            ir::ExprId a = add(p, ir::Op::index, element, span, {left, at});
            ir::ExprId b = add(p, ir::Op::index, element, span, {right, at});
            all = make_both(p, all, make_equal(p, a, b, span), span);
        }
        return all;
    }
    case ir::TypeKind::optional: {
        ir::ExprId a = part(ir::Op::has_value, p.types.bool_, left), b = part(ir::Op::has_value, p.types.bool_, right);
        ir::ExprId same =
            make_equal(p, part(ir::Op::value, type.element, left), part(ir::Op::value, type.element, right), span);
        ir::ExprId none = make_bool(p, true, span);
        return make_both(p, make_binary(p, ir::BinaryOp::equal, p.types.bool_, a, b, span),
                         add(p, ir::Op::select, p.types.bool_, span, {a, same, none}), span);
    }
    default: return make_binary(p, ir::BinaryOp::equal, p.types.bool_, left, right, span);
    }
}

/// The value as an expression that may be repeated: a local, a constant, or a new temporary for it. Unchanged where
/// there is no list of statements for a temporary, and if the value is open (sema/pipelines/values.h).
ir::ExprId named(Body& body, ir::ExprId value, Span span) {
    ir::Op op = body.program().exprs[value].op;
    if (!body.block || is_open(body, value) || op == ir::Op::local || op == ir::Op::constant) return value;
    return make_local(body.program(), emit_temporary(body, "compared", value, span), span);
}

}  // namespace

bool has_equality(const ir::Program& program, ir::TypeId type) {
    constexpr std::uint64_t most_comparisons = 64;
    const ir::Types& types = program.types;
    if (types.kind(type) == ir::TypeKind::struct_) return comparisons(program, type) <= most_comparisons;
    return types.is_scalar(type) || types.is_vector(type) || types.kind(type) == ir::TypeKind::enum_;
}

ir::ExprId make_struct_equality(Body& body, bool negated, ir::ExprId left, ir::ExprId right, Span span) {
    const ir::ExprId sides[] = {left, right};
    if (is_open(body, left) || is_open(body, right)) settle(body);
    else settle(body, sides);
    left = named(body, left, span);
    right = named(body, right, span);
    ir::ExprId equal = make_equal(body.program(), left, right, span);
    if (!negated) return equal;
    ir::ExprId result = add(body.program(), ir::Op::unary, body.types().bool_, span, {equal});
    body.program().exprs[result].unary = ir::UnaryOp::logical_not;
    return result;
}

}  // namespace gliftc::sema
