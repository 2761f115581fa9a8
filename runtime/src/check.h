// Checks of arguments, the same for every device. They throw wrong_argument; check_call also throws aliased_memory and
// too_large.
#pragma once

#include <glift/commands.h>

namespace glift::detail {

void check_condition(const DeviceObject* device, const Condition& condition);
void check_call(const DeviceObject* device, const Kernel& kernel, const Call& call);
void check_memories(const DeviceObject* device, const Kernel& kernel, std::span<const Memory> memories);
/// Checks the description; returns it with the bytes of an image filled in.
MemoryDescription whole_description(const MemoryDescription& description);
/// Checks that the memory can be used in place of one allocated by the description.
void check_part(const DeviceObject* device, const Memory& memory, const MemoryDescription& wanted);
void check_range(const DeviceObject* device, const Memory& buffer, std::uint64_t offset, std::uint64_t bytes,
                 const char* call);
void check_image_regions(const DeviceObject* device, const Memory& image, std::span<const ImageRegion> regions,
                         std::uint64_t bytes, const char* call);
void check_image_copies(const DeviceObject* device, const Memory& from, const Memory& to,
                        std::span<const ImageCopyRegion> regions);
void check_host_regions(std::span<const CopyRegion> regions, std::uint64_t bytes, bool host_is_source,
                        const char* call);

}  // namespace glift::detail
