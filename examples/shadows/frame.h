// Draws frames with shadows: the structures of a frame on a device, and recordings of shadows.glift's pipelines that
// draw one.
#pragma once

#include "fitted_light.h"
#include "shadows.glift.hpp"

#include "examples/common/picture.h"
#include "examples/common/scenes/scenes.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// How shadows are made: by one shadow map, by adaptive shadow maps (ASM), or by resolution-matched ones (RMSM).
enum class Method { standard, adaptive, matched };
/// What a picture shows: the frame; the frame with a colour for each level of pages, or with the borders of pages; the
/// levels all over the map; the pool of pages.
enum class View { picture, levels, borders, map, pool };

enum class Filter { nearest, bilinear, trilinear };

/// The method of a name: standard, asm or rmsm. Like the three functions below, throws std::runtime_error, which lists
/// the names, if there is none.
Method method_of(const std::string& name);
View view_of(const std::string& name);
Filter filter_of(const std::string& name);
LightKind light_of(const std::string& name);

/// The most levels of a quadtree. With pages of 32 cells a side, the finest of so many has 131,072 cells a side.
constexpr std::uint32_t most_levels = 13;

/// The program's options (add_knobs of main.cpp) say what each setting is.
struct Settings {
    std::uint32_t cells = 32;   ///< of a page along each axis: 16, 32 or 64
    std::uint32_t levels = 11;  ///< of a map; the quadtree of a point light's six maps has two more
    std::uint32_t pages = 16'384, pairs = 4'000'000, standard = 2048, seed = 6, rounds = 8;
    float bias = 1e-4f;
    std::uint32_t step = 1, finest = 0;
    Filter filter = Filter::bilinear;
    bool cached = false;
    LightKind light = LightKind::directional;
    bool by_kernel = true;  ///< depths of pages are computed by kernels; false: by draws
};

/// For each pixel of a frame, the place in light space of the surface that it shows, and how much light gets there.
struct Lighting {
    /// s, t, depth, and the level whose cells are as large as the pixel; level -1: nothing that the light can reach.
    std::vector<glift::float4> surface;
    std::vector<glift::float3> slopes;   ///< derivatives of the surface's depth by s and by t; the bias of that depth
    std::vector<glift::float4> colours;  ///< colours in ambient light; w: light multiplies them by up to 1 + w
    std::vector<float> lit;              ///< the share of the light that gets there, 0 to 1
};

/// A text about a frame's pages; empty for a standard map, which has no pages.
std::string text_of(const shadows::Status& status, Method method);
/// A text for a frame with `lost` pairs: that shadows are missing, and the remedy.
std::string text_of_lost(const shadows::Status& status);

class Frame {
public:
    /// Throws std::runtime_error if a point light has too many levels, or fewer than 6 pages.
    Frame(glift::Device device, const Settings& settings, glift::uint2 size);

    /// Sets the scene of the next frames. Writes the mesh to the device only if it is another one. Pages that `cached`
    /// keeps are of one mesh and one light: where one of these changes, each method's next frame makes all pages anew.
    /// Throws std::runtime_error if the scene has no triangles.
    void set_scene(const scenes::Scene& scene);
    /// Takes over `bias`, `step`, `finest`, `filter`, `cached` and `rounds` for the next frames. The other settings
    /// stay as they are.
    void set_knobs(const Settings& settings);
    /// Moves the camera; all else stays.
    void set_view(const camera::Camera& view) { scene_.view = view; }
    /// Writes view and light to the device and, if there is no recording of such a frame by this method, makes one.
    void prepare(Method method);
    /// Submits the recording of a frame that is prepared: one submission. Does not wait.
    void submit(Method method);
    void draw(Method method);  ///< prepare(method), submit(method)

    const glift::Device& device() const { return device_; }
    const scenes::Scene& scene() const { return scene_; }
    /// The scene's light, with near and far planes fitted to the scene (fitted_light).
    const camera::Camera& light() const { return light_; }
    glift::uint2 size() const { return size_; }
    LightKind light_kind() const { return settings_.light; }
    /// Texels along each side of the standard map, or of each of its six faces.
    std::uint32_t standard_side() const {
        return settings_.light == LightKind::point ? settings_.standard / 2 : settings_.standard;
    }
    /// The tangent of half the angle that a spot light sees, or that a face of a point light sees: 90 degrees and, on
    /// each side, a texel of the standard map more.
    float opening() const;
    /// The matrices from the world to clip coordinates of the light's faces: six of a point light, else one.
    std::vector<glift::float4x4> lights() const;
    eye::Viewpoint viewpoint() const;
    /// A picture of the last frame: image() gives it on the device, picture() reads it from there.
    eye::Picture image(View view) const;
    picture::Picture picture(View view = View::picture) const;
    Lighting lighting() const;
    /// Counts of the last frame. download_counts() does not wait: it downloads the bytes of a shadows::Status.
    shadows::Status counts() const;
    glift::Download download_counts() const;
    /// How often the last frame has filled pages; 0 if it was drawn by Method::standard.
    std::uint32_t rounds() const { return counts().rounds; }
    std_page_allocator::PoolStatus pool() const { return counts().pool; }
    std::vector<std::uint32_t> owners() const;  ///< for each frame of the pool, the number of its page + 1; 0: none
    /// The depths of all frames of the pool; 0 in those that hold no page.
    std::vector<float> depths_of_pages() const;
    /// text_of the last frame. Throws std::runtime_error, with the remedy, if depths are missing because pairs of a
    /// triangle and a page found no room.
    std::string status() const;

private:
    using Structures = std::variant<std::monostate, shadows::Shadows16, shadows::Shadows32, shadows::Shadows64>;
    /// A method's own structures, so that a cached frame finds no pages that another method has asked for; made for its
    /// first frame.
    struct Made {
        Structures structures;
        glift::Recording recorded;
        bool keeps = false;     ///< the recorded frame keeps pages
        bool is_stale = false;  ///< the pages are of another mesh or light
    };

    Structures make_structures() const;
    glift::Recording record(Method method, bool keeps) const;
    void write_mesh(const mesh::Mesh& mesh);
    const Made& last() const { return made_.at(static_cast<std::size_t>(last_)); }

    /// Calls use(a copy of the structures of the last frame, which shares all their memory), whatever the size of their
    /// pages. They are there after `prepare`.
    template <class Use> auto with_shadows(const Use& use) const {
        const auto use_copy = [&](auto copy) { return use(copy); };
        const Structures& structures = last().structures;
        if (const auto* some = std::get_if<shadows::Shadows16>(&structures)) return use_copy(*some);
        if (const auto* some = std::get_if<shadows::Shadows64>(&structures)) return use_copy(*some);
        return use_copy(std::get<shadows::Shadows32>(structures));
    }
    /// The level on which one page covers a whole map.
    std::uint32_t coarsest() const { return settings_.levels - 1; }
    std::uint32_t quadtree_levels() const { return settings_.levels + (settings_.light == LightKind::point ? 2 : 0); }

    glift::Device device_;
    Settings settings_;
    glift::uint2 size_;
    std::optional<shadow_map::Corners> corners_;
    std::optional<shadow_map::Points> points_, colours_;
    scenes::Scene scene_;
    camera::Camera light_;
    std::array<Made, 3> made_;  ///< by each method
    Method last_ = Method::matched;
};
