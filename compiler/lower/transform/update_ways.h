// Chooses what becomes of a kernel's updates in shaders (privatise.h), and how many elements an invocation takes.
#pragma once

#include "lower/analysis/updates.h"
#include "lower/build/combination.h"
#include "lower/transform/several_elements.h"

#include <optional>
#include <vector>

namespace gliftc::lower {

/// An update, what becomes of it, and the locals that this takes.
struct PrivateUpdate : Update {
    ir::UpdateWay way = ir::UpdateWay::plain;
    std::optional<ir::SumOrder> order;
    LocalId sum;                    ///< of tree, column and run: what the invocation has combined
    std::vector<LocalId> row_sums;  ///< of tree: the same for each of the workgroup's rows
    LocalId at;                     ///< of run: for which element of the buffer
};

struct UpdateWays {
    std::vector<PrivateUpdate> updates;
    std::uint32_t axis = 0;  ///< along which an invocation takes elements
    bool has_runs = false;   ///< it takes consecutive ones
    SeveralElements made;    ///< how many elements; the workgroup's size
};

/// How the update's values are combined.
Combination combination_of(Context& cx, const Update& update);

/// Absent: no update gains.
std::optional<UpdateWays> ways_of_updates(Context& cx, const std::vector<Update>& updates, const Updates& dependence);

}  // namespace gliftc::lower
