// Values in kernels over blocks that the block alone decides.
#pragma once

#include "lower/analysis/number.h"
#include "lower/context.h"

namespace gliftc::lower {

/// Finds the values that are the same for all elements of a block and do not change in the pass.
class BlockValues {
public:
    explicit BlockValues(Context& context) : cx(context), numbers_(context) {}

    bool has(ExprId id);
    /// Whether the statement is a `let` that gives such a value to an immutable local. The local of any other `let` is
    /// noted as varying, so this has to be called for all `let`s, in the order of the body.
    bool has(const ir::Stmt& stmt);

private:
    Context& cx;
    Numbers numbers_;
    IdSet<ir::Local> varying_;
};

}  // namespace gliftc::lower
