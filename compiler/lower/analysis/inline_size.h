// Estimates how much code inlining a call makes.
#pragma once

#include "ir/ir.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace gliftc::lower {

/// Sizes of functions as straight-line code. A size includes those of the called functions that can be inlined, too, so
/// that nested calls are inlined only as far as the result stays small.
class InlineSizes {
public:
    explicit InlineSizes(const ir::Program& program) : p(program) {}

    /// An estimate of the number of nodes that inlining a call makes, with loops unrolled. None if the call is not to
    /// be inlined: the function cannot be executed symbolically (inline.cpp), has a loop of too many rounds, or makes
    /// too many nodes.
    std::optional<std::size_t> of(ir::FunctionId function);

private:
    using Statements = std::vector<ir::StmtId>;
    using Loops = std::vector<ir::LocalId>;  ///< variables of the enclosing loops
    std::optional<std::size_t> of(const Statements& body, Loops& loops);
    std::optional<std::size_t> of_both(const ir::Stmt& stmt, const Statements& rest, Loops& loops);
    std::optional<std::size_t> of_loop(const ir::Stmt& stmt, Loops& loops);
    std::size_t of_value(ir::ExprId root);

    const ir::Program& p;
    std::unordered_map<ir::FunctionId, std::optional<std::size_t>> sizes_;
};

}  // namespace gliftc::lower
