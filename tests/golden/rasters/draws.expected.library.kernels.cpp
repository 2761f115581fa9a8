// Made by gliftc from draws.glift. Changes are lost when it is made again.
#include "draws.glift.types.hpp"

#include <glift/drawing.h>
#include <glift/host/fragments.h>
#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace std_image {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// image.glift:109: draw_depth<Image<d32>>

namespace {
struct draw_depth_19ff2775_direct_parameters {
    float depth;
};
static_assert(offsetof(draw_depth_19ff2775_direct_parameters, depth) == 0);

// image.glift:109: runs draw_depth<Image<d32>> for the given corners.
GLIFT_HOST_KERNEL
static void draw_depth_19ff2775_direct_vertex(const void* pointer, std::uint64_t first, std::uint32_t count,
    [[maybe_unused]] std::uint32_t instance, float* corners) {
    [[maybe_unused]] const auto& call = *static_cast<const glift::HostCall*>(pointer);
    const auto& parameters = *static_cast<const draw_depth_19ff2775_direct_parameters*>(call.parameters);
    const float depth = parameters.depth;
    for (std::uint32_t i = 0; i < count; ++i) {
        [[maybe_unused]] const uint corner = static_cast<uint>(first) + i;
        float4 place{};
        const uint2 address_2 = uint2(corner, instance);
        // image.glift:111
        place = float4(address_2.x == 1u ? 3.0f : -1.0f, address_2.x == 2u ? 3.0f : -1.0f, depth, 1.0f);
        corners = glift::host::put(corners, place);
    }
}

static void draw_depth_19ff2775_direct(const glift::HostCall& call) {
    const glift::HostTargets& targets = *call.targets;
    glift::host::Draw draw;
    draw.body = &call;
    draw.vertex = draw_depth_19ff2775_direct_vertex;
    draw.corners = call.size[0];
    draw.instances = call.size[1];
    draw.viewport = targets.extent;
    draw.framebuffer = targets.origin;
    draw.depth = {reinterpret_cast<float*>(targets.depth.first), targets.depth.row / sizeof(float),
        glift::DepthTest::always, true, true};
    glift::host::draw(draw);
}

struct draw_depth_19ff2775_general_parameters {
    uint2 size;
    uint corner_origin;
    float depth;
};
static_assert(offsetof(draw_depth_19ff2775_general_parameters, size) == 0);
static_assert(offsetof(draw_depth_19ff2775_general_parameters, corner_origin) == 8);
static_assert(offsetof(draw_depth_19ff2775_general_parameters, depth) == 12);

// image.glift:109: runs draw_depth<Image<d32>> for the given corners.
GLIFT_HOST_KERNEL
static void draw_depth_19ff2775_general_vertex(const void* pointer, std::uint64_t first, std::uint32_t count,
    [[maybe_unused]] std::uint32_t instance, float* corners) {
    [[maybe_unused]] const auto& call = *static_cast<const glift::HostCall*>(pointer);
    const auto& parameters = *static_cast<const draw_depth_19ff2775_general_parameters*>(call.parameters);
    const uint corner_origin = parameters.corner_origin;
    const float depth = parameters.depth;
    for (std::uint32_t i = 0; i < count; ++i) {
        [[maybe_unused]] const uint corner = static_cast<uint>(first) + i;
        float4 place{};
        const uint2 address_2 = uint2(corner, instance);
        // image.glift:111
        const uint corner_address = corner_origin + address_2.x;
        place = float4(corner_address == 1u ? 3.0f : -1.0f, corner_address == 2u ? 3.0f : -1.0f, depth, 1.0f);
        corners = glift::host::put(corners, place);
    }
}

static void draw_depth_19ff2775_general(const glift::HostCall& call) {
    const glift::HostTargets& targets = *call.targets;
    glift::host::Draw draw;
    draw.body = &call;
    draw.vertex = draw_depth_19ff2775_general_vertex;
    draw.corners = call.size[0];
    draw.instances = call.size[1];
    draw.viewport = targets.extent;
    draw.framebuffer = targets.origin;
    draw.depth = {reinterpret_cast<float*>(targets.depth.first), targets.depth.row / sizeof(float),
        glift::DepthTest::always, true, true};
    glift::host::draw(draw);
}

constexpr glift::Parameter draw_depth_19ff2775_parameters[] = {
    {"depth", 0, sizeof(draw_depth_19ff2775_direct_parameters::depth)},
};
const glift::Drawing draw_depth_19ff2775_drawing = {.topology = glift::Topology::triangles, .cull = glift::Cull::none,
    .depth = "z", .depth_test = glift::DepthTest::always};
}  // namespace

extern GLIFT_SHARED const glift::Kernel draw_depth_19ff2775_kernel;
const glift::Kernel draw_depth_19ff2775_kernel = {
    .name = "draw_depth",
    .file = "image.glift",
    .line = 109,
    .rank = 2,
    .group = {1, 1, 1},
    .loop_rounds = 0,
    .bindings = {},
    .direct = {.host = &draw_depth_19ff2775_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &draw_depth_19ff2775_general, .parameter_bytes = 16, .uniform_buffer = true},
    .wide = {},
    .parameters = draw_depth_19ff2775_parameters,
    .drawing = &draw_depth_19ff2775_drawing,
};

}  // namespace std_image

namespace std_transfer {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Image<d32>, Box<2, float>>

namespace {
struct read_box_9d8f71b4_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_9d8f71b4_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_9d8f71b4_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: runs kernel read_box<Image<d32>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_9d8f71b4_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_9d8f71b4_direct_parameters*>(call.parameters);
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
                to_data_row[i] = glift::host::load_texel<glift::Format::d32, float>(from_data, int2(address));
            }
        }
    }
}

static void read_box_9d8f71b4_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_9d8f71b4_direct_rows(call, rows); });
}

struct read_box_9d8f71b4_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint to_extent_x;
};
static_assert(offsetof(read_box_9d8f71b4_general_parameters, size) == 0);
static_assert(offsetof(read_box_9d8f71b4_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_9d8f71b4_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_9d8f71b4_general_parameters, to_extent_x) == 24);

// transfer.glift:15: runs kernel read_box<Image<d32>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_9d8f71b4_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_9d8f71b4_general_parameters*>(call.parameters);
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
                to_data_row[i] = glift::host::load_texel<glift::Format::d32, float>(from_data, int2(from_address));
            }
        }
    }
}

static void read_box_9d8f71b4_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_9d8f71b4_general_rows(call,
        rows); });
}

struct read_box_9d8f71b4_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, size) == 0);
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, base) == 24);
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, to_extent_x) == 40);
static_assert(offsetof(read_box_9d8f71b4_wide_parameters, to_data_address) == 48);

// transfer.glift:15: runs kernel read_box<Image<d32>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_9d8f71b4_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_9d8f71b4_wide_parameters*>(call.parameters);
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
            to_data[to_at] = glift::host::load_texel<glift::Format::d32, float>(from_data, int2(from_address));
        }
    }
}

static void read_box_9d8f71b4_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_9d8f71b4_wide_rows(call, rows); });
}

const glift::Binding read_box_9d8f71b4_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read, .sampled = true},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter read_box_9d8f71b4_parameters[] = {
    {"from_extent", 0, sizeof(read_box_9d8f71b4_direct_parameters::from_extent)},
    {"to_extent_x", 8, sizeof(read_box_9d8f71b4_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_9d8f71b4_kernel;
const glift::Kernel read_box_9d8f71b4_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_9d8f71b4_bindings,
    .direct = {.host = &read_box_9d8f71b4_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &read_box_9d8f71b4_general, .parameter_bytes = 28},
    .wide = {.host = &read_box_9d8f71b4_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = read_box_9d8f71b4_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<1, uint, none, buffer>, Box<1, uint>>

namespace {
struct read_box_698f90a1_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(read_box_698f90a1_direct_parameters, from_extent) == 0);

// transfer.glift:15: runs kernel read_box<Array<1, uint, none, buffer>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_698f90a1_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const uint* from_data_row = glift::host::row_pointer(from_data + address);
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_698f90a1_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_698f90a1_direct_rows(call, rows); });
}

struct read_box_698f90a1_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_698f90a1_general_parameters, size) == 0);
static_assert(offsetof(read_box_698f90a1_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_698f90a1_general_parameters, to_origin) == 8);

// transfer.glift:15: runs kernel read_box<Array<1, uint, none, buffer>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_698f90a1_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_698f90a1_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            const uint* from_data_row = glift::host::row_pointer(from_data + from_address);
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_698f90a1_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_698f90a1_general_rows(call,
        rows); });
}

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

// transfer.glift:15: runs kernel read_box<Array<1, uint, none, buffer>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_698f90a1_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_698f90a1_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
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

static void read_box_698f90a1_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_698f90a1_wide_rows(call, rows); });
}

const glift::Binding read_box_698f90a1_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_698f90a1_parameters[] = {
    {"from_extent", 0, sizeof(read_box_698f90a1_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_698f90a1_kernel;
const glift::Kernel read_box_698f90a1_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_698f90a1_bindings,
    .direct = {.host = &read_box_698f90a1_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &read_box_698f90a1_general, .parameter_bytes = 12},
    .wide = {.host = &read_box_698f90a1_wide, .parameter_bytes = 32},
    .parameters = read_box_698f90a1_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, uint>, Array<1, uint, none, buffer>>

namespace {
struct write_box_920b34ba_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_920b34ba_direct_parameters, from_extent) == 0);

// transfer.glift:20: runs kernel write_box<Box<1, uint>, Array<1, uint, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_920b34ba_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const uint* from_data_row = glift::host::row_pointer(from_data + address);
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_920b34ba_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_920b34ba_direct_rows(call,
        rows); });
}

struct write_box_920b34ba_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_920b34ba_general_parameters, size) == 0);
static_assert(offsetof(write_box_920b34ba_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_920b34ba_general_parameters, to_origin) == 8);

// transfer.glift:20: runs kernel write_box<Box<1, uint>, Array<1, uint, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_920b34ba_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_920b34ba_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:21
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            const uint* from_data_row = glift::host::row_pointer(from_data + from_address);
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_920b34ba_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_920b34ba_general_rows(call,
        rows); });
}

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

// transfer.glift:20: runs kernel write_box<Box<1, uint>, Array<1, uint, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_920b34ba_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_920b34ba_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
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

static void write_box_920b34ba_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_920b34ba_wide_rows(call, rows); });
}

const glift::Binding write_box_920b34ba_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_920b34ba_parameters[] = {
    {"from_extent", 0, sizeof(write_box_920b34ba_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_920b34ba_kernel;
const glift::Kernel write_box_920b34ba_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_920b34ba_bindings,
    .direct = {.host = &write_box_920b34ba_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &write_box_920b34ba_general, .parameter_bytes = 12},
    .wide = {.host = &write_box_920b34ba_wide, .parameter_bytes = 32},
    .parameters = write_box_920b34ba_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<1, uint, none, buffer>, uint>

namespace {
struct fill_box_fbf6ae12_direct_parameters {
    uint to_extent;
    uint value;
};
static_assert(offsetof(fill_box_fbf6ae12_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_fbf6ae12_direct_parameters, value) == 4);

// transfer.glift:25: runs kernel fill_box<Array<1, uint, none, buffer>, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_fbf6ae12_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_fbf6ae12_direct_parameters*>(call.parameters);
    const uint value = parameters.value;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_fbf6ae12_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_fbf6ae12_direct_rows(call, rows); });
}

struct fill_box_fbf6ae12_general_parameters {
    uint size;
    uint to_origin;
    uint value;
};
static_assert(offsetof(fill_box_fbf6ae12_general_parameters, size) == 0);
static_assert(offsetof(fill_box_fbf6ae12_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_fbf6ae12_general_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<Array<1, uint, none, buffer>, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_fbf6ae12_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_fbf6ae12_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint value = parameters.value;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_fbf6ae12_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_fbf6ae12_general_rows(call,
        rows); });
}

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

// transfer.glift:25: runs kernel fill_box<Array<1, uint, none, buffer>, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_fbf6ae12_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_fbf6ae12_wide_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint value = parameters.value;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
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

static void fill_box_fbf6ae12_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_fbf6ae12_wide_rows(call, rows); });
}

const glift::Binding fill_box_fbf6ae12_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 16,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter fill_box_fbf6ae12_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_fbf6ae12_direct_parameters::to_extent)},
    {"value", 4, sizeof(fill_box_fbf6ae12_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_fbf6ae12_kernel;
const glift::Kernel fill_box_fbf6ae12_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_fbf6ae12_bindings,
    .direct = {.host = &fill_box_fbf6ae12_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &fill_box_fbf6ae12_general, .parameter_bytes = 12},
    .wide = {.host = &fill_box_fbf6ae12_wide, .parameter_bytes = 24},
    .parameters = fill_box_fbf6ae12_parameters,
    .items = {2, 1, 1},
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
// transfer.glift:15: read_box<Image<rgba8>, Box<2, float4>>

namespace {
struct read_box_d09c6321_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_d09c6321_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_d09c6321_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: runs kernel read_box<Image<rgba8>, Box<2, float4>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_d09c6321_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_d09c6321_direct_parameters*>(call.parameters);
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

static void read_box_d09c6321_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_d09c6321_direct_rows(call, rows); });
}

struct read_box_d09c6321_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint to_extent_x;
};
static_assert(offsetof(read_box_d09c6321_general_parameters, size) == 0);
static_assert(offsetof(read_box_d09c6321_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_d09c6321_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_d09c6321_general_parameters, to_extent_x) == 24);

// transfer.glift:15: runs kernel read_box<Image<rgba8>, Box<2, float4>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_d09c6321_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_d09c6321_general_parameters*>(call.parameters);
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

static void read_box_d09c6321_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_d09c6321_general_rows(call,
        rows); });
}

struct read_box_d09c6321_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_d09c6321_wide_parameters, size) == 0);
static_assert(offsetof(read_box_d09c6321_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_d09c6321_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_d09c6321_wide_parameters, base) == 24);
static_assert(offsetof(read_box_d09c6321_wide_parameters, to_extent_x) == 40);
static_assert(offsetof(read_box_d09c6321_wide_parameters, to_data_address) == 48);

// transfer.glift:15: runs kernel read_box<Image<rgba8>, Box<2, float4>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_d09c6321_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_d09c6321_wide_parameters*>(call.parameters);
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

static void read_box_d09c6321_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_d09c6321_wide_rows(call, rows); });
}

const glift::Binding read_box_d09c6321_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read, .sampled = true,
        .sampler = {.filter = glift::Filter::linear}},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(float4)},
};
constexpr glift::Parameter read_box_d09c6321_parameters[] = {
    {"from_extent", 0, sizeof(read_box_d09c6321_direct_parameters::from_extent)},
    {"to_extent_x", 8, sizeof(read_box_d09c6321_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_d09c6321_kernel;
const glift::Kernel read_box_d09c6321_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_d09c6321_bindings,
    .direct = {.host = &read_box_d09c6321_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &read_box_d09c6321_general, .parameter_bytes = 28},
    .wide = {.host = &read_box_d09c6321_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = read_box_d09c6321_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<2, float4>, Image<rgba8>>

namespace {
struct write_box_c92d8b24_direct_parameters {
    uint2 from_extent;
};
static_assert(offsetof(write_box_c92d8b24_direct_parameters, from_extent) == 0);

// transfer.glift:20: runs kernel write_box<Box<2, float4>, Image<rgba8>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_c92d8b24_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_c92d8b24_direct_parameters*>(call.parameters);
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

static void write_box_c92d8b24_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_c92d8b24_direct_rows(call,
        rows); });
}

struct write_box_c92d8b24_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
};
static_assert(offsetof(write_box_c92d8b24_general_parameters, size) == 0);
static_assert(offsetof(write_box_c92d8b24_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_c92d8b24_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_c92d8b24_general_parameters, from_extent_x) == 24);

// transfer.glift:20: runs kernel write_box<Box<2, float4>, Image<rgba8>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_c92d8b24_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_c92d8b24_general_parameters*>(call.parameters);
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

static void write_box_c92d8b24_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_c92d8b24_general_rows(call,
        rows); });
}

struct write_box_c92d8b24_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t from_data_address;
};
static_assert(offsetof(write_box_c92d8b24_wide_parameters, size) == 0);
static_assert(offsetof(write_box_c92d8b24_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_c92d8b24_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_c92d8b24_wide_parameters, base) == 24);
static_assert(offsetof(write_box_c92d8b24_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_c92d8b24_wide_parameters, from_data_address) == 48);

// transfer.glift:20: runs kernel write_box<Box<2, float4>, Image<rgba8>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_c92d8b24_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_c92d8b24_wide_parameters*>(call.parameters);
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

static void write_box_c92d8b24_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_c92d8b24_wide_rows(call, rows); });
}

const glift::Binding write_box_c92d8b24_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 48,
        .element_bytes = sizeof(float4)},
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter write_box_c92d8b24_parameters[] = {
    {"from_extent", 0, sizeof(write_box_c92d8b24_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_c92d8b24_kernel;
const glift::Kernel write_box_c92d8b24_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = write_box_c92d8b24_bindings,
    .direct = {.host = &write_box_c92d8b24_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &write_box_c92d8b24_general, .parameter_bytes = 28},
    .wide = {.host = &write_box_c92d8b24_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = write_box_c92d8b24_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Image<rgba8>, float4>

namespace {
struct fill_box_9f341825_direct_parameters {
    uint2 to_extent;
    float4 value;
};
static_assert(offsetof(fill_box_9f341825_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_9f341825_direct_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<Image<rgba8>, float4> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_9f341825_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_9f341825_direct_parameters*>(call.parameters);
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

static void fill_box_9f341825_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_9f341825_direct_rows(call, rows); });
}

struct fill_box_9f341825_general_parameters {
    uint2 size;
    uint2 to_origin;
    float4 value;
};
static_assert(offsetof(fill_box_9f341825_general_parameters, size) == 0);
static_assert(offsetof(fill_box_9f341825_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_9f341825_general_parameters, value) == 16);

// transfer.glift:25: runs kernel fill_box<Image<rgba8>, float4> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_9f341825_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_9f341825_general_parameters*>(call.parameters);
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

static void fill_box_9f341825_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_9f341825_general_rows(call,
        rows); });
}

struct fill_box_9f341825_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    float4 value;
};
static_assert(offsetof(fill_box_9f341825_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_9f341825_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_9f341825_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_9f341825_wide_parameters, value) == 28);

// transfer.glift:25: runs kernel fill_box<Image<rgba8>, float4> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_9f341825_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_9f341825_wide_parameters*>(call.parameters);
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

static void fill_box_9f341825_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_9f341825_wide_rows(call, rows); });
}

const glift::Binding fill_box_9f341825_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write},
};
constexpr glift::Parameter fill_box_9f341825_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_9f341825_direct_parameters::to_extent)},
    {"value", 8, sizeof(fill_box_9f341825_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_9f341825_kernel;
const glift::Kernel fill_box_9f341825_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = fill_box_9f341825_bindings,
    .direct = {.host = &fill_box_9f341825_direct, .parameter_bytes = 24, .push_constants = true},
    .general = {.host = &fill_box_9f341825_general, .parameter_bytes = 32},
    .wide = {.host = &fill_box_9f341825_wide, .parameter_bytes = 44, .base_offset = 16},
    .parameters = fill_box_9f341825_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<2, uint, none, buffer>, Box<2, uint>>

namespace {
struct read_box_61c1abfb_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_61c1abfb_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_61c1abfb_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: runs kernel read_box<Array<2, uint, none, buffer>, Box<2, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_61c1abfb_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_61c1abfb_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const uint to_extent_x = parameters.to_extent_x;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:15
            const uint from_at = address.y * from_extent.x + address.x;
            const uint to_at = address.y * to_extent_x + address.x;
            const uint* from_data_row = glift::host::row_pointer(from_data + from_at);
            uint* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_61c1abfb_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_61c1abfb_direct_rows(call, rows); });
}

struct read_box_61c1abfb_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
    uint to_extent_x;
};
static_assert(offsetof(read_box_61c1abfb_general_parameters, size) == 0);
static_assert(offsetof(read_box_61c1abfb_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_61c1abfb_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_61c1abfb_general_parameters, from_extent_x) == 24);
static_assert(offsetof(read_box_61c1abfb_general_parameters, to_extent_x) == 28);

// transfer.glift:15: runs kernel read_box<Array<2, uint, none, buffer>, Box<2, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_61c1abfb_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_61c1abfb_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const uint to_extent_x = parameters.to_extent_x;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:16
            const uint2 from_address = from_origin + address;
            // transfer.glift:15
            const uint from_at = from_address.y * from_extent_x + from_address.x;
            // transfer.glift:16
            const uint2 to_address = to_origin + address;
            // transfer.glift:15
            const uint to_at = to_address.y * to_extent_x + to_address.x;
            const uint* from_data_row = glift::host::row_pointer(from_data + from_at);
            uint* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_61c1abfb_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_61c1abfb_general_rows(call,
        rows); });
}

struct read_box_61c1abfb_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t to_extent_x;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_61c1abfb_wide_parameters, size) == 0);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, base) == 24);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, to_extent_x) == 48);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, from_data_address) == 56);
static_assert(offsetof(read_box_61c1abfb_wide_parameters, to_data_address) == 64);

// transfer.glift:15: runs kernel read_box<Array<2, uint, none, buffer>, Box<2, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_61c1abfb_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_61c1abfb_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:16
            const uint2 from_address = from_origin + address;
            // transfer.glift:15
            const std::uint64_t from_at = std::uint64_t(from_address.y) * from_extent_x + std::uint64_t(from_address.x);
            // transfer.glift:16
            const uint2 to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address.y) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:16
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void read_box_61c1abfb_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_61c1abfb_wide_rows(call, rows); });
}

const glift::Binding read_box_61c1abfb_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 64,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_61c1abfb_parameters[] = {
    {"from_extent", 0, sizeof(read_box_61c1abfb_direct_parameters::from_extent)},
    {"to_extent_x", 8, sizeof(read_box_61c1abfb_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_61c1abfb_kernel;
const glift::Kernel read_box_61c1abfb_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_61c1abfb_bindings,
    .direct = {.host = &read_box_61c1abfb_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &read_box_61c1abfb_general, .parameter_bytes = 32},
    .wide = {.host = &read_box_61c1abfb_wide, .parameter_bytes = 72, .base_offset = 24},
    .parameters = read_box_61c1abfb_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<2, uint>, Array<2, uint, none, buffer>>

namespace {
struct write_box_522c64c2_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(write_box_522c64c2_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_522c64c2_direct_parameters, to_extent_x) == 8);

// transfer.glift:20: runs kernel write_box<Box<2, uint>, Array<2, uint, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_522c64c2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_522c64c2_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const uint to_extent_x = parameters.to_extent_x;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:20
            const uint from_at = address.y * from_extent.x + address.x;
            const uint to_at = address.y * to_extent_x + address.x;
            const uint* from_data_row = glift::host::row_pointer(from_data + from_at);
            uint* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_522c64c2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_522c64c2_direct_rows(call,
        rows); });
}

struct write_box_522c64c2_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
    uint to_extent_x;
};
static_assert(offsetof(write_box_522c64c2_general_parameters, size) == 0);
static_assert(offsetof(write_box_522c64c2_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_522c64c2_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_522c64c2_general_parameters, from_extent_x) == 24);
static_assert(offsetof(write_box_522c64c2_general_parameters, to_extent_x) == 28);

// transfer.glift:20: runs kernel write_box<Box<2, uint>, Array<2, uint, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_522c64c2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_522c64c2_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const uint to_extent_x = parameters.to_extent_x;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:21
            const uint2 from_address = from_origin + address;
            // transfer.glift:20
            const uint from_at = from_address.y * from_extent_x + from_address.x;
            // transfer.glift:21
            const uint2 to_address = to_origin + address;
            // transfer.glift:20
            const uint to_at = to_address.y * to_extent_x + to_address.x;
            const uint* from_data_row = glift::host::row_pointer(from_data + from_at);
            uint* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_522c64c2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_522c64c2_general_rows(call,
        rows); });
}

struct write_box_522c64c2_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t to_extent_x;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_522c64c2_wide_parameters, size) == 0);
static_assert(offsetof(write_box_522c64c2_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_522c64c2_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_522c64c2_wide_parameters, base) == 24);
static_assert(offsetof(write_box_522c64c2_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_522c64c2_wide_parameters, to_extent_x) == 48);
static_assert(offsetof(write_box_522c64c2_wide_parameters, from_data_address) == 56);
static_assert(offsetof(write_box_522c64c2_wide_parameters, to_data_address) == 64);

// transfer.glift:20: runs kernel write_box<Box<2, uint>, Array<2, uint, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_522c64c2_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_522c64c2_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
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
            const std::uint64_t to_at = std::uint64_t(to_address.y) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:21
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void write_box_522c64c2_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_522c64c2_wide_rows(call, rows); });
}

const glift::Binding write_box_522c64c2_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 64,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_522c64c2_parameters[] = {
    {"from_extent", 0, sizeof(write_box_522c64c2_direct_parameters::from_extent)},
    {"to_extent_x", 8, sizeof(write_box_522c64c2_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_522c64c2_kernel;
const glift::Kernel write_box_522c64c2_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = write_box_522c64c2_bindings,
    .direct = {.host = &write_box_522c64c2_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &write_box_522c64c2_general, .parameter_bytes = 32},
    .wide = {.host = &write_box_522c64c2_wide, .parameter_bytes = 72, .base_offset = 24},
    .parameters = write_box_522c64c2_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<2, uint, none, buffer>, uint>

namespace {
struct fill_box_fa7e631f_direct_parameters {
    uint2 to_extent;
    uint value;
};
static_assert(offsetof(fill_box_fa7e631f_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_fa7e631f_direct_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<Array<2, uint, none, buffer>, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_fa7e631f_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_fa7e631f_direct_parameters*>(call.parameters);
    const uint2 to_extent = parameters.to_extent;
    const uint value = parameters.value;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:25
            const uint to_at = address.y * to_extent.x + address.x;
            uint* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_fa7e631f_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_fa7e631f_direct_rows(call, rows); });
}

struct fill_box_fa7e631f_general_parameters {
    uint2 size;
    uint2 to_origin;
    uint to_extent_x;
    uint value;
};
static_assert(offsetof(fill_box_fa7e631f_general_parameters, size) == 0);
static_assert(offsetof(fill_box_fa7e631f_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_fa7e631f_general_parameters, to_extent_x) == 16);
static_assert(offsetof(fill_box_fa7e631f_general_parameters, value) == 20);

// transfer.glift:25: runs kernel fill_box<Array<2, uint, none, buffer>, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_fa7e631f_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_fa7e631f_general_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const uint to_extent_x = parameters.to_extent_x;
    const uint value = parameters.value;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            // transfer.glift:25
            const uint to_at = to_address.y * to_extent_x + to_address.x;
            uint* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_fa7e631f_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_fa7e631f_general_rows(call,
        rows); });
}

struct fill_box_fa7e631f_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_x;
    uint value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, to_extent_x) == 32);
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, value) == 40);
static_assert(offsetof(fill_box_fa7e631f_wide_parameters, to_data_address) == 48);

// transfer.glift:25: runs kernel fill_box<Array<2, uint, none, buffer>, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_fa7e631f_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_fa7e631f_wide_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const uint value = parameters.value;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            // transfer.glift:25
            const std::uint64_t to_at = std::uint64_t(to_address.y) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:26
            to_data[to_at] = value;
        }
    }
}

static void fill_box_fa7e631f_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_fa7e631f_wide_rows(call, rows); });
}

const glift::Binding fill_box_fa7e631f_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter fill_box_fa7e631f_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_fa7e631f_direct_parameters::to_extent)},
    {"value", 8, sizeof(fill_box_fa7e631f_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_fa7e631f_kernel;
const glift::Kernel fill_box_fa7e631f_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = fill_box_fa7e631f_bindings,
    .direct = {.host = &fill_box_fa7e631f_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &fill_box_fa7e631f_general, .parameter_bytes = 24},
    .wide = {.host = &fill_box_fa7e631f_wide, .parameter_bytes = 56, .base_offset = 16},
    .parameters = fill_box_fa7e631f_parameters,
    .items = {1, 2, 1},
};

}  // namespace std_transfer

