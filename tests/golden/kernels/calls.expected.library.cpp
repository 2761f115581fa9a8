// Made by gliftc from calls.glift. Changes are lost when it is made again.
#include "calls.glift.internal.hpp"

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

}  // namespace std_array

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

}  // namespace std_transfer

