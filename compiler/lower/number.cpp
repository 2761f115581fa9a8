#include "lower/number.h"

#include "ir/walk.h"

#include <bit>

namespace gliftc::lower {

using namespace ir;

namespace {

enum Trait : std::uint8_t { known = 1, impure = 2, loads = 4, changes = 8 };

bool has_effect(const Expr& node) {
    if (node.op != Op::intrinsic) return false;
    std::string_view signature = signature_of(node.intrinsic);
    return signature[0] == '@' || signature.back() == '*';
}

}  // namespace

bool Numbers::is_pure(ExprId id) {
    is_fixed(id);
    return !(traits_[id] & impure);
}

bool Numbers::has_load(ExprId id) {
    is_fixed(id);
    return traits_[id] & loads;
}

bool Numbers::is_fixed(ExprId id) {
    auto [found, is_new] = traits_.try_emplace(id, known);
    if (!is_new) return !(found->second & (changes | impure));
    const Expr& node = cx.p.exprs[id];
    std::uint8_t trait = known;
    if (has_effect(node)) trait |= impure;
    if (node.op == Op::local) {
        const Local& local = cx.p.locals[node.local];
        if (local.is_mutable || local.storage == Storage::shared) trait |= changes;
    }
    if (node.op == Op::load || node.op == Op::image_load || node.op == Op::image_sample) {
        trait |= loads;
        if (cx.pass.bindings[node.slot].access != Access::read) trait |= changes;
    }
    // A function made for this pass may load.
    if (node.op == Op::call) trait |= loads;
    for (ExprId operand : node.operands) {
        is_fixed(operand);
        trait |= traits_[operand] & (impure | loads | changes);
    }
    traits_[id] = trait;
    return !(trait & (changes | impure));
}

ValueNumber Numbers::of(ExprId id) {
    if (auto found = fixed_.find(id); found != fixed_.end()) return found->second;
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::local) {
        if (auto found = locals_.find(node.local); found != locals_.end()) return found->second;
    }
    std::vector<std::uint64_t> key{static_cast<std::uint64_t>(node.op), node.type.index};
    auto word = [&](std::uint64_t value) { key.push_back(value); };
    switch (node.op) {
    case Op::constant:
        word(node.bits);
        word(std::bit_cast<std::uint64_t>(node.number));
        break;
    case Op::local:
        word(node.local.index);
        word(versions_[node.local]);
        break;
    case Op::unary: word(static_cast<std::uint64_t>(node.unary)); break;
    case Op::binary: word(static_cast<std::uint64_t>(node.binary)); break;
    case Op::swizzle:
        for (std::uint8_t lane : node.lanes) word(lane);
        break;
    case Op::field:
    case Op::parameter: word(node.slot); break;
    case Op::call: word(node.function.index); break;
    case Op::intrinsic: word(static_cast<std::uint64_t>(node.intrinsic)); break;
    case Op::member:
    case Op::memory_extent:
    case Op::domain:
        word(node.slot);
        word(node.place.root);
        for (std::uint32_t member : node.place.members) word(member);
        break;
    case Op::load:
    case Op::image_load:
    case Op::image_sample:
        word(node.slot);
        word(bindings_[node.slot]);
        break;
    case Op::builtin: word(static_cast<std::uint64_t>(node.builtin)); break;
    default: break;  // told apart by op, type and operands
    }
    if (!is_pure(id) && has_effect(node)) word(++next_ + (std::uint64_t{1} << 32));
    for (ExprId operand : node.operands) word(of(operand));
    auto [found, is_new] = table_.try_emplace(std::move(key), next_ + 1);
    if (is_new) ++next_;
    if (is_fixed(id)) fixed_.emplace(id, found->second);
    return found->second;
}

void Numbers::change_all(const std::vector<StmtId>& body) {
    for_each_statement(cx.p, body, [&](const Stmt& stmt) {
        if (stmt.op == StmtOp::assign) {
            ExprId root = stmt.target;
            while (cx.p.exprs[root].op != Op::local) root = cx.p.exprs[root].operands[0];
            change(cx.p.exprs[root].local);
        }
        if (stmt.op == StmtOp::store || stmt.op == StmtOp::image_store || stmt.op == StmtOp::atomic) change_binding(stmt.slot);
        if (stmt.op == StmtOp::barrier) {
            for (std::uint32_t i = 0; i < cx.pass.bindings.size(); ++i) change_binding(i);
            for (LocalId local : cx.pass.shared) change(local);
        }
        // Atomic operations write workgroup memory.
        bool has_atomic = false;
        for_each_root(stmt, [&](ExprId root) { has_atomic = has_atomic || !is_pure(root); });
        if (has_atomic)
            for (LocalId local : cx.pass.shared) change(local);
    });
}

}  // namespace gliftc::lower
