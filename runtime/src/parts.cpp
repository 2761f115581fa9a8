// Levels and layers of images, as images over the same texels.
#include "image_layout.h"
#include "objects.h"
#include "text.h"

#include <glift/error.h>

namespace glift {

namespace detail {

namespace {

Texels all_of(const MemoryObject& image) {
    if (image.whole()) return image.texels();
    return {0, image.description().mips, 0, face_count(image.description())};
}

[[noreturn]] void throw_no_part(const char* call, const MemoryDescription& image, std::uint32_t number,
                                std::uint32_t count) {
    throw Error(ErrorCode::wrong_argument, "an image has no such part", std::string(call) + ", " + memory_text(image),
                "number " + std::to_string(number) + " of " + std::to_string(count), "they are counted from 0");
}

/// The part's handle also holds the handle that it was made from: the storage of a temporary is reused once its last
/// handle is gone (workspace.h).
Memory part_of(const Memory& memory, MemoryDescription description, Texels texels) {
    const std::shared_ptr<MemoryObject> own = memory.object()->shared_from_this();
    MemoryObject& whole = own->whole() ? *own->whole() : *own;
    description.bytes = image_bytes(description);
    std::shared_ptr<MemoryObject> part = whole.part(description, texels);
    MemoryObject* const same = part.get();
    const auto release = [part = std::move(part), held = memory.share()](MemoryObject*) {};
    return Memory(std::shared_ptr<MemoryObject>(same, release));
}

}  // namespace

MemoryObject::MemoryObject(std::shared_ptr<MemoryObject> whole, const MemoryDescription& description,
                           const Texels& texels)
    : MemoryObject(whole->device(), description) {
    whole_ = std::move(whole);
    texels_ = texels;
}

bool shares_texels(const MemoryObject* one, const MemoryObject* other) {
    if (one == other) return true;
    if (!one || !other || (!one->whole() && !other->whole())) return false;
    const auto image = [](const MemoryObject* memory) { return memory->whole() ? memory->whole().get() : memory; };
    if (image(one) != image(other)) return false;
    const Texels a = all_of(*one), b = all_of(*other);
    const auto meet = [](std::uint32_t first, std::uint32_t count, std::uint32_t second, std::uint32_t second_count) {
        return first < second + second_count && second < first + count;
    };
    return meet(a.mip, a.mips, b.mip, b.mips) && meet(a.layer, a.layers, b.layer, b.layers);
}

}  // namespace detail

Memory Memory::mip(std::uint32_t level) const {
    detail::MemoryObject& object = object_.in("Memory::mip");
    MemoryDescription d = object.description();
    if (d.kind == MemoryKind::buffer || level >= d.mips) detail::throw_no_part("Memory::mip", d, level, d.mips);
    detail::Texels texels = detail::all_of(object);
    texels.mip += level;
    texels.mips = 1;
    const auto extent = detail::mip_extent(d, level);
    d.extent = {extent[0], extent[1], d.kind == MemoryKind::image2darray ? d.extent[2] : extent[2]};
    d.mips = 1;
    return detail::part_of(*this, d, texels);
}

Memory Memory::layer(std::uint32_t layer) const {
    detail::MemoryObject& object = object_.in("Memory::layer");
    MemoryDescription d = object.description();
    const bool has_layers = d.kind == MemoryKind::image2darray || d.kind == MemoryKind::imagecube;
    const std::uint32_t count = has_layers ? detail::face_count(d) : 0;
    if (layer >= count) detail::throw_no_part("Memory::layer", d, layer, count);
    detail::Texels texels = detail::all_of(object);
    texels.layer += layer;
    texels.layers = 1;
    texels.mips = 1;
    d.kind = MemoryKind::image2d;
    d.extent[2] = 1;
    d.mips = 1;
    return detail::part_of(*this, d, texels);
}

}  // namespace glift
