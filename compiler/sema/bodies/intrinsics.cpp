// Calls of intrinsics: matches arguments against the signature strings of ir/intrinsics.def.
#include "ir/chain.h"
#include "ir/walk.h"
#include "sema/bodies/order.h"
#include "sema/kernels/raster.h"
#include "sema/pipelines/values.h"
#include "sema/types/typing.h"

#include <algorithm>
#include <unordered_map>

namespace gliftc::sema {

namespace {

/// One parameter of a signature. `letter`: the types that it takes, as ir/intrinsics.def explains.
struct Shape {
    char letter;
    bool or_scalar;  // "Nn", "Fn": a scalar of the vector's element type is accepted, too
};

struct Signature {
    std::vector<Shape> params;
    char result;
    bool subgroup = false;
    bool atomic = false;  // the first parameter is an element of workgroup or coherent memory
};

Signature read(std::string_view text) {
    Signature signature{};
    std::size_t i = 0;
    if (text.starts_with('@')) signature.atomic = true, i = 1;
    for (; text[i] != ':'; ++i) {
        bool follows_capital = !signature.params.empty() && text[i] == 'n' &&
                               std::string_view("NF").find(signature.params.back().letter) != std::string_view::npos;
        if (follows_capital && !signature.params.back().or_scalar) signature.params.back().or_scalar = true;
        else signature.params.push_back({text[i], false});
    }
    signature.result = text[i + 1];
    signature.subgroup = text.ends_with('*');
    return signature;
}

bool is_value(ir::TypeKind kind) {
    switch (kind) {
    case ir::TypeKind::bool_:
    case ir::TypeKind::int_:
    case ir::TypeKind::uint:
    case ir::TypeKind::float_:
    case ir::TypeKind::half:
    case ir::TypeKind::double_:
    case ir::TypeKind::int64:
    case ir::TypeKind::uint64:
    case ir::TypeKind::vector:
    case ir::TypeKind::matrix:
    case ir::TypeKind::array:
    case ir::TypeKind::struct_:
    case ir::TypeKind::enum_:
    case ir::TypeKind::optional: return true;
    case ir::TypeKind::error:
    case ir::TypeKind::void_:
    case ir::TypeKind::structure:
    case ir::TypeKind::slice:
    case ir::TypeKind::device: return false;
    }
    return false;
}

bool accepts(const ir::Types& types, char letter, ir::TypeId type) {
    ir::TypeId scalar = types.scalar_of(type);
    bool shaped = types.is_scalar(type) || types.is_vector(type);
    switch (letter) {
    case 'F': return shaped && types.is_floating(scalar);
    case 'G': return shaped && types.is_floating(scalar) && scalar != types.double_;
    case 'J': return shaped && (scalar == types.int_ || scalar == types.uint);
    case 'V': return (types.is_vector(type) || types.is_scalar(type)) && types.is_floating(scalar);
    case 'N': return shaped && types.is_number(scalar);
    case 'I': return shaped && types.is_integer(scalar);
    case 'U': return shaped && types.kind(scalar) == ir::TypeKind::uint;
    case 'R': return shaped && types.kind(scalar) == ir::TypeKind::float_;
    case 'D': return shaped && types.kind(scalar) == ir::TypeKind::double_;
    case 'L': return shaped && types.kind(scalar) == ir::TypeKind::uint64;
    case 'S': return shaped && types.kind(scalar) == ir::TypeKind::int_;
    case 'B': return shaped && types.kind(scalar) == ir::TypeKind::bool_;
    case 'M': return types.is_matrix(type);
    case 'T': return is_value(types.kind(type));
    case 'f': return type == types.float_;
    case 'u': return type == types.uint;
    case 'i': return type == types.int_;
    case 'b': return type == types.bool_;
    case '2': return types.is_vector(type) && types.components(type) == 2 && scalar == types.float_;
    case '4': return types.is_vector(type) && types.components(type) == 4 && scalar == types.float_;
    default: return false;
    }
}

ir::TypeId result_of(ir::Types& types, char letter, ir::TypeId argument) {
    switch (letter) {
    case 'b': return types.bool_;
    case 'u': return types.uint;
    case 'v': return types.void_;
    case '2': return types.vector(types.float_, 2);
    case '4': return types.vector(types.float_, 4);
    case 'w': return types.vector(types.uint, 4);
    case 't': return types.matrix(types.scalar_of(argument), types[argument].rows, types[argument].count);
    case '=': return types.scalar_of(argument);
    case 'B': return types.with_scalar(argument, types.bool_);
    case 'S': return types.with_scalar(argument, types.int_);
    case 'U': return types.with_scalar(argument, types.uint);
    case 'D': return types.with_scalar(argument, types.double_);
    case 'L': return types.with_scalar(argument, types.uint64);
    default: return argument;
    }
}

/// The type of the result. Result F with a first parameter U or S is a bit cast: floats in place of integers.
ir::TypeId result_type(ir::Types& types, const Signature& signature, ir::TypeId argument) {
    if (signature.result == 'F' && !signature.params.empty() &&
        (signature.params[0].letter == 'U' || signature.params[0].letter == 'S'))
        return types.with_scalar(argument, types.float_);
    return result_of(types, signature.result, argument);
}

bool is_generic_letter(char letter) {
    return std::string_view("FGVNIJUSRDLBMT").find(letter) != std::string_view::npos;
}

ir::TypeId fixed_type(ir::Types& types, char letter) {
    switch (letter) {
    case 'f': return types.float_;
    case 'u': return types.uint;
    case 'i': return types.int_;
    case 'b': return types.bool_;
    case '2': return types.vector(types.float_, 2);
    case '4': return types.vector(types.float_, 4);
    default: return {};
    }
}

/// Whether the signature gives the result this parameter's type, or that of its elements ('='), so that the expected
/// result type is a hint.
bool has_type_of_result(const Signature& signature, const Shape& shape) {
    return signature.result == shape.letter || signature.result == '=';
}

/// The scalar type hint for literals: that of the other arguments, else of the expected type, else float for the
/// letters of floating types, double for D and uint64 for L. Absent for other letters: literals keep their own types.
ir::TypeId literal_hint(ir::Types& types, char letter, ir::TypeId common, ir::TypeId wanted) {
    if (common) return types.scalar_of(common);
    if (wanted && accepts(types, letter, wanted)) return types.scalar_of(wanted);
    if (letter == 'F' || letter == 'G' || letter == 'V' || letter == 'R') return types.float_;
    if (letter == 'D') return types.double_;
    if (letter == 'L') return types.uint64;
    return {};
}

Operand wrong_argument(Body& body, ir::Intrinsic intrinsic, char letter, Span span, ir::TypeId type) {
    Diagnostic& diagnostic =
        body.context.error(Diag::intrinsic_argument, span, {ir::name_of(intrinsic), body.context.text(type)});
    note_optional(body, diagnostic, span, type);
    const ir::TypeId scalar = body.types().scalar_of(type);
    if (letter == 'G' && scalar == body.types().double_)
        note(diagnostic, span, "devices have this function for float and half only: convert the argument");
    if (letter == 'J' && body.types().is_integer(scalar))
        note(diagnostic, span, "devices have this function for 32 bits only: uint(x) and uint(x >> 32) are the halves");
    return error_operand(span);
}

/// abs(x) and sign(x) for unsigned x, which GLSL does not have: x and min(x, 1).
std::optional<ir::ExprId> of_unsigned(Body& body, ir::Intrinsic intrinsic, const ir::Operands& operands, Span span) {
    if (intrinsic != ir::Intrinsic::abs && intrinsic != ir::Intrinsic::sign) return std::nullopt;
    ir::Types& types = body.types();
    const ir::TypeId type = body.program().exprs[operands[0]].type, scalar = types.scalar_of(type);
    if (!types.is_integer(scalar) || types.is_signed(scalar)) return std::nullopt;
    if (intrinsic == ir::Intrinsic::abs) return operands[0];
    ir::ExprId one = add(body.program(), ir::Op::constant, scalar, span);
    body.program().exprs[one].bits = 1;
    if (type != scalar) one = add(body.program(), ir::Op::construct, type, span, {one});
    const ir::ExprId least = add(body.program(), ir::Op::intrinsic, type, span, {operands[0], one});
    body.program().exprs[least].intrinsic = ir::Intrinsic::min;
    return least;
}

/// Whether the expression has at most `left` nodes, which calculate with variables and constants; takes their number
/// off.
bool is_short(const ir::Program& program, ir::ExprId id, int& left) {
    const ir::Expr& expr = program.exprs[id];
    const bool calculates = expr.op == ir::Op::local || expr.op == ir::Op::constant || expr.op == ir::Op::construct ||
                            expr.op == ir::Op::swizzle || expr.op == ir::Op::unary || expr.op == ir::Op::binary;
    if (!calculates || --left < 0) return false;
    return std::ranges::all_of(expr.operands, [&](ir::ExprId operand) { return is_short(program, operand, left); });
}

/// The value as an expression that may stand in several places.
ir::ExprId repeatable(Body& body, ir::ExprId value, Span span) {
    int most = 8;
    if (is_short(body.program(), value, most) || !body.block) return value;
    if (body.kind != BodyKind::pipeline)
        return make_local(body.program(), emit_temporary(body, "v", value, span), span);
    settle(body);
    return value;
}

ir::ExprId length_of(Body& body, ir::ExprId vector, Span span) {
    ir::Program& p = body.program();
    const ir::TypeId scalar = p.types.scalar_of(p.exprs[vector].type);
    const ir::ExprId square = add(p, ir::Op::intrinsic, scalar, span, {vector, vector});
    p.exprs[square].intrinsic = ir::Intrinsic::dot;
    const ir::ExprId root = add(p, ir::Op::intrinsic, scalar, span, {square});
    p.exprs[root].intrinsic = ir::Intrinsic::sqrt;
    return root;
}

/// length, distance and normalize, which devices round differently, as exact operations: sqrt(dot(v, v)), the length of
/// the difference, v * (1 / length(v)). Absent for other functions.
std::optional<ir::ExprId> composed(Body& body, ir::Intrinsic intrinsic, const ir::Operands& operands, Span span) {
    ir::Program& p = body.program();
    const bool is_distance = intrinsic == ir::Intrinsic::distance, is_normal = intrinsic == ir::Intrinsic::normalize;
    if (!is_distance && !is_normal && intrinsic != ir::Intrinsic::length) return std::nullopt;
    const ir::TypeId type = p.exprs[operands[0]].type, scalar = p.types.scalar_of(type);
    ir::ExprId vector = operands[0];
    if (is_distance) vector = make_binary(p, ir::BinaryOp::subtract, type, vector, operands[1], span);
    vector = repeatable(body, vector, span);
    const ir::ExprId length = length_of(body, vector, span);
    if (!is_normal) return length;
    const ir::ExprId one = add(p, ir::Op::constant, scalar, span);
    p.exprs[one].number = 1;
    ir::ExprId factor = make_binary(p, ir::BinaryOp::divide, scalar, one, length, span);
    if (type != scalar) factor = add(p, ir::Op::construct, type, span, {factor});
    return make_binary(p, ir::BinaryOp::multiply, type, vector, factor, span);
}

}  // namespace

std::optional<ir::Intrinsic> find_intrinsic(std::string_view name) {
    static const auto table = [] {
        std::unordered_map<std::string_view, ir::Intrinsic> names;
#define INTRINSIC(name, signature, exactness) names.emplace(#name, ir::Intrinsic::name);
#include "ir/intrinsics.def"
#undef INTRINSIC
        return names;
    }();
    auto found = table.find(name);
    return found == table.end() ? std::nullopt : std::optional(found->second);
}

/// The element type of the structure at a place in a kernel or a function.
static ir::TypeId element_at(const Body& body, const ir::Place& place) {
    const ir::StructureId structure =
        body.kernel ? body.kernel->params[place.root].structure : body.structures[place.root];
    const ir::Program& p = body.context.program;
    return ir::structure_at(p, p.structures[structure], place.members).element;
}

// long: a case for each kind of built-in function
Operand call_intrinsic(Body& body, ir::Intrinsic intrinsic, const std::vector<ast::ExprId>& arguments,
                       const ast::Expr& call, ir::TypeId wanted) {
    Context& c = body.context;
    ir::Types& types = body.types();
    Signature signature = read(ir::signature_of(intrinsic));
    std::string name(ir::name_of(intrinsic));
    if (signature.params.size() != arguments.size()) {
        Diagnostic& diagnostic =
            c.error(Diag::argument_count, call.span,
                    {name, std::to_string(signature.params.size()), std::to_string(arguments.size())});
        const bool is_of_all = intrinsic == ir::Intrinsic::min || intrinsic == ir::Intrinsic::max;
        if (is_of_all && arguments.size() == 1)
            note(diagnostic, call.span,
                 "it compares two values; the pipelines 'minimum' and 'maximum' of std.reduce go through all elements "
                 "of "
                 "a structure");
        return error_operand(call.span);
    }
    if (signature.subgroup && !body.grouped()) {
        note(c.error(Diag::needs_group, call.span, {name}), call.span,
             "write 'group(size)' after the kernel's parameters");
        return error_operand(call.span);
    }
    if (ir::is_derivative(intrinsic) && !is_in_part(body, ir::Part::fragment, name, call.span))
        return error_operand(call.span);
    const Parts parts(body);
    ir::Operands operands;
    operands.assign(arguments.size(), {});
    std::vector<Steps> steps(arguments.size());
    ir::TypeId common;
    for (int round = 0; round < 2; ++round) {
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const bool flexible = typing_of(c, arguments[i]) != Typing::own;
            if (flexible != (round == 1)) continue;
            const Shape& shape = signature.params[i];
            const ir::TypeId fixed = fixed_type(types, shape.letter);
            const ir::TypeId like_result =
                has_type_of_result(signature, shape) ? operand_hint(types, wanted) : ir::TypeId{};
            const ir::TypeId hint = flexible ? literal_hint(types, shape.letter, common, like_result)
                                    : common ? common
                                             : like_result;
            const Recording recording(body, steps[i]);
            operands[i] = fixed ? check_value(body, arguments[i], fixed) : check_hinted(body, arguments[i], hint);
            if (is_error(body, operands[i])) return error_operand(call.span);
            ir::TypeId type = body.program().exprs[operands[i]].type;
            if (!accepts(types, shape.letter, type))
                return wrong_argument(body, intrinsic, shape.letter, c[arguments[i]].span, type);
            if (is_generic_letter(shape.letter) && (!common || types.components(type) > types.components(common)))
                common = type;
        }
    }
    for (std::size_t i = 0; i < operands.size(); ++i) {
        append(body, std::move(steps[i]));
        if (signature.atomic && i == 0) is_target(body, operands[0]);
    }
    ir::TypeId first = operands.empty() ? types.bool_ : body.program().exprs[operands[0]].type;
    if (signature.params.size() && signature.params[0].or_scalar && common) first = common;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        const Shape& shape = signature.params[i];
        if (!is_generic_letter(shape.letter)) continue;
        ir::TypeId type = body.program().exprs[operands[i]].type;
        if (type == common) continue;
        bool scalar = types.is_scalar(type) && type == types.scalar_of(common);
        // A literal beside vectors is broadcast; so is a scalar where GLSL accepts one.
        if (!scalar || !(shape.or_scalar || is_flexible(c, arguments[i])))
            return wrong_argument(body, intrinsic, shape.letter, c[arguments[i]].span, type);
        operands[i] = add(body.program(), ir::Op::construct, common, call.span, {operands[i]});
    }
    if (signature.atomic) {
        const ir::Expr& root = ir::place_of(body.program(), operands[0]);
        bool shared = root.op == ir::Op::local && body.program().locals[root.local].storage == ir::Storage::shared;
        const bool is_scalar = types.is_scalar(body.program().exprs[operands[0]].type);
        bool is_coherent = root.op == ir::Op::read && body.is_coherent(root.place) && is_scalar &&
                           root.type == element_at(body, root.place);
        if (!shared && !is_coherent) {
            c.error(Diag::atomic_target, c[arguments[0]].span, {name});
            return error_operand(call.span);
        }
    }
    if (auto value = of_unsigned(body, intrinsic, operands, call.span)) return value_operand(body, *value, call.span);
    if (auto value = composed(body, intrinsic, operands, call.span)) return value_operand(body, *value, call.span);
    ir::TypeId type =
        result_type(types, signature,
                    common && !operands.empty() && is_generic_letter(signature.params[0].letter) ? common : first);
    ir::ExprId result = add(body.program(), ir::Op::intrinsic, type, call.span, std::move(operands));
    body.program().exprs[result].intrinsic = intrinsic;
    if (signature.atomic) add_effect(body, result);
    return value_operand(body, result, call.span);
}

}  // namespace gliftc::sema
