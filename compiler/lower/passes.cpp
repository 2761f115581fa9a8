#include "lower/passes.h"

#include "lower/predicate.h"
#include "lower/share.h"
#include "lower/strength.h"

#include <algorithm>

namespace gliftc::lower {

namespace {

using Body = std::vector<StmtId>;
using Facts = std::vector<ExprId>;

/// A pass that no fact helps.
template <Body (*run)(Context&, const Body&)> Body without_facts(Context& cx, const Body& body, const Facts&) {
    return run(cx, body);
}

bool always(const Context&) { return true; }
bool has_group(const Context& cx) { return cx.kernel.grouped(); }

constexpr BodyPass share_pass{
    "share", "statements of memory, whose expressions may share nodes",
    "what is equal is computed once; expressions are trees; nothing is moved past a write that it depends on", share,
    always};
constexpr BodyPass drop_dead_pass{"drop_dead", "trees", "no let that nothing uses", without_facts<drop_dead>, always};

constexpr BodyPass bodies[] = {
    share_pass,
    {"strengthen", "shared bodies", "integers that differ by a uniform amount are computed one from the other",
     without_facts<strengthen>, always},
    share_pass,
    drop_dead_pass,
    {"predicate_loads", "shared bodies without dead lets",
     "what is loaded where a condition holds and counts only there is loaded under a branch",
     without_facts<predicate_loads>, has_group},
    drop_dead_pass,
    {"merge_single_uses", "trees", "temporaries that are used once, in no deeper loop, stand where they are used",
     without_facts<merge_single_uses>, always},
};

constexpr KernelPass kernels[] = {
    {"expand", "a checked kernel",
     "no operation of structures; functions inlined; every access guarded that may leave memory"},
    {"coarsen", "the expanded body of a kernel without a group", "a second body, for two elements an invocation"},
    {"simplify", "expanded bodies", "the body passes have run over each of them and over the functions they call"},
    {"move_uniforms", "all bodies of the pass", "uniform values are parameters that the host computes"},
};

}  // namespace

std::span<const BodyPass> body_passes() { return bodies; }
std::span<const KernelPass> kernel_passes() { return kernels; }

bool is_pass(std::string_view name) {
    return std::ranges::any_of(bodies, [&](const BodyPass& pass) { return pass.name == name; }) ||
           std::ranges::any_of(kernels, [&](const KernelPass& pass) { return pass.name == name; });
}

}  // namespace gliftc::lower
