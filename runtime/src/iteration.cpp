#include <glift/iteration.h>

#include <algorithm>
#include <string>

namespace glift {

namespace {

std::string place_of(const Kernel& kernel) {
    return std::string(kernel.file) + ":" + std::to_string(kernel.line) + ": " + kernel.name;
}

[[noreturn]] void throw_sizes(const Kernel& kernel, const detail::Box& a, const detail::Box& b) {
    throw Error(ErrorCode::wrong_argument, "ranges of different sizes", place_of(kernel),
                a.name + (" is " + detail::text_of(a.size, a.rank)) + " and " + b.name + " is " +
                    detail::text_of(b.size, b.rank),
                "pass ranges of one size: all of each structure, or boxes made with range(origin, size)");
}

[[noreturn]] void throw_small(const Kernel& kernel, const detail::Box& visited, const detail::Box& around) {
    throw Error(ErrorCode::wrong_argument, "structures of different sizes", place_of(kernel),
                std::string("the domain of ") + around.name + " is " + detail::text_of(around.domain, around.rank) +
                    ", too small to look around what is visited: " + visited.name + ", " +
                    detail::text_of(visited.size, visited.rank) + " from " +
                    detail::text_of(visited.origin, visited.rank) + " on",
                "pass structures of one size, or boxes of one size made with range(origin, size)");
}

}  // namespace

void Iteration::add_visited(const detail::Box& box, bool is_whole, const std::vector<detail::DeviceCount>& counts) {
    if (!box.is_inside()) detail::throw_outside(place_of(kernel_), box);
    const bool has_count = !counts.empty();
    if (count_ == 0) {
        first_ = box;
        are_counted_ = has_count;
    } else if (box.size != first_.size) {
        // The sizes of ranges with lengths on the device are upper bounds, of which the smallest counts.
        if (!are_counted_ || !has_count) throw_sizes(kernel_, first_, box);
        for (std::size_t axis = 0; axis < box.size.size(); ++axis)
            first_.size[axis] = std::min(first_.size[axis], box.size[axis]);
    }
    are_counted_ = are_counted_ && has_count;
    ++count_;
    whole_ = whole_ && is_whole;
    for (const detail::DeviceCount& count : counts)
        if (std::ranges::find(counts_, count) == counts_.end()) counts_.push_back(count);
}

void Iteration::add_near(detail::Box box, bool is_whole) {
    if (is_whole) {
        box.origin = first_.origin;
        box.size = first_.size;
        if (!box.is_inside()) throw_small(kernel_, first_, box);
    } else if (box.size != first_.size) {
        throw_sizes(kernel_, first_, box);
    }
    if (!box.is_inside()) detail::throw_outside(place_of(kernel_), box);
    whole_ = whole_ && is_whole && box.origin == Extent{} && box.size == box.domain;
}

void Iteration::add_any(const detail::Box& box, bool is_whole) {
    if (!is_whole && !box.is_inside()) detail::throw_outside(place_of(kernel_), box);
    whole_ = whole_ && is_whole;
}

Extent Iteration::size() const { return kernel_.of_blocks ? Extent{visited_.x, visited_.y, 1, 1} : first_.size; }

Memory Iteration::partial_sums(const Commands& commands) const {
    constexpr std::uint64_t most_words = std::uint64_t{1} << 32;
    std::uint64_t words = 0;
    bool meet = false;
    for (const SumOrder& order : kernel_.sums) {
        const SumCount count = count_of(order, size());
        words += count.words();
        meet = meet || (count.parts > 1 && count.parts <= order.most_parts);
    }
    if (meet && words >= most_words)
        throw Error(ErrorCode::too_large, "too many sums", place_of(kernel_),
                    "their parts take " + std::to_string(words) + " words, and one call may have " +
                        std::to_string(most_words - 1),
                    "call the kernel for parts of the structures, made with range(origin, size)");
    return commands.allocate({.name = "partial sums", .bytes = meet ? 4 * words : 4, .zeroed = meet});
}

bool Iteration::can_be_direct(const Commands& commands, std::span<const Memory> memories) const {
    return whole_ && commands.can_be_direct(kernel_, memories, size(), sharing_);
}

void Iteration::dispatch(const Commands& commands, FormName form, std::span<const Memory> memories,
                         std::span<const std::byte> parameters, std::initializer_list<std::size_t> sizes) {
    for (std::size_t offset : sizes) patch(counts_, offset, first_.size, first_.rank);
    commands.dispatch(
        kernel_, {.form = form,
                  .memories = memories,
                  .parameters = parameters,
                  .size = size(),
                  .patches = {patches_.data(), patch_count_},
                  .sharing = sharing_,
                  .visited = {visited_ranges_.data(), visited_count_ > visited_ranges_.size() ? 0 : visited_count_}});
}

void Iteration::same_blocks(const char* first, const char* other,
                            std::initializer_list<std::pair<Memory, Memory>> memories) const {
    for (const auto& [one, two] : memories) {
        if (one == two) continue;
        throw Error(ErrorCode::wrong_argument, "structures with different blocks", place_of(kernel_),
                    std::string(first) + " and " + other +
                        " are visited together, and have lists of their own of what is there",
                    "pass two structures over one list, or write one of them by its address");
    }
}

void Iteration::count_blocks(std::size_t offset) {
    if (!block_count_) return;
    if (patch_count_ == patches_.size()) throw_patches();
    patches_[patch_count_++] = {*block_count_, static_cast<std::uint32_t>(offset + 4), visited_.y, 0, false};
}

void Iteration::throw_patches() const {
    throw Error(ErrorCode::wrong_argument, "too many sizes that live on the device", place_of(kernel_),
                "one call takes " + std::to_string(patches_.size()) + " numbers", "split the kernel");
}

/// Adds a patch for each axis and count.
void Iteration::patch(const std::vector<detail::DeviceCount>& counts, std::size_t offset, const Extent& limits,
                      unsigned axes) {
    if (patch_count_ + axes * counts.size() > patches_.size()) throw_patches();
    for (unsigned axis = 0; axis < axes; ++axis)
        for (const detail::DeviceCount& count : counts)
            patches_[patch_count_++] = {{count.value.memory, count.value.offset + 4 * axis},
                                        static_cast<std::uint32_t>(offset + 4 * axis),
                                        limits[axis],
                                        count.before[axis],
                                        &count != counts.data()};
}

}  // namespace glift
