#include "lower/dispatch.h"

namespace gliftc::lower {

using namespace ir;

void choose_dispatch(Context& cx) {
    const Kernel& kernel = cx.kernel;
    cx.pass.rank = cx.p.types.components(kernel.domain_type);
    cx.pass.items = kernel.items;
    if (kernel.grouped()) {
        cx.pass.group = kernel.group;
        for (std::uint32_t& width : cx.pass.group) width = std::max(width, 1u);
    } else {
        // 256 invocations a group, x longest so that neighbours in x lie in one subgroup.
        switch (cx.pass.rank) {
        case 1: cx.pass.group = {256, 1, 1}; break;
        case 2: cx.pass.group = {32, 8, 1}; break;
        default: cx.pass.group = {32, 4, 2}; break;
        }
    }
    cx.pass.address = cx.new_local("address", kernel.domain_type, kernel.span);
    cx.pass.in_range = cx.new_local("in_range", cx.p.types.bool_, kernel.span);
    cx.pass.shared = kernel.shared;
}

ExprId in_range_condition(Context& cx) {
    ExprId at = cx.make.local(cx.pass.address);
    if (cx.pass.rank == 1) return cx.make.binary(BinaryOp::less, at, cx.size);
    TypeId truths = cx.p.types.with_scalar(cx.kernel.domain_type, cx.p.types.bool_);
    return cx.make.intrinsic(Intrinsic::all, cx.p.types.bool_,
                             {cx.make.intrinsic(Intrinsic::lessThan, truths, {at, cx.size})});
}

std::vector<StmtId> dispatch_prologue(Context& cx) {
    Make& make = cx.make;
    TypeId uint3 = cx.p.types.vector(cx.p.types.uint, 3);
    ExprId id = make.builtin(Builtin::global_id, uint3);
    auto lane = [&](ExprId vector, std::uint32_t i) { return make.component(vector, i); };
    std::vector<StmtId> result;
    auto let = [&](LocalId local, ExprId value) {
        Stmt stmt = statement(StmtOp::let, cx.kernel.span);
        stmt.local = local;
        stmt.value = value;
        result.push_back(cx.add(std::move(stmt)));
    };
    ExprId address;
    TypeId type = cx.kernel.domain_type;
    if (cx.pass.rank == 1) {
        // More groups than a device allows along x are folded into rows of groups.
        ExprId row = make.multiply(lane(make.builtin(Builtin::group_count, uint3), 0), make.uint(cx.pass.group[0]));
        address = make.multiply(make.add(make.multiply(lane(id, 1), row), lane(id, 0)), make.uint(cx.pass.items));
    } else if (cx.pass.rank == 2) {
        Expr both;
        both.op = Op::swizzle;
        both.type = type;
        both.lanes = {0, 1};
        both.operands = {id};
        address = cx.p.exprs.add(std::move(both));
    } else if (cx.pass.rank == 3) {
        address = id;
    } else {
        ExprId depth = lane(cx.size, 2);
        address = make.construct(type, {lane(id, 0), lane(id, 1), make.binary(BinaryOp::remainder, lane(id, 2), depth),
                                        make.binary(BinaryOp::divide, lane(id, 2), depth)});
    }
    let(cx.pass.address, address);
    let(cx.pass.in_range, in_range_condition(cx));
    return result;
}

}  // namespace gliftc::lower
