// Made by gliftc from frames.glift. Changes are lost when it is made again.
#include "frames.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

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
struct read_box_1f848e0d_direct_parameters {
    uint from_frames_n;
    uint from_data_extent;
};
static_assert(offsetof(read_box_1f848e0d_direct_parameters, from_frames_n) == 0);
static_assert(offsetof(read_box_1f848e0d_direct_parameters, from_data_extent) == 4);
struct read_box_1f848e0d_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint from_frames_n;
    uint from_data_extent;
};
static_assert(offsetof(read_box_1f848e0d_general_parameters, size) == 0);
static_assert(offsetof(read_box_1f848e0d_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_1f848e0d_general_parameters, to_origin) == 8);
static_assert(offsetof(read_box_1f848e0d_general_parameters, from_frames_n) == 12);
static_assert(offsetof(read_box_1f848e0d_general_parameters, from_data_extent) == 16);
struct read_box_1f848e0d_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint from_frames_n;
    std::uint64_t from_data_extent;
    std::uint64_t from_frames_data_address;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_1f848e0d_wide_parameters, size) == 0);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, from_origin) == 4);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, to_origin) == 8);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, from_frames_n) == 12);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, from_data_extent) == 16);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, from_frames_data_address) == 24);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, from_data_address) == 32);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, to_data_address) == 40);
}  // namespace

extern const glift::Kernel read_box_1f848e0d_kernel;

GLIFT_SHARED void read_box_1f848e0d(const glift::Commands& commands, const glift::Range<::frames::Pool>& from,
    const glift::Range<Box_1_float>& to) {
    glift::Iteration iteration(read_box_1f848e0d_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->frames().data(), from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(read_box_1f848e0d_kernel, memories, iteration.size())) {
        const read_box_1f848e0d_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_frames_n = from->frames().n(),
            .from_data_extent = from->data_extent(),
            .from_frames_data_address = 0u,
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_1f848e0d_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_1f848e0d_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const read_box_1f848e0d_direct_parameters parameters = {
            .from_frames_n = from->frames().n(),
            .from_data_extent = glift::fitted(from->data_extent()),
        };
        commands.dispatch(read_box_1f848e0d_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_1f848e0d_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_frames_n = from->frames().n(),
            .from_data_extent = glift::fitted(from->data_extent()),
        };
        commands.dispatch(read_box_1f848e0d_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_1f848e0d_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct write_box_31432b0a_direct_parameters {
    uint from_extent;
    uint to_frames_n;
    uint to_data_extent;
};
static_assert(offsetof(write_box_31432b0a_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_31432b0a_direct_parameters, to_frames_n) == 4);
static_assert(offsetof(write_box_31432b0a_direct_parameters, to_data_extent) == 8);
struct write_box_31432b0a_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint to_frames_n;
    uint to_data_extent;
};
static_assert(offsetof(write_box_31432b0a_general_parameters, size) == 0);
static_assert(offsetof(write_box_31432b0a_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_31432b0a_general_parameters, to_origin) == 8);
static_assert(offsetof(write_box_31432b0a_general_parameters, to_frames_n) == 12);
static_assert(offsetof(write_box_31432b0a_general_parameters, to_data_extent) == 16);
struct write_box_31432b0a_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint to_frames_n;
    std::uint64_t to_data_extent;
    std::uint64_t from_data_address;
    std::uint64_t to_frames_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_31432b0a_wide_parameters, size) == 0);
static_assert(offsetof(write_box_31432b0a_wide_parameters, from_origin) == 4);
static_assert(offsetof(write_box_31432b0a_wide_parameters, to_origin) == 8);
static_assert(offsetof(write_box_31432b0a_wide_parameters, to_frames_n) == 12);
static_assert(offsetof(write_box_31432b0a_wide_parameters, to_data_extent) == 16);
static_assert(offsetof(write_box_31432b0a_wide_parameters, from_data_address) == 24);
static_assert(offsetof(write_box_31432b0a_wide_parameters, to_frames_data_address) == 32);
static_assert(offsetof(write_box_31432b0a_wide_parameters, to_data_address) == 40);
}  // namespace

extern const glift::Kernel write_box_31432b0a_kernel;

GLIFT_SHARED void write_box_31432b0a(const glift::Commands& commands, const glift::Range<Box_1_float>& from,
    const glift::Range<::frames::Pool>& to) {
    glift::Iteration iteration(write_box_31432b0a_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->frames().data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(write_box_31432b0a_kernel, memories, iteration.size())) {
        const write_box_31432b0a_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_frames_n = to->frames().n(),
            .to_data_extent = to->data_extent(),
            .from_data_address = 0u,
            .to_frames_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(write_box_31432b0a_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_31432b0a_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const write_box_31432b0a_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_frames_n = to->frames().n(),
            .to_data_extent = glift::fitted(to->data_extent()),
        };
        commands.dispatch(write_box_31432b0a_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_31432b0a_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_frames_n = to->frames().n(),
            .to_data_extent = glift::fitted(to->data_extent()),
        };
        commands.dispatch(write_box_31432b0a_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_31432b0a_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct fill_box_frames_Pool_float_direct_parameters {
    uint to_frames_n;
    uint to_data_extent;
    float value;
};
static_assert(offsetof(fill_box_frames_Pool_float_direct_parameters, to_frames_n) == 0);
static_assert(offsetof(fill_box_frames_Pool_float_direct_parameters, to_data_extent) == 4);
static_assert(offsetof(fill_box_frames_Pool_float_direct_parameters, value) == 8);
struct fill_box_frames_Pool_float_general_parameters {
    uint size;
    uint to_origin;
    uint to_frames_n;
    uint to_data_extent;
    float value;
};
static_assert(offsetof(fill_box_frames_Pool_float_general_parameters, size) == 0);
static_assert(offsetof(fill_box_frames_Pool_float_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_frames_Pool_float_general_parameters, to_frames_n) == 8);
static_assert(offsetof(fill_box_frames_Pool_float_general_parameters, to_data_extent) == 12);
static_assert(offsetof(fill_box_frames_Pool_float_general_parameters, value) == 16);
struct fill_box_frames_Pool_float_wide_parameters {
    uint size;
    uint to_origin;
    uint to_frames_n;
    std::uint64_t to_data_extent;
    float value;
    std::uint64_t to_frames_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, to_frames_n) == 8);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, to_data_extent) == 16);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, value) == 24);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, to_frames_data_address) == 32);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, to_data_address) == 40);
}  // namespace

extern const glift::Kernel fill_box_frames_Pool_float_kernel;

GLIFT_SHARED void fill_box_frames_Pool_float(const glift::Commands& commands, const glift::Range<::frames::Pool>& to,
    float value) {
    glift::Iteration iteration(fill_box_frames_Pool_float_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->frames().data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {to});
    if (commands.needs_wide(fill_box_frames_Pool_float_kernel, memories, iteration.size())) {
        const fill_box_frames_Pool_float_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_frames_n = to->frames().n(),
            .to_data_extent = to->data_extent(),
            .value = value,
            .to_frames_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(fill_box_frames_Pool_float_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_frames_Pool_float_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const fill_box_frames_Pool_float_direct_parameters parameters = {
            .to_frames_n = to->frames().n(),
            .to_data_extent = glift::fitted(to->data_extent()),
            .value = value,
        };
        commands.dispatch(fill_box_frames_Pool_float_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const fill_box_frames_Pool_float_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_frames_n = to->frames().n(),
            .to_data_extent = glift::fitted(to->data_extent()),
            .value = value,
        };
        commands.dispatch(fill_box_frames_Pool_float_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_frames_Pool_float_general_parameters, size)}), .sharing = iteration.sharing()});
    }
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

