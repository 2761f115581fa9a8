#include "pass_plan.h"

#include <algorithm>
#include <string_view>

namespace glift::detail {

namespace {

bool is_local(const Binding& binding) { return binding.reach == Reach::element || binding.reach == Reach::window; }
bool writes(const Binding& binding) { return binding.access != Access::read; }
bool reads(const Binding& binding) { return binding.access != Access::write; }

/// Whether ranks can combine what they write through this binding: words of which one value results, in any order.
bool can_be_combined(const Binding& binding) {
    if (binding.kind != MemoryKind::buffer || binding.element_bytes % 4 != 0) return false;
    switch (binding.update) {
    case Update::store:
    case Update::assign:
    case Update::bit_and:
    case Update::bit_or:
    case Update::bit_xor: return true;
    case Update::min:
    case Update::max: return binding.element_bytes == 4;
    case Update::add: return binding.element_bytes == 4 && binding.number != Number::real;
    case Update::other: return false;
    }
    return false;
}

bool find_scattered(const Kernel& kernel, const Call& call, PassPlan& plan) {
    for (std::size_t k = 0; k < kernel.bindings.size(); ++k) {
        const Binding& binding = kernel.bindings[k];
        if (!writes(binding) || is_local(binding)) continue;
        const auto is_same = [&](const Memory& other) { return other == call.memories[k]; };
        if (!can_be_combined(binding) || std::ranges::count_if(call.memories, is_same) != 1) return false;
        plan.scattered.push_back(k);
    }
    return true;
}

/// Adds the radius of the windows; false where ranks do not exchange as many elements.
bool find_radius(const Kernel& kernel, PassPlan& plan) {
    for (const Binding& binding : kernel.bindings)
        if (binding.reach == Reach::window && reads(binding)) plan.radius = std::max(plan.radius, binding.radius);
    return plan.radius <= SlabLayout::farthest;
}

std::optional<PassPlan> paged_plan(const Kernel& kernel, const Call& call, Coverages& coverages,
                                   std::span<const std::shared_ptr<Space>> spaces) {
    PassPlan plan;
    for (const std::shared_ptr<Space>& space : spaces)
        if (std::ranges::find(call.memories, space->paging->list) != call.memories.end()) plan.space = space;
    if (!plan.space) return std::nullopt;
    for (std::size_t k = 0; k < kernel.bindings.size(); ++k) {
        const Binding& binding = kernel.bindings[k];
        const Memory& memory = call.memories[k];
        const Paging& paging = *plan.space->paging;
        const bool is_listing = memory == paging.list || memory == paging.table;
        if (is_listing && writes(binding)) return std::nullopt;
        // A kernel that reads the list as it reads other structures must see all of it.
        if (memory == paging.list && binding.reach != Reach::memory) return std::nullopt;
        if (!writes(binding) || !is_local(binding)) continue;
        const Coverage* coverage = coverages.find(memory);
        if (!coverage || coverage->space != plan.space) return std::nullopt;
    }
    return plan;
}

bool belongs_to(const Binding& binding, std::string_view parameter) {
    const std::string_view name = binding.name;
    return name.starts_with(parameter) && name.size() > parameter.size() && name[parameter.size()] == '.';
}

/// Finds what the visited ranges have in common, and the layouts of their memories.
std::optional<PassPlan> dense_plan(const Kernel& kernel, const Call& call, Coverages& coverages, SlabLayouts& layouts,
                                   bool is_host) {
    if (call.visited.empty() || !call.patches.empty()) return std::nullopt;
    PassPlan plan;
    std::vector<RangeShape> shapes;
    for (const VisitedRange& visited : call.visited) shapes.push_back(visited.shape(visited.range));
    const unsigned last = shapes[0].rank - 1;
    // An invocation may take several elements of a range.
    if (kernel.rank != shapes[0].rank || call.size != shapes[0].size) return std::nullopt;
    plan.origin = shapes[0].origin[last];
    plan.size = call.size[last];
    for (const RangeShape& shape : shapes) {
        if (shape.rank != kernel.rank || shape.domain[last] != shapes[0].domain[last]) return std::nullopt;
        if (!shape.is_whole && shape.origin[last] != plan.origin) return std::nullopt;
        plan.is_whole = plan.is_whole && shape.is_whole;
    }
    plan.layouts.resize(call.memories.size());
    for (std::size_t k = 0; k < call.memories.size(); ++k) {
        const Binding& binding = kernel.bindings[k];
        if (!is_local(binding)) continue;
        for (std::size_t i = 0; i < shapes.size(); ++i)
            if (belongs_to(binding, call.visited[i].name) &&
                (!shapes[i].indices.memory || shapes[i].indices.memory == call.memories[k])) {
                shapes[i].element_bytes = binding.element_bytes;  // of a component: those of the whole
                plan.layouts[k] = layouts.of(shapes[i]);
            }
        const Coverage* coverage = coverages.find(call.memories[k]);
        if ((writes(binding) || coverage) && !plan.layouts[k]) return std::nullopt;
        if (!coverage) continue;
        if (coverage->space->paging) return std::nullopt;
        if (coverage->layout.plane_bytes != plan.layouts[k]->plane_bytes) return std::nullopt;
        if (coverage->space->cuts.planes() != shapes[0].domain[last]) return std::nullopt;
        plan.space = coverage->space;
    }
    if (!plan.space) return std::nullopt;
    const std::uint32_t axis = std::min(last, 2u);
    if (!is_host) plan.covered = kernel.group[axis] * kernel.items[axis];
    return plan;
}

/// Whether the boundaries between ranks lie between workgroups, so that no element is visited by two ranks. (If a pass
/// only writes its own elements, it does no harm that a rank also computes some of its neighbours'.)
bool is_aligned(const PassPlan& plan) {
    const Cuts& cuts = plan.space->cuts;
    for (unsigned rank = 1; rank < cuts.ranks(); ++rank) {
        const std::uint32_t cut = cuts.of(rank).first;
        if (cut > plan.origin && cut < plan.origin + plan.size && (cut - plan.origin) % plan.covered != 0) return false;
    }
    return true;
}

}  // namespace

std::optional<PassPlan> plan_of(const Kernel& kernel, const Call& call, Coverages& coverages, SlabLayouts& layouts,
                                std::span<const std::shared_ptr<Space>> paged_spaces, bool is_host) {
    if (kernel.drawing || kernel.declares_group || !kernel.sums.empty() || !call.conditions.empty())
        return std::nullopt;
    std::optional<PassPlan> plan = kernel.of_blocks ? paged_plan(kernel, call, coverages, paged_spaces)
                                                    : dense_plan(kernel, call, coverages, layouts, is_host);
    if (!plan || !find_scattered(kernel, call, *plan) || !find_radius(kernel, *plan)) return std::nullopt;
    if (!plan->space->paging && !plan->scattered.empty() && !is_aligned(*plan)) return std::nullopt;
    return plan;
}

}  // namespace glift::detail
