#include "sema/structures/replace.h"

#include "ir/evaluate.h"
#include "ir/walk.h"
#include "sema/pipelines/predication.h"

#include <algorithm>
#include <map>
#include <set>

namespace gliftc::sema {

namespace {

/// Why the memory of a structure cannot be replaced; empty if it can.
std::string why_kept(Body& body, const Operand& target) {
    if (target.local || !body.container) return "it is no member of the container whose pipeline this is";
    const ir::Structure& container = body.program().structures[body.container];
    if (target.place.members.size() != 1) return "it is a part of a member: replace the member as a whole";
    const std::uint32_t member = target.place.members[0];
    if (container.members[member].by_reference) return "it was given to " + container.display + ", whose it is not";
    return "";
}

/// Compares the structures that the constructors of `temporary` and `member` are given. Whether, in each position where
/// `member` is given the container's member number `given`, or a part of it, `temporary` is given the local `other`, or
/// the same part of that.
bool is_made_over(const Body& body, ir::LocalId temporary, const ir::MemberStructure& member, std::uint32_t given,
                  ir::LocalId other) {
    std::vector<ir::Expr> structures;
    for (ir::ExprId argument : body.made.at(temporary))
        if (const ir::Expr& expr = body.context.program.exprs[argument];
            body.context.program.types.kind(expr.type) == ir::TypeKind::structure)
            structures.push_back(expr);
    if (structures.size() != member.structures.size()) return false;
    for (std::size_t k = 0; k < structures.size(); ++k) {
        const ir::Place& place = member.structures[k];
        if (place.members.empty() || place.members[0] != given) continue;
        const std::vector<std::uint32_t> rest(place.members.begin() + 1, place.members.end());
        if (structures[k].local != other || !std::ranges::equal(structures[k].place.members, rest)) return false;
    }
    return true;
}

/// The temporary that the name denotes, if it is declared in the innermost block.
std::optional<ir::LocalId> temporary_of(const Body& body, const ast::Expr& value, const Operand& operand) {
    const bool is_whole = operand.kind == OperandKind::structure && operand.local && operand.place.members.empty() &&
                          !operand.is_slice && body.made.contains(operand.local);
    if (!is_whole || value.kind != ast::ExprKind::name) return std::nullopt;
    return body.scopes.back().contains(value.name) ? std::optional(operand.local) : std::nullopt;
}

/// A structure, and the index of its member.
using Member = std::pair<ir::StructureId, std::uint32_t>;

/// Calls visit(const Stmt&) for all statements that may run: an `if` with a constant condition is entered on one side
/// only.
template <class Visit>
void for_each_running(const ir::Program& program, const std::vector<ir::StmtId>& body, Visit&& visit) {
    for (ir::StmtId id : body) {
        const ir::Stmt& stmt = program.stmts[id];
        visit(stmt);
        std::optional<ir::Value> known;
        if (stmt.op == ir::StmtOp::if_) known = ir::evaluate(program, stmt.value);
        if (!known || known->bits()) for_each_running(program, stmt.body, visit);
        if (!known || !known->bits()) for_each_running(program, stmt.otherwise, visit);
    }
}

/// The pipelines that may run: public ones, and those that any pipeline calls.
std::set<ir::PipelineId> running_pipelines(const ir::Program& program) {
    std::set<ir::PipelineId> running;
    for (ir::PipelineId i : program.pipelines.ids()) {
        if (program.pipelines[i].is_pub) running.insert(i);
        for_each_running(program, program.pipelines[i].body, [&](const ir::Stmt& stmt) {
            ir::for_each_root(stmt, [&](ir::ExprId root) {
                ir::for_each_node(program, root, [&](ir::ExprId node) {
                    const ir::Expr& expr = program.exprs[node];
                    if (expr.op == ir::Op::pipeline_call) running.insert(expr.pipeline());
                });
            });
        });
    }
    return running;
}

/// The members whose memory some pipeline replaces, and where.
std::map<Member, Span> replaced_members(const ir::Program& program) {
    std::map<Member, Span> replaced;
    for (ir::PipelineId i : running_pipelines(program)) {
        const ir::Pipeline& pipeline = program.pipelines[i];
        for_each_running(program, pipeline.body, [&](const ir::Stmt& stmt) {
            if (stmt.op == ir::StmtOp::replace && pipeline.owner)
                replaced.emplace(Member(pipeline.owner, stmt.place.members[0]), stmt.span);
        });
    }
    return replaced;
}

/// Where a member on the path from a structure is replaced, if one is; the first `first` steps of the path do not
/// count.
std::optional<Span> replaced_on_path(const ir::Program& program, const std::map<Member, Span>& replaced,
                                     ir::StructureId structure, const ir::Place& place, std::size_t first) {
    for (std::size_t k = 0; k < place.members.size(); ++k) {
        const auto found = replaced.find(Member(structure, place.members[k]));
        if (k >= first && found != replaced.end()) return found->second;
        structure = program.structures[structure].members[place.members[k]].structure;
    }
    return std::nullopt;
}

std::string path_text(const Context& c, const ir::Structure& structure, const ir::Place& place) {
    std::string text;
    const ir::Structure* at = &structure;
    for (std::uint32_t member : place.members) {
        text += (text.empty() ? "" : ".") + std::string(c.text(at->members[member].name));
        at = &c.program.structures[at->members[member].structure];
    }
    return text;
}

}  // namespace

void check_replaced_together(Body& body) {
    for (const Body::Replacement& replaced : body.replacements) {
        const ir::Structure& container = body.program().structures[body.container];
        for (std::uint32_t i = 0; i < container.members.size(); ++i) {
            const ir::MemberStructure& member = container.members[i];
            const bool is_given = std::ranges::any_of(member.structures, [&](const ir::Place& place) {
                return !place.members.empty() && place.members[0] == replaced.member;
            });
            const bool is_made_anew = std::ranges::any_of(body.replacements, [&](const Body::Replacement& other) {
                return other.member == i && other.block == replaced.block &&
                       is_made_over(body, other.temporary, member, replaced.member, replaced.temporary);
            });
            if (!is_given || is_made_anew) continue;
            const std::string name(body.context.text(member.name));
            Diagnostic& error = body.context.error(Diag::replaced_member, replaced.span);
            note(error, replaced.span, "it was given to the member '" + name + "', which would keep it");
            note(error, replaced.span,
                 "give '" + name + "' other memory in the same block: a temporary made over this one");
        }
    }
}

void check_given(Context& c) {
    const std::map<Member, Span> replaced = replaced_members(c.program);
    if (replaced.empty()) return;
    for (ir::StructureId i : c.program.structures.ids()) {
        const ir::Structure& structure = c.program.structures[i];
        const auto check = [&](Name name, Span span, const ir::Place& place, std::size_t first) {
            const std::optional<Span> where = replaced_on_path(c.program, replaced, i, place, first);
            if (!where) return;
            const std::string given = path_text(c, structure, place);
            Diagnostic& error = c.error(Diag::given_replaced, span, {c.text(name), given});
            note(error, *where, "here " + given + " may get other memory");
            note(error, span, "make it where it is used, in pipelines: let " + std::string(c.text(name)) + " = …");
        };
        // Step 0 is a member of the container itself, which check_replaced_together() checks.
        for (const ir::MemberStructure& member : structure.members)
            for (const ir::Place& place : member.structures) check(member.name, member.span, place, 1);
        for (const ir::Memory& memory : structure.memories)
            if (memory.part) check(memory.name, memory.span, memory.part->of, 0);
    }
}

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
    body.replacements.push_back({target.place.members[0], *temporary, written.span, body.block});
    emit(body, id);
    body.scopes.back().erase(c[stmt.value].name);  // its memory is the member's: the name ends here
    return true;
}

}  // namespace gliftc::sema
