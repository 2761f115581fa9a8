#include "check.h"

#include "check_draw.h"
#include "image_layout.h"
#include "objects.h"
#include "report.h"
#include "text.h"

#include <glift/error.h>

namespace glift::detail {

namespace {

[[noreturn]] void wrong(std::string problem, std::string where, std::string why = {}, std::string remedy = {}) {
    throw Error(ErrorCode::wrong_argument, std::move(problem), std::move(where), std::move(why), std::move(remedy));
}

void check_owner(const DeviceObject* device, const Memory& memory, const char* call) {
    if (!memory) {
        wrong("an empty memory handle was passed", call,
              "it, or the structure that it is of, was default-constructed or moved from",
              "pass what Device::allocate returned, or a structure that was made with a device");
    }
    if (!device->reaches(*memory.object())) {
        wrong("a memory of another device was passed", std::string(call) + ", " + memory_text(memory.description()), {},
              "allocate it on the device that runs the call, or copy it there through the host");
    }
    if (memory.object()->is_replaced()) throw_given_up(*memory.object(), call);
}

// A function of its own, not a part of check_memories, so that the code that runs at each dispatch stays small.
[[noreturn]] void wrong_memory(const DeviceObject* device, const Kernel& kernel, const Binding& binding,
                               const Memory& memory) {
    const std::string where = kernel_text(kernel) + ", binding " + binding.name;
    check_owner(device, memory, where.c_str());
    wrong("a memory of the wrong kind was passed", where,
          std::string("the kernel takes ") + kind_text(binding.kind) + ", given " + memory_text(memory.description()));
}

[[noreturn]] void aliased(const Kernel& kernel, const Call& call, std::size_t first, std::size_t second) {
    throw Error(ErrorCode::aliased_memory, "one memory was passed twice in one call, and is written",
                kernel_text(kernel) + ", " + memory_text(call.memories[first].description()),
                std::string("it is bound as ") + kernel.bindings[first].name + " and as " +
                    kernel.bindings[second].name + ", and invocations run in no order",
                "write into another structure, then copy or swap");
}

/// Refuses a buffer whose elements the kernel's physical addresses cannot count.
void check_elements(const Kernel& kernel, const Binding& binding, const MemoryDescription& memory) {
    if (kernel.address_bits == 64 || memory.kind != MemoryKind::buffer) return;
    if (memory.bytes / binding.element_bytes < std::uint64_t{1} << 32) return;
    throw Error(ErrorCode::too_large, "a memory has 2^32 elements or more",
                kernel_text(kernel) + ", " + memory_text(memory),
                "the kernel was compiled with physical addresses of 32 bits",
                "compile the module with gliftc --address-bits=64, in CMake glift_compile(… ADDRESS_BITS 64)");
}

void check_patches(const DeviceObject* device, const Kernel& kernel, const Call& call) {
    if (call.form == FormName::direct && !kernel.of_blocks)
        wrong("device values were passed to the direct form", kernel_text(kernel));
    for (const Patch& patch : call.patches) {
        check_range(device, patch.value.memory, patch.value.offset, 4, "a device value");
        const std::size_t bytes = call.parameters.size();
        if (patch.offset % 4 || patch.value.offset % 4 || bytes < 4 || patch.offset > bytes - 4) {
            wrong("a device value's offset is not a multiple of 4 or is outside the parameters", kernel_text(kernel),
                  "offset " + std::to_string(patch.offset) + " of " + std::to_string(bytes) + " bytes, value at " +
                      std::to_string(patch.value.offset),
                  "take both offsets from the layout of the parameters and of the memory");
        }
    }
}

void check_description(const MemoryDescription& d) {
    const bool buffer = d.kind == MemoryKind::buffer;
    if (buffer != (d.format == Format::none)) {
        wrong(buffer ? "a buffer has no texel format" : "an image needs a texel format", memory_text(d));
    }
    if (buffer) return;
    const auto e = d.extent;
    const bool has_layers = d.kind == MemoryKind::image2darray;
    const std::uint32_t largest = std::max(e[0], std::max(e[1], has_layers ? 1 : e[2]));
    if (e[0] == 0 || e[1] == 0 || e[2] == 0) wrong("an image has no texels", memory_text(d));
    if (d.mips == 0 || d.mips > 32 || (d.mips > 1 && (largest >> (d.mips - 1)) == 0)) {
        wrong("an image has more levels than its extent can halve, or none", memory_text(d));
    }
    const bool flat = d.kind != MemoryKind::image3d && !has_layers;
    if ((flat && e[2] != 1) || (d.kind == MemoryKind::image1d && e[1] != 1) ||
        (d.kind == MemoryKind::imagecube && e[0] != e[1])) {
        wrong("the extent does not fit the kind of image", memory_text(d));
    }
}

}  // namespace

namespace {

/// Whether a memory may be bound where a kernel takes this kind. A cube may also be bound as an array of layers: its
/// faces.
bool is_bound_as(const MemoryDescription& d, MemoryKind kind) {
    return d.kind == kind || (d.kind == MemoryKind::imagecube && kind == MemoryKind::image2darray);
}

}  // namespace

void check_memories(const DeviceObject* device, const Kernel& kernel, std::span<const Memory> memories) {
    if (memories.size() != kernel.bindings.size()) {
        wrong("the number of memories does not fit the kernel", kernel_text(kernel),
              "it takes " + std::to_string(kernel.bindings.size()) + ", given " + std::to_string(memories.size()));
    }
    for (std::size_t k = 0; k < memories.size(); ++k) {
        const MemoryObject* object = memories[k].object();
        if (!object || object->device().get() != device ||
            !is_bound_as(object->description(), kernel.bindings[k].kind) || object->is_replaced()) {
            wrong_memory(device, kernel, kernel.bindings[k], memories[k]);
        }
    }
}

void check_condition(const DeviceObject* device, const Condition& condition) {
    check_range(device, condition.value.memory, condition.value.offset, 4, "a condition on the device");
    if (condition.value.offset % 4)
        wrong("a condition's offset is not a multiple of 4", "a condition on the device",
              std::to_string(condition.value.offset));
}

void check_call(const DeviceObject* device, const Kernel& kernel, const Call& call) {
    check_memories(device, kernel, call.memories);
    const DeviceProperties& properties = device->properties();
    if (kernel.shared_bytes > properties.shared_memory_bytes) {
        throw Error(ErrorCode::too_large,
                    "the kernel's workgroup memory, " + std::to_string(kernel.shared_bytes) +
                        " bytes, is larger than the device allows",
                    kernel_text(kernel),
                    properties.name + " has " + std::to_string(properties.shared_memory_bytes) + " bytes a workgroup",
                    "declare less shared memory; a pipeline can ask device.shared_memory_bytes and run another kernel");
    }
    const Form& form = form_of(kernel, call.form);
    if (call.parameters.size() != form.parameter_bytes) {
        wrong("the size of the parameters does not fit the kernel", kernel_text(kernel),
              "it takes " + std::to_string(form.parameter_bytes) + " bytes, given " +
                  std::to_string(call.parameters.size()));
    }
    for (std::size_t k = 0; k < call.memories.size(); ++k) {
        const MemoryObject* object = call.memories[k].object();
        const Binding& binding = kernel.bindings[k];
        check_elements(kernel, binding, object->description());
        for (std::size_t j = 0; j < k; ++j) {
            if (call.sharing != Sharing::unknown || !shares_texels(call.memories[j].object(), object)) continue;
            const Access other = kernel.bindings[j].access;
            if (other != binding.access || binding.access == Access::write) aliased(kernel, call, j, k);
        }
    }
    if (call.sharing == Sharing::one_place && call.form == FormName::direct)
        wrong("aliased elements were passed to the direct form (Sharing::one_place)", kernel_text(kernel));
    if (!call.patches.empty()) check_patches(device, kernel, call);
    for (const Condition& condition : call.conditions) check_condition(device, condition);
    check_draw(device, kernel, call);
}

MemoryDescription whole_description(const MemoryDescription& description) {
    MemoryDescription whole = description;
    if (!whole.name) whole.name = "";
    check_description(whole);
    if (whole.kind != MemoryKind::buffer) whole.bytes = image_bytes(whole);
    return whole;
}

void check_part(const DeviceObject* device, const Memory& memory, const MemoryDescription& wanted) {
    check_owner(device, memory, wanted.name);
    const MemoryDescription& given = memory.description();
    const bool image = wanted.kind != MemoryKind::buffer;
    const bool fits =
        given.kind == wanted.kind && given.format == wanted.format &&
        (image ? given.extent == wanted.extent && given.mips >= wanted.mips : given.bytes >= wanted.bytes);
    if (fits) return;
    wrong("a memory does not fit the structure that it is to be a part of", wanted.name,
          "needed: " + shape_text(wanted) + "; given: " + memory_text(given),
          image ? "allocate an image of that kind, format and extent"
                : "allocate a buffer of that many bytes, or more");
}

void check_range(const DeviceObject* device, const Memory& buffer, std::uint64_t offset, std::uint64_t bytes,
                 const char* call) {
    check_owner(device, buffer, call);
    const MemoryDescription& d = buffer.description();
    if (d.kind != MemoryKind::buffer) wrong("an image was passed where a buffer is needed", call, memory_text(d));
    if (offset > d.bytes || bytes > d.bytes - offset) {
        wrong("a range lies outside its memory", std::string(call) + ", " + memory_text(d),
              std::to_string(bytes) + " bytes from byte " + std::to_string(offset) + " on",
              "pass a range inside the memory");
    }
}

namespace {

void check_box(const MemoryDescription& d, std::array<std::uint32_t, 3> origin, std::array<std::uint32_t, 3> extent,
               std::uint32_t mip, std::uint32_t face, const char* call) {
    bool inside = mip < d.mips && face < face_count(d);
    const auto limit = mip_extent(d, inside ? mip : 0);
    for (int axis = 0; axis < 3; ++axis) {
        inside = inside && origin[axis] <= limit[axis] && extent[axis] <= limit[axis] - origin[axis];
    }
    if (!inside) wrong("a box of texels lies outside its image", std::string(call) + ", " + memory_text(d));
}

}  // namespace

void check_image_regions(const DeviceObject* device, const Memory& image, std::span<const ImageRegion> regions,
                         std::uint64_t bytes, const char* call) {
    check_owner(device, image, call);
    const MemoryDescription& d = image.description();
    if (d.kind == MemoryKind::buffer) wrong("a buffer was passed where an image is needed", call, memory_text(d));
    for (const ImageRegion& region : regions) {
        check_box(d, region.origin, region.extent, region.mip, region.face, call);
        const std::uint64_t needed =
            std::uint64_t(region.extent[0]) * region.extent[1] * region.extent[2] * texel_bytes(d.format);
        if (region.offset > bytes || needed > bytes - region.offset) {
            wrong("a box of texels needs bytes beyond the buffer", std::string(call) + ", " + memory_text(d),
                  size_text(needed) + " at " + std::to_string(region.offset) + ", of " + size_text(bytes));
        }
        if (region.offset % texel_bytes(d.format) || region.offset % 4) {
            wrong("the offset of a box of texels is not a multiple of 4 and of the texel", call);
        }
    }
}

void check_image_copies(const DeviceObject* device, const Memory& from, const Memory& to,
                        std::span<const ImageCopyRegion> regions) {
    constexpr const char* call = "Commands::copy_images";
    check_owner(device, from, call);
    check_owner(device, to, call);
    const MemoryDescription& source = from.description();
    const MemoryDescription& target = to.description();
    if (source.format != target.format || source.format == Format::none) {
        wrong("images of different formats cannot be copied", call, memory_text(source) + " to " + memory_text(target));
    }
    if (shares_texels(from.object(), to.object()))
        wrong("an image cannot be copied to itself, or to a part of itself", call, memory_text(source));
    for (const ImageCopyRegion& region : regions) {
        check_box(source, region.from, region.extent, region.from_mip, region.from_face, call);
        check_box(target, region.to, region.extent, region.to_mip, region.to_face, call);
    }
}

void check_host_regions(std::span<const CopyRegion> regions, std::uint64_t bytes, bool host_is_source,
                        const char* call) {
    for (const CopyRegion& region : regions) {
        const std::uint64_t offset = host_is_source ? region.from : region.to;
        if (offset > bytes || region.bytes > bytes - offset) wrong("a range lies outside the host's bytes", call);
    }
}

}  // namespace glift::detail
