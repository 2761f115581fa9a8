#include "vulkan_stream.h"

#include "vulkan_device.h"

#include <algorithm>

namespace glift::detail {

namespace {

// Large uploads to buffers are split, so that staging stays small.
constexpr std::uint64_t part_bytes = std::uint64_t(32) << 20;

}  // namespace

VulkanStream::VulkanStream(VulkanDevice& device) : device_(device), encoder_(device) {}

bool VulkanStream::is_marked() const { return device_.context().has_labels || device_.profiler().is_on(); }

void VulkanStream::begin_marked(const Work& work, std::optional<TimedWork>& times) {
    encoder_.labels().begin(encoder_.commands(), work.name);
    if (!device_.profiler().is_on()) return;
    const Query begin = take_query();
    if (!begin.pool) return;
    times = TimedWork{device_.profiler().tag(work), begin, take_query()};
    encoder_.timestamp(begin.pool, begin.index);
}

void VulkanStream::end_marked(std::optional<TimedWork>& times) {
    encoder_.labels().end(encoder_.commands());
    if (!times) return;
    encoder_.timestamp(times->end.pool, times->end.index);
    note_times(std::move(*times));
}

bool VulkanStream::can_be_direct(const Kernel& kernel, std::span<const Memory> memories,
                                 const std::array<std::uint32_t, 4>& size, Sharing sharing) {
    return encoder_.can_be_direct(kernel, memories, size, sharing);
}

void VulkanStream::dispatch(const Kernel& kernel, const Call& call) {
    const std::lock_guard lock(device_.mutex());
    open();
    marked([&] { return work_of(kernel, call); }, [&] { encoder_.dispatch(kernel, call); });
    for (const Memory& memory : call.memories) hold(memory);
    for (const Patch& patch : call.patches) hold(patch.value.memory);
    for (const Condition& condition : call.conditions) hold(condition.value.memory);
    if (call.targets) {
        for (const Attachment& target : call.targets->colours) hold(target.memory);
        if (call.targets->depth.memory) hold(call.targets->depth.memory);
    }
    count_pass();
    recorded();
}

void VulkanStream::count_pass() { ++device_.counters().passes; }

void VulkanStream::fill(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value) {
    const std::lock_guard lock(device_.mutex());
    open();
    marked([&] { return Work{.name = "fill", .bytes = bytes}; },
           [&] { encoder_.fill(vulkan_memory(memory), offset, bytes, value); });
    hold(memory);
    recorded();
}

void VulkanStream::fill_where(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value,
                              std::span<const Condition> conditions) {
    const std::lock_guard lock(device_.mutex());
    open();
    marked([&] { return Work{.name = "fill", .bytes = bytes}; },
           [&] { encoder_.fill_where(vulkan_memory(memory), offset, bytes, value, conditions); });
    hold(memory);
    for (const Condition& condition : conditions) hold(condition.value.memory);
    recorded();
}

void VulkanStream::clear(const Memory& memory) {
    const std::lock_guard lock(device_.mutex());
    open();
    marked([&] { return Work{.name = "clear", .bytes = memory.description().bytes}; },
           [&] { encoder_.clear(vulkan_memory(memory)); });
    hold(memory);
    recorded();
}

void VulkanStream::copy(const Memory& from, const Memory& to, std::span<const CopyRegion> regions) {
    const std::lock_guard lock(device_.mutex());
    open();
    marked([&] { return work_of("copy", regions); },
           [&] { encoder_.copy(vulkan_memory(from), vulkan_memory(to), regions); });
    hold(from);
    hold(to);
    recorded();
}

void VulkanStream::copy_to_image(const Memory& buffer, const Memory& image, std::span<const ImageRegion> regions) {
    const std::lock_guard lock(device_.mutex());
    open();
    marked([&] { return work_of("copy", image, regions); },
           [&] { encoder_.copy_to_image(vulkan_memory(buffer), vulkan_memory(image), regions); });
    hold(buffer);
    hold(image);
    recorded();
}

void VulkanStream::copy_from_image(const Memory& image, const Memory& buffer, std::span<const ImageRegion> regions) {
    const std::lock_guard lock(device_.mutex());
    open();
    marked([&] { return work_of("copy", image, regions); },
           [&] { encoder_.copy_from_image(vulkan_memory(image), vulkan_memory(buffer), regions); });
    hold(image);
    hold(buffer);
    recorded();
}

void VulkanStream::copy_images(const Memory& from, const Memory& to, std::span<const ImageCopyRegion> regions) {
    const std::lock_guard lock(device_.mutex());
    open();
    marked([&] { return work_of("copy", from, regions); },
           [&] { encoder_.copy_images(vulkan_memory(from), vulkan_memory(to), regions); });
    hold(from);
    hold(to);
    recorded();
}

void VulkanStream::upload(const Memory& to, std::span<const CopyRegion> regions, std::span<const std::byte> bytes) {
    const std::lock_guard lock(device_.mutex());
    std::vector<CopyRegion> part;
    std::uint64_t filled = 0;
    const auto send = [&] {
        open();
        marked([&] { return work_of("upload", part); },
               [&] { encoder_.upload(vulkan_memory(to), part, bytes.data()); });
        recorded();
        staged(filled);
        part.clear();
        filled = 0;
    };
    for (CopyRegion region : regions) {
        while (region.bytes) {
            const std::uint64_t taken = std::min(region.bytes, part_bytes - filled);
            part.push_back({region.from, region.to, taken});
            region = {region.from + taken, region.to + taken, region.bytes - taken};
            filled += taken;
            if (filled == part_bytes) send();
        }
    }
    if (filled) send();
    hold(to);
}

void VulkanStream::upload_filled(const Memory& to, std::uint64_t bytes, const Fill& fill) {
    if (bytes > part_bytes) return Stream::upload_filled(to, bytes, fill);
    const std::lock_guard lock(device_.mutex());
    open();
    marked([&] { return Work{.name = "upload", .bytes = bytes}; },
           [&] { encoder_.upload_filled(vulkan_memory(to), bytes, fill); });
    hold(to);
    recorded();
    staged(bytes);
}

void VulkanStream::upload_image(const Memory& image, std::span<const ImageRegion> regions,
                                std::span<const std::byte> bytes) {
    const std::lock_guard lock(device_.mutex());
    open();
    marked([&] { return work_of("upload", image, regions); },
           [&] { encoder_.upload_image(vulkan_memory(image), regions, bytes.data()); });
    hold(image);
    recorded();
    staged(bytes.size());
}

}  // namespace glift::detail
