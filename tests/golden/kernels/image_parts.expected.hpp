// Made by gliftc from image_parts.glift. Changes are lost when it is made again.
#pragma once

#include "image_parts.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

namespace std_image {

#ifndef GLIFT_std_image_HAS_ImageLevels_r32f
#define GLIFT_std_image_HAS_ImageLevels_r32f
/// ImageLevels<r32f>. A 2-D image with `levels` levels, each of half the extent of the one before, rounded down and
/// no less than a texel. There may be 1 + floor(log2(larger side)) of them. Elements are those of level 0;
/// `sample(x, level)`, for formats other than d32, is filtered within a level and between two of them, x in texels
/// of level 0; a `level` beyond the last one means the last one.
class ImageLevels_r32f : public glift::Structure<ImageLevels_r32f, glift::uint2, float> {
public:
    static constexpr const char* type_name = "ImageLevels<r32f>";

    ImageLevels_r32f() = default;
    ImageLevels_r32f(const glift::Commands& commands, glift::uint2 extent, glift::uint levels);
    /// Makes the structure with the given memory.
    ImageLevels_r32f(const glift::Commands& commands, glift::uint2 extent, glift::uint levels, glift::Memory data);

    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    glift::uint levels() const { return levels_; }
    const glift::Memory& data() const { return data_; }
    glift::uint2 data_extent() const { return data_extent_; }
    bool same_state(const ImageLevels_r32f& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<ImageLevels_r32f>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<ImageLevels_r32f>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<ImageLevels_r32f>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.value("levels", levels_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint2, glift::uint>;
    static constexpr std::uint64_t state_key = 9029626676026448781u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.argument("levels", levels_);
        visit.image("data", data_, data_extent_);
    }

private:
    glift::uint2 extent_{};
    glift::uint levels_{};
    glift::uint2 data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_image

namespace image_parts {

using Levels = ::std_image::ImageLevels_r32f;

}  // namespace image_parts

namespace std_image {

#ifndef GLIFT_std_image_HAS_ImageLevel_r32f
#define GLIFT_std_image_HAS_ImageLevel_r32f
/// ImageLevel<r32f>. One level of `of`: the same texels, as an image that is read, written and drawn to by itself,
/// also while other levels are.
class ImageLevel_r32f : public glift::Structure<ImageLevel_r32f, glift::uint2, float> {
public:
    static constexpr const char* type_name = "ImageLevel<r32f>";

    ImageLevel_r32f() = default;
    ImageLevel_r32f(const glift::Commands& commands, const ImageLevels_r32f& of, glift::uint level);

    glift::uint2 domain() const;
    glift::uint level() const { return level_; }
    const ImageLevels_r32f& of() const { return of_; }
    ImageLevels_r32f& of() { return of_; }
    const glift::Memory& data() const { return data_; }
    glift::uint2 data_extent() const { return data_extent_; }
    bool same_state(const ImageLevel_r32f& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<ImageLevel_r32f>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<ImageLevel_r32f>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<ImageLevel_r32f>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("level", level_);
        see.memory("data", data());
        see.given("of", of());
    }
    static constexpr std::uint64_t state_key = 9954807252285922879u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("level", level_);
        visit.given("of", of_);
    }

private:
    glift::uint level_{};
    ImageLevels_r32f of_;
    glift::uint2 data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_image

namespace image_parts {

using Level = ::std_image::ImageLevel_r32f;

}  // namespace image_parts

namespace std_image {

#ifndef GLIFT_std_image_HAS_ImageLayers_rgba8
#define GLIFT_std_image_HAS_ImageLayers_rgba8
/// ImageLayers<rgba8>. `layers` 2-D images of one extent; the third component of an address is the layer.
/// `sample(x)` is filtered within the layer in which x lies: layer l from l to l + 1.
class ImageLayers_rgba8 : public glift::Structure<ImageLayers_rgba8, glift::uint3, glift::float4> {
public:
    static constexpr const char* type_name = "ImageLayers<rgba8>";

    ImageLayers_rgba8() = default;
    ImageLayers_rgba8(const glift::Commands& commands, glift::uint2 extent, glift::uint layers);
    /// Makes the structure with the given memory.
    ImageLayers_rgba8(const glift::Commands& commands, glift::uint2 extent, glift::uint layers, glift::Memory data);

    glift::uint3 domain() const;
    glift::uint2 extent() const { return extent_; }
    glift::uint layers() const { return layers_; }
    const glift::Memory& data() const { return data_; }
    glift::uint3 data_extent() const { return data_extent_; }
    bool same_state(const ImageLayers_rgba8& other) const;

    void fill(glift::float4 value);
    void fill(glift::float4 value, const glift::Range<ImageLayers_rgba8>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<ImageLayers_rgba8>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<ImageLayers_rgba8>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.value("layers", layers_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint2, glift::uint>;
    static constexpr std::uint64_t state_key = 12215317453492606684u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.argument("layers", layers_);
        visit.image("data", data_, data_extent_);
    }

private:
    glift::uint2 extent_{};
    glift::uint layers_{};
    glift::uint3 data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_image

namespace image_parts {

using Layers = ::std_image::ImageLayers_rgba8;

}  // namespace image_parts

namespace std_image {

#ifndef GLIFT_std_image_HAS_ImageLayer_rgba8
#define GLIFT_std_image_HAS_ImageLayer_rgba8
/// ImageLayer<rgba8>. One layer of `of`: the same texels, as an image that is read, written and drawn to by itself.
class ImageLayer_rgba8 : public glift::Structure<ImageLayer_rgba8, glift::uint2, glift::float4> {
public:
    static constexpr const char* type_name = "ImageLayer<rgba8>";

    ImageLayer_rgba8() = default;
    ImageLayer_rgba8(const glift::Commands& commands, const ImageLayers_rgba8& of, glift::uint layer);

    glift::uint2 domain() const;
    glift::uint layer() const { return layer_; }
    const ImageLayers_rgba8& of() const { return of_; }
    ImageLayers_rgba8& of() { return of_; }
    const glift::Memory& data() const { return data_; }
    glift::uint2 data_extent() const { return data_extent_; }
    bool same_state(const ImageLayer_rgba8& other) const;

    void fill(glift::float4 value);
    void fill(glift::float4 value, const glift::Range<ImageLayer_rgba8>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<ImageLayer_rgba8>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<ImageLayer_rgba8>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("layer", layer_);
        see.memory("data", data());
        see.given("of", of());
    }
    static constexpr std::uint64_t state_key = 12564200580033999203u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("layer", layer_);
        visit.given("of", of_);
    }

private:
    glift::uint layer_{};
    ImageLayers_rgba8 of_;
    glift::uint2 data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_image

namespace image_parts {

using Layer = ::std_image::ImageLayer_rgba8;

void halve(const glift::Commands& commands, const glift::Range<Level>& fine, const glift::Range<Level>& a,
    const glift::Range<Level>& to);

void resample(const glift::Commands& commands, const glift::Range<Levels>& from, const glift::Range<Layers>& layers,
    const glift::Range<Layer>& a, glift::uint level, const glift::Range<Layer>& to);

void build(const glift::Commands& commands, const Levels& all);

}  // namespace image_parts
