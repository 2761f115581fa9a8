// Levels of the IR: each operation and each kind of statement belongs to one.
//
// Kernels as sema makes them hold values and structures, pipelines and tests values and host operations, lowered passes
// values and memory; their variants for the host device also what the passes for it make.
#pragma once

#include "ir/ir.h"

#include <string_view>

namespace gliftc::ir {

enum class Level : std::uint8_t {
    value,      ///< arithmetic, locals, control flow: everywhere
    shape,      ///< what a structure was made with, its extents: kernels before lowering, pipelines, uniform parameters
    structure,  ///< elements, addresses, windows: kernels before lowering
    host,       ///< passes, read-back, slices: pipelines and tests
    guarded,    ///< accesses with the condition that they need: lowered bodies before the pass "guard"
    memory,     ///< loads, stores, parameters: passes after lowering
    cpu,        ///< rows of memory, workgroups as loops: variants for the host device
};

Level level_of(Op op);
Level level_of(StmtOp op);
std::string_view name_of(Op op);
std::string_view name_of(StmtOp op);
std::string_view name_of(Level level);

/// Reports an internal error: an operation of the wrong level.
[[noreturn]] void misplaced(Op op, std::string_view where);
[[noreturn]] void misplaced(StmtOp op, std::string_view where);

}  // namespace gliftc::ir
