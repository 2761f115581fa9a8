// Combines a value of each invocation of a workgroup, through workgroup memory.
#pragma once

#include "lower/build/combination.h"
#include "lower/build/statements.h"

#include <string_view>
#include <vector>

namespace gliftc::lower {

/// Two levels of additions (or of another operation): each invocation below 16 combines its value with every 16th of
/// the others, then the first one combines those. Eight levels of halves would take four times as many barriers.
class WorkgroupTree {
public:
    static constexpr std::uint32_t invocations = 256, branches = 16, most_levels = 2;
    static_assert(branches * branches == invocations);

    /// `name`: of the array in workgroup memory.
    WorkgroupTree(Context& context, const Combination& combination, std::string_view name, Span span);

    /// Statements after which first() is what the keys of all invocations combine to, in the first invocation.
    /// `levels`: most_levels; or a variable that is 0 where nothing is to be combined.
    std::vector<StmtId> combine(ExprId key, ExprId levels);
    ExprId first() { return of(build.uint(0)); }

private:
    ExprId lane() { return build.builtin(ir::Builtin::local_index, cx.p.types.uint); }
    ExprId of(ExprId invocation) { return build.index(build.local(keys_), invocation); }
    std::vector<StmtId> level(ExprId number);

    Context& cx;
    Builder& build;
    const Combination combination_;
    Statements make;
    LocalId keys_;
};

}  // namespace gliftc::lower
