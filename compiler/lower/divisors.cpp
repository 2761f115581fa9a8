// Divisors that the state of structures decides. Dividing by zero divides by one; what is uniform is computed by the
// host, so that it makes a one of a zero and shaders test nothing. What is visited has at least one element: its
// extents are as they are. Printers rely on it: a parameter made of structures alone is no zero where it divides.
#include "ir/walk.h"
#include "lower/expand.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

bool is_visited(Pattern pattern) {
    return pattern == Pattern::each || pattern == Pattern::near || pattern == Pattern::at;
}

}  // namespace

/// Whether the value is the extent of a range's structure, along one axis or as a whole.
bool Expander::is_visited_extent(ExprId id) {
    for (std::uint32_t root = 0; root < cx.kernel.params.size(); ++root) {
        if (!is_visited(cx.kernel.params[root].pattern)) continue;
        const ExprId domain = domain_of({root, {}});
        if (numbers_.of(domain) == numbers_.of(id)) return true;
        const std::uint32_t axes = p.types.components(make.type(domain));
        for (std::uint32_t axis = 0; axis < axes; ++axis)
            if (numbers_.of(make.component(domain, axis)) == numbers_.of(id)) return true;
    }
    return false;
}

ExprId Expander::divisor(ExprId id) {
    const TypeId type = make.type(id);
    const TypeId scalar = p.types.scalar_of(type);
    const bool is_unsigned = p.types.is_integer(scalar) && !p.types.is_signed(scalar);
    if (!is_unsigned || make.is_constant(id) || !is_uniform(cx, id)) return id;
    bool is_state = true;
    for_each_node(p, id, [&](ExprId part) { is_state = is_state && p.exprs[part].op != Op::local; });
    if (!is_state || compares_extents_) return id;
    compares_extents_ = true;  // what a visited extent is itself divided by is left as it is
    const bool is_visited = is_visited_extent(id);
    compares_extents_ = false;
    if (is_visited) return id;
    const ExprId one = make.integer(scalar, 1);
    return make.intrinsic(Intrinsic::max, type, {id, p.types.is_vector(type) ? make.construct(type, {one}) : one});
}

}  // namespace gliftc::lower
