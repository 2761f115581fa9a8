// Made by gliftc from at.glift. Changes are lost when it is made again.
#include "at.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace std_array {

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

}  // namespace

GLIFT_SHARED Array_2_float_none_buffer::Array_2_float_none_buffer(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Array<2, float, none, buffer>.data",
        .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Array_2_float_none_buffer::Array_2_float_none_buffer(const glift::Commands& commands, uint2 extent,
    glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
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
        return linearize_64(va, extent);
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

}  // namespace

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

}  // namespace std_transfer

