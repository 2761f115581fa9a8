// Kernels that draw: a vertex shader, the rasteriser and a fragment shader.
//
// A draw runs over two axes: vertices and instances. Consecutive vertices form a primitive: three form a triangle, two
// a line, one a point. Form::spirv is the vertex shader, Form::fragment the fragment shader; both have the same
// bindings and parameters. Output i of the fragment shader is colour target i. Each call gives the targets and the
// viewport.
#pragma once

#include <glift/memory.h>
#include <glift/vector.h>

#include <cstdint>
#include <span>

namespace glift {

/// Which triangles are culled. Front faces are counter-clockwise as seen in the window, whose y grows downwards.
enum class Cull : std::uint8_t { none, back, front };

enum class Topology : std::uint8_t { triangles, lines, points };

/// A fragment passes where `its depth <test> stored depth`.
enum class DepthTest : std::uint8_t { less, less_equal, greater, equal, always };

/// How a fragment's colour is blended with the stored one. `over` is source + (1 - source alpha) * stored, for colours
/// that are premultiplied by alpha; `multiply` is source * stored.
enum class Blend : std::uint8_t { replace, over, add, min, max, multiply };

struct ColourTarget {
    const char* name;  ///< as in the source
    Format format;
    Blend blend = Blend::replace;
};

struct Drawing {
    Topology topology = Topology::triangles;
    Cull cull = Cull::none;
    std::span<const ColourTarget> colours = {};
    const char* depth = nullptr;  ///< name of the depth target; null: none
    DepthTest depth_test = DepthTest::less;
    bool writes_depth = true;
    /// Whether the fragment shader takes derivatives that depend on loads from buffers or storage images: helper
    /// invocations must then load, too. A device without DeviceProperties::helpers_load refuses the kernel.
    bool derives_loads = false;
};

/// One mip level of an image that is drawn to; of a cube also one face, of an image2darray one layer (`face`).
struct Attachment {
    Memory memory;
    std::uint32_t mip = 0, face = 0;
};

/// The targets of one call, and the viewport, in pixels of the targets. The viewport must lie inside each target;
/// targets may be larger.
struct DrawTargets {
    std::span<const Attachment> colours = {};  ///< in the order of Drawing::colours
    Attachment depth = {};                     ///< empty where Drawing::depth is null
    uint2 origin, extent;                      ///< the viewport, which is also the scissor
};

}  // namespace glift
