// Passes of which each rank computes its part.
#include "page_kernels.h"
#include "rank_stream.h"

#include <glift/iteration.h>

#include <algorithm>
#include <chrono>
#include <cstring>

namespace glift::detail {

namespace {

bool reads(const Binding& binding) { return binding.access != Access::write; }
bool writes(const Binding& binding) { return binding.access != Access::read; }
bool is_local(const Binding& binding) { return binding.reach == Reach::element || binding.reach == Reach::window; }

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::uint32_t up_to(std::uint32_t value, std::uint32_t multiple) {
    return (value + multiple - 1) / multiple * multiple;
}

/// Whether this rank has all elements of which the pass may read any.
bool must_gather(const Binding& binding, const Coverage& coverage, const PassPlan& plan) {
    if (!coverage.is_partial()) return false;
    if (is_local(binding)) return coverage.space != plan.space;
    return true;
}

}  // namespace

/// Reads where each plane of pages begins in the list, after it has changed.
void RankStream::refresh(Paging& paging, const Cuts& cuts) {
    if (!paging.is_stale) return;
    const std::uint32_t count = cuts.planes() + 1;
    if (!paging.planes)
        paging.planes =
            local().allocate({.name = "planes of pages", .bytes = 4 * std::uint64_t{count}, .zeroed = false});
    const FindPlanes parameters = {count,
                                   paging.pages_of_plane,
                                   static_cast<std::uint32_t>(paging.count.offset / 4),
                                   static_cast<std::uint32_t>(paging.list.description().bytes / 4),
                                   {}};
    const Memory memories[] = {paging.list, paging.count.memory, paging.planes};
    local().dispatch(find_planes_kernel, {.form = FormName::general,
                                          .memories = memories,
                                          .parameters = glift::bytes_of(parameters),
                                          .size = {count, 1, 1, 1}});
    const std::vector<std::byte> bytes = bytes_of(paging.planes);
    paging.first_of_plane.resize(count);
    std::memcpy(paging.first_of_plane.data(), bytes.data(), 4 * std::size_t{count});
    paging.forget_sublists();
    paging.is_stale = false;
}

/// The pages of two parts of the planes, as a list of their own.
const Paging::Sublist& RankStream::sublist(Paging& paging, Planes lower, Planes upper) {
    for (const Paging::Sublist& list : paging.sublists)
        if (list.lower == lower && list.upper == upper) return list;
    const auto part = [&](Planes planes) {
        if (planes.count() == 0) return Planes{};
        return Planes{paging.first_of_plane[planes.first], paging.first_of_plane[planes.end]};
    };
    const Planes first = part(lower), second = part(upper);
    Paging::Sublist list{lower, upper, Memory(), first.count() + second.count()};
    if (!paging.spare.empty()) {
        list.memory = paging.spare.back();
        paging.spare.pop_back();
    } else {
        const MemoryDescription& whole = paging.list.description();
        list.memory = local().allocate({.name = "pages of a rank", .bytes = whole.bytes, .zeroed = false});
    }
    if (list.pages != 0) {
        const TakePages parameters = {list.pages, first.first, first.count(), second.first, {}};
        const Memory memories[] = {paging.list, list.memory};
        local().dispatch(take_pages_kernel, {.form = FormName::general,
                                             .memories = memories,
                                             .parameters = glift::bytes_of(parameters),
                                             .size = {list.pages, 1, 1, 1}});
    }
    return paging.sublists.emplace_back(std::move(list));
}

void RankStream::run_distributed(const Kernel& kernel, const Call& call, const PassPlan& plan) {
    for (std::size_t k = 0; k < call.memories.size(); ++k) {
        Coverage* coverage = coverages_.find(call.memories[k]);
        if (coverage && must_gather(kernel.bindings[k], *coverage, plan)) gather(call.memories[k]);
    }
    for (const Patch& patch : call.patches) gather(patch.value);
    if (plan.space->paging) refresh(*plan.space->paging, plan.space->cuts);
    const std::vector<Before> before = keep_before(kernel, call, plan);
    const std::uint32_t extension = run_parts(kernel, call, plan);
    combine(kernel, call, before);
    ++statistics_.distributed_passes;
    for (std::size_t k = 0; k < call.memories.size(); ++k) {
        if (!writes(kernel.bindings[k])) continue;
        note_topology_write(call.memories[k]);
        if (!is_local(kernel.bindings[k])) continue;
        Coverage* coverage = coverages_.find(call.memories[k]);
        if (!coverage || coverage->space != plan.space) {
            Coverage made;
            made.space = plan.space;
            coverage = &coverages_.set(call.memories[k], std::move(made));
        }
        if (plan.layouts.size() > k && plan.layouts[k]) coverage->layout = coverage->ghost_layout = *plan.layouts[k];
        // An element that the pass leaves as it is, is as old as it was.
        coverage->ghost = std::min(extension, coverage->ghost);
    }
}

/// How far beyond its own elements this rank can compute: as far as it has what the pass reads.
std::uint32_t RankStream::extension_of(const Kernel& kernel, const Call& call, const PassPlan& plan) {
    if (!plan.scattered.empty()) return 0;
    std::uint32_t extension = plan.space->halo;
    for (std::size_t k = 0; k < call.memories.size(); ++k) {
        const Binding& binding = kernel.bindings[k];
        if (plan.layouts.size() > k && plan.layouts[k] && plan.layouts[k]->wraps()) return 0;
        const Coverage* coverage = coverages_.find(call.memories[k]);
        if (!coverage || !coverage->is_partial() || !reads(binding) || !is_local(binding)) continue;
        const std::uint32_t radius = binding.reach == Reach::window ? binding.radius : 0;
        extension = std::min(extension, coverage->ghost - std::min(coverage->ghost, radius));
    }
    return extension;
}

/// The elements around a rank's own that the pass reads and that are older here than at their owners.
std::vector<Piece> RankStream::missing_ghosts(const Kernel& kernel, const Call& call, const PassPlan& plan) {
    std::vector<Piece> missing;
    for (std::size_t k = 0; k < call.memories.size(); ++k) {
        const Binding& binding = kernel.bindings[k];
        if (binding.reach != Reach::window || !reads(binding)) continue;
        Coverage* coverage = coverages_.find(call.memories[k]);
        if (!coverage || !coverage->is_partial()) continue;
        const SlabLayout edges = plan.layouts.size() > k && plan.layouts[k] ? *plan.layouts[k] : coverage->layout;
        if (coverage->ghost >= binding.radius && coverage->ghost_layout == edges) continue;
        const std::uint32_t width = std::max(binding.radius, plan.space->halo);
        const std::vector<Piece> pieces = ghost_pieces(call.memories[k], *coverage, width, edges);
        missing.insert(missing.end(), pieces.begin(), pieces.end());
        coverage->ghost = width;
        coverage->ghost_layout = edges;
    }
    return missing;
}

/// Computes this rank's part. If elements are missing, those that need none of them are computed while they arrive.
/// Returns how far beyond its own elements the rank has computed.
std::uint32_t RankStream::run_parts(const Kernel& kernel, const Call& call, const PassPlan& plan) {
    const Cuts& cuts = plan.space->cuts;
    const Planes own = cuts.of(messenger_.rank());
    const std::vector<Piece> missing = missing_ghosts(kernel, call, plan);
    const std::uint32_t layers = plan.space->paging ? plan.space->paging->layers : 1;
    const std::uint32_t extension = extension_of(kernel, call, plan), beyond = (extension + layers - 1) / layers;
    Planes all = own;
    if (own.count() != 0) all = {own.first - std::min(own.first, beyond), std::min(own.end + beyond, cuts.planes())};
    if (missing.empty()) {
        run_planes(kernel, call, plan, all);
        return extension;
    }
    const double begin = now();
    const Messenger::Started started = messenger_.start(missing);
    const std::uint32_t width = (plan.radius + layers - 1) / layers;
    Planes inner = {own.first + width, own.end - std::min(own.end, width)};
    if (!plan.space->paging && inner.count() != 0) {
        // Between workgroups, so that no element is computed twice.
        inner.first = std::max(plan.origin, inner.first);
        inner.first = plan.origin + up_to(inner.first - plan.origin, plan.covered);
        inner.end = std::max(inner.end, plan.origin);
        inner.end = plan.origin + (inner.end - plan.origin) / plan.covered * plan.covered;
    }
    const bool overlaps = options_.overlaps && inner.count() != 0 && plan.scattered.empty();
    if (overlaps) {
        run_planes(kernel, call, plan, inner);
        local().flush();
    }
    const double waits = now();
    statistics_.exchanged_bytes += messenger_.finish(started);
    ++statistics_.exchanges;
    statistics_.exchange_seconds += now() - (overlaps ? waits : begin);
    if (overlaps) run_planes(kernel, call, plan, {all.first, inner.first}, {inner.end, all.end});
    else run_planes(kernel, call, plan, all);
    local().flush();
    passes_since_flush_ = 0;
    return extension;
}

void RankStream::run_planes(const Kernel& kernel, const Call& call, const PassPlan& plan, Planes lower, Planes upper) {
    if (plan.space->paging) return run_pages(kernel, call, *plan.space, lower, upper);
    for (const Planes& planes : {lower, upper}) {
        const std::uint32_t first = std::max(planes.first, plan.origin) - plan.origin;
        const std::uint32_t end = std::min(std::max(planes.end, plan.origin) - plan.origin, plan.size);
        if (first >= end) continue;
        Call part = call;
        if (first != 0 || end != plan.size) part.part = Part{first, end};
        local().dispatch(kernel, part);
    }
}

/// Runs the pass over the pages of some planes: with a list of them in place of the list of all pages.
void RankStream::run_pages(const Kernel& kernel, const Call& call, const Space& space, Planes lower, Planes upper) {
    const Paging::Sublist list = sublist(*space.paging, lower, upper);
    if (list.pages == 0) return;
    std::vector<Memory> memories(call.memories.begin(), call.memories.end());
    std::ranges::replace(memories, space.paging->list, list.memory);
    std::vector<std::byte> parameters(call.parameters.begin(), call.parameters.end());
    const std::uint32_t at = form_of(kernel, call.form).size_offset + 4;
    std::memcpy(parameters.data() + at, &list.pages, 4);
    std::vector<Patch> patches(call.patches.begin(), call.patches.end());
    std::erase_if(patches, [&](const Patch& patch) { return patch.offset == at; });
    Call part = call;
    part.memories = memories;
    part.parameters = parameters;
    part.size[1] = list.pages;
    part.patches = patches;
    part.fixed = {};
    local().dispatch(kernel, part);
}

}  // namespace glift::detail
