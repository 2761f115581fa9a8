// Physical memory: a buffer or an image on a device, shared by whoever holds the handle.
#pragma once

#include <glift/handle.h>
#include <glift/host/memory.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace glift {

/// Bytes of one texel; 0 for Format::none.
GLIFT_API std::uint32_t texel_bytes(Format format);

struct MemoryDescription {
    const char* name = "";  ///< shown by debuggers and in errors, `f.data`; copied
    MemoryKind kind = MemoryKind::buffer;
    Format format = Format::none;
    std::uint64_t bytes = 0;  ///< buffers: size; images: ignored, and derived from the fields below and the format
    /// Images: texels (cubes: of a face; image2darray: of a layer, and the number of layers); buffers: unused.
    std::array<std::uint32_t, 3> extent = {1, 1, 1};
    std::uint32_t mips = 1;
    bool zeroed = true;  ///< false: contents start undefined, for memory that is written before it is read
};

namespace detail {
class MemoryObject;
}

/// A handle to one memory. Copies share it; the storage is freed when the last handle is gone and the device no longer
/// uses it. Contents start as zeros, unless MemoryDescription::zeroed is false. An image of the user's (adopt_image in
/// vulkan.h) is neither zeroed nor freed. A buffer may have no bytes; shaders may read it up to the next multiple of
/// sixteen, and at least sixteen bytes.
class GLIFT_API Memory {
public:
    Memory() = default;  ///< an empty handle
    explicit Memory(std::shared_ptr<detail::MemoryObject> object) : object_(std::move(object)) {}

    const MemoryDescription& description() const;  ///< images: bytes is filled in, all mips, faces and layers
    std::array<std::uint32_t, 3> extent() const { return description().extent; }

    /// One level of an image, as an image of its own over the same texels: a pass may use it beside other levels as if
    /// they were different memories. Throws wrong_argument where there is no such level.
    Memory mip(std::uint32_t level) const;
    /// One layer of an image2darray or one face of a cube, of level 0, as an image2d over the same texels. Throws
    /// wrong_argument where there is no such layer or face.
    Memory layer(std::uint32_t layer) const;

    explicit operator bool() const { return bool(object_); }
    bool operator==(const Memory&) const = default;

    detail::MemoryObject* object() const { return object_.share().get(); }
    const std::shared_ptr<detail::MemoryObject>& share() const { return object_.share(); }

private:
    detail::Held<detail::MemoryObject> object_;
};

}  // namespace glift
