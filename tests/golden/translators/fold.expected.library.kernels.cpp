// Made by gliftc from fold.glift. Changes are lost when it is made again.
#include "fold.glift.types.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace std_transfer {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Field, Box<3, float>>

namespace {
struct read_box_0059b9f4_direct_parameters {
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(read_box_0059b9f4_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_0059b9f4_direct_parameters, to_extent) == 12);

// transfer.glift:15: runs kernel read_box<Field, Box<3, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_0059b9f4_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_0059b9f4_direct_parameters*>(call.parameters);
    const uint3 from_extent = parameters.from_extent;
    const uint3 to_extent = parameters.to_extent;
    const glift::HostMemory& from_data = call.memories[0];
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:15
            const uint to_at = (address.z * to_extent.y + address.y) * to_extent.x + address.x;
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint3 address{row.begin + static_cast<uint>(i), row.y, row.z};
                // transfer.glift:15
                const uint from_i = (address.z * from_extent.y + address.y) * from_extent.x + address.x;
                const uint2 from_at = uint2(from_i % 64u, from_i / 64u);
                // transfer.glift:16
                to_data_row[i] = glift::host::load_texel<glift::Format::r32f, float>(from_data, int2(from_at));
            }
        }
    }
}

static void read_box_0059b9f4_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_0059b9f4_direct_rows(call, rows); });
}

struct read_box_0059b9f4_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(read_box_0059b9f4_general_parameters, size) == 0);
static_assert(offsetof(read_box_0059b9f4_general_parameters, from_origin) == 12);
static_assert(offsetof(read_box_0059b9f4_general_parameters, to_origin) == 24);
static_assert(offsetof(read_box_0059b9f4_general_parameters, from_extent) == 36);
static_assert(offsetof(read_box_0059b9f4_general_parameters, to_extent) == 48);

// transfer.glift:15: runs kernel read_box<Field, Box<3, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_0059b9f4_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_0059b9f4_general_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const uint3 from_extent = parameters.from_extent;
    const uint3 to_extent = parameters.to_extent;
    const glift::HostMemory& from_data = call.memories[0];
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:16
            const uint3 to_address = to_origin + address;
            // transfer.glift:15
            const uint to_at = (to_address.z * to_extent.y + to_address.y) * to_extent.x + to_address.x;
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint3 address{row.begin + static_cast<uint>(i), row.y, row.z};
                // transfer.glift:16
                const uint3 from_address = from_origin + address;
                // transfer.glift:15
                const uint from_i = (from_address.z * from_extent.y + from_address.y) * from_extent.x + from_address.x;
                const uint2 from_at = uint2(from_i % 64u, from_i / 64u);
                // transfer.glift:16
                to_data_row[i] = glift::host::load_texel<glift::Format::r32f, float>(from_data, int2(from_at));
            }
        }
    }
}

static void read_box_0059b9f4_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_0059b9f4_general_rows(call,
        rows); });
}

struct read_box_0059b9f4_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    uint3 from_extent;
    std::uint64_t to_extent_y;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_0059b9f4_wide_parameters, size) == 0);
static_assert(offsetof(read_box_0059b9f4_wide_parameters, from_origin) == 12);
static_assert(offsetof(read_box_0059b9f4_wide_parameters, to_origin) == 24);
static_assert(offsetof(read_box_0059b9f4_wide_parameters, base) == 36);
static_assert(offsetof(read_box_0059b9f4_wide_parameters, from_extent) == 48);
static_assert(offsetof(read_box_0059b9f4_wide_parameters, to_extent_y) == 64);
static_assert(offsetof(read_box_0059b9f4_wide_parameters, to_extent_x) == 72);
static_assert(offsetof(read_box_0059b9f4_wide_parameters, to_data_address) == 80);

// transfer.glift:15: runs kernel read_box<Field, Box<3, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_0059b9f4_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_0059b9f4_wide_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const uint3 from_extent = parameters.from_extent;
    const std::uint64_t to_extent_y = parameters.to_extent_y;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_data = call.memories[0];
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:16
            const uint3 from_address = from_origin + address;
            // transfer.glift:15
            const uint from_i = (from_address.z * from_extent.y + from_address.y) * from_extent.x + from_address.x;
            const uint2 from_at = uint2(from_i % 64u, from_i / 64u);
            // transfer.glift:16
            const uint3 to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = (std::uint64_t(to_address.z) * to_extent_y
                + std::uint64_t(to_address.y)) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:16
            to_data[to_at] = glift::host::load_texel<glift::Format::r32f, float>(from_data, int2(from_at));
        }
    }
}

static void read_box_0059b9f4_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_0059b9f4_wide_rows(call, rows); });
}

const glift::Binding read_box_0059b9f4_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read, .sampled = true},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 80,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter read_box_0059b9f4_parameters[] = {
    {"from_extent", 0, sizeof(read_box_0059b9f4_direct_parameters::from_extent)},
    {"to_extent", 12, sizeof(read_box_0059b9f4_direct_parameters::to_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_0059b9f4_kernel;
const glift::Kernel read_box_0059b9f4_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = read_box_0059b9f4_bindings,
    .direct = {.host = &read_box_0059b9f4_direct, .parameter_bytes = 24, .push_constants = true},
    .general = {.host = &read_box_0059b9f4_general, .parameter_bytes = 60},
    .wide = {.host = &read_box_0059b9f4_wide, .parameter_bytes = 88, .base_offset = 36},
    .parameters = read_box_0059b9f4_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<3, float>, Field>

namespace {
struct write_box_16a1dc11_direct_parameters {
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(write_box_16a1dc11_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_16a1dc11_direct_parameters, to_extent) == 12);

// transfer.glift:20: runs kernel write_box<Box<3, float>, Field> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_16a1dc11_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_16a1dc11_direct_parameters*>(call.parameters);
    const uint3 from_extent = parameters.from_extent;
    const uint3 to_extent = parameters.to_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:20
            const uint from_at = (address.z * from_extent.y + address.y) * from_extent.x + address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint3 address{row.begin + static_cast<uint>(i), row.y, row.z};
                // transfer.glift:20
                const uint to_i = (address.z * to_extent.y + address.y) * to_extent.x + address.x;
                const uint2 to_at = uint2(to_i % 64u, to_i / 64u);
                // transfer.glift:21
                glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(to_at), from_data_row[i]);
            }
        }
    }
}

static void write_box_16a1dc11_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_16a1dc11_direct_rows(call,
        rows); });
}

struct write_box_16a1dc11_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(write_box_16a1dc11_general_parameters, size) == 0);
static_assert(offsetof(write_box_16a1dc11_general_parameters, from_origin) == 12);
static_assert(offsetof(write_box_16a1dc11_general_parameters, to_origin) == 24);
static_assert(offsetof(write_box_16a1dc11_general_parameters, from_extent) == 36);
static_assert(offsetof(write_box_16a1dc11_general_parameters, to_extent) == 48);

// transfer.glift:20: runs kernel write_box<Box<3, float>, Field> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_16a1dc11_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_16a1dc11_general_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const uint3 from_extent = parameters.from_extent;
    const uint3 to_extent = parameters.to_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:21
            const uint3 from_address = from_origin + address;
            // transfer.glift:20
            const uint from_at = (from_address.z * from_extent.y + from_address.y) * from_extent.x + from_address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint3 address{row.begin + static_cast<uint>(i), row.y, row.z};
                // transfer.glift:21
                const uint3 to_address = to_origin + address;
                // transfer.glift:20
                const uint to_i = (to_address.z * to_extent.y + to_address.y) * to_extent.x + to_address.x;
                const uint2 to_at = uint2(to_i % 64u, to_i / 64u);
                // transfer.glift:21
                glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(to_at), from_data_row[i]);
            }
        }
    }
}

static void write_box_16a1dc11_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_16a1dc11_general_rows(call,
        rows); });
}

struct write_box_16a1dc11_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    std::uint64_t from_extent_y;
    std::uint64_t from_extent_x;
    uint3 to_extent;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_16a1dc11_wide_parameters, size) == 0);
static_assert(offsetof(write_box_16a1dc11_wide_parameters, from_origin) == 12);
static_assert(offsetof(write_box_16a1dc11_wide_parameters, to_origin) == 24);
static_assert(offsetof(write_box_16a1dc11_wide_parameters, base) == 36);
static_assert(offsetof(write_box_16a1dc11_wide_parameters, from_extent_y) == 48);
static_assert(offsetof(write_box_16a1dc11_wide_parameters, from_extent_x) == 56);
static_assert(offsetof(write_box_16a1dc11_wide_parameters, to_extent) == 64);
static_assert(offsetof(write_box_16a1dc11_wide_parameters, from_data_address) == 80);

// transfer.glift:20: runs kernel write_box<Box<3, float>, Field> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_16a1dc11_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_16a1dc11_wide_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_y = parameters.from_extent_y;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const uint3 to_extent = parameters.to_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:21
            const uint3 from_address = from_origin + address;
            // transfer.glift:20
            const std::uint64_t from_at = (std::uint64_t(from_address.z) * from_extent_y
                + std::uint64_t(from_address.y)) * from_extent_x + std::uint64_t(from_address.x);
            // transfer.glift:21
            const uint3 to_address = to_origin + address;
            // transfer.glift:20
            const uint to_i = (to_address.z * to_extent.y + to_address.y) * to_extent.x + to_address.x;
            const uint2 to_at = uint2(to_i % 64u, to_i / 64u);
            // transfer.glift:21
            glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(to_at), from_data[from_at]);
        }
    }
}

static void write_box_16a1dc11_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_16a1dc11_wide_rows(call, rows); });
}

const glift::Binding write_box_16a1dc11_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 80,
        .element_bytes = sizeof(float)},
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter write_box_16a1dc11_parameters[] = {
    {"from_extent", 0, sizeof(write_box_16a1dc11_direct_parameters::from_extent)},
    {"to_extent", 12, sizeof(write_box_16a1dc11_direct_parameters::to_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_16a1dc11_kernel;
const glift::Kernel write_box_16a1dc11_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = write_box_16a1dc11_bindings,
    .direct = {.host = &write_box_16a1dc11_direct, .parameter_bytes = 24, .push_constants = true},
    .general = {.host = &write_box_16a1dc11_general, .parameter_bytes = 60},
    .wide = {.host = &write_box_16a1dc11_wide, .parameter_bytes = 88, .base_offset = 36},
    .parameters = write_box_16a1dc11_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Field, float>

namespace {
struct fill_box_fold_Field_float_direct_parameters {
    uint3 to_extent;
    float value;
};
static_assert(offsetof(fill_box_fold_Field_float_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_fold_Field_float_direct_parameters, value) == 12);

// transfer.glift:25: runs kernel fill_box<Field, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_fold_Field_float_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_fold_Field_float_direct_parameters*>(call.parameters);
    const uint3 to_extent = parameters.to_extent;
    const float value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:25
            const uint to_i = (address.z * to_extent.y + address.y) * to_extent.x + address.x;
            const uint2 to_at = uint2(to_i % 64u, to_i / 64u);
            // transfer.glift:26
            glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(to_at), value);
        }
    }
}

static void fill_box_fold_Field_float_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_fold_Field_float_direct_rows(call,
        rows); });
}

struct fill_box_fold_Field_float_general_parameters {
    uint3 size;
    uint3 to_origin;
    uint3 to_extent;
    float value;
};
static_assert(offsetof(fill_box_fold_Field_float_general_parameters, size) == 0);
static_assert(offsetof(fill_box_fold_Field_float_general_parameters, to_origin) == 12);
static_assert(offsetof(fill_box_fold_Field_float_general_parameters, to_extent) == 24);
static_assert(offsetof(fill_box_fold_Field_float_general_parameters, value) == 36);

// transfer.glift:25: runs kernel fill_box<Field, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_fold_Field_float_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_fold_Field_float_general_parameters*>(call.parameters);
    const uint3 to_origin = parameters.to_origin;
    const uint3 to_extent = parameters.to_extent;
    const float value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:26
            const uint3 to_address = to_origin + address;
            // transfer.glift:25
            const uint to_i = (to_address.z * to_extent.y + to_address.y) * to_extent.x + to_address.x;
            const uint2 to_at = uint2(to_i % 64u, to_i / 64u);
            // transfer.glift:26
            glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(to_at), value);
        }
    }
}

static void fill_box_fold_Field_float_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_fold_Field_float_general_rows(call,
        rows); });
}

struct fill_box_fold_Field_float_wide_parameters {
    uint3 size;
    uint3 to_origin;
    uint3 base;
    uint3 to_extent;
    float value;
};
static_assert(offsetof(fill_box_fold_Field_float_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_fold_Field_float_wide_parameters, to_origin) == 12);
static_assert(offsetof(fill_box_fold_Field_float_wide_parameters, base) == 24);
static_assert(offsetof(fill_box_fold_Field_float_wide_parameters, to_extent) == 36);
static_assert(offsetof(fill_box_fold_Field_float_wide_parameters, value) == 48);

// transfer.glift:25: runs kernel fill_box<Field, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_fold_Field_float_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_fold_Field_float_wide_parameters*>(call.parameters);
    const uint3 to_origin = parameters.to_origin;
    const uint3 to_extent = parameters.to_extent;
    const float value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:26
            const uint3 to_address = to_origin + address;
            // transfer.glift:25
            const uint to_i = (to_address.z * to_extent.y + to_address.y) * to_extent.x + to_address.x;
            const uint2 to_at = uint2(to_i % 64u, to_i / 64u);
            // transfer.glift:26
            glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(to_at), value);
        }
    }
}

static void fill_box_fold_Field_float_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_fold_Field_float_wide_rows(call,
        rows); });
}

const glift::Binding fill_box_fold_Field_float_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter fill_box_fold_Field_float_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_fold_Field_float_direct_parameters::to_extent)},
    {"value", 12, sizeof(fill_box_fold_Field_float_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_fold_Field_float_kernel;
const glift::Kernel fill_box_fold_Field_float_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = fill_box_fold_Field_float_bindings,
    .direct = {.host = &fill_box_fold_Field_float_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &fill_box_fold_Field_float_general, .parameter_bytes = 40},
    .wide = {.host = &fill_box_fold_Field_float_wide, .parameter_bytes = 52, .base_offset = 24},
    .parameters = fill_box_fold_Field_float_parameters,
    .items = {1, 2, 1},
};

}  // namespace std_transfer

