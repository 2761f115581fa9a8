#include "sema/kernels/aliasing.h"

#include "ir/chain.h"
#include "ir/effects.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

/// The fields of elements of the root that a structure of its chain has as its elements (ir::fields_in).
std::vector<std::uint32_t> fields_of(const ir::Program& p, const ir::Structure& structure) {
    return ir::fields_in(p, structure, ir::root_structure(p, structure));
}

/// Whether two such paths lead to different fields, neither of which contains the other.
bool are_other_fields(const std::vector<std::uint32_t>& one, const std::vector<std::uint32_t>& other) {
    const auto [a, b] = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
    return a != one.end() && b != other.end();
}

/// A structure as a Glift pipeline (a host function that calls kernels) names it: a local, then a path of members from
/// it.
struct Whole {
    ir::LocalId local;
    ir::Place place;
    bool operator==(const Whole&) const = default;
};

/// Where `whole` is, or lies in, a member by reference of a temporary: replaces that member by the structure that the
/// temporary's constructor was given for it, and returns true. Returns false if `whole` does not lie in such a member,
/// or if the argument for it is no Op::structure_value.
bool follow_given(Body& body, Whole& whole) {
    const ir::Program& p = body.program();
    if (!whole.local || whole.place.members.empty()) return false;  // without a local: a member of the container itself
    const auto made = body.made.find(whole.local);
    const ir::Structure& structure = p.structures[p.types[p.locals[whole.local].type].structure];
    whole.place.members = ir::made_at(p, structure, whole.place.members);
    const std::uint32_t member = whole.place.members[0];
    if (made == body.made.end() || !structure.members[member].by_reference) return false;
    // Members by reference come first, in the order of the constructor's structure arguments.
    std::uint32_t given = 0;
    for (ir::ExprId argument : made->second) {
        const ir::Expr& expr = p.exprs[argument];
        if (p.types.kind(expr.type) != ir::TypeKind::structure || given++ != member) continue;
        if (expr.op != ir::Op::structure_value) return false;
        Whole next{expr.local, expr.place};
        next.place.members.append(whole.place.members.begin() + 1, whole.place.members.end());
        whole = std::move(next);
        return true;
    }
    return false;
}

/// The root of an argument: the last structure of its chain (ir/chain.h), which stores or computes the elements. If
/// that structure is a member that was given to the constructor of its owner, the result is the path to the structure
/// that was given, so that paths can be compared. None for slices and values.
std::optional<Whole> root_of(Body& body, const ir::Expr& argument) {
    const ir::Program& p = body.program();
    if (argument.op != ir::Op::structure_value || p.types.kind(argument.type) != ir::TypeKind::structure)
        return std::nullopt;
    const ir::Structure& structure = p.structures[p.types[argument.type].structure];
    Whole whole{argument.local, ir::root_of(p, structure, argument.place)};
    while (follow_given(body, whole)) {}
    return whole;
}

bool are_one_structure(const ir::Expr& one, const ir::Expr& other) {
    return one.local == other.local && one.place == other.place;
}

void report(Context& c, Diag id, const ir::Kernel& kernel, const ir::KernelParam& one, const ir::KernelParam& other,
            Span span) {
    Diagnostic& diagnostic = c.error(id, span, {c.text(one.name), c.text(other.name), c.text(kernel.name)});
    note(diagnostic, one.span, "'" + c.text(one.name) + "' is declared here");
    note(diagnostic, other.span, "'" + c.text(other.name) + "' is declared here");
    note(diagnostic, span, "write into another structure, then copy or swap");
    const bool reads = one.direction == ir::Direction::in, other_reads = other.direction == ir::Direction::in;
    if (id != Diag::shared_memory || reads == other_reads) return;
    note(diagnostic, kernel.span,
         "or promise that what is read is not written in the same pass: @disjoint(" +
             c.text((reads ? one : other).name) + ", " + c.text((reads ? other : one).name) + ")");
}

/// Whether invocations may race where two parameters share a memory and may map addresses to it differently. Element i
/// of one may then be element j of the other, so that two parameters of which each invocation accesses its own element
/// alone race as soon as one of them is written. Other patterns: as ir::may_meet.
bool may_meet_through_two(const ir::KernelParam& one, const ir::KernelParam& other) {
    const bool is_element = ir::traits_of(one.pattern).reach == ir::Reach::element &&
                            ir::traits_of(other.pattern).reach == ir::Reach::element;
    const bool writes = one.direction != ir::Direction::in || other.direction != ir::Direction::in;
    return is_element ? writes : ir::may_meet(one, other);
}

/// A structure that a kernel accesses, as its root (root_of), and the parameter that leads to it, whose argument has
/// the index `argument`. `fields` are those of the root's elements that it accesses. `is_member`: the parameter has the
/// pattern `calls` (the kernel calls functions of its structure), and the structure is a member that those functions
/// write; `param` then has the pattern by which they write it.
struct Touched {
    Whole root;
    ir::KernelParam param;
    std::vector<std::uint32_t> fields;
    std::uint32_t argument = 0;
    bool is_member = false;
};

std::vector<Touched> touched_by(Body& body, const ir::Kernel& kernel, const ir::Operands& arguments) {
    const ir::Program& p = body.program();
    std::vector<Touched> touched;
    for (std::uint32_t i = 0; i < arguments.size(); ++i) {
        const ir::Expr& argument = p.exprs[arguments[i]];
        const ir::KernelParam& param = kernel.params[i];
        if (param.pattern != ir::Pattern::calls) {
            if (auto root = root_of(body, argument))
                touched.push_back({std::move(*root), param, fields_of(p, p.structures[param.structure]), i});
            continue;
        }
        for (const ir::Effect& effect : kernel.effects) {
            if (effect.place.root != i) continue;
            const ir::Structure& written = ir::structure_at(p, p.structures[param.structure], effect.place.members);
            Whole member{argument.local, argument.place};
            member.place.members.append(effect.place.members);
            member.place = ir::root_of(p, written, member.place);
            while (follow_given(body, member)) {}
            Touched made{std::move(member), param, fields_of(p, written), i, true};
            made.param.pattern = effect.pattern;
            made.param.combine = effect.combine;
            made.param.direction = ir::Direction::inout;
            touched.push_back(std::move(made));
        }
    }
    return touched;
}

}  // namespace

void check_one_memory(Body& body, const ir::Kernel& kernel, const ir::Operands& arguments) {
    Context& c = body.context;
    const std::vector<Touched> touched = touched_by(body, kernel, arguments);
    for (std::size_t k = 1; k < touched.size(); ++k) {
        const ir::Expr& second = c.program.exprs[arguments[touched[k].argument]];
        for (std::size_t i = 0; i < k; ++i) {
            const Touched &a = touched[i], &b = touched[k];
            if (a.root != b.root || a.argument == b.argument) continue;
            if (are_other_fields(a.fields, b.fields)) continue;
            if (ir::is_promised_apart(kernel, a.argument, b.argument)) continue;
            if (a.is_member || b.is_member) {
                if (may_meet_through_two(a.param, b.param))
                    return report(c, Diag::shared_memory, kernel, a.param, b.param, second.span);
            } else if (are_one_structure(c.program.exprs[arguments[a.argument]], second)) {
                if (ir::may_meet(a.param, b.param))
                    return report(c, Diag::one_memory, kernel, a.param, b.param, second.span);
            } else if (may_meet_through_two(a.param, b.param)) {
                return report(c, Diag::shared_memory, kernel, a.param, b.param, second.span);
            }
        }
    }
}

}  // namespace gliftc::sema
