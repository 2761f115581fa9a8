// Expander: `sample`, `gather` and `compare`, which access the elements around a point. If element a of the structure
// is texel a of an image, and the parameter is not coherent, the device's sampler filters, gathers or compares the
// texels, as far as it can for the image's shape and format. If it can gather the texels but not compare them,
// `compare` gathers them and compares by arithmetic. Otherwise the elements are read one by one, and `sample` and
// `compare` interpolate by arithmetic.
#include "ir/chain.h"
#include "lower/expand/expand.h"
#include "lower/expand/memory.h"

namespace gliftc::lower {

using namespace ir;

/// Whether the structure keeps element a in texel a of an image.
bool Expander::is_texel_address(const Place& place) {
    const Structure& structure = cx.structure_at(place);
    if (is_computed(p, structure) || root_memory(p, structure).shape == MemoryShape::buffer) return false;
    ExprId probe = build.local(cx.new_local("probe", structure.domain_type, span_));
    Pair at;
    Block block = collect([&] { at = translated(place, probe, "probe"); });
    return block.empty() && at.value == probe && (!at.has || build.is_true(at.has));
}

namespace {

bool is_flat(MemoryShape shape) { return shape == MemoryShape::image2d || shape == MemoryShape::image2darray; }

BinaryOp operator_of(Compare compare) {
    switch (compare) {
    case Compare::less: return BinaryOp::less;
    case Compare::less_equal: return BinaryOp::less_equal;
    case Compare::greater: return BinaryOp::greater;
    case Compare::greater_equal: return BinaryOp::greater_equal;
    }
    return BinaryOp::less_equal;
}

}  // namespace

/// A float, or a vector of floats, whose components are all `number`.
ExprId Expander::of_floats(TypeId type, double number) {
    Expr constant;
    constant.type = p.types.float_;
    constant.number = number;
    const ExprId made = p.exprs.add(constant);
    return p.types.is_vector(type) ? build.construct(type, {made}) : made;
}

/// The extent of the image that elements lie in.
ExprId Expander::image_extent(const Place& place) {
    const Structure& structure = cx.structure_at(place);
    Expr extent;
    extent.op = Op::memory_extent;
    extent.type = structure.domain_type;
    extent.place = canonical(root_of(p, structure, place));
    extent.slot = root_structure(p, structure).via_memory;
    return p.exprs.add(std::move(extent));
}

/// A point that is given relative to the range, in the coordinates of the whole image.
ExprId Expander::in_image(const Place& place, ExprId at) {
    if (!is_range(place)) return at;
    const ExprId origin = from_origin(place, build.zero(cx.structure_at(place).domain_type));
    return build.add(at, build.convert(build.type(at), origin));
}

/// The coordinates that a device's sampler is given for a point in the image: the point divided by the extent, and for
/// an array of images the number of the layer in which the point lies.
ExprId Expander::sampler_point(const Place& place, ExprId at) {
    const ExprId point = build.binary(BinaryOp::divide, at, build.convert(build.type(at), image_extent(place)));
    if (root_memory(p, cx.structure_at(place)).shape != MemoryShape::image2darray) return point;
    const ExprId layer = build.intrinsic(Intrinsic::floor, p.types.float_, {build.component(at, 2)});
    return build.construct(build.type(at), {build.component(point, 0), build.component(point, 1), layer});
}

ExprId Expander::of_image(Op op, TypeId type, std::uint32_t slot, Operands operands) {
    Expr made;
    made.op = op;
    made.type = type;
    made.slot = slot;
    made.operands = std::move(operands);
    return p.exprs.add(std::move(made));
}

ExprId Expander::sample(const Expr& node) {
    Place place = resolved(node.place);
    ExprId at = named(cx.name_of(place) + "_point", value_of(node.operands[0]));
    // Devices need not filter depths.
    const bool is_filtered =
        is_texel_address(place) && !is_coherent(place) && root_memory(p, cx.structure_at(place)).format != Format::d32;
    if (!is_filtered) return mixed(around(place, at));
    const bool is_cube = root_memory(p, cx.structure_at(place)).shape == MemoryShape::imagecube;
    Operands operands = {is_cube ? at : sampler_point(place, in_image(place, at))};
    if (node.operands.size() > 1) operands.push_back(build.convert(p.types.float_, value_of(node.operands[1])));
    return of_image(Op::image_sample, node.type, binding(place, Access::read, {}, is_cube), std::move(operands));
}

/// Whether the device gathers the texels around a point: if texel a of a 2-D image, or of an array of 2-D images, holds
/// element a, and the structure is not a coherent parameter.
bool Expander::is_gathered(const Place& place) {
    return !is_coherent(place) && is_texel_address(place) && is_flat(root_memory(p, cx.structure_at(place)).shape);
}

/// The four texels around a point, gathered by the device. The gather is given the corner that the four texels share,
/// so that a device that rounds coordinates still takes these four.
Expander::Around Expander::gathered(const Place& place, ExprId at) {
    const std::string name = cx.name_of(place);
    const TypeId element = cx.structure_at(place).element, four = p.types.vector(element, 4);
    const ExprId point = in_image(place, at);
    const ExprId lower =
        named(name + "_lower", build.binary(BinaryOp::subtract, point, of_floats(build.type(at), 0.5)));
    const ExprId corner = named(name + "_corner", build.intrinsic(Intrinsic::floor, build.type(at), {lower}));
    ExprId middle = build.add(corner, of_floats(build.type(at), 1.0));
    if (p.types.components(build.type(at)) == 3)
        middle = build.construct(build.type(at),
                                 {build.component(middle, 0), build.component(middle, 1), build.component(point, 2)});
    const ExprId texels = named(name + "_texels", of_image(Op::image_gather, four, binding(place, Access::read),
                                                           {sampler_point(place, middle)}));
    Around found{
        .axes = 2, .weight = named(name + "_weight", build.binary(BinaryOp::subtract, lower, corner)), .all = texels};
    for (std::uint32_t i = 0; i < 4; ++i) found.values.push_back(build.component(texels, i));
    return found;
}

ExprId Expander::gather(const Expr& node) {
    Place place = resolved(node.place);
    ExprId at = named(cx.name_of(place) + "_point", value_of(node.operands[0]));
    if (is_gathered(place)) return gathered(place, at).all;
    return build.construct(node.type, around(place, at).values);
}

/// The weighted mean of the results (0 or 1) of comparing the reference with each element around a point; the weights
/// are those that `sample` gives the elements.
ExprId Expander::compare(const Expr& node) {
    Place place = resolved(node.place);
    const Memory computed;  // stands for the memory of a view
    const Structure& structure = cx.structure_at(place);
    const Memory& memory = is_computed(p, structure) ? computed : root_memory(p, structure);
    const Compare how = memory.compare;
    const bool is_depth = memory.format == Format::d32;
    const std::string name = cx.name_of(place);
    ExprId at = named(name + "_point", value_of(node.operands[0]));
    ExprId reference = named(name + "_reference", value_of(node.operands[1]));
    const bool is_image = is_gathered(place);
    if (is_depth && memory.shape == MemoryShape::imagecube && is_texel_address(place))
        return of_image(Op::image_compare, p.types.float_, binding(place, Access::read, how, true), {at, reference});
    if (is_image && is_depth)
        return of_image(Op::image_compare, p.types.float_, binding(place, Access::read, how),
                        {sampler_point(place, in_image(place, at)), reference});
    Around found = is_image ? gathered(place, at) : around(place, at);
    const ExprId no = of_floats(p.types.float_, 0.0), yes = of_floats(p.types.float_, 1.0);
    for (ExprId& value : found.values) value = build.select(build.binary(operator_of(how), reference, value), yes, no);
    return mixed(std::move(found));
}

/// The address of the texel of an image that is nearest to `texel`, which may lie beyond the edge.
ExprId Expander::texel_near(const Place& place, ExprId texel) {
    const TypeId type = build.type(texel);
    const ExprId size = build.convert(type, image_extent(place));
    const ExprId one =
        build.convert(type, p.types.is_vector(type) ? build.construct(type, {build.uint(1)}) : build.uint(1));
    const ExprId last = build.binary(BinaryOp::subtract, size, one);
    return build.intrinsic(Intrinsic::clamp, type, {texel, build.zero(type), last});
}

/// The elements around a point, each read separately. The centre of element a lies at a + 0.5. Beyond the edge of an
/// image the nearest texel is taken; of other structures, what a read of that address gives.
Expander::Around Expander::around(const Place& place, ExprId at) {
    const Structure& structure = cx.structure_at(place);
    const bool is_image = is_texel_address(place);
    const bool has_layers = is_image && root_memory(p, structure).shape == MemoryShape::image2darray;
    std::string name = cx.name_of(place);
    if (is_image) at = in_image(place, at);
    TypeId floats = build.type(at), numbers = structure.domain_type;
    const std::uint32_t all = p.types.components(floats);
    Around found{.axes = has_layers ? 2 : all, .weight = {}, .all = {}};
    ExprId lower = named(name + "_lower", build.binary(BinaryOp::subtract, at, of_floats(floats, 0.5)));
    ExprId corner = named(name + "_corner", build.intrinsic(Intrinsic::floor, floats, {lower}));
    found.weight = named(name + "_weight", build.binary(BinaryOp::subtract, lower, corner));
    if (has_layers)
        corner = build.construct(floats, {build.component(corner, 0), build.component(corner, 1),
                                          build.intrinsic(Intrinsic::floor, p.types.float_, {build.component(at, 2)})});
    // For reads of a structure, negative coordinates wrap to unsigned addresses outside its domain, where it decides
    // what a read gives. For texels they stay signed, and texel_near clamps them.
    TypeId ints = p.types.with_scalar(numbers, p.types.int_);
    ExprId base = build.convert(ints, corner);
    base = named(name + "_base", is_image ? base : build.convert(numbers, base));
    for (std::uint32_t i = 0; i < (1u << found.axes); ++i) {
        Operands step;
        for (std::uint32_t axis = 0; axis < all; ++axis) step.push_back(build.uint(i >> axis & 1));
        ExprId offset = all == 1 ? step[0] : build.construct(numbers, std::move(step));
        std::string corner_name = name + "_corner" + std::to_string(i);
        const ExprId value = is_image ? load_from(cx, binding(place, Access::read),
                                                  texel_near(place, build.add(base, build.convert(ints, offset))))
                                      : read(place, build.add(base, offset), corner_name);
        found.values.push_back(named(corner_name, value));
    }
    return found;
}

/// Between two values, field by field.
ExprId Expander::mixed(ExprId one, ExprId other, ExprId weight) {
    const TypeId type = build.type(one);
    if (p.types.kind(type) != TypeKind::struct_) return build.intrinsic(Intrinsic::mix, type, {one, other, weight});
    Operands fields;
    const std::size_t count = p.structs[p.types[type].struct_].fields.size();
    for (std::uint32_t i = 0; i < count; ++i)
        fields.push_back(mixed(build.field(one, i), build.field(other, i), weight));
    return build.construct(type, std::move(fields));
}

ExprId Expander::mixed(Around found) {
    for (std::uint32_t axis = 0; axis < found.axes; ++axis) {
        Operands mixed;
        ExprId t = build.component(found.weight, axis);
        for (std::size_t i = 0; i < found.values.size(); i += 2)
            mixed.push_back(this->mixed(found.values[i], found.values[i + 1], t));
        found.values = std::move(mixed);
    }
    return found.values[0];
}

}  // namespace gliftc::lower
