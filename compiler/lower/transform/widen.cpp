// long: one walk, with a case for each kind of expression and statement
#include "lower/transform/widen.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace gliftc::lower {

using namespace ir;

namespace {

/// What happens to a number beyond 2^64 - 1: in copies of translators it wraps around, in extents it stays at 2^64 - 1.
enum class Overflow : std::uint8_t { wraps, saturates };

/// An expression in the copy: either `narrow`, in its original type, or `wide`, in 64 bits, if a uint in it may exceed
/// 2^32 - 1. The other one is absent.
struct Value {
    ExprId narrow, wide;
};

/// How a copy holds a local or a function's result. narrow: as the original does. wide: in 64 bits. exact: in 64 bits,
/// of which only sums and the like (Widener::exact) use the upper 32.
enum class Width : std::uint8_t { narrow, exact, wide };

struct Copied {
    LocalId id;
    Width width = Width::narrow;
};

/// What the result of a function is: not an address; the address in memory that a translator gives, to which nothing is
/// added; or one that the next stage translates, in which a negative number must stay one.
enum class Address : std::uint8_t { none, physical, intermediate };

/// The 64-bit copy of a function; the function itself if nothing in it is in 64 bits.
struct Copy {
    FunctionId id;
    Width result = Width::narrow;
};

class Widener {
public:
    Widener(Program& program, Overflow overflow) : p(program), overflow_(overflow) {}

    Value value(ExprId id) { return visit(p.exprs[id]); }
    ExprId widened(const Value& value);
    Copy copied(FunctionId id, const std::vector<Width>& params, Address address = Address::none);

private:
    /// The function that is being copied.
    struct Frame {
        std::unordered_map<LocalId, Copied> locals;
        std::vector<std::pair<StmtId, Value>> returns;
        bool has_wide = false;
    };

    Value visit(Expr node);
    Value local(const Expr& node);
    Value construct(Expr node);
    Value conversion(Expr node);
    Value unary(Expr node);
    Value binary(Expr node);
    Value shift(Expr node);
    Value part(Expr node);
    Value call(Expr node);
    Value intrinsic(Expr node);
    Value optional(Expr node);
    Value extent(Expr node);
    Value rebuilt(Expr node);
    Value joined(Expr node, const std::vector<Value>& values);
    Value grown(const Expr& node, ExprId a, ExprId b);
    ExprId narrowed(const Value& value);
    ExprId exact(const Value& value);
    bool wraps(const Expr& narrow) const;
    ExprId convert(TypeId type, ExprId id);
    ExprId made(Op op, TypeId type, Operands operands);
    ExprId remade(ExprId optional, TypeId type);
    ExprId called(const char* name, TypeId result, Operands operands);
    ExprId target(ExprId id);

    std::vector<StmtId> body(const std::vector<StmtId>& statements);
    void rewrite(const Stmt& stmt, Stmt& made);
    void declare(const Stmt& stmt, Stmt& made);
    Value note(ExprId wide) {
        if (frame_ != nullptr) frame_->has_wide = true;
        return {{}, wide};
    }

    TypeId wide_type(TypeId type);
    bool is_widenable(TypeId type) { return wide_type(type) != type; }
    bool is_uint(ExprId id) { return p.types.scalar_of(p.exprs[id].type) == p.types.uint; }
    ExprId add(Expr node) { return p.exprs.add(std::move(node)); }

    Program& p;
    Overflow overflow_;
    Frame* frame_ = nullptr;
    std::map<std::tuple<std::uint32_t, std::vector<Width>, Address>, Copy> copies_;
    std::map<std::pair<std::string, std::vector<std::uint32_t>>, FunctionId> externs_;  ///< by name and types
};

/// uint64 for uint, also in vectors and optionals; other types as they are.
TypeId Widener::wide_type(TypeId type) {
    if (p.types.kind(type) == TypeKind::optional) {
        const TypeId element = p.types[type].element, wide = wide_type(element);
        return wide == element ? type : p.types.optional(wide);
    }
    const bool is_number = type == p.types.uint || p.types.is_vector(type);
    return is_number && p.types.scalar_of(type) == p.types.uint ? p.types.with_scalar(type, p.types.uint64) : type;
}

ExprId Widener::convert(TypeId type, ExprId id) {
    Expr node;
    node.op = Op::convert;
    node.type = type;
    node.span = p.exprs[id].span;
    node.operands = {id};
    return add(std::move(node));
}

ExprId Widener::made(Op op, TypeId type, Operands operands) {
    Expr node;
    node.op = op;
    node.type = type;
    node.operands = std::move(operands);
    return add(std::move(node));
}

/// Converts an optional to the optional type `type`.
ExprId Widener::remade(ExprId optional, TypeId type) {
    const TypeId element = p.types[type].element;
    const ExprId inner = made(Op::value, p.types[p.exprs[optional].type].element, {optional});
    return made(Op::select, type,
                {made(Op::has_value, p.types.bool_, {optional}), made(Op::some, type, {convert(element, inner)}),
                 made(Op::none, type, {})});
}

/// A call of a C++ function of the runtime, glift::NAME.
ExprId Widener::called(const char* name, TypeId result, Operands operands) {
    std::vector<std::uint32_t> types{result.index};
    for (ExprId operand : operands) types.push_back(p.exprs[operand].type.index);
    FunctionId& function = externs_[{name, std::move(types)}];
    if (!function) {
        Function made;
        made.name = p.names->intern(name);
        made.extern_name = std::string("glift::") + name;
        made.result = result;
        for (ExprId operand : operands) {
            Local param;
            param.name = made.name;
            param.type = p.exprs[operand].type;
            made.params.push_back(p.locals.add(std::move(param)));
        }
        function = p.functions.add(std::move(made));
    }
    Expr node;
    node.op = Op::call;
    node.type = result;
    node.function = function;
    node.operands = std::move(operands);
    return add(std::move(node));
}

ExprId Widener::widened(const Value& value) {
    if (value.wide) return value.wide;
    Expr node = p.exprs[value.narrow];
    const TypeId type = wide_type(node.type);
    if (type == node.type) return value.narrow;
    if (node.op == Op::constant || node.op == Op::none) {
        node.type = type;
        return add(std::move(node));
    }
    if (p.types.kind(type) == TypeKind::optional) return remade(value.narrow, type);
    if (node.op == Op::convert && p.types.is_signed(p.types.scalar_of(p.exprs[node.operands[0]].type)))
        return convert(type, node.operands[0]);
    return convert(type, value.narrow);
}

/// Whether the 32-bit value may have wrapped around at 2^32, because the exact number may be negative or have more
/// bits. This may be so for a conversion from a signed or 64-bit number (which is also how a local, parameter or result
/// of Width::exact is read), for a complement, in translators also for a difference or a negation; and for selects,
/// vectors and components of vectors that are made of these.
bool Widener::wraps(const Expr& narrow) const {
    const auto operand_wraps = [&](ExprId operand) { return wraps(p.exprs[operand]); };
    switch (narrow.op) {
    case Op::convert: {
        const TypeId from = p.types.scalar_of(p.exprs[narrow.operands[0]].type);
        return p.types.scalar_of(narrow.type) == p.types.uint && (p.types.is_signed(from) || from == p.types.uint64);
    }
    case Op::unary:
        return p.types.scalar_of(narrow.type) == p.types.uint &&
               (narrow.unary == UnaryOp::bit_not || overflow_ == Overflow::wraps);
    case Op::binary:
        return narrow.binary == BinaryOp::subtract && overflow_ == Overflow::wraps &&
               p.types.scalar_of(narrow.type) == p.types.uint;
    case Op::select: return operand_wraps(narrow.operands[1]) || operand_wraps(narrow.operands[2]);
    case Op::construct: return p.types.is_vector(narrow.type) && std::ranges::any_of(narrow.operands, operand_wraps);
    case Op::swizzle: return operand_wraps(narrow.operands[0]);
    case Op::index: return p.types.is_vector(p.exprs[narrow.operands[0]].type) && operand_wraps(narrow.operands[0]);
    default: return false;
    }
}

/// The value in 64 bits as an operand of a sum, product, difference, left shift or bitwise operation: x - 1 for x = 0
/// is 2^64 - 1 there, so that adding it to a 64-bit number subtracts 1.
ExprId Widener::exact(const Value& value) {
    if (value.wide || !wraps(p.exprs[value.narrow])) return widened(value);
    Expr node = p.exprs[value.narrow];
    if (node.op == Op::convert) {
        const ExprId from = node.operands[0];
        const bool is_exact = p.types.scalar_of(p.exprs[from].type) == p.types.uint64;
        return is_exact ? note(from).wide : widened(value);
    }
    node.type = wide_type(node.type);
    for (std::size_t i = 0; i < node.operands.size(); ++i) {
        const bool is_index = node.op == Op::index && i == 1;
        ExprId& operand = node.operands[i];
        if (!is_index && is_widenable(p.exprs[operand].type)) operand = exact({operand, {}});
    }
    return add(std::move(node));
}

/// The value in its original type: the low 32 bits; for extents, unless it is an optional, a call that throws an error
/// if the value does not fit.
ExprId Widener::narrowed(const Value& value) {
    if (value.narrow) return value.narrow;
    const TypeId wide = p.exprs[value.wide].type;
    if (p.types.kind(wide) == TypeKind::optional)
        return remade(value.wide, p.types.optional(p.types.with_scalar(p.types[wide].element, p.types.uint)));
    const TypeId type = p.types.with_scalar(wide, p.types.uint);
    return overflow_ == Overflow::wraps ? convert(type, value.wide) : called("fitted", type, {value.wide});
}

Value Widener::visit(Expr node) {
    switch (node.op) {
    case Op::constant: return {add(std::move(node)), {}};
    case Op::local: return local(node);
    case Op::construct: return construct(std::move(node));
    case Op::convert: return conversion(std::move(node));
    case Op::unary: return unary(std::move(node));
    case Op::binary: return binary(std::move(node));
    case Op::swizzle:
    case Op::index: return part(std::move(node));
    case Op::select: {
        const Value condition = value(node.operands[0]);
        std::vector<Value> values{condition, value(node.operands[1]), value(node.operands[2])};
        return joined(std::move(node), values);
    }
    case Op::call: return call(std::move(node));
    case Op::intrinsic: return intrinsic(std::move(node));
    case Op::none:
    case Op::some:
    case Op::has_value:
    case Op::value: return optional(std::move(node));
    case Op::memory_extent: return extent(std::move(node));
    default: return rebuilt(std::move(node));
    }
}

Value Widener::local(const Expr& node) {
    const auto found = frame_ == nullptr ? decltype(frame_->locals)::iterator{} : frame_->locals.find(node.local);
    if (frame_ == nullptr || found == frame_->locals.end()) return {add(node), {}};
    Expr copy = node;
    copy.local = found->second.id;
    copy.type = p.locals[copy.local].type;
    const ExprId id = add(std::move(copy));
    switch (found->second.width) {
    case Width::narrow: return {id, {}};
    case Width::exact: return {convert(node.type, id), {}};
    case Width::wide: break;
    }
    return note(id);
}

/// The same operation on operands in their original types (`narrowed`).
Value Widener::rebuilt(Expr node) {
    for (ExprId& operand : node.operands) operand = narrowed(value(operand));
    return {add(std::move(node)), {}};
}

/// The operation on narrow operands if all are narrow; else on 64-bit ones, with a 64-bit result if the original one is
/// of uints.
Value Widener::joined(Expr node, const std::vector<Value>& values) {
    const bool is_wide = std::ranges::any_of(values, [](const Value& each) { return static_cast<bool>(each.wide); });
    for (std::size_t i = 0; i < values.size(); ++i) node.operands[i] = is_wide ? widened(values[i]) : values[i].narrow;
    const TypeId type = is_wide ? wide_type(node.type) : node.type;
    const bool grows = type != node.type;
    node.type = type;
    const ExprId id = add(std::move(node));
    return grows ? note(id) : Value{id, {}};
}

Value Widener::construct(Expr node) {
    if (!is_widenable(node.type)) return rebuilt(std::move(node));
    std::vector<Value> values;
    for (ExprId operand : node.operands) values.push_back(value(operand));
    return joined(std::move(node), values);
}

Value Widener::conversion(Expr node) {
    const Value from = value(node.operands[0]);
    const bool to_uint = p.types.scalar_of(node.type) == p.types.uint;
    if (from.wide && to_uint && p.types.scalar_of(p.exprs[from.wide].type) == p.types.uint64) return from;
    node.operands[0] = from.wide ? from.wide : from.narrow;
    return {add(std::move(node)), {}};
}

Value Widener::unary(Expr node) {
    const Value of = value(node.operands[0]);
    return joined(std::move(node), {of});
}

/// Whether the low bits of the result depend on nothing but the low bits of the operands: then the operation in 64 bits
/// gives the same low 32 bits as that in 32 bits. Not for shifts, which binary() handles before.
bool is_modular(BinaryOp op) {
    switch (op) {
    case BinaryOp::add:
    case BinaryOp::subtract:
    case BinaryOp::multiply:
    case BinaryOp::bit_and:
    case BinaryOp::bit_or:
    case BinaryOp::bit_xor: return true;
    default: return false;
    }
}

/// A sum, product or left shift of uints, in 64 bits.
Value Widener::grown(const Expr& node, ExprId a, ExprId b) {
    const TypeId type = wide_type(node.type);
    if (overflow_ == Overflow::saturates) {
        const char* name = node.binary == BinaryOp::add        ? "saturated_sum"
                           : node.binary == BinaryOp::multiply ? "saturated_product"
                                                               : "saturated_shift";
        return note(called(name, type, {a, b}));
    }
    Expr made = node;
    made.type = type;
    made.operands = {a, b};
    return note(add(std::move(made)));
}

Value Widener::binary(Expr node) {
    const Value a = value(node.operands[0]), b = value(node.operands[1]);
    const bool of_uints = is_uint(node.operands[0]) && is_uint(node.operands[1]);
    if (node.binary == BinaryOp::shift_left || node.binary == BinaryOp::shift_right) {
        node.operands[1] = narrowed(b);
        if (node.binary == BinaryOp::shift_left && is_widenable(node.type))
            return grown(node, exact(a), node.operands[1]);
        if (!a.wide) {
            node.operands[0] = a.narrow;
            return {add(std::move(node)), {}};
        }
        node.operands[0] = a.wide;
        node.type = wide_type(node.type);
        return note(add(std::move(node)));
    }
    const bool grows = node.binary == BinaryOp::add || node.binary == BinaryOp::multiply;
    if (grows && of_uints && is_widenable(node.type)) return grown(node, exact(a), exact(b));
    if (is_modular(node.binary) && (a.wide || b.wide)) return joined(std::move(node), {{{}, exact(a)}, {{}, exact(b)}});
    return joined(std::move(node), {a, b});
}

/// A component of a vector or an element of an array.
Value Widener::part(Expr node) {
    const Value whole = value(node.operands[0]);
    if (node.op == Op::index) node.operands[1] = narrowed(value(node.operands[1]));
    node.operands[0] = whole.wide ? whole.wide : whole.narrow;
    if (!whole.wide) return {add(std::move(node)), {}};
    node.type = wide_type(node.type);
    return note(add(std::move(node)));
}

Value Widener::call(Expr node) {
    if (!p.functions[node.function].extern_name.empty()) return rebuilt(std::move(node));
    std::vector<Width> widths;
    for (ExprId& operand : node.operands) {
        const Value argument = value(operand);
        widths.push_back(argument.wide ? Width::wide : wraps(p.exprs[argument.narrow]) ? Width::exact : Width::narrow);
        operand = widths.back() == Width::narrow ? argument.narrow : exact(argument);
    }
    const Copy copy = copied(node.function, widths);
    node.function = copy.id;
    const TypeId type = node.type;
    if (copy.result != Width::narrow) node.type = wide_type(type);
    const ExprId id = add(std::move(node));
    if (copy.result == Width::exact) return {convert(type, id), {}};
    return copy.result == Width::wide ? note(id) : Value{id, {}};
}

/// Intrinsics that mean the same in any width take 64-bit operands. In extents findMSB does, too. The operands of all
/// others are narrowed to 32 bits.
Value Widener::intrinsic(Expr node) {
    switch (node.intrinsic) {
    case Intrinsic::min:
    case Intrinsic::max:
    case Intrinsic::clamp:
    case Intrinsic::lessThan:
    case Intrinsic::lessThanEqual:
    case Intrinsic::greaterThan:
    case Intrinsic::greaterThanEqual:
    case Intrinsic::equal:
    case Intrinsic::notEqual: {
        std::vector<Value> values;
        for (ExprId operand : node.operands) values.push_back(value(operand));
        return joined(std::move(node), values);
    }
    case Intrinsic::findMSB: {
        const Value of = value(node.operands[0]);
        const bool stays_wide = of.wide && overflow_ == Overflow::saturates;
        node.operands[0] = stays_wide ? of.wide : narrowed(of);
        return {add(std::move(node)), {}};
    }
    default: return rebuilt(std::move(node));
    }
}

Value Widener::optional(Expr node) {
    if (node.op == Op::none) return {add(std::move(node)), {}};
    const Value of = value(node.operands[0]);
    node.operands[0] = of.wide ? of.wide : of.narrow;
    const TypeId type = of.wide ? wide_type(node.type) : node.type;
    const bool grows = type != node.type;
    node.type = type;
    const ExprId id = add(std::move(node));
    return grows ? note(id) : Value{id, {}};
}

/// The extent of a memory: in expressions that are evaluated when structures are made, a scalar one (of buffers and 1-D
/// images) is exact, in 64 bits.
Value Widener::extent(Expr node) {
    if (overflow_ == Overflow::wraps || node.type != p.types.uint) return {add(std::move(node)), {}};
    node.type = p.types.uint64;
    return note(add(std::move(node)));
}

/// The target of an assignment: a local or a part of one.
ExprId Widener::target(ExprId id) {
    const Value made = value(id);
    return made.wide ? made.wide : made.narrow;
}

void Widener::declare(const Stmt& stmt, Stmt& made) {
    const Local before = p.locals[stmt.local];
    Local copy = before;
    Value init;
    if (stmt.value) init = value(stmt.value);
    Width width = Width::narrow;
    if (stmt.op == StmtOp::let && is_widenable(before.type)) {
        // A mutable local may be assigned a wide value later.
        if (before.is_mutable || init.wide) width = Width::wide;
        else if (stmt.value && wraps(p.exprs[init.narrow])) width = Width::exact;
    }
    if (width != Width::narrow) copy.type = wide_type(before.type);
    made.local = p.locals.add(std::move(copy));
    frame_->locals[stmt.local] = {made.local, width};
    if (!stmt.value) return;
    made.value = width == Width::narrow ? narrowed(init) : width == Width::exact ? exact(init) : widened(init);
}

void Widener::rewrite(const Stmt& stmt, Stmt& made) {
    switch (stmt.op) {
    case StmtOp::let: return declare(stmt, made);
    case StmtOp::for_:
        made.limit = narrowed(value(stmt.limit));
        declare(stmt, made);
        break;
    case StmtOp::assign: {
        made.target = target(stmt.target);
        const Value assigned = value(stmt.value);
        const bool is_wide = p.exprs[made.target].type != p.exprs[stmt.target].type;
        made.value = is_wide ? widened(assigned) : narrowed(assigned);
        break;
    }
    default:
        if (stmt.value) made.value = narrowed(value(stmt.value));
        break;
    }
    made.body = body(stmt.body);
    made.otherwise = body(stmt.otherwise);
}

std::vector<StmtId> Widener::body(const std::vector<StmtId>& statements) {
    std::vector<StmtId> result;
    for (StmtId id : statements) {
        const Stmt stmt = p.stmts[id];
        Stmt made = stmt;
        if (stmt.op == StmtOp::return_) {
            Value returned;
            if (stmt.value) returned = value(stmt.value);
            result.push_back(p.stmts.add(std::move(made)));
            if (stmt.value) frame_->returns.emplace_back(result.back(), returned);
            continue;
        }
        rewrite(stmt, made);
        result.push_back(p.stmts.add(std::move(made)));
    }
    return result;
}

/// The copy of a function whose parameters have these widths.
Copy Widener::copied(FunctionId id, const std::vector<Width>& params, Address address) {
    const auto key = std::tuple(id.index, params, address);
    if (const auto found = copies_.find(key); found != copies_.end()) return found->second;
    const Function original = p.functions[id];
    Function made = original;
    Frame frame;
    Frame* const outer = std::exchange(frame_, &frame);
    for (std::size_t i = 0; i < made.params.size(); ++i) {
        Local param = p.locals[original.params[i]];
        if (params[i] != Width::narrow) {
            param.type = wide_type(param.type);
            frame.has_wide = true;
        }
        made.params[i] = p.locals.add(std::move(param));
        frame.locals[original.params[i]] = {made.params[i], params[i]};
    }
    made.body = body(original.body);
    Copy result;
    const bool is_operand = address == Address::intermediate || (address == Address::none && outer != nullptr);
    for (const auto& [stmt, returned] : frame.returns) {
        if (returned.wide) result.result = Width::wide;
        else if (is_operand && result.result == Width::narrow && wraps(p.exprs[returned.narrow]))
            result.result = Width::exact;
    }
    for (const auto& [stmt, returned] : frame.returns)
        p.stmts[stmt].value = result.result == Width::narrow  ? narrowed(returned)
                              : result.result == Width::exact ? exact(returned)
                                                              : widened(returned);
    frame_ = outer;
    if (!frame.has_wide && result.result == Width::narrow) {
        result.id = id;
        return copies_[key] = result;
    }
    if (result.result != Width::narrow) made.result = wide_type(original.result);
    made.name = p.names->intern((*p.names)[original.name] + "_64");
    made.display += " in 64 bits";
    result.id = p.functions.add(std::move(made));
    return copies_[key] = result;
}

}  // namespace

void widen_extents(Program& program) {
    Widener widener(program, Overflow::saturates);
    const auto exact = [&](ExprId& id) {
        const Value value = widener.value(id);
        if (value.wide) id = value.wide;
    };
    for (Structure& structure : program.structures) {
        for (Memory& memory : structure.memories) {
            if (memory.shape == MemoryShape::buffer) memory.extent = widener.widened(widener.value(memory.extent));
            else exact(memory.extent);
        }
        for (MemberStructure& member : structure.members)
            for (ExprId& argument : member.arguments) exact(argument);
    }
}

void widen_translators(Program& program) {
    Widener widener(program, Overflow::wraps);
    for (Structure& structure : program.structures) {
        // Where the memory is a structure, the result is a virtual address, with 32 bits per axis.
        if (!structure.base.empty()) continue;
        Width width = Width::narrow;
        for (Stage& stage : structure.via) {
            const Translator& translator = program.translators[stage.translator];
            const Width given = std::exchange(width, Width::narrow);
            if (translator.physical_type != program.types.uint || !translator.translate) continue;
            const bool is_last = &stage == &structure.via.back();
            const Copy copy =
                widener.copied(translator.translate, {given}, is_last ? Address::physical : Address::intermediate);
            stage.wide = copy.id;
            width = copy.result;
        }
    }
}

}  // namespace gliftc::lower
