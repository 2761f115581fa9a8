// Made by gliftc from blocks.glift. Changes are lost when it is made again.
#include "blocks.glift.internal.hpp"

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
        index = index * std::uint64_t(extent[1u - back]) + std::uint64_t(address[1u - back]);
    }
    // address.glift:32
    return index;
}

}  // namespace

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

GLIFT_SHARED Array_2_float_none_buffer::Array_2_float_none_buffer(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.allocate({.name = "Array<2, float, none, buffer>.data",
        .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Array_2_float_none_buffer::Array_2_float_none_buffer(const glift::Commands& commands, uint2 extent,
    glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Array<2, float, none, buffer>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED uint2 Array_2_float_none_buffer::domain() const {
    return extent_;
}

GLIFT_SHARED bool Array_2_float_none_buffer::same_state(const Array_2_float_none_buffer& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Array_2_float_none_buffer::place(uint2 address) const {
    [[maybe_unused]] const uint2 extent = extent_;
    const auto translate = [&](uint2 va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64_2(va, extent);
    };
    return translate(address);
}

}  // namespace std_array

namespace std_transfer {

using namespace glift::types;

namespace {

// address.glift:53: div_ceil<3>
inline uint3 div_ceil(uint3 a, uint3 b) {
    // address.glift:54
    const uint3 any = glift::min(a, uint3(1u));
    // address.glift:55
    return (a - any) / b + any;
}

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
        index = index * std::uint64_t(extent[2u - back]) + std::uint64_t(address[2u - back]);
    }
    // address.glift:32
    return index;
}

}  // namespace

namespace {
struct read_box_a23c245a_direct_parameters {
    uint3 from_extent;
    uint div_ceil_y;
    uint div_ceil_x;
    uint from_table_extent;
    uint2 from_frames_extent;
    uint3 to_extent;
};
static_assert(offsetof(read_box_a23c245a_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_a23c245a_direct_parameters, div_ceil_y) == 12);
static_assert(offsetof(read_box_a23c245a_direct_parameters, div_ceil_x) == 16);
static_assert(offsetof(read_box_a23c245a_direct_parameters, from_table_extent) == 20);
static_assert(offsetof(read_box_a23c245a_direct_parameters, from_frames_extent) == 24);
static_assert(offsetof(read_box_a23c245a_direct_parameters, to_extent) == 32);
struct read_box_a23c245a_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint div_ceil_y;
    uint div_ceil_x;
    uint from_table_extent;
    uint2 from_frames_extent;
    uint3 to_extent;
};
static_assert(offsetof(read_box_a23c245a_general_parameters, size) == 0);
static_assert(offsetof(read_box_a23c245a_general_parameters, from_origin) == 12);
static_assert(offsetof(read_box_a23c245a_general_parameters, to_origin) == 24);
static_assert(offsetof(read_box_a23c245a_general_parameters, div_ceil_y) == 36);
static_assert(offsetof(read_box_a23c245a_general_parameters, div_ceil_x) == 40);
static_assert(offsetof(read_box_a23c245a_general_parameters, from_table_extent) == 44);
static_assert(offsetof(read_box_a23c245a_general_parameters, from_frames_extent) == 48);
static_assert(offsetof(read_box_a23c245a_general_parameters, to_extent) == 56);
struct read_box_a23c245a_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    uint div_ceil_y;
    uint div_ceil_x;
    uint from_table_extent;
    std::uint64_t from_frames_extent_x;
    uint from_frames_extent_y;
    std::uint64_t to_extent_y;
    std::uint64_t to_extent_x;
    std::uint64_t from_table_data_address;
    std::uint64_t from_frames_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_a23c245a_wide_parameters, size) == 0);
static_assert(offsetof(read_box_a23c245a_wide_parameters, from_origin) == 12);
static_assert(offsetof(read_box_a23c245a_wide_parameters, to_origin) == 24);
static_assert(offsetof(read_box_a23c245a_wide_parameters, base) == 36);
static_assert(offsetof(read_box_a23c245a_wide_parameters, div_ceil_y) == 48);
static_assert(offsetof(read_box_a23c245a_wide_parameters, div_ceil_x) == 52);
static_assert(offsetof(read_box_a23c245a_wide_parameters, from_table_extent) == 56);
static_assert(offsetof(read_box_a23c245a_wide_parameters, from_frames_extent_x) == 64);
static_assert(offsetof(read_box_a23c245a_wide_parameters, from_frames_extent_y) == 72);
static_assert(offsetof(read_box_a23c245a_wide_parameters, to_extent_y) == 80);
static_assert(offsetof(read_box_a23c245a_wide_parameters, to_extent_x) == 88);
static_assert(offsetof(read_box_a23c245a_wide_parameters, from_table_data_address) == 96);
static_assert(offsetof(read_box_a23c245a_wide_parameters, from_frames_data_address) == 104);
static_assert(offsetof(read_box_a23c245a_wide_parameters, to_data_address) == 112);
}  // namespace

extern const glift::Kernel read_box_a23c245a_kernel;

GLIFT_SHARED void read_box_a23c245a(const glift::Commands& commands, const glift::Range<::blocks::Listed>& from,
    const glift::Range<Box_3_float>& to) {
    glift::Iteration iteration(read_box_a23c245a_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->table().data(), from->frames().data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(read_box_a23c245a_kernel, memories, iteration.size())) {
        const read_box_a23c245a_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .div_ceil_y = div_ceil(from->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x = div_ceil(from->extent(), uint3(8u, 8u, 8u)).x,
            .from_table_extent = from->table().extent(),
            .from_frames_extent_x = std::uint64_t(from->frames().extent().x),
            .from_frames_extent_y = from->frames().extent().y,
            .to_extent_y = std::uint64_t(to->extent().y),
            .to_extent_x = std::uint64_t(to->extent().x),
            .from_table_data_address = 0u,
            .from_frames_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_a23c245a_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_a23c245a_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const read_box_a23c245a_direct_parameters parameters = {
            .from_extent = from->extent(),
            .div_ceil_y = div_ceil(from->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x = div_ceil(from->extent(), uint3(8u, 8u, 8u)).x,
            .from_table_extent = from->table().extent(),
            .from_frames_extent = from->frames().extent(),
            .to_extent = to->extent(),
        };
        commands.dispatch(read_box_a23c245a_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_a23c245a_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .div_ceil_y = div_ceil(from->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x = div_ceil(from->extent(), uint3(8u, 8u, 8u)).x,
            .from_table_extent = from->table().extent(),
            .from_frames_extent = from->frames().extent(),
            .to_extent = to->extent(),
        };
        commands.dispatch(read_box_a23c245a_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_a23c245a_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct write_box_93a8b595_direct_parameters {
    uint3 from_extent;
    uint div_ceil_y;
    uint div_ceil_x;
    uint to_table_extent;
    uint2 to_frames_extent;
};
static_assert(offsetof(write_box_93a8b595_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_93a8b595_direct_parameters, div_ceil_y) == 12);
static_assert(offsetof(write_box_93a8b595_direct_parameters, div_ceil_x) == 16);
static_assert(offsetof(write_box_93a8b595_direct_parameters, to_table_extent) == 20);
static_assert(offsetof(write_box_93a8b595_direct_parameters, to_frames_extent) == 24);
struct write_box_93a8b595_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 from_extent;
    uint div_ceil_y;
    uint div_ceil_x;
    uint to_table_extent;
    uint2 to_frames_extent;
};
static_assert(offsetof(write_box_93a8b595_general_parameters, size) == 0);
static_assert(offsetof(write_box_93a8b595_general_parameters, from_origin) == 12);
static_assert(offsetof(write_box_93a8b595_general_parameters, to_origin) == 24);
static_assert(offsetof(write_box_93a8b595_general_parameters, from_extent) == 36);
static_assert(offsetof(write_box_93a8b595_general_parameters, div_ceil_y) == 48);
static_assert(offsetof(write_box_93a8b595_general_parameters, div_ceil_x) == 52);
static_assert(offsetof(write_box_93a8b595_general_parameters, to_table_extent) == 56);
static_assert(offsetof(write_box_93a8b595_general_parameters, to_frames_extent) == 60);
struct write_box_93a8b595_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    std::uint64_t from_extent_y;
    std::uint64_t from_extent_x;
    uint div_ceil_y;
    uint div_ceil_x;
    uint to_table_extent;
    std::uint64_t to_frames_extent_x;
    uint to_frames_extent_y;
    std::uint64_t from_data_address;
    std::uint64_t to_table_data_address;
    std::uint64_t to_frames_data_address;
};
static_assert(offsetof(write_box_93a8b595_wide_parameters, size) == 0);
static_assert(offsetof(write_box_93a8b595_wide_parameters, from_origin) == 12);
static_assert(offsetof(write_box_93a8b595_wide_parameters, to_origin) == 24);
static_assert(offsetof(write_box_93a8b595_wide_parameters, base) == 36);
static_assert(offsetof(write_box_93a8b595_wide_parameters, from_extent_y) == 48);
static_assert(offsetof(write_box_93a8b595_wide_parameters, from_extent_x) == 56);
static_assert(offsetof(write_box_93a8b595_wide_parameters, div_ceil_y) == 64);
static_assert(offsetof(write_box_93a8b595_wide_parameters, div_ceil_x) == 68);
static_assert(offsetof(write_box_93a8b595_wide_parameters, to_table_extent) == 72);
static_assert(offsetof(write_box_93a8b595_wide_parameters, to_frames_extent_x) == 80);
static_assert(offsetof(write_box_93a8b595_wide_parameters, to_frames_extent_y) == 88);
static_assert(offsetof(write_box_93a8b595_wide_parameters, from_data_address) == 96);
static_assert(offsetof(write_box_93a8b595_wide_parameters, to_table_data_address) == 104);
static_assert(offsetof(write_box_93a8b595_wide_parameters, to_frames_data_address) == 112);
}  // namespace

extern const glift::Kernel write_box_93a8b595_kernel;

GLIFT_SHARED void write_box_93a8b595(const glift::Commands& commands, const glift::Range<Box_3_float>& from,
    const glift::Range<::blocks::Listed>& to) {
    glift::Iteration iteration(write_box_93a8b595_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->table().data(), to->frames().data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(write_box_93a8b595_kernel, memories, iteration.size())) {
        const write_box_93a8b595_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_y = std::uint64_t(from->extent().y),
            .from_extent_x = std::uint64_t(from->extent().x),
            .div_ceil_y = div_ceil(to->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x = div_ceil(to->extent(), uint3(8u, 8u, 8u)).x,
            .to_table_extent = to->table().extent(),
            .to_frames_extent_x = std::uint64_t(to->frames().extent().x),
            .to_frames_extent_y = to->frames().extent().y,
            .from_data_address = 0u,
            .to_table_data_address = 0u,
            .to_frames_data_address = 0u,
        };
        commands.dispatch(write_box_93a8b595_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_93a8b595_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const write_box_93a8b595_direct_parameters parameters = {
            .from_extent = from->extent(),
            .div_ceil_y = div_ceil(to->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x = div_ceil(to->extent(), uint3(8u, 8u, 8u)).x,
            .to_table_extent = to->table().extent(),
            .to_frames_extent = to->frames().extent(),
        };
        commands.dispatch(write_box_93a8b595_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_93a8b595_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent = from->extent(),
            .div_ceil_y = div_ceil(to->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x = div_ceil(to->extent(), uint3(8u, 8u, 8u)).x,
            .to_table_extent = to->table().extent(),
            .to_frames_extent = to->frames().extent(),
        };
        commands.dispatch(write_box_93a8b595_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_93a8b595_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct fill_box_blocks_Listed_float_direct_parameters {
    uint2 size;
    uint to_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint to_table_extent;
    uint2 to_frames_extent;
    uint3 to_extent;
    float value;
};
static_assert(offsetof(fill_box_blocks_Listed_float_direct_parameters, size) == 0);
static_assert(offsetof(fill_box_blocks_Listed_float_direct_parameters, to_active_extent) == 8);
static_assert(offsetof(fill_box_blocks_Listed_float_direct_parameters, div_ceil_x) == 12);
static_assert(offsetof(fill_box_blocks_Listed_float_direct_parameters, div_ceil_y) == 16);
static_assert(offsetof(fill_box_blocks_Listed_float_direct_parameters, div_ceil_y_2) == 20);
static_assert(offsetof(fill_box_blocks_Listed_float_direct_parameters, div_ceil_x_2) == 24);
static_assert(offsetof(fill_box_blocks_Listed_float_direct_parameters, to_table_extent) == 28);
static_assert(offsetof(fill_box_blocks_Listed_float_direct_parameters, to_frames_extent) == 32);
static_assert(offsetof(fill_box_blocks_Listed_float_direct_parameters, to_extent) == 40);
static_assert(offsetof(fill_box_blocks_Listed_float_direct_parameters, value) == 52);
struct fill_box_blocks_Listed_float_general_parameters {
    uint2 size;
    uint3 to_size;
    uint3 to_origin;
    uint to_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint to_table_extent;
    uint2 to_frames_extent;
    float value;
};
static_assert(offsetof(fill_box_blocks_Listed_float_general_parameters, size) == 0);
static_assert(offsetof(fill_box_blocks_Listed_float_general_parameters, to_size) == 8);
static_assert(offsetof(fill_box_blocks_Listed_float_general_parameters, to_origin) == 20);
static_assert(offsetof(fill_box_blocks_Listed_float_general_parameters, to_active_extent) == 32);
static_assert(offsetof(fill_box_blocks_Listed_float_general_parameters, div_ceil_x) == 36);
static_assert(offsetof(fill_box_blocks_Listed_float_general_parameters, div_ceil_y) == 40);
static_assert(offsetof(fill_box_blocks_Listed_float_general_parameters, div_ceil_y_2) == 44);
static_assert(offsetof(fill_box_blocks_Listed_float_general_parameters, div_ceil_x_2) == 48);
static_assert(offsetof(fill_box_blocks_Listed_float_general_parameters, to_table_extent) == 52);
static_assert(offsetof(fill_box_blocks_Listed_float_general_parameters, to_frames_extent) == 56);
static_assert(offsetof(fill_box_blocks_Listed_float_general_parameters, value) == 64);
struct fill_box_blocks_Listed_float_wide_parameters {
    uint2 size;
    uint3 to_size;
    uint3 to_origin;
    uint to_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint to_table_extent;
    uint to_frames_extent_y;
    std::uint64_t to_frames_extent_x;
    float value;
    std::uint64_t to_active_data_address;
    std::uint64_t to_table_data_address;
    std::uint64_t to_frames_data_address;
};
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, to_size) == 8);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, to_origin) == 20);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, to_active_extent) == 32);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, div_ceil_x) == 36);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, div_ceil_y) == 40);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, div_ceil_y_2) == 44);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, div_ceil_x_2) == 48);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, to_table_extent) == 52);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, to_frames_extent_y) == 56);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, to_frames_extent_x) == 64);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, value) == 72);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, to_active_data_address) == 80);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, to_table_data_address) == 88);
static_assert(offsetof(fill_box_blocks_Listed_float_wide_parameters, to_frames_data_address) == 96);
}  // namespace

extern const glift::Kernel fill_box_blocks_Listed_float_kernel;

GLIFT_SHARED void fill_box_blocks_Listed_float(const glift::Commands& commands,
    const glift::Range<::blocks::Listed>& to, float value) {
    glift::Iteration iteration(fill_box_blocks_Listed_float_kernel);
    iteration.each("to", to);
    iteration.blocks(uint2(512u, to->capacity()), ::blocks::blocks_blocks_Listed(commands, to));
    const glift::Memory memories[] = {to->active().data(), to->table().data(), to->frames().data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {to});
    if (commands.needs_wide(fill_box_blocks_Listed_float_kernel, memories, iteration.extent())) {
        const fill_box_blocks_Listed_float_wide_parameters parameters = {
            .size = iteration.visited(),
            .to_size = to.size(),
            .to_origin = to.origin(),
            .to_active_extent = to->active().extent(),
            .div_ceil_x = glift::max(div_ceil(to->extent(), uint3(8u, 8u, 8u)).x, 1u),
            .div_ceil_y = glift::max(div_ceil(to->extent(), uint3(8u, 8u, 8u)).y, 1u),
            .div_ceil_y_2 = div_ceil(to->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_2 = div_ceil(to->extent(), uint3(8u, 8u, 8u)).x,
            .to_table_extent = to->table().extent(),
            .to_frames_extent_y = to->frames().extent().y,
            .to_frames_extent_x = std::uint64_t(to->frames().extent().x),
            .value = value,
            .to_active_data_address = 0u,
            .to_table_data_address = 0u,
            .to_frames_data_address = 0u,
        };
        iteration.count_blocks(offsetof(fill_box_blocks_Listed_float_wide_parameters, size));
        commands.dispatch(fill_box_blocks_Listed_float_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.extent(), .patches = iteration.patches({offsetof(fill_box_blocks_Listed_float_wide_parameters, to_size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const fill_box_blocks_Listed_float_direct_parameters parameters = {
            .size = iteration.visited(),
            .to_active_extent = to->active().extent(),
            .div_ceil_x = glift::max(div_ceil(to->extent(), uint3(8u, 8u, 8u)).x, 1u),
            .div_ceil_y = glift::max(div_ceil(to->extent(), uint3(8u, 8u, 8u)).y, 1u),
            .div_ceil_y_2 = div_ceil(to->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_2 = div_ceil(to->extent(), uint3(8u, 8u, 8u)).x,
            .to_table_extent = to->table().extent(),
            .to_frames_extent = to->frames().extent(),
            .to_extent = to->extent(),
            .value = value,
        };
        iteration.count_blocks(offsetof(fill_box_blocks_Listed_float_direct_parameters, size));
        commands.dispatch(fill_box_blocks_Listed_float_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.extent(), .patches = iteration.patches({}), .sharing = iteration.sharing()});
    } else {
        const fill_box_blocks_Listed_float_general_parameters parameters = {
            .size = iteration.visited(),
            .to_size = to.size(),
            .to_origin = to.origin(),
            .to_active_extent = to->active().extent(),
            .div_ceil_x = glift::max(div_ceil(to->extent(), uint3(8u, 8u, 8u)).x, 1u),
            .div_ceil_y = glift::max(div_ceil(to->extent(), uint3(8u, 8u, 8u)).y, 1u),
            .div_ceil_y_2 = div_ceil(to->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_2 = div_ceil(to->extent(), uint3(8u, 8u, 8u)).x,
            .to_table_extent = to->table().extent(),
            .to_frames_extent = to->frames().extent(),
            .value = value,
        };
        iteration.count_blocks(offsetof(fill_box_blocks_Listed_float_general_parameters, size));
        commands.dispatch(fill_box_blocks_Listed_float_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.extent(), .patches = iteration.patches({offsetof(fill_box_blocks_Listed_float_general_parameters, to_size)}), .sharing = iteration.sharing()});
    }
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

GLIFT_SHARED Box_3_float::Box_3_float(const glift::Commands& commands, uint3 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
      data_(commands.allocate({.name = "Box<3, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Box_3_float::Box_3_float(const glift::Commands& commands, uint3 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_2(extent_)),
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
        return linearize_64_2(va, extent);
    };
    return translate(address);
}

}  // namespace std_transfer

