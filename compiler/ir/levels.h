// Which operations may stand where: each operation and each kind of statement belongs to one level.
//
// Kernels as sema makes them hold values and structures, pipelines and tests values and host operations, lowered passes
// values and memory.
#pragma once

#include "ir/ir.h"

#include <string_view>

namespace gliftc::ir {

enum class Level : std::uint8_t {
    value,      ///< arithmetic, locals, control flow: everywhere
    shape,      ///< what a structure was made with, its extents: kernels before lowering, pipelines, uniform parameters
    structure,  ///< elements, addresses, windows: kernels before lowering
    host,       ///< passes, read-back, slices: pipelines and tests
    memory,     ///< loads, stores, parameters: passes after lowering
};

Level level_of(Op op);
Level level_of(StmtOp op);
std::string_view name_of(Op op);
std::string_view name_of(StmtOp op);
std::string_view name_of(Level level);

/// An operation has come to a place that its level cannot reach: a bug of gliftc, reported as such.
[[noreturn]] void misplaced(Op op, std::string_view where);
[[noreturn]] void misplaced(StmtOp op, std::string_view where);

}  // namespace gliftc::ir
