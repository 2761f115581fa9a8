// The size of expressions if printed as trees.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// The number of nodes of an expression as a tree: a node with several parents counts once for each.
class TreeSizes {
public:
    explicit TreeSizes(const Context& context) : p(context.p), sizes_(context.first_expr) {}

    /// At most UINT32_MAX.
    std::uint32_t of(ExprId id) {
        if (const std::uint32_t* found = sizes_.find(id)) return *found;
        std::uint64_t size = 1;
        for (ExprId operand : p.exprs[id].operands) size += of(operand);
        const auto bounded = static_cast<std::uint32_t>(std::min<std::uint64_t>(size, UINT32_MAX));
        sizes_.emplace(id, bounded);
        return bounded;
    }

private:
    const ir::Program& p;
    NodeMap<ExprId, std::uint32_t> sizes_;
};

}  // namespace gliftc::lower
