// Expander: checks of checked builds (gliftc --checked). Accesses by address outside a structure are reported.
//
// Reported is a read, write or atomic operation by address, in a kernel or a function that it calls, outside the domain
// (or range) of a structure that does not define what lies outside. A structure defines that by an `otherwise`, its own
// or that of a structure in its chain of memories (ir/chain.h), or by a first translator that is partial (a border, a
// page table). Not reported are accesses by translators, views and functions of blocks, which may rely on reading zeros
// outside, those of kernels declared @accesses_outside, and `load`, `near`, `sample`, `gather`, `compare`, `find` and
// `contains`, which are meant for addresses that may be outside.
#include "ir/chain.h"
#include "lower/expand/expand.h"

namespace gliftc::lower {

using namespace ir;

bool Expander::checks_range(const Place& place) {
    const Structure& structure = cx.structure_at(place);
    return cx.checks == Checks::ranges && within_ == 0 && !cx.kernel.accesses_outside && is_total(structure) &&
           !says_otherwise(p, structure, place);
}

void Expander::check_range(const Place& place, ExprId address, Access access, Span span) {
    if (!checks_range(place)) return;
    const Structure& structure = cx.structure_at(place);
    ExprId outside = build.negate(inside_domain(place, address));
    // Invocations beyond the range, which only fill up workgroups, report nothing.
    if (cx.kernel.grouped()) outside = build.both(build.local(cx.pass.in_range), outside);
    if (build.is_false(outside)) return;
    Stmt report = statement(StmtOp::report, span ? span : span_);
    report.slot = is_computed(p, structure) ? no_binding : binding(place, access);
    report.target = address;
    append_if(outside, collect([&] { append(std::move(report)); }), {});
}

}  // namespace gliftc::lower
