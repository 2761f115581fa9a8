// Expander: filtered reads. They use the device's sampler if the memory is an image in which elements have their own
// addresses, else a weighted sum of reads.
#include "ir/chain.h"
#include "lower/expand.h"

namespace gliftc::lower {

using namespace ir;

/// Whether the structure keeps element a in texel a of an image that devices can filter: not of depths, for which they
/// need not support it.
bool Expander::is_texel_address(const Place& place) {
    const Structure& structure = cx.structure_at(place);
    if (is_computed(p, structure)) return false;
    const Memory& memory = root_memory(p, structure);
    if (memory.shape == MemoryShape::buffer || memory.format == Format::d32) return false;
    ExprId probe = make.local(cx.new_local("probe", structure.domain_type, span_));
    Pair at;
    Block block = collect([&] { at = translated(place, probe, "probe"); });
    return block.empty() && at.value == probe && (!at.has || make.is_true(at.has));
}

ExprId Expander::sample(const Expr& node) {
    Place place = resolved(node.place);
    ExprId at = named(cx.name_of(place) + "_point", value_of(node.operands[0]));
    if (!is_texel_address(place)) return filtered(place, at);
    const Structure& structure = cx.structure_at(place);
    Expr extent;
    extent.op = Op::memory_extent;
    extent.type = structure.domain_type;
    extent.place = canonical(root_of(p, structure, place));
    extent.slot = root_structure(p, structure).via_memory;
    ExprId size = make.convert(make.type(at), p.exprs.add(std::move(extent)));
    Expr sampled;
    sampled.op = Op::image_sample;
    sampled.type = node.type;
    sampled.slot = binding(place, Access::read);
    if (is_range(place))
        at = make.add(at, make.convert(make.type(at), from_origin(place, make.zero(structure.domain_type))));
    ExprId point = make.binary(BinaryOp::divide, at, size);
    if (root_memory(p, structure).shape == MemoryShape::image2darray) {
        // Samplers round the layer to the nearest number.
        Expr half;
        half.type = p.types.float_;
        half.number = 0.5;
        const ExprId layer = make.binary(BinaryOp::subtract, make.component(at, 2), p.exprs.add(std::move(half)));
        Operands parts;
        parts.push_back(make.component(point, 0));
        parts.push_back(make.component(point, 1));
        parts.push_back(layer);
        point = make.construct(make.type(at), std::move(parts));
    }
    sampled.operands = {point};
    if (node.operands.size() > 1) sampled.operands.push_back(make.convert(p.types.float_, value_of(node.operands[1])));
    return p.exprs.add(std::move(sampled));
}

/// Linear filtering: interpolates between the 2^n elements around the point, along x first. Element centres lie at 0.5.
ExprId Expander::filtered(const Place& place, ExprId at) {
    const Structure& structure = cx.structure_at(place);
    std::string name = cx.name_of(place);
    TypeId floats = make.type(at), numbers = structure.domain_type;
    std::uint32_t axes = p.types.components(floats);
    auto splat = [&](ExprId number) { return axes == 1 ? number : make.construct(floats, {number}); };
    Expr half;
    half.type = p.types.float_;
    half.number = 0.5;
    ExprId lower = named(name + "_lower", make.binary(BinaryOp::subtract, at, splat(p.exprs.add(half))));
    ExprId corner = named(name + "_corner", make.intrinsic(Intrinsic::floor, floats, {lower}));
    ExprId weight = named(name + "_weight", make.binary(BinaryOp::subtract, lower, corner));
    // Negative corners wrap to large addresses, outside the domain, where reads give the structure's `otherwise`.
    TypeId ints = p.types.with_scalar(numbers, p.types.int_);
    ExprId base = named(name + "_base", make.convert(numbers, make.convert(ints, corner)));
    Operands values;
    for (std::uint32_t i = 0; i < (1u << axes); ++i) {
        Operands step;
        for (std::uint32_t axis = 0; axis < axes; ++axis) step.push_back(make.uint(i >> axis & 1));
        ExprId offset = axes == 1 ? step[0] : make.construct(numbers, std::move(step));
        std::string corner_name = name + "_corner" + std::to_string(i);
        values.push_back(named(corner_name, read(place, make.add(base, offset), corner_name)));
    }
    for (std::uint32_t axis = 0; axis < axes; ++axis) {
        Operands mixed;
        ExprId t = make.component(weight, axis);
        for (std::size_t i = 0; i < values.size(); i += 2)
            mixed.push_back(make.intrinsic(Intrinsic::mix, make.type(values[i]), {values[i], values[i + 1], t}));
        values = std::move(mixed);
    }
    return values[0];
}

}  // namespace gliftc::lower
