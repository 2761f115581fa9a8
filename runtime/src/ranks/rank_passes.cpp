// Passes of which each rank computes its part.
#include "page_kernels.h"
#include "rank_stream.h"

#include <glift/iteration.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace glift::detail {

namespace {

bool reads(const Binding& binding) { return binding.access != Access::write; }
bool writes(const Binding& binding) { return binding.access != Access::read; }
bool is_local(const Binding& binding) { return binding.reach == Reach::element || binding.reach == Reach::window; }

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

/// Makes the sublists from `first_list` on; finds where each plane of pages begins in the list, if that has changed
/// (not again: messages under way may be reading it).
void RankStream::cut_pages(const Paging& paging, const Cuts& cuts, std::uint32_t first_list) {
    const auto end = static_cast<std::uint32_t>(paging.sublists.size());
    const std::uint32_t planes = cuts.planes() + 1;
    CutPages p = {.planes = planes,
                  .pages_of_plane = paging.pages_of_plane,
                  .count_word = static_cast<std::uint32_t>(paging.count.offset / 4),
                  .capacity = static_cast<std::uint32_t>(paging.list.description().bytes / 4),
                  .lists = std::min(end - first_list, CutPages::most_lists),
                  .first_list = first_list};
    std::array<Memory, 5 + CutPages::most_lists> memories = {paging.list, paging.count.memory, paging.planes,
                                                             paging.seen.memory, paging.counts};
    std::uint32_t most = 0;
    for (std::uint32_t k = 0; k < CutPages::most_lists; ++k) {
        const bool is_there = k < p.lists;
        memories[5 + k] = is_there ? paging.sublists[first_list + k].memory : paging.unused[k];
        if (!is_there) continue;
        const auto& [lower, upper, memory, age] = paging.sublists[first_list + k];
        const std::uint32_t bounds[] = {lower.first, lower.end, upper.first, upper.end};
        std::ranges::copy(bounds, p.bounds + 4 * k);
        most = std::max(most, paging.most_pages({0, lower.count() + upper.count()}));
    }
    const auto groups_for = [](std::uint32_t pages) { return std::clamp((pages + 255) / 256, 1u, 4096u); };
    p.groups_of_planes = paging.is_stale && first_list == 0 ? groups_for(paging.capacity) : 0;
    p.groups_of_list = groups_for(most);
    p.size = 64 * (p.groups_of_planes + p.groups_of_list * p.lists);
    local().dispatch(
        cut_pages_kernel,
        {.form = FormName::general, .memories = memories, .parameters = glift::bytes_of(p), .size = {p.size, 1, 1, 1}});
    if (first_list + p.lists < end) cut_pages(paging, cuts, first_list + p.lists);
}

/// After the list of pages has changed: finds the planes, which the host sees later, and makes the sublists anew that
/// were used not long ago.
void RankStream::refresh(Paging& paging, const Cuts& cuts) {
    if (!paging.is_stale) return;
    paging.forget_old_sublists();
    cut_pages(paging, cuts, 0);
    paging.is_stale = false;
}

/// Waits until the host sees where each plane of pages begins.
void RankStream::see_planes(Paging& paging, const Cuts& cuts) {
    refresh(paging, cuts);
    messenger_.finish();
    if (const auto point = local_->point()) point->wait();
}

/// The pages of two parts of the planes, as a list of their own.
std::uint32_t RankStream::sublist(Paging& paging, const Cuts& cuts, Planes lower, Planes upper) {
    for (std::uint32_t k = 0; k < paging.sublists.size(); ++k) {
        Paging::Sublist& list = paging.sublists[k];
        if (list.lower != lower || list.upper != upper) continue;
        list.age = 0;
        return k;
    }
    if (paging.sublists.size() == Paging::most_sublists) paging.forget_sublists();
    Memory memory;
    if (paging.spare.empty()) {
        memory =
            local().allocate({.name = "pages of a rank", .bytes = paging.list.description().bytes, .zeroed = false});
    } else {
        memory = std::move(paging.spare.back());
        paging.spare.pop_back();
    }
    const auto number = static_cast<std::uint32_t>(paging.sublists.size());
    paging.sublists.push_back({lower, upper, std::move(memory)});
    cut_pages(paging, cuts, number);
    return number;
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
        const bool leaves_some = !plan.is_whole || kernel.bindings[k].update != Update::assign;
        coverage->ghost = leaves_some ? std::min(extension, coverage->ghost) : extension;
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
    const Messenger::Started started = messenger_.start(missing, exchanges_);
    ++statistics_.exchanges;
    const std::uint32_t width = (plan.radius + layers - 1) / layers;
    Planes inner = {own.first + width, own.end - std::min(own.end, width)};
    if (!plan.space->paging && inner.count() != 0) {
        // Between workgroups, so that no element is computed twice.
        inner.first = std::max(plan.origin, inner.first);
        inner.first = plan.origin + up_to(inner.first - plan.origin, plan.covered);
        inner.end = std::max(inner.end, plan.origin);
        inner.end = plan.origin + (inner.end - plan.origin) / plan.covered * plan.covered;
    }
    if (options_.overlaps && inner.count() != 0 && plan.scattered.empty()) {
        run_planes(kernel, call, plan, inner);
        messenger_.receive(started);
        run_planes(kernel, call, plan, {all.first, inner.first}, {inner.end, all.end});
    } else {
        messenger_.receive(started);
        run_planes(kernel, call, plan, all);
    }
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
    if (lower.count() + upper.count() == 0) return;
    Paging& paging = *space.paging;
    const std::uint32_t number = sublist(paging, space.cuts, lower, upper);
    std::vector<Memory> memories(call.memories.begin(), call.memories.end());
    std::ranges::replace(memories, paging.list, paging.sublists[number].memory);
    const std::uint32_t at = form_of(kernel, call.form).size_offset + 4;
    std::vector<Patch> patches(call.patches.begin(), call.patches.end());
    std::erase_if(patches, [&](const Patch& patch) { return patch.offset == at; });
    patches.push_back(
        {{paging.counts, 4 * std::uint64_t{number}}, at, paging.most_pages({0, lower.count() + upper.count()})});
    Call part = call;
    part.memories = memories;
    part.size[1] = patches.back().limit;
    part.patches = patches;
    part.fixed = {};
    local().dispatch(kernel, part);
}

}  // namespace glift::detail
