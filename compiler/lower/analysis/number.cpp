#include "lower/analysis/number.h"

#include "ir/effects.h"
#include "ir/walk.h"

#include <algorithm>
#include <bit>

namespace gliftc::lower {

using namespace ir;

namespace {

bool has_effect(const Pass& pass, const Expr& node) {
    if (node.op == Op::load || node.op == Op::guarded_load || node.op == Op::image_load)
        return pass.bindings[node.slot].coherent;  // each load may see what another workgroup has written meanwhile
    if (node.op != Op::intrinsic) return false;
    return signature_of(node.intrinsic)[0] == '@' || is_collective(node.intrinsic);
}

}  // namespace

bool Numbers::is_written(std::uint32_t binding) const {
    const std::uint32_t place = cx.pass.bindings[binding].one_place;
    return std::ranges::any_of(cx.pass.bindings, [&](const PassBinding& other) {
        return other.one_place == place && other.access != Access::read;
    });
}

/// The traits that a call has because of the function's body: `changes` if it reads memory that the pass writes,
/// `impure` if it has an effect or loads coherent memory, which other workgroups may write meanwhile. `seen`: the
/// functions that have been looked at.
std::uint8_t Numbers::traits_of_body(FunctionId function, std::unordered_set<FunctionId>& seen) const {
    if (!cx.made_functions.contains(function) || !seen.insert(function).second) return 0;
    std::uint8_t trait = 0;
    for_each_expression(cx.p, cx.p.functions[function].body, [&](ExprId id) {
        const Expr& node = cx.p.exprs[id];
        if (has_effect(cx.pass, node)) trait |= impure;
        if (is_load(node.op) && is_written(node.slot)) trait |= changes;
        if (node.op == Op::call) trait |= traits_of_body(node.function, seen);
    });
    return trait;
}

std::uint8_t Numbers::find_traits(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    std::uint8_t trait = known;
    if (has_effect(cx.pass, node)) trait |= impure;
    if (node.op == Op::local) {
        const Local& local = cx.p.locals[node.local];
        if (local.is_mutable || local.storage == Storage::shared) trait |= changes;
    }
    if (is_load(node.op)) {
        trait |= loads;
        if (is_written(node.slot)) trait |= changes;
    }
    if (node.op == Op::call) {
        std::unordered_set<FunctionId> seen;
        trait |= loads | traits_of_body(node.function, seen);
    }
    for (ExprId operand : node.operands) trait |= traits_of(operand) & (impure | loads | changes);
    cx.traits.emplace(id, trait);
    return trait;
}

/// A hash of the node without its operands, and of the version of the local or memory that it reads.
ShapeKey Numbers::shape_of(const Expr& node) const {
    ShapeKey key;
    key.mix(static_cast<std::uint64_t>(node.op) << 32 | node.type.index);
    switch (node.op) {
    case Op::constant:
        key.mix(node.bits);
        key.mix(std::bit_cast<std::uint64_t>(node.number));
        break;
    case Op::local: key.mix(std::uint64_t{version_of(node.local)} << 32 | node.local.index); break;
    case Op::unary: key.mix(static_cast<std::uint64_t>(node.unary)); break;
    case Op::binary: key.mix(static_cast<std::uint64_t>(node.binary)); break;
    case Op::swizzle: key.mix(std::bit_cast<std::uint32_t>(node.lanes)); break;
    case Op::field:
    case Op::parameter: key.mix(node.slot); break;
    case Op::call: key.mix(node.function.index); break;
    case Op::intrinsic: key.mix(static_cast<std::uint64_t>(node.intrinsic)); break;
    case Op::member:
    case Op::memory_extent:
    case Op::host_state:
    case Op::domain:
        key.mix(node.slot);
        key.mix(node.place.root);
        for (std::uint32_t member : node.place.members) key.mix(member);
        break;
    case Op::guarded_load:
    case Op::load:
    case Op::image_load:
    case Op::image_sample:
    case Op::image_gather:
    case Op::image_compare:
        key.mix(node.slot);
        key.mix(version_of(cx.pass.bindings[node.slot].one_place));
        break;
    case Op::builtin: key.mix(static_cast<std::uint64_t>(node.builtin)); break;
    default: break;  // told apart by op, type and operands
    }
    return key;
}

ValueNumber Numbers::of(ExprId id) {
    if (ValueNumber number = memory_->known(id)) return number;
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::local) {
        if (const ValueNumber* found = locals_.find(node.local)) return *found;
    }
    const std::uint8_t traits = traits_of(id);
    ShapeKey key = shape_of(node);
    if ((traits & impure) && (node.op == Op::call || has_effect(cx.pass, node)))
        key.mix(++next_ + (std::uint64_t{1} << 32));
    if (node.op == Op::call && (traits & changes))  // the function may load from any of these memories
        for (const PassBinding& binding : cx.pass.bindings) key.mix(version_of(binding.one_place));
    for (ExprId operand : node.operands) key.mix(of(operand));
    ValueNumber& number = memory_->number_of(key);
    if (number == 0) number = ++next_;
    // An expression with an effect may have another value at each evaluation.
    if (!(traits & impure)) memory_->learn(id, number, !(traits & changes));
    return number;
}

void Numbers::change_all(const std::vector<StmtId>& body) {
    for (StmtId id : body) change_all(cx.p.stmts[id]);
}

void Numbers::change_all(const Stmt& stmt) {
    change_by(stmt);
    change_all(stmt.body);
    change_all(stmt.otherwise);
}

/// Notes what the statement itself changes; the statements nested in it are left out.
void Numbers::change_by(const Stmt& stmt) {
    if (stmt.op == StmtOp::assign) {
        ExprId root = stmt.target;
        while (cx.p.exprs[root].op != Op::local) root = cx.p.exprs[root].operands[0];
        change(cx.p.exprs[root].local);
    }
    if (stmt.op == StmtOp::store || stmt.op == StmtOp::image_store || stmt.op == StmtOp::atomic)
        change_binding(stmt.slot);
    if (stmt.op == StmtOp::barrier || stmt.op == StmtOp::subgroup_barrier) {
        for (std::uint32_t i = 0; i < cx.pass.bindings.size(); ++i) change_binding(i);
        for (LocalId local : cx.pass.shared) change(local);
    }
    // An effect may be an atomic operation on workgroup memory.
    bool has_atomic = false;
    for_each_root(stmt, [&](ExprId root) { has_atomic = has_atomic || !is_pure(root); });
    if (has_atomic)
        for (LocalId local : cx.pass.shared) change(local);
}

}  // namespace gliftc::lower
