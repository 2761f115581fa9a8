// Finds loads in a kernel's loop that the invocations of a workgroup repeat, as in all pairs and products of matrices.
#pragma once

#include "lower/analysis/number.h"
#include "lower/analysis/slopes.h"
#include "lower/context.h"

#include <vector>

namespace gliftc::lower {

/// Loads of one element in one round of the loop.
struct StagedLoad {
    std::vector<ExprId> nodes;  ///< loads or guarded loads of the same value
    std::uint32_t binding = 0;
    std::uint8_t axes = 0;  ///< bit i: the element depends on component i of the invocation's address
    bool is_row = false;    ///< consecutive x have consecutive elements
};

/// The kernel's loop, and what is before and after it.
struct StagedLoop {
    std::vector<StmtId> before, after;
    StmtId loop;
    std::vector<StagedLoad> loads;
};

class StagedLoads {
public:
    explicit StagedLoads(Context& context);

    /// Without loads, unless the body is statements without stores, one loop over a uniform range of uints without
    /// stores and without loops inside, and statements without loops. Found are loads that each round makes, from
    /// memory that the pass does not write, of a number or vector of 32-bit numbers, whose address is a function of the
    /// loop's variable, of uniform values, and of some but not all axes of the invocation's address.
    StagedLoop of(const std::vector<StmtId>& body);

private:
    bool is_same_for_all(ExprId value);
    bool find_loop(const std::vector<StmtId>& body);
    bool is_plain(const std::vector<StmtId>& body, bool may_store) const;
    bool is_plain(const ir::Stmt& stmt, bool may_store) const;
    bool calls_a_function(const ir::Stmt& stmt) const;
    void visit(ExprId id);
    void note(ExprId id);
    bool is_function_of_address(ExprId id, const ir::Stmt& loop);
    bool may_be_staged(const ir::Expr& node) const;

    Context& cx;
    Numbers numbers_;
    std::vector<RowSlopes> slopes_;  ///< one an axis
    StagedLoop found_;
    std::vector<ValueNumber> values_;  ///< of each of found_.loads
    bool is_varying_ = false;          ///< the address that is being visited mentions the loop's variable
};

}  // namespace gliftc::lower
