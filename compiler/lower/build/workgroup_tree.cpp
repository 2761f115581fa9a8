#include "lower/build/workgroup_tree.h"

#include <bit>

namespace gliftc::lower {

using namespace ir;

WorkgroupTree::WorkgroupTree(Context& context, const Combination& combination, std::string_view name, Span span,
                             std::uint32_t rows)
    : cx(context), build(context.build), combination_(combination), make(context, span), rows_(rows),
      keys_(make.workgroup_array(name, combination.type(), rows * invocations)) {}

std::vector<StmtId> WorkgroupTree::combine(ExprId levels) {
    return {make.loop("level", levels, [this](ExprId number) { return level(number); })};
}

/// One level, in which 16 invocations or one combine keys of a row.
std::vector<StmtId> WorkgroupTree::level(ExprId number) {
    std::vector<StmtId> body{make.barrier()};
    const ExprId shift = build.multiply(number, build.uint(std::countr_zero(branches)));
    const ExprId width = build.binary(BinaryOp::shift_right, build.uint(branches), shift);
    const ExprId combines = build.binary(BinaryOp::less, lane(), build.multiply(width, build.uint(rows_)));
    ExprId row = build.uint(0), place = lane();
    if (rows_ != 1) {
        const ExprId bits = build.binary(BinaryOp::subtract, build.uint(std::countr_zero(branches)), shift);
        row = make.let("row", build.binary(BinaryOp::shift_right, lane(), bits), body);
        place = build.binary(BinaryOp::subtract, lane(), build.multiply(row, width));
        // Where nothing is combined: no key beyond the last.
        row = make.let("row", build.select(combines, row, build.uint(0)), body);
    }
    // No if around the loop: lavapipe would run all its rounds in every invocation.
    const ExprId count = build.select(combines, build.uint(branches - 1), build.uint(0));
    const LocalId others = make.variable("others", count, body);
    build.limits[others] = branches - 1;
    const ExprId sum = build.local(make.variable("sum", key(row, place), body));
    body.push_back(make.loop("turn", build.local(others), [&](ExprId turn) -> std::vector<StmtId> {
        const ExprId other = build.add(place, build.multiply(build.add(turn, build.uint(1)), width));
        return {make.assign(sum, combination_.of(sum, key(row, other)))};
    }));
    body.push_back(make.where(combines, {make.assign(key(row, place), sum)}));
    return body;
}

}  // namespace gliftc::lower
