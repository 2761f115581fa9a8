// Rasterisation: what a kernel that draws triangles, lines or points has besides its body, which is the vertex part (a
// vertex shader). The fragment part is the fragment shader.
//
// The parts exchange values with the rasteriser through locals that neither part declares: the vertex part assigns the
// position of the vertex, its distances to clip planes and the values to interpolate; the fragment part reads the
// interpolated values and assigns colours and depth. docs/reference/language.md calls a vertex a corner.
#pragma once

#include "base/arena.h"
#include "base/name.h"
#include "ir/types.h"
#include "source/source.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace gliftc::ir {

struct Stmt;
struct Local;

/// Which part of a draw a body is; `whole`: the body of a kernel that does not draw.
enum class Part : std::uint8_t { whole, vertex, fragment };

enum class Topology : std::uint8_t { triangles, lines, points };
enum class Cull : std::uint8_t { none, back, front };
enum class DepthTest : std::uint8_t { less, less_equal, greater, equal, always };
enum class Blend : std::uint8_t { replace, over, add, min, max, multiply };

/// smooth: perspective-correct; linear: linear in window coordinates; flat: the value of the first vertex.
enum class Interpolation : std::uint8_t { smooth, linear, flat };

/// A value that is interpolated between vertices.
struct Varying {
    Name name;
    TypeId type;
    Interpolation interpolation = Interpolation::smooth;
    Id<Local> written;  ///< the vertex part assigns it
    Id<Local> read;     ///< the fragment part reads it
    Span span;
};

struct ColourTarget {
    std::uint32_t param = 0;  ///< the kernel's parameter that is drawn to
    Blend blend = Blend::replace;
    Id<Local> value;  ///< the fragment part assigns the colour to it
};

struct DepthTarget {
    std::uint32_t param = 0;  ///< the kernel's parameter that has the depths
    DepthTest test = DepthTest::less;
    bool is_written = true;  ///< depths that pass the test are stored
    Id<Local> value;         ///< the fragment part may assign another depth to it
    bool is_set = false;     ///< the fragment part assigns `value`
};

struct Raster {
    Topology topology = Topology::triangles;
    Cull cull = Cull::none;
    std::vector<Varying> varyings;
    std::vector<ColourTarget> colours;  ///< in the order of the parameters
    std::optional<DepthTarget> depth;
    std::optional<std::uint32_t> pixels;  ///< the parameter whose range is the viewport: a target, else an `at`
    Id<Local> place;                      ///< float4: the vertex's clip coordinates
    std::vector<Id<Local>> clip_distances;
    bool has_fragment = false;
    std::vector<Id<Stmt>> fragment;
};

/// All locals that the parts exchange with the rasteriser.
std::vector<Id<Local>> given_locals(const Raster& raster);

}  // namespace gliftc::ir
