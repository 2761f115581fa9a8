// Questions about loops and arrays. Most of them decide which loops of a kernel are unrolled. (Loops of inlined
// functions always are, see inline.cpp.) A kernel's loop is unrolled only if it has constant bounds, and for one of two
// reasons. If offsets of neighbour reads depend on the loop and it has at most near_unroll_limit iterations, its body
// is copied for each iteration, so that these offsets become constants, unless a break, a continue or the return of an
// expanded function leaves the loop. If the loop indexes a private array by its variable and has at most unroll_limit
// iterations, it gets an unroll hint for the shader's compiler.
#pragma once

#include "ir/ir.h"

#include <cstdint>
#include <optional>

namespace gliftc::lower {

inline constexpr std::uint64_t unroll_limit = 64;
inline constexpr std::uint32_t near_unroll_limit = 65 * 65;  ///< one loop over a square window of the largest radius

/// Whether the type is an array of more than unroll_limit elements, or an array of such arrays.
bool is_long_array(const ir::Program& program, ir::TypeId type);

/// The iterations of `for i in first..limit` with constant bounds.
struct Rounds {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};
std::optional<Rounds> rounds_of(const ir::Program& program, ir::ExprId first, ir::ExprId limit);

/// Whether the loop's variable occurs in an index of a private array: the first index into a local that is an array and
/// not in workgroup memory. Such arrays stay in registers only if all their indices are compile-time constants after
/// unrolling.
bool indexes_array_by_loop(const ir::Program& program, const ir::Stmt& loop);

/// Whether the offset of a neighbour read (Op::near) in the loop uses the loop's variable or a local declared in it.
bool has_near_depending_on_loop(const ir::Program& program, const ir::Stmt& loop);

/// Whether the statements, the body of a loop, contain a break or continue of that loop.
bool leaves_loop(const ir::Program& program, const std::vector<ir::StmtId>& body);

/// Whether the statements contain a return, at any depth.
bool returns(const ir::Program& program, const std::vector<ir::StmtId>& body);

}  // namespace gliftc::lower
