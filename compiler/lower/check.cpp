// Checked builds: accesses by address that miss their structure are reported.
//
// What is a mistake: a read or write by address, in a kernel or a function that it calls, outside the domain of a
// structure that says nothing about its outside. A structure says something by `otherwise` or by a first translator
// that itself tells some addresses to be nowhere (a border, a page table). Translators and views may rely on zeros
// outside; so may `near`, `sample`, `find` and `contains`, which exist to be asked about neighbours.
#include "ir/chain.h"
#include "lower/expand.h"

namespace gliftc::lower {

using namespace ir;

bool Expander::checks_range(const Place& place) {
    const Structure& structure = cx.structure_at(place);
    return cx.checks == Checks::ranges && within_ == 0 && is_total(structure) && !says_otherwise(p, structure, place);
}

void Expander::check_range(const Place& place, ExprId address, Access access, Span span) {
    if (!checks_range(place)) return;
    const Structure& structure = cx.structure_at(place);
    ExprId outside = make.negate(inside_domain(place, address));
    // Invocations that only fill up the last workgroup do not count.
    if (cx.kernel.grouped()) outside = make.both(make.local(cx.pass.in_range), outside);
    if (make.is_false(outside)) return;
    Stmt report = statement(StmtOp::report, span ? span : span_);
    report.slot = is_computed(p, structure) ? no_binding : binding(place, access);
    report.target = address;
    append_if(outside, collect([&] { append(std::move(report)); }), {});
}

}  // namespace gliftc::lower
