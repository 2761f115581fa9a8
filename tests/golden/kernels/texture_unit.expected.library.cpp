// Made by gliftc from texture_unit.glift. Changes are lost when it is made again.
#include "texture_unit.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace std_array {

using namespace glift::types;

namespace {

// fold.glift:23: fold_width in 64 bits
inline std::uint64_t fold_width_64(std::uint64_t count) {
    // fold.glift:24
    std::uint64_t width = std::uint64_t{1u};
    // fold.glift:25
    for (uint step = 0u; step < 16u; ++step) {
        // fold.glift:26
        if (glift::saturated_product(width, width) < count) {
            // fold.glift:27
            width = glift::saturated_product(width, std::uint64_t{2u});
        }
    }
    // fold.glift:30
    return width;
}

// address.glift:53: div_ceil<1> in 64 bits
inline std::uint64_t div_ceil_64(std::uint64_t a, std::uint64_t b) {
    // address.glift:54
    const std::uint64_t any = glift::min(a, std::uint64_t{1u});
    // address.glift:55
    return glift::saturated_sum(glift::divide(a - any, b), any);
}

// fold.glift:34: fold_extent in 64 bits
inline glift::vec<std::uint64_t, 2> fold_extent_64(std::uint64_t count) {
    // fold.glift:35
    const std::uint64_t width = fold_width_64(count);
    // fold.glift:36
    return glift::vec<std::uint64_t, 2>(width, glift::max(div_ceil_64(count, width), std::uint64_t{1u}));
}

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

// address.glift:18: volume<1> in 64 bits
inline std::uint64_t volume_64_2(uint extent) {
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

}  // namespace

GLIFT_SHARED Array_2_uint_none_image2d::Array_2_uint_none_image2d(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(glift::fitted(fold_extent_64(volume_64(extent_)), "Array<2, uint, none, image2d>.data")),
      data_(commands.allocate({.name = "Array<2, uint, none, image2d>.data", .kind = glift::MemoryKind::image2d,
        .format = glift::Format::r32ui, .extent = glift::image_extent(data_extent_)})) {}

GLIFT_SHARED Array_2_uint_none_image2d::Array_2_uint_none_image2d(const glift::Commands& commands, uint2 extent,
    glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(glift::fitted(fold_extent_64(volume_64(extent_)), "Array<2, uint, none, image2d>.data")),
      data_(commands.adopt(std::move(data),
        {.name = "Array<2, uint, none, image2d>.data", .kind = glift::MemoryKind::image2d,
        .format = glift::Format::r32ui, .extent = glift::image_extent(data_extent_)})) {}

GLIFT_SHARED uint2 Array_2_uint_none_image2d::domain() const {
    return extent_;
}

GLIFT_SHARED bool Array_2_uint_none_image2d::same_state(const Array_2_uint_none_image2d& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED void Array_2_uint_none_image2d::copy_out(const glift::Commands& commands,
    const glift::Range<Array_2_uint_none_image2d>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_92f4ce80(commands, range, ::std_transfer::Box_2_uint(commands, range.size(), box));
}

GLIFT_SHARED void Array_2_uint_none_image2d::copy_in(const glift::Commands& commands,
    const glift::Range<Array_2_uint_none_image2d>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_99148957(commands, ::std_transfer::Box_2_uint(commands, range.size(), box), range);
}

GLIFT_SHARED void Array_2_uint_none_image2d::fill(uint value, const glift::Range<Array_2_uint_none_image2d>& range) {
    ::std_transfer::fill_box_1b4fd378(device(), range, value);
}
GLIFT_SHARED void Array_2_uint_none_image2d::fill(uint value) {
    fill(value, *this);
}

GLIFT_SHARED Array_1_float3_none_buffer::Array_1_float3_none_buffer(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.allocate({.name = "Array<1, float3, none, buffer>.data",
        .bytes = glift::buffer_bytes<float3>(data_extent_)})) {}

GLIFT_SHARED Array_1_float3_none_buffer::Array_1_float3_none_buffer(const glift::Commands& commands, uint extent,
    glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
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

GLIFT_SHARED Array_1_float_none_buffer::Array_1_float_none_buffer(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.allocate({.name = "Array<1, float, none, buffer>.data",
        .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Array_1_float_none_buffer::Array_1_float_none_buffer(const glift::Commands& commands, uint extent,
    glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Array<1, float, none, buffer>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED uint Array_1_float_none_buffer::domain() const {
    return extent_;
}

GLIFT_SHARED bool Array_1_float_none_buffer::same_state(const Array_1_float_none_buffer& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Array_1_float_none_buffer::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED void Array_1_float_none_buffer::copy_out(const glift::Commands& commands,
    const glift::Range<Array_1_float_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_679e2ba9(commands, range, ::std_transfer::Box_1_float(commands, range.size(), box));
}

GLIFT_SHARED void Array_1_float_none_buffer::copy_in(const glift::Commands& commands,
    const glift::Range<Array_1_float_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_7a558d52(commands, ::std_transfer::Box_1_float(commands, range.size(), box), range);
}

GLIFT_SHARED void Array_1_float_none_buffer::fill(float value, const glift::Range<Array_1_float_none_buffer>& range) {
    ::std_transfer::fill_box_4fb0cc86(device(), range, value);
}
GLIFT_SHARED void Array_1_float_none_buffer::fill(float value) {
    fill(value, *this);
}

}  // namespace std_array

namespace std_transfer {

using namespace glift::types;

namespace {

// address.glift:18: volume<3> in 64 bits
inline std::uint64_t volume_64(uint3 extent) {
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
inline std::uint64_t linearize_64(uint3 address, uint3 extent) {
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

// address.glift:18: volume<1> in 64 bits
inline std::uint64_t volume_64_3(uint extent) {
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
inline std::uint64_t linearize_64_3(uint address, uint extent) {
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

}  // namespace

namespace {
struct read_box_89e7a8a0_direct_parameters {
    uint3 from_domain;
    uint3 to_extent;
    uint from_extent_y;
};
static_assert(offsetof(read_box_89e7a8a0_direct_parameters, from_domain) == 0);
static_assert(offsetof(read_box_89e7a8a0_direct_parameters, to_extent) == 12);
static_assert(offsetof(read_box_89e7a8a0_direct_parameters, from_extent_y) == 24);
struct read_box_89e7a8a0_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 to_extent;
};
static_assert(offsetof(read_box_89e7a8a0_general_parameters, size) == 0);
static_assert(offsetof(read_box_89e7a8a0_general_parameters, from_origin) == 12);
static_assert(offsetof(read_box_89e7a8a0_general_parameters, to_origin) == 24);
static_assert(offsetof(read_box_89e7a8a0_general_parameters, to_extent) == 36);
struct read_box_89e7a8a0_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    std::uint64_t to_extent_y;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_89e7a8a0_wide_parameters, size) == 0);
static_assert(offsetof(read_box_89e7a8a0_wide_parameters, from_origin) == 12);
static_assert(offsetof(read_box_89e7a8a0_wide_parameters, to_origin) == 24);
static_assert(offsetof(read_box_89e7a8a0_wide_parameters, base) == 36);
static_assert(offsetof(read_box_89e7a8a0_wide_parameters, to_extent_y) == 48);
static_assert(offsetof(read_box_89e7a8a0_wide_parameters, to_extent_x) == 56);
static_assert(offsetof(read_box_89e7a8a0_wide_parameters, to_data_address) == 64);
}  // namespace

extern const glift::Kernel read_box_89e7a8a0_kernel;

GLIFT_SHARED void read_box_89e7a8a0(const glift::Commands& commands, const glift::Range<::texture_unit::Shadows>& from,
    const glift::Range<Box_3_float>& to) {
    glift::Iteration iteration(read_box_89e7a8a0_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->depths(), to->data()};
    if (commands.needs_wide(read_box_89e7a8a0_kernel, memories, iteration.size())) {
        const read_box_89e7a8a0_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_y = std::uint64_t(to->extent().y),
            .to_extent_x = std::uint64_t(to->extent().x),
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_89e7a8a0_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_89e7a8a0_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const read_box_89e7a8a0_direct_parameters parameters = {
            .from_domain = uint3(from->extent(), from->layers()),
            .to_extent = to->extent(),
            .from_extent_y = from->extent().y,
        };
        commands.dispatch(read_box_89e7a8a0_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const read_box_89e7a8a0_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_extent = to->extent(),
        };
        commands.dispatch(read_box_89e7a8a0_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_89e7a8a0_general_parameters,
            size)})});
    }
}

namespace {
struct read_box_0976d8f6_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_0976d8f6_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_0976d8f6_direct_parameters, to_extent_x) == 8);
struct read_box_0976d8f6_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint to_extent_x;
};
static_assert(offsetof(read_box_0976d8f6_general_parameters, size) == 0);
static_assert(offsetof(read_box_0976d8f6_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_0976d8f6_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_0976d8f6_general_parameters, to_extent_x) == 24);
struct read_box_0976d8f6_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_0976d8f6_wide_parameters, size) == 0);
static_assert(offsetof(read_box_0976d8f6_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_0976d8f6_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_0976d8f6_wide_parameters, base) == 24);
static_assert(offsetof(read_box_0976d8f6_wide_parameters, to_extent_x) == 40);
static_assert(offsetof(read_box_0976d8f6_wide_parameters, to_data_address) == 48);
}  // namespace

extern const glift::Kernel read_box_0976d8f6_kernel;

GLIFT_SHARED void read_box_0976d8f6(const glift::Commands& commands, const glift::Range<::texture_unit::Heights>& from,
    const glift::Range<Box_2_float>& to) {
    glift::Iteration iteration(read_box_0976d8f6_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(read_box_0976d8f6_kernel, memories, iteration.size())) {
        const read_box_0976d8f6_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_x = std::uint64_t(to->extent().x),
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_0976d8f6_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_0976d8f6_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const read_box_0976d8f6_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_0976d8f6_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const read_box_0976d8f6_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_0976d8f6_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_0976d8f6_general_parameters,
            size)})});
    }
}

namespace {
struct write_box_c1315537_direct_parameters {
    uint2 from_extent;
};
static_assert(offsetof(write_box_c1315537_direct_parameters, from_extent) == 0);
struct write_box_c1315537_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
};
static_assert(offsetof(write_box_c1315537_general_parameters, size) == 0);
static_assert(offsetof(write_box_c1315537_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_c1315537_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_c1315537_general_parameters, from_extent_x) == 24);
struct write_box_c1315537_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_c1315537_wide_parameters, size) == 0);
static_assert(offsetof(write_box_c1315537_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_c1315537_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_c1315537_wide_parameters, base) == 24);
static_assert(offsetof(write_box_c1315537_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_c1315537_wide_parameters, from_data_address) == 48);
}  // namespace

extern const glift::Kernel write_box_c1315537_kernel;

GLIFT_SHARED void write_box_c1315537(const glift::Commands& commands, const glift::Range<Box_2_float>& from,
    const glift::Range<::texture_unit::Heights>& to) {
    glift::Iteration iteration(write_box_c1315537_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(write_box_c1315537_kernel, memories, iteration.size())) {
        const write_box_c1315537_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = std::uint64_t(from->extent().x),
            .from_data_address = 0u,
        };
        commands.dispatch(write_box_c1315537_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_c1315537_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const write_box_c1315537_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_c1315537_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const write_box_c1315537_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
        };
        commands.dispatch(write_box_c1315537_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_c1315537_general_parameters,
            size)})});
    }
}

namespace {
struct fill_box_7c95e848_direct_parameters {
    uint2 to_extent;
    float value;
};
static_assert(offsetof(fill_box_7c95e848_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_7c95e848_direct_parameters, value) == 8);
struct fill_box_7c95e848_general_parameters {
    uint2 size;
    uint2 to_origin;
    float value;
};
static_assert(offsetof(fill_box_7c95e848_general_parameters, size) == 0);
static_assert(offsetof(fill_box_7c95e848_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_7c95e848_general_parameters, value) == 16);
struct fill_box_7c95e848_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    float value;
};
static_assert(offsetof(fill_box_7c95e848_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_7c95e848_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_7c95e848_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_7c95e848_wide_parameters, value) == 28);
}  // namespace

extern const glift::Kernel fill_box_7c95e848_kernel;

GLIFT_SHARED void fill_box_7c95e848(const glift::Commands& commands, const glift::Range<::texture_unit::Heights>& to,
    float value) {
    glift::Iteration iteration(fill_box_7c95e848_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_7c95e848_kernel, memories, iteration.size())) {
        const fill_box_7c95e848_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .base = {},
            .value = value,
        };
        commands.dispatch(fill_box_7c95e848_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_7c95e848_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_7c95e848_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_7c95e848_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_7c95e848_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_7c95e848_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_7c95e848_general_parameters,
            size)})});
    }
}

namespace {
struct read_box_92f4ce80_direct_parameters {
    uint2 from_extent;
    uint from_data_extent_x;
    uint to_extent_x;
};
static_assert(offsetof(read_box_92f4ce80_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_92f4ce80_direct_parameters, from_data_extent_x) == 8);
static_assert(offsetof(read_box_92f4ce80_direct_parameters, to_extent_x) == 12);
struct read_box_92f4ce80_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
    uint from_data_extent_x;
    uint to_extent_x;
};
static_assert(offsetof(read_box_92f4ce80_general_parameters, size) == 0);
static_assert(offsetof(read_box_92f4ce80_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_92f4ce80_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_92f4ce80_general_parameters, from_extent_x) == 24);
static_assert(offsetof(read_box_92f4ce80_general_parameters, from_data_extent_x) == 28);
static_assert(offsetof(read_box_92f4ce80_general_parameters, to_extent_x) == 32);
struct read_box_92f4ce80_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    uint from_extent_x;
    uint from_data_extent_x;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_92f4ce80_wide_parameters, size) == 0);
static_assert(offsetof(read_box_92f4ce80_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_92f4ce80_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_92f4ce80_wide_parameters, base) == 24);
static_assert(offsetof(read_box_92f4ce80_wide_parameters, from_extent_x) == 36);
static_assert(offsetof(read_box_92f4ce80_wide_parameters, from_data_extent_x) == 40);
static_assert(offsetof(read_box_92f4ce80_wide_parameters, to_extent_x) == 48);
static_assert(offsetof(read_box_92f4ce80_wide_parameters, to_data_address) == 56);
}  // namespace

extern const glift::Kernel read_box_92f4ce80_kernel;

GLIFT_SHARED void read_box_92f4ce80(const glift::Commands& commands,
    const glift::Range<::std_array::Array_2_uint_none_image2d>& from, const glift::Range<Box_2_uint>& to) {
    glift::Iteration iteration(read_box_92f4ce80_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(read_box_92f4ce80_kernel, memories, iteration.size())) {
        const read_box_92f4ce80_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = from->extent().x,
            .from_data_extent_x = glift::max(from->data_extent().x, 1u),
            .to_extent_x = std::uint64_t(to->extent().x),
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_92f4ce80_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_92f4ce80_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const read_box_92f4ce80_direct_parameters parameters = {
            .from_extent = from->extent(),
            .from_data_extent_x = glift::max(from->data_extent().x, 1u),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_92f4ce80_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const read_box_92f4ce80_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
            .from_data_extent_x = glift::max(from->data_extent().x, 1u),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_92f4ce80_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_92f4ce80_general_parameters,
            size)})});
    }
}

namespace {
struct write_box_99148957_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
    uint to_data_extent_x;
};
static_assert(offsetof(write_box_99148957_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_99148957_direct_parameters, to_extent_x) == 8);
static_assert(offsetof(write_box_99148957_direct_parameters, to_data_extent_x) == 12);
struct write_box_99148957_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
    uint to_extent_x;
    uint to_data_extent_x;
};
static_assert(offsetof(write_box_99148957_general_parameters, size) == 0);
static_assert(offsetof(write_box_99148957_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_99148957_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_99148957_general_parameters, from_extent_x) == 24);
static_assert(offsetof(write_box_99148957_general_parameters, to_extent_x) == 28);
static_assert(offsetof(write_box_99148957_general_parameters, to_data_extent_x) == 32);
struct write_box_99148957_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    uint to_extent_x;
    uint to_data_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_99148957_wide_parameters, size) == 0);
static_assert(offsetof(write_box_99148957_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_99148957_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_99148957_wide_parameters, base) == 24);
static_assert(offsetof(write_box_99148957_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_99148957_wide_parameters, to_extent_x) == 48);
static_assert(offsetof(write_box_99148957_wide_parameters, to_data_extent_x) == 52);
static_assert(offsetof(write_box_99148957_wide_parameters, from_data_address) == 56);
}  // namespace

extern const glift::Kernel write_box_99148957_kernel;

GLIFT_SHARED void write_box_99148957(const glift::Commands& commands, const glift::Range<Box_2_uint>& from,
    const glift::Range<::std_array::Array_2_uint_none_image2d>& to) {
    glift::Iteration iteration(write_box_99148957_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (commands.needs_wide(write_box_99148957_kernel, memories, iteration.size())) {
        const write_box_99148957_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = std::uint64_t(from->extent().x),
            .to_extent_x = to->extent().x,
            .to_data_extent_x = glift::max(to->data_extent().x, 1u),
            .from_data_address = 0u,
        };
        commands.dispatch(write_box_99148957_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_99148957_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const write_box_99148957_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_x = to->extent().x,
            .to_data_extent_x = glift::max(to->data_extent().x, 1u),
        };
        commands.dispatch(write_box_99148957_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const write_box_99148957_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
            .to_extent_x = to->extent().x,
            .to_data_extent_x = glift::max(to->data_extent().x, 1u),
        };
        commands.dispatch(write_box_99148957_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_99148957_general_parameters,
            size)})});
    }
}

namespace {
struct fill_box_1b4fd378_direct_parameters {
    uint2 to_extent;
    uint to_data_extent_x;
    uint value;
};
static_assert(offsetof(fill_box_1b4fd378_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_1b4fd378_direct_parameters, to_data_extent_x) == 8);
static_assert(offsetof(fill_box_1b4fd378_direct_parameters, value) == 12);
struct fill_box_1b4fd378_general_parameters {
    uint2 size;
    uint2 to_origin;
    uint to_extent_x;
    uint to_data_extent_x;
    uint value;
};
static_assert(offsetof(fill_box_1b4fd378_general_parameters, size) == 0);
static_assert(offsetof(fill_box_1b4fd378_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_1b4fd378_general_parameters, to_extent_x) == 16);
static_assert(offsetof(fill_box_1b4fd378_general_parameters, to_data_extent_x) == 20);
static_assert(offsetof(fill_box_1b4fd378_general_parameters, value) == 24);
struct fill_box_1b4fd378_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    uint to_extent_x;
    uint to_data_extent_x;
    uint value;
};
static_assert(offsetof(fill_box_1b4fd378_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_1b4fd378_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_1b4fd378_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_1b4fd378_wide_parameters, to_extent_x) == 28);
static_assert(offsetof(fill_box_1b4fd378_wide_parameters, to_data_extent_x) == 32);
static_assert(offsetof(fill_box_1b4fd378_wide_parameters, value) == 36);
}  // namespace

extern const glift::Kernel fill_box_1b4fd378_kernel;

GLIFT_SHARED void fill_box_1b4fd378(const glift::Commands& commands,
    const glift::Range<::std_array::Array_2_uint_none_image2d>& to, uint value) {
    glift::Iteration iteration(fill_box_1b4fd378_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_1b4fd378_kernel, memories, iteration.size())) {
        const fill_box_1b4fd378_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_x = to->extent().x,
            .to_data_extent_x = glift::max(to->data_extent().x, 1u),
            .value = value,
        };
        commands.dispatch(fill_box_1b4fd378_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_1b4fd378_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_1b4fd378_direct_parameters parameters = {
            .to_extent = to->extent(),
            .to_data_extent_x = glift::max(to->data_extent().x, 1u),
            .value = value,
        };
        commands.dispatch(fill_box_1b4fd378_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_1b4fd378_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_extent_x = to->extent().x,
            .to_data_extent_x = glift::max(to->data_extent().x, 1u),
            .value = value,
        };
        commands.dispatch(fill_box_1b4fd378_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_1b4fd378_general_parameters,
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
struct read_box_679e2ba9_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(read_box_679e2ba9_direct_parameters, from_extent) == 0);
struct read_box_679e2ba9_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_679e2ba9_general_parameters, size) == 0);
static_assert(offsetof(read_box_679e2ba9_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_679e2ba9_general_parameters, to_origin) == 8);
struct read_box_679e2ba9_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_679e2ba9_wide_parameters, size) == 0);
static_assert(offsetof(read_box_679e2ba9_wide_parameters, from_origin) == 4);
static_assert(offsetof(read_box_679e2ba9_wide_parameters, to_origin) == 8);
static_assert(offsetof(read_box_679e2ba9_wide_parameters, from_data_address) == 16);
static_assert(offsetof(read_box_679e2ba9_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel read_box_679e2ba9_kernel;

GLIFT_SHARED void read_box_679e2ba9(const glift::Commands& commands,
    const glift::Range<::std_array::Array_1_float_none_buffer>& from, const glift::Range<Box_1_float>& to) {
    glift::Iteration iteration(read_box_679e2ba9_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(read_box_679e2ba9_kernel, memories, iteration.size())) {
        const read_box_679e2ba9_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_679e2ba9_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_679e2ba9_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const read_box_679e2ba9_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(read_box_679e2ba9_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_679e2ba9_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(read_box_679e2ba9_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_679e2ba9_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct write_box_7a558d52_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_7a558d52_direct_parameters, from_extent) == 0);
struct write_box_7a558d52_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_7a558d52_general_parameters, size) == 0);
static_assert(offsetof(write_box_7a558d52_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_7a558d52_general_parameters, to_origin) == 8);
struct write_box_7a558d52_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_7a558d52_wide_parameters, size) == 0);
static_assert(offsetof(write_box_7a558d52_wide_parameters, from_origin) == 4);
static_assert(offsetof(write_box_7a558d52_wide_parameters, to_origin) == 8);
static_assert(offsetof(write_box_7a558d52_wide_parameters, from_data_address) == 16);
static_assert(offsetof(write_box_7a558d52_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel write_box_7a558d52_kernel;

GLIFT_SHARED void write_box_7a558d52(const glift::Commands& commands, const glift::Range<Box_1_float>& from,
    const glift::Range<::std_array::Array_1_float_none_buffer>& to) {
    glift::Iteration iteration(write_box_7a558d52_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(write_box_7a558d52_kernel, memories, iteration.size())) {
        const write_box_7a558d52_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(write_box_7a558d52_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_7a558d52_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const write_box_7a558d52_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_7a558d52_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_7a558d52_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(write_box_7a558d52_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_7a558d52_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct fill_box_4fb0cc86_direct_parameters {
    uint to_extent;
    float value;
};
static_assert(offsetof(fill_box_4fb0cc86_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_4fb0cc86_direct_parameters, value) == 4);
struct fill_box_4fb0cc86_general_parameters {
    uint size;
    uint to_origin;
    float value;
};
static_assert(offsetof(fill_box_4fb0cc86_general_parameters, size) == 0);
static_assert(offsetof(fill_box_4fb0cc86_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_4fb0cc86_general_parameters, value) == 8);
struct fill_box_4fb0cc86_wide_parameters {
    uint size;
    uint to_origin;
    float value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_4fb0cc86_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_4fb0cc86_wide_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_4fb0cc86_wide_parameters, value) == 8);
static_assert(offsetof(fill_box_4fb0cc86_wide_parameters, to_data_address) == 16);
}  // namespace

extern const glift::Kernel fill_box_4fb0cc86_kernel;

GLIFT_SHARED void fill_box_4fb0cc86(const glift::Commands& commands,
    const glift::Range<::std_array::Array_1_float_none_buffer>& to, float value) {
    glift::Iteration iteration(fill_box_4fb0cc86_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_4fb0cc86_kernel, memories, iteration.size())) {
        const fill_box_4fb0cc86_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
            .to_data_address = 0u,
        };
        commands.dispatch(fill_box_4fb0cc86_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_4fb0cc86_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_4fb0cc86_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_4fb0cc86_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_4fb0cc86_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_4fb0cc86_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_4fb0cc86_general_parameters,
            size)})});
    }
}

GLIFT_SHARED Box_3_float::Box_3_float(const glift::Commands& commands, uint3 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Box<3, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Box_3_float::Box_3_float(const glift::Commands& commands, uint3 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box<3, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED uint3 Box_3_float::domain() const {
    return extent_;
}

GLIFT_SHARED bool Box_3_float::same_state(const Box_3_float& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Box_3_float::place(uint3 address) const {
    [[maybe_unused]] const uint3 extent = extent_;
    const auto translate = [&](uint3 va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
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

GLIFT_SHARED Box_1_float3::Box_1_float3(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_3(extent_)),
      data_(commands.allocate({.name = "Box<1, float3>.data", .bytes = glift::buffer_bytes<float3>(data_extent_)})) {}

GLIFT_SHARED Box_1_float3::Box_1_float3(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_3(extent_)),
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
        return linearize_64_3(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED Box_1_float::Box_1_float(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_3(extent_)),
      data_(commands.allocate({.name = "Box<1, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Box_1_float::Box_1_float(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_3(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box<1, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED uint Box_1_float::domain() const {
    return extent_;
}

GLIFT_SHARED bool Box_1_float::same_state(const Box_1_float& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Box_1_float::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64_3(va, extent);
    };
    return translate(address);
}

}  // namespace std_transfer

