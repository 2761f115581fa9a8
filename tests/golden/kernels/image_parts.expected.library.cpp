// Made by gliftc from image_parts.glift. Changes are lost when it is made again.
#include "image_parts.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace std_image {

using namespace glift::types;

GLIFT_SHARED ImageLevels_r32f::ImageLevels_r32f(const glift::Commands& commands, uint2 extent, uint levels)
    : Structure(commands.device()),
      extent_(extent),
      levels_(levels),
      data_extent_(extent_),
      data_(commands.allocate({.name = "ImageLevels<r32f>.data", .kind = glift::MemoryKind::image2d,
        .format = glift::Format::r32f, .extent = glift::image_extent(data_extent_), .mips = levels_})) {}

GLIFT_SHARED ImageLevels_r32f::ImageLevels_r32f(const glift::Commands& commands, uint2 extent, uint levels,
    glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      levels_(levels),
      data_extent_(extent_),
      data_(commands.adopt(std::move(data),
        {.name = "ImageLevels<r32f>.data", .kind = glift::MemoryKind::image2d, .format = glift::Format::r32f,
        .extent = glift::image_extent(data_extent_), .mips = levels_})) {}

GLIFT_SHARED uint2 ImageLevels_r32f::domain() const {
    return extent_;
}

GLIFT_SHARED bool ImageLevels_r32f::same_state(const ImageLevels_r32f& other) const {
    return extent_ == other.extent_ && levels_ == other.levels_;
}

GLIFT_SHARED void ImageLevels_r32f::copy_out(const glift::Commands& commands,
    const glift::Range<ImageLevels_r32f>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_ead0b93f(commands, range, ::std_transfer::Box_2_float(commands, range.size(), box));
}

GLIFT_SHARED void ImageLevels_r32f::copy_in(const glift::Commands& commands,
    const glift::Range<ImageLevels_r32f>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_3c321d3e(commands, ::std_transfer::Box_2_float(commands, range.size(), box), range);
}

GLIFT_SHARED void ImageLevels_r32f::fill(float value, const glift::Range<ImageLevels_r32f>& range) {
    ::std_transfer::fill_box_8cc295b1(device(), range, value);
}
GLIFT_SHARED void ImageLevels_r32f::fill(float value) {
    fill(value, *this);
}

GLIFT_SHARED ImageLevel_r32f::ImageLevel_r32f(const glift::Commands& commands, const ImageLevels_r32f& of, uint level)
    : Structure(commands.device()),
      level_(level),
      of_(of),
      data_extent_(glift::max(of_.data_extent() >> uint2(level_), uint2(1u))),
      data_(of_.data().mip(level_)) {}

GLIFT_SHARED uint2 ImageLevel_r32f::domain() const {
    return data_extent_;
}

GLIFT_SHARED bool ImageLevel_r32f::same_state(const ImageLevel_r32f& other) const {
    return level_ == other.level_ && of_.same_state(other.of_);
}

GLIFT_SHARED void ImageLevel_r32f::copy_out(const glift::Commands& commands, const glift::Range<ImageLevel_r32f>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_a6033574(commands, range, ::std_transfer::Box_2_float(commands, range.size(), box));
}

GLIFT_SHARED void ImageLevel_r32f::copy_in(const glift::Commands& commands, const glift::Range<ImageLevel_r32f>& range,
    const glift::Memory& box) const {
    ::std_transfer::write_box_7baf3dcd(commands, ::std_transfer::Box_2_float(commands, range.size(), box), range);
}

GLIFT_SHARED void ImageLevel_r32f::fill(float value, const glift::Range<ImageLevel_r32f>& range) {
    ::std_transfer::fill_box_2b12c936(device(), range, value);
}
GLIFT_SHARED void ImageLevel_r32f::fill(float value) {
    fill(value, *this);
}

GLIFT_SHARED ImageLayers_rgba8::ImageLayers_rgba8(const glift::Commands& commands, uint2 extent, uint layers)
    : Structure(commands.device()),
      extent_(extent),
      layers_(layers),
      data_extent_(uint3(extent_, layers_)),
      data_(commands.allocate({.name = "ImageLayers<rgba8>.data", .kind = glift::MemoryKind::image2darray,
        .format = glift::Format::rgba8, .extent = glift::image_extent(data_extent_)})) {}

GLIFT_SHARED ImageLayers_rgba8::ImageLayers_rgba8(const glift::Commands& commands, uint2 extent, uint layers,
    glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      layers_(layers),
      data_extent_(uint3(extent_, layers_)),
      data_(commands.adopt(std::move(data),
        {.name = "ImageLayers<rgba8>.data", .kind = glift::MemoryKind::image2darray, .format = glift::Format::rgba8,
        .extent = glift::image_extent(data_extent_)})) {}

GLIFT_SHARED uint3 ImageLayers_rgba8::domain() const {
    return uint3(extent_, layers_);
}

GLIFT_SHARED bool ImageLayers_rgba8::same_state(const ImageLayers_rgba8& other) const {
    return extent_ == other.extent_ && layers_ == other.layers_;
}

GLIFT_SHARED void ImageLayers_rgba8::copy_out(const glift::Commands& commands,
    const glift::Range<ImageLayers_rgba8>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_184e6050(commands, range, ::std_transfer::Box_3_float4(commands, range.size(), box));
}

GLIFT_SHARED void ImageLayers_rgba8::copy_in(const glift::Commands& commands,
    const glift::Range<ImageLayers_rgba8>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_424b54b5(commands, ::std_transfer::Box_3_float4(commands, range.size(), box), range);
}

GLIFT_SHARED void ImageLayers_rgba8::fill(float4 value, const glift::Range<ImageLayers_rgba8>& range) {
    ::std_transfer::fill_box_06059ad3(device(), range, value);
}
GLIFT_SHARED void ImageLayers_rgba8::fill(float4 value) {
    fill(value, *this);
}

GLIFT_SHARED ImageLayer_rgba8::ImageLayer_rgba8(const glift::Commands& commands, const ImageLayers_rgba8& of,
    uint layer)
    : Structure(commands.device()),
      layer_(layer),
      of_(of),
      data_extent_(of_.data_extent().xy()),
      data_(of_.data().layer(layer_)) {}

GLIFT_SHARED uint2 ImageLayer_rgba8::domain() const {
    return data_extent_;
}

GLIFT_SHARED bool ImageLayer_rgba8::same_state(const ImageLayer_rgba8& other) const {
    return layer_ == other.layer_ && of_.same_state(other.of_);
}

GLIFT_SHARED void ImageLayer_rgba8::copy_out(const glift::Commands& commands,
    const glift::Range<ImageLayer_rgba8>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_9ab1f796(commands, range, ::std_transfer::Box_2_float4(commands, range.size(), box));
}

GLIFT_SHARED void ImageLayer_rgba8::copy_in(const glift::Commands& commands,
    const glift::Range<ImageLayer_rgba8>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_fc1ef9a5(commands, ::std_transfer::Box_2_float4(commands, range.size(), box), range);
}

GLIFT_SHARED void ImageLayer_rgba8::fill(float4 value, const glift::Range<ImageLayer_rgba8>& range) {
    ::std_transfer::fill_box_673f66ca(device(), range, value);
}
GLIFT_SHARED void ImageLayer_rgba8::fill(float4 value) {
    fill(value, *this);
}

}  // namespace std_image

namespace std_transfer {

using namespace glift::types;

namespace {

// address.glift:18: volume<2> in 64 bits
inline std::uint64_t volume_64(uint2 extent) {
    // address.glift:19
    std::uint64_t product = std::uint64_t(extent.x);
    // address.glift:20
    for (uint axis = 1u; axis < 2u; ++axis) {
        // address.glift:21
        product = glift::saturated_product(product, std::uint64_t(extent[axis]));
    }
    // address.glift:23
    return product;
}

// address.glift:27: linearize<2> in 64 bits
inline std::uint64_t linearize_64(uint2 address, uint2 extent) {
    // address.glift:28
    std::uint64_t index = std::uint64_t(address.y);
    // address.glift:29
    for (uint back = 1u; back < 2u; ++back) {
        // address.glift:30
        index = index * std::uint64_t(extent[2u - 1u - back]) + std::uint64_t(address[2u - 1u - back]);
    }
    // address.glift:32
    return index;
}

// address.glift:18: volume<3> in 64 bits
inline std::uint64_t volume_64_2(uint3 extent) {
    // address.glift:19
    std::uint64_t product = std::uint64_t(extent.x);
    // address.glift:20
    for (uint axis = 1u; axis < 3u; ++axis) {
        // address.glift:21
        product = glift::saturated_product(product, std::uint64_t(extent[axis]));
    }
    // address.glift:23
    return product;
}

// address.glift:27: linearize<3> in 64 bits
inline std::uint64_t linearize_64_2(uint3 address, uint3 extent) {
    // address.glift:28
    std::uint64_t index = std::uint64_t(address.z);
    // address.glift:29
    for (uint back = 1u; back < 3u; ++back) {
        // address.glift:30
        index = index * std::uint64_t(extent[3u - 1u - back]) + std::uint64_t(address[3u - 1u - back]);
    }
    // address.glift:32
    return index;
}

}  // namespace

namespace {
struct read_box_a6033574_direct_parameters {
    uint2 from_data_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_a6033574_direct_parameters, from_data_extent) == 0);
static_assert(offsetof(read_box_a6033574_direct_parameters, to_extent_x) == 8);
struct read_box_a6033574_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint to_extent_x;
};
static_assert(offsetof(read_box_a6033574_general_parameters, size) == 0);
static_assert(offsetof(read_box_a6033574_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_a6033574_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_a6033574_general_parameters, to_extent_x) == 24);
struct read_box_a6033574_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_a6033574_wide_parameters, size) == 0);
static_assert(offsetof(read_box_a6033574_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_a6033574_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_a6033574_wide_parameters, base) == 24);
static_assert(offsetof(read_box_a6033574_wide_parameters, to_extent_x) == 40);
static_assert(offsetof(read_box_a6033574_wide_parameters, to_data_address) == 48);
}  // namespace

extern const glift::Kernel read_box_a6033574_kernel;

GLIFT_SHARED void read_box_a6033574(const glift::Commands& commands,
    const glift::Range<::std_image::ImageLevel_r32f>& from, const glift::Range<Box_2_float>& to) {
    glift::Iteration iteration(read_box_a6033574_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(read_box_a6033574_kernel, memories, iteration.size())) {
        const read_box_a6033574_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_x = std::uint64_t(to->extent().x),
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_a6033574_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_a6033574_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const read_box_a6033574_direct_parameters parameters = {
            .from_data_extent = from->data_extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_a6033574_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const read_box_a6033574_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_a6033574_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_a6033574_general_parameters,
            size)})});
    }
}

namespace {
struct write_box_7baf3dcd_direct_parameters {
    uint2 from_extent;
};
static_assert(offsetof(write_box_7baf3dcd_direct_parameters, from_extent) == 0);
struct write_box_7baf3dcd_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
};
static_assert(offsetof(write_box_7baf3dcd_general_parameters, size) == 0);
static_assert(offsetof(write_box_7baf3dcd_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_7baf3dcd_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_7baf3dcd_general_parameters, from_extent_x) == 24);
struct write_box_7baf3dcd_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, size) == 0);
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, base) == 24);
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, from_data_address) == 48);
}  // namespace

extern const glift::Kernel write_box_7baf3dcd_kernel;

GLIFT_SHARED void write_box_7baf3dcd(const glift::Commands& commands, const glift::Range<Box_2_float>& from,
    const glift::Range<::std_image::ImageLevel_r32f>& to) {
    glift::Iteration iteration(write_box_7baf3dcd_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(write_box_7baf3dcd_kernel, memories, iteration.size())) {
        const write_box_7baf3dcd_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = std::uint64_t(from->extent().x),
            .from_data_address = 0u,
        };
        commands.dispatch(write_box_7baf3dcd_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_7baf3dcd_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const write_box_7baf3dcd_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_7baf3dcd_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const write_box_7baf3dcd_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
        };
        commands.dispatch(write_box_7baf3dcd_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_7baf3dcd_general_parameters,
            size)})});
    }
}

namespace {
struct fill_box_2b12c936_direct_parameters {
    uint2 to_data_extent;
    float value;
};
static_assert(offsetof(fill_box_2b12c936_direct_parameters, to_data_extent) == 0);
static_assert(offsetof(fill_box_2b12c936_direct_parameters, value) == 8);
struct fill_box_2b12c936_general_parameters {
    uint2 size;
    uint2 to_origin;
    float value;
};
static_assert(offsetof(fill_box_2b12c936_general_parameters, size) == 0);
static_assert(offsetof(fill_box_2b12c936_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_2b12c936_general_parameters, value) == 16);
struct fill_box_2b12c936_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    float value;
};
static_assert(offsetof(fill_box_2b12c936_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_2b12c936_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_2b12c936_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_2b12c936_wide_parameters, value) == 28);
}  // namespace

extern const glift::Kernel fill_box_2b12c936_kernel;

GLIFT_SHARED void fill_box_2b12c936(const glift::Commands& commands,
    const glift::Range<::std_image::ImageLevel_r32f>& to, float value) {
    glift::Iteration iteration(fill_box_2b12c936_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_2b12c936_kernel, memories, iteration.size())) {
        const fill_box_2b12c936_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .base = {},
            .value = value,
        };
        commands.dispatch(fill_box_2b12c936_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_2b12c936_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_2b12c936_direct_parameters parameters = {
            .to_data_extent = to->data_extent(),
            .value = value,
        };
        commands.dispatch(fill_box_2b12c936_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_2b12c936_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_2b12c936_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_2b12c936_general_parameters,
            size)})});
    }
}

namespace {
struct read_box_ead0b93f_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_ead0b93f_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_ead0b93f_direct_parameters, to_extent_x) == 8);
struct read_box_ead0b93f_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint to_extent_x;
};
static_assert(offsetof(read_box_ead0b93f_general_parameters, size) == 0);
static_assert(offsetof(read_box_ead0b93f_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_ead0b93f_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_ead0b93f_general_parameters, to_extent_x) == 24);
struct read_box_ead0b93f_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_ead0b93f_wide_parameters, size) == 0);
static_assert(offsetof(read_box_ead0b93f_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_ead0b93f_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_ead0b93f_wide_parameters, base) == 24);
static_assert(offsetof(read_box_ead0b93f_wide_parameters, to_extent_x) == 40);
static_assert(offsetof(read_box_ead0b93f_wide_parameters, to_data_address) == 48);
}  // namespace

extern const glift::Kernel read_box_ead0b93f_kernel;

GLIFT_SHARED void read_box_ead0b93f(const glift::Commands& commands,
    const glift::Range<::std_image::ImageLevels_r32f>& from, const glift::Range<Box_2_float>& to) {
    glift::Iteration iteration(read_box_ead0b93f_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(read_box_ead0b93f_kernel, memories, iteration.size())) {
        const read_box_ead0b93f_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_x = std::uint64_t(to->extent().x),
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_ead0b93f_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_ead0b93f_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const read_box_ead0b93f_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_ead0b93f_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const read_box_ead0b93f_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_ead0b93f_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_ead0b93f_general_parameters,
            size)})});
    }
}

namespace {
struct write_box_3c321d3e_direct_parameters {
    uint2 from_extent;
};
static_assert(offsetof(write_box_3c321d3e_direct_parameters, from_extent) == 0);
struct write_box_3c321d3e_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
};
static_assert(offsetof(write_box_3c321d3e_general_parameters, size) == 0);
static_assert(offsetof(write_box_3c321d3e_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_3c321d3e_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_3c321d3e_general_parameters, from_extent_x) == 24);
struct write_box_3c321d3e_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_3c321d3e_wide_parameters, size) == 0);
static_assert(offsetof(write_box_3c321d3e_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_3c321d3e_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_3c321d3e_wide_parameters, base) == 24);
static_assert(offsetof(write_box_3c321d3e_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_3c321d3e_wide_parameters, from_data_address) == 48);
}  // namespace

extern const glift::Kernel write_box_3c321d3e_kernel;

GLIFT_SHARED void write_box_3c321d3e(const glift::Commands& commands, const glift::Range<Box_2_float>& from,
    const glift::Range<::std_image::ImageLevels_r32f>& to) {
    glift::Iteration iteration(write_box_3c321d3e_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(write_box_3c321d3e_kernel, memories, iteration.size())) {
        const write_box_3c321d3e_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = std::uint64_t(from->extent().x),
            .from_data_address = 0u,
        };
        commands.dispatch(write_box_3c321d3e_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_3c321d3e_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const write_box_3c321d3e_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_3c321d3e_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const write_box_3c321d3e_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
        };
        commands.dispatch(write_box_3c321d3e_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_3c321d3e_general_parameters,
            size)})});
    }
}

namespace {
struct fill_box_8cc295b1_direct_parameters {
    uint2 to_extent;
    float value;
};
static_assert(offsetof(fill_box_8cc295b1_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_8cc295b1_direct_parameters, value) == 8);
struct fill_box_8cc295b1_general_parameters {
    uint2 size;
    uint2 to_origin;
    float value;
};
static_assert(offsetof(fill_box_8cc295b1_general_parameters, size) == 0);
static_assert(offsetof(fill_box_8cc295b1_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_8cc295b1_general_parameters, value) == 16);
struct fill_box_8cc295b1_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    float value;
};
static_assert(offsetof(fill_box_8cc295b1_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_8cc295b1_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_8cc295b1_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_8cc295b1_wide_parameters, value) == 28);
}  // namespace

extern const glift::Kernel fill_box_8cc295b1_kernel;

GLIFT_SHARED void fill_box_8cc295b1(const glift::Commands& commands,
    const glift::Range<::std_image::ImageLevels_r32f>& to, float value) {
    glift::Iteration iteration(fill_box_8cc295b1_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_8cc295b1_kernel, memories, iteration.size())) {
        const fill_box_8cc295b1_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .base = {},
            .value = value,
        };
        commands.dispatch(fill_box_8cc295b1_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_8cc295b1_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_8cc295b1_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_8cc295b1_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_8cc295b1_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_8cc295b1_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_8cc295b1_general_parameters,
            size)})});
    }
}

namespace {
struct read_box_184e6050_direct_parameters {
    uint3 from_domain;
    uint3 to_extent;
    uint from_extent_y;
};
static_assert(offsetof(read_box_184e6050_direct_parameters, from_domain) == 0);
static_assert(offsetof(read_box_184e6050_direct_parameters, to_extent) == 12);
static_assert(offsetof(read_box_184e6050_direct_parameters, from_extent_y) == 24);
struct read_box_184e6050_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 to_extent;
};
static_assert(offsetof(read_box_184e6050_general_parameters, size) == 0);
static_assert(offsetof(read_box_184e6050_general_parameters, from_origin) == 12);
static_assert(offsetof(read_box_184e6050_general_parameters, to_origin) == 24);
static_assert(offsetof(read_box_184e6050_general_parameters, to_extent) == 36);
struct read_box_184e6050_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    std::uint64_t to_extent_y;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_184e6050_wide_parameters, size) == 0);
static_assert(offsetof(read_box_184e6050_wide_parameters, from_origin) == 12);
static_assert(offsetof(read_box_184e6050_wide_parameters, to_origin) == 24);
static_assert(offsetof(read_box_184e6050_wide_parameters, base) == 36);
static_assert(offsetof(read_box_184e6050_wide_parameters, to_extent_y) == 48);
static_assert(offsetof(read_box_184e6050_wide_parameters, to_extent_x) == 56);
static_assert(offsetof(read_box_184e6050_wide_parameters, to_data_address) == 64);
}  // namespace

extern const glift::Kernel read_box_184e6050_kernel;

GLIFT_SHARED void read_box_184e6050(const glift::Commands& commands,
    const glift::Range<::std_image::ImageLayers_rgba8>& from, const glift::Range<Box_3_float4>& to) {
    glift::Iteration iteration(read_box_184e6050_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(read_box_184e6050_kernel, memories, iteration.size())) {
        const read_box_184e6050_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_y = std::uint64_t(to->extent().y),
            .to_extent_x = std::uint64_t(to->extent().x),
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_184e6050_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_184e6050_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const read_box_184e6050_direct_parameters parameters = {
            .from_domain = uint3(from->extent(), from->layers()),
            .to_extent = to->extent(),
            .from_extent_y = from->extent().y,
        };
        commands.dispatch(read_box_184e6050_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const read_box_184e6050_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_extent = to->extent(),
        };
        commands.dispatch(read_box_184e6050_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_184e6050_general_parameters,
            size)})});
    }
}

namespace {
struct write_box_424b54b5_direct_parameters {
    uint3 from_extent;
};
static_assert(offsetof(write_box_424b54b5_direct_parameters, from_extent) == 0);
struct write_box_424b54b5_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 from_extent;
};
static_assert(offsetof(write_box_424b54b5_general_parameters, size) == 0);
static_assert(offsetof(write_box_424b54b5_general_parameters, from_origin) == 12);
static_assert(offsetof(write_box_424b54b5_general_parameters, to_origin) == 24);
static_assert(offsetof(write_box_424b54b5_general_parameters, from_extent) == 36);
struct write_box_424b54b5_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    std::uint64_t from_extent_y;
    std::uint64_t from_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_424b54b5_wide_parameters, size) == 0);
static_assert(offsetof(write_box_424b54b5_wide_parameters, from_origin) == 12);
static_assert(offsetof(write_box_424b54b5_wide_parameters, to_origin) == 24);
static_assert(offsetof(write_box_424b54b5_wide_parameters, base) == 36);
static_assert(offsetof(write_box_424b54b5_wide_parameters, from_extent_y) == 48);
static_assert(offsetof(write_box_424b54b5_wide_parameters, from_extent_x) == 56);
static_assert(offsetof(write_box_424b54b5_wide_parameters, from_data_address) == 64);
}  // namespace

extern const glift::Kernel write_box_424b54b5_kernel;

GLIFT_SHARED void write_box_424b54b5(const glift::Commands& commands, const glift::Range<Box_3_float4>& from,
    const glift::Range<::std_image::ImageLayers_rgba8>& to) {
    glift::Iteration iteration(write_box_424b54b5_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(write_box_424b54b5_kernel, memories, iteration.size())) {
        const write_box_424b54b5_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_y = std::uint64_t(from->extent().y),
            .from_extent_x = std::uint64_t(from->extent().x),
            .from_data_address = 0u,
        };
        commands.dispatch(write_box_424b54b5_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_424b54b5_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const write_box_424b54b5_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_424b54b5_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const write_box_424b54b5_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_424b54b5_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_424b54b5_general_parameters,
            size)})});
    }
}

namespace {
struct fill_box_06059ad3_direct_parameters {
    uint3 to_domain;
    float4 value;
    uint to_extent_y;
};
static_assert(offsetof(fill_box_06059ad3_direct_parameters, to_domain) == 0);
static_assert(offsetof(fill_box_06059ad3_direct_parameters, value) == 12);
static_assert(offsetof(fill_box_06059ad3_direct_parameters, to_extent_y) == 28);
struct fill_box_06059ad3_general_parameters {
    uint3 size;
    uint3 to_origin;
    float4 value;
};
static_assert(offsetof(fill_box_06059ad3_general_parameters, size) == 0);
static_assert(offsetof(fill_box_06059ad3_general_parameters, to_origin) == 12);
static_assert(offsetof(fill_box_06059ad3_general_parameters, value) == 24);
struct fill_box_06059ad3_wide_parameters {
    uint3 size;
    uint3 to_origin;
    uint3 base;
    float4 value;
};
static_assert(offsetof(fill_box_06059ad3_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_06059ad3_wide_parameters, to_origin) == 12);
static_assert(offsetof(fill_box_06059ad3_wide_parameters, base) == 24);
static_assert(offsetof(fill_box_06059ad3_wide_parameters, value) == 36);
}  // namespace

extern const glift::Kernel fill_box_06059ad3_kernel;

GLIFT_SHARED void fill_box_06059ad3(const glift::Commands& commands,
    const glift::Range<::std_image::ImageLayers_rgba8>& to, float4 value) {
    glift::Iteration iteration(fill_box_06059ad3_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_06059ad3_kernel, memories, iteration.size())) {
        const fill_box_06059ad3_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .base = {},
            .value = value,
        };
        commands.dispatch(fill_box_06059ad3_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_06059ad3_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_06059ad3_direct_parameters parameters = {
            .to_domain = uint3(to->extent(), to->layers()),
            .value = value,
            .to_extent_y = to->extent().y,
        };
        commands.dispatch(fill_box_06059ad3_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_06059ad3_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_06059ad3_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_06059ad3_general_parameters,
            size)})});
    }
}

namespace {
struct read_box_9ab1f796_direct_parameters {
    uint2 from_data_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_9ab1f796_direct_parameters, from_data_extent) == 0);
static_assert(offsetof(read_box_9ab1f796_direct_parameters, to_extent_x) == 8);
struct read_box_9ab1f796_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint to_extent_x;
};
static_assert(offsetof(read_box_9ab1f796_general_parameters, size) == 0);
static_assert(offsetof(read_box_9ab1f796_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_9ab1f796_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_9ab1f796_general_parameters, to_extent_x) == 24);
struct read_box_9ab1f796_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_9ab1f796_wide_parameters, size) == 0);
static_assert(offsetof(read_box_9ab1f796_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_9ab1f796_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_9ab1f796_wide_parameters, base) == 24);
static_assert(offsetof(read_box_9ab1f796_wide_parameters, to_extent_x) == 40);
static_assert(offsetof(read_box_9ab1f796_wide_parameters, to_data_address) == 48);
}  // namespace

extern const glift::Kernel read_box_9ab1f796_kernel;

GLIFT_SHARED void read_box_9ab1f796(const glift::Commands& commands,
    const glift::Range<::std_image::ImageLayer_rgba8>& from, const glift::Range<Box_2_float4>& to) {
    glift::Iteration iteration(read_box_9ab1f796_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(read_box_9ab1f796_kernel, memories, iteration.size())) {
        const read_box_9ab1f796_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_x = std::uint64_t(to->extent().x),
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_9ab1f796_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_9ab1f796_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const read_box_9ab1f796_direct_parameters parameters = {
            .from_data_extent = from->data_extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_9ab1f796_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const read_box_9ab1f796_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_9ab1f796_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_9ab1f796_general_parameters,
            size)})});
    }
}

namespace {
struct write_box_fc1ef9a5_direct_parameters {
    uint2 from_extent;
};
static_assert(offsetof(write_box_fc1ef9a5_direct_parameters, from_extent) == 0);
struct write_box_fc1ef9a5_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
};
static_assert(offsetof(write_box_fc1ef9a5_general_parameters, size) == 0);
static_assert(offsetof(write_box_fc1ef9a5_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_fc1ef9a5_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_fc1ef9a5_general_parameters, from_extent_x) == 24);
struct write_box_fc1ef9a5_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, size) == 0);
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, base) == 24);
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, from_data_address) == 48);
}  // namespace

extern const glift::Kernel write_box_fc1ef9a5_kernel;

GLIFT_SHARED void write_box_fc1ef9a5(const glift::Commands& commands, const glift::Range<Box_2_float4>& from,
    const glift::Range<::std_image::ImageLayer_rgba8>& to) {
    glift::Iteration iteration(write_box_fc1ef9a5_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(write_box_fc1ef9a5_kernel, memories, iteration.size())) {
        const write_box_fc1ef9a5_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = std::uint64_t(from->extent().x),
            .from_data_address = 0u,
        };
        commands.dispatch(write_box_fc1ef9a5_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_fc1ef9a5_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const write_box_fc1ef9a5_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_fc1ef9a5_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const write_box_fc1ef9a5_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
        };
        commands.dispatch(write_box_fc1ef9a5_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_fc1ef9a5_general_parameters,
            size)})});
    }
}

namespace {
struct fill_box_673f66ca_direct_parameters {
    uint2 to_data_extent;
    float4 value;
};
static_assert(offsetof(fill_box_673f66ca_direct_parameters, to_data_extent) == 0);
static_assert(offsetof(fill_box_673f66ca_direct_parameters, value) == 8);
struct fill_box_673f66ca_general_parameters {
    uint2 size;
    uint2 to_origin;
    float4 value;
};
static_assert(offsetof(fill_box_673f66ca_general_parameters, size) == 0);
static_assert(offsetof(fill_box_673f66ca_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_673f66ca_general_parameters, value) == 16);
struct fill_box_673f66ca_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    float4 value;
};
static_assert(offsetof(fill_box_673f66ca_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_673f66ca_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_673f66ca_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_673f66ca_wide_parameters, value) == 28);
}  // namespace

extern const glift::Kernel fill_box_673f66ca_kernel;

GLIFT_SHARED void fill_box_673f66ca(const glift::Commands& commands,
    const glift::Range<::std_image::ImageLayer_rgba8>& to, float4 value) {
    glift::Iteration iteration(fill_box_673f66ca_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_673f66ca_kernel, memories, iteration.size())) {
        const fill_box_673f66ca_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .base = {},
            .value = value,
        };
        commands.dispatch(fill_box_673f66ca_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_673f66ca_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_673f66ca_direct_parameters parameters = {
            .to_data_extent = to->data_extent(),
            .value = value,
        };
        commands.dispatch(fill_box_673f66ca_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_673f66ca_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_673f66ca_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_673f66ca_general_parameters,
            size)})});
    }
}

GLIFT_SHARED Box_2_float::Box_2_float(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Box<2, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Box_2_float::Box_2_float(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box<2, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED uint2 Box_2_float::domain() const {
    return extent_;
}

GLIFT_SHARED bool Box_2_float::same_state(const Box_2_float& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Box_2_float::place(uint2 address) const {
    [[maybe_unused]] const uint2 extent = extent_;
    const auto translate = [&](uint2 va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED Box_3_float4::Box_3_float4(const glift::Commands& commands, uint3 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.allocate({.name = "Box<3, float4>.data", .bytes = glift::buffer_bytes<float4>(data_extent_)})) {}

GLIFT_SHARED Box_3_float4::Box_3_float4(const glift::Commands& commands, uint3 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box<3, float4>.data", .bytes = glift::buffer_bytes<float4>(data_extent_)})) {}

GLIFT_SHARED uint3 Box_3_float4::domain() const {
    return extent_;
}

GLIFT_SHARED bool Box_3_float4::same_state(const Box_3_float4& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Box_3_float4::place(uint3 address) const {
    [[maybe_unused]] const uint3 extent = extent_;
    const auto translate = [&](uint3 va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64_2(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED Box_2_float4::Box_2_float4(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Box<2, float4>.data", .bytes = glift::buffer_bytes<float4>(data_extent_)})) {}

GLIFT_SHARED Box_2_float4::Box_2_float4(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box<2, float4>.data", .bytes = glift::buffer_bytes<float4>(data_extent_)})) {}

GLIFT_SHARED uint2 Box_2_float4::domain() const {
    return extent_;
}

GLIFT_SHARED bool Box_2_float4::same_state(const Box_2_float4& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Box_2_float4::place(uint2 address) const {
    [[maybe_unused]] const uint2 extent = extent_;
    const auto translate = [&](uint2 va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
    };
    return translate(address);
}

}  // namespace std_transfer

