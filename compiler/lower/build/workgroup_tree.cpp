#include "lower/build/workgroup_tree.h"

#include <bit>

namespace gliftc::lower {

using namespace ir;

WorkgroupTree::WorkgroupTree(Context& context, const Combination& combination, std::string_view name, Span span)
    : cx(context), build(context.build), combination_(combination), make(context, span),
      keys_(make.workgroup_array(name, combination.type(), invocations)) {}

std::vector<StmtId> WorkgroupTree::combine(ExprId key, ExprId levels) {
    return {make.assign(of(lane()), key), make.loop("level", levels, [this](ExprId number) { return level(number); })};
}

/// One level, in which 16 invocations or one combine keys.
std::vector<StmtId> WorkgroupTree::level(ExprId number) {
    std::vector<StmtId> body{make.barrier()};
    const ExprId shift = build.multiply(number, build.uint(std::countr_zero(branches)));
    const ExprId width = build.binary(BinaryOp::shift_right, build.uint(branches), shift);
    const ExprId combines = build.binary(BinaryOp::less, lane(), width);
    // No if around the loop: lavapipe would run all its rounds in every invocation.
    const ExprId count = build.select(combines, build.uint(branches - 1), build.uint(0));
    const LocalId others = make.variable("others", count, body);
    build.limits[others] = branches - 1;
    const ExprId sum = build.local(make.variable("sum", of(lane()), body));
    body.push_back(make.loop("turn", build.local(others), [&](ExprId turn) -> std::vector<StmtId> {
        const ExprId other = build.add(lane(), build.multiply(build.add(turn, build.uint(1)), width));
        return {make.assign(sum, combination_.of(sum, of(other)))};
    }));
    body.push_back(make.where(combines, {make.assign(of(lane()), sum)}));
    return body;
}

}  // namespace gliftc::lower
