#include "lower/expand/dispatch.h"

#include "lower/expand/blocks.h"

#include <algorithm>
#include <bit>

namespace gliftc::lower {

using namespace ir;

namespace {

/// The workgroup size in kernels over blocks of `volume` elements, 256 invocations at most: a workgroup has one block
/// or a part of it, but several blocks if these have 16 elements or fewer. `volume` is absent if it is not a constant.
std::array<std::uint32_t, 3> group_of_blocks(std::optional<std::uint64_t> volume) {
    constexpr std::uint32_t most = 256, small = 32, unknown = 64;
    if (!volume) return {unknown, 1, 1};
    if (*volume <= small / 2) {
        const std::uint32_t width = std::bit_ceil(std::max(static_cast<std::uint32_t>(*volume), 1u));
        return {width, most / width, 1};
    }
    const std::uint64_t wide = *volume / elements_in_block(*volume);
    if (wide >= most) return {most, 1, 1};
    return {(static_cast<std::uint32_t>(wide) + small - 1) / small * small, 1, 1};
}

}  // namespace

void choose_dispatch(Context& cx) {
    const Kernel& kernel = cx.kernel;
    cx.pass.rank = cx.p.types.components(iteration_type(cx));
    cx.pass.items = kernel.items;
    cx.pass.plain().assumes.elements = {kernel.items, 1, 1};
    if (kernel.grouped()) {
        cx.pass.group = kernel.group;
        for (std::uint32_t& width : cx.pass.group) width = std::max(width, 1u);
    } else if (kernel.space) {
        cx.pass.group = group_of_blocks(block_volume(cx));
    } else {
        // 256 invocations per workgroup; longest in x, so that neighbours in x are mostly in one subgroup.
        switch (cx.pass.rank) {
        case 1: cx.pass.group = {256, 1, 1}; break;
        case 2: cx.pass.group = {32, 8, 1}; break;
        default: cx.pass.group = {32, 4, 2}; break;
        }
    }
    if (kernel.raster) {  // invocations are vertices and instances, which the device groups itself
        cx.pass.group = {1, 1, 1};
        return;
    }
    cx.pass.splits = !kernel.grouped() && !kernel.space;
    cx.pass.of_blocks = kernel.space.has_value();
    cx.pass.address = cx.new_local("address", iteration_type(cx), kernel.span);
    cx.pass.in_range = cx.new_local("in_range", cx.p.types.bool_, kernel.span);
    cx.pass.shared = kernel.shared;
}

ExprId in_range_condition(Context& cx) { return in_range_condition(cx, cx.build.local(cx.pass.address)); }

ExprId in_range_condition(Context& cx, ExprId at) {
    if (cx.pass.rank == 1) return cx.build.binary(BinaryOp::less, at, cx.size);
    TypeId truths = cx.p.types.with_scalar(iteration_type(cx), cx.p.types.bool_);
    return cx.build.intrinsic(Intrinsic::all, cx.p.types.bool_,
                              {cx.build.intrinsic(Intrinsic::lessThan, truths, {at, cx.size})});
}

ExprId first_of_row(Context& cx, ExprId row) {
    Builder& build = cx.build;
    const ExprId address = build.local(cx.pass.address);
    const TypeId uint3 = cx.p.types.vector(cx.p.types.uint, 3);
    const ExprId place = build.component(build.builtin(Builtin::local_id, uint3), 0);
    Operands parts{build.binary(BinaryOp::subtract, build.component(address, 0), place),
                   build.add(build.component(address, 1), row)};
    if (cx.pass.rank == 3) parts.push_back(build.component(address, 2));
    return build.construct(build.type(address), std::move(parts));
}

namespace {

/// The address in a one-dimensional range. Where there are more workgroups than a device allows along x, they continue
/// in rows along y. Several elements of an invocation are consecutive if the kernel declares them (at<S, n>), else a
/// workgroup's width apart.
ExprId line_address(Context& cx, std::uint32_t elements) {
    Builder& build = cx.build;
    const TypeId uint3 = cx.p.types.vector(cx.p.types.uint, 3);
    auto part = [&](Builtin of, std::uint32_t axis) { return build.component(build.builtin(of, uint3), axis); };
    const ExprId groups = part(Builtin::group_count, 0), width = build.uint(cx.pass.group[0]);
    if (elements == cx.pass.items) {
        const ExprId row = build.multiply(groups, width);
        const ExprId invocation =
            build.add(build.multiply(part(Builtin::global_id, 1), row), part(Builtin::global_id, 0));
        return build.multiply(invocation, build.uint(cx.pass.items));
    }
    const ExprId group = build.add(build.multiply(part(Builtin::group_id, 1), groups), part(Builtin::group_id, 0));
    return build.add(build.multiply(group, build.multiply(width, build.uint(elements))), part(Builtin::local_id, 0));
}

/// {position in the block, number of the block}. Workgroups along y count blocks; where there are more than a device
/// allows, they continue in layers along z. Several elements of an invocation are a workgroup's width apart, its blocks
/// consecutive.
ExprId block_address(Context& cx, const std::array<std::uint32_t, 3>& elements) {
    Builder& build = cx.build;
    const TypeId uint3 = cx.p.types.vector(cx.p.types.uint, 3);
    const auto part = [&](Builtin of, std::uint32_t axis) { return build.component(build.builtin(of, uint3), axis); };
    const ExprId layer = build.multiply(part(Builtin::group_id, 2), part(Builtin::group_count, 1));
    const ExprId number = build.add(build.multiply(layer, build.uint(cx.pass.group[1])), part(Builtin::global_id, 1));
    const ExprId block = build.multiply(number, build.uint(elements[1]));
    const ExprId first = build.multiply(part(Builtin::group_id, 0), build.uint(cx.pass.group[0] * elements[0]));
    const ExprId position =
        elements[0] == 1 ? part(Builtin::global_id, 0) : build.add(first, part(Builtin::local_id, 0));
    return build.construct(iteration_type(cx), {position, block});
}

/// The address of the first of the elements that an invocation takes, in two or three dimensions. Several elements are
/// a workgroup's width apart along x, consecutive along the other axes.
ExprId invocation_address(Context& cx, TypeId type, const std::array<std::uint32_t, 3>& elements) {
    Builder& build = cx.build;
    const std::uint32_t axes = cx.p.types.components(type);
    const TypeId uint3 = cx.p.types.vector(cx.p.types.uint, 3);
    ExprId id = build.builtin(Builtin::global_id, uint3);
    if (cx.pass.has_base())
        id = build.add(id, cx.parameter_expr(cx.parameter(ParameterSource::base, "base", uint3, 0)));
    if (axes == 2) {
        Expr both;
        both.op = Op::swizzle;
        both.type = type;
        both.lanes = {0, 1};
        both.operands = {id};
        id = cx.p.exprs.add(std::move(both));
    }
    if (elements == std::array{1u, 1u, 1u}) return id;
    Operands counts;
    for (std::uint32_t axis = 0; axis < axes; ++axis) counts.push_back(build.uint(elements[axis]));
    if (elements[0] == 1) return build.multiply(id, build.construct(type, std::move(counts)));
    const ExprId width = build.uint(cx.pass.group[0]), at = build.component(id, 0);
    const ExprId group = build.binary(BinaryOp::divide, at, width);
    Operands parts{build.add(build.multiply(group, build.uint(cx.pass.group[0] * elements[0])),
                             build.binary(BinaryOp::remainder, at, width))};
    for (std::uint32_t axis = 1; axis < axes; ++axis)
        parts.push_back(build.multiply(build.component(id, axis), counts[axis]));
    return build.construct(type, std::move(parts));
}

}  // namespace

std::vector<StmtId> dispatch_prologue(Context& cx) {
    Builder& build = cx.build;
    const TypeId uint3 = cx.p.types.vector(cx.p.types.uint, 3), type = iteration_type(cx);
    const std::array<std::uint32_t, 3>& elements = variant_for(cx.pass, Devices::shaders).assumes.elements;
    std::vector<StmtId> result;
    auto let = [&](LocalId local, ExprId value) {
        Stmt stmt = statement(StmtOp::let, cx.kernel.span);
        stmt.local = local;
        stmt.value = value;
        result.push_back(cx.add(std::move(stmt)));
    };
    ExprId address;
    if (cx.pass.of_blocks) {
        address = block_address(cx, elements);
    } else if (cx.pass.rank == 1) {
        address = line_address(cx, elements[0]);
    } else if (cx.pass.rank < 4) {
        address = invocation_address(cx, type, elements);
    } else {
        const LocalId id = cx.new_local("id", uint3, cx.kernel.span);
        let(id, invocation_address(cx, uint3, elements));
        const auto part = [&](std::uint32_t axis) { return build.component(build.local(id), axis); };
        ExprId depth = build.component(cx.size, 2);
        address = build.construct(type, {part(0), part(1), build.binary(BinaryOp::remainder, part(2), depth),
                                         build.binary(BinaryOp::divide, part(2), depth)});
    }
    let(cx.pass.address, address);
    let(cx.pass.in_range, in_range_condition(cx));
    return result;
}

}  // namespace gliftc::lower
