// long: one interpreter: expressions, statements and calls run each other
#include "ir/evaluate.h"

#include "base/half.h"

#include <bit>
#include <cmath>
#include <utility>

namespace gliftc::ir {

namespace {

constexpr std::uint64_t step_limit = 1'000'000;
constexpr unsigned depth_limit = 200;

double round_to(const Types& types, TypeId scalar, double number) {
    switch (types.kind(scalar)) {
    case TypeKind::float_: return static_cast<float>(number);
    case TypeKind::half: return round_to_half(number);
    default: return number;
    }
}

bool is_64_bit(const Types& types, TypeId scalar) {
    return types.kind(scalar) == TypeKind::int64 || types.kind(scalar) == TypeKind::uint64;
}

Lane of_bool(bool value) { return {.bits = value ? 1u : 0u}; }

Lane compare(const Types& types, BinaryOp op, TypeId type, Lane a, Lane b) {
    auto by = [op](auto x, auto y) {
        switch (op) {
        case BinaryOp::less: return x < y;
        case BinaryOp::less_equal: return x <= y;
        case BinaryOp::greater: return x > y;
        case BinaryOp::greater_equal: return x >= y;
        case BinaryOp::equal: return x == y;
        default: return x != y;
        }
    };
    if (types.is_floating(type)) return of_bool(by(a.number, b.number));
    if (types.is_signed(type)) return of_bool(by(static_cast<std::int64_t>(a.bits), static_cast<std::int64_t>(b.bits)));
    return of_bool(by(a.bits, b.bits));
}

Lane apply_floating(const Types& types, BinaryOp op, TypeId type, Lane a, Lane b) {
    double result = 0;
    switch (op) {
    case BinaryOp::multiply: result = a.number * b.number; break;
    case BinaryOp::divide: result = a.number / b.number; break;
    case BinaryOp::add: result = a.number + b.number; break;
    case BinaryOp::subtract: result = a.number - b.number; break;
    default: break;
    }
    return {.number = round_to(types, type, result)};
}

Lane apply_integer(const Types& types, BinaryOp op, TypeId type, Lane a, Lane b) {
    auto x = a.bits, y = b.bits;
    auto sx = static_cast<std::int64_t>(x), sy = static_cast<std::int64_t>(y);
    std::uint64_t width = is_64_bit(types, type) ? 64 : 32;
    std::uint64_t result = 0;
    switch (op) {
    case BinaryOp::multiply: result = x * y; break;
    case BinaryOp::divide:
        if (y == 0) result = x;  // as if divided by one
        else if (types.is_signed(type)) result = sy == -1 ? 0 - x : static_cast<std::uint64_t>(sx / sy);
        else result = x / y;
        break;
    case BinaryOp::remainder:
        if (y == 0) result = 0;
        else if (types.is_signed(type)) result = sy == -1 ? 0 : static_cast<std::uint64_t>(sx % sy);
        else result = x % y;
        break;
    case BinaryOp::add: result = x + y; break;
    case BinaryOp::subtract: result = x - y; break;
    case BinaryOp::shift_left: result = x << (y & (width - 1)); break;
    case BinaryOp::shift_right:
        result = types.is_signed(type) ? static_cast<std::uint64_t>(sx >> (y & (width - 1))) : x >> (y & (width - 1));
        break;
    case BinaryOp::bit_and: result = x & y; break;
    case BinaryOp::bit_xor: result = x ^ y; break;
    case BinaryOp::bit_or: result = x | y; break;
    default: break;
    }
    return normalize(types, type, {.bits = result});
}

/// Evaluates expressions and functions. An expression that it cannot compute has no value; a statement that needs the
/// value of one ends the evaluation (Flow::stuck).
class Interpreter {
public:
    Interpreter(const Program& program, const Definitions& definitions)
        : program_(program), types_(program.types), definitions_(definitions) {}

    void set_surroundings(const Surroundings& surroundings) { surroundings_ = &surroundings; }
    std::optional<Value> value_of(ExprId id);
    std::optional<Value> call(FunctionId id, std::vector<Value> arguments);

private:
    enum class Flow { next, break_, continue_, return_, stuck };
    /// The locals of one call: so few that a linear search is fastest.
    class Frame {
    public:
        Value* find(LocalId local) {
            for (auto& [known, value] : values_)
                if (known == local) return &value;
            return nullptr;
        }
        void set(LocalId local, Value value) {
            if (Value* known = find(local)) *known = std::move(value);
            else values_.emplace_back(local, std::move(value));
        }

    private:
        std::vector<std::pair<LocalId, Value>> values_;
    };

    Value zero(TypeId type) {
        Value value{type, {}};
        value.lanes.assign(lane_count(program_, type), Lane{});
        return value;
    }
    std::optional<Value> construct(const Expr& expr);
    std::optional<Value> binary(const Expr& expr);
    std::optional<Value> intrinsic(const Expr& expr);
    std::optional<Value> call(const Expr& expr);
    std::optional<std::pair<std::size_t, std::size_t>> part_of(const Expr& expr, TypeId whole);
    std::optional<std::pair<LocalId, std::size_t>> target_of(ExprId id);
    Flow run(const std::vector<StmtId>& body);
    Flow run(const Stmt& stmt);
    Flow run_for(const Stmt& stmt);
    bool assign(const Stmt& stmt);

    const Program& program_;
    const Types& types_;
    const Definitions& definitions_;
    const Surroundings* surroundings_ = nullptr;
    Frame* frame_ = nullptr;
    Value returned_;
    std::uint64_t steps_ = 0;
    unsigned depth_ = 0;
};

// long: a case for each operation
std::optional<Value> Interpreter::value_of(ExprId id) {
    if (!id || ++steps_ > step_limit) return std::nullopt;
    const Expr& expr = program_.exprs[id];
    switch (expr.op) {
    case Op::constant: return Value{expr.type, {normalize(types_, expr.type, {expr.bits, expr.number})}};
    case Op::local:
        if (frame_)
            if (const Value* found = frame_->find(expr.local)) return *found;
        if (auto defined = definitions_.find(expr.local); defined != definitions_.end())
            return value_of(defined->second);
        return std::nullopt;
    case Op::construct: return construct(expr);
    case Op::convert: {
        auto value = value_of(expr.operands[0]);
        if (!value) return std::nullopt;
        TypeId from = types_.scalar_of(value->type), to = types_.scalar_of(expr.type);
        for (Lane& lane : value->lanes) lane = convert(types_, from, to, lane);
        value->type = expr.type;
        return value;
    }
    case Op::unary: {
        auto value = value_of(expr.operands[0]);
        if (!value) return std::nullopt;
        TypeId scalar = types_.scalar_of(expr.type);
        for (Lane& lane : value->lanes) {
            if (expr.unary == UnaryOp::logical_not) lane.bits = lane.bits ? 0 : 1;
            else if (expr.unary == UnaryOp::bit_not) lane.bits = ~lane.bits;
            else lane = {0 - lane.bits, -lane.number};
            lane = normalize(types_, scalar, lane);
        }
        return value;
    }
    case Op::binary: return binary(expr);
    case Op::select: {
        auto condition = value_of(expr.operands[0]);
        if (!condition) return std::nullopt;
        return value_of(expr.operands[condition->bits() ? 1 : 2]);
    }
    case Op::swizzle: {
        auto value = value_of(expr.operands[0]);
        if (!value) return std::nullopt;
        Value result{expr.type, {}};
        for (std::uint32_t i = 0; i < types_.components(expr.type); ++i)
            result.lanes.push_back(value->lanes[expr.lanes[i]]);
        return result;
    }
    case Op::index:
    case Op::field: {
        auto value = value_of(expr.operands[0]);
        if (!value) return std::nullopt;
        auto part = part_of(expr, value->type);
        if (!part) return std::nullopt;
        auto first = value->lanes.begin() + static_cast<std::ptrdiff_t>(part->first);
        return Value{expr.type, {first, first + static_cast<std::ptrdiff_t>(part->second)}};
    }
    case Op::call: return call(expr);
    case Op::intrinsic: return intrinsic(expr);
    case Op::none: return zero(expr.type);
    case Op::some: {
        auto value = value_of(expr.operands[0]);
        if (!value) return std::nullopt;
        Value result{expr.type, {Lane{.bits = 1}}};
        result.lanes.append(value->lanes);
        return result;
    }
    case Op::has_value: {
        auto value = value_of(expr.operands[0]);
        if (!value) return std::nullopt;
        return Value{types_.bool_, {value->lanes[0]}};
    }
    case Op::value: {
        auto value = value_of(expr.operands[0]);
        if (!value) return std::nullopt;
        return Value{expr.type, {value->lanes.begin() + 1, value->lanes.end()}};
    }
    default: return surroundings_ ? (*surroundings_)(expr) : std::nullopt;
    }
}

std::optional<Value> Interpreter::construct(const Expr& expr) {
    Value result{expr.type, {}};
    for (ExprId operand : expr.operands) {
        auto value = value_of(operand);
        if (!value) return std::nullopt;
        result.lanes.append(value->lanes);
    }
    std::size_t wanted = lane_count(program_, expr.type);
    if (result.lanes.size() == 1 && wanted > 1 && types_.is_vector(expr.type))
        result.lanes.assign(wanted, Lane{result.lanes[0]});
    if (result.lanes.size() != wanted) return std::nullopt;
    return result;
}

std::optional<Value> Interpreter::binary(const Expr& expr) {
    auto left = value_of(expr.operands[0]);
    if (!left) return std::nullopt;
    if (expr.binary == BinaryOp::logical_and && !left->bits()) return left;
    if (expr.binary == BinaryOp::logical_or && left->bits()) return left;
    auto right = value_of(expr.operands[1]);
    if (!right) return std::nullopt;
    if (expr.binary == BinaryOp::logical_and || expr.binary == BinaryOp::logical_or) return right;
    if (types_.is_matrix(left->type) || types_.is_matrix(right->type)) return std::nullopt;
    TypeId scalar = types_.scalar_of(left->type);
    if (expr.binary == BinaryOp::equal || expr.binary == BinaryOp::not_equal) {
        bool equal = left->lanes.size() == right->lanes.size();
        for (std::size_t i = 0; equal && i < left->lanes.size(); ++i)
            equal = apply(types_, BinaryOp::equal, scalar, left->lanes[i], right->lanes[i]).bits != 0;
        return Value{types_.bool_, {of_bool(equal == (expr.binary == BinaryOp::equal))}};
    }
    std::size_t count = std::max(left->lanes.size(), right->lanes.size());
    Value result{expr.type, {}};
    for (std::size_t i = 0; i < count; ++i)
        result.lanes.push_back(apply(types_, expr.binary, scalar, left->lanes[left->lanes.size() == 1 ? 0 : i],
                                     right->lanes[right->lanes.size() == 1 ? 0 : i]));
    return result;
}

std::optional<Lane> apply_intrinsic(const Types& types, Intrinsic intrinsic, TypeId type, const Lane* lanes) {
    const Lane &a = lanes[0], &b = lanes[1], &c = lanes[2];
    auto less = [&](const Lane& x, const Lane& y) { return compare(types, BinaryOp::less, type, x, y).bits != 0; };
    auto number = [&](double value) { return Lane{.number = round_to(types, type, value)}; };
    // If one operand is NaN, the result is the other one.
    auto least = [&](const Lane& x, const Lane& y) { return less(y, x) || std::isnan(x.number) ? y : x; };
    auto greatest = [&](const Lane& x, const Lane& y) { return less(x, y) || std::isnan(x.number) ? y : x; };
    bool floating = types.is_floating(type), is_signed = types.is_signed(type);
    auto signed_bits = static_cast<std::int64_t>(a.bits);
    const std::uint64_t word = is_64_bit(types, type) ? a.bits : static_cast<std::uint32_t>(a.bits);
    switch (intrinsic) {
    case Intrinsic::min: return least(a, b);
    case Intrinsic::max: return greatest(a, b);
    case Intrinsic::clamp: return least(greatest(a, b), c);
    case Intrinsic::mod: {
        const Lane quotient = apply(types, BinaryOp::divide, type, a, b);
        const Lane whole = apply(types, BinaryOp::multiply, type, b, number(std::floor(quotient.number)));
        return apply(types, BinaryOp::subtract, type, a, whole);
    }
    case Intrinsic::abs:
        if (floating) return number(std::fabs(a.number));
        return normalize(types, type, {.bits = is_signed && signed_bits < 0 ? 0 - a.bits : a.bits});
    case Intrinsic::sign:
        if (floating) return number(a.number > 0 ? 1 : a.number < 0 ? -1 : 0);
        return normalize(types, type,
                         {.bits = static_cast<std::uint64_t>(signed_bits > 0   ? 1
                                                             : signed_bits < 0 ? -1
                                                                               : 0)});
    case Intrinsic::floor: return number(std::floor(a.number));
    case Intrinsic::ceil: return number(std::ceil(a.number));
    case Intrinsic::trunc: return number(std::trunc(a.number));
    case Intrinsic::round: return number(std::nearbyint(a.number));
    case Intrinsic::sqrt: return number(std::sqrt(a.number));
    case Intrinsic::bitCount: return Lane{.bits = static_cast<std::uint64_t>(std::popcount(word))};
    case Intrinsic::findLSB:
        return Lane{.bits = static_cast<std::uint64_t>(word ? std::int64_t{std::countr_zero(word)} : -1)};
    case Intrinsic::findMSB: {
        const std::uint64_t found = is_signed && signed_bits < 0 ? ~a.bits : word;
        return Lane{.bits = static_cast<std::uint64_t>(std::int64_t{63} - std::countl_zero(found))};
    }
    case Intrinsic::lessThan: return of_bool(less(a, b));
    case Intrinsic::greaterThan: return of_bool(less(b, a));
    case Intrinsic::lessThanEqual: return compare(types, BinaryOp::less_equal, type, a, b);
    case Intrinsic::greaterThanEqual: return compare(types, BinaryOp::greater_equal, type, a, b);
    case Intrinsic::equal: return compare(types, BinaryOp::equal, type, a, b);
    case Intrinsic::notEqual: return compare(types, BinaryOp::not_equal, type, a, b);
    default: return std::nullopt;
    }
}

std::optional<Value> Interpreter::intrinsic(const Expr& expr) {
    std::vector<Value> operands;
    std::size_t count = 1;
    for (ExprId operand : expr.operands) {
        auto value = value_of(operand);
        if (!value) return std::nullopt;
        count = std::max(count, value->lanes.size());
        operands.push_back(std::move(*value));
    }
    if (operands.empty() || operands.size() > 3) return std::nullopt;
    if (expr.intrinsic == Intrinsic::any || expr.intrinsic == Intrinsic::all) {
        bool any = false, all = true;
        for (const Lane& lane : operands[0].lanes) any |= lane.bits != 0, all &= lane.bits != 0;
        return Value{expr.type, {of_bool(expr.intrinsic == Intrinsic::any ? any : all)}};
    }
    Value result{expr.type, {}};
    for (std::size_t i = 0; i < count; ++i) {
        Lane lanes[3];
        for (std::size_t k = 0; k < operands.size(); ++k)
            lanes[k] = operands[k].lanes[operands[k].lanes.size() == 1 ? 0 : i];
        auto lane = apply_intrinsic(types_, expr.intrinsic, types_.scalar_of(operands[0].type), lanes);
        if (!lane) return std::nullopt;
        result.lanes.push_back(*lane);
    }
    return result;
}

std::optional<Value> Interpreter::call(const Expr& expr) {
    const Function& function = program_.functions[expr.function];
    if (!function.structures.empty()) return std::nullopt;
    std::vector<Value> arguments;
    for (ExprId operand : expr.operands) {
        auto value = value_of(operand);
        if (!value) return std::nullopt;
        arguments.push_back(std::move(*value));
    }
    return call(expr.function, std::move(arguments));
}

/// The result of a sum, product or shift of sizes that lower/transform/widen.h made saturating: 2^64 - 1 if the exact
/// result does not fit. Absent for calls of other C++ functions.
std::optional<Value> saturated(const Function& function, const std::vector<Value>& arguments) {
    if (!function.extern_name.starts_with("glift::saturated_") || arguments.size() != 2) return std::nullopt;
    const auto apply = [&](std::uint64_t a, std::uint64_t b) -> std::uint64_t {
        if (function.extern_name.ends_with("sum")) return a > UINT64_MAX - b ? UINT64_MAX : a + b;
        if (function.extern_name.ends_with("product")) return b != 0 && a > UINT64_MAX / b ? UINT64_MAX : a * b;
        if (a == 0) return 0;
        return b >= 64 || a > UINT64_MAX >> b ? UINT64_MAX : a << b;
    };
    const auto lane = [](const Value& value, std::size_t i) {
        return value.lanes[value.lanes.size() == 1 ? 0 : i].bits;
    };
    Value result{function.result, {}};
    for (std::size_t i = 0; i < std::max(arguments[0].lanes.size(), arguments[1].lanes.size()); ++i)
        result.lanes.push_back({.bits = apply(lane(arguments[0], i), lane(arguments[1], i))});
    return result;
}

std::optional<Value> Interpreter::call(FunctionId id, std::vector<Value> arguments) {
    const Function& function = program_.functions[id];
    if (!function.extern_name.empty()) return saturated(function, arguments);
    if (depth_ >= depth_limit) return std::nullopt;
    Frame frame;
    for (std::size_t i = 0; i < arguments.size(); ++i) frame.set(function.params[i], std::move(arguments[i]));
    Frame* outer = std::exchange(frame_, &frame);
    ++depth_;
    returned_ = {};
    Flow flow = run(function.body);
    --depth_;
    frame_ = outer;
    if (flow != Flow::return_) return std::nullopt;
    return returned_;
}

std::optional<std::pair<std::size_t, std::size_t>> Interpreter::part_of(const Expr& expr, TypeId whole) {
    std::size_t size = lane_count(program_, expr.type);
    if (expr.op == Op::field) {
        std::size_t offset = 0;
        const Struct& type = program_.structs[types_[whole].struct_];
        for (std::uint32_t i = 0; i < expr.slot; ++i) offset += lane_count(program_, type.fields[i].type);
        return std::pair{offset, size};
    }
    auto index = value_of(expr.operands[1]);
    if (!index ||
        index->bits() >= std::max<std::uint64_t>(1, lane_count(program_, whole) / std::max<std::size_t>(1, size)))
        return std::nullopt;
    return std::pair{static_cast<std::size_t>(index->bits()) * size, size};
}

std::optional<std::pair<LocalId, std::size_t>> Interpreter::target_of(ExprId id) {
    const Expr& expr = program_.exprs[id];
    if (expr.op == Op::local) return std::pair{expr.local, std::size_t{0}};
    if (expr.op != Op::index && expr.op != Op::field) return std::nullopt;
    auto base = target_of(expr.operands[0]);
    auto part = part_of(expr, program_.exprs[expr.operands[0]].type);
    if (!base || !part) return std::nullopt;
    return std::pair{base->first, base->second + part->first};
}

bool Interpreter::assign(const Stmt& stmt) {
    auto value = value_of(stmt.value);
    if (!value) return false;
    const Expr& target = program_.exprs[stmt.target];
    ExprId base = target.op == Op::swizzle ? target.operands[0] : stmt.target;
    auto place = target_of(base);
    if (!place) return false;
    Value* found = frame_->find(place->first);
    if (!found) return false;
    for (std::size_t i = 0; i < value->lanes.size(); ++i)
        found->lanes[place->second + (target.op == Op::swizzle ? target.lanes[i] : i)] = value->lanes[i];
    return true;
}

Interpreter::Flow Interpreter::run_for(const Stmt& stmt) {
    auto first = value_of(stmt.value), limit = value_of(stmt.limit);
    if (!first || !limit) return Flow::stuck;
    TypeId type = first->type;
    Lane at = first->lanes[0];
    while (compare(types_, BinaryOp::less, type, at, limit->lanes[0]).bits) {
        if (++steps_ > step_limit) return Flow::stuck;
        frame_->set(stmt.local, Value{type, {at}});
        Flow flow = run(stmt.body);
        if (flow == Flow::break_) break;
        if (flow == Flow::return_ || flow == Flow::stuck) return flow;
        at = normalize(types_, type, {.bits = at.bits + 1});
    }
    return Flow::next;
}

Interpreter::Flow Interpreter::run(const Stmt& stmt) {
    if (!frame_ || ++steps_ > step_limit) return Flow::stuck;
    switch (stmt.op) {
    case StmtOp::let: {
        auto value = stmt.value ? value_of(stmt.value) : std::optional(zero(program_.locals[stmt.local].type));
        if (!value) return Flow::stuck;
        frame_->set(stmt.local, std::move(*value));
        return Flow::next;
    }
    case StmtOp::assign: return assign(stmt) ? Flow::next : Flow::stuck;
    case StmtOp::if_: {
        auto condition = value_of(stmt.value);
        if (!condition) return Flow::stuck;
        return run(condition->bits() ? stmt.body : stmt.otherwise);
    }
    case StmtOp::for_: return run_for(stmt);
    case StmtOp::while_:
        for (;;) {
            auto condition = value_of(stmt.value);
            if (!condition) return Flow::stuck;
            if (!condition->bits()) return Flow::next;
            Flow flow = run(stmt.body);
            if (flow == Flow::break_) return Flow::next;
            if (flow == Flow::return_ || flow == Flow::stuck) return flow;
        }
    case StmtOp::break_: return Flow::break_;
    case StmtOp::continue_: return Flow::continue_;
    case StmtOp::return_: {
        auto value = stmt.value ? value_of(stmt.value) : std::nullopt;
        if (!value) return Flow::stuck;
        returned_ = std::move(*value);
        return Flow::return_;
    }
    case StmtOp::block: return run(stmt.body);
    default: return Flow::stuck;
    }
}

Interpreter::Flow Interpreter::run(const std::vector<StmtId>& body) {
    for (StmtId id : body) {
        Flow flow = run(program_.stmts[id]);
        if (flow != Flow::next) return flow;
    }
    return Flow::next;
}

}  // namespace

Lane normalize(const Types& types, TypeId scalar, Lane lane) {
    switch (types.kind(scalar)) {
    case TypeKind::bool_: return {.bits = lane.bits ? 1u : 0u};
    case TypeKind::int_:
        return {.bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(static_cast<std::int32_t>(lane.bits)))};
    case TypeKind::uint:
    case TypeKind::enum_: return {.bits = static_cast<std::uint32_t>(lane.bits)};
    case TypeKind::float_:
    case TypeKind::half:
    case TypeKind::double_: return {.number = round_to(types, scalar, lane.number)};
    default: return lane;
    }
}

Lane apply(const Types& types, BinaryOp op, TypeId type, Lane a, Lane b) {
    switch (op) {
    case BinaryOp::less:
    case BinaryOp::less_equal:
    case BinaryOp::greater:
    case BinaryOp::greater_equal:
    case BinaryOp::equal:
    case BinaryOp::not_equal: return compare(types, op, type, a, b);
    case BinaryOp::logical_and: return of_bool(a.bits && b.bits);
    case BinaryOp::logical_or: return of_bool(a.bits || b.bits);
    default: break;
    }
    return types.is_floating(type) ? apply_floating(types, op, type, a, b) : apply_integer(types, op, type, a, b);
}

/// An integer as a floating number of the type. Rounded once: to a double first would round an int64 twice.
double floating(const Types& types, TypeId from, TypeId to, std::uint64_t bits) {
    const auto number = static_cast<std::int64_t>(bits);
    if (types.kind(to) == TypeKind::float_)
        return types.is_signed(from) ? static_cast<float>(number) : static_cast<float>(bits);
    return types.is_signed(from) ? static_cast<double>(number) : static_cast<double>(bits);
}

Lane convert(const Types& types, TypeId from, TypeId to, Lane lane) {
    bool floating_from = types.is_floating(from), floating_to = types.is_floating(to);
    if (types.kind(to) == TypeKind::bool_) return of_bool(floating_from ? lane.number != 0 : lane.bits != 0);
    if (floating_from && floating_to) return normalize(types, to, lane);
    if (floating_to) return normalize(types, to, {.number = floating(types, from, to, lane.bits)});
    if (!floating_from) return normalize(types, to, lane);
    // Saturates; NaN gives zero: docs/reference/language.md, "What is defined".
    double low = types.is_signed(to) ? (types.kind(to) == TypeKind::int64 ? -0x1p63 : -0x1p31) : 0;
    double high = types.kind(to) == TypeKind::int_    ? 0x1p31
                  : types.kind(to) == TypeKind::uint  ? 0x1p32
                  : types.kind(to) == TypeKind::int64 ? 0x1p63
                                                      : 0x1p64;
    double whole = std::trunc(lane.number);
    if (std::isnan(whole)) return {};
    if (whole < low) whole = low;
    if (whole >= high)
        return normalize(types, to,
                         {.bits = types.kind(to) == TypeKind::int_    ? 0x7fffffffu
                                  : types.kind(to) == TypeKind::uint  ? 0xffffffffu
                                  : types.kind(to) == TypeKind::int64 ? 0x7fffffffffffffffu
                                                                      : ~std::uint64_t{0}});
    return normalize(types, to,
                     {.bits = whole < 0 ? static_cast<std::uint64_t>(static_cast<std::int64_t>(whole))
                                        : static_cast<std::uint64_t>(whole)});
}

std::size_t lane_count(const Program& program, TypeId id) {
    const Type& type = program.types[id];
    switch (type.kind) {
    case TypeKind::vector: return type.count;
    case TypeKind::matrix: return std::size_t{type.count} * type.rows;
    case TypeKind::array: return std::size_t{type.count} * lane_count(program, type.element);
    case TypeKind::optional: return 1 + lane_count(program, type.element);
    case TypeKind::struct_: {
        std::size_t count = 0;
        for (const StructField& field : program.structs[type.struct_].fields) count += lane_count(program, field.type);
        return count;
    }
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: return 0;
    default: return 1;
    }
}

std::optional<Value> evaluate(const Program& program, ExprId expr) { return evaluate(program, expr, Definitions{}); }

std::optional<Value> evaluate(const Program& program, ExprId expr, const Definitions& definitions) {
    return Interpreter(program, definitions).value_of(expr);
}

std::optional<Value> evaluate(const Program& program, ExprId expr, const Surroundings& surroundings) {
    const Definitions none;
    Interpreter interpreter(program, none);
    interpreter.set_surroundings(surroundings);
    return interpreter.value_of(expr);
}

std::optional<Value> call(const Program& program, FunctionId function, std::vector<Value> arguments,
                          const Surroundings& surroundings) {
    const Definitions none;
    Interpreter interpreter(program, none);
    interpreter.set_surroundings(surroundings);
    return interpreter.call(function, std::move(arguments));
}

}  // namespace gliftc::ir
