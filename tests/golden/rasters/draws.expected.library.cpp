// Made by gliftc from draws.glift. Changes are lost when it is made again.
#include "draws.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace std_array {

using namespace glift::types;

namespace {

// address.glift:18: volume<1> in 64 bits
inline std::uint64_t volume_64(uint extent) {
    // address.glift:19
    std::uint64_t product = std::uint64_t(extent);
    // address.glift:20
    for (uint axis = 1u; axis < 1u; ++axis) {
        // address.glift:21
        product = glift::saturated_product(product, std::uint64_t(extent));
    }
    // address.glift:23
    return product;
}

// address.glift:27: linearize<1> in 64 bits
inline std::uint64_t linearize_64(uint address, uint extent) {
    // address.glift:28
    std::uint64_t index = std::uint64_t(address);
    // address.glift:29
    for (uint back = 1u; back < 1u; ++back) {
        // address.glift:30
        index = index * std::uint64_t(extent) + std::uint64_t(address);
    }
    // address.glift:32
    return index;
}

// address.glift:18: volume<2> in 64 bits
inline std::uint64_t volume_64_2(uint2 extent) {
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
inline std::uint64_t linearize_64_2(uint2 address, uint2 extent) {
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

}  // namespace

GLIFT_SHARED Array_1_float3_none_buffer::Array_1_float3_none_buffer(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Array<1, float3, none, buffer>.data",
        .bytes = glift::buffer_bytes<float3>(data_extent_)})) {}

GLIFT_SHARED Array_1_float3_none_buffer::Array_1_float3_none_buffer(const glift::Commands& commands, uint extent,
    glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Array<1, float3, none, buffer>.data", .bytes = glift::buffer_bytes<float3>(data_extent_)})) {}

GLIFT_SHARED uint Array_1_float3_none_buffer::domain() const {
    return extent_;
}

GLIFT_SHARED bool Array_1_float3_none_buffer::same_state(const Array_1_float3_none_buffer& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Array_1_float3_none_buffer::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED void Array_1_float3_none_buffer::copy_out(const glift::Commands& commands,
    const glift::Range<Array_1_float3_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_f0d3f0af(commands, range, ::std_transfer::Box_1_float3(commands, range.size(), box));
}

GLIFT_SHARED void Array_1_float3_none_buffer::copy_in(const glift::Commands& commands,
    const glift::Range<Array_1_float3_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_59b2fb2a(commands, ::std_transfer::Box_1_float3(commands, range.size(), box), range);
}

GLIFT_SHARED void Array_1_float3_none_buffer::fill(float3 value,
    const glift::Range<Array_1_float3_none_buffer>& range) {
    ::std_transfer::fill_box_dfa8b7d0(device(), range, value);
}
GLIFT_SHARED void Array_1_float3_none_buffer::fill(float3 value) {
    fill(value, *this);
}

GLIFT_SHARED Array_1_uint_none_buffer::Array_1_uint_none_buffer(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Array<1, uint, none, buffer>.data",
        .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

GLIFT_SHARED Array_1_uint_none_buffer::Array_1_uint_none_buffer(const glift::Commands& commands, uint extent,
    glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Array<1, uint, none, buffer>.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

GLIFT_SHARED uint Array_1_uint_none_buffer::domain() const {
    return extent_;
}

GLIFT_SHARED bool Array_1_uint_none_buffer::same_state(const Array_1_uint_none_buffer& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Array_1_uint_none_buffer::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED void Array_1_uint_none_buffer::copy_out(const glift::Commands& commands,
    const glift::Range<Array_1_uint_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_698f90a1(commands, range, ::std_transfer::Box_1_uint(commands, range.size(), box));
}

GLIFT_SHARED void Array_1_uint_none_buffer::copy_in(const glift::Commands& commands,
    const glift::Range<Array_1_uint_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_920b34ba(commands, ::std_transfer::Box_1_uint(commands, range.size(), box), range);
}

GLIFT_SHARED void Array_1_uint_none_buffer::fill(uint value, const glift::Range<Array_1_uint_none_buffer>& range) {
    ::std_transfer::fill_box_fbf6ae12(device(), range, value);
}
GLIFT_SHARED void Array_1_uint_none_buffer::fill(uint value) {
    fill(value, *this);
}

GLIFT_SHARED Array_2_uint_none_buffer::Array_2_uint_none_buffer(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.allocate({.name = "Array<2, uint, none, buffer>.data",
        .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

GLIFT_SHARED Array_2_uint_none_buffer::Array_2_uint_none_buffer(const glift::Commands& commands, uint2 extent,
    glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Array<2, uint, none, buffer>.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

GLIFT_SHARED uint2 Array_2_uint_none_buffer::domain() const {
    return extent_;
}

GLIFT_SHARED bool Array_2_uint_none_buffer::same_state(const Array_2_uint_none_buffer& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Array_2_uint_none_buffer::place(uint2 address) const {
    [[maybe_unused]] const uint2 extent = extent_;
    const auto translate = [&](uint2 va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64_2(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED void Array_2_uint_none_buffer::copy_out(const glift::Commands& commands,
    const glift::Range<Array_2_uint_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_61c1abfb(commands, range, ::std_transfer::Box_2_uint(commands, range.size(), box));
}

GLIFT_SHARED void Array_2_uint_none_buffer::copy_in(const glift::Commands& commands,
    const glift::Range<Array_2_uint_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_522c64c2(commands, ::std_transfer::Box_2_uint(commands, range.size(), box), range);
}

GLIFT_SHARED void Array_2_uint_none_buffer::fill(uint value, const glift::Range<Array_2_uint_none_buffer>& range) {
    ::std_transfer::fill_box_fa7e631f(device(), range, value);
}
GLIFT_SHARED void Array_2_uint_none_buffer::fill(uint value) {
    fill(value, *this);
}

}  // namespace std_array

namespace std_image {

using namespace glift::types;

namespace {
struct draw_depth_19ff2775_direct_parameters {
    float depth;
};
static_assert(offsetof(draw_depth_19ff2775_direct_parameters, depth) == 0);
struct draw_depth_19ff2775_general_parameters {
    uint2 size;
    uint corner_origin;
    float depth;
};
static_assert(offsetof(draw_depth_19ff2775_general_parameters, size) == 0);
static_assert(offsetof(draw_depth_19ff2775_general_parameters, corner_origin) == 8);
static_assert(offsetof(draw_depth_19ff2775_general_parameters, depth) == 12);
}  // namespace

extern const glift::Kernel draw_depth_19ff2775_kernel;

GLIFT_SHARED void draw_depth_19ff2775(const glift::Commands& commands, const glift::Range<Everything>& corner,
    const glift::Range<Image_d32>& z, float depth) {
    glift::DrawIteration iteration(draw_depth_19ff2775_kernel);
    iteration.corners("corner", corner);
    iteration.depth("z", z, z->data());
    if (iteration.is_whole()) {
        const draw_depth_19ff2775_direct_parameters parameters = {
            .depth = depth,
        };
        commands.dispatch(draw_depth_19ff2775_kernel,
            {.form = glift::FormName::direct, .memories = {}, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .targets = iteration.targets()});
    } else {
        const draw_depth_19ff2775_general_parameters parameters = {
            .size = iteration.counts(),
            .corner_origin = corner.origin(),
            .depth = depth,
        };
        commands.dispatch(draw_depth_19ff2775_kernel,
            {.form = glift::FormName::general, .memories = {}, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(draw_depth_19ff2775_general_parameters,
            size)}), .targets = iteration.targets()});
    }
}

GLIFT_SHARED Image_rgba8::Image_rgba8(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(extent_),
      data_(commands.allocate({.name = "Image<rgba8>.data", .kind = glift::MemoryKind::image2d,
        .format = glift::Format::rgba8, .extent = glift::image_extent(data_extent_)})) {}

GLIFT_SHARED Image_rgba8::Image_rgba8(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(extent_),
      data_(commands.adopt(std::move(data),
        {.name = "Image<rgba8>.data", .kind = glift::MemoryKind::image2d, .format = glift::Format::rgba8,
        .extent = glift::image_extent(data_extent_)})) {}

GLIFT_SHARED uint2 Image_rgba8::domain() const {
    return extent_;
}

GLIFT_SHARED bool Image_rgba8::same_state(const Image_rgba8& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED void Image_rgba8::copy_out(const glift::Commands& commands, const glift::Range<Image_rgba8>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_d09c6321(commands, range, ::std_transfer::Box_2_float4(commands, range.size(), box));
}

GLIFT_SHARED void Image_rgba8::copy_in(const glift::Commands& commands, const glift::Range<Image_rgba8>& range,
    const glift::Memory& box) const {
    ::std_transfer::write_box_c92d8b24(commands, ::std_transfer::Box_2_float4(commands, range.size(), box), range);
}

GLIFT_SHARED void Image_rgba8::fill(float4 value, const glift::Range<Image_rgba8>& range) {
    ::std_transfer::fill_box_9f341825(device(), range, value);
}
GLIFT_SHARED void Image_rgba8::fill(float4 value) {
    fill(value, *this);
}

GLIFT_SHARED Image_d32::Image_d32(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(extent_),
      data_(commands.allocate({.name = "Image<d32>.data", .kind = glift::MemoryKind::image2d,
        .format = glift::Format::d32, .extent = glift::image_extent(data_extent_)})) {}

GLIFT_SHARED Image_d32::Image_d32(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(extent_),
      data_(commands.adopt(std::move(data),
        {.name = "Image<d32>.data", .kind = glift::MemoryKind::image2d, .format = glift::Format::d32,
        .extent = glift::image_extent(data_extent_)})) {}

GLIFT_SHARED uint2 Image_d32::domain() const {
    return extent_;
}

GLIFT_SHARED bool Image_d32::same_state(const Image_d32& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED void Image_d32::copy_out(const glift::Commands& commands, const glift::Range<Image_d32>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_9d8f71b4(commands, range, ::std_transfer::Box_2_float(commands, range.size(), box));
}

GLIFT_SHARED Everything::Everything(uint count)
    : count_(count) {}

GLIFT_SHARED uint Everything::domain() const {
    return count_;
}

GLIFT_SHARED bool Everything::same_state(const Everything& other) const {
    return count_ == other.count_;
}

// image.glift:116: clear_depth<Image<d32>>
GLIFT_SHARED void clear_depth_89866a9c(const glift::Commands& commands, const Image_d32& z, float depth) {
    // image.glift:117
    Everything made(3u);
    draw_depth_19ff2775(commands, made, z, depth);
    made = {};
}

}  // namespace std_image

namespace std_transfer {

using namespace glift::types;

namespace {

// address.glift:18: volume<1> in 64 bits
inline std::uint64_t volume_64(uint extent) {
    // address.glift:19
    std::uint64_t product = std::uint64_t(extent);
    // address.glift:20
    for (uint axis = 1u; axis < 1u; ++axis) {
        // address.glift:21
        product = glift::saturated_product(product, std::uint64_t(extent));
    }
    // address.glift:23
    return product;
}

// address.glift:27: linearize<1> in 64 bits
inline std::uint64_t linearize_64(uint address, uint extent) {
    // address.glift:28
    std::uint64_t index = std::uint64_t(address);
    // address.glift:29
    for (uint back = 1u; back < 1u; ++back) {
        // address.glift:30
        index = index * std::uint64_t(extent) + std::uint64_t(address);
    }
    // address.glift:32
    return index;
}

// address.glift:18: volume<2> in 64 bits
inline std::uint64_t volume_64_2(uint2 extent) {
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
inline std::uint64_t linearize_64_2(uint2 address, uint2 extent) {
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

}  // namespace

namespace {
struct read_box_9d8f71b4_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_9d8f71b4_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_9d8f71b4_direct_parameters, to_extent_x) == 8);
struct read_box_9d8f71b4_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint to_extent_x;
};
static_assert(offsetof(read_box_9d8f71b4_general_parameters, size) == 0);
static_assert(offsetof(read_box_9d8f71b4_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_9d8f71b4_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_9d8f71b4_general_parameters, to_extent_x) == 24);
struct read_box_9d8f71b4_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, size) == 0);
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, base) == 24);
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, to_extent_x) == 40);
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, to_data_address) == 48);
}  // namespace

extern const glift::Kernel read_box_9d8f71b4_kernel;

GLIFT_SHARED void read_box_9d8f71b4(const glift::Commands& commands, const glift::Range<::std_image::Image_d32>& from,
    const glift::Range<Box_2_float>& to) {
    glift::Iteration iteration(read_box_9d8f71b4_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(read_box_9d8f71b4_kernel, memories, iteration.size())) {
        const read_box_9d8f71b4_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_x = std::uint64_t(to->extent().x),
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_9d8f71b4_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_9d8f71b4_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const read_box_9d8f71b4_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_9d8f71b4_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const read_box_9d8f71b4_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_9d8f71b4_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_9d8f71b4_general_parameters,
            size)})});
    }
}

namespace {
struct read_box_698f90a1_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(read_box_698f90a1_direct_parameters, from_extent) == 0);
struct read_box_698f90a1_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_698f90a1_general_parameters, size) == 0);
static_assert(offsetof(read_box_698f90a1_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_698f90a1_general_parameters, to_origin) == 8);
struct read_box_698f90a1_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_698f90a1_wide_parameters, size) == 0);
static_assert(offsetof(read_box_698f90a1_wide_parameters, from_origin) == 4);
static_assert(offsetof(read_box_698f90a1_wide_parameters, to_origin) == 8);
static_assert(offsetof(read_box_698f90a1_wide_parameters, from_data_address) == 16);
static_assert(offsetof(read_box_698f90a1_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel read_box_698f90a1_kernel;

GLIFT_SHARED void read_box_698f90a1(const glift::Commands& commands,
    const glift::Range<::std_array::Array_1_uint_none_buffer>& from, const glift::Range<Box_1_uint>& to) {
    glift::Iteration iteration(read_box_698f90a1_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(read_box_698f90a1_kernel, memories, iteration.size())) {
        const read_box_698f90a1_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_698f90a1_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_698f90a1_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const read_box_698f90a1_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(read_box_698f90a1_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_698f90a1_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(read_box_698f90a1_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_698f90a1_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct write_box_920b34ba_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_920b34ba_direct_parameters, from_extent) == 0);
struct write_box_920b34ba_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_920b34ba_general_parameters, size) == 0);
static_assert(offsetof(write_box_920b34ba_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_920b34ba_general_parameters, to_origin) == 8);
struct write_box_920b34ba_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_920b34ba_wide_parameters, size) == 0);
static_assert(offsetof(write_box_920b34ba_wide_parameters, from_origin) == 4);
static_assert(offsetof(write_box_920b34ba_wide_parameters, to_origin) == 8);
static_assert(offsetof(write_box_920b34ba_wide_parameters, from_data_address) == 16);
static_assert(offsetof(write_box_920b34ba_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel write_box_920b34ba_kernel;

GLIFT_SHARED void write_box_920b34ba(const glift::Commands& commands, const glift::Range<Box_1_uint>& from,
    const glift::Range<::std_array::Array_1_uint_none_buffer>& to) {
    glift::Iteration iteration(write_box_920b34ba_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(write_box_920b34ba_kernel, memories, iteration.size())) {
        const write_box_920b34ba_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(write_box_920b34ba_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_920b34ba_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const write_box_920b34ba_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_920b34ba_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_920b34ba_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(write_box_920b34ba_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_920b34ba_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct fill_box_fbf6ae12_direct_parameters {
    uint to_extent;
    uint value;
};
static_assert(offsetof(fill_box_fbf6ae12_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_fbf6ae12_direct_parameters, value) == 4);
struct fill_box_fbf6ae12_general_parameters {
    uint size;
    uint to_origin;
    uint value;
};
static_assert(offsetof(fill_box_fbf6ae12_general_parameters, size) == 0);
static_assert(offsetof(fill_box_fbf6ae12_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_fbf6ae12_general_parameters, value) == 8);
struct fill_box_fbf6ae12_wide_parameters {
    uint size;
    uint to_origin;
    uint value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_fbf6ae12_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_fbf6ae12_wide_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_fbf6ae12_wide_parameters, value) == 8);
static_assert(offsetof(fill_box_fbf6ae12_wide_parameters, to_data_address) == 16);
}  // namespace

extern const glift::Kernel fill_box_fbf6ae12_kernel;

GLIFT_SHARED void fill_box_fbf6ae12(const glift::Commands& commands,
    const glift::Range<::std_array::Array_1_uint_none_buffer>& to, uint value) {
    glift::Iteration iteration(fill_box_fbf6ae12_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_fbf6ae12_kernel, memories, iteration.size())) {
        const fill_box_fbf6ae12_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
            .to_data_address = 0u,
        };
        commands.dispatch(fill_box_fbf6ae12_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_fbf6ae12_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_fbf6ae12_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_fbf6ae12_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_fbf6ae12_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_fbf6ae12_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_fbf6ae12_general_parameters,
            size)})});
    }
}

namespace {
struct read_box_f0d3f0af_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(read_box_f0d3f0af_direct_parameters, from_extent) == 0);
struct read_box_f0d3f0af_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_f0d3f0af_general_parameters, size) == 0);
static_assert(offsetof(read_box_f0d3f0af_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_f0d3f0af_general_parameters, to_origin) == 8);
struct read_box_f0d3f0af_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_f0d3f0af_wide_parameters, size) == 0);
static_assert(offsetof(read_box_f0d3f0af_wide_parameters, from_origin) == 4);
static_assert(offsetof(read_box_f0d3f0af_wide_parameters, to_origin) == 8);
static_assert(offsetof(read_box_f0d3f0af_wide_parameters, from_data_address) == 16);
static_assert(offsetof(read_box_f0d3f0af_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel read_box_f0d3f0af_kernel;

GLIFT_SHARED void read_box_f0d3f0af(const glift::Commands& commands,
    const glift::Range<::std_array::Array_1_float3_none_buffer>& from, const glift::Range<Box_1_float3>& to) {
    glift::Iteration iteration(read_box_f0d3f0af_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(read_box_f0d3f0af_kernel, memories, iteration.size())) {
        const read_box_f0d3f0af_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_f0d3f0af_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_f0d3f0af_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const read_box_f0d3f0af_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(read_box_f0d3f0af_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_f0d3f0af_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(read_box_f0d3f0af_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_f0d3f0af_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct write_box_59b2fb2a_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_59b2fb2a_direct_parameters, from_extent) == 0);
struct write_box_59b2fb2a_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_59b2fb2a_general_parameters, size) == 0);
static_assert(offsetof(write_box_59b2fb2a_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_59b2fb2a_general_parameters, to_origin) == 8);
struct write_box_59b2fb2a_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_59b2fb2a_wide_parameters, size) == 0);
static_assert(offsetof(write_box_59b2fb2a_wide_parameters, from_origin) == 4);
static_assert(offsetof(write_box_59b2fb2a_wide_parameters, to_origin) == 8);
static_assert(offsetof(write_box_59b2fb2a_wide_parameters, from_data_address) == 16);
static_assert(offsetof(write_box_59b2fb2a_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel write_box_59b2fb2a_kernel;

GLIFT_SHARED void write_box_59b2fb2a(const glift::Commands& commands, const glift::Range<Box_1_float3>& from,
    const glift::Range<::std_array::Array_1_float3_none_buffer>& to) {
    glift::Iteration iteration(write_box_59b2fb2a_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(write_box_59b2fb2a_kernel, memories, iteration.size())) {
        const write_box_59b2fb2a_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(write_box_59b2fb2a_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_59b2fb2a_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const write_box_59b2fb2a_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_59b2fb2a_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_59b2fb2a_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(write_box_59b2fb2a_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_59b2fb2a_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct fill_box_dfa8b7d0_direct_parameters {
    uint to_extent;
    float3 value;
};
static_assert(offsetof(fill_box_dfa8b7d0_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_dfa8b7d0_direct_parameters, value) == 4);
struct fill_box_dfa8b7d0_general_parameters {
    uint size;
    uint to_origin;
    float3 value;
};
static_assert(offsetof(fill_box_dfa8b7d0_general_parameters, size) == 0);
static_assert(offsetof(fill_box_dfa8b7d0_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_dfa8b7d0_general_parameters, value) == 8);
struct fill_box_dfa8b7d0_wide_parameters {
    uint size;
    uint to_origin;
    float3 value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_dfa8b7d0_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_dfa8b7d0_wide_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_dfa8b7d0_wide_parameters, value) == 8);
static_assert(offsetof(fill_box_dfa8b7d0_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel fill_box_dfa8b7d0_kernel;

GLIFT_SHARED void fill_box_dfa8b7d0(const glift::Commands& commands,
    const glift::Range<::std_array::Array_1_float3_none_buffer>& to, float3 value) {
    glift::Iteration iteration(fill_box_dfa8b7d0_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_dfa8b7d0_kernel, memories, iteration.size())) {
        const fill_box_dfa8b7d0_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
            .to_data_address = 0u,
        };
        commands.dispatch(fill_box_dfa8b7d0_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_dfa8b7d0_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_dfa8b7d0_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_dfa8b7d0_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_dfa8b7d0_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_dfa8b7d0_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_dfa8b7d0_general_parameters,
            size)})});
    }
}

namespace {
struct read_box_d09c6321_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_d09c6321_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_d09c6321_direct_parameters, to_extent_x) == 8);
struct read_box_d09c6321_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint to_extent_x;
};
static_assert(offsetof(read_box_d09c6321_general_parameters, size) == 0);
static_assert(offsetof(read_box_d09c6321_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_d09c6321_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_d09c6321_general_parameters, to_extent_x) == 24);
struct read_box_d09c6321_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_d09c6321_wide_parameters, size) == 0);
static_assert(offsetof(read_box_d09c6321_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_d09c6321_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_d09c6321_wide_parameters, base) == 24);
static_assert(offsetof(read_box_d09c6321_wide_parameters, to_extent_x) == 40);
static_assert(offsetof(read_box_d09c6321_wide_parameters, to_data_address) == 48);
}  // namespace

extern const glift::Kernel read_box_d09c6321_kernel;

GLIFT_SHARED void read_box_d09c6321(const glift::Commands& commands, const glift::Range<::std_image::Image_rgba8>& from,
    const glift::Range<Box_2_float4>& to) {
    glift::Iteration iteration(read_box_d09c6321_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(read_box_d09c6321_kernel, memories, iteration.size())) {
        const read_box_d09c6321_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_x = std::uint64_t(to->extent().x),
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_d09c6321_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_d09c6321_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const read_box_d09c6321_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_d09c6321_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const read_box_d09c6321_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_d09c6321_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_d09c6321_general_parameters,
            size)})});
    }
}

namespace {
struct write_box_c92d8b24_direct_parameters {
    uint2 from_extent;
};
static_assert(offsetof(write_box_c92d8b24_direct_parameters, from_extent) == 0);
struct write_box_c92d8b24_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
};
static_assert(offsetof(write_box_c92d8b24_general_parameters, size) == 0);
static_assert(offsetof(write_box_c92d8b24_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_c92d8b24_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_c92d8b24_general_parameters, from_extent_x) == 24);
struct write_box_c92d8b24_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_c92d8b24_wide_parameters, size) == 0);
static_assert(offsetof(write_box_c92d8b24_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_c92d8b24_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_c92d8b24_wide_parameters, base) == 24);
static_assert(offsetof(write_box_c92d8b24_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_c92d8b24_wide_parameters, from_data_address) == 48);
}  // namespace

extern const glift::Kernel write_box_c92d8b24_kernel;

GLIFT_SHARED void write_box_c92d8b24(const glift::Commands& commands, const glift::Range<Box_2_float4>& from,
    const glift::Range<::std_image::Image_rgba8>& to) {
    glift::Iteration iteration(write_box_c92d8b24_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(write_box_c92d8b24_kernel, memories, iteration.size())) {
        const write_box_c92d8b24_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = std::uint64_t(from->extent().x),
            .from_data_address = 0u,
        };
        commands.dispatch(write_box_c92d8b24_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_c92d8b24_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const write_box_c92d8b24_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_c92d8b24_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const write_box_c92d8b24_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
        };
        commands.dispatch(write_box_c92d8b24_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_c92d8b24_general_parameters,
            size)})});
    }
}

namespace {
struct fill_box_9f341825_direct_parameters {
    uint2 to_extent;
    float4 value;
};
static_assert(offsetof(fill_box_9f341825_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_9f341825_direct_parameters, value) == 8);
struct fill_box_9f341825_general_parameters {
    uint2 size;
    uint2 to_origin;
    float4 value;
};
static_assert(offsetof(fill_box_9f341825_general_parameters, size) == 0);
static_assert(offsetof(fill_box_9f341825_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_9f341825_general_parameters, value) == 16);
struct fill_box_9f341825_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    float4 value;
};
static_assert(offsetof(fill_box_9f341825_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_9f341825_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_9f341825_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_9f341825_wide_parameters, value) == 28);
}  // namespace

extern const glift::Kernel fill_box_9f341825_kernel;

GLIFT_SHARED void fill_box_9f341825(const glift::Commands& commands, const glift::Range<::std_image::Image_rgba8>& to,
    float4 value) {
    glift::Iteration iteration(fill_box_9f341825_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_9f341825_kernel, memories, iteration.size())) {
        const fill_box_9f341825_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .base = {},
            .value = value,
        };
        commands.dispatch(fill_box_9f341825_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_9f341825_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_9f341825_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_9f341825_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_9f341825_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_9f341825_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_9f341825_general_parameters,
            size)})});
    }
}

namespace {
struct read_box_61c1abfb_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_61c1abfb_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_61c1abfb_direct_parameters, to_extent_x) == 8);
struct read_box_61c1abfb_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
    uint to_extent_x;
};
static_assert(offsetof(read_box_61c1abfb_general_parameters, size) == 0);
static_assert(offsetof(read_box_61c1abfb_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_61c1abfb_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_61c1abfb_general_parameters, from_extent_x) == 24);
static_assert(offsetof(read_box_61c1abfb_general_parameters, to_extent_x) == 28);
struct read_box_61c1abfb_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t to_extent_x;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_61c1abfb_wide_parameters, size) == 0);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, base) == 24);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, to_extent_x) == 48);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, from_data_address) == 56);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, to_data_address) == 64);
}  // namespace

extern const glift::Kernel read_box_61c1abfb_kernel;

GLIFT_SHARED void read_box_61c1abfb(const glift::Commands& commands,
    const glift::Range<::std_array::Array_2_uint_none_buffer>& from, const glift::Range<Box_2_uint>& to) {
    glift::Iteration iteration(read_box_61c1abfb_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(read_box_61c1abfb_kernel, memories, iteration.size())) {
        const read_box_61c1abfb_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = std::uint64_t(from->extent().x),
            .to_extent_x = std::uint64_t(to->extent().x),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_61c1abfb_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_61c1abfb_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const read_box_61c1abfb_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_61c1abfb_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_61c1abfb_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_61c1abfb_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_61c1abfb_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct write_box_522c64c2_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(write_box_522c64c2_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_522c64c2_direct_parameters, to_extent_x) == 8);
struct write_box_522c64c2_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
    uint to_extent_x;
};
static_assert(offsetof(write_box_522c64c2_general_parameters, size) == 0);
static_assert(offsetof(write_box_522c64c2_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_522c64c2_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_522c64c2_general_parameters, from_extent_x) == 24);
static_assert(offsetof(write_box_522c64c2_general_parameters, to_extent_x) == 28);
struct write_box_522c64c2_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t to_extent_x;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_522c64c2_wide_parameters, size) == 0);
static_assert(offsetof(write_box_522c64c2_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_522c64c2_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_522c64c2_wide_parameters, base) == 24);
static_assert(offsetof(write_box_522c64c2_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_522c64c2_wide_parameters, to_extent_x) == 48);
static_assert(offsetof(write_box_522c64c2_wide_parameters, from_data_address) == 56);
static_assert(offsetof(write_box_522c64c2_wide_parameters, to_data_address) == 64);
}  // namespace

extern const glift::Kernel write_box_522c64c2_kernel;

GLIFT_SHARED void write_box_522c64c2(const glift::Commands& commands, const glift::Range<Box_2_uint>& from,
    const glift::Range<::std_array::Array_2_uint_none_buffer>& to) {
    glift::Iteration iteration(write_box_522c64c2_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(write_box_522c64c2_kernel, memories, iteration.size())) {
        const write_box_522c64c2_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = std::uint64_t(from->extent().x),
            .to_extent_x = std::uint64_t(to->extent().x),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(write_box_522c64c2_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_522c64c2_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const write_box_522c64c2_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(write_box_522c64c2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_522c64c2_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(write_box_522c64c2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_522c64c2_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct fill_box_fa7e631f_direct_parameters {
    uint2 to_extent;
    uint value;
};
static_assert(offsetof(fill_box_fa7e631f_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_fa7e631f_direct_parameters, value) == 8);
struct fill_box_fa7e631f_general_parameters {
    uint2 size;
    uint2 to_origin;
    uint to_extent_x;
    uint value;
};
static_assert(offsetof(fill_box_fa7e631f_general_parameters, size) == 0);
static_assert(offsetof(fill_box_fa7e631f_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_fa7e631f_general_parameters, to_extent_x) == 16);
static_assert(offsetof(fill_box_fa7e631f_general_parameters, value) == 20);
struct fill_box_fa7e631f_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    uint value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, to_extent_x) == 32);
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, value) == 40);
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, to_data_address) == 48);
}  // namespace

extern const glift::Kernel fill_box_fa7e631f_kernel;

GLIFT_SHARED void fill_box_fa7e631f(const glift::Commands& commands,
    const glift::Range<::std_array::Array_2_uint_none_buffer>& to, uint value) {
    glift::Iteration iteration(fill_box_fa7e631f_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_fa7e631f_kernel, memories, iteration.size())) {
        const fill_box_fa7e631f_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_x = std::uint64_t(to->extent().x),
            .value = value,
            .to_data_address = 0u,
        };
        commands.dispatch(fill_box_fa7e631f_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_fa7e631f_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_fa7e631f_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_fa7e631f_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_fa7e631f_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_extent_x = to->extent().x,
            .value = value,
        };
        commands.dispatch(fill_box_fa7e631f_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_fa7e631f_general_parameters,
            size)})});
    }
}

GLIFT_SHARED Box_1_float3::Box_1_float3(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Box<1, float3>.data", .bytes = glift::buffer_bytes<float3>(data_extent_)})) {}

GLIFT_SHARED Box_1_float3::Box_1_float3(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box<1, float3>.data", .bytes = glift::buffer_bytes<float3>(data_extent_)})) {}

GLIFT_SHARED uint Box_1_float3::domain() const {
    return extent_;
}

GLIFT_SHARED bool Box_1_float3::same_state(const Box_1_float3& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Box_1_float3::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED Box_1_uint::Box_1_uint(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Box<1, uint>.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

GLIFT_SHARED Box_1_uint::Box_1_uint(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box<1, uint>.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

GLIFT_SHARED uint Box_1_uint::domain() const {
    return extent_;
}

GLIFT_SHARED bool Box_1_uint::same_state(const Box_1_uint& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Box_1_uint::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED Box_2_float4::Box_2_float4(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.allocate({.name = "Box<2, float4>.data", .bytes = glift::buffer_bytes<float4>(data_extent_)})) {}

GLIFT_SHARED Box_2_float4::Box_2_float4(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
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
        return linearize_64_2(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED Box_2_float::Box_2_float(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.allocate({.name = "Box<2, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Box_2_float::Box_2_float(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
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
        return linearize_64_2(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED Box_2_uint::Box_2_uint(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.allocate({.name = "Box<2, uint>.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

GLIFT_SHARED Box_2_uint::Box_2_uint(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box<2, uint>.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

GLIFT_SHARED uint2 Box_2_uint::domain() const {
    return extent_;
}

GLIFT_SHARED bool Box_2_uint::same_state(const Box_2_uint& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Box_2_uint::place(uint2 address) const {
    [[maybe_unused]] const uint2 extent = extent_;
    const auto translate = [&](uint2 va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64_2(va, extent);
    };
    return translate(address);
}

}  // namespace std_transfer

