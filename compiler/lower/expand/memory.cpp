#include "lower/expand/memory.h"

namespace gliftc::lower {

using namespace ir;

ExprId index_of(Context& cx, std::uint32_t binding, ExprId physical) {
    const Types& types = cx.p.types;
    if (cx.pass.bindings[binding].shape != MemoryShape::buffer)
        return cx.build.convert(cx.p.types.with_scalar(cx.build.type(physical), types.int_), physical);
    return cx.is_wide() ? cx.build.convert(types.uint64, physical) : physical;
}

ExprId load_from(Context& cx, std::uint32_t binding, ExprId physical) {
    Expr node;
    node.op = cx.pass.bindings[binding].shape == MemoryShape::buffer ? Op::load : Op::image_load;
    node.type = cx.pass.bindings[binding].element;
    node.slot = binding;
    node.operands = {index_of(cx, binding, physical)};
    return cx.p.exprs.add(std::move(node));
}

}  // namespace gliftc::lower
