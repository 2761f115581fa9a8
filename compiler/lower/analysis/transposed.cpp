#include "lower/analysis/transposed.h"

#include "ir/effects.h"
#include "ir/walk.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace gliftc::lower {

using namespace ir;

namespace {

/// A kernel with more loads or nodes would take too many registers, and too much code, for several elements.
constexpr std::size_t most_loads = 8, most_nodes = 320;
constexpr std::uint32_t largest_element = 16;  ///< bytes
/// Elements along x that are fewer bytes apart share a sector of GPUs' caches: a tile gains nothing.
constexpr std::uint64_t sector = 32;

/// The bytes that a value takes in workgroup memory, or a number above largest_element.
std::uint32_t bytes_of(const Program& program, TypeId id) {
    const Type& type = program.types[id];
    switch (type.kind) {
    case TypeKind::bool_:
    case TypeKind::int_:
    case TypeKind::uint:
    case TypeKind::float_:
    case TypeKind::half:
    case TypeKind::enum_: return 4;
    case TypeKind::double_:
    case TypeKind::int64:
    case TypeKind::uint64: return 8;
    case TypeKind::vector: return bytes_of(program, type.element) * type.count;
    case TypeKind::struct_: {
        std::uint32_t sum = 0, largest = 4;
        for (const StructField& field : program.structs[type.struct_].fields) {
            const std::uint32_t bytes = bytes_of(program, field.type);
            sum += bytes;
            if (bytes % 8 == 0) largest = 8;
        }
        return (sum + largest - 1) / largest * largest;
    }
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::matrix:
    case TypeKind::array:
    case TypeKind::optional:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: break;
    }
    return largest_element + 1;
}

/// The distance modulo 2^32 as the number of elements between two addresses.
std::uint64_t distance(std::int64_t step) {
    return static_cast<std::uint64_t>(std::abs(static_cast<std::int64_t>(static_cast<std::int32_t>(step))));
}

}  // namespace

TransposedAccesses::TransposedAccesses(Context& context) : cx(context), dependence_(context), numbers_(context) {
    for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) {
        slopes_.emplace_back(cx.p, cx.pass.address, 0, axis);
        slopes_.back().assume_no_wrap();
        for (const KernelParam& param : cx.kernel.params)
            if (param.local) slopes_.back().learn_steady(param.local);
    }
}

std::vector<TransposedAccess> TransposedAccesses::of(const std::vector<StmtId>& body) {
    dependence_.of(body);
    if (!dependence_.may_repeat() || !may_be_tiled(body)) return {};
    for_each_statement(cx.p, body, [&](const Stmt& stmt) {
        for (RowSlopes& slopes : slopes_) slopes.learn(stmt);
    });
    find_stores(body);
    std::erase_if(stores_, [&](const TransposedAccess& store) { return !is_only_access(store.binding, body); });
    for (StmtId id : body) {
        const Stmt& stmt = cx.p.stmts[id];
        for_each_root(stmt, [&](ExprId root) { find_loads(root); });
        const bool has_name = stmt.op == StmtOp::let && stmt.value && !cx.p.locals[stmt.local].is_mutable;
        if (has_name) numbers_.define(stmt.local, numbers_.of(stmt.value));
    }
    std::vector<TransposedAccess> found = std::move(stores_);
    std::ranges::move(loads_, std::back_inserter(found));
    std::erase_if(found, [&, axis = found.empty() ? 0 : found.front().axis](const TransposedAccess& access) {
        return access.axis != axis;
    });
    return found;
}

bool TransposedAccesses::may_be_tiled(const std::vector<StmtId>& body) {
    bool fits = true;
    std::size_t loads = 0, nodes = 0;
    for_each_statement(cx.p, body, [&](const Stmt& stmt) {
        for_each_root(stmt, [&](ExprId root) { fits = fits && numbers_.is_pure(root); });
    });
    for_each_expression(cx.p, body, [&](ExprId id) {
        const Op op = cx.p.exprs[id].op;
        ++nodes;
        loads += is_load(op);
        fits = fits && op != Op::builtin;
    });
    return fits && loads <= most_loads && nodes <= most_nodes;
}

bool TransposedAccesses::is_of_address(ExprId id) {
    if (!id) return true;
    if (const bool* found = of_address_.find(id)) return *found;
    const Expr node = cx.p.exprs[id];
    const auto is_operand_of_address = [&](ExprId operand) { return is_of_address(operand); };
    bool result = is_uniform(cx, id) || node.op == Op::parameter;
    if (!result && node.op == Op::local) {
        const ExprId* definition = cx.definitions.find(node.local);
        result = node.local == cx.pass.address || (definition != nullptr && is_of_address(*definition));
    } else if (!result && !node.operands.empty()) {
        result = node.op != Op::call && !is_load(node.op) && std::ranges::all_of(node.operands, is_operand_of_address);
    }
    of_address_.emplace(id, result);
    return result;
}

void TransposedAccesses::find_stores(const std::vector<StmtId>& body) {
    for (StmtId id : body) {
        const Stmt& stmt = cx.p.stmts[id];
        if (stmt.op == StmtOp::store) note_store(id);
        if (stmt.op == StmtOp::block) find_stores(stmt.body);
        if (stmt.op != StmtOp::if_) continue;
        conditions_.push_back({stmt.value, true});
        spans_.push_back(stmt.span);
        find_stores(stmt.body);
        conditions_.back().is_true = false;
        find_stores(stmt.otherwise);
        conditions_.pop_back();
        spans_.pop_back();
    }
}

void TransposedAccesses::note_store(StmtId id) {
    const Stmt& stmt = cx.p.stmts[id];
    std::optional<TransposedAccess> access = transposed(stmt.slot, cx.build.type(stmt.value), stmt.target);
    if (!access) return;
    access->store = id;
    access->conditions = conditions_;
    // The guards that the expander makes have the span of the statement.
    const auto is_of_source = [&](const Span& span) { return span != stmt.span; };
    access->is_conditional = std::ranges::any_of(spans_, is_of_source);
    stores_.push_back(std::move(*access));
}

/// Leaves out operands that are not always evaluated.
void TransposedAccesses::find_loads(ExprId id) {
    if (!seen_.insert(id)) return;
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::load || node.op == Op::guarded_load) return note_load(id);
    const bool is_logical =
        node.op == Op::binary && (node.binary == BinaryOp::logical_and || node.binary == BinaryOp::logical_or);
    const std::size_t evaluated = node.op == Op::select || is_logical ? 1 : node.operands.size();
    for (std::size_t i = 0; i < evaluated; ++i) find_loads(node.operands[i]);
}

void TransposedAccesses::note_load(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    const auto is_of_address = [&](ExprId operand) { return this->is_of_address(operand); };
    if (!dependence_.is_fixed(id) || !std::ranges::all_of(node.operands, is_of_address)) return;
    std::optional<TransposedAccess> access =
        transposed(node.slot, node.type, node.operands[node.op == Op::guarded_load ? 1 : 0]);
    if (!access) return;
    const auto is_same = [&](const TransposedAccess& one) { return numbers_.of(one.loads[0]) == numbers_.of(id); };
    if (const auto found = std::ranges::find_if(loads_, is_same); found != loads_.end())
        return found->loads.push_back(id);
    access->loads.push_back(id);
    loads_.push_back(std::move(*access));
}

/// Whether one statement writes the memory, and none reads it.
bool TransposedAccesses::is_only_access(std::uint32_t binding, const std::vector<StmtId>& body) const {
    const auto is_same = [&](std::uint32_t slot) {
        return cx.pass.bindings[slot].one_place == cx.pass.bindings[binding].one_place;
    };
    for (std::uint32_t slot = 0; slot < cx.pass.bindings.size(); ++slot)
        if (is_same(slot) && cx.pass.bindings[slot].access != Access::write) return false;
    std::size_t writes = 0;
    for_each_statement(cx.p, body, [&](const Stmt& stmt) {
        const bool is_write = stmt.op == StmtOp::store || stmt.op == StmtOp::image_store || stmt.op == StmtOp::atomic;
        writes += is_write && is_same(stmt.slot);
    });
    return writes == 1;
}

std::optional<TransposedAccess> TransposedAccesses::transposed(std::uint32_t slot, TypeId type, ExprId address) {
    const PassBinding& binding = cx.pass.bindings[slot];
    const std::uint32_t bytes = bytes_of(cx.p, type);
    if (binding.shape != MemoryShape::buffer || binding.in_rows || binding.atomic || binding.coherent) return {};
    if (type != binding.element || bytes > largest_element || !is_of_address(address)) return {};
    const Slope along_x = slopes_[0].of(address)[0];
    if (along_x.known && distance(along_x.step) * bytes < sector) return {};
    for (std::uint32_t axis = 1; axis < cx.pass.rank; ++axis) {
        const Slope slope = slopes_[axis].of(address)[0];
        if (slope.known && distance(slope.step) == 1)
            return TransposedAccess{.binding = slot, .axis = axis, .bytes = bytes};
    }
    return {};
}

}  // namespace gliftc::lower
