// Made by gliftc from texture_unit.glift. Changes are lost when it is made again.
#include "texture_unit.glift.types.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace std_transfer {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Shadows, Box<3, float>>

namespace {
struct read_box_89e7a8a0_direct_parameters {
    uint3 from_domain;
    uint3 to_extent;
    uint from_extent_y;
};
static_assert(offsetof(read_box_89e7a8a0_direct_parameters, from_domain) == 0);
static_assert(offsetof(read_box_89e7a8a0_direct_parameters, to_extent) == 12);
static_assert(offsetof(read_box_89e7a8a0_direct_parameters, from_extent_y) == 24);

// transfer.glift:15: runs kernel read_box<Shadows, Box<3, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_89e7a8a0_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_89e7a8a0_direct_parameters*>(call.parameters);
    const uint3 to_extent = parameters.to_extent;
    const glift::HostMemory& from_depths = call.memories[0];
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
                // transfer.glift:16
                to_data_row[i] = glift::host::load_texel<glift::Format::d32, float>(from_depths, int3(address));
            }
        }
    }
}

static void read_box_89e7a8a0_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_89e7a8a0_direct_rows(call, rows); });
}

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

// transfer.glift:15: runs kernel read_box<Shadows, Box<3, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_89e7a8a0_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_89e7a8a0_general_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const uint3 to_extent = parameters.to_extent;
    const glift::HostMemory& from_depths = call.memories[0];
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
                to_data_row[i] = glift::host::load_texel<glift::Format::d32, float>(from_depths, int3(from_address));
            }
        }
    }
}

static void read_box_89e7a8a0_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_89e7a8a0_general_rows(call,
        rows); });
}

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

// transfer.glift:15: runs kernel read_box<Shadows, Box<3, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_89e7a8a0_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_89e7a8a0_wide_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const std::uint64_t to_extent_y = parameters.to_extent_y;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_depths = call.memories[0];
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:16
            const uint3 from_address = from_origin + address;
            const uint3 to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = (std::uint64_t(to_address.z) * to_extent_y
                + std::uint64_t(to_address.y)) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:16
            to_data[to_at] = glift::host::load_texel<glift::Format::d32, float>(from_depths, int3(from_address));
        }
    }
}

static void read_box_89e7a8a0_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_89e7a8a0_wide_rows(call, rows); });
}

const glift::Binding read_box_89e7a8a0_bindings[] = {
    {.name = "from.depths", .kind = glift::MemoryKind::image2darray, .access = glift::Access::read, .sampled = true},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 64,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter read_box_89e7a8a0_parameters[] = {
    {"from_domain", 0, sizeof(read_box_89e7a8a0_direct_parameters::from_domain)},
    {"to_extent", 12, sizeof(read_box_89e7a8a0_direct_parameters::to_extent)},
    {"from_extent_y", 24, sizeof(read_box_89e7a8a0_direct_parameters::from_extent_y)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_89e7a8a0_kernel;
const glift::Kernel read_box_89e7a8a0_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = read_box_89e7a8a0_bindings,
    .direct = {.host = &read_box_89e7a8a0_direct, .parameter_bytes = 28, .push_constants = true},
    .general = {.host = &read_box_89e7a8a0_general, .parameter_bytes = 48},
    .wide = {.host = &read_box_89e7a8a0_wide, .parameter_bytes = 72, .base_offset = 36},
    .parameters = read_box_89e7a8a0_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Heights, Box<2, float>>

namespace {
struct read_box_0976d8f6_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_0976d8f6_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_0976d8f6_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: runs kernel read_box<Heights, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_0976d8f6_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_0976d8f6_direct_parameters*>(call.parameters);
    const uint to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_data = call.memories[0];
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:15
            const uint to_at = address.y * to_extent_x + address.x;
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:16
                to_data_row[i] = glift::host::load_texel<glift::Format::r32f, float>(from_data, int2(address));
            }
        }
    }
}

static void read_box_0976d8f6_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_0976d8f6_direct_rows(call, rows); });
}

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

// transfer.glift:15: runs kernel read_box<Heights, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_0976d8f6_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_0976d8f6_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_data = call.memories[0];
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:16
            const uint2 to_address = to_origin + address;
            // transfer.glift:15
            const uint to_at = to_address.y * to_extent_x + to_address.x;
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:16
                const uint2 from_address = from_origin + address;
                to_data_row[i] = glift::host::load_texel<glift::Format::r32f, float>(from_data, int2(from_address));
            }
        }
    }
}

static void read_box_0976d8f6_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_0976d8f6_general_rows(call,
        rows); });
}

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

// transfer.glift:15: runs kernel read_box<Heights, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_0976d8f6_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_0976d8f6_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_data = call.memories[0];
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:16
            const uint2 from_address = from_origin + address;
            const uint2 to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address.y) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:16
            to_data[to_at] = glift::host::load_texel<glift::Format::r32f, float>(from_data, int2(from_address));
        }
    }
}

static void read_box_0976d8f6_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_0976d8f6_wide_rows(call, rows); });
}

const glift::Binding read_box_0976d8f6_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read, .sampled = true,
        .sampler = {.filter = glift::Filter::linear}},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter read_box_0976d8f6_parameters[] = {
    {"from_extent", 0, sizeof(read_box_0976d8f6_direct_parameters::from_extent)},
    {"to_extent_x", 8, sizeof(read_box_0976d8f6_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_0976d8f6_kernel;
const glift::Kernel read_box_0976d8f6_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_0976d8f6_bindings,
    .direct = {.host = &read_box_0976d8f6_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &read_box_0976d8f6_general, .parameter_bytes = 28},
    .wide = {.host = &read_box_0976d8f6_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = read_box_0976d8f6_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<2, float>, Heights>

namespace {
struct write_box_c1315537_direct_parameters {
    uint2 from_extent;
};
static_assert(offsetof(write_box_c1315537_direct_parameters, from_extent) == 0);

// transfer.glift:20: runs kernel write_box<Box<2, float>, Heights> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_c1315537_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_c1315537_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:20
            const uint from_at = address.y * from_extent.x + address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:21
                glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(address), from_data_row[i]);
            }
        }
    }
}

static void write_box_c1315537_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_c1315537_direct_rows(call,
        rows); });
}

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

// transfer.glift:20: runs kernel write_box<Box<2, float>, Heights> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_c1315537_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_c1315537_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:21
            const uint2 from_address = from_origin + address;
            // transfer.glift:20
            const uint from_at = from_address.y * from_extent_x + from_address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:21
                const uint2 to_address = to_origin + address;
                glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(to_address), from_data_row[i]);
            }
        }
    }
}

static void write_box_c1315537_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_c1315537_general_rows(call,
        rows); });
}

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

// transfer.glift:20: runs kernel write_box<Box<2, float>, Heights> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_c1315537_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_c1315537_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:21
            const uint2 from_address = from_origin + address;
            // transfer.glift:20
            const std::uint64_t from_at = std::uint64_t(from_address.y) * from_extent_x + std::uint64_t(from_address.x);
            // transfer.glift:21
            const uint2 to_address = to_origin + address;
            glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(to_address), from_data[from_at]);
        }
    }
}

static void write_box_c1315537_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_c1315537_wide_rows(call, rows); });
}

const glift::Binding write_box_c1315537_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 48,
        .element_bytes = sizeof(float)},
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter write_box_c1315537_parameters[] = {
    {"from_extent", 0, sizeof(write_box_c1315537_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_c1315537_kernel;
const glift::Kernel write_box_c1315537_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = write_box_c1315537_bindings,
    .direct = {.host = &write_box_c1315537_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &write_box_c1315537_general, .parameter_bytes = 28},
    .wide = {.host = &write_box_c1315537_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = write_box_c1315537_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Heights, float>

namespace {
struct fill_box_7c95e848_direct_parameters {
    uint2 to_extent;
    float value;
};
static_assert(offsetof(fill_box_7c95e848_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_7c95e848_direct_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<Heights, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_7c95e848_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_7c95e848_direct_parameters*>(call.parameters);
    const float value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(address), value);
        }
    }
}

static void fill_box_7c95e848_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_7c95e848_direct_rows(call, rows); });
}

struct fill_box_7c95e848_general_parameters {
    uint2 size;
    uint2 to_origin;
    float value;
};
static_assert(offsetof(fill_box_7c95e848_general_parameters, size) == 0);
static_assert(offsetof(fill_box_7c95e848_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_7c95e848_general_parameters, value) == 16);

// transfer.glift:25: runs kernel fill_box<Heights, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_7c95e848_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_7c95e848_general_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const float value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(to_address), value);
        }
    }
}

static void fill_box_7c95e848_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_7c95e848_general_rows(call,
        rows); });
}

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

// transfer.glift:25: runs kernel fill_box<Heights, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_7c95e848_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_7c95e848_wide_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const float value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            glift::host::store_texel<glift::Format::r32f, float>(to_data, int2(to_address), value);
        }
    }
}

static void fill_box_7c95e848_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_7c95e848_wide_rows(call, rows); });
}

const glift::Binding fill_box_7c95e848_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter fill_box_7c95e848_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_7c95e848_direct_parameters::to_extent)},
    {"value", 8, sizeof(fill_box_7c95e848_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_7c95e848_kernel;
const glift::Kernel fill_box_7c95e848_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = fill_box_7c95e848_bindings,
    .direct = {.host = &fill_box_7c95e848_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &fill_box_7c95e848_general, .parameter_bytes = 20},
    .wide = {.host = &fill_box_7c95e848_wide, .parameter_bytes = 32, .base_offset = 16},
    .parameters = fill_box_7c95e848_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<2, uint, none, image2d>, Box<2, uint>>

namespace {
struct read_box_92f4ce80_direct_parameters {
    uint2 from_extent;
    uint from_data_extent_x;
    uint to_extent_x;
};
static_assert(offsetof(read_box_92f4ce80_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_92f4ce80_direct_parameters, from_data_extent_x) == 8);
static_assert(offsetof(read_box_92f4ce80_direct_parameters, to_extent_x) == 12);

// transfer.glift:15: runs kernel read_box<Array<2, uint, none, image2d>, Box<2, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_92f4ce80_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_92f4ce80_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const uint from_data_extent_x = parameters.from_data_extent_x;
    const uint to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_data = call.memories[0];
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:15
            const uint to_at = address.y * to_extent_x + address.x;
            uint* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:15
                const uint from_index = address.y * from_extent.x + address.x;
                const uint2 from_at = uint2(glift::remainder(from_index, from_data_extent_x),
                    glift::divide(from_index, from_data_extent_x));
                // transfer.glift:16
                to_data_row[i] = glift::host::load_texel<glift::Format::r32ui, uint>(from_data, int2(from_at));
            }
        }
    }
}

static void read_box_92f4ce80_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_92f4ce80_direct_rows(call, rows); });
}

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

// transfer.glift:15: runs kernel read_box<Array<2, uint, none, image2d>, Box<2, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_92f4ce80_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_92f4ce80_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const uint from_data_extent_x = parameters.from_data_extent_x;
    const uint to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_data = call.memories[0];
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:16
            const uint2 to_address = to_origin + address;
            // transfer.glift:15
            const uint to_at = to_address.y * to_extent_x + to_address.x;
            uint* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:16
                const uint2 from_address = from_origin + address;
                // transfer.glift:15
                const uint from_index = from_address.y * from_extent_x + from_address.x;
                const uint2 from_at = uint2(glift::remainder(from_index, from_data_extent_x),
                    glift::divide(from_index, from_data_extent_x));
                // transfer.glift:16
                to_data_row[i] = glift::host::load_texel<glift::Format::r32ui, uint>(from_data, int2(from_at));
            }
        }
    }
}

static void read_box_92f4ce80_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_92f4ce80_general_rows(call,
        rows); });
}

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

// transfer.glift:15: runs kernel read_box<Array<2, uint, none, image2d>, Box<2, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_92f4ce80_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_92f4ce80_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const uint from_data_extent_x = parameters.from_data_extent_x;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_data = call.memories[0];
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:16
            const uint2 from_address = from_origin + address;
            // transfer.glift:15
            const uint from_index = from_address.y * from_extent_x + from_address.x;
            const uint2 from_at = uint2(glift::remainder(from_index, from_data_extent_x),
                glift::divide(from_index, from_data_extent_x));
            // transfer.glift:16
            const uint2 to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address.y) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:16
            to_data[to_at] = glift::host::load_texel<glift::Format::r32ui, uint>(from_data, int2(from_at));
        }
    }
}

static void read_box_92f4ce80_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_92f4ce80_wide_rows(call, rows); });
}

const glift::Binding read_box_92f4ce80_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read, .sampled = true},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 56,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter read_box_92f4ce80_parameters[] = {
    {"from_extent", 0, sizeof(read_box_92f4ce80_direct_parameters::from_extent)},
    {"from_data_extent_x", 8, sizeof(read_box_92f4ce80_direct_parameters::from_data_extent_x)},
    {"to_extent_x", 12, sizeof(read_box_92f4ce80_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_92f4ce80_kernel;
const glift::Kernel read_box_92f4ce80_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_92f4ce80_bindings,
    .direct = {.host = &read_box_92f4ce80_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &read_box_92f4ce80_general, .parameter_bytes = 36},
    .wide = {.host = &read_box_92f4ce80_wide, .parameter_bytes = 64, .base_offset = 24},
    .parameters = read_box_92f4ce80_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<2, uint>, Array<2, uint, none, image2d>>

namespace {
struct write_box_99148957_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
    uint to_data_extent_x;
};
static_assert(offsetof(write_box_99148957_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_99148957_direct_parameters, to_extent_x) == 8);
static_assert(offsetof(write_box_99148957_direct_parameters, to_data_extent_x) == 12);

// transfer.glift:20: runs kernel write_box<Box<2, uint>, Array<2, uint, none, image2d>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_99148957_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_99148957_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const uint to_extent_x = parameters.to_extent_x;
    const uint to_data_extent_x = parameters.to_data_extent_x;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:20
            const uint from_at = address.y * from_extent.x + address.x;
            const uint* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:20
                const uint to_index = address.y * to_extent_x + address.x;
                const uint2 to_at = uint2(glift::remainder(to_index, to_data_extent_x),
                    glift::divide(to_index, to_data_extent_x));
                // transfer.glift:21
                glift::host::store_texel<glift::Format::r32ui, uint>(to_data, int2(to_at), from_data_row[i]);
            }
        }
    }
}

static void write_box_99148957_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_99148957_direct_rows(call,
        rows); });
}

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

// transfer.glift:20: runs kernel write_box<Box<2, uint>, Array<2, uint, none, image2d>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_99148957_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_99148957_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const uint to_extent_x = parameters.to_extent_x;
    const uint to_data_extent_x = parameters.to_data_extent_x;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:21
            const uint2 from_address = from_origin + address;
            // transfer.glift:20
            const uint from_at = from_address.y * from_extent_x + from_address.x;
            const uint* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:21
                const uint2 to_address = to_origin + address;
                // transfer.glift:20
                const uint to_index = to_address.y * to_extent_x + to_address.x;
                const uint2 to_at = uint2(glift::remainder(to_index, to_data_extent_x),
                    glift::divide(to_index, to_data_extent_x));
                // transfer.glift:21
                glift::host::store_texel<glift::Format::r32ui, uint>(to_data, int2(to_at), from_data_row[i]);
            }
        }
    }
}

static void write_box_99148957_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_99148957_general_rows(call,
        rows); });
}

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

// transfer.glift:20: runs kernel write_box<Box<2, uint>, Array<2, uint, none, image2d>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_99148957_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_99148957_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const uint to_extent_x = parameters.to_extent_x;
    const uint to_data_extent_x = parameters.to_data_extent_x;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:21
            const uint2 from_address = from_origin + address;
            // transfer.glift:20
            const std::uint64_t from_at = std::uint64_t(from_address.y) * from_extent_x + std::uint64_t(from_address.x);
            // transfer.glift:21
            const uint2 to_address = to_origin + address;
            // transfer.glift:20
            const uint to_index = to_address.y * to_extent_x + to_address.x;
            const uint2 to_at = uint2(glift::remainder(to_index, to_data_extent_x),
                glift::divide(to_index, to_data_extent_x));
            // transfer.glift:21
            glift::host::store_texel<glift::Format::r32ui, uint>(to_data, int2(to_at), from_data[from_at]);
        }
    }
}

static void write_box_99148957_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_99148957_wide_rows(call, rows); });
}

const glift::Binding write_box_99148957_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(uint)},
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter write_box_99148957_parameters[] = {
    {"from_extent", 0, sizeof(write_box_99148957_direct_parameters::from_extent)},
    {"to_extent_x", 8, sizeof(write_box_99148957_direct_parameters::to_extent_x)},
    {"to_data_extent_x", 12, sizeof(write_box_99148957_direct_parameters::to_data_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_99148957_kernel;
const glift::Kernel write_box_99148957_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = write_box_99148957_bindings,
    .direct = {.host = &write_box_99148957_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &write_box_99148957_general, .parameter_bytes = 36},
    .wide = {.host = &write_box_99148957_wide, .parameter_bytes = 64, .base_offset = 24},
    .parameters = write_box_99148957_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<2, uint, none, image2d>, uint>

namespace {
struct fill_box_1b4fd378_direct_parameters {
    uint2 to_extent;
    uint to_data_extent_x;
    uint value;
};
static_assert(offsetof(fill_box_1b4fd378_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_1b4fd378_direct_parameters, to_data_extent_x) == 8);
static_assert(offsetof(fill_box_1b4fd378_direct_parameters, value) == 12);

// transfer.glift:25: runs kernel fill_box<Array<2, uint, none, image2d>, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_1b4fd378_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_1b4fd378_direct_parameters*>(call.parameters);
    const uint2 to_extent = parameters.to_extent;
    const uint to_data_extent_x = parameters.to_data_extent_x;
    const uint value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:25
            const uint to_index = address.y * to_extent.x + address.x;
            const uint2 to_at = uint2(glift::remainder(to_index, to_data_extent_x),
                glift::divide(to_index, to_data_extent_x));
            // transfer.glift:26
            glift::host::store_texel<glift::Format::r32ui, uint>(to_data, int2(to_at), value);
        }
    }
}

static void fill_box_1b4fd378_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_1b4fd378_direct_rows(call, rows); });
}

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

// transfer.glift:25: runs kernel fill_box<Array<2, uint, none, image2d>, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_1b4fd378_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_1b4fd378_general_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const uint to_extent_x = parameters.to_extent_x;
    const uint to_data_extent_x = parameters.to_data_extent_x;
    const uint value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            // transfer.glift:25
            const uint to_index = to_address.y * to_extent_x + to_address.x;
            const uint2 to_at = uint2(glift::remainder(to_index, to_data_extent_x),
                glift::divide(to_index, to_data_extent_x));
            // transfer.glift:26
            glift::host::store_texel<glift::Format::r32ui, uint>(to_data, int2(to_at), value);
        }
    }
}

static void fill_box_1b4fd378_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_1b4fd378_general_rows(call,
        rows); });
}

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

// transfer.glift:25: runs kernel fill_box<Array<2, uint, none, image2d>, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_1b4fd378_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_1b4fd378_wide_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const uint to_extent_x = parameters.to_extent_x;
    const uint to_data_extent_x = parameters.to_data_extent_x;
    const uint value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            // transfer.glift:25
            const uint to_index = to_address.y * to_extent_x + to_address.x;
            const uint2 to_at = uint2(glift::remainder(to_index, to_data_extent_x),
                glift::divide(to_index, to_data_extent_x));
            // transfer.glift:26
            glift::host::store_texel<glift::Format::r32ui, uint>(to_data, int2(to_at), value);
        }
    }
}

static void fill_box_1b4fd378_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_1b4fd378_wide_rows(call, rows); });
}

const glift::Binding fill_box_1b4fd378_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter fill_box_1b4fd378_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_1b4fd378_direct_parameters::to_extent)},
    {"to_data_extent_x", 8, sizeof(fill_box_1b4fd378_direct_parameters::to_data_extent_x)},
    {"value", 12, sizeof(fill_box_1b4fd378_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_1b4fd378_kernel;
const glift::Kernel fill_box_1b4fd378_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = fill_box_1b4fd378_bindings,
    .direct = {.host = &fill_box_1b4fd378_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &fill_box_1b4fd378_general, .parameter_bytes = 28},
    .wide = {.host = &fill_box_1b4fd378_wide, .parameter_bytes = 40, .base_offset = 16},
    .parameters = fill_box_1b4fd378_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<1, float3, none, buffer>, Box<1, float3>>

namespace {
struct read_box_f0d3f0af_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(read_box_f0d3f0af_direct_parameters, from_extent) == 0);

// transfer.glift:15: runs kernel read_box<Array<1, float3, none, buffer>, Box<1, float3>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_f0d3f0af_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const float3* from_data = glift::host::elements<const float3>(call.memories[0]);
    float3* to_data = glift::host::elements<float3>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const float3* from_data_row = glift::host::row_pointer(from_data + address);
            float3* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_f0d3f0af_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_f0d3f0af_direct_rows(call, rows); });
}

struct read_box_f0d3f0af_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_f0d3f0af_general_parameters, size) == 0);
static_assert(offsetof(read_box_f0d3f0af_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_f0d3f0af_general_parameters, to_origin) == 8);

// transfer.glift:15: runs kernel read_box<Array<1, float3, none, buffer>, Box<1, float3>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_f0d3f0af_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_f0d3f0af_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float3* from_data = glift::host::elements<const float3>(call.memories[0]);
    float3* to_data = glift::host::elements<float3>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            const float3* from_data_row = glift::host::row_pointer(from_data + from_address);
            float3* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_f0d3f0af_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_f0d3f0af_general_rows(call,
        rows); });
}

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

// transfer.glift:15: runs kernel read_box<Array<1, float3, none, buffer>, Box<1, float3>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_f0d3f0af_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_f0d3f0af_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float3* from_data = glift::host::elements<const float3>(call.memories[0]);
    float3* to_data = glift::host::elements<float3>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            // transfer.glift:15
            const std::uint64_t from_at = std::uint64_t(from_address);
            // transfer.glift:16
            const uint to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:16
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void read_box_f0d3f0af_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_f0d3f0af_wide_rows(call, rows); });
}

const glift::Binding read_box_f0d3f0af_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(float3), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(float3), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_f0d3f0af_parameters[] = {
    {"from_extent", 0, sizeof(read_box_f0d3f0af_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_f0d3f0af_kernel;
const glift::Kernel read_box_f0d3f0af_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_f0d3f0af_bindings,
    .direct = {.host = &read_box_f0d3f0af_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &read_box_f0d3f0af_general, .parameter_bytes = 12},
    .wide = {.host = &read_box_f0d3f0af_wide, .parameter_bytes = 32},
    .parameters = read_box_f0d3f0af_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, float3>, Array<1, float3, none, buffer>>

namespace {
struct write_box_59b2fb2a_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_59b2fb2a_direct_parameters, from_extent) == 0);

// transfer.glift:20: runs kernel write_box<Box<1, float3>, Array<1, float3, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_59b2fb2a_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const float3* from_data = glift::host::elements<const float3>(call.memories[0]);
    float3* to_data = glift::host::elements<float3>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const float3* from_data_row = glift::host::row_pointer(from_data + address);
            float3* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_59b2fb2a_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_59b2fb2a_direct_rows(call,
        rows); });
}

struct write_box_59b2fb2a_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_59b2fb2a_general_parameters, size) == 0);
static_assert(offsetof(write_box_59b2fb2a_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_59b2fb2a_general_parameters, to_origin) == 8);

// transfer.glift:20: runs kernel write_box<Box<1, float3>, Array<1, float3, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_59b2fb2a_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_59b2fb2a_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float3* from_data = glift::host::elements<const float3>(call.memories[0]);
    float3* to_data = glift::host::elements<float3>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:21
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            const float3* from_data_row = glift::host::row_pointer(from_data + from_address);
            float3* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_59b2fb2a_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_59b2fb2a_general_rows(call,
        rows); });
}

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

// transfer.glift:20: runs kernel write_box<Box<1, float3>, Array<1, float3, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_59b2fb2a_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_59b2fb2a_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float3* from_data = glift::host::elements<const float3>(call.memories[0]);
    float3* to_data = glift::host::elements<float3>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:21
            const uint from_address = from_origin + address;
            // transfer.glift:20
            const std::uint64_t from_at = std::uint64_t(from_address);
            // transfer.glift:21
            const uint to_address = to_origin + address;
            // transfer.glift:20
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:21
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void write_box_59b2fb2a_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_59b2fb2a_wide_rows(call, rows); });
}

const glift::Binding write_box_59b2fb2a_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(float3), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(float3), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_59b2fb2a_parameters[] = {
    {"from_extent", 0, sizeof(write_box_59b2fb2a_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_59b2fb2a_kernel;
const glift::Kernel write_box_59b2fb2a_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_59b2fb2a_bindings,
    .direct = {.host = &write_box_59b2fb2a_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &write_box_59b2fb2a_general, .parameter_bytes = 12},
    .wide = {.host = &write_box_59b2fb2a_wide, .parameter_bytes = 32},
    .parameters = write_box_59b2fb2a_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<1, float3, none, buffer>, float3>

namespace {
struct fill_box_dfa8b7d0_direct_parameters {
    uint to_extent;
    float3 value;
};
static_assert(offsetof(fill_box_dfa8b7d0_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_dfa8b7d0_direct_parameters, value) == 4);

// transfer.glift:25: runs kernel fill_box<Array<1, float3, none, buffer>, float3> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_dfa8b7d0_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_dfa8b7d0_direct_parameters*>(call.parameters);
    const float3 value = parameters.value;
    float3* to_data = glift::host::elements<float3>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            float3* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_dfa8b7d0_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_dfa8b7d0_direct_rows(call, rows); });
}

struct fill_box_dfa8b7d0_general_parameters {
    uint size;
    uint to_origin;
    float3 value;
};
static_assert(offsetof(fill_box_dfa8b7d0_general_parameters, size) == 0);
static_assert(offsetof(fill_box_dfa8b7d0_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_dfa8b7d0_general_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<Array<1, float3, none, buffer>, float3> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_dfa8b7d0_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_dfa8b7d0_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const float3 value = parameters.value;
    float3* to_data = glift::host::elements<float3>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            float3* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_dfa8b7d0_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_dfa8b7d0_general_rows(call,
        rows); });
}

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

// transfer.glift:25: runs kernel fill_box<Array<1, float3, none, buffer>, float3> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_dfa8b7d0_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_dfa8b7d0_wide_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const float3 value = parameters.value;
    float3* to_data = glift::host::elements<float3>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            // transfer.glift:25
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:26
            to_data[to_at] = value;
        }
    }
}

static void fill_box_dfa8b7d0_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_dfa8b7d0_wide_rows(call, rows); });
}

const glift::Binding fill_box_dfa8b7d0_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(float3)},
};
constexpr glift::Parameter fill_box_dfa8b7d0_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_dfa8b7d0_direct_parameters::to_extent)},
    {"value", 4, sizeof(fill_box_dfa8b7d0_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_dfa8b7d0_kernel;
const glift::Kernel fill_box_dfa8b7d0_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_dfa8b7d0_bindings,
    .direct = {.host = &fill_box_dfa8b7d0_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &fill_box_dfa8b7d0_general, .parameter_bytes = 20},
    .wide = {.host = &fill_box_dfa8b7d0_wide, .parameter_bytes = 32},
    .parameters = fill_box_dfa8b7d0_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<1, float, none, buffer>, Box<1, float>>

namespace {
struct read_box_679e2ba9_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(read_box_679e2ba9_direct_parameters, from_extent) == 0);

// transfer.glift:15: runs kernel read_box<Array<1, float, none, buffer>, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_679e2ba9_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const float* from_data_row = glift::host::row_pointer(from_data + address);
            float* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_679e2ba9_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_679e2ba9_direct_rows(call, rows); });
}

struct read_box_679e2ba9_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_679e2ba9_general_parameters, size) == 0);
static_assert(offsetof(read_box_679e2ba9_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_679e2ba9_general_parameters, to_origin) == 8);

// transfer.glift:15: runs kernel read_box<Array<1, float, none, buffer>, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_679e2ba9_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_679e2ba9_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            const float* from_data_row = glift::host::row_pointer(from_data + from_address);
            float* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_679e2ba9_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_679e2ba9_general_rows(call,
        rows); });
}

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

// transfer.glift:15: runs kernel read_box<Array<1, float, none, buffer>, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_679e2ba9_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_679e2ba9_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            // transfer.glift:15
            const std::uint64_t from_at = std::uint64_t(from_address);
            // transfer.glift:16
            const uint to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:16
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void read_box_679e2ba9_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_679e2ba9_wide_rows(call, rows); });
}

const glift::Binding read_box_679e2ba9_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_679e2ba9_parameters[] = {
    {"from_extent", 0, sizeof(read_box_679e2ba9_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_679e2ba9_kernel;
const glift::Kernel read_box_679e2ba9_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_679e2ba9_bindings,
    .direct = {.host = &read_box_679e2ba9_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &read_box_679e2ba9_general, .parameter_bytes = 12},
    .wide = {.host = &read_box_679e2ba9_wide, .parameter_bytes = 32},
    .parameters = read_box_679e2ba9_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, float>, Array<1, float, none, buffer>>

namespace {
struct write_box_7a558d52_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_7a558d52_direct_parameters, from_extent) == 0);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Array<1, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_7a558d52_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const float* from_data_row = glift::host::row_pointer(from_data + address);
            float* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_7a558d52_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_7a558d52_direct_rows(call,
        rows); });
}

struct write_box_7a558d52_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_7a558d52_general_parameters, size) == 0);
static_assert(offsetof(write_box_7a558d52_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_7a558d52_general_parameters, to_origin) == 8);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Array<1, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_7a558d52_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_7a558d52_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:21
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            const float* from_data_row = glift::host::row_pointer(from_data + from_address);
            float* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_7a558d52_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_7a558d52_general_rows(call,
        rows); });
}

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

// transfer.glift:20: runs kernel write_box<Box<1, float>, Array<1, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_7a558d52_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_7a558d52_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:21
            const uint from_address = from_origin + address;
            // transfer.glift:20
            const std::uint64_t from_at = std::uint64_t(from_address);
            // transfer.glift:21
            const uint to_address = to_origin + address;
            // transfer.glift:20
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:21
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void write_box_7a558d52_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_7a558d52_wide_rows(call, rows); });
}

const glift::Binding write_box_7a558d52_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_7a558d52_parameters[] = {
    {"from_extent", 0, sizeof(write_box_7a558d52_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_7a558d52_kernel;
const glift::Kernel write_box_7a558d52_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_7a558d52_bindings,
    .direct = {.host = &write_box_7a558d52_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &write_box_7a558d52_general, .parameter_bytes = 12},
    .wide = {.host = &write_box_7a558d52_wide, .parameter_bytes = 32},
    .parameters = write_box_7a558d52_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<1, float, none, buffer>, float>

namespace {
struct fill_box_4fb0cc86_direct_parameters {
    uint to_extent;
    float value;
};
static_assert(offsetof(fill_box_4fb0cc86_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_4fb0cc86_direct_parameters, value) == 4);

// transfer.glift:25: runs kernel fill_box<Array<1, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_4fb0cc86_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_4fb0cc86_direct_parameters*>(call.parameters);
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            float* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_4fb0cc86_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_4fb0cc86_direct_rows(call, rows); });
}

struct fill_box_4fb0cc86_general_parameters {
    uint size;
    uint to_origin;
    float value;
};
static_assert(offsetof(fill_box_4fb0cc86_general_parameters, size) == 0);
static_assert(offsetof(fill_box_4fb0cc86_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_4fb0cc86_general_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<Array<1, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_4fb0cc86_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_4fb0cc86_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            float* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_4fb0cc86_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_4fb0cc86_general_rows(call,
        rows); });
}

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

// transfer.glift:25: runs kernel fill_box<Array<1, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_4fb0cc86_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_4fb0cc86_wide_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            // transfer.glift:25
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:26
            to_data[to_at] = value;
        }
    }
}

static void fill_box_4fb0cc86_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_4fb0cc86_wide_rows(call, rows); });
}

const glift::Binding fill_box_4fb0cc86_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 16,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter fill_box_4fb0cc86_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_4fb0cc86_direct_parameters::to_extent)},
    {"value", 4, sizeof(fill_box_4fb0cc86_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_4fb0cc86_kernel;
const glift::Kernel fill_box_4fb0cc86_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_4fb0cc86_bindings,
    .direct = {.host = &fill_box_4fb0cc86_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &fill_box_4fb0cc86_general, .parameter_bytes = 12},
    .wide = {.host = &fill_box_4fb0cc86_wide, .parameter_bytes = 24},
    .parameters = fill_box_4fb0cc86_parameters,
    .items = {2, 1, 1},
};

}  // namespace std_transfer

