// What a kernel that draws has beside its body, which is the vertex part.
//
// Both parts speak of locals that neither declares: the vertex part assigns the place of the corner, its distances to
// clip planes and what is interpolated; the fragment part reads what is interpolated and assigns what it draws.
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

/// Perspective-correct; linear in the window; of the first corner.
enum class Interpolation : std::uint8_t { smooth, linear, flat };

struct Varying {
    Name name;
    TypeId type;
    Interpolation interpolation = Interpolation::smooth;
    Id<Local> written;  ///< in the vertex part
    Id<Local> read;     ///< in the fragment part
    Span span;
};

struct ColourTarget {
    std::uint32_t param = 0;
    Blend blend = Blend::replace;
    Id<Local> value;  ///< what the fragment part draws
};

struct DepthTarget {
    std::uint32_t param = 0;
    DepthTest test = DepthTest::less;
    bool is_written = true;
    Id<Local> value;      ///< where the fragment part gives another depth
    bool is_set = false;  ///< it does
};

struct Raster {
    Topology topology = Topology::triangles;
    Cull cull = Cull::none;
    std::vector<Varying> varyings;
    std::vector<ColourTarget> colours;  ///< in the order of the parameters
    std::optional<DepthTarget> depth;
    std::optional<std::uint32_t> pixels;  ///< the parameter whose range is the viewport: a target, else an `at`
    Id<Local> place;                      ///< float4: clip coordinates
    std::vector<Id<Local>> clip_distances;
    bool has_fragment = false;
    std::vector<Id<Stmt>> fragment;
};

/// The locals that the parts use and do not declare.
std::vector<Id<Local>> given_locals(const Raster& raster);

}  // namespace gliftc::ir
