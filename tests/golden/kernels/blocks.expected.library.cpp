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
        index = index * std::uint64_t(extent[2u - 1u - back]) + std::uint64_t(address[2u - 1u - back]);
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

GLIFT_SHARED void Array_2_float_none_buffer::copy_out(const glift::Commands& commands,
    const glift::Range<Array_2_float_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_f3d15695(commands, range, ::std_transfer::Box_2_float(commands, range.size(), box));
}

GLIFT_SHARED void Array_2_float_none_buffer::copy_in(const glift::Commands& commands,
    const glift::Range<Array_2_float_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_d5801374(commands, ::std_transfer::Box_2_float(commands, range.size(), box), range);
}

GLIFT_SHARED void Array_2_float_none_buffer::fill(float value, const glift::Range<Array_2_float_none_buffer>& range) {
    ::std_transfer::fill_box_902cb707(device(), range, value);
}
GLIFT_SHARED void Array_2_float_none_buffer::fill(float value) {
    fill(value, *this);
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

// address.glift:18: volume<3> in 64 bits
inline std::uint64_t volume_64_3(uint3 extent) {
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
inline std::uint64_t linearize_64_3(uint3 address, uint3 extent) {
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
    iteration.blocks(uint2(512u, to->capacity()), ::blocks::block_count_blocks_Listed(commands, to));
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

namespace {
struct list_there_b56b1eed_direct_parameters {
    uint2 size;
    uint a_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint3 a_extent;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint a_table_extent;
    uint2 a_frames_extent;
    glift::Bool counter_extent_value_0;
    uint addresses_extent;
    uint values_extent;
    uint3 translated_extent;
    uint div_ceil_y_3;
    uint div_ceil_x_3;
    uint translated_table_extent;
    uint translated_frames_extent_y;
    uint places_extent;
};
static_assert(offsetof(list_there_b56b1eed_direct_parameters, size) == 0);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, a_active_extent) == 8);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, div_ceil_x) == 12);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, div_ceil_y) == 16);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, a_extent) == 20);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, div_ceil_y_2) == 32);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, div_ceil_x_2) == 36);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, a_table_extent) == 40);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, a_frames_extent) == 44);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, counter_extent_value_0) == 52);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, addresses_extent) == 56);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, values_extent) == 60);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, translated_extent) == 64);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, div_ceil_y_3) == 76);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, div_ceil_x_3) == 80);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, translated_table_extent) == 84);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, translated_frames_extent_y) == 88);
static_assert(offsetof(list_there_b56b1eed_direct_parameters, places_extent) == 92);
struct list_there_b56b1eed_general_parameters {
    uint2 size;
    uint3 from_origin;
    uint counter_origin;
    uint counter_size;
    uint addresses_origin;
    uint addresses_size;
    uint values_origin;
    uint values_size;
    uint3 translated_origin;
    uint places_origin;
    uint places_size;
    uint3 a_size;
    uint3 a_origin;
    uint a_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint3 from_extent;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint from_table_extent;
    uint2 from_frames_extent;
    uint3 translated_extent;
    uint div_ceil_y_3;
    uint div_ceil_x_3;
    uint translated_table_extent;
    uint translated_frames_extent_y;
};
static_assert(offsetof(list_there_b56b1eed_general_parameters, size) == 0);
static_assert(offsetof(list_there_b56b1eed_general_parameters, from_origin) == 8);
static_assert(offsetof(list_there_b56b1eed_general_parameters, counter_origin) == 20);
static_assert(offsetof(list_there_b56b1eed_general_parameters, counter_size) == 24);
static_assert(offsetof(list_there_b56b1eed_general_parameters, addresses_origin) == 28);
static_assert(offsetof(list_there_b56b1eed_general_parameters, addresses_size) == 32);
static_assert(offsetof(list_there_b56b1eed_general_parameters, values_origin) == 36);
static_assert(offsetof(list_there_b56b1eed_general_parameters, values_size) == 40);
static_assert(offsetof(list_there_b56b1eed_general_parameters, translated_origin) == 44);
static_assert(offsetof(list_there_b56b1eed_general_parameters, places_origin) == 56);
static_assert(offsetof(list_there_b56b1eed_general_parameters, places_size) == 60);
static_assert(offsetof(list_there_b56b1eed_general_parameters, a_size) == 64);
static_assert(offsetof(list_there_b56b1eed_general_parameters, a_origin) == 76);
static_assert(offsetof(list_there_b56b1eed_general_parameters, a_active_extent) == 88);
static_assert(offsetof(list_there_b56b1eed_general_parameters, div_ceil_x) == 92);
static_assert(offsetof(list_there_b56b1eed_general_parameters, div_ceil_y) == 96);
static_assert(offsetof(list_there_b56b1eed_general_parameters, from_extent) == 100);
static_assert(offsetof(list_there_b56b1eed_general_parameters, div_ceil_y_2) == 112);
static_assert(offsetof(list_there_b56b1eed_general_parameters, div_ceil_x_2) == 116);
static_assert(offsetof(list_there_b56b1eed_general_parameters, from_table_extent) == 120);
static_assert(offsetof(list_there_b56b1eed_general_parameters, from_frames_extent) == 124);
static_assert(offsetof(list_there_b56b1eed_general_parameters, translated_extent) == 132);
static_assert(offsetof(list_there_b56b1eed_general_parameters, div_ceil_y_3) == 144);
static_assert(offsetof(list_there_b56b1eed_general_parameters, div_ceil_x_3) == 148);
static_assert(offsetof(list_there_b56b1eed_general_parameters, translated_table_extent) == 152);
static_assert(offsetof(list_there_b56b1eed_general_parameters, translated_frames_extent_y) == 156);
struct list_there_b56b1eed_wide_parameters {
    uint2 size;
    uint3 from_origin;
    uint counter_origin;
    uint counter_size;
    uint addresses_origin;
    uint addresses_size;
    uint values_origin;
    uint values_size;
    uint3 translated_origin;
    uint places_origin;
    uint places_size;
    uint3 a_size;
    uint3 a_origin;
    uint a_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint3 from_extent;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint from_table_extent;
    uint from_frames_extent_y;
    std::uint64_t from_frames_extent_x;
    uint3 translated_extent;
    uint div_ceil_y_3;
    uint div_ceil_x_3;
    uint translated_table_extent;
    uint translated_frames_extent_y;
    std::uint64_t a_active_data_address;
    std::uint64_t from_table_data_address;
    std::uint64_t from_frames_data_address;
    std::uint64_t counter_data_address;
    std::uint64_t addresses_data_address;
    std::uint64_t values_data_address;
    std::uint64_t translated_table_data_address;
    std::uint64_t places_data_address;
};
static_assert(offsetof(list_there_b56b1eed_wide_parameters, size) == 0);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, from_origin) == 8);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, counter_origin) == 20);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, counter_size) == 24);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, addresses_origin) == 28);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, addresses_size) == 32);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, values_origin) == 36);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, values_size) == 40);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, translated_origin) == 44);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, places_origin) == 56);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, places_size) == 60);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, a_size) == 64);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, a_origin) == 76);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, a_active_extent) == 88);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, div_ceil_x) == 92);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, div_ceil_y) == 96);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, from_extent) == 100);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, div_ceil_y_2) == 112);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, div_ceil_x_2) == 116);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, from_table_extent) == 120);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, from_frames_extent_y) == 124);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, from_frames_extent_x) == 128);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, translated_extent) == 136);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, div_ceil_y_3) == 148);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, div_ceil_x_3) == 152);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, translated_table_extent) == 156);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, translated_frames_extent_y) == 160);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, a_active_data_address) == 168);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, from_table_data_address) == 176);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, from_frames_data_address) == 184);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, counter_data_address) == 192);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, addresses_data_address) == 200);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, values_data_address) == 208);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, translated_table_data_address) == 216);
static_assert(offsetof(list_there_b56b1eed_wide_parameters, places_data_address) == 224);
}  // namespace

extern const glift::Kernel list_there_b56b1eed_kernel;

GLIFT_SHARED void list_there_b56b1eed(const glift::Commands& commands, const glift::Range<::blocks::Listed>& a,
    const glift::Range<::blocks::Listed>& from, const glift::Range<::blocks::Listed>& translated,
    const glift::Range<Box_1_uint>& counter, const glift::Range<Box_1_uint3>& addresses,
    const glift::Range<Box_1_uint2>& places, const glift::Range<Box_1_float>& values) {
    glift::Iteration iteration(list_there_b56b1eed_kernel);
    iteration.each("a", a);
    iteration.any("from", from);
    iteration.any("translated", translated);
    iteration.any("counter", counter);
    iteration.any("addresses", addresses);
    iteration.any("places", places);
    iteration.any("values", values);
    iteration.blocks(uint2(512u, a->capacity()), ::blocks::block_count_blocks_Listed(commands, a));
    const glift::Memory memories[] = {a->active().data(), from->table().data(), from->frames().data(), counter->data(),
        addresses->data(), values->data(), translated->table().data(), places->data()};
    if (iteration.is_shared(memories)) iteration.share(memories,
        {a, from, translated, counter, addresses, places, values});
    if (commands.needs_wide(list_there_b56b1eed_kernel, memories, iteration.extent())) {
        const list_there_b56b1eed_wide_parameters parameters = {
            .size = iteration.visited(),
            .from_origin = from.origin(),
            .counter_origin = counter.origin(),
            .counter_size = counter.size(),
            .addresses_origin = addresses.origin(),
            .addresses_size = addresses.size(),
            .values_origin = values.origin(),
            .values_size = values.size(),
            .translated_origin = translated.origin(),
            .places_origin = places.origin(),
            .places_size = places.size(),
            .a_size = a.size(),
            .a_origin = a.origin(),
            .a_active_extent = a->active().extent(),
            .div_ceil_x = glift::max(div_ceil(a->extent(), uint3(8u, 8u, 8u)).x, 1u),
            .div_ceil_y = glift::max(div_ceil(a->extent(), uint3(8u, 8u, 8u)).y, 1u),
            .from_extent = from->extent(),
            .div_ceil_y_2 = div_ceil(from->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_2 = div_ceil(from->extent(), uint3(8u, 8u, 8u)).x,
            .from_table_extent = from->table().extent(),
            .from_frames_extent_y = from->frames().extent().y,
            .from_frames_extent_x = std::uint64_t(from->frames().extent().x),
            .translated_extent = translated->extent(),
            .div_ceil_y_3 = div_ceil(translated->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_3 = div_ceil(translated->extent(), uint3(8u, 8u, 8u)).x,
            .translated_table_extent = translated->table().extent(),
            .translated_frames_extent_y = translated->frames().extent().y,
            .a_active_data_address = 0u,
            .from_table_data_address = 0u,
            .from_frames_data_address = 0u,
            .counter_data_address = 0u,
            .addresses_data_address = 0u,
            .values_data_address = 0u,
            .translated_table_data_address = 0u,
            .places_data_address = 0u,
        };
        iteration.count_blocks(offsetof(list_there_b56b1eed_wide_parameters, size));
        iteration.count(counter, offsetof(list_there_b56b1eed_wide_parameters, counter_size));
        iteration.count(addresses, offsetof(list_there_b56b1eed_wide_parameters, addresses_size));
        iteration.count(values, offsetof(list_there_b56b1eed_wide_parameters, values_size));
        iteration.count(places, offsetof(list_there_b56b1eed_wide_parameters, places_size));
        commands.dispatch(list_there_b56b1eed_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.extent(), .patches = iteration.patches({offsetof(list_there_b56b1eed_wide_parameters,
            a_size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && a->same_state(from.structure())) {
        const list_there_b56b1eed_direct_parameters parameters = {
            .size = iteration.visited(),
            .a_active_extent = a->active().extent(),
            .div_ceil_x = glift::max(div_ceil(a->extent(), uint3(8u, 8u, 8u)).x, 1u),
            .div_ceil_y = glift::max(div_ceil(a->extent(), uint3(8u, 8u, 8u)).y, 1u),
            .a_extent = a->extent(),
            .div_ceil_y_2 = div_ceil(a->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_2 = div_ceil(a->extent(), uint3(8u, 8u, 8u)).x,
            .a_table_extent = a->table().extent(),
            .a_frames_extent = a->frames().extent(),
            .counter_extent_value_0 = 0u < counter->extent(),
            .addresses_extent = addresses->extent(),
            .values_extent = values->extent(),
            .translated_extent = translated->extent(),
            .div_ceil_y_3 = div_ceil(translated->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_3 = div_ceil(translated->extent(), uint3(8u, 8u, 8u)).x,
            .translated_table_extent = translated->table().extent(),
            .translated_frames_extent_y = translated->frames().extent().y,
            .places_extent = places->extent(),
        };
        iteration.count_blocks(offsetof(list_there_b56b1eed_direct_parameters, size));
        commands.dispatch(list_there_b56b1eed_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.extent(), .patches = iteration.patches({}), .sharing = iteration.sharing()});
    } else {
        const list_there_b56b1eed_general_parameters parameters = {
            .size = iteration.visited(),
            .from_origin = from.origin(),
            .counter_origin = counter.origin(),
            .counter_size = counter.size(),
            .addresses_origin = addresses.origin(),
            .addresses_size = addresses.size(),
            .values_origin = values.origin(),
            .values_size = values.size(),
            .translated_origin = translated.origin(),
            .places_origin = places.origin(),
            .places_size = places.size(),
            .a_size = a.size(),
            .a_origin = a.origin(),
            .a_active_extent = a->active().extent(),
            .div_ceil_x = glift::max(div_ceil(a->extent(), uint3(8u, 8u, 8u)).x, 1u),
            .div_ceil_y = glift::max(div_ceil(a->extent(), uint3(8u, 8u, 8u)).y, 1u),
            .from_extent = from->extent(),
            .div_ceil_y_2 = div_ceil(from->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_2 = div_ceil(from->extent(), uint3(8u, 8u, 8u)).x,
            .from_table_extent = from->table().extent(),
            .from_frames_extent = from->frames().extent(),
            .translated_extent = translated->extent(),
            .div_ceil_y_3 = div_ceil(translated->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_3 = div_ceil(translated->extent(), uint3(8u, 8u, 8u)).x,
            .translated_table_extent = translated->table().extent(),
            .translated_frames_extent_y = translated->frames().extent().y,
        };
        iteration.count_blocks(offsetof(list_there_b56b1eed_general_parameters, size));
        iteration.count(counter, offsetof(list_there_b56b1eed_general_parameters, counter_size));
        iteration.count(addresses, offsetof(list_there_b56b1eed_general_parameters, addresses_size));
        iteration.count(values, offsetof(list_there_b56b1eed_general_parameters, values_size));
        iteration.count(places, offsetof(list_there_b56b1eed_general_parameters, places_size));
        commands.dispatch(list_there_b56b1eed_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.extent(), .patches = iteration.patches({offsetof(list_there_b56b1eed_general_parameters,
            a_size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct read_box_f3d15695_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_f3d15695_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_f3d15695_direct_parameters, to_extent_x) == 8);
struct read_box_f3d15695_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
    uint to_extent_x;
};
static_assert(offsetof(read_box_f3d15695_general_parameters, size) == 0);
static_assert(offsetof(read_box_f3d15695_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_f3d15695_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_f3d15695_general_parameters, from_extent_x) == 24);
static_assert(offsetof(read_box_f3d15695_general_parameters, to_extent_x) == 28);
struct read_box_f3d15695_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t to_extent_x;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_f3d15695_wide_parameters, size) == 0);
static_assert(offsetof(read_box_f3d15695_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_f3d15695_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_f3d15695_wide_parameters, base) == 24);
static_assert(offsetof(read_box_f3d15695_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(read_box_f3d15695_wide_parameters, to_extent_x) == 48);
static_assert(offsetof(read_box_f3d15695_wide_parameters, from_data_address) == 56);
static_assert(offsetof(read_box_f3d15695_wide_parameters, to_data_address) == 64);
}  // namespace

extern const glift::Kernel read_box_f3d15695_kernel;

GLIFT_SHARED void read_box_f3d15695(const glift::Commands& commands,
    const glift::Range<::std_array::Array_2_float_none_buffer>& from, const glift::Range<Box_2_float>& to) {
    glift::Iteration iteration(read_box_f3d15695_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(read_box_f3d15695_kernel, memories, iteration.size())) {
        const read_box_f3d15695_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = std::uint64_t(from->extent().x),
            .to_extent_x = std::uint64_t(to->extent().x),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_f3d15695_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_f3d15695_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const read_box_f3d15695_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_f3d15695_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_f3d15695_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_f3d15695_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_f3d15695_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct write_box_d5801374_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(write_box_d5801374_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_d5801374_direct_parameters, to_extent_x) == 8);
struct write_box_d5801374_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
    uint to_extent_x;
};
static_assert(offsetof(write_box_d5801374_general_parameters, size) == 0);
static_assert(offsetof(write_box_d5801374_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_d5801374_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_d5801374_general_parameters, from_extent_x) == 24);
static_assert(offsetof(write_box_d5801374_general_parameters, to_extent_x) == 28);
struct write_box_d5801374_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t to_extent_x;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_d5801374_wide_parameters, size) == 0);
static_assert(offsetof(write_box_d5801374_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_d5801374_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_d5801374_wide_parameters, base) == 24);
static_assert(offsetof(write_box_d5801374_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_d5801374_wide_parameters, to_extent_x) == 48);
static_assert(offsetof(write_box_d5801374_wide_parameters, from_data_address) == 56);
static_assert(offsetof(write_box_d5801374_wide_parameters, to_data_address) == 64);
}  // namespace

extern const glift::Kernel write_box_d5801374_kernel;

GLIFT_SHARED void write_box_d5801374(const glift::Commands& commands, const glift::Range<Box_2_float>& from,
    const glift::Range<::std_array::Array_2_float_none_buffer>& to) {
    glift::Iteration iteration(write_box_d5801374_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(write_box_d5801374_kernel, memories, iteration.size())) {
        const write_box_d5801374_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = std::uint64_t(from->extent().x),
            .to_extent_x = std::uint64_t(to->extent().x),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(write_box_d5801374_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_d5801374_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const write_box_d5801374_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(write_box_d5801374_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_d5801374_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(write_box_d5801374_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_d5801374_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct fill_box_902cb707_direct_parameters {
    uint2 to_extent;
    float value;
};
static_assert(offsetof(fill_box_902cb707_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_902cb707_direct_parameters, value) == 8);
struct fill_box_902cb707_general_parameters {
    uint2 size;
    uint2 to_origin;
    uint to_extent_x;
    float value;
};
static_assert(offsetof(fill_box_902cb707_general_parameters, size) == 0);
static_assert(offsetof(fill_box_902cb707_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_902cb707_general_parameters, to_extent_x) == 16);
static_assert(offsetof(fill_box_902cb707_general_parameters, value) == 20);
struct fill_box_902cb707_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    float value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_902cb707_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_902cb707_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_902cb707_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_902cb707_wide_parameters, to_extent_x) == 32);
static_assert(offsetof(fill_box_902cb707_wide_parameters, value) == 40);
static_assert(offsetof(fill_box_902cb707_wide_parameters, to_data_address) == 48);
}  // namespace

extern const glift::Kernel fill_box_902cb707_kernel;

GLIFT_SHARED void fill_box_902cb707(const glift::Commands& commands,
    const glift::Range<::std_array::Array_2_float_none_buffer>& to, float value) {
    glift::Iteration iteration(fill_box_902cb707_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_902cb707_kernel, memories, iteration.size())) {
        const fill_box_902cb707_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_x = std::uint64_t(to->extent().x),
            .value = value,
            .to_data_address = 0u,
        };
        commands.dispatch(fill_box_902cb707_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_902cb707_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_902cb707_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_902cb707_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_902cb707_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_extent_x = to->extent().x,
            .value = value,
        };
        commands.dispatch(fill_box_902cb707_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_902cb707_general_parameters,
            size)})});
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

GLIFT_SHARED Box_3_float::Box_3_float(const glift::Commands& commands, uint3 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_3(extent_)),
      data_(commands.allocate({.name = "Box<3, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Box_3_float::Box_3_float(const glift::Commands& commands, uint3 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64_3(extent_)),
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
        return linearize_64_3(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED Box_1_uint3::Box_1_uint3(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Box<1, uint3>.data", .bytes = glift::buffer_bytes<uint3>(data_extent_)})) {}

GLIFT_SHARED Box_1_uint3::Box_1_uint3(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box<1, uint3>.data", .bytes = glift::buffer_bytes<uint3>(data_extent_)})) {}

GLIFT_SHARED uint Box_1_uint3::domain() const {
    return extent_;
}

GLIFT_SHARED bool Box_1_uint3::same_state(const Box_1_uint3& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Box_1_uint3::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED Box_1_uint2::Box_1_uint2(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Box<1, uint2>.data", .bytes = glift::buffer_bytes<uint2>(data_extent_)})) {}

GLIFT_SHARED Box_1_uint2::Box_1_uint2(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box<1, uint2>.data", .bytes = glift::buffer_bytes<uint2>(data_extent_)})) {}

GLIFT_SHARED uint Box_1_uint2::domain() const {
    return extent_;
}

GLIFT_SHARED bool Box_1_uint2::same_state(const Box_1_uint2& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Box_1_uint2::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED Box_1_float::Box_1_float(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Box<1, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Box_1_float::Box_1_float(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
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
        return linearize_64(va, extent);
    };
    return translate(address);
}

}  // namespace std_transfer

