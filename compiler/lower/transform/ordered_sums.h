// Sums of floats in one order, whatever the device. The elements of a sum (ir::SumOrder) are those that differ along
// some axes, along one of which they are cut into parts; along the others each element is a part. A workgroup or an
// invocation adds the elements of a part. If a sum has one part, it updates memory. Else parts meet in memory that the
// runtime gives (glift::SumOrder): a workgroup stores the sums of its parts and counts itself, and the one that comes
// last adds all of them in their order. So no workgroup waits for another.
//
//     part of a row      4,096 elements: lane i of 256 adds the elements i, i + 256, …; then each lane i below 16 adds
//                        the sums of the lanes i + 16, i + 32, …; then lane 0 those of the lanes 1 to 15
//     part of a column   64 elements, one after the other
//     parts              of rows, as the elements of a part of a row; of columns, one after the other
//
// The host device has loops of its own in this order (glift/host/sums.h).
//
// Source of the last workgroup: CUDA samples, threadFenceReduction.
#pragma once

#include "lower/build/workgroup_tree.h"
#include "lower/transform/several_elements.h"

namespace gliftc::lower {

/// The order in which an update adds whose address is the same along the axes in `same_along`, in a body of
/// `made.elements` along `axis` in workgroups of `made.group`. `sums`: how many ordered sums the kernel has.
ir::SumOrder order_of_sum(std::uint8_t same_along, std::uint32_t axis, const SeveralElements& made, std::size_t sums);

/// Makes the statements by which the parts of sums meet. The sums of a kernel take the memory one after the other.
class OrderedSums {
public:
    OrderedSums(Context& context, const SeveralElements& made);

    /// For sums of columns. Statements after which `sum` is the whole sum in one invocation for each sum, and -0 in all
    /// others; `sum` can be assigned. Before them it is that of the invocation's part.
    std::vector<StmtId> meet(const ir::SumOrder& order, ExprId sum, Span span);
    /// For sums of rows, of several updates of one order. Statements after which those first keys of the `tree` are
    /// whole sums that belong to them, one for each sum, and the others are -0. Before them they are the sums of parts:
    /// key i * n + j is that of update i in the workgroup's row j of n, which invocation j alone uses (invocation 0, if
    /// n is 1). `row`: the address of the first element of the invocation's row.
    std::vector<StmtId> meet(const ir::SumOrder& order, std::uint32_t sums, Span span, WorkgroupTree& tree, ExprId row);

private:
    struct Numbers;
    ExprId size(std::uint32_t axis) { return component(cx.size, axis); }
    ExprId component(ExprId vector, std::uint32_t axis);
    ExprId quotient(ExprId value, std::uint32_t divisor) {
        return build.binary(ir::BinaryOp::divide, value, build.uint(divisor));
    }
    ExprId named(ExprId value, std::string_view name, std::uint32_t axis);
    ExprId quotient_up(ExprId value, std::uint32_t divisor);
    std::uint32_t elements_of_group(std::uint32_t axis) const { return made_.elements[axis] * made_.group[axis]; }
    Numbers numbers(const ir::SumOrder& order, ExprId start, ExprId address, Statements make,
                    std::vector<StmtId>& body);
    ExprId word(ExprId at);
    ExprId nothing();  ///< -0
    ExprId lane();
    ExprId is_first_lane();
    StmtId stored(const Numbers& of, ExprId sum, Statements make);
    ExprId counted(const Numbers& of, Statements make, std::vector<StmtId>& body);
    std::vector<StmtId> stored_columns(const Numbers& of, ExprId sum, ExprId is_last, Statements make);
    std::vector<StmtId> stored_rows(const std::vector<Numbers>& of, WorkgroupTree& tree, ExprId row, ExprId is_last,
                                    Statements make);
    void add_parts(const ir::SumOrder& order, const std::vector<Numbers>& of, const std::vector<ExprId>& shares,
                   Statements make, std::vector<StmtId>& body);
    ExprId adds_column(const ir::SumOrder& order);
    void add_rows(const ir::SumOrder& order, const std::vector<Numbers>& of, WorkgroupTree& tree, ExprId is_last,
                  Statements make, std::vector<StmtId>& body);
    ExprId last_flag(Statements make);
    void acquire(const Numbers& of, Statements make, std::vector<StmtId>& body);
    ExprId has_several_parts(const ir::SumOrder& order, const Numbers& of);

    Context& cx;
    Builder& build;
    const SeveralElements& made_;
    std::uint32_t slot_;
    ExprId used_;  ///< words of the memory that the sums before have
};

}  // namespace gliftc::lower
