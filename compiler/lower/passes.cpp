#include "lower/passes.h"

#include "lower/host/move_rows.h"
#include "lower/host/split_at_barriers.h"
#include "lower/host/split_at_derivatives.h"
#include "lower/host/version_loops.h"
#include "lower/transform/dead.h"
#include "lower/transform/guard.h"
#include "lower/transform/narrow_loads.h"
#include "lower/transform/narrow_stores.h"
#include "lower/transform/share.h"
#include "lower/transform/split_chains.h"
#include "lower/transform/split_structs.h"
#include "lower/transform/strength.h"

#include <algorithm>

namespace gliftc::lower {

using ir::Part;

namespace {

using Body = std::vector<StmtId>;
using Facts = std::vector<ExprId>;

/// Adapts a pass that has no use for facts.
template <Body (*run)(Context&, const Body&)> Body without_facts(Context& cx, const Body& body, const Facts&) {
    return run(cx, body);
}

bool has_group(const Context& cx) { return cx.kernel.grouped(); }
bool takes_many(const Context& cx) { return !cx.kernel.grouped() && cx.pass.items != 1; }

bool is_of_fragments(const Context& cx) { return cx.part == Part::fragment; }

constexpr BodyPass share_pass{
    "share", "statements of memory, whose expressions may share nodes",
    "what is equal is computed once; expressions are trees; nothing is moved past a write that it depends on", share};
constexpr BodyPass drop_dead_pass{
    "drop_dead", "trees", "no let that nothing uses, no value of a local that nothing reads", without_facts<drop_dead>};

constexpr BodyPass bodies[] = {
    {"split_chains", "statements of memory", "no chain of `else if` has more than 32 links",
     without_facts<split_chains>},
    share_pass,
    drop_dead_pass,
    {"guard", "shared bodies without dead lets", "no guarded_load: loads from safe addresses, or under branches",
     without_facts<guard>},
    {"strengthen", "shared bodies", "integers that differ by a uniform amount are computed one from the other",
     without_facts<strengthen>},
    share_pass,
    drop_dead_pass,
    {"narrow_stores", "trees", "stores of a struct are stores of those members that may differ from what memory holds",
     without_facts<narrow_stores>},
    {"split_structs", "trees",
     "of structs that are loaded, those of which only some members are used are a local for each such member",
     without_facts<split_structs>},
    {"merge_single_uses", "trees", "temporaries that are used once, in no deeper loop, stand where they are used",
     without_facts<merge_single_uses>},
    {"narrow_loads", "trees", "loads of a vector of which one component is used are loads of that component",
     without_facts<narrow_loads>},
};

constexpr BodyPass host_bodies[] = {
    {"version_loops", "uniform values are parameters",
     "where one test holds for all that an invocation's loops reach, their guards are gone",
     without_facts<version_loops>, takes_many},
    {"move_rows", "trees", "loops that move rows of numbers to or from an array are one statement",
     without_facts<move_rows>},
    {"split_at_barriers", "a kernel with a group, and its prologue",
     "what lies between barriers is a loop over the invocations; what crosses them is kept for each",
     without_facts<split_at_barriers>, has_group},
    {"split_at_derivatives", "a fragment part", "what lies between derivatives is a loop over the fragments of a block",
     without_facts<split_at_derivatives>, is_of_fragments},
};

constexpr KernelPass kernels[] = {
    {"fold_constants", "checked functions that all kernels share",
     "what they compute of constants alone, without arithmetic of uints, is a constant; selects of constants are made"},
    {"expand", "a checked kernel",
     "no operation of structures; functions inlined; loads that may leave memory are guarded_load"},
    {"coarsen", "the expanded body of a kernel without a group",
     "a second body, for two elements per invocation, or up to eight of a block"},
    {"privatise", "the expanded body of a kernel without a group or returns",
     "a second body, mostly for many elements per invocation, that combines their updates before it makes them, sums "
     "of floats in one order; for the host device, a body whose updates can be combined along rows and columns"},
    {"stage", "the expanded body of a kernel without a group, with one loop over a uniform range",
     "a second body, in which a workgroup loads together what its invocations load in the loop"},
    {"tile", "the expanded body of a kernel in two or three dimensions, without a group, loops or returns",
     "a second body, for the elements of a tile, that makes transposed accesses through workgroup memory"},
    {"move_uniforms", "all bodies of the pass", "uniform values are parameters that the host computes"},
    {"split_blocks", "the host device's body for blocks all of whose elements are visited",
     "values that depend on the block alone are computed once per block"},
    {"copy_rows", "split blocks",
     "loops that copy a row of memory to an array that is filled once per block are one statement"},
    {"lockstep", "variants for the host device of a kernel without a group, blocks, updates or coherent parameters",
     "elements of a row that run one loop over the same range run it in lockstep: each round for a run of elements"},
    {"find_rows", "variants for the host device of a kernel without a group",
     "accesses whose address advances by one from each element of a row to the next are row_load and row_store; in the "
     "middle of a row none of them is clamped; the order in which elements may be done is known"},
    {"find_row_updates", "the same variants after find_rows",
     "updates whose address is the same for all elements of a row are row_update; sums in one order are row_update or "
     "column_update"},
};

}  // namespace

std::span<const BodyPass> body_passes() { return bodies; }
std::span<const BodyPass> host_passes() { return host_bodies; }
std::span<const KernelPass> kernel_passes() { return kernels; }

bool is_pass(std::string_view name) {
    const auto is_called_so = [&](const auto& pass) { return pass.name == name; };
    return std::ranges::any_of(bodies, is_called_so) || std::ranges::any_of(host_bodies, is_called_so) ||
           std::ranges::any_of(kernels, is_called_so);
}

}  // namespace gliftc::lower
