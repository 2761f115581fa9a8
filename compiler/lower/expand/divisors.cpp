// Expander: unsigned divisors that are computed from the state of structures alone. In the language, dividing an
// integer by zero is dividing it by one. Such divisors are uniform, so the host computes max(divisor, 1) and shaders
// need no test. The extents of structures that are visited, or read around the visited element (`near`), need no max:
// they are not zero, or the kernel would not run. The printer of GLSL relies on all this: where a parameter that is
// computed from the state of structures alone is a divisor, it makes no test for zero (emit/glsl/guards.cpp).
#include "ir/walk.h"
#include "lower/expand/expand.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

bool is_visited(Pattern pattern) {
    return pattern == Pattern::each || pattern == Pattern::near || pattern == Pattern::at;
}

/// Whether the value depends on a local other than immutable ones, whose definitions are looked at instead.
bool depends_on_locals(Context& cx, ExprId id) {
    bool depends = false;
    for_each_node(cx.p, id, [&](ExprId part) {
        if (depends || cx.p.exprs[part].op != Op::local) return;
        const ExprId* definition = cx.definitions.find(cx.p.exprs[part].local);
        depends = definition == nullptr || depends_on_locals(cx, *definition);
    });
    return depends;
}

}  // namespace

/// Whether the value is the extent, or a component of it, of a structure given as `each`, `near` or `at`.
bool Expander::is_visited_extent(ExprId id) {
    for (std::uint32_t root = 0; root < cx.kernel.params.size(); ++root) {
        if (!is_visited(cx.kernel.params[root].pattern)) continue;
        const ExprId domain = domain_of({root, {}});
        if (numbers_.of(domain) == numbers_.of(id)) return true;
        const std::uint32_t axes = p.types.components(build.type(domain));
        for (std::uint32_t axis = 0; axis < axes; ++axis)
            if (numbers_.of(build.component(domain, axis)) == numbers_.of(id)) return true;
    }
    return false;
}

ExprId Expander::divisor(ExprId id) {
    const TypeId type = build.type(id);
    const TypeId scalar = p.types.scalar_of(type);
    const bool is_unsigned = p.types.is_integer(scalar) && !p.types.is_signed(scalar);
    if (!is_unsigned || build.is_constant(id) || !is_uniform(cx, id)) return id;
    if (depends_on_locals(cx, id) || compares_extents_) return id;
    compares_extents_ = true;  // is_visited_extent makes the extents, whose own divisors then stay as they are
    const bool is_visited = is_visited_extent(id);
    compares_extents_ = false;
    if (is_visited) return id;
    const ExprId one = build.integer(scalar, 1);
    return build.intrinsic(Intrinsic::max, type, {id, p.types.is_vector(type) ? build.construct(type, {one}) : one});
}

}  // namespace gliftc::lower
