// Combines values of the invocations of a workgroup, through workgroup memory.
#pragma once

#include "lower/build/combination.h"
#include "lower/build/statements.h"

#include <string_view>
#include <vector>

namespace gliftc::lower {

/// Two levels of additions (or of another operation): invocation i below 16 combines the values of the invocations
/// i, i + 16, …, then the first one combines those. Eight levels of halves would take four times as many barriers. If
/// each invocation has a value for several rows, up to 16 of them are combined at the same time.
class WorkgroupTree {
public:
    static constexpr std::uint32_t invocations = 256, branches = 16, most_levels = 2;
    static_assert(branches * branches == invocations);

    /// `name`: of the array in workgroup memory.
    WorkgroupTree(Context& context, const Combination& combination, std::string_view name, Span span,
                  std::uint32_t rows);

    /// Statements after which first(row) is what the keys of the row combine to, in invocation `row`. `levels`:
    /// most_levels; or a variable that is 0 where nothing is to be combined.
    std::vector<StmtId> combine(ExprId levels);
    /// The invocation's key for the row.
    ExprId own(ExprId row) { return key(row, lane()); }
    ExprId first(ExprId row) { return key(row, build.uint(0)); }
    std::uint32_t rows() const { return rows_; }

private:
    ExprId lane() { return build.builtin(ir::Builtin::local_index, cx.p.types.uint); }
    ExprId key(ExprId row, ExprId invocation) {
        return build.index(build.local(keys_), build.add(build.multiply(row, build.uint(invocations)), invocation));
    }
    std::vector<StmtId> level(ExprId number);

    Context& cx;
    Builder& build;
    const Combination combination_;
    Statements make;
    std::uint32_t rows_;
    LocalId keys_;
};

}  // namespace gliftc::lower
