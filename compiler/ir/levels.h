// Levels of the IR: each operation and each kind of statement belongs to one, which says where it may occur.
//
// Kernels as sema makes them contain operations of the levels value, shape and structure, and fragment parts also the
// statement `discard`, whose level is memory. Pipelines and tests contain operations of value, shape and host. Lowered
// passes contain operations of value and memory, and their variants for the host device also of cpu.
#pragma once

#include "ir/ir.h"

#include <string_view>

namespace gliftc::ir {

enum class Level : std::uint8_t {
    value,      ///< arithmetic, locals, control flow; allowed everywhere
    shape,      ///< a structure's arguments and extents; in kernels before lowering, pipelines, uniform parameters
    structure,  ///< elements, addresses, windows; in kernels before lowering
    host,       ///< dispatches, read-back, slices; in pipelines and tests
    guarded,    ///< loads with the condition under which they are allowed; in lowered bodies before the pass "guard"
    memory,     ///< loads, stores, parameters; in passes after lowering
    cpu,        ///< accesses to rows of memory, workgroups as loops; in variants for the host device
};

Level level_of(Op op);
Level level_of(StmtOp op);
std::string_view name_of(Op op);
std::string_view name_of(StmtOp op);
std::string_view name_of(Level level);

/// Throws std::logic_error, an internal error: the operation or statement occurs where its level does not allow it.
/// `where` begins the message.
[[noreturn]] void misplaced(Op op, std::string_view where);
[[noreturn]] void misplaced(StmtOp op, std::string_view where);

}  // namespace gliftc::ir
