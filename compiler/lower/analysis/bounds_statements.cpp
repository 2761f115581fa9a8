// BoundsInterpreter: the cases for statements. Where a condition is not known, both paths are followed and their
// results joined.
#include "ir/evaluate.h"
#include "lower/analysis/bounds.h"
#include "lower/analysis/unroll.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;
using symbolic::number;
using symbolic::operator+;
using symbolic::Sum;
using symbolic::value_of;

namespace {

constexpr unsigned depth_limit = 32;

}  // namespace

Parts BoundsInterpreter::call(FunctionId id, std::vector<Parts> arguments) {
    const Function& function = p.functions[id];
    if (depth_ > depth_limit) return unknown(function.result);
    Frame frame;
    for (std::size_t i = 0; i < function.params.size() && i < arguments.size(); ++i)
        frame.locals[function.params[i]] = std::move(arguments[i]);
    Frame* outer = std::exchange(frame_, &frame);
    ++depth_;
    run(function.body);
    --depth_;
    Parts result = frame.is_followed ? frame.returned.value_or(Parts{}) : unknown(function.result);
    frame_ = outer;
    return result;
}

std::optional<Parts> BoundsInterpreter::translated(Parts address) {
    for (const Stage& stage : s->via) {
        stage_ = &stage;
        address = call(p.translators[stage.translator].translate, {std::move(address)});
        if (address.empty()) return std::nullopt;
    }
    stage_ = nullptr;
    return address;
}

/// Applies facts, which are sums that are known to be at least zero. If a fact gives a varying unknown a new upper
/// bound, that unknown is replaced, in the values of locals, by another one with this bound.
void BoundsInterpreter::assume(const std::vector<Sum>& facts) {
    for (const Sum& fact : facts) {
        for (const auto& [product, factor] : fact) {
            if (product.size() != 1 || factor != -1) continue;
            const symbolic::Unknown each = product[0];
            const Sum own{{product, 1}};
            const Sum high = fact + own;
            const symbolic::Bounds bounds = symbols.bounds(each);
            const bool is_alone =
                std::ranges::none_of(high, [&](const auto& term) { return std::ranges::count(term.first, each) != 0; });
            const bool is_known = bounds.high && symbols.is_at_most(*bounds.high, high);
            if (!symbols.varies(own) || !is_alone || is_known) continue;
            const Sum bounded = symbols.varying({bounds.low, high});
            for (auto& [local, parts] : frame_->locals)
                for (Part& part : parts) part.sum = symbolic::replaced(part.sum, each, bounded);
        }
    }
}

void BoundsInterpreter::give_up() { frame_->is_followed = false; }

void BoundsInterpreter::assign(ExprId target, const Parts& value) {
    const Expr& node = p.exprs[target];
    if (node.op == Op::local) {
        frame_->locals[node.local] = value;
        return;
    }
    const Expr& base = p.exprs[node.operands[0]];
    if (base.op != Op::local || (node.op != Op::index && node.op != Op::swizzle)) return give_up();
    Parts& whole = frame_->locals[base.local];
    const auto at = node.op == Op::index ? value_of(of(node.operands[1])[0].sum) : std::nullopt;
    if (node.op == Op::index && !at) {
        whole = unknown(base.type);
        return;
    }
    if (value.empty() || whole.size() < value.size()) return give_up();
    // An index beyond the array, or a negative one, is clamped to its last element, as it is at run time.
    const std::size_t last = whole.size() / value.size() - 1;
    const std::size_t element = std::min(static_cast<std::size_t>(at.value_or(-1)), last);
    for (std::size_t i = 0; i < value.size(); ++i)
        whole[node.op == Op::swizzle ? node.lanes[i] : element * value.size() + i] = value[i];
}

void BoundsInterpreter::run_if(const Stmt& stmt) {
    const Part condition = of(stmt.value)[0];
    if (condition.truth.known) return run(*condition.truth.known ? stmt.body : stmt.otherwise);
    const auto before = frame_->locals;
    assume(condition.truth.if_true);
    run(stmt.body);
    const bool has_left = std::exchange(frame_->has_left, false);
    const auto after = std::exchange(frame_->locals, before);
    assume(condition.truth.if_false);
    run(stmt.otherwise);
    if (has_left) return;  // all paths in stmt.body return: what follows is reached only through stmt.otherwise
    if (std::exchange(frame_->has_left, false)) {
        frame_->locals = after;
        return;
    }
    for (auto& [local, parts] : frame_->locals) {
        const auto other = after.find(local);
        if (other == after.end()) continue;
        if (other->second.size() != parts.size()) {  // an optional that is none on one side
            parts = joined(other->second, parts);
            continue;
        }
        for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = chosen(condition, other->second[i], parts[i]);
    }
}

void BoundsInterpreter::run_for(const Stmt& stmt) {
    const auto first = value_of(of(stmt.value)[0].sum), limit = value_of(of(stmt.limit)[0].sum);
    const bool is_known = first && limit && *limit - *first <= static_cast<std::int64_t>(unroll_limit);
    if (!is_known || leaves_loop(p, stmt.body)) return give_up();
    for (std::int64_t i = *first; i < *limit && !frame_->has_left && frame_->is_followed; ++i) {
        frame_->locals[stmt.local] = {part_of(number(i))};
        run(stmt.body);
    }
}

void BoundsInterpreter::run(const std::vector<StmtId>& body) {
    for (StmtId id : body) {
        if (frame_->has_left || !frame_->is_followed) return;
        const Stmt& stmt = p.stmts[id];
        switch (stmt.op) {
        case StmtOp::let: {
            const TypeId type = p.locals[stmt.local].type;
            Parts zeros(lane_count(p, type), part_of(number(0)));
            frame_->locals[stmt.local] = stmt.value ? of(stmt.value) : std::move(zeros);
            break;
        }
        case StmtOp::assign: assign(stmt.target, of(stmt.value)); break;
        case StmtOp::return_: {
            const Parts value = stmt.value ? of(stmt.value) : Parts{};
            frame_->returned = frame_->returned ? joined(*frame_->returned, value) : value;
            frame_->has_left = true;
            break;
        }
        case StmtOp::if_: run_if(stmt); break;
        case StmtOp::block: run(stmt.body); break;
        case StmtOp::for_: run_for(stmt); break;
        default: give_up();
        }
    }
}

}  // namespace gliftc::lower
