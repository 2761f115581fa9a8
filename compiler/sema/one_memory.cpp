#include "sema/one_memory.h"

#include "ir/chain.h"
#include "ir/effects.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

/// A structure of a pipeline: a local, then members.
struct Whole {
    ir::LocalId local;
    ir::Place place;
    bool operator==(const Whole&) const = default;
};

/// What a member that was given to a temporary stands for: the structure that was given.
bool follow_given(Body& body, Whole& whole) {
    const ir::Program& p = body.program();
    const auto made = body.made.find(whole.local);
    if (made == body.made.end() || whole.place.members.empty()) return false;
    const ir::Structure& structure = p.structures[p.types[p.locals[whole.local].type].index];
    const std::uint32_t member = whole.place.members[0];
    if (!structure.members[member].by_reference) return false;
    // Those that are given are the first members, in the order of the arguments.
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

/// Where the elements of a whole structure lie: none for slices and values.
std::optional<Whole> root_of(Body& body, const ir::Expr& argument) {
    const ir::Program& p = body.program();
    if (argument.op != ir::Op::structure_value || p.types.kind(argument.type) != ir::TypeKind::structure)
        return std::nullopt;
    const ir::Structure& structure = p.structures[p.types[argument.type].index];
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

/// Whether invocations may race where one memory is reached through two translators.
bool may_meet_through_two(const ir::KernelParam& one, const ir::KernelParam& other) {
    const bool is_element = ir::traits_of(one.pattern).reach == ir::Reach::element &&
                            ir::traits_of(other.pattern).reach == ir::Reach::element;
    const bool writes = one.direction != ir::Direction::in || other.direction != ir::Direction::in;
    return is_element ? writes : ir::may_meet(one, other);
}

/// Whether the place is a member of a parameter that only writes, and where that one's elements lie.
bool is_written_part(const ir::Program& p, const ir::Kernel& kernel, const ir::Place& place) {
    const ir::KernelParam& param = kernel.params[place.root];
    if (place.members.empty() || param.pattern != ir::Pattern::scatter) return false;
    const ir::Structure& whole = p.structures[param.structure];
    const ir::Structure& part = ir::structure_at(p, whole, place.members);
    if (part.kind == ir::StructureKind::adaptor) return false;
    return ir::root_of(p, part, place) == ir::root_of(p, whole, {place.root, {}});
}

}  // namespace

void check_reads_of_written(Context& c, const ir::Kernel& kernel) {
    const ir::Program& p = c.program;
    ir::for_each_expression(p, kernel.body, [&](ir::ExprId id) {
        const ir::Expr& expr = p.exprs[id];
        std::vector<ir::Place> read = expr.places;
        if (expr.op == ir::Op::read || expr.op == ir::Op::sample) read.push_back(expr.place);
        for (const ir::Place& place : read) {
            if (!is_written_part(p, kernel, place)) continue;
            const ir::KernelParam& param = kernel.params[place.root];
            note(c.error(Diag::written_and_read, expr.span, {c.text(param.name), c.text(kernel.name)}), param.span,
                 "a scatter parameter is only written; take the structure as 'inout coherent', or as a second "
                 "parameter with @disjoint");
        }
    });
}

void check_one_memory(Body& body, const ir::Kernel& kernel, const ir::Operands& arguments) {
    Context& c = body.context;
    std::vector<std::optional<Whole>> roots;
    for (ir::ExprId argument : arguments) roots.push_back(root_of(body, c.program.exprs[argument]));
    for (std::uint32_t k = 1; k < arguments.size(); ++k) {
        const ir::Expr& second = c.program.exprs[arguments[k]];
        for (std::uint32_t i = 0; i < k; ++i) {
            if (!roots[i] || roots[i] != roots[k] || ir::is_promised_apart(kernel, i, k)) continue;
            const ir::KernelParam &one = kernel.params[i], &other = kernel.params[k];
            if (are_one_structure(c.program.exprs[arguments[i]], second)) {
                if (ir::may_meet(one, other)) return report(c, Diag::one_memory, kernel, one, other, second.span);
            } else if (may_meet_through_two(one, other)) {
                return report(c, Diag::shared_memory, kernel, one, other, second.span);
            }
        }
    }
}

}  // namespace gliftc::sema
