#include "sema/replace.h"

#include "sema/arms.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

/// Why a structure keeps the memory that it has; empty: it can get other memory.
std::string why_kept(Body& body, const Operand& target) {
    if (target.local || !body.container) return "it is no member of the container whose pipeline this is";
    const ir::Structure& container = body.program().structures[*body.container];
    if (container.kind != ir::StructureKind::adaptor) return container.display + " is not an adaptor";
    if (target.place.members.size() != 1) return "it is a part of a member: replace the member as a whole";
    const std::uint32_t member = target.place.members[0];
    if (container.members[member].by_reference) return "it was given to " + container.display + ", whose it is not";
    for (const ir::MemberStructure& other : container.members) {
        const bool is_given = std::ranges::any_of(other.structures, [&](const ir::Place& place) {
            return !place.members.empty() && place.members[0] == member;
        });
        if (is_given) return "it was given to the member '" + body.context.text(other.name) + "', which would keep it";
    }
    return "";
}

/// The temporary of this block that a name stands for.
std::optional<ir::LocalId> temporary_of(const Body& body, const ast::Expr& value, const Operand& operand) {
    const bool is_whole = operand.kind == OperandKind::structure && operand.local && operand.place.members.empty() &&
                          !operand.is_slice && body.made.contains(operand.local);
    if (!is_whole || value.kind != ast::ExprKind::name) return std::nullopt;
    return body.scopes.back().contains(value.name) ? std::optional(operand.local) : std::nullopt;
}

}  // namespace

bool check_replace(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    const ast::Expr& written = c[stmt.target];
    const bool may_be = written.kind == ast::ExprKind::name || written.kind == ast::ExprKind::member;
    if (body.kind != BodyKind::pipeline || !may_be || stmt.op) return false;
    if (written.kind == ast::ExprKind::name && !find_symbol(body, written.name)) return false;
    const Operand target = check(body, stmt.target);
    if (target.kind != OperandKind::structure || target.is_slice) return false;
    if (const std::string why = why_kept(body, target); !why.empty()) {
        note(c.error(Diag::replaced_member, written.span), written.span, why);
        return true;
    }
    if (is_refused_in_arm(body, "a member that gets other memory", stmt.span,
                          "replace it before or after, whether or not there is need"))
        return true;
    const Operand value = check(body, stmt.value);
    if (value.kind == OperandKind::error) return true;
    const std::optional<ir::LocalId> temporary = temporary_of(body, c[stmt.value], value);
    if (!temporary) {
        note(c.error(Diag::replaced_value, c[stmt.value].span), c[stmt.value].span,
             "make it in this block: temp name = …");
        return true;
    }
    if (value.structure != target.structure) {
        c.error(
            Diag::type_mismatch, c[stmt.value].span,
            {body.program().structures[target.structure].display, body.program().structures[value.structure].display});
        return true;
    }
    needs_host(body, stmt.span);
    const ir::StmtId id = add(body.program(), ir::StmtOp::replace, stmt.span);
    body.program().stmts[id].place = target.place;
    body.program().stmts[id].local = *temporary;
    emit(body, id);
    body.scopes.back().erase(c[stmt.value].name);  // its memory is the member's
    return true;
}

}  // namespace gliftc::sema
