#include "work.h"

#include "../image_layout.h"

#include <algorithm>

namespace glift::detail {

namespace {

std::uint64_t texels_of(const std::array<std::uint32_t, 3>& extent) {
    return std::uint64_t{extent[0]} * extent[1] * extent[2];
}

/// The number of elements that the call visits; 0 where it lies on the device.
std::uint64_t visited_elements(const Kernel& kernel, const Call& call) {
    const std::uint32_t first = form_of(kernel, call.form).size_offset;
    const bool is_on_device = std::ranges::any_of(call.patches, [&](const Patch& patch) {
        return patch.offset >= first && patch.offset < first + 4 * kernel.rank;
    });
    if (is_on_device || kernel.drawing) return 0;
    std::uint64_t elements = 1;
    for (const std::uint32_t axis : call.size) elements *= axis;
    return elements;
}

std::uint64_t element_bytes(const Binding& binding, const Memory& memory) {
    if (binding.kind != MemoryKind::buffer) return texel_bytes(memory.description().format);
    return binding.field_bytes != 0 ? binding.field_bytes : binding.element_bytes;
}

}  // namespace

Work work_of(const Kernel& kernel, const Call& call) {
    Work work{kernel.name, kernel.file, kernel.line};
    const std::uint64_t elements = visited_elements(kernel, call);
    for (std::size_t k = 0; k < kernel.bindings.size() && k < call.memories.size(); ++k) {
        const Binding& binding = kernel.bindings[k];
        const bool is_visited = binding.reach == Reach::element || binding.reach == Reach::window;
        if (!is_visited || elements == 0) {
            work.has_uncounted_bytes = true;
            continue;
        }
        const std::uint64_t times = binding.access == Access::read_write ? 2 : 1;
        work.bytes += times * elements * element_bytes(binding, call.memories[k]);
    }
    return work;
}

Work work_of(const char* kind, std::span<const CopyRegion> regions) {
    Work work{kind};
    for (const CopyRegion& region : regions) work.bytes += region.bytes;
    return work;
}

Work work_of(const char* kind, const Memory& image, std::span<const ImageRegion> regions) {
    Work work{kind};
    for (const ImageRegion& region : regions)
        work.bytes += texels_of(region.extent) * texel_bytes(image.description().format);
    return work;
}

Work work_of(const char* kind, const Memory& image, std::span<const ImageCopyRegion> regions) {
    Work work{kind};
    for (const ImageCopyRegion& region : regions)
        work.bytes += texels_of(region.extent) * texel_bytes(image.description().format);
    return work;
}

}  // namespace glift::detail
