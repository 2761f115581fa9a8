#include "lower/analysis/affine.h"

#include "ir/evaluate.h"
#include "ir/walk.h"
#include "lower/analysis/unroll.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <vector>

namespace gliftc::lower {

using namespace ir;

namespace {

/// How one scalar depends on the virtual address: not at all, as an affine function, or otherwise.
enum class Degree : std::uint8_t { uniform, affine, other };

struct Part {
    Degree degree = Degree::uniform;
    std::optional<std::uint64_t> value;  ///< the scalar's value, where that is a constant
};
using Parts = std::vector<Part>;

/// Abstract interpretation of a translator's code, with a degree for each scalar instead of a number. Where code cannot
/// be followed, the result is `other`.
class Degrees {
public:
    explicit Degrees(const Program& program) : p(program) {}

    Parts call(FunctionId id, std::vector<Parts> arguments);

private:
    using Frame = std::unordered_map<LocalId, Parts>;

    Parts of(ExprId id);
    Parts of_binary(const Expr& node);
    Parts of_construct(const Expr& node);
    Parts joined(const Expr& node);
    Parts all(TypeId type, Degree degree) {
        return Parts(std::max<std::size_t>(1, lane_count(p, type)), Part{degree, {}});
    }
    bool run(const std::vector<StmtId>& body);
    bool run_if(const Stmt& stmt);
    bool run_for(const Stmt& stmt);
    void assign(ExprId target, const Parts& value);
    std::optional<std::uint64_t> index_of(const Expr& node);

    const Program& p;
    Frame* frame_ = nullptr;
    std::optional<Parts> returned_;
    unsigned depth_ = 0;
};

Degree highest(const Parts& parts) {
    Degree degree = Degree::uniform;
    for (const Part& part : parts) degree = std::max(degree, part.degree);
    return degree;
}

Parts Degrees::call(FunctionId id, std::vector<Parts> arguments) {
    const Function& function = p.functions[id];
    if (depth_ >= 32) return all(function.result, Degree::other);
    ++depth_;
    Frame frame;
    for (std::size_t i = 0; i < function.params.size() && i < arguments.size(); ++i)
        frame[function.params[i]] = std::move(arguments[i]);
    Frame* outer = std::exchange(frame_, &frame);
    auto outer_returned = std::exchange(returned_, std::nullopt);
    bool followed = run(function.body);
    Parts result = followed && returned_ ? *returned_ : all(function.result, Degree::other);
    frame_ = outer;
    returned_ = std::move(outer_returned);
    --depth_;
    return result;
}

/// The result of an operation that is not known to be linear: uniform if all operands are, else `other`.
Parts Degrees::joined(const Expr& node) {
    Degree degree = Degree::uniform;
    for (ExprId operand : node.operands) degree = std::max(degree, highest(of(operand)));
    return all(node.type, degree == Degree::uniform ? Degree::uniform : Degree::other);
}

Parts Degrees::of_construct(const Expr& node) {
    Parts parts;
    for (ExprId operand : node.operands) {
        Parts more = of(operand);
        parts.insert(parts.end(), more.begin(), more.end());
    }
    std::size_t count = std::max<std::size_t>(1, lane_count(p, node.type));
    if (parts.size() == 1) parts.assign(count, Part(parts[0]));
    parts.resize(count, Part{Degree::other, {}});
    return parts;
}

Parts Degrees::of_binary(const Expr& node) {
    Parts a = of(node.operands[0]), b = of(node.operands[1]);
    bool is_sum = node.binary == BinaryOp::add || node.binary == BinaryOp::subtract;
    bool is_product = node.binary == BinaryOp::multiply;
    if (p.types.is_floating(p.types.scalar_of(node.type)) || p.types.is_matrix(node.type)) return joined(node);
    Parts result;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
        const Part &x = a[a.size() == 1 ? 0 : i], &y = b[b.size() == 1 ? 0 : i];
        Part part{Degree::other, {}};
        if (x.degree == Degree::uniform && y.degree == Degree::uniform) {
            part.degree = Degree::uniform;
            TypeId scalar = p.types.scalar_of(p.exprs[node.operands[0]].type);
            if (x.value && y.value)
                part.value = apply(p.types, node.binary, scalar, {.bits = *x.value}, {.bits = *y.value}).bits;
        } else if (is_sum && x.degree != Degree::other && y.degree != Degree::other) {
            part.degree = Degree::affine;
        } else if (is_product && std::min(x.degree, y.degree) == Degree::uniform) {
            part.degree = std::max(x.degree, y.degree);
        } else if (node.binary == BinaryOp::shift_left && y.degree == Degree::uniform) {
            part.degree = x.degree;
        }
        result.push_back(part);
    }
    if (p.types.components(node.type) != result.size())
        return all(node.type, highest(result) == Degree::uniform ? Degree::uniform : Degree::other);
    return result;
}

std::optional<std::uint64_t> Degrees::index_of(const Expr& node) {
    Parts at = of(node.operands[1]);
    return at[0].value;
}

// long: one switch over the operations
Parts Degrees::of(ExprId id) {
    const Expr& node = p.exprs[id];
    switch (node.op) {
    case Op::constant: return {Part{Degree::uniform, node.bits}};
    case Op::local: {
        auto found = frame_->find(node.local);
        return found == frame_->end() ? all(node.type, Degree::other) : found->second;
    }
    case Op::construct: return of_construct(node);
    case Op::binary: return of_binary(node);
    case Op::convert: {
        Parts parts = of(node.operands[0]);
        TypeId from = p.types.scalar_of(p.exprs[node.operands[0]].type), to = p.types.scalar_of(node.type);
        // Conversions between integers keep the degree.
        bool keeps = p.types.is_integer(from) && p.types.is_integer(to);
        for (Part& part : parts) {
            if (!keeps && part.degree == Degree::affine) part.degree = Degree::other;
            if (!keeps) part.value.reset();
            if (part.value) part.value = convert(p.types, from, to, {.bits = *part.value}).bits;
        }
        return parts;
    }
    case Op::swizzle: {
        Parts whole = of(node.operands[0]), parts;
        for (std::uint32_t i = 0; i < p.types.components(node.type); ++i) parts.push_back(whole[node.lanes[i]]);
        return parts;
    }
    case Op::index: {
        Parts whole = of(node.operands[0]);
        std::size_t count = std::max<std::size_t>(1, lane_count(p, node.type));
        auto at = index_of(node);
        if (!at || (*at + 1) * count > whole.size())
            return all(node.type, highest(whole) == Degree::uniform ? Degree::uniform : Degree::other);
        auto begin = whole.begin() + static_cast<std::ptrdiff_t>(*at * count);
        return {begin, begin + static_cast<std::ptrdiff_t>(count)};
    }
    case Op::some: {
        Parts parts = of(node.operands[0]);
        parts.insert(parts.begin(), Part{Degree::uniform, 1});
        return parts;
    }
    case Op::call: {
        if (!p.functions[node.function].structures.empty()) return all(node.type, Degree::other);
        std::vector<Parts> arguments;
        for (ExprId operand : node.operands) arguments.push_back(of(operand));
        return call(node.function, std::move(arguments));
    }
    case Op::state:
    case Op::member:
    case Op::memory_extent:
    case Op::host_state:
    case Op::domain:
    case Op::none: return all(node.type, Degree::uniform);
    case Op::unary:
    case Op::select:
    case Op::field:
    case Op::intrinsic:
    case Op::has_value:
    case Op::value: return joined(node);
    default: return all(node.type, Degree::other);
    }
}

void Degrees::assign(ExprId target, const Parts& value) {
    const Expr& node = p.exprs[target];
    if (node.op == Op::local) {
        (*frame_)[node.local] = value;
        return;
    }
    const Expr& base = p.exprs[node.operands[0]];
    if (base.op != Op::local || (node.op != Op::index && node.op != Op::swizzle)) {
        // A field, or a part of a part: not followed.
        const Expr& root = place_of(p, target);
        if (root.op == Op::local) (*frame_)[root.local] = all(p.locals[root.local].type, Degree::other);
        return;
    }
    Parts& whole = (*frame_)[base.local];
    auto at = node.op == Op::index ? index_of(node) : std::nullopt;
    for (std::size_t i = 0; i < value.size(); ++i) {
        std::size_t slot = node.op == Op::swizzle ? node.lanes[i] : at ? *at * value.size() + i : whole.size();
        if (slot < whole.size()) whole[slot] = value[i];
        else whole.assign(whole.size(), Part{Degree::other, {}});
    }
}

bool Degrees::run_if(const Stmt& stmt) {
    Parts condition = of(stmt.value);
    if (condition[0].value) return run(*condition[0].value ? stmt.body : stmt.otherwise);
    bool leaves = returns(p, stmt.body) || returns(p, stmt.otherwise);
    if (leaves) return false;
    Frame before = *frame_;
    if (!run(stmt.body)) return false;
    Frame taken = std::exchange(*frame_, before);
    if (!run(stmt.otherwise)) return false;
    // A local that a side assigns becomes a select between two values: uniform if both and the condition are, else
    // `other`.
    std::vector<StmtId> sides = stmt.body;
    sides.insert(sides.end(), stmt.otherwise.begin(), stmt.otherwise.end());
    for_each_statement(p, sides, [&](const Stmt& inner) {
        if (inner.op != StmtOp::assign) return;
        ExprId root = inner.target;
        while (p.exprs[root].op != Op::local) root = p.exprs[root].operands[0];
        Parts& parts = (*frame_)[p.exprs[root].local];
        Degree degree = std::max({highest(parts), highest(taken[p.exprs[root].local]), condition[0].degree});
        parts.assign(parts.size(), Part{degree == Degree::uniform ? Degree::uniform : Degree::other, {}});
    });
    return true;
}

/// Interprets each round of a loop with constant bounds.
bool Degrees::run_for(const Stmt& stmt) {
    const std::optional<std::uint64_t> first = of(stmt.value)[0].value, limit = of(stmt.limit)[0].value;
    if (!first || !limit) return false;
    const bool is_signed = p.types.is_signed(p.locals[stmt.local].type);
    const bool runs =
        is_signed ? static_cast<std::int64_t>(*first) < static_cast<std::int64_t>(*limit) : *first < *limit;
    if (!runs) return true;
    const std::uint64_t rounds = *limit - *first;
    if (rounds > unroll_limit || leaves_loop(p, stmt.body)) return false;
    for (std::uint64_t i = 0; i < rounds && !returned_; ++i) {
        (*frame_)[stmt.local] = {Part{Degree::uniform, *first + i}};
        if (!run(stmt.body)) return false;
    }
    return true;
}

/// Interprets the statements, up to a return; false if it cannot follow one of them.
bool Degrees::run(const std::vector<StmtId>& body) {
    for (StmtId id : body) {
        const Stmt& stmt = p.stmts[id];
        switch (stmt.op) {
        case StmtOp::let:
            (*frame_)[stmt.local] = stmt.value ? of(stmt.value) : all(p.locals[stmt.local].type, Degree::uniform);
            break;
        case StmtOp::assign: assign(stmt.target, of(stmt.value)); break;
        case StmtOp::return_: returned_ = stmt.value ? of(stmt.value) : Parts{}; return true;
        case StmtOp::if_:
            if (!run_if(stmt)) return false;
            if (returned_) return true;
            break;
        case StmtOp::block:
            if (!run(stmt.body)) return false;
            if (returned_) return true;
            break;
        case StmtOp::for_:
            if (!run_for(stmt)) return false;
            if (returned_) return true;
            break;
        default: return false;
        }
    }
    return true;
}

}  // namespace

bool is_affine(const Program& program, const Translator& translator) {
    if (!translator.translate) return false;
    const Function& function = program.functions[translator.translate];
    if (function.params.size() != 1) return false;
    std::size_t count = std::max<std::size_t>(1, lane_count(program, translator.virtual_type));
    Parts result = Degrees(program).call(translator.translate, {Parts(count, Part{Degree::affine, {}})});
    return std::all_of(result.begin(), result.end(), [](const Part& part) { return part.degree != Degree::other; });
}

void mark_affine(Program& program) {
    for (Translator& translator : program.translators) translator.properties.affine = is_affine(program, translator);
}

}  // namespace gliftc::lower
