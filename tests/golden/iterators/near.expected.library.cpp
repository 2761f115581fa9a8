// Made by gliftc from near.glift. Changes are lost when it is made again.
#include "near.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace std_array {

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

}  // namespace

GLIFT_SHARED Array_3_float_none_buffer::Array_3_float_none_buffer(const glift::Commands& commands, uint3 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Array<3, float, none, buffer>.data",
        .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Array_3_float_none_buffer::Array_3_float_none_buffer(const glift::Commands& commands, uint3 extent,
    glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Array<3, float, none, buffer>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED uint3 Array_3_float_none_buffer::domain() const {
    return extent_;
}

GLIFT_SHARED bool Array_3_float_none_buffer::same_state(const Array_3_float_none_buffer& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Array_3_float_none_buffer::place(uint3 address) const {
    [[maybe_unused]] const uint3 extent = extent_;
    const auto translate = [&](uint3 va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
    };
    return translate(address);
}

GLIFT_SHARED void Array_3_float_none_buffer::copy_out(const glift::Commands& commands,
    const glift::Range<Array_3_float_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_6d963c25(commands, range, ::std_transfer::Box_3_float(commands, range.size(), box));
}

GLIFT_SHARED void Array_3_float_none_buffer::copy_in(const glift::Commands& commands,
    const glift::Range<Array_3_float_none_buffer>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_e5b112ea(commands, ::std_transfer::Box_3_float(commands, range.size(), box), range);
}

GLIFT_SHARED void Array_3_float_none_buffer::fill(float value, const glift::Range<Array_3_float_none_buffer>& range) {
    ::std_transfer::fill_box_bdadf51c(device(), range, value);
}
GLIFT_SHARED void Array_3_float_none_buffer::fill(float value) {
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

}  // namespace

namespace {
struct read_box_6d963c25_direct_parameters {
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(read_box_6d963c25_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_6d963c25_direct_parameters, to_extent) == 12);
struct read_box_6d963c25_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(read_box_6d963c25_general_parameters, size) == 0);
static_assert(offsetof(read_box_6d963c25_general_parameters, from_origin) == 12);
static_assert(offsetof(read_box_6d963c25_general_parameters, to_origin) == 24);
static_assert(offsetof(read_box_6d963c25_general_parameters, from_extent) == 36);
static_assert(offsetof(read_box_6d963c25_general_parameters, to_extent) == 48);
struct read_box_6d963c25_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    std::uint64_t from_extent_y;
    std::uint64_t from_extent_x;
    std::uint64_t to_extent_y;
    std::uint64_t to_extent_x;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_6d963c25_wide_parameters, size) == 0);
static_assert(offsetof(read_box_6d963c25_wide_parameters, from_origin) == 12);
static_assert(offsetof(read_box_6d963c25_wide_parameters, to_origin) == 24);
static_assert(offsetof(read_box_6d963c25_wide_parameters, base) == 36);
static_assert(offsetof(read_box_6d963c25_wide_parameters, from_extent_y) == 48);
static_assert(offsetof(read_box_6d963c25_wide_parameters, from_extent_x) == 56);
static_assert(offsetof(read_box_6d963c25_wide_parameters, to_extent_y) == 64);
static_assert(offsetof(read_box_6d963c25_wide_parameters, to_extent_x) == 72);
static_assert(offsetof(read_box_6d963c25_wide_parameters, from_data_address) == 80);
static_assert(offsetof(read_box_6d963c25_wide_parameters, to_data_address) == 88);
}  // namespace

extern const glift::Kernel read_box_6d963c25_kernel;

GLIFT_SHARED void read_box_6d963c25(const glift::Commands& commands,
    const glift::Range<::std_array::Array_3_float_none_buffer>& from, const glift::Range<Box_3_float>& to) {
    glift::Iteration iteration(read_box_6d963c25_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(read_box_6d963c25_kernel, memories, iteration.size())) {
        const read_box_6d963c25_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_y = std::uint64_t(from->extent().y),
            .from_extent_x = std::uint64_t(from->extent().x),
            .to_extent_y = std::uint64_t(to->extent().y),
            .to_extent_x = std::uint64_t(to->extent().x),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_6d963c25_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_6d963c25_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const read_box_6d963c25_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent = to->extent(),
        };
        commands.dispatch(read_box_6d963c25_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_6d963c25_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent = from->extent(),
            .to_extent = to->extent(),
        };
        commands.dispatch(read_box_6d963c25_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_6d963c25_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct write_box_e5b112ea_direct_parameters {
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(write_box_e5b112ea_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_e5b112ea_direct_parameters, to_extent) == 12);
struct write_box_e5b112ea_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(write_box_e5b112ea_general_parameters, size) == 0);
static_assert(offsetof(write_box_e5b112ea_general_parameters, from_origin) == 12);
static_assert(offsetof(write_box_e5b112ea_general_parameters, to_origin) == 24);
static_assert(offsetof(write_box_e5b112ea_general_parameters, from_extent) == 36);
static_assert(offsetof(write_box_e5b112ea_general_parameters, to_extent) == 48);
struct write_box_e5b112ea_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    std::uint64_t from_extent_y;
    std::uint64_t from_extent_x;
    std::uint64_t to_extent_y;
    std::uint64_t to_extent_x;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_e5b112ea_wide_parameters, size) == 0);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, from_origin) == 12);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, to_origin) == 24);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, base) == 36);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, from_extent_y) == 48);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, from_extent_x) == 56);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, to_extent_y) == 64);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, to_extent_x) == 72);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, from_data_address) == 80);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, to_data_address) == 88);
}  // namespace

extern const glift::Kernel write_box_e5b112ea_kernel;

GLIFT_SHARED void write_box_e5b112ea(const glift::Commands& commands, const glift::Range<Box_3_float>& from,
    const glift::Range<::std_array::Array_3_float_none_buffer>& to) {
    glift::Iteration iteration(write_box_e5b112ea_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(write_box_e5b112ea_kernel, memories, iteration.size())) {
        const write_box_e5b112ea_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_y = std::uint64_t(from->extent().y),
            .from_extent_x = std::uint64_t(from->extent().x),
            .to_extent_y = std::uint64_t(to->extent().y),
            .to_extent_x = std::uint64_t(to->extent().x),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(write_box_e5b112ea_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_e5b112ea_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const write_box_e5b112ea_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent = to->extent(),
        };
        commands.dispatch(write_box_e5b112ea_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_e5b112ea_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent = from->extent(),
            .to_extent = to->extent(),
        };
        commands.dispatch(write_box_e5b112ea_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_e5b112ea_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct fill_box_bdadf51c_direct_parameters {
    uint3 to_extent;
    float value;
};
static_assert(offsetof(fill_box_bdadf51c_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_bdadf51c_direct_parameters, value) == 12);
struct fill_box_bdadf51c_general_parameters {
    uint3 size;
    uint3 to_origin;
    uint3 to_extent;
    float value;
};
static_assert(offsetof(fill_box_bdadf51c_general_parameters, size) == 0);
static_assert(offsetof(fill_box_bdadf51c_general_parameters, to_origin) == 12);
static_assert(offsetof(fill_box_bdadf51c_general_parameters, to_extent) == 24);
static_assert(offsetof(fill_box_bdadf51c_general_parameters, value) == 36);
struct fill_box_bdadf51c_wide_parameters {
    uint3 size;
    uint3 to_origin;
    uint3 base;
    std::uint64_t to_extent_y;
    std::uint64_t to_extent_x;
    float value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, to_origin) == 12);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, base) == 24);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, to_extent_y) == 40);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, to_extent_x) == 48);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, value) == 56);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, to_data_address) == 64);
}  // namespace

extern const glift::Kernel fill_box_bdadf51c_kernel;

GLIFT_SHARED void fill_box_bdadf51c(const glift::Commands& commands,
    const glift::Range<::std_array::Array_3_float_none_buffer>& to, float value) {
    glift::Iteration iteration(fill_box_bdadf51c_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_bdadf51c_kernel, memories, iteration.size())) {
        const fill_box_bdadf51c_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_y = std::uint64_t(to->extent().y),
            .to_extent_x = std::uint64_t(to->extent().x),
            .value = value,
            .to_data_address = 0u,
        };
        commands.dispatch(fill_box_bdadf51c_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_bdadf51c_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const fill_box_bdadf51c_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_bdadf51c_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_bdadf51c_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_bdadf51c_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_bdadf51c_general_parameters,
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

}  // namespace std_transfer

