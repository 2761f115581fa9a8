// Made by gliftc from image_parts.glift. Changes are lost when it is made again.
#include "image_parts.glift.types.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace std_transfer {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<ImageLevel<r32f>, Box<2, float>>

namespace {
struct read_box_a6033574_direct_parameters {
    uint2 from_data_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_a6033574_direct_parameters, from_data_extent) == 0);
static_assert(offsetof(read_box_a6033574_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: runs kernel read_box<ImageLevel<r32f>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_a6033574_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_a6033574_direct_parameters*>(call.parameters);
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

static void read_box_a6033574_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_a6033574_direct_rows(call, rows); });
}

struct read_box_a6033574_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint to_extent_x;
};
static_assert(offsetof(read_box_a6033574_general_parameters, size) == 0);
static_assert(offsetof(read_box_a6033574_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_a6033574_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_a6033574_general_parameters, to_extent_x) == 24);

// transfer.glift:15: runs kernel read_box<ImageLevel<r32f>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_a6033574_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_a6033574_general_parameters*>(call.parameters);
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

static void read_box_a6033574_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_a6033574_general_rows(call,
        rows); });
}

struct read_box_a6033574_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_a6033574_wide_parameters, size) == 0);
static_assert(offsetof(read_box_a6033574_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_a6033574_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_a6033574_wide_parameters, base) == 24);
static_assert(offsetof(read_box_a6033574_wide_parameters, to_extent_x) == 40);
static_assert(offsetof(read_box_a6033574_wide_parameters, to_data_address) == 48);

// transfer.glift:15: runs kernel read_box<ImageLevel<r32f>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_a6033574_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_a6033574_wide_parameters*>(call.parameters);
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

static void read_box_a6033574_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_a6033574_wide_rows(call, rows); });
}

const glift::Binding read_box_a6033574_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read, .sampled = true,
        .sampler = {.filter = glift::Filter::linear}},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter read_box_a6033574_parameters[] = {
    {"from_data_extent", 0, sizeof(read_box_a6033574_direct_parameters::from_data_extent)},
    {"to_extent_x", 8, sizeof(read_box_a6033574_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_a6033574_kernel;
const glift::Kernel read_box_a6033574_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_a6033574_bindings,
    .direct = {.host = &read_box_a6033574_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &read_box_a6033574_general, .parameter_bytes = 28},
    .wide = {.host = &read_box_a6033574_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = read_box_a6033574_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<2, float>, ImageLevel<r32f>>

namespace {
struct write_box_7baf3dcd_direct_parameters {
    uint2 from_extent;
};
static_assert(offsetof(write_box_7baf3dcd_direct_parameters, from_extent) == 0);

// transfer.glift:20: runs kernel write_box<Box<2, float>, ImageLevel<r32f>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_7baf3dcd_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_7baf3dcd_direct_parameters*>(call.parameters);
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

static void write_box_7baf3dcd_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_7baf3dcd_direct_rows(call,
        rows); });
}

struct write_box_7baf3dcd_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
};
static_assert(offsetof(write_box_7baf3dcd_general_parameters, size) == 0);
static_assert(offsetof(write_box_7baf3dcd_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_7baf3dcd_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_7baf3dcd_general_parameters, from_extent_x) == 24);

// transfer.glift:20: runs kernel write_box<Box<2, float>, ImageLevel<r32f>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_7baf3dcd_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_7baf3dcd_general_parameters*>(call.parameters);
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

static void write_box_7baf3dcd_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_7baf3dcd_general_rows(call,
        rows); });
}

struct write_box_7baf3dcd_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, size) == 0);
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, base) == 24);
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_7baf3dcd_wide_parameters, from_data_address) == 48);

// transfer.glift:20: runs kernel write_box<Box<2, float>, ImageLevel<r32f>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_7baf3dcd_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_7baf3dcd_wide_parameters*>(call.parameters);
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

static void write_box_7baf3dcd_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_7baf3dcd_wide_rows(call, rows); });
}

const glift::Binding write_box_7baf3dcd_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 48,
        .element_bytes = sizeof(float)},
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter write_box_7baf3dcd_parameters[] = {
    {"from_extent", 0, sizeof(write_box_7baf3dcd_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_7baf3dcd_kernel;
const glift::Kernel write_box_7baf3dcd_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = write_box_7baf3dcd_bindings,
    .direct = {.host = &write_box_7baf3dcd_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &write_box_7baf3dcd_general, .parameter_bytes = 28},
    .wide = {.host = &write_box_7baf3dcd_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = write_box_7baf3dcd_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<ImageLevel<r32f>, float>

namespace {
struct fill_box_2b12c936_direct_parameters {
    uint2 to_data_extent;
    float value;
};
static_assert(offsetof(fill_box_2b12c936_direct_parameters, to_data_extent) == 0);
static_assert(offsetof(fill_box_2b12c936_direct_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<ImageLevel<r32f>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_2b12c936_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_2b12c936_direct_parameters*>(call.parameters);
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

static void fill_box_2b12c936_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_2b12c936_direct_rows(call, rows); });
}

struct fill_box_2b12c936_general_parameters {
    uint2 size;
    uint2 to_origin;
    float value;
};
static_assert(offsetof(fill_box_2b12c936_general_parameters, size) == 0);
static_assert(offsetof(fill_box_2b12c936_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_2b12c936_general_parameters, value) == 16);

// transfer.glift:25: runs kernel fill_box<ImageLevel<r32f>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_2b12c936_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_2b12c936_general_parameters*>(call.parameters);
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

static void fill_box_2b12c936_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_2b12c936_general_rows(call,
        rows); });
}

struct fill_box_2b12c936_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    float value;
};
static_assert(offsetof(fill_box_2b12c936_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_2b12c936_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_2b12c936_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_2b12c936_wide_parameters, value) == 28);

// transfer.glift:25: runs kernel fill_box<ImageLevel<r32f>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_2b12c936_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_2b12c936_wide_parameters*>(call.parameters);
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

static void fill_box_2b12c936_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_2b12c936_wide_rows(call, rows); });
}

const glift::Binding fill_box_2b12c936_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter fill_box_2b12c936_parameters[] = {
    {"to_data_extent", 0, sizeof(fill_box_2b12c936_direct_parameters::to_data_extent)},
    {"value", 8, sizeof(fill_box_2b12c936_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_2b12c936_kernel;
const glift::Kernel fill_box_2b12c936_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = fill_box_2b12c936_bindings,
    .direct = {.host = &fill_box_2b12c936_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &fill_box_2b12c936_general, .parameter_bytes = 20},
    .wide = {.host = &fill_box_2b12c936_wide, .parameter_bytes = 32, .base_offset = 16},
    .parameters = fill_box_2b12c936_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<ImageLevels<r32f>, Box<2, float>>

namespace {
struct read_box_ead0b93f_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_ead0b93f_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_ead0b93f_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: runs kernel read_box<ImageLevels<r32f>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_ead0b93f_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_ead0b93f_direct_parameters*>(call.parameters);
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

static void read_box_ead0b93f_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_ead0b93f_direct_rows(call, rows); });
}

struct read_box_ead0b93f_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint to_extent_x;
};
static_assert(offsetof(read_box_ead0b93f_general_parameters, size) == 0);
static_assert(offsetof(read_box_ead0b93f_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_ead0b93f_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_ead0b93f_general_parameters, to_extent_x) == 24);

// transfer.glift:15: runs kernel read_box<ImageLevels<r32f>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_ead0b93f_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_ead0b93f_general_parameters*>(call.parameters);
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

static void read_box_ead0b93f_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_ead0b93f_general_rows(call,
        rows); });
}

struct read_box_ead0b93f_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_ead0b93f_wide_parameters, size) == 0);
static_assert(offsetof(read_box_ead0b93f_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_ead0b93f_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_ead0b93f_wide_parameters, base) == 24);
static_assert(offsetof(read_box_ead0b93f_wide_parameters, to_extent_x) == 40);
static_assert(offsetof(read_box_ead0b93f_wide_parameters, to_data_address) == 48);

// transfer.glift:15: runs kernel read_box<ImageLevels<r32f>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_ead0b93f_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_ead0b93f_wide_parameters*>(call.parameters);
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

static void read_box_ead0b93f_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_ead0b93f_wide_rows(call, rows); });
}

const glift::Binding read_box_ead0b93f_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read, .sampled = true,
        .sampler = {.filter = glift::Filter::linear}},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter read_box_ead0b93f_parameters[] = {
    {"from_extent", 0, sizeof(read_box_ead0b93f_direct_parameters::from_extent)},
    {"to_extent_x", 8, sizeof(read_box_ead0b93f_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_ead0b93f_kernel;
const glift::Kernel read_box_ead0b93f_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_ead0b93f_bindings,
    .direct = {.host = &read_box_ead0b93f_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &read_box_ead0b93f_general, .parameter_bytes = 28},
    .wide = {.host = &read_box_ead0b93f_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = read_box_ead0b93f_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<2, float>, ImageLevels<r32f>>

namespace {
struct write_box_3c321d3e_direct_parameters {
    uint2 from_extent;
};
static_assert(offsetof(write_box_3c321d3e_direct_parameters, from_extent) == 0);

// transfer.glift:20: runs kernel write_box<Box<2, float>, ImageLevels<r32f>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_3c321d3e_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_3c321d3e_direct_parameters*>(call.parameters);
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

static void write_box_3c321d3e_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_3c321d3e_direct_rows(call,
        rows); });
}

struct write_box_3c321d3e_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
};
static_assert(offsetof(write_box_3c321d3e_general_parameters, size) == 0);
static_assert(offsetof(write_box_3c321d3e_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_3c321d3e_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_3c321d3e_general_parameters, from_extent_x) == 24);

// transfer.glift:20: runs kernel write_box<Box<2, float>, ImageLevels<r32f>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_3c321d3e_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_3c321d3e_general_parameters*>(call.parameters);
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

static void write_box_3c321d3e_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_3c321d3e_general_rows(call,
        rows); });
}

struct write_box_3c321d3e_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_3c321d3e_wide_parameters, size) == 0);
static_assert(offsetof(write_box_3c321d3e_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_3c321d3e_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_3c321d3e_wide_parameters, base) == 24);
static_assert(offsetof(write_box_3c321d3e_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_3c321d3e_wide_parameters, from_data_address) == 48);

// transfer.glift:20: runs kernel write_box<Box<2, float>, ImageLevels<r32f>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_3c321d3e_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_3c321d3e_wide_parameters*>(call.parameters);
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

static void write_box_3c321d3e_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_3c321d3e_wide_rows(call, rows); });
}

const glift::Binding write_box_3c321d3e_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 48,
        .element_bytes = sizeof(float)},
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter write_box_3c321d3e_parameters[] = {
    {"from_extent", 0, sizeof(write_box_3c321d3e_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_3c321d3e_kernel;
const glift::Kernel write_box_3c321d3e_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = write_box_3c321d3e_bindings,
    .direct = {.host = &write_box_3c321d3e_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &write_box_3c321d3e_general, .parameter_bytes = 28},
    .wide = {.host = &write_box_3c321d3e_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = write_box_3c321d3e_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<ImageLevels<r32f>, float>

namespace {
struct fill_box_8cc295b1_direct_parameters {
    uint2 to_extent;
    float value;
};
static_assert(offsetof(fill_box_8cc295b1_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_8cc295b1_direct_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<ImageLevels<r32f>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_8cc295b1_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_8cc295b1_direct_parameters*>(call.parameters);
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

static void fill_box_8cc295b1_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_8cc295b1_direct_rows(call, rows); });
}

struct fill_box_8cc295b1_general_parameters {
    uint2 size;
    uint2 to_origin;
    float value;
};
static_assert(offsetof(fill_box_8cc295b1_general_parameters, size) == 0);
static_assert(offsetof(fill_box_8cc295b1_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_8cc295b1_general_parameters, value) == 16);

// transfer.glift:25: runs kernel fill_box<ImageLevels<r32f>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_8cc295b1_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_8cc295b1_general_parameters*>(call.parameters);
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

static void fill_box_8cc295b1_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_8cc295b1_general_rows(call,
        rows); });
}

struct fill_box_8cc295b1_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    float value;
};
static_assert(offsetof(fill_box_8cc295b1_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_8cc295b1_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_8cc295b1_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_8cc295b1_wide_parameters, value) == 28);

// transfer.glift:25: runs kernel fill_box<ImageLevels<r32f>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_8cc295b1_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_8cc295b1_wide_parameters*>(call.parameters);
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

static void fill_box_8cc295b1_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_8cc295b1_wide_rows(call, rows); });
}

const glift::Binding fill_box_8cc295b1_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter fill_box_8cc295b1_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_8cc295b1_direct_parameters::to_extent)},
    {"value", 8, sizeof(fill_box_8cc295b1_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_8cc295b1_kernel;
const glift::Kernel fill_box_8cc295b1_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = fill_box_8cc295b1_bindings,
    .direct = {.host = &fill_box_8cc295b1_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &fill_box_8cc295b1_general, .parameter_bytes = 20},
    .wide = {.host = &fill_box_8cc295b1_wide, .parameter_bytes = 32, .base_offset = 16},
    .parameters = fill_box_8cc295b1_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<ImageLayers<rgba8>, Box<3, float4>>

namespace {
struct read_box_184e6050_direct_parameters {
    uint3 from_domain;
    uint3 to_extent;
    uint from_extent_y;
};
static_assert(offsetof(read_box_184e6050_direct_parameters, from_domain) == 0);
static_assert(offsetof(read_box_184e6050_direct_parameters, to_extent) == 12);
static_assert(offsetof(read_box_184e6050_direct_parameters, from_extent_y) == 24);

// transfer.glift:15: runs kernel read_box<ImageLayers<rgba8>, Box<3, float4>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_184e6050_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_184e6050_direct_parameters*>(call.parameters);
    const uint3 to_extent = parameters.to_extent;
    const glift::HostMemory& from_data = call.memories[0];
    float4* to_data = glift::host::elements<float4>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:15
            const uint to_at = (address.z * to_extent.y + address.y) * to_extent.x + address.x;
            float4* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint3 address{row.begin + static_cast<uint>(i), row.y, row.z};
                // transfer.glift:16
                to_data_row[i] = glift::host::load_texel<glift::Format::rgba8, float4>(from_data, int3(address));
            }
        }
    }
}

static void read_box_184e6050_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_184e6050_direct_rows(call, rows); });
}

struct read_box_184e6050_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 to_extent;
};
static_assert(offsetof(read_box_184e6050_general_parameters, size) == 0);
static_assert(offsetof(read_box_184e6050_general_parameters, from_origin) == 12);
static_assert(offsetof(read_box_184e6050_general_parameters, to_origin) == 24);
static_assert(offsetof(read_box_184e6050_general_parameters, to_extent) == 36);

// transfer.glift:15: runs kernel read_box<ImageLayers<rgba8>, Box<3, float4>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_184e6050_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_184e6050_general_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const uint3 to_extent = parameters.to_extent;
    const glift::HostMemory& from_data = call.memories[0];
    float4* to_data = glift::host::elements<float4>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:16
            const uint3 to_address = to_origin + address;
            // transfer.glift:15
            const uint to_at = (to_address.z * to_extent.y + to_address.y) * to_extent.x + to_address.x;
            float4* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint3 address{row.begin + static_cast<uint>(i), row.y, row.z};
                // transfer.glift:16
                const uint3 from_address = from_origin + address;
                to_data_row[i] = glift::host::load_texel<glift::Format::rgba8, float4>(from_data, int3(from_address));
            }
        }
    }
}

static void read_box_184e6050_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_184e6050_general_rows(call,
        rows); });
}

struct read_box_184e6050_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    std::uint64_t to_extent_y;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_184e6050_wide_parameters, size) == 0);
static_assert(offsetof(read_box_184e6050_wide_parameters, from_origin) == 12);
static_assert(offsetof(read_box_184e6050_wide_parameters, to_origin) == 24);
static_assert(offsetof(read_box_184e6050_wide_parameters, base) == 36);
static_assert(offsetof(read_box_184e6050_wide_parameters, to_extent_y) == 48);
static_assert(offsetof(read_box_184e6050_wide_parameters, to_extent_x) == 56);
static_assert(offsetof(read_box_184e6050_wide_parameters, to_data_address) == 64);

// transfer.glift:15: runs kernel read_box<ImageLayers<rgba8>, Box<3, float4>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_184e6050_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_184e6050_wide_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const std::uint64_t to_extent_y = parameters.to_extent_y;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_data = call.memories[0];
    float4* to_data = glift::host::elements<float4>(call.memories[1]);
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
            to_data[to_at] = glift::host::load_texel<glift::Format::rgba8, float4>(from_data, int3(from_address));
        }
    }
}

static void read_box_184e6050_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_184e6050_wide_rows(call, rows); });
}

const glift::Binding read_box_184e6050_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::image2darray, .access = glift::Access::read, .sampled = true,
        .sampler = {.filter = glift::Filter::linear}},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 64,
        .element_bytes = sizeof(float4)},
};
constexpr glift::Parameter read_box_184e6050_parameters[] = {
    {"from_domain", 0, sizeof(read_box_184e6050_direct_parameters::from_domain)},
    {"to_extent", 12, sizeof(read_box_184e6050_direct_parameters::to_extent)},
    {"from_extent_y", 24, sizeof(read_box_184e6050_direct_parameters::from_extent_y)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_184e6050_kernel;
const glift::Kernel read_box_184e6050_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = read_box_184e6050_bindings,
    .direct = {.host = &read_box_184e6050_direct, .parameter_bytes = 28, .push_constants = true},
    .general = {.host = &read_box_184e6050_general, .parameter_bytes = 48},
    .wide = {.host = &read_box_184e6050_wide, .parameter_bytes = 72, .base_offset = 36},
    .parameters = read_box_184e6050_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<3, float4>, ImageLayers<rgba8>>

namespace {
struct write_box_424b54b5_direct_parameters {
    uint3 from_extent;
};
static_assert(offsetof(write_box_424b54b5_direct_parameters, from_extent) == 0);

// transfer.glift:20: runs kernel write_box<Box<3, float4>, ImageLayers<rgba8>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_424b54b5_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_424b54b5_direct_parameters*>(call.parameters);
    const uint3 from_extent = parameters.from_extent;
    const float4* from_data = glift::host::elements<const float4>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:20
            const uint from_at = (address.z * from_extent.y + address.y) * from_extent.x + address.x;
            const float4* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint3 address{row.begin + static_cast<uint>(i), row.y, row.z};
                // transfer.glift:21
                glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int3(address), from_data_row[i]);
            }
        }
    }
}

static void write_box_424b54b5_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_424b54b5_direct_rows(call,
        rows); });
}

struct write_box_424b54b5_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 from_extent;
};
static_assert(offsetof(write_box_424b54b5_general_parameters, size) == 0);
static_assert(offsetof(write_box_424b54b5_general_parameters, from_origin) == 12);
static_assert(offsetof(write_box_424b54b5_general_parameters, to_origin) == 24);
static_assert(offsetof(write_box_424b54b5_general_parameters, from_extent) == 36);

// transfer.glift:20: runs kernel write_box<Box<3, float4>, ImageLayers<rgba8>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_424b54b5_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_424b54b5_general_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const uint3 from_extent = parameters.from_extent;
    const float4* from_data = glift::host::elements<const float4>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:21
            const uint3 from_address = from_origin + address;
            // transfer.glift:20
            const uint from_at = (from_address.z * from_extent.y + from_address.y) * from_extent.x + from_address.x;
            const float4* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint3 address{row.begin + static_cast<uint>(i), row.y, row.z};
                // transfer.glift:21
                const uint3 to_address = to_origin + address;
                glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int3(to_address), from_data_row[i]);
            }
        }
    }
}

static void write_box_424b54b5_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_424b54b5_general_rows(call,
        rows); });
}

struct write_box_424b54b5_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    std::uint64_t from_extent_y;
    std::uint64_t from_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_424b54b5_wide_parameters, size) == 0);
static_assert(offsetof(write_box_424b54b5_wide_parameters, from_origin) == 12);
static_assert(offsetof(write_box_424b54b5_wide_parameters, to_origin) == 24);
static_assert(offsetof(write_box_424b54b5_wide_parameters, base) == 36);
static_assert(offsetof(write_box_424b54b5_wide_parameters, from_extent_y) == 48);
static_assert(offsetof(write_box_424b54b5_wide_parameters, from_extent_x) == 56);
static_assert(offsetof(write_box_424b54b5_wide_parameters, from_data_address) == 64);

// transfer.glift:20: runs kernel write_box<Box<3, float4>, ImageLayers<rgba8>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_424b54b5_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_424b54b5_wide_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_y = parameters.from_extent_y;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const float4* from_data = glift::host::elements<const float4>(call.memories[0]);
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
            glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int3(to_address), from_data[from_at]);
        }
    }
}

static void write_box_424b54b5_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_424b54b5_wide_rows(call, rows); });
}

const glift::Binding write_box_424b54b5_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 64,
        .element_bytes = sizeof(float4)},
    {.name = "to.data", .kind = glift::MemoryKind::image2darray, .access = glift::Access::write},
};
constexpr glift::Parameter write_box_424b54b5_parameters[] = {
    {"from_extent", 0, sizeof(write_box_424b54b5_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_424b54b5_kernel;
const glift::Kernel write_box_424b54b5_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = write_box_424b54b5_bindings,
    .direct = {.host = &write_box_424b54b5_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &write_box_424b54b5_general, .parameter_bytes = 48},
    .wide = {.host = &write_box_424b54b5_wide, .parameter_bytes = 72, .base_offset = 36},
    .parameters = write_box_424b54b5_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<ImageLayers<rgba8>, float4>

namespace {
struct fill_box_06059ad3_direct_parameters {
    uint3 to_domain;
    float4 value;
    uint to_extent_y;
};
static_assert(offsetof(fill_box_06059ad3_direct_parameters, to_domain) == 0);
static_assert(offsetof(fill_box_06059ad3_direct_parameters, value) == 12);
static_assert(offsetof(fill_box_06059ad3_direct_parameters, to_extent_y) == 28);

// transfer.glift:25: runs kernel fill_box<ImageLayers<rgba8>, float4> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_06059ad3_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_06059ad3_direct_parameters*>(call.parameters);
    const float4 value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:26
            glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int3(address), value);
        }
    }
}

static void fill_box_06059ad3_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_06059ad3_direct_rows(call, rows); });
}

struct fill_box_06059ad3_general_parameters {
    uint3 size;
    uint3 to_origin;
    float4 value;
};
static_assert(offsetof(fill_box_06059ad3_general_parameters, size) == 0);
static_assert(offsetof(fill_box_06059ad3_general_parameters, to_origin) == 12);
static_assert(offsetof(fill_box_06059ad3_general_parameters, value) == 24);

// transfer.glift:25: runs kernel fill_box<ImageLayers<rgba8>, float4> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_06059ad3_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_06059ad3_general_parameters*>(call.parameters);
    const uint3 to_origin = parameters.to_origin;
    const float4 value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:26
            const uint3 to_address = to_origin + address;
            glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int3(to_address), value);
        }
    }
}

static void fill_box_06059ad3_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_06059ad3_general_rows(call,
        rows); });
}

struct fill_box_06059ad3_wide_parameters {
    uint3 size;
    uint3 to_origin;
    uint3 base;
    float4 value;
};
static_assert(offsetof(fill_box_06059ad3_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_06059ad3_wide_parameters, to_origin) == 12);
static_assert(offsetof(fill_box_06059ad3_wide_parameters, base) == 24);
static_assert(offsetof(fill_box_06059ad3_wide_parameters, value) == 36);

// transfer.glift:25: runs kernel fill_box<ImageLayers<rgba8>, float4> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_06059ad3_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_06059ad3_wide_parameters*>(call.parameters);
    const uint3 to_origin = parameters.to_origin;
    const float4 value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:26
            const uint3 to_address = to_origin + address;
            glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int3(to_address), value);
        }
    }
}

static void fill_box_06059ad3_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_06059ad3_wide_rows(call, rows); });
}

const glift::Binding fill_box_06059ad3_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::image2darray, .access = glift::Access::write},
};
constexpr glift::Parameter fill_box_06059ad3_parameters[] = {
    {"to_domain", 0, sizeof(fill_box_06059ad3_direct_parameters::to_domain)},
    {"value", 12, sizeof(fill_box_06059ad3_direct_parameters::value)},
    {"to_extent_y", 28, sizeof(fill_box_06059ad3_direct_parameters::to_extent_y)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_06059ad3_kernel;
const glift::Kernel fill_box_06059ad3_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = fill_box_06059ad3_bindings,
    .direct = {.host = &fill_box_06059ad3_direct, .parameter_bytes = 32, .push_constants = true},
    .general = {.host = &fill_box_06059ad3_general, .parameter_bytes = 40},
    .wide = {.host = &fill_box_06059ad3_wide, .parameter_bytes = 52, .base_offset = 24},
    .parameters = fill_box_06059ad3_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<ImageLayer<rgba8>, Box<2, float4>>

namespace {
struct read_box_9ab1f796_direct_parameters {
    uint2 from_data_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_9ab1f796_direct_parameters, from_data_extent) == 0);
static_assert(offsetof(read_box_9ab1f796_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: runs kernel read_box<ImageLayer<rgba8>, Box<2, float4>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_9ab1f796_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_9ab1f796_direct_parameters*>(call.parameters);
    const uint to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_data = call.memories[0];
    float4* to_data = glift::host::elements<float4>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:15
            const uint to_at = address.y * to_extent_x + address.x;
            float4* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:16
                to_data_row[i] = glift::host::load_texel<glift::Format::rgba8, float4>(from_data, int2(address));
            }
        }
    }
}

static void read_box_9ab1f796_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_9ab1f796_direct_rows(call, rows); });
}

struct read_box_9ab1f796_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint to_extent_x;
};
static_assert(offsetof(read_box_9ab1f796_general_parameters, size) == 0);
static_assert(offsetof(read_box_9ab1f796_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_9ab1f796_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_9ab1f796_general_parameters, to_extent_x) == 24);

// transfer.glift:15: runs kernel read_box<ImageLayer<rgba8>, Box<2, float4>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_9ab1f796_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_9ab1f796_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_data = call.memories[0];
    float4* to_data = glift::host::elements<float4>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:16
            const uint2 to_address = to_origin + address;
            // transfer.glift:15
            const uint to_at = to_address.y * to_extent_x + to_address.x;
            float4* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:16
                const uint2 from_address = from_origin + address;
                to_data_row[i] = glift::host::load_texel<glift::Format::rgba8, float4>(from_data, int2(from_address));
            }
        }
    }
}

static void read_box_9ab1f796_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_9ab1f796_general_rows(call,
        rows); });
}

struct read_box_9ab1f796_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_9ab1f796_wide_parameters, size) == 0);
static_assert(offsetof(read_box_9ab1f796_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_9ab1f796_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_9ab1f796_wide_parameters, base) == 24);
static_assert(offsetof(read_box_9ab1f796_wide_parameters, to_extent_x) == 40);
static_assert(offsetof(read_box_9ab1f796_wide_parameters, to_data_address) == 48);

// transfer.glift:15: runs kernel read_box<ImageLayer<rgba8>, Box<2, float4>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_9ab1f796_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_9ab1f796_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const glift::HostMemory& from_data = call.memories[0];
    float4* to_data = glift::host::elements<float4>(call.memories[1]);
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
            to_data[to_at] = glift::host::load_texel<glift::Format::rgba8, float4>(from_data, int2(from_address));
        }
    }
}

static void read_box_9ab1f796_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_9ab1f796_wide_rows(call, rows); });
}

const glift::Binding read_box_9ab1f796_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read, .sampled = true,
        .sampler = {.filter = glift::Filter::linear}},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(float4)},
};
constexpr glift::Parameter read_box_9ab1f796_parameters[] = {
    {"from_data_extent", 0, sizeof(read_box_9ab1f796_direct_parameters::from_data_extent)},
    {"to_extent_x", 8, sizeof(read_box_9ab1f796_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_9ab1f796_kernel;
const glift::Kernel read_box_9ab1f796_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_9ab1f796_bindings,
    .direct = {.host = &read_box_9ab1f796_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &read_box_9ab1f796_general, .parameter_bytes = 28},
    .wide = {.host = &read_box_9ab1f796_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = read_box_9ab1f796_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<2, float4>, ImageLayer<rgba8>>

namespace {
struct write_box_fc1ef9a5_direct_parameters {
    uint2 from_extent;
};
static_assert(offsetof(write_box_fc1ef9a5_direct_parameters, from_extent) == 0);

// transfer.glift:20: runs kernel write_box<Box<2, float4>, ImageLayer<rgba8>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_fc1ef9a5_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_fc1ef9a5_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const float4* from_data = glift::host::elements<const float4>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:20
            const uint from_at = address.y * from_extent.x + address.x;
            const float4* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:21
                glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int2(address), from_data_row[i]);
            }
        }
    }
}

static void write_box_fc1ef9a5_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_fc1ef9a5_direct_rows(call,
        rows); });
}

struct write_box_fc1ef9a5_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
};
static_assert(offsetof(write_box_fc1ef9a5_general_parameters, size) == 0);
static_assert(offsetof(write_box_fc1ef9a5_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_fc1ef9a5_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_fc1ef9a5_general_parameters, from_extent_x) == 24);

// transfer.glift:20: runs kernel write_box<Box<2, float4>, ImageLayer<rgba8>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_fc1ef9a5_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_fc1ef9a5_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const float4* from_data = glift::host::elements<const float4>(call.memories[0]);
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:21
            const uint2 from_address = from_origin + address;
            // transfer.glift:20
            const uint from_at = from_address.y * from_extent_x + from_address.x;
            const float4* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:21
                const uint2 to_address = to_origin + address;
                glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int2(to_address), from_data_row[i]);
            }
        }
    }
}

static void write_box_fc1ef9a5_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_fc1ef9a5_general_rows(call,
        rows); });
}

struct write_box_fc1ef9a5_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, size) == 0);
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, base) == 24);
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_fc1ef9a5_wide_parameters, from_data_address) == 48);

// transfer.glift:20: runs kernel write_box<Box<2, float4>, ImageLayer<rgba8>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_fc1ef9a5_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_fc1ef9a5_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const float4* from_data = glift::host::elements<const float4>(call.memories[0]);
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
            glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int2(to_address), from_data[from_at]);
        }
    }
}

static void write_box_fc1ef9a5_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_fc1ef9a5_wide_rows(call, rows); });
}

const glift::Binding write_box_fc1ef9a5_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 48,
        .element_bytes = sizeof(float4)},
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter write_box_fc1ef9a5_parameters[] = {
    {"from_extent", 0, sizeof(write_box_fc1ef9a5_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_fc1ef9a5_kernel;
const glift::Kernel write_box_fc1ef9a5_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = write_box_fc1ef9a5_bindings,
    .direct = {.host = &write_box_fc1ef9a5_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &write_box_fc1ef9a5_general, .parameter_bytes = 28},
    .wide = {.host = &write_box_fc1ef9a5_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = write_box_fc1ef9a5_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<ImageLayer<rgba8>, float4>

namespace {
struct fill_box_673f66ca_direct_parameters {
    uint2 to_data_extent;
    float4 value;
};
static_assert(offsetof(fill_box_673f66ca_direct_parameters, to_data_extent) == 0);
static_assert(offsetof(fill_box_673f66ca_direct_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<ImageLayer<rgba8>, float4> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_673f66ca_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_673f66ca_direct_parameters*>(call.parameters);
    const float4 value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int2(address), value);
        }
    }
}

static void fill_box_673f66ca_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_673f66ca_direct_rows(call, rows); });
}

struct fill_box_673f66ca_general_parameters {
    uint2 size;
    uint2 to_origin;
    float4 value;
};
static_assert(offsetof(fill_box_673f66ca_general_parameters, size) == 0);
static_assert(offsetof(fill_box_673f66ca_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_673f66ca_general_parameters, value) == 16);

// transfer.glift:25: runs kernel fill_box<ImageLayer<rgba8>, float4> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_673f66ca_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_673f66ca_general_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const float4 value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int2(to_address), value);
        }
    }
}

static void fill_box_673f66ca_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_673f66ca_general_rows(call,
        rows); });
}

struct fill_box_673f66ca_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    float4 value;
};
static_assert(offsetof(fill_box_673f66ca_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_673f66ca_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_673f66ca_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_673f66ca_wide_parameters, value) == 28);

// transfer.glift:25: runs kernel fill_box<ImageLayer<rgba8>, float4> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_673f66ca_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_673f66ca_wide_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const float4 value = parameters.value;
    const glift::HostMemory& to_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            glift::host::store_texel<glift::Format::rgba8, float4>(to_data, int2(to_address), value);
        }
    }
}

static void fill_box_673f66ca_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_673f66ca_wide_rows(call, rows); });
}

const glift::Binding fill_box_673f66ca_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter fill_box_673f66ca_parameters[] = {
    {"to_data_extent", 0, sizeof(fill_box_673f66ca_direct_parameters::to_data_extent)},
    {"value", 8, sizeof(fill_box_673f66ca_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_673f66ca_kernel;
const glift::Kernel fill_box_673f66ca_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = fill_box_673f66ca_bindings,
    .direct = {.host = &fill_box_673f66ca_direct, .parameter_bytes = 24, .push_constants = true},
    .general = {.host = &fill_box_673f66ca_general, .parameter_bytes = 32},
    .wide = {.host = &fill_box_673f66ca_wide, .parameter_bytes = 44, .base_offset = 16},
    .parameters = fill_box_673f66ca_parameters,
    .items = {1, 2, 1},
};

}  // namespace std_transfer

