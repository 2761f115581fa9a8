#include "lower/analysis/slopes.h"

namespace gliftc::lower {

namespace {

using ir::BinaryOp;
using ir::Expr;
using ir::ExprId;
using ir::Op;
using ir::Stmt;
using ir::StmtOp;

constexpr int deepest_call = 8;
constexpr std::int64_t longest_unrolled = 16;

Slopes unknown() { return {}; }

Slopes steady() {
    Slopes slopes;
    slopes.fill({true, 0, std::nullopt, 0});
    return slopes;
}

// Arithmetic modulo 2^64, which gives results that are right modulo 2^32.
std::int64_t plus(std::int64_t a, std::int64_t b) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}
std::int64_t minus(std::int64_t a, std::int64_t b) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}
std::int64_t times(std::int64_t a, std::int64_t b) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b));
}

/// Whether a / b is the same for all elements of a row, so that a % b advances as a does: at the row's first element a
/// is a multiple of the row's length, `a.aligned`; it advances by one; and b is a multiple of that length, too.
bool is_by_rows(const Slope& a, const Slope& b) {
    return a.step == 1 && a.aligned != 0 && b.constant && *b.constant > 0 && *b.constant % a.aligned == 0;
}

/// 2 to the power of a constant.
Slope power_of_two(const Slope& exponent) {
    if (!exponent.constant || *exponent.constant < 0 || *exponent.constant > 31) return {};
    return {true, 0, std::int64_t{1} << *exponent.constant, 0};
}

Slope combine(BinaryOp op, const Slope& a, const Slope& b) {
    if (!a.known || !b.known) return {};
    switch (op) {
    case BinaryOp::add:
        return {true, plus(a.step, b.step),
                a.constant && b.constant ? std::optional(plus(*a.constant, *b.constant)) : std::nullopt, 0};
    case BinaryOp::subtract:
        return {true, minus(a.step, b.step),
                a.constant && b.constant ? std::optional(minus(*a.constant, *b.constant)) : std::nullopt, 0};
    case BinaryOp::multiply:
        if (a.constant && b.constant) return {true, 0, times(*a.constant, *b.constant), 0};
        if (a.constant) return {true, times(*a.constant, b.step), std::nullopt, 0};
        if (b.constant) return {true, times(a.step, *b.constant), std::nullopt, 0};
        break;
    case BinaryOp::divide:
        if (is_by_rows(a, b)) return {true, 0, std::nullopt, 0};
        break;
    case BinaryOp::remainder:
        if (is_by_rows(a, b)) return a;
        break;
    case BinaryOp::shift_right:
        if (is_by_rows(a, power_of_two(b))) return {true, 0, std::nullopt, 0};
        break;
    case BinaryOp::shift_left:
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
    if (a.step == 0 && b.step == 0) return {true, 0, std::nullopt, 0};
    return {};
}

bool all_steady(const Slopes& slopes, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!slopes[i].known || slopes[i].step != 0) return false;
    }
    return true;
}

}  // namespace

RowSlopes::RowSlopes(const ir::Program& program, ir::LocalId address, std::uint32_t row, std::uint32_t axis)
    : program_(program) {
    Slopes slopes = steady();
    slopes[axis].step = 1;
    slopes[axis].aligned = row;
    locals_[address] = slopes;
}

bool RowSlopes::is_row(ExprId index) {
    const Slopes slopes = of(index);
    return slopes[0].known && slopes[0].step == 1 && program_.types.components(program_.exprs[index].type) == 1;
}

bool RowSlopes::is_steady(ExprId expr) {
    return all_steady(of(expr), program_.types.components(program_.exprs[expr].type));
}

void RowSlopes::learn(const Stmt& stmt) {
    if (stmt.op == StmtOp::let && stmt.value && !program_.locals[stmt.local].is_mutable)
        locals_[stmt.local] = of(stmt.value);
}

void RowSlopes::learn_steady(ir::LocalId local) { locals_[local] = steady(); }

Slopes RowSlopes::of_construct(const Expr& expr) {
    const std::uint32_t count = program_.types.components(expr.type);
    if (!program_.types.is_vector(expr.type)) return unknown();
    Slopes result;
    std::uint32_t at = 0;
    for (ExprId operand : expr.operands) {
        const Slopes part = of(operand);
        const std::uint32_t parts = program_.types.components(program_.exprs[operand].type);
        for (std::uint32_t i = 0; i < parts && at < count; ++i) result[at++] = part[i];
    }
    if (at == 1) result.fill(result[0]);
    return result;
}

Slopes RowSlopes::of_binary(const Expr& expr) {
    Slopes a = of(expr.operands[0]), b = of(expr.operands[1]);
    const std::uint32_t count_a = program_.types.components(program_.exprs[expr.operands[0]].type);
    const std::uint32_t count_b = program_.types.components(program_.exprs[expr.operands[1]].type);
    if (count_a == 1) a.fill(a[0]);
    if (count_b == 1) b.fill(b[0]);
    Slopes result;
    for (std::size_t i = 0; i < 4; ++i) {
        result[i] = combine(expr.binary, a[i], b[i]);
        if (is_aligned_ && result[i].known && result[i].step == 1 && expr.binary != BinaryOp::remainder)
            result[i].aligned = a[i].aligned | b[i].aligned;
    }
    return result;
}

/// Whether the type is int or uint, or a vector of them: conversions between these keep the bits.
bool RowSlopes::is_word(ir::TypeId type) const {
    const ir::TypeId scalar = program_.types.scalar_of(type);
    return scalar == program_.types.int_ || scalar == program_.types.uint;
}

/// Whether the slope of a value is also that of the converted value.
bool RowSlopes::is_kept_by_conversion(ir::TypeId from, ir::TypeId to) const {
    if (is_word(from) && is_word(to)) return true;
    return !may_wrap_ && is_word(from) && program_.types.is_integer(program_.types.scalar_of(to));
}

/// The slope of `vector[i]`; absent: i is not a constant from 0 to 3, or what is indexed is no vector.
std::optional<Slope> RowSlopes::of_component(const Expr& expr) {
    const Slope index = of(expr.operands[1])[0];
    const bool is_known = index.constant && *index.constant >= 0 && *index.constant < 4;
    if (!is_known || !program_.types.is_vector(program_.exprs[expr.operands[0]].type)) return std::nullopt;
    return of(expr.operands[0])[static_cast<std::size_t>(*index.constant)];
}

// long: a case for each operation
Slopes RowSlopes::of(ExprId id) {
    const Expr& expr = program_.exprs[id];
    switch (expr.op) {
    case Op::constant: {
        Slopes result = steady();
        if (program_.types.is_integer(expr.type)) result[0].constant = static_cast<std::int64_t>(expr.bits);
        return result;
    }
#define SHAPE_OPERATION(name) case Op::name:
#include "ir/operations.def"
    case Op::parameter: return steady();
    case Op::local: {
        const auto found = locals_.find(expr.local);
        return found == locals_.end() ? unknown() : found->second;
    }
    case Op::construct: return of_construct(expr);
    case Op::convert:
        if (is_kept_by_conversion(program_.exprs[expr.operands[0]].type, expr.type)) return of(expr.operands[0]);
        break;
    case Op::unary:
        if (expr.unary == ir::UnaryOp::minus) {
            Slopes result = of(expr.operands[0]);
            for (Slope& slope : result) slope = combine(BinaryOp::subtract, {true, 0, 0, 0}, slope);
            return result;
        }
        break;
    case Op::binary: return of_binary(expr);
    case Op::swizzle: {
        const Slopes from = of(expr.operands[0]);
        Slopes result;
        for (std::uint32_t i = 0; i < program_.types.components(expr.type); ++i) result[i] = from[expr.lanes[i]];
        return result;
    }
    case Op::index:
        if (const std::optional<Slope> part = of_component(expr)) return {*part};
        break;
    case Op::call: return of_call(expr);
    case Op::intrinsic:
    case Op::select: break;
    case Op::field:
    case Op::none:
    case Op::some:
    case Op::has_value:
    case Op::value:
#define STRUCTURE_OPERATION(name) case Op::name:
#define GUARDED_OPERATION(name) case Op::name:
#define HOST_OPERATION(name) case Op::name:
#define CPU_OPERATION(name) case Op::name:
#include "ir/operations.def"
    case Op::load:
    case Op::image_load:
    case Op::image_sample:
    case Op::image_gather:
    case Op::image_compare:
    case Op::builtin: return unknown();
    }
    // A pure operation on values that are constant along the row is constant along the row.
    for (ExprId operand : expr.operands) {
        if (!all_steady(of(operand), program_.types.components(program_.exprs[operand].type))) return unknown();
    }
    return steady();
}

Slopes RowSlopes::of_call(const Expr& expr) {
    if (depth_ >= deepest_call) return unknown();
    const ir::Function& function = program_.functions[expr.function];
    RowSlopes callee(program_, depth_ + 1, may_wrap_);
    callee.is_aligned_ = is_aligned_;
    for (std::size_t i = 0; i < function.params.size() && i < expr.operands.size(); ++i)
        callee.locals_[function.params[i]] = of(expr.operands[i]);
    std::optional<Slopes> result;
    return callee.run(function.body, result) && result ? *result : unknown();
}

bool RowSlopes::assign(ExprId target, const Slopes& value) {
    const Expr& expr = program_.exprs[target];
    if (expr.op == Op::local) {
        locals_[expr.local] = value;
        return true;
    }
    if ((expr.op != Op::swizzle && expr.op != Op::index) || program_.exprs[expr.operands[0]].op != Op::local ||
        !program_.types.is_vector(program_.exprs[expr.operands[0]].type))
        return false;
    Slopes& whole = locals_[program_.exprs[expr.operands[0]].local];
    if (expr.op == Op::swizzle) {
        for (std::uint32_t i = 0; i < program_.types.components(expr.type); ++i) whole[expr.lanes[i]] = value[i];
        return true;
    }
    const Slope index = of(expr.operands[1])[0];
    const std::uint32_t axes = program_.types.components(program_.exprs[expr.operands[0]].type);
    if (!index.constant || *index.constant < 0 || *index.constant >= axes) return false;
    whole[static_cast<std::size_t>(*index.constant)] = value[0];
    return true;
}

bool RowSlopes::run(const std::vector<ir::StmtId>& body, std::optional<Slopes>& result) {
    for (ir::StmtId id : body) {
        const Stmt& stmt = program_.stmts[id];
        switch (stmt.op) {
        case StmtOp::let: {
            Slopes zero = steady();
            for (Slope& slope : zero) slope.constant = 0;
            locals_[stmt.local] = stmt.value ? of(stmt.value) : zero;
            break;
        }
        case StmtOp::assign:
            if (!assign(stmt.target, of(stmt.value))) return false;
            break;
        case StmtOp::for_: {
            const Slope first = of(stmt.value)[0], limit = of(stmt.limit)[0];
            if (!first.constant || !limit.constant || *limit.constant - *first.constant > longest_unrolled)
                return false;
            for (std::int64_t i = *first.constant; i < *limit.constant; ++i) {
                locals_[stmt.local] = steady();
                locals_[stmt.local][0].constant = i;
                if (!run(stmt.body, result) || result) return false;
            }
            break;
        }
        case StmtOp::block:
            if (!run(stmt.body, result)) return false;
            if (result) return true;
            break;
        case StmtOp::return_: result = stmt.value ? of(stmt.value) : unknown(); return true;
        case StmtOp::if_:
        case StmtOp::while_:
        case StmtOp::break_:
        case StmtOp::continue_:
        case StmtOp::evaluate:
        case StmtOp::print:
        case StmtOp::barrier:
        case StmtOp::subgroup_barrier:
#define STRUCTURE_STATEMENT(name) case StmtOp::name:
#define HOST_STATEMENT(name) case StmtOp::name:
#define MEMORY_STATEMENT(name) case StmtOp::name:
#define CPU_STATEMENT(name) case StmtOp::name:
#include "ir/statements.def"
            return false;
        }
    }
    return true;
}

}  // namespace gliftc::lower
