// Which loops are unrolled: those with constant bounds whose neighbour offsets depend on the loop, so that the offsets
// become constants.
#pragma once

#include "ir/ir.h"

#include <cstdint>
#include <optional>

namespace gliftc::lower {

inline constexpr std::uint64_t unroll_limit = 64;

/// Whether the type is an array that is too long to unroll, or holds one.
bool is_long_array(const ir::Program& program, ir::TypeId type);

/// The rounds of `for i in first..limit` with constant bounds.
struct Rounds {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};
std::optional<Rounds> rounds_of(const ir::Program& program, ir::ExprId first, ir::ExprId limit);

/// Whether the loop's variable takes part in the index of an array of the invocation's own. Such arrays live in
/// registers only where all their indices are known.
bool indexes_array_by_loop(const ir::Program& program, const ir::Stmt& loop);

/// Whether an offset of a near access in the loop names the loop's variable or something declared in the loop.
bool has_near_depending_on_loop(const ir::Program& program, const ir::Stmt& loop);

/// Whether the statements hold a break or continue of the loop they are the body of.
bool leaves_loop(const ir::Program& program, const std::vector<ir::StmtId>& body);

/// Whether the statements hold a return, at any depth.
bool returns(const ir::Program& program, const std::vector<ir::StmtId>& body);

}  // namespace gliftc::lower
