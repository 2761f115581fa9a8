#include "rank_stream.h"

#include "page_kernels.h"

#include <glift/error.h>

#include <algorithm>
#include <cstring>
#include <numeric>

namespace glift::detail {

namespace {

constexpr unsigned most_passes_unsubmitted = 64;
constexpr std::uint64_t most_gathered_at_once = std::uint64_t{32} << 20;

bool reads(const Binding& binding) { return binding.access != Access::write; }
bool writes(const Binding& binding) { return binding.access != Access::read; }

[[noreturn]] void throw_not_distributed(const char* type_name, const char* why, const char* remedy) {
    throw Error(ErrorCode::wrong_argument, "the structure cannot be distributed", type_name, why, remedy);
}

void check_halo(const char* type_name, std::uint32_t halo) {
    if (halo <= SlabLayout::farthest) return;
    throw Error(ErrorCode::wrong_argument, "a halo is too wide", type_name,
                std::to_string(halo) + " elements; the most is " + std::to_string(SlabLayout::farthest),
                "pass a smaller Distribution::halo");
}

}  // namespace

RankStream::RankStream(DeviceObject& device, std::shared_ptr<ranks::Transport> transport,
                       std::shared_ptr<DeviceObject> local, const ranks::Options& options)
    : device_(device), local_(local), options_(options),
      messenger_(std::move(transport), std::move(local), options.limit.count()) {}

void RankStream::wait() {
    messenger_.finish();
    local().wait();
}

ranks::Statistics RankStream::statistics() {
    messenger_.finish();
    ranks::Statistics result = statistics_;
    result.exchanged_bytes = exchanges_.bytes;
    result.exchange_seconds = exchanges_.seconds;
    result.gathered_bytes = gathers_.bytes;
    result.migrated_bytes = migrations_.bytes;
    return result;
}

void RankStream::dispatch(const Kernel& kernel, const Call& call) {
    if (messenger_.size() == 1) return run_whole(kernel, call);
    messenger_.check();
    const bool is_host = local_->properties().kind == DeviceKind::host;
    if (const auto plan = plan_of(kernel, call, coverages_, layouts_, paged_spaces_, is_host))
        run_distributed(kernel, call, *plan);
    else run_whole(kernel, call);
    // The device begins while the host gives more passes, most of which are short.
    if (++passes_since_flush_ < most_passes_unsubmitted) return;
    local().flush();
    passes_since_flush_ = 0;
}

/// Runs the pass on every rank, after gathering what it reads. What it writes alone gets the same values on every rank,
/// so that its other elements stay as far up to date as they were.
void RankStream::run_whole(const Kernel& kernel, const Call& call) {
    for (std::size_t k = 0; k < call.memories.size() && k < kernel.bindings.size(); ++k)
        if (reads(kernel.bindings[k])) gather(call.memories[k]);
    for (const Patch& patch : call.patches) gather(patch.value);
    for (const Condition& condition : call.conditions) gather(condition.value);
    local().dispatch(kernel, call);
    ++statistics_.whole_passes;
    for (std::size_t k = 0; k < call.memories.size() && k < kernel.bindings.size(); ++k)
        if (writes(kernel.bindings[k])) note_topology_write(call.memories[k]);
}

void RankStream::note_topology_write(const Memory& memory) {
    for (const std::shared_ptr<Space>& space : paged_spaces_) {
        Paging& paging = *space->paging;
        if (memory == paging.list || memory == paging.count.memory || memory == paging.table) paging.is_stale = true;
    }
}

/// Brings all elements of a memory to all ranks, if this is not so yet.
void RankStream::gather(const Memory& memory) {
    Coverage* coverage = memory ? coverages_.find(memory) : nullptr;
    if (!coverage || !coverage->is_partial()) return;
    const Cuts& cuts = coverage->space->cuts;
    if (coverage->space->paging) see_planes(*coverage->space->paging, cuts);
    std::uint32_t most_planes = 0;
    for (unsigned rank = 0; rank < cuts.ranks(); ++rank) most_planes = std::max(most_planes, cuts.of(rank).count());
    const std::uint64_t plane = std::max<std::uint64_t>(1, most_bytes_of_plane(*coverage));
    const auto step = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(most_gathered_at_once / plane, 1, 1u << 20));
    for (std::uint32_t at = 0; at < most_planes; at += step) {
        transfer(gather_pieces(memory, *coverage, {at, at + step}), gathers_);
    }
    ++statistics_.gathers;
    coverage->ghost = Coverage::everywhere;
}

/// Sends and receives pieces. Waits, so that these do not have to be in the hosts' memory at once.
void RankStream::transfer(const std::vector<Piece>& pieces, Traffic& traffic) {
    messenger_.receive(messenger_.start(pieces, traffic));
    messenger_.finish();
}

void RankStream::clear(const Memory& memory) {
    local().clear(memory);
    note_topology_write(memory);
}

void RankStream::fill(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value) {
    local().fill(memory, offset, bytes, value);
    note_topology_write(memory);
}

void RankStream::fill_where(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value,
                            std::span<const Condition> conditions) {
    for (const Condition& condition : conditions) gather(condition.value);
    local().fill_where(memory, offset, bytes, value, conditions);
    note_topology_write(memory);
}

void RankStream::copy(const Memory& from, const Memory& to, std::span<const CopyRegion> regions) {
    gather(from);
    local().copy(from, to, regions);
    note_topology_write(to);
}

void RankStream::copy_to_image(const Memory& buffer, const Memory& image, std::span<const ImageRegion> regions) {
    gather(buffer);
    local().copy_to_image(buffer, image, regions);
}

void RankStream::copy_from_image(const Memory& image, const Memory& buffer, std::span<const ImageRegion> regions) {
    local().copy_from_image(image, buffer, regions);
    note_topology_write(buffer);
}

void RankStream::copy_images(const Memory& from, const Memory& to, std::span<const ImageCopyRegion> regions) {
    local().copy_images(from, to, regions);
}

void RankStream::upload(const Memory& to, std::span<const CopyRegion> regions, std::span<const std::byte> bytes) {
    local().upload(to, regions, bytes);
    note_topology_write(to);
}

void RankStream::upload_image(const Memory& image, std::span<const ImageRegion> regions,
                              std::span<const std::byte> bytes) {
    local().upload_image(image, regions, bytes);
}

std::shared_ptr<DownloadObject> RankStream::download(const Memory& from, std::span<const CopyRegion> regions,
                                                     std::uint64_t bytes) {
    gather(from);
    messenger_.finish();
    return local().download(from, regions, bytes);
}

std::shared_ptr<DownloadObject> RankStream::download_image(const Memory& image, std::span<const ImageRegion> regions,
                                                           std::uint64_t bytes) {
    messenger_.finish();
    return local().download_image(image, regions, bytes);
}

void RankStream::distribute(const char* type_name, const RangeShape& shape, std::span<const Memory> memories,
                            const ranks::Distribution& how) {
    check_halo(type_name, how.halo);
    for (const Memory& memory : memories) {
        RangeShape one = shape;
        if (const std::uint64_t elements = volume_of(shape.domain); memory && elements != 0)
            one.element_bytes = static_cast<std::uint32_t>(memory.description().bytes / elements);
        const std::optional<SlabLayout> layout = memory ? layouts_.of(one) : std::nullopt;
        if (!layout)
            throw_not_distributed(
                type_name, "its elements do not lie in buffers, plane by plane of the last axis",
                "distribute std.array's Array in buffers, with 2 planes or more, or std.sparse's Sparse");
        std::shared_ptr<Space>& space = dense_spaces_[layout->planes];
        if (!space) space = std::make_shared<Space>(Space{Cuts(layout->planes, messenger_.size()), nullptr});
        space->halo = std::max(space->halo, how.halo);
        Coverage coverage;
        coverage.space = space;
        coverage.layout = coverage.ghost_layout = *layout;
        gather(memory);
        coverages_.set(memory, std::move(coverage));
    }
}

void RankStream::distribute(const PagedShape& shape, const ranks::Distribution& how) {
    check_halo(shape.type_name, how.halo);
    const unsigned last = shape.rank - 1;
    std::uint32_t pages_of_plane = 1, elements = shape.page[last];
    for (unsigned axis = 0; axis < last; ++axis) {
        pages_of_plane *= (shape.extent[axis] + shape.page[axis] - 1) / shape.page[axis];
        elements *= shape.page[axis];
    }
    const std::uint32_t planes = (shape.extent[last] + shape.page[last] - 1) / shape.page[last];
    for (const Memory& frames : shape.frames) {
        const MemoryDescription& d = frames.description();
        const std::uint64_t element = shape.capacity ? d.bytes / shape.capacity / elements : 0;
        if (d.kind != MemoryKind::buffer || element * elements / shape.page[last] % 4 != 0 || element == 0)
            throw_not_distributed(shape.type_name,
                                  "its frames are not in a buffer, or a layer of a page is not of whole words",
                                  "distribute std.sparse's Sparse with elements of 4 bytes or more");
    }
    auto space = std::make_shared<Space>(Space{Cuts(planes, messenger_.size()), std::make_unique<Paging>(), how.halo});
    Paging& paging = *space->paging;
    paging.list = shape.list;
    paging.count = shape.count;
    paging.table = shape.table;
    paging.pages_of_plane = pages_of_plane;
    paging.layers = shape.page[last];
    paging.capacity = shape.capacity;
    const std::uint64_t planes_bytes = 4 * (std::uint64_t{planes} + 1);
    paging.planes = local().allocate({.name = "planes of pages", .bytes = planes_bytes, .zeroed = false});
    paging.seen = local_->allocate_visible({.name = "planes of pages", .bytes = planes_bytes, .zeroed = false});
    paging.counts = local().allocate({.name = "pages of a rank", .bytes = 4 * Paging::most_sublists, .zeroed = false});
    for (std::uint32_t k = 0; k < CutPages::most_lists; ++k)
        paging.unused.push_back(local().allocate({.name = "no pages", .bytes = 4, .zeroed = false}));
    messenger_.finish();  // what is under way may refer to the space that this one replaces
    for (const Memory& frames : shape.frames) {
        Coverage coverage;
        coverage.space = space;
        coverage.frame_bytes = frames.description().bytes / shape.capacity / elements * elements;
        coverage.layer_bytes = coverage.frame_bytes / shape.page[last];
        gather(frames);
        coverages_.set(frames, std::move(coverage));
    }
    std::erase_if(paged_spaces_, [&](const auto& other) { return other->paging->list == shape.list; });
    paged_spaces_.push_back(std::move(space));
}

/// The space of a distributed structure, of whose pages the places are known.
Space& RankStream::space_of(const PagedShape& shape) {
    const auto at = std::ranges::find_if(paged_spaces_, [&](const auto& s) { return s->paging->list == shape.list; });
    if (at == paged_spaces_.end())
        throw Error(ErrorCode::wrong_argument, "the structure is not distributed", shape.type_name, {},
                    "call World::distribute first");
    see_planes(*(*at)->paging, (*at)->cuts);
    return **at;
}

double RankStream::imbalance(const PagedShape& shape) {
    const Space& space = space_of(shape);
    std::uint32_t most = 0;
    for (unsigned rank = 0; rank < messenger_.size(); ++rank)
        most = std::max(most, space.paging->pages(space.cuts.of(rank)).count());
    const std::uint32_t all = space.paging->pages({0, space.cuts.planes()}).count();
    return all == 0 ? 1 : static_cast<double>(most) * messenger_.size() / all;
}

double RankStream::balance(const PagedShape& shape) {
    Space& space = space_of(shape);
    std::vector<std::uint64_t> before;
    for (std::uint32_t plane = 0; plane <= space.cuts.planes(); ++plane)
        before.push_back(space.paging->pages({0, plane}).end);
    const Cuts next(before, messenger_.size());
    if (before.back() == 0 || next == space.cuts) return imbalance(shape);
    for (const auto& [memory, coverage] : coverages_.of(space)) {
        if (!coverage->is_partial()) continue;
        transfer(migration_pieces(memory, *coverage, next), migrations_);
        coverage->ghost = 0;
    }
    space.cuts = next;
    space.paging->forget_sublists();
    return imbalance(shape);
}

std::vector<std::byte> RankStream::bytes_of(const Memory& memory) {
    messenger_.finish();
    const std::uint64_t bytes = memory.description().bytes;
    const CopyRegion region = {0, 0, bytes};
    const auto download = local().download(memory, {&region, 1}, bytes);
    const std::span<const std::byte> span = download->get();
    return {span.begin(), span.end()};
}

Memory RankStream::copy_of(const Memory& memory) {
    const std::uint64_t bytes = memory.description().bytes;
    Memory copy = local().allocate({.name = "before a pass", .bytes = bytes, .zeroed = false});
    const CopyRegion region = {0, 0, bytes};
    local().copy(memory, copy, {&region, 1});
    return copy;
}

}  // namespace glift::detail
