// Cuts long `else if` chains into parts that follow each other. Each link of a chain is a branch inside the `else` of
// the one before it, and lavapipe (Mesa 22.3) ignores the conditions of branches that are nested more than about 80
// deep. From the link `longest_chain` on, the rest of a chain moves behind it:
//
//     var rest = false;
//     if c0 { … } else if c1 { … } else { rest = true; }
//     if rest { rest = false; if c2 { … } else if … else { rest = true; } }
//     if rest { … }
//
// A chain ends where its rest would use a variable that is declared in one of its `else` branches. The rest is then a
// chain of its own, which stays inside.
//
// Guarantees: no chain has more links than `longest_chain`; the same statements are executed in the same order.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

inline constexpr std::size_t longest_chain = 32;

std::vector<StmtId> split_chains(Context& cx, const std::vector<StmtId>& body);

/// Splits the chains of the functions without structures, which lowered kernels call as they are. Returns the functions
/// that have changed.
std::vector<ir::FunctionId> split_chains(ir::Program& program);

}  // namespace gliftc::lower
