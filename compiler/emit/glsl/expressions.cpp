// Expressions, with parentheses only where GLSL needs them or a reader may misread them (is_easily_misread).
#include "base/concat.h"
#include "emit/glsl/printer.h"
#include "emit/glsl/signs.h"
#include "ir/levels.h"

#include <cstdio>
#include <stdexcept>

namespace gliftc::glsl {

using ir::BinaryOp;
using ir::Expr;
using ir::ExprId;
using ir::Op;
using ir::TypeId;
using ir::TypeKind;

namespace {

struct Operator {
    const char* text;
    Level level;
};

Operator operator_of(BinaryOp op) {
    switch (op) {
    case BinaryOp::multiply: return {"*", Level::term};
    case BinaryOp::divide: return {"/", Level::term};
    case BinaryOp::remainder: return {"%", Level::term};
    case BinaryOp::add: return {"+", Level::sum};
    case BinaryOp::subtract: return {"-", Level::sum};
    case BinaryOp::shift_left: return {"<<", Level::shift};
    case BinaryOp::shift_right: return {">>", Level::shift};
    case BinaryOp::less: return {"<", Level::relation};
    case BinaryOp::less_equal: return {"<=", Level::relation};
    case BinaryOp::greater: return {">", Level::relation};
    case BinaryOp::greater_equal: return {">=", Level::relation};
    case BinaryOp::equal: return {"==", Level::equality};
    case BinaryOp::not_equal: return {"!=", Level::equality};
    case BinaryOp::bit_and: return {"&", Level::bit_and};
    case BinaryOp::bit_xor: return {"^", Level::bit_xor};
    case BinaryOp::bit_or: return {"|", Level::bit_or};
    case BinaryOp::logical_and: return {"&&", Level::logical_and};
    case BinaryOp::logical_or: return {"||", Level::logical_or};
    }
    throw std::logic_error("emit/glsl: unknown operator");
}

/// Readers should not have to remember how shifts, bit operations and || bind: other operators in them, except unary
/// ones, get parentheses.
bool is_easily_misread(Level outer) {
    return outer == Level::shift || outer == Level::bit_and || outer == Level::bit_xor || outer == Level::bit_or ||
           outer == Level::logical_or;
}

std::string operand_text(Printer& p, ExprId id, Level outer, bool is_right) {
    Text text = print(p, id);
    bool fits = is_right ? text.level > outer : text.level >= outer;
    if (is_easily_misread(outer) && text.level != outer && text.level < Level::unary) fits = false;
    return fits ? std::move(text.text) : concat("(", text.text, ")");
}

/// A uint constant from 10 on in hexadecimal, as masks are easier to read: 0x00ff00ffu. Empty for other expressions.
std::string mask_text(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    if (expr.op != Op::constant || expr.type != p.program.types.uint || expr.bits < 10) return "";
    char text[16];
    std::snprintf(text, sizeof text, "0x%08xu", static_cast<std::uint32_t>(expr.bits));
    return text;
}

Text plain_binary(Printer& p, BinaryOp op, ExprId a, ExprId b) {
    Operator o = operator_of(op);
    bool is_mask = op == BinaryOp::bit_and || op == BinaryOp::bit_or || op == BinaryOp::bit_xor;
    if (std::string mask = is_mask ? mask_text(p, b) : ""; !mask.empty())
        return {operand_text(p, a, o.level, false) + " " + o.text + " " + mask, o.level};
    const std::string left = operand_text(p, a, o.level, false);
    return {concat(left, " ", o.text, " ", operand_text(p, b, o.level, true)), o.level};
}

Text helper_call(Printer& p, Helper helper, const Expr& expr, TypeId shape) {
    ExprId a = expr.operands[0], b = expr.operands[1];
    return {need(p, helper, shape) + "(" + print_as(p, a, shape) + ", " + print_as(p, b, shape) + ")"};
}

Text matrix_product(Printer& p, const Expr& expr) {
    const ir::Types& types = p.program.types;
    TypeId a = p.program.exprs[expr.operands[0]].type, b = p.program.exprs[expr.operands[1]].type;
    Helper helper = types.is_matrix(a) ? (types.is_matrix(b) ? Helper::matrix_matrix : Helper::matrix_vector)
                                       : Helper::vector_matrix;
    if (helper == Helper::matrix_vector) b = {};
    return {need(p, helper, a, b) + "(" + print_any(p, expr.operands[0]) + ", " + print_any(p, expr.operands[1]) + ")"};
}

Text print_division(Printer& p, const Expr& expr) {
    const ir::Types& types = p.program.types;
    ExprId a = expr.operands[0], b = expr.operands[1];
    TypeId scalar = types.scalar_of(expr.type);
    bool remainder = expr.binary == BinaryOp::remainder;
    if (types.is_floating(scalar)) {
        if (types.is_matrix(expr.type) && types.is_scalar(p.program.exprs[b].type))
            return {need(p, Helper::matrix_scalar_quotient, expr.type) + "(" + print_any(p, a) + ", " +
                    print_any(p, b) + ")"};
        if (corrects_division(p, expr.type) && !is_power_of_two(p, b)) return print_quotient(p, expr);
        return plain_binary(p, expr.binary, a, b);
    }
    bool safe = divisor_is_safe(p, b);
    if (scalar == types.uint64 && !is_power_of_two(p, b))
        return helper_call(p, remainder ? Helper::remainder : Helper::quotient, expr, expr.type);
    if (types.is_signed(scalar)) {
        if (safe && !remainder) return plain_binary(p, expr.binary, a, b);
        return helper_call(p, remainder ? Helper::remainder : Helper::quotient, expr, expr.type);
    }
    if (safe) return plain_binary(p, expr.binary, a, b);
    return {operand_text(p, a, Level::term, false) + (remainder ? " % " : " / ") + "max(" + print_any(p, b) + ", 1u)",
            Level::term};
}

Text print_shift(Printer& p, const Expr& expr) {
    const ir::Types& types = p.program.types;
    TypeKind kind = types.kind(types.scalar_of(expr.type));
    std::uint32_t width = kind == TypeKind::int64 || kind == TypeKind::uint64 ? 64 : 32;
    ExprId a = expr.operands[0], b = expr.operands[1];
    std::string left = types.is_vector(expr.type) && !types.is_vector(p.program.exprs[a].type)
                           ? print_as(p, a, expr.type)
                           : operand_text(p, a, Level::shift, false);
    const char* sign = expr.binary == BinaryOp::shift_left ? " << " : " >> ";
    if (shift_is_safe(p, b, width)) return {left + sign + operand_text(p, b, Level::shift, true), Level::shift};
    TypeKind amount = types.kind(types.scalar_of(p.program.exprs[b].type));
    std::string mask = std::to_string(width - 1) + (amount == TypeKind::uint     ? "u"
                                                    : amount == TypeKind::uint64 ? "ul"
                                                    : amount == TypeKind::int64  ? "l"
                                                                                 : "");
    return {left + sign + "(" + operand_text(p, b, Level::bit_and, false) + " & " + mask + ")", Level::shift};
}

Text print_negative(Printer& p, ExprId value) {
    return {need(p, Helper::negative, p.program.exprs[value].type) + "(" + print_any(p, value) + ")"};
}

Text print_binary(Printer& p, const Expr& expr) {
    if (const ExprId value = negated_choice(p, expr)) return print_negative(p, value);
    const ir::Types& types = p.program.types;
    TypeId a = p.program.exprs[expr.operands[0]].type, b = p.program.exprs[expr.operands[1]].type;
    switch (expr.binary) {
    case BinaryOp::divide:
    case BinaryOp::remainder: return print_division(p, expr);
    case BinaryOp::shift_left:
    case BinaryOp::shift_right: return print_shift(p, expr);
    case BinaryOp::multiply:
        if ((types.is_matrix(a) && !types.is_scalar(b)) || (types.is_matrix(b) && !types.is_scalar(a)))
            return matrix_product(p, expr);
        return plain_binary(p, expr.binary, expr.operands[0], expr.operands[1]);
    case BinaryOp::add:
    case BinaryOp::subtract:
    case BinaryOp::less:
    case BinaryOp::less_equal:
    case BinaryOp::greater:
    case BinaryOp::greater_equal:
    case BinaryOp::equal:
    case BinaryOp::not_equal:
    case BinaryOp::bit_and:
    case BinaryOp::bit_xor:
    case BinaryOp::bit_or:
    case BinaryOp::logical_and:
    case BinaryOp::logical_or: break;
    }
    return plain_binary(p, expr.binary, expr.operands[0], expr.operands[1]);
}

/// A choice between constants, at least one of them -0.0, as the negative of the choice between the negated constants:
/// negative(c ? 0.0 : 1.0) for c ? -0.0 : -1.0. Else drivers may lose the sign of zero (signs.h).
Text print_negative_choice(Printer& p, const Expr& expr) {
    const ir::TypeId scalar = p.program.types.scalar_of(expr.type);
    const auto negated = [&](ExprId side) {
        std::string parts;
        for (const double number : numbers_of(p, side))
            parts += (parts.empty() ? "" : ", ") + literal(p, scalar, 0, -number);
        return p.program.types.is_vector(expr.type) ? type_text(p, expr.type) + "(" + parts + ")" : parts;
    };
    return {need(p, Helper::negative, expr.type) + "(" + print(p, expr.operands[0], Level::logical_or) + " ? " +
            negated(expr.operands[1]) + " : " + negated(expr.operands[2]) + ")"};
}

Text print_unary(Printer& p, const Expr& expr) {
    if (const ExprId value = negated_choice(p, expr)) return print_negative(p, value);
    const char* sign = expr.unary == ir::UnaryOp::minus ? "-" : expr.unary == ir::UnaryOp::logical_not ? "!" : "~";
    if (expr.unary == ir::UnaryOp::logical_not && p.program.types.is_vector(expr.type))
        return {"not(" + print_any(p, expr.operands[0]) + ")"};
    std::string inside = print(p, expr.operands[0], Level::unary);
    bool doubled = inside[0] == '-' && *sign == '-';
    return {sign + (doubled ? "(" + inside + ")" : inside), Level::unary};
}

Text print_convert(Printer& p, const Expr& expr) {
    const ir::Types& types = p.program.types;
    ExprId operand = expr.operands[0];
    TypeId from = types.scalar_of(p.program.exprs[operand].type), to = types.scalar_of(expr.type);
    if (from == to) return print(p, operand);
    if (types.is_floating(from) && types.is_integer(to)) {
        Helper helper = to == types.int_    ? Helper::to_int
                        : to == types.uint  ? Helper::to_uint
                        : to == types.int64 ? Helper::to_int64
                                            : Helper::to_uint64;
        return {need(p, helper, p.program.exprs[operand].type) + "(" + print_any(p, operand) + ")"};
    }
    if (to == types.half)
        return {need(p, Helper::to_half, p.program.exprs[operand].type) + "(" + print_any(p, operand) + ")"};
    return {type_text(p, expr.type) + "(" + print_any(p, operand) + ")"};
}

/// Whether the expression is an element of a buffer that is reached by its address, or a part of one.
bool is_read_by_address(const Printer& p, ExprId id) {
    const Expr* expr = &p.program.exprs[id];
    while (expr->op == Op::field || expr->op == Op::index || expr->op == Op::value)
        expr = &p.program.exprs[expr->operands[0]];
    return expr->op == Op::load && p.pass.form == ir::Form::general;
}

/// A vector of which one component is taken. If copy propagation in NIR (Mesa's compiler) knows a vector from a read of
/// it as a whole, it mistakes each single component that is read through an address for component 0. So a vector that
/// lies behind an address is first passed whole to a function, and the component is taken from the result.
std::string print_vector(Printer& p, ExprId id, std::string text) {
    return is_read_by_address(p, id) ? need(p, Helper::whole_vector, p.program.exprs[id].type) + "(" + text + ")"
                                     : text;
}

Text print_swizzle(Printer& p, const Expr& expr) {
    const ir::Types& types = p.program.types;
    std::uint32_t count = types.components(expr.type);
    if (!types.is_vector(p.program.exprs[expr.operands[0]].type)) {
        if (count == 1) return print(p, expr.operands[0]);
        return {type_text(p, expr.type) + "(" + print_any(p, expr.operands[0]) + ")"};
    }
    std::string text = print(p, expr.operands[0], Level::postfix);
    if (count == 1) text = print_vector(p, expr.operands[0], std::move(text));
    text += ".";
    for (std::uint32_t i = 0; i < count; ++i) text += "xyzw"[expr.lanes[i]];
    return {text};
}

Text print_builtin(Printer& p, const Expr& expr) {
    auto subgroup = [&](const char* name) {
        p.extensions.insert("GL_KHR_shader_subgroup_basic");
        return Text{name};
    };
    switch (expr.builtin) {
    case ir::Builtin::global_id: return {"gl_GlobalInvocationID"};
    case ir::Builtin::local_id: return {"gl_LocalInvocationID"};
    case ir::Builtin::group_id: return {"gl_WorkGroupID"};
    case ir::Builtin::group_count: return {"gl_NumWorkGroups"};
    case ir::Builtin::local_index: return {"gl_LocalInvocationIndex"};
    case ir::Builtin::subgroup_size: return subgroup("gl_SubgroupSize");
    case ir::Builtin::subgroup_lane: return subgroup("gl_SubgroupInvocationID");
    case ir::Builtin::subgroup_index: return subgroup("gl_SubgroupID");
    case ir::Builtin::subgroup_count: return subgroup("gl_NumSubgroups");
    case ir::Builtin::corner: return {"uint(gl_VertexIndex)"};
    case ir::Builtin::instance: return {"uint(gl_InstanceIndex)"};
    case ir::Builtin::fragment_place: return {"gl_FragCoord"};
    case ir::Builtin::is_front: return {"gl_FrontFacing"};
    case ir::Builtin::skips_branches: return {need(p, Helper::skips_branches, expr.type)};
    case ir::Builtin::adds_floats: return {need(p, Helper::adds_floats, expr.type)};
    }
    throw std::logic_error("emit/glsl: unknown builtin");
}

Text print_local(Printer& p, const Expr& expr) {
    if (p.in_range_is_known && expr.local == p.pass.in_range) return {"true"};
    auto found = p.local_names.find(expr.local);
    if (found != p.local_names.end()) return {found->second};
    throw std::logic_error("emit/glsl: a local is used before it is declared: " +
                           (*p.program.names)[p.program.locals[expr.local].name]);
}

/// The expression as it stands: to take a part of it, or to assign to it. print() composes some values of their parts:
/// those that lie in a block and hold arrays of bools (blocks.cpp).
std::string print_whole(Printer& p, ExprId id);

Text print_index(Printer& p, const Expr& expr) {
    const ir::Type& of = p.program.types[p.program.exprs[expr.operands[0]].type];
    std::string whole = print_whole(p, expr.operands[0]);
    if (of.kind == TypeKind::vector) whole = print_vector(p, expr.operands[0], std::move(whole));
    return {whole + "[" + guarded_index(p, expr.operands[1], of.count) + "]"};
}

/// One side of a select, or an argument of a constructor (parts_of_whole). A struct, array or optional in a block is
/// composed of its parts: glslang gives it another type than one in a variable, and does not convert between the two in
/// `?:`.
std::string print_side(Printer& p, ExprId id, Level least) {
    TypeId type = p.program.exprs[id].type;
    TypeKind kind = p.program.types.kind(type);
    bool has_parts = kind == TypeKind::struct_ || kind == TypeKind::array || kind == TypeKind::optional;
    if (has_parts && lies_in_block(p.program, id)) return remade(p, print_whole(p, id), type);
    return print(p, id, least);
}

/// The arguments of a constructor. If it makes a struct, an array or an optional that contains a bool (holds_bool),
/// each argument that is a struct, an array or an optional in a block is composed of its parts, since glslang would
/// pass it with the type that it has in the block, where bools are uints.
std::string parts_of_whole(Printer& p, const Expr& expr) {
    const TypeKind kind = p.program.types.kind(expr.type);
    const bool has_parts = kind == TypeKind::struct_ || kind == TypeKind::array || kind == TypeKind::optional;
    if (!has_parts || !holds_bool(p.program, expr.type)) return join_arguments(p, expr.operands);
    std::string parts;
    for (ExprId operand : expr.operands)
        if (!is_empty(p.program, p.program.exprs[operand].type))
            parts += (parts.empty() ? "" : ", ") + print_side(p, operand, Level::ternary);
    return parts;
}

Text print_node(Printer& p, ExprId id);

std::string print_whole(Printer& p, ExprId id) {
    if (!lies_in_block(p.program, id)) return print(p, id, Level::postfix);
    Text text = print_node(p, id);
    return text.level < Level::postfix ? concat("(", text.text, ")") : std::move(text.text);
}

Text print_node(Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    switch (expr.op) {
    case Op::constant: {
        std::string text = literal(p, expr.type, expr.bits, expr.number);
        return {text, text[0] == '-' ? Level::unary : Level::postfix};
    }
    case Op::local: return print_local(p, expr);
    case Op::construct:
        return {concat(type_text(p, expr.type), "(", parts_of_whole(p, expr), padding_values(p, expr.type), ")")};
    case Op::convert: return print_convert(p, expr);
    case Op::unary: return print_unary(p, expr);
    case Op::binary: return print_binary(p, expr);
    case Op::select:
        if (is_choice_of_negative_zero(p, expr)) return print_negative_choice(p, expr);
        return {print(p, expr.operands[0], Level::logical_or) + " ? " +
                    print_side(p, expr.operands[1], Level::logical_or) + " : " +
                    print_side(p, expr.operands[2], Level::ternary),
                Level::ternary};
    case Op::swizzle: return print_swizzle(p, expr);
    case Op::index: return print_index(p, expr);
    case Op::field: {
        const ir::Type& of = p.program.types[p.program.exprs[expr.operands[0]].type];
        return {print_whole(p, expr.operands[0]) + "." + p.field_names[of.struct_][expr.slot]};
    }
    case Op::call: return {p.function_names.at(expr.function) + "(" + join_arguments(p, expr.operands) + ")"};
    case Op::intrinsic: return print_intrinsic(p, expr);
    case Op::none: return {zero(p, expr.type)};
    case Op::some: {
        std::string value = parts_of_whole(p, expr);
        return {type_text(p, expr.type) + "(true" + (value.empty() ? "" : ", " + value) + ")"};
    }
    case Op::has_value: return {print(p, expr.operands[0], Level::postfix) + ".has"};
    case Op::value: return {print(p, expr.operands[0], Level::postfix) + ".value"};
    case Op::parameter: return {p.parameter_names.at(expr.slot)};
    case Op::load:
    case Op::image_load:
    case Op::image_sample:
    case Op::image_gather:
    case Op::image_compare: return print_load(p, expr);
    case Op::builtin: return print_builtin(p, expr);
#define SHAPE_OPERATION(name) case Op::name:
#define STRUCTURE_OPERATION(name) case Op::name:
#define GUARDED_OPERATION(name) case Op::name:
#define HOST_OPERATION(name) case Op::name:
#define CPU_OPERATION(name) case Op::name:
#include "ir/operations.def"
        break;
    }
    ir::misplaced(expr.op, "emit/glsl: a lowered pass");
}

}  // namespace

std::string print_place(Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    const bool is_lane = expr.op == Op::swizzle && p.program.types.is_vector(p.program.exprs[expr.operands[0]].type);
    if (is_lane) return print_whole(p, expr.operands[0]) + "." + "xyzw"[expr.lanes[0]];
    if (expr.op != Op::index) return print_whole(p, id);
    const ir::Type& of = p.program.types[p.program.exprs[expr.operands[0]].type];
    return print_place(p, expr.operands[0]) + "[" + guarded_index(p, expr.operands[1], of.count) + "]";
}

Text print(Printer& p, ExprId id) {
    Text text = print_node(p, id);
    const TypeId type = p.program.exprs[id].type;
    if (!may_hold_bool_array(p.program, type) || !lies_in_block(p.program, id)) return text;
    return {remade(p, text.level < Level::postfix ? "(" + text.text + ")" : text.text, type)};
}

std::string print(Printer& p, ExprId id, Level least) {
    Text text = print(p, id);
    return text.level >= least ? text.text : "(" + text.text + ")";
}

std::string print_any(Printer& p, ExprId id) { return print(p, id).text; }

std::string print_as(Printer& p, ExprId id, TypeId shape) {
    const ir::Types& types = p.program.types;
    bool splat = types.is_vector(shape) && !types.is_vector(p.program.exprs[id].type);
    return splat ? type_text(p, shape) + "(" + print_any(p, id) + ")" : print_any(p, id);
}

std::string print_negated(Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    if (expr.op == Op::unary && expr.unary == ir::UnaryOp::logical_not)
        return print(p, expr.operands[0], Level::logical_or);
    if (expr.op == Op::binary) {
        const ir::Types& types = p.program.types;
        bool ordered = !types.is_floating(types.scalar_of(p.program.exprs[expr.operands[0]].type));
        auto with = [&](BinaryOp op) { return plain_binary(p, op, expr.operands[0], expr.operands[1]).text; };
        if (ordered && expr.binary == BinaryOp::less) return with(BinaryOp::greater_equal);
        if (ordered && expr.binary == BinaryOp::greater_equal) return with(BinaryOp::less);
        if (ordered && expr.binary == BinaryOp::greater) return with(BinaryOp::less_equal);
        if (ordered && expr.binary == BinaryOp::less_equal) return with(BinaryOp::greater);
        if (expr.binary == BinaryOp::equal) return with(BinaryOp::not_equal);
        if (expr.binary == BinaryOp::not_equal) return with(BinaryOp::equal);
        if (expr.binary == BinaryOp::logical_and)
            return print_negated(p, expr.operands[0]) + " || " + print_negated(p, expr.operands[1]);
    }
    if (expr.op == Op::intrinsic && expr.intrinsic == ir::Intrinsic::all &&
        p.program.types.is_vector(p.program.exprs[expr.operands[0]].type)) {
        const Expr& inner = p.program.exprs[expr.operands[0]];
        if (inner.op == Op::intrinsic && inner.intrinsic == ir::Intrinsic::lessThan &&
            p.program.types.is_integer(p.program.types.scalar_of(p.program.exprs[inner.operands[0]].type)))
            return "any(greaterThanEqual(" + join_arguments(p, inner.operands) + "))";
    }
    return "!" + print(p, id, Level::unary);
}

std::string join_arguments(Printer& p, const ir::Operands& arguments) {
    std::string text;
    for (ExprId argument : arguments)
        if (!is_empty(p.program, p.program.exprs[argument].type))
            text += (text.empty() ? "" : ", ") + print_any(p, argument);
    return text;
}

bool is_constant(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    if (expr.op == Op::constant) return true;
    if (expr.op != Op::construct) return false;
    for (ExprId operand : expr.operands)
        if (!is_constant(p, operand)) return false;
    return true;
}

}  // namespace gliftc::glsl
