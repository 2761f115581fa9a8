// Expressions as C++, with parentheses only where C++ or a careful reader needs them.
#include "base/concat.h"
#include "emit/cpp/printer.h"
#include "ir/walk.h"

#include <algorithm>
#include <cmath>

namespace gliftc::cpp {

namespace {

using ir::BinaryOp;
using ir::Expr;
using ir::ExprId;
using ir::Op;
using ir::TypeId;
using ir::TypeKind;

struct Operator {
    const char* text;
    Level level;
    /// The loosest level of an operand that needs no parentheses; if it is `level`, the right operand must be tighter.
    Level operand;
};

Operator operator_of(BinaryOp op) {
    switch (op) {
    case BinaryOp::multiply: return {" * ", Level::term, Level::term};
    case BinaryOp::divide: return {" / ", Level::term, Level::term};
    case BinaryOp::remainder: return {" % ", Level::term, Level::term};
    case BinaryOp::add: return {" + ", Level::sum, Level::sum};
    case BinaryOp::subtract: return {" - ", Level::sum, Level::sum};
    case BinaryOp::shift_left: return {" << ", Level::shift, Level::unary};
    case BinaryOp::shift_right: return {" >> ", Level::shift, Level::unary};
    case BinaryOp::less: return {" < ", Level::relation, Level::shift};
    case BinaryOp::less_equal: return {" <= ", Level::relation, Level::shift};
    case BinaryOp::greater: return {" > ", Level::relation, Level::shift};
    case BinaryOp::greater_equal: return {" >= ", Level::relation, Level::shift};
    case BinaryOp::equal: return {" == ", Level::equality, Level::shift};
    case BinaryOp::not_equal: return {" != ", Level::equality, Level::shift};
    case BinaryOp::bit_and: return {" & ", Level::bit_and, Level::unary};
    case BinaryOp::bit_xor: return {" ^ ", Level::bit_xor, Level::unary};
    case BinaryOp::bit_or: return {" | ", Level::bit_or, Level::unary};
    case BinaryOp::logical_and: return {" && ", Level::logical_and, Level::equality};
    case BinaryOp::logical_or: return {" || ", Level::logical_or, Level::equality};
    }
    return {" ? ", Level::ternary, Level::postfix};
}

Text function_call(Printer& p, const std::string& name, const ir::Operands& operands) {
    return {concat(name, "(", join_arguments(p, operands), ")")};
}

bool is_scalar_integer(const Printer& p, TypeId type) { return p.program.types.is_integer(type); }

/// Whether the expression is a constant by which C++ may divide any integer: neither 0 nor -1.
bool is_safe_divisor(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    if (expr.op != Op::constant || expr.bits == 0) return false;
    return !(p.program.types.is_signed(expr.type) && static_cast<std::int64_t>(expr.bits) == -1) &&
           !(p.program.types.kind(expr.type) == TypeKind::int_ && static_cast<std::int32_t>(expr.bits) == -1);
}

/// Whether the expression is the constant 0, and not -0.
bool is_zero(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    return expr.op == Op::constant && expr.bits == 0 && expr.number == 0 && !std::signbit(expr.number);
}

Text print_shift(Printer& p, const Expr& expr, Operator op) {
    const Expr& amount = p.program.exprs[expr.operands[1]];
    const TypeKind kind = p.program.types.kind(expr.type);
    const unsigned width = kind == TypeKind::int64 || kind == TypeKind::uint64 ? 64 : 32;
    const std::string left = print(p, expr.operands[0], Level::unary);
    if (amount.op == Op::constant) return {left + op.text + std::to_string(amount.bits & (width - 1)), op.level};
    return {left + op.text + "(" + print(p, expr.operands[1], Level::unary) + " & " + std::to_string(width - 1) + ")",
            op.level};
}

Text print_binary(Printer& p, const Expr& expr) {
    const Operator op = operator_of(expr.binary);
    const bool scalar = is_scalar_integer(p, expr.type);
    switch (expr.binary) {
    case BinaryOp::divide:
        if (scalar && !is_safe_divisor(p, expr.operands[1])) return function_call(p, "glift::divide", expr.operands);
        break;
    case BinaryOp::remainder:
        if (!p.program.types.is_vector(expr.type) && !(scalar && is_safe_divisor(p, expr.operands[1])))
            return function_call(p, "glift::remainder", expr.operands);
        break;
    case BinaryOp::shift_left:
    case BinaryOp::shift_right:
        if (scalar) return print_shift(p, expr, op);
        break;
    case BinaryOp::subtract:
        if (p.program.types.is_floating(expr.type) && is_zero(p, expr.operands[0]))
            return function_call(p, "glift::subtract", expr.operands);
        break;
    case BinaryOp::multiply:
    case BinaryOp::add:
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
    // The left operand also needs no parentheses if its operator is the same (a && b && c) or, in sums and products,
    // another one of the same level (a + b - c). A shift in a shift and a comparison in a comparison always get them.
    Text left = print(p, expr.operands[0]);
    const Expr& first = p.program.exprs[expr.operands[0]];
    const bool chain = first.op == Op::binary && left.level == op.level &&
                       operator_of(first.binary).level == op.level &&
                       (first.binary == expr.binary || op.level == Level::sum || op.level == Level::term) &&
                       op.level != Level::shift && op.level != Level::relation && op.level != Level::equality;
    const Level right = static_cast<Level>(static_cast<int>(op.operand) + (op.operand == op.level ? 1 : 0));
    const std::string first_text = chain ? std::move(left.text) : wrap(std::move(left), op.operand);
    return {concat(first_text, op.text, print(p, expr.operands[1], right)), op.level};
}

Text print_convert(Printer& p, const Expr& expr) {
    const ir::Types& types = p.program.types;
    const TypeId from = p.program.exprs[expr.operands[0]].type;
    const std::string to = type_text(p.globals, expr.type);
    const std::string operand = print_any(p, expr.operands[0]);
    if (from == expr.type) return print(p, expr.operands[0]);
    if (types.is_vector(expr.type) || types.is_matrix(expr.type)) return {to + "(" + operand + ")"};
    const bool to_integer = types.is_integer(expr.type) || types.kind(expr.type) == TypeKind::enum_;
    if (types.kind(expr.type) == TypeKind::bool_ || (to_integer && types.is_floating(from)))
        return {"glift::convert<" + to + ">(" + operand + ")"};
    return {to + "(" + operand + ")"};
}

Text print_construct(Printer& p, const Expr& expr) {
    const ir::Type& type = p.program.types[expr.type];
    const std::string name = type_text(p.globals, expr.type);
    switch (type.kind) {
    case TypeKind::array:
        if (std::ranges::all_of(expr.operands, [&](ExprId operand) { return is_zero(p, operand); }))
            return {name + "{}"};
        return {name + "{{" + join_arguments(p, expr.operands) + "}}"};
    case TypeKind::struct_: return {name + "{" + join_arguments(p, expr.operands) + "}"};
    case TypeKind::matrix: {
        if (expr.operands.size() == type.count) return {name + "{{" + join_arguments(p, expr.operands) + "}}"};
        std::string columns;
        for (std::uint32_t c = 0; c < type.count; ++c) {
            std::string column;
            for (std::uint32_t r = 0; r < type.rows; ++r)
                column += (r ? ", " : "") + print_any(p, expr.operands[std::size_t{c} * type.rows + r]);
            columns += (c ? ", {" : "{") + column + "}";
        }
        return {name + "{{" + columns + "}}"};
    }
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::bool_:
    case TypeKind::int_:
    case TypeKind::uint:
    case TypeKind::float_:
    case TypeKind::half:
    case TypeKind::double_:
    case TypeKind::int64:
    case TypeKind::uint64:
    case TypeKind::vector:
    case TypeKind::enum_:
    case TypeKind::optional:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: break;
    }
    return {name + "(" + join_arguments(p, expr.operands) + ")"};
}

Text print_swizzle(Printer& p, const Expr& expr) {
    const std::uint32_t count = p.program.types.components(expr.type);
    const std::string vector = print(p, expr.operands[0], Level::postfix);
    static constexpr char letters[] = "xyzw";
    if (p.program.types.components(p.program.exprs[expr.operands[0]].type) == 1) {
        if (count == 1) return {vector};
        return {type_text(p.globals, expr.type) + "(" + vector + ")"};
    }
    if (count == 1) return {concat(vector, ".", std::string_view(letters + expr.lanes[0], 1))};
    bool in_order = count < p.program.types.components(p.program.exprs[expr.operands[0]].type);
    std::string lanes, name;
    for (std::uint32_t i = 0; i < count; ++i) {
        in_order = in_order && expr.lanes[i] == expr.lanes[0] + i;
        lanes += (i ? ", " : "") + std::to_string(expr.lanes[i]);
        name += letters[expr.lanes[i]];
    }
    if (in_order) return {vector + "." + name + "()"};
    return {"glift::swizzle<" + lanes + ">(" + vector + ")"};
}

/// The value of a part of a struct or an array. These hold bools as memory does, so vectors of bools are converted to
/// the type that values have.
std::string as_value(Printer& p, const Expr& part, std::string text) {
    if (!is_bool_vector(p.program, part.type)) return text;
    return concat(type_text(p.globals, part.type), "(", text, ")");
}

/// One side of `?:`. A bool as memory holds it (glift::Bool) is converted to bool: if the other side is a bool, C++
/// could convert either to the other, which is an error.
std::string print_side(Printer& p, ExprId id, Level least) {
    const Expr& expr = p.program.exprs[id];
    const bool lies_in_memory =
        expr.op == Op::field || expr.op == Op::index || expr.op == Op::load || expr.op == Op::row_load;
    if (!lies_in_memory || expr.type != p.program.types.bool_) return print(p, id, least);
    return concat("bool(", print_any(p, id), ")");
}

Text print_index(Printer& p, const Expr& expr) {
    const Expr& index = p.program.exprs[expr.operands[1]];
    const std::string base = print(p, expr.operands[0], Level::postfix);
    if (index.op == Op::constant && p.program.types.is_vector(p.program.exprs[expr.operands[0]].type) && index.bits < 4)
        return {base + "." + "xyzw"[index.bits]};
    std::string text = base + "[" + print_any(p, expr.operands[1]) + "]";
    const bool is_of_array = p.program.types.kind(p.program.exprs[expr.operands[0]].type) == TypeKind::array;
    return {is_of_array ? as_value(p, expr, std::move(text)) : std::move(text)};
}

/// An element of memory, or a part of one, as an lvalue.
std::string print_place(Printer& p, ir::ExprId id) {
    const Expr& expr = p.program.exprs[id];
    if (expr.op == Op::load || expr.op == Op::row_load || expr.op == Op::image_load) return p.outer_place(expr);
    const std::string base = print_place(p, expr.operands[0]);
    const ir::TypeId whole = p.program.exprs[expr.operands[0]].type;
    if (expr.op == Op::field) return base + "." + p.globals.field_names[p.program.types[whole].struct_][expr.slot];
    if (expr.op == Op::index) return base + "[" + print_any(p, expr.operands[1]) + "]";
    return p.program.types.is_vector(whole) ? base + "." + "xyzw"[expr.lanes[0]] : base;
}

Text print_intrinsic(Printer& p, const Expr& expr) {
    const std::string name(ir::name_of(expr.intrinsic));
    if (ir::is_derivative(expr.intrinsic) && p.outer_expression) return p.outer_expression(expr);
    if (!name.starts_with("atomic")) return function_call(p, "glift::" + name, expr.operands);
    const Expr& place = ir::place_of(p.program, expr.operands[0]);
    if (place.op != Op::load && place.op != Op::row_load && place.op != Op::image_load)
        return function_call(p, "glift::host::" + name, expr.operands);
    std::string text = "glift::host::memory::" + name + "(" + print_place(p, expr.operands[0]);
    for (std::size_t i = 1; i < expr.operands.size(); ++i) text += ", " + print_any(p, expr.operands[i]);
    return {text + ")"};
}

std::string name_of_function(Printer& p, ir::FunctionId function) {
    if (const auto found = p.local_functions.find(function); found != p.local_functions.end()) return found->second;
    require_function(p.globals, function);
    return visible(p, p.globals.function_names.at(function));
}

/// Prints the call of a function: structures are passed before values.
Text print_call(Printer& p, const Expr& expr) {
    if (p.outer_call && !expr.places.empty())
        if (const std::string name = p.outer_call(expr); !name.empty())
            return {name + "(" + join_arguments(p, expr.operands) + ")"};
    const std::string name = name_of_function(p, expr.function);
    std::string arguments;
    for (const ir::Place& place : expr.places) {
        Expr whole;
        whole.op = Op::structure_value;
        whole.place = place;
        whole.local = expr.local;
        arguments += (arguments.empty() ? "" : ", ") + p.outer_expression(whole).text;
    }
    const std::string values = join_arguments(p, expr.operands);
    if (!arguments.empty() && !values.empty()) arguments += ", ";
    return {name + "(" + arguments + values + ")"};
}

Text print_local(Printer& p, ir::LocalId local) {
    if (p.outer_local) {
        if (std::string text = p.outer_local(local); !text.empty()) return {text};
    }
    if (auto found = p.local_names.find(local); found != p.local_names.end()) return {found->second};
    return {declare_local(p, local)};
}

}  // namespace

std::string wrap(Text&& text, Level least) {
    return text.level < least ? concat("(", text.text, ")") : std::move(text.text);
}

std::string print(Printer& p, ExprId expr, Level least) { return wrap(print(p, expr), least); }

std::string print_any(Printer& p, ExprId expr) { return print(p, expr).text; }

std::string join_arguments(Printer& p, const ir::Operands& arguments) {
    std::string text;
    for (ExprId argument : arguments) {
        if (!text.empty()) text += ", ";
        text += print_any(p, argument);
    }
    return text;
}

Text print(Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    switch (expr.op) {
    case Op::constant: {
        std::string text = literal(p.program, expr.type, expr.bits, expr.number);
        const Level level = text.starts_with('-') ? Level::unary : Level::postfix;
        return {std::move(text), level};
    }
    case Op::local: return print_local(p, expr.local);
    case Op::construct: return print_construct(p, expr);
    case Op::convert: return print_convert(p, expr);
    case Op::unary: {
        const char* sign = expr.unary == ir::UnaryOp::minus ? "-" : expr.unary == ir::UnaryOp::logical_not ? "!" : "~";
        std::string operand = print(p, expr.operands[0], Level::unary);
        if (operand.starts_with(sign)) operand = "(" + operand + ")";
        return {sign + operand, Level::unary};
    }
    case Op::binary: return print_binary(p, expr);
    case Op::select: {
        const std::string condition = print(p, expr.operands[0], Level::logical_or);
        const std::string yes = print_side(p, expr.operands[1], Level::logical_or);
        return {concat(condition, " ? ", yes, " : ", print_side(p, expr.operands[2], Level::ternary)), Level::ternary};
    }
    case Op::swizzle: return print_swizzle(p, expr);
    case Op::index: return print_index(p, expr);
    case Op::field: {
        const ir::Type& type = p.program.types[p.program.exprs[expr.operands[0]].type];
        std::string text =
            concat(print(p, expr.operands[0], Level::postfix), ".", p.globals.field_names[type.struct_][expr.slot]);
        return {as_value(p, expr, std::move(text))};
    }
    case Op::call: return print_call(p, expr);
    case Op::intrinsic: return print_intrinsic(p, expr);
    case Op::none: return {type_text(p.globals, expr.type) + "()"};
    case Op::some: return function_call(p, type_text(p.globals, expr.type), expr.operands);
    case Op::has_value: return {print(p, expr.operands[0], Level::postfix) + ".has_value()"};
    case Op::value: return {"*" + print(p, expr.operands[0], Level::unary), Level::unary};
#define SHAPE_OPERATION(name) case Op::name:
#define STRUCTURE_OPERATION(name) case Op::name:
#define GUARDED_OPERATION(name) case Op::name:
#define HOST_OPERATION(name) case Op::name:
#define MEMORY_OPERATION(name) case Op::name:
#define CPU_OPERATION(name) case Op::name:
#include "ir/operations.def"
        return p.outer_expression(expr);
    }
    return p.outer_expression(expr);
}

}  // namespace gliftc::cpp
