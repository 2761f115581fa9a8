// The updates of a kernel (`scatter` with an operation) and how their addresses depend on the element's.
#pragma once

#include "lower/analysis/number.h"
#include "lower/analysis/slopes.h"
#include "lower/context.h"

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
};

/// Finds the updates of an expanded body, before its uniform values are parameters.
class Updates {
public:
    explicit Updates(Context& context);

    /// Empty if the body has a statement that cannot be repeated for each element of an invocation: a loop, whose
    /// rounds lavapipe limits, a return, or a call of a function with a loop.
    std::vector<Update> of(const std::vector<StmtId>& body);

    /// Whether the body that was given to of() has no such statement.
    bool may_repeat() const { return may_repeat_; }
    /// Whether the value cannot change within the pass.
    bool is_fixed(ExprId value) { return numbers_.is_fixed(value); }
    bool has_load(ExprId value) { return numbers_.has_load(value); }
    bool is_same_along(std::uint32_t axis, ExprId value);

private:
    void visit(StmtId id);
    void visit_all(const std::vector<StmtId>& body);
    void visit_if(const ir::Stmt& stmt);
    bool calls_a_loop(ExprId id) const;
    bool has_loop(const std::vector<StmtId>& body) const;
    void note(StmtId id);
    bool differs(ExprId target, std::uint8_t same_along);
    bool is_affine(ExprId index);

    Context& cx;
    Numbers numbers_;
    std::vector<RowSlopes> slopes_;  ///< one an axis
    IdSet<ir::Expr> seen_;
    std::vector<Condition> conditions_;
    std::vector<Update> found_;
    bool may_repeat_ = true;
};

}  // namespace gliftc::lower
