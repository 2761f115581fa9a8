// A frame's structures on a device, and the pipelines of shadows.glift that make one.
#pragma once

#include "shadows.glift.hpp"

#include "examples/common/picture.h"
#include "examples/common/scenes/scenes.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

enum class Method { standard, adaptive, matched };
enum class View { picture, levels, borders, map, pool };

enum class Filter { nearest, bilinear, trilinear };

/// standard, asm or rmsm. Throws std::runtime_error.
Method method_of(const std::string& name);
View view_of(const std::string& name);
Filter filter_of(const std::string& name);

struct Settings {
    std::uint32_t cells = 32;  ///< of a page along each axis: 16, 32 or 64
    std::uint32_t levels = 11, pages = 8192, pairs = 4'000'000, standard = 2048, seed = 6, rounds = 8;
    float bias = 1e-4f;
    std::uint32_t step = 1, finest = 0;
    Filter filter = Filter::bilinear;
    bool cached = false, spot = false;
    bool by_kernel = true;  ///< how pages are filled; else by draws
};

/// What the light does to the picture: for each pixel its place in light space and the share of light there.
struct Lighting {
    std::vector<glift::float4> surface;  ///< s, t, depth, level; level -1: not reached by the light
    std::vector<glift::float2> slopes;   ///< depth by s and t
    std::vector<glift::float4> colours;  ///< as eye.glift has them
    std::vector<float> lit;
};

class Frame {
public:
    Frame(glift::Device device, const Settings& settings, glift::uint2 size);

    /// The scene of the next frames. As long as its size stays, so does memory, and what a cache holds.
    void set_scene(const scenes::Scene& scene);
    /// Knobs of the next frames. Sizes of the quadtree, the standard map and the light's kind stay as they are.
    void set_knobs(const Settings& settings);
    /// Another place of the camera; all else stays.
    void set_view(const camera::Camera& view) { scene_.view = view; }
    /// Gives the view to the device and, the first time, records what a frame is.
    void prepare(Method method);
    /// A frame that is prepared: one submission. Nothing waits.
    void submit(Method method) { recorded_[static_cast<std::size_t>(method)].submit(); }
    void draw(Method method);  ///< both

    const glift::Device& device() const { return device_; }
    const scenes::Scene& scene() const { return scene_; }
    glift::uint2 size() const { return size_; }
    bool is_spot() const { return settings_.spot; }
    glift::float4x4 light() const;
    eye::Viewpoint viewpoint() const;
    /// Of the last frame, on the device or read from it.
    eye::Picture image(View view) const;
    picture::Picture picture(View view = View::picture) const;
    Lighting lighting() const;
    /// Of the last frame.
    shadows::Status counts() const;
    /// How often the last frame of ASM or RMSM has filled pages.
    std::uint32_t rounds() const { return counts().rounds; }
    std_page_allocator::PoolStatus pool() const { return counts().pool; }
    std::vector<std::uint32_t> owners() const;  ///< page + 1 of each frame
    /// The pool's depths, those of frames without a page 0.
    std::vector<float> depths_of_pages() const;
    /// Of the last frame. Throws std::runtime_error where depths are missing, with the remedy.
    std::string status() const;

private:
    /// Gives what there is, by the size of its pages, to `use`: a copy, which shares all memory. There is some after
    /// `set_scene`.
    template <class Use> auto with_shadows(const Use& use) const {
        const auto use_copy = [&](auto copy) { return use(copy); };
        if (const auto* some = std::get_if<shadows::Shadows16>(&shadows_)) return use_copy(*some);
        if (const auto* some = std::get_if<shadows::Shadows64>(&shadows_)) return use_copy(*some);
        return use_copy(std::get<shadows::Shadows32>(shadows_));
    }

    glift::Device device_;
    Settings settings_;
    glift::uint2 size_;
    std::variant<std::monostate, shadows::Shadows16, shadows::Shadows32, shadows::Shadows64> shadows_;
    std::optional<shadow_map::Corners> corners_;
    std::optional<shadow_map::Points> points_, colours_;
    scenes::Scene scene_;
    std::array<glift::Recording, 3> recorded_;  ///< a frame by each method
};
