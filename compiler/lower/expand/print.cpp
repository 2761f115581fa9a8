// Expander: messages of `print` and `assert`. A message begins with the address of the visited element in its
// structure, which is the same in all forms and on all devices.
#include "ir/effects.h"
#include "lower/expand/expand.h"

namespace gliftc::lower {

using namespace ir;

/// The address of the visited element in the first structure that the kernel visits.
ExprId Expander::visited_element() {
    if (cx.kernel.space) return centre_address(*cx.kernel.space);
    const std::vector<KernelParam>& params = cx.kernel.params;
    const auto has = [&](Course course) {
        return std::ranges::find_if(
            params, [&](const KernelParam& param) { return traits_of(param.pattern).course == course; });
    };
    auto visited = has(Course::visits);
    if (visited == params.end()) visited = has(Course::follows);
    return centre_address(static_cast<std::uint32_t>(visited - params.begin()));
}

void Expander::print(const Stmt& stmt) {
    const ExprId address = visited_element();
    Operands words;
    for (std::uint32_t axis = 0; axis < p.types.components(build.type(address)); ++axis)
        words.push_back(p.types.is_vector(build.type(address)) ? build.component(address, axis) : address);
    if (stmt.value)
        for (ExprId word : Operands(p.exprs[stmt.value].operands)) words.push_back(value_of(word));
    Stmt made = statement(StmtOp::print, stmt.span);
    made.slot = stmt.slot;
    made.value = build.construct(p.types.array(p.types.uint, static_cast<std::uint32_t>(words.size())), words);
    // Invocations beyond the range, which only fill up workgroups, print nothing.
    if (!cx.kernel.grouped()) return append(std::move(made));
    append_if(build.local(cx.pass.in_range), collect([&] { append(std::move(made)); }), {});
}

}  // namespace gliftc::lower
