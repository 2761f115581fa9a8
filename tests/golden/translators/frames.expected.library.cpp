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

namespace {
struct list_there_d62ad97a_direct_parameters {
    uint a_frames_n;
    uint a_data_extent;
    glift::Bool counter_extent_value_0;
    uint addresses_extent;
    uint values_extent;
    uint translated_frames_n;
    uint translated_data_extent;
    uint places_extent;
};
static_assert(offsetof(list_there_d62ad97a_direct_parameters, a_frames_n) == 0);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, a_data_extent) == 4);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, counter_extent_value_0) == 8);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, addresses_extent) == 12);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, values_extent) == 16);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, translated_frames_n) == 20);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, translated_data_extent) == 24);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, places_extent) == 28);
struct list_there_d62ad97a_general_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint counter_origin;
    uint counter_size;
    uint addresses_origin;
    uint addresses_size;
    uint values_origin;
    uint values_size;
    uint translated_origin;
    uint places_origin;
    uint places_size;
    uint from_frames_n;
    uint from_data_extent;
    uint translated_frames_n;
    uint translated_data_extent;
};
static_assert(offsetof(list_there_d62ad97a_general_parameters, size) == 0);
static_assert(offsetof(list_there_d62ad97a_general_parameters, a_origin) == 4);
static_assert(offsetof(list_there_d62ad97a_general_parameters, from_origin) == 8);
static_assert(offsetof(list_there_d62ad97a_general_parameters, counter_origin) == 12);
static_assert(offsetof(list_there_d62ad97a_general_parameters, counter_size) == 16);
static_assert(offsetof(list_there_d62ad97a_general_parameters, addresses_origin) == 20);
static_assert(offsetof(list_there_d62ad97a_general_parameters, addresses_size) == 24);
static_assert(offsetof(list_there_d62ad97a_general_parameters, values_origin) == 28);
static_assert(offsetof(list_there_d62ad97a_general_parameters, values_size) == 32);
static_assert(offsetof(list_there_d62ad97a_general_parameters, translated_origin) == 36);
static_assert(offsetof(list_there_d62ad97a_general_parameters, places_origin) == 40);
static_assert(offsetof(list_there_d62ad97a_general_parameters, places_size) == 44);
static_assert(offsetof(list_there_d62ad97a_general_parameters, from_frames_n) == 48);
static_assert(offsetof(list_there_d62ad97a_general_parameters, from_data_extent) == 52);
static_assert(offsetof(list_there_d62ad97a_general_parameters, translated_frames_n) == 56);
static_assert(offsetof(list_there_d62ad97a_general_parameters, translated_data_extent) == 60);
struct list_there_d62ad97a_wide_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint counter_origin;
    uint counter_size;
    uint addresses_origin;
    uint addresses_size;
    uint values_origin;
    uint values_size;
    uint translated_origin;
    uint places_origin;
    uint places_size;
    uint from_frames_n;
    std::uint64_t from_data_extent;
    uint translated_frames_n;
    std::uint64_t translated_data_extent;
    std::uint64_t from_frames_data_address;
    std::uint64_t from_data_address;
    std::uint64_t counter_data_address;
    std::uint64_t addresses_data_address;
    std::uint64_t values_data_address;
    std::uint64_t translated_frames_data_address;
    std::uint64_t places_data_address;
};
static_assert(offsetof(list_there_d62ad97a_wide_parameters, size) == 0);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, a_origin) == 4);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, from_origin) == 8);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, counter_origin) == 12);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, counter_size) == 16);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, addresses_origin) == 20);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, addresses_size) == 24);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, values_origin) == 28);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, values_size) == 32);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, translated_origin) == 36);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, places_origin) == 40);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, places_size) == 44);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, from_frames_n) == 48);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, from_data_extent) == 56);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, translated_frames_n) == 64);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, translated_data_extent) == 72);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, from_frames_data_address) == 80);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, from_data_address) == 88);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, counter_data_address) == 96);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, addresses_data_address) == 104);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, values_data_address) == 112);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, translated_frames_data_address) == 120);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, places_data_address) == 128);
}  // namespace

extern const glift::Kernel list_there_d62ad97a_kernel;

GLIFT_SHARED void list_there_d62ad97a(const glift::Commands& commands, const glift::Range<::frames::Pool>& a,
    const glift::Range<::frames::Pool>& from, const glift::Range<::frames::Pool>& translated,
    const glift::Range<Box_1_uint>& counter, const glift::Range<Box_1_uint>& addresses,
    const glift::Range<Box_1_uint>& places, const glift::Range<Box_1_float>& values) {
    glift::Iteration iteration(list_there_d62ad97a_kernel);
    iteration.each("a", a);
    iteration.any("from", from);
    iteration.any("translated", translated);
    iteration.any("counter", counter);
    iteration.any("addresses", addresses);
    iteration.any("places", places);
    iteration.any("values", values);
    const glift::Memory memories[] = {from->frames().data(), from->data(), counter->data(), addresses->data(),
        values->data(), translated->frames().data(), places->data()};
    if (iteration.is_shared(memories)) iteration.share(memories,
        {a, from, translated, counter, addresses, places, values});
    if (commands.needs_wide(list_there_d62ad97a_kernel, memories, iteration.size())) {
        const list_there_d62ad97a_wide_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
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
            .from_frames_n = from->frames().n(),
            .from_data_extent = from->data_extent(),
            .translated_frames_n = translated->frames().n(),
            .translated_data_extent = translated->data_extent(),
            .from_frames_data_address = 0u,
            .from_data_address = 0u,
            .counter_data_address = 0u,
            .addresses_data_address = 0u,
            .values_data_address = 0u,
            .translated_frames_data_address = 0u,
            .places_data_address = 0u,
        };
        iteration.count(counter, offsetof(list_there_d62ad97a_wide_parameters, counter_size));
        iteration.count(addresses, offsetof(list_there_d62ad97a_wide_parameters, addresses_size));
        iteration.count(values, offsetof(list_there_d62ad97a_wide_parameters, values_size));
        iteration.count(places, offsetof(list_there_d62ad97a_wide_parameters, places_size));
        commands.dispatch(list_there_d62ad97a_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(list_there_d62ad97a_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && a->same_state(from.structure())) {
        const list_there_d62ad97a_direct_parameters parameters = {
            .a_frames_n = a->frames().n(),
            .a_data_extent = glift::fitted(a->data_extent()),
            .counter_extent_value_0 = 0u < counter->extent(),
            .addresses_extent = addresses->extent(),
            .values_extent = values->extent(),
            .translated_frames_n = translated->frames().n(),
            .translated_data_extent = glift::fitted(translated->data_extent()),
            .places_extent = places->extent(),
        };
        commands.dispatch(list_there_d62ad97a_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const list_there_d62ad97a_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
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
            .from_frames_n = from->frames().n(),
            .from_data_extent = glift::fitted(from->data_extent()),
            .translated_frames_n = translated->frames().n(),
            .translated_data_extent = glift::fitted(translated->data_extent()),
        };
        iteration.count(counter, offsetof(list_there_d62ad97a_general_parameters, counter_size));
        iteration.count(addresses, offsetof(list_there_d62ad97a_general_parameters, addresses_size));
        iteration.count(values, offsetof(list_there_d62ad97a_general_parameters, values_size));
        iteration.count(places, offsetof(list_there_d62ad97a_general_parameters, places_size));
        commands.dispatch(list_there_d62ad97a_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(list_there_d62ad97a_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct read_box_c62e930d_direct_parameters {
    uint from_n;
};
static_assert(offsetof(read_box_c62e930d_direct_parameters, from_n) == 0);
struct read_box_c62e930d_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_c62e930d_general_parameters, size) == 0);
static_assert(offsetof(read_box_c62e930d_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_c62e930d_general_parameters, to_origin) == 8);
struct read_box_c62e930d_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_c62e930d_wide_parameters, size) == 0);
static_assert(offsetof(read_box_c62e930d_wide_parameters, from_origin) == 4);
static_assert(offsetof(read_box_c62e930d_wide_parameters, to_origin) == 8);
static_assert(offsetof(read_box_c62e930d_wide_parameters, from_data_address) == 16);
static_assert(offsetof(read_box_c62e930d_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel read_box_c62e930d_kernel;

GLIFT_SHARED void read_box_c62e930d(const glift::Commands& commands, const glift::Range<::frames::Frames>& from,
    const glift::Range<Box_1_uint>& to) {
    glift::Iteration iteration(read_box_c62e930d_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(read_box_c62e930d_kernel, memories, iteration.size())) {
        const read_box_c62e930d_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_c62e930d_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_c62e930d_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const read_box_c62e930d_direct_parameters parameters = {
            .from_n = from->n(),
        };
        commands.dispatch(read_box_c62e930d_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_c62e930d_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(read_box_c62e930d_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_c62e930d_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct write_box_32448ca0_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_32448ca0_direct_parameters, from_extent) == 0);
struct write_box_32448ca0_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_32448ca0_general_parameters, size) == 0);
static_assert(offsetof(write_box_32448ca0_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_32448ca0_general_parameters, to_origin) == 8);
struct write_box_32448ca0_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_32448ca0_wide_parameters, size) == 0);
static_assert(offsetof(write_box_32448ca0_wide_parameters, from_origin) == 4);
static_assert(offsetof(write_box_32448ca0_wide_parameters, to_origin) == 8);
static_assert(offsetof(write_box_32448ca0_wide_parameters, from_data_address) == 16);
static_assert(offsetof(write_box_32448ca0_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel write_box_32448ca0_kernel;

GLIFT_SHARED void write_box_32448ca0(const glift::Commands& commands, const glift::Range<Box_1_uint>& from,
    const glift::Range<::frames::Frames>& to) {
    glift::Iteration iteration(write_box_32448ca0_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(write_box_32448ca0_kernel, memories, iteration.size())) {
        const write_box_32448ca0_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(write_box_32448ca0_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_32448ca0_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const write_box_32448ca0_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_32448ca0_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_32448ca0_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(write_box_32448ca0_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_32448ca0_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct fill_box_frames_Frames_uint_direct_parameters {
    uint to_n;
    uint value;
};
static_assert(offsetof(fill_box_frames_Frames_uint_direct_parameters, to_n) == 0);
static_assert(offsetof(fill_box_frames_Frames_uint_direct_parameters, value) == 4);
struct fill_box_frames_Frames_uint_general_parameters {
    uint size;
    uint to_origin;
    uint value;
};
static_assert(offsetof(fill_box_frames_Frames_uint_general_parameters, size) == 0);
static_assert(offsetof(fill_box_frames_Frames_uint_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_frames_Frames_uint_general_parameters, value) == 8);
struct fill_box_frames_Frames_uint_wide_parameters {
    uint size;
    uint to_origin;
    uint value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_frames_Frames_uint_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_frames_Frames_uint_wide_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_frames_Frames_uint_wide_parameters, value) == 8);
static_assert(offsetof(fill_box_frames_Frames_uint_wide_parameters, to_data_address) == 16);
}  // namespace

extern const glift::Kernel fill_box_frames_Frames_uint_kernel;

GLIFT_SHARED void fill_box_frames_Frames_uint(const glift::Commands& commands, const glift::Range<::frames::Frames>& to,
    uint value) {
    glift::Iteration iteration(fill_box_frames_Frames_uint_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_frames_Frames_uint_kernel, memories, iteration.size())) {
        const fill_box_frames_Frames_uint_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
            .to_data_address = 0u,
        };
        commands.dispatch(fill_box_frames_Frames_uint_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_frames_Frames_uint_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const fill_box_frames_Frames_uint_direct_parameters parameters = {
            .to_n = to->n(),
            .value = value,
        };
        commands.dispatch(fill_box_frames_Frames_uint_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_frames_Frames_uint_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_frames_Frames_uint_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_frames_Frames_uint_general_parameters, size)})});
    }
}

namespace {
struct list_there_ba0d4190_direct_parameters {
    uint a_n;
    glift::Bool counter_extent_value_0;
    uint addresses_extent;
    uint values_extent;
    uint translated_n;
    uint places_extent;
};
static_assert(offsetof(list_there_ba0d4190_direct_parameters, a_n) == 0);
static_assert(offsetof(list_there_ba0d4190_direct_parameters, counter_extent_value_0) == 4);
static_assert(offsetof(list_there_ba0d4190_direct_parameters, addresses_extent) == 8);
static_assert(offsetof(list_there_ba0d4190_direct_parameters, values_extent) == 12);
static_assert(offsetof(list_there_ba0d4190_direct_parameters, translated_n) == 16);
static_assert(offsetof(list_there_ba0d4190_direct_parameters, places_extent) == 20);
struct list_there_ba0d4190_general_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint from_size;
    uint counter_origin;
    uint counter_size;
    uint addresses_origin;
    uint addresses_size;
    uint values_origin;
    uint values_size;
    uint translated_origin;
    uint translated_size;
    uint places_origin;
    uint places_size;
};
static_assert(offsetof(list_there_ba0d4190_general_parameters, size) == 0);
static_assert(offsetof(list_there_ba0d4190_general_parameters, a_origin) == 4);
static_assert(offsetof(list_there_ba0d4190_general_parameters, from_origin) == 8);
static_assert(offsetof(list_there_ba0d4190_general_parameters, from_size) == 12);
static_assert(offsetof(list_there_ba0d4190_general_parameters, counter_origin) == 16);
static_assert(offsetof(list_there_ba0d4190_general_parameters, counter_size) == 20);
static_assert(offsetof(list_there_ba0d4190_general_parameters, addresses_origin) == 24);
static_assert(offsetof(list_there_ba0d4190_general_parameters, addresses_size) == 28);
static_assert(offsetof(list_there_ba0d4190_general_parameters, values_origin) == 32);
static_assert(offsetof(list_there_ba0d4190_general_parameters, values_size) == 36);
static_assert(offsetof(list_there_ba0d4190_general_parameters, translated_origin) == 40);
static_assert(offsetof(list_there_ba0d4190_general_parameters, translated_size) == 44);
static_assert(offsetof(list_there_ba0d4190_general_parameters, places_origin) == 48);
static_assert(offsetof(list_there_ba0d4190_general_parameters, places_size) == 52);
struct list_there_ba0d4190_wide_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint from_size;
    uint counter_origin;
    uint counter_size;
    uint addresses_origin;
    uint addresses_size;
    uint values_origin;
    uint values_size;
    uint translated_origin;
    uint translated_size;
    uint places_origin;
    uint places_size;
    std::uint64_t from_data_address;
    std::uint64_t counter_data_address;
    std::uint64_t addresses_data_address;
    std::uint64_t values_data_address;
    std::uint64_t places_data_address;
};
static_assert(offsetof(list_there_ba0d4190_wide_parameters, size) == 0);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, a_origin) == 4);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, from_origin) == 8);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, from_size) == 12);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, counter_origin) == 16);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, counter_size) == 20);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, addresses_origin) == 24);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, addresses_size) == 28);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, values_origin) == 32);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, values_size) == 36);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, translated_origin) == 40);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, translated_size) == 44);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, places_origin) == 48);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, places_size) == 52);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, from_data_address) == 56);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, counter_data_address) == 64);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, addresses_data_address) == 72);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, values_data_address) == 80);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, places_data_address) == 88);
}  // namespace

extern const glift::Kernel list_there_ba0d4190_kernel;

GLIFT_SHARED void list_there_ba0d4190(const glift::Commands& commands, const glift::Range<::frames::Frames>& a,
    const glift::Range<::frames::Frames>& from, const glift::Range<::frames::Frames>& translated,
    const glift::Range<Box_1_uint>& counter, const glift::Range<Box_1_uint>& addresses,
    const glift::Range<Box_1_uint>& places, const glift::Range<Box_1_uint>& values) {
    glift::Iteration iteration(list_there_ba0d4190_kernel);
    iteration.each("a", a);
    iteration.any("from", from);
    iteration.any("translated", translated);
    iteration.any("counter", counter);
    iteration.any("addresses", addresses);
    iteration.any("places", places);
    iteration.any("values", values);
    const glift::Memory memories[] = {from->data(), counter->data(), addresses->data(), values->data(), places->data()};
    if (iteration.is_shared(memories)) iteration.share(memories,
        {a, from, translated, counter, addresses, places, values});
    if (commands.needs_wide(list_there_ba0d4190_kernel, memories, iteration.size())) {
        const list_there_ba0d4190_wide_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .counter_origin = counter.origin(),
            .counter_size = counter.size(),
            .addresses_origin = addresses.origin(),
            .addresses_size = addresses.size(),
            .values_origin = values.origin(),
            .values_size = values.size(),
            .translated_origin = translated.origin(),
            .translated_size = translated.size(),
            .places_origin = places.origin(),
            .places_size = places.size(),
            .from_data_address = 0u,
            .counter_data_address = 0u,
            .addresses_data_address = 0u,
            .values_data_address = 0u,
            .places_data_address = 0u,
        };
        iteration.count(from, offsetof(list_there_ba0d4190_wide_parameters, from_size));
        iteration.count(counter, offsetof(list_there_ba0d4190_wide_parameters, counter_size));
        iteration.count(addresses, offsetof(list_there_ba0d4190_wide_parameters, addresses_size));
        iteration.count(values, offsetof(list_there_ba0d4190_wide_parameters, values_size));
        iteration.count(translated, offsetof(list_there_ba0d4190_wide_parameters, translated_size));
        iteration.count(places, offsetof(list_there_ba0d4190_wide_parameters, places_size));
        commands.dispatch(list_there_ba0d4190_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(list_there_ba0d4190_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && a->same_state(from.structure())) {
        const list_there_ba0d4190_direct_parameters parameters = {
            .a_n = a->n(),
            .counter_extent_value_0 = 0u < counter->extent(),
            .addresses_extent = addresses->extent(),
            .values_extent = values->extent(),
            .translated_n = translated->n(),
            .places_extent = places->extent(),
        };
        commands.dispatch(list_there_ba0d4190_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const list_there_ba0d4190_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .counter_origin = counter.origin(),
            .counter_size = counter.size(),
            .addresses_origin = addresses.origin(),
            .addresses_size = addresses.size(),
            .values_origin = values.origin(),
            .values_size = values.size(),
            .translated_origin = translated.origin(),
            .translated_size = translated.size(),
            .places_origin = places.origin(),
            .places_size = places.size(),
        };
        iteration.count(from, offsetof(list_there_ba0d4190_general_parameters, from_size));
        iteration.count(counter, offsetof(list_there_ba0d4190_general_parameters, counter_size));
        iteration.count(addresses, offsetof(list_there_ba0d4190_general_parameters, addresses_size));
        iteration.count(values, offsetof(list_there_ba0d4190_general_parameters, values_size));
        iteration.count(translated, offsetof(list_there_ba0d4190_general_parameters, translated_size));
        iteration.count(places, offsetof(list_there_ba0d4190_general_parameters, places_size));
        commands.dispatch(list_there_ba0d4190_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(list_there_ba0d4190_general_parameters,
            size)}), .sharing = iteration.sharing()});
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

