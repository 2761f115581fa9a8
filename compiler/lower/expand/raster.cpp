// Expander: addresses of the invocations of a draw, which are {vertex, instance} in the vertex part, and pixels in the
// fragment part.
#include "lower/expand/expand.h"

namespace gliftc::lower {

using namespace ir;

/// The address of a parameter's current element, relative to its range: in the vertex part of a draw the vertex or the
/// instance, else the invocation's address.
ExprId Expander::own_address(std::uint32_t root) {
    const ExprId address = build.local(cx.pass.address);
    if (cx.part != Part::vertex) return address;
    return build.component(address, cx.kernel.params[root].pattern == Pattern::instance ? 1 : 0);
}

/// The origin, in the framebuffer, of the range that is drawn to; absent if it is known to be zero.
ExprId Expander::viewport_origin() {
    const std::uint32_t root = *cx.kernel.raster->pixels;
    if (cx.is_direct() || cx.kernel.params[root].pattern != Pattern::target) return {};
    return cx.parameter_expr(
        cx.parameter(ParameterSource::origin, cx.name_of({root, {}}) + "_origin", cx.kernel.domain_type, root));
}

ExprId Expander::window() {
    if (window_) return build.local(window_);
    const TypeId float2 = p.types.vector(p.types.float_, 2), float4 = p.types.vector(p.types.float_, 4);
    ExprId value = build.builtin(Builtin::fragment_place, float4);
    if (const ExprId origin = viewport_origin()) {
        const ExprId first = build.convert(float2, origin);
        const ExprId xy = build.construct(float2, {build.component(value, 0), build.component(value, 1)});
        const ExprId relative = build.binary(BinaryOp::subtract, xy, first);
        value = build.construct(float4, {relative, build.component(value, 2), build.component(value, 3)});
    }
    Block made = collect([&] { window_ = let("window", value, cx.kernel.span); });
    prelude_.insert(prelude_.end(), made.begin(), made.end());
    return build.local(window_);
}

void Expander::declare_address(Part part) {
    const TypeId type = cx.kernel.domain_type, uint = p.types.uint;
    ExprId value;
    if (part == Part::vertex) {
        value = build.construct(type, {build.builtin(Builtin::corner, uint), build.builtin(Builtin::instance, uint)});
    } else {
        const ExprId place = build.builtin(Builtin::fragment_place, p.types.vector(p.types.float_, 4));
        const auto pixel = [&](std::uint32_t axis) { return build.convert(uint, build.component(place, axis)); };
        value = build.construct(type, {pixel(0), pixel(1)});
        if (const ExprId origin = viewport_origin()) value = build.binary(BinaryOp::subtract, value, origin);
    }
    cx.pass.address = {};
    Block made =
        collect([&] { cx.pass.address = let(part == Part::vertex ? "address" : "pixel", value, cx.kernel.span); });
    prelude_.insert(prelude_.end(), made.begin(), made.end());
}

std::vector<StmtId> Expander::draw_part(Part part, const std::vector<StmtId>& body) {
    cx.part = part;
    declare_address(part);
    return expanded_body(body);
}

}  // namespace gliftc::lower
