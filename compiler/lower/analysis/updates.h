// The updates of a kernel (`scatter` with an operation) and how their addresses depend on the element's.
#pragma once

#include "lower/analysis/block_values.h"
#include "lower/analysis/number.h"
#include "lower/analysis/slopes.h"
#include "lower/context.h"

#include <optional>
#include <vector>

namespace gliftc::lower {

/// A condition under which an update is made: the value is true, or false.
struct Condition {
    ExprId value;
    bool is_true = true;
};

struct Update {
    StmtId stmt;                        ///< the `atomic`
    std::vector<Condition> conditions;  ///< of the ifs around it, the outermost first
    std::uint8_t same_along = 0;        ///< bit i: its address is the same for all elements along axis i
    bool may_collide = false;           ///< elements that are near each other may have one address
    bool differs = false;               ///< elements have one address only if they differ along same_along alone
    bool is_in_loop = false;
    std::uint32_t run = 1;  ///< so many consecutive elements along x mostly have one address: 1, 4, 8 or 16
};

/// Finds the updates of an expanded body, before its uniform values are parameters.
class Updates {
public:
    explicit Updates(Context& context);

    /// Empty if the body has a return.
    std::vector<Update> of(const std::vector<StmtId>& body);

    /// Of the body that was given to of(): whether it has a loop, or calls a function with one. Lavapipe limits the
    /// rounds of an invocation's loops, so they must not be multiplied by the number of its elements.
    bool has_loop() const { return has_loop_; }
    /// How many loads that body has.
    std::uint32_t loads() const { return loads_; }
    /// Whether that body can be repeated for each element of an invocation.
    bool may_repeat() const { return !has_loop_ && !has_return_; }
    /// Whether the value cannot change within the pass.
    bool is_fixed(ExprId value) { return numbers_.is_fixed(value); }
    bool has_load(ExprId value) { return numbers_.has_load(value); }
    bool is_same_along(std::uint32_t axis, ExprId value);
    /// Whether the local that a statement outside of ifs declares is the same for all elements of a block.
    bool is_of_block(LocalId local) const { return locals_of_block_.contains(local); }

private:
    void visit(StmtId id);
    void visit_all(const std::vector<StmtId>& body);
    void visit_if(const ir::Stmt& stmt);
    void visit_loop(const ir::Stmt& stmt);
    bool calls_a_loop(ExprId id) const;
    bool contains_loop(const std::vector<StmtId>& body) const;
    void note(StmtId id);
    bool differs(ExprId target, std::uint8_t same_along);
    bool is_affine(ExprId index);
    bool has_definition(ExprId value) const;
    std::uint32_t run_of(ExprId target);
    void learn(RowSlopes& slopes, std::uint32_t axis, const ir::Stmt& let);

    Context& cx;
    Numbers numbers_;
    std::vector<RowSlopes> slopes_;  ///< one an axis
    std::optional<BlockValues> of_block_;
    IdSet<ir::Expr> seen_;
    std::vector<Condition> conditions_;
    std::vector<Update> found_;
    std::vector<StmtId> lets_;          ///< seen so far
    IdSet<ir::Local> locals_of_block_;  ///< those of them that are the same for all elements of a block
    bool has_loop_ = false, has_return_ = false;
    std::uint32_t depth_ = 0;  ///< of loops around the statement
    std::uint32_t loads_ = 0;
};

}  // namespace gliftc::lower
