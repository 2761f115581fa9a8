// Loops that move rows of numbers between an array of the invocation's own and memory, one row behind the other: on the
// host one copy, which the C++ compiler knows how to make of vectors.
#pragma once

#include "ir/pass.h"

#include <optional>

namespace gliftc::host {

struct RowMove {
    bool is_load = false;
    ir::ExprId array;  ///< the local, all of which is moved
    std::uint32_t binding = 0;
    ir::ExprId first;  ///< the first row in memory
};

std::optional<RowMove> row_move_of(const ir::Program& program, const ir::Pass& pass, const ir::Stmt& loop);

}  // namespace gliftc::host
