// Made by gliftc from shared.glift. Changes are lost when it is made again.
#include "shared.glift.types.hpp"

#include <glift/host/atomics.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace std_transfer {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Paged, Box<1, float>>

namespace {
struct read_box_b7c9e6e7_direct_parameters {
    uint from_extent;
    uint from_table_extent;
    uint2 from_frames_extent;
};
static_assert(offsetof(read_box_b7c9e6e7_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_b7c9e6e7_direct_parameters, from_table_extent) == 4);
static_assert(offsetof(read_box_b7c9e6e7_direct_parameters, from_frames_extent) == 8);

// transfer.glift:15: runs kernel read_box<Paged, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_b7c9e6e7_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_b7c9e6e7_direct_parameters*>(call.parameters);
    const uint from_extent = parameters.from_extent;
    const uint from_table_extent = parameters.from_table_extent;
    const uint2 from_frames_extent = parameters.from_frames_extent;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            float* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // transfer.glift:15
                bool from_either = address >= from_extent;
                if (!from_either) {
                    const uint from_table_address = address / 16u;
                    const bool from_table_value_inside = from_table_address < from_table_extent;
                    const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                    from_either = (from_table_value_inside ? from_table_value : 0u) == 0u;
                }
                uint2 from_result{};
                bool from_found{};
                if (from_either) {
                    from_result = uint2(0u);
                    from_found = false;
                } else {
                    const uint from_table_address = address / 16u;
                    const bool from_table_value_inside = from_table_address < from_table_extent;
                    const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                    from_result = uint2(address % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                    from_found = true;
                }
                const uint2 from_place = from_result;
                const uint from_at = from_place.y * from_frames_extent.x + from_place.x;
                const bool from_found_2 = from_found && from_place.y < from_frames_extent.y;
                // transfer.glift:16
                const float from_value = from_frames_data[from_found_2 ? from_at : 0u];
                to_data_row[i] = from_found_2 ? from_value : -1.0f;
            }
        }
    }
}

static void read_box_b7c9e6e7_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_b7c9e6e7_direct_rows(call, rows); });
}

struct read_box_b7c9e6e7_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint from_extent;
    uint from_table_extent;
    uint2 from_frames_extent;
};
static_assert(offsetof(read_box_b7c9e6e7_general_parameters, size) == 0);
static_assert(offsetof(read_box_b7c9e6e7_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_b7c9e6e7_general_parameters, to_origin) == 8);
static_assert(offsetof(read_box_b7c9e6e7_general_parameters, from_extent) == 12);
static_assert(offsetof(read_box_b7c9e6e7_general_parameters, from_table_extent) == 16);
static_assert(offsetof(read_box_b7c9e6e7_general_parameters, from_frames_extent) == 20);

// transfer.glift:15: runs kernel read_box<Paged, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_b7c9e6e7_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_b7c9e6e7_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint from_extent = parameters.from_extent;
    const uint from_table_extent = parameters.from_table_extent;
    const uint2 from_frames_extent = parameters.from_frames_extent;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:16
            const uint to_address = to_origin + address;
            float* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // transfer.glift:16
                const uint from_address = from_origin + address;
                // transfer.glift:15
                bool from_either = from_address >= from_extent;
                if (!from_either) {
                    const uint from_table_address = from_address / 16u;
                    const bool from_table_value_inside = from_table_address < from_table_extent;
                    const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                    from_either = (from_table_value_inside ? from_table_value : 0u) == 0u;
                }
                uint2 from_result{};
                bool from_found{};
                if (from_either) {
                    from_result = uint2(0u);
                    from_found = false;
                } else {
                    const uint from_table_address = from_address / 16u;
                    const bool from_table_value_inside = from_table_address < from_table_extent;
                    const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                    from_result = uint2(from_address % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                    from_found = true;
                }
                const uint2 from_place = from_result;
                const uint from_at = from_place.y * from_frames_extent.x + from_place.x;
                const bool from_found_2 = from_found && from_place.y < from_frames_extent.y;
                // transfer.glift:16
                const float from_value = from_frames_data[from_found_2 ? from_at : 0u];
                to_data_row[i] = from_found_2 ? from_value : -1.0f;
            }
        }
    }
}

static void read_box_b7c9e6e7_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_b7c9e6e7_general_rows(call,
        rows); });
}

struct read_box_b7c9e6e7_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint from_extent;
    uint from_table_extent;
    std::uint64_t from_frames_extent_x;
    uint from_frames_extent_y;
    std::uint64_t from_table_data_address;
    std::uint64_t from_frames_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_b7c9e6e7_wide_parameters, size) == 0);
static_assert(offsetof(read_box_b7c9e6e7_wide_parameters, from_origin) == 4);
static_assert(offsetof(read_box_b7c9e6e7_wide_parameters, to_origin) == 8);
static_assert(offsetof(read_box_b7c9e6e7_wide_parameters, from_extent) == 12);
static_assert(offsetof(read_box_b7c9e6e7_wide_parameters, from_table_extent) == 16);
static_assert(offsetof(read_box_b7c9e6e7_wide_parameters, from_frames_extent_x) == 24);
static_assert(offsetof(read_box_b7c9e6e7_wide_parameters, from_frames_extent_y) == 32);
static_assert(offsetof(read_box_b7c9e6e7_wide_parameters, from_table_data_address) == 40);
static_assert(offsetof(read_box_b7c9e6e7_wide_parameters, from_frames_data_address) == 48);
static_assert(offsetof(read_box_b7c9e6e7_wide_parameters, to_data_address) == 56);

// transfer.glift:15: runs kernel read_box<Paged, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_b7c9e6e7_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_b7c9e6e7_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint from_extent = parameters.from_extent;
    const uint from_table_extent = parameters.from_table_extent;
    const std::uint64_t from_frames_extent_x = parameters.from_frames_extent_x;
    const uint from_frames_extent_y = parameters.from_frames_extent_y;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            // transfer.glift:15
            bool from_either = from_address >= from_extent;
            if (!from_either) {
                const uint from_table_address = from_address / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const std::uint64_t from_table_value_at = std::uint64_t(from_table_address);
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_value_at
                    : std::uint64_t{0u}];
                from_either = (from_table_value_inside ? from_table_value : 0u) == 0u;
            }
            uint2 from_result{};
            bool from_found{};
            if (from_either) {
                from_result = uint2(0u);
                from_found = false;
            } else {
                const uint from_table_address = from_address / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const std::uint64_t from_table_value_at = std::uint64_t(from_table_address);
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_value_at
                    : std::uint64_t{0u}];
                from_result = uint2(from_address % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                from_found = true;
            }
            const uint2 from_place = from_result;
            const std::uint64_t from_at = std::uint64_t(from_place.y) * from_frames_extent_x
                + std::uint64_t(from_place.x);
            const bool from_found_2 = from_found && from_place.y < from_frames_extent_y;
            // transfer.glift:16
            const uint to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:16
            const float from_value = from_frames_data[from_found_2 ? from_at : std::uint64_t{0u}];
            to_data[to_at] = from_found_2 ? from_value : -1.0f;
        }
    }
}

static void read_box_b7c9e6e7_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_b7c9e6e7_wide_rows(call, rows); });
}

const glift::Binding read_box_b7c9e6e7_bindings[] = {
    {.name = "from.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 40,
        .element_bytes = sizeof(uint)},
    {.name = "from.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 48,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 56,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_b7c9e6e7_parameters[] = {
    {"from_extent", 0, sizeof(read_box_b7c9e6e7_direct_parameters::from_extent)},
    {"from_table_extent", 4, sizeof(read_box_b7c9e6e7_direct_parameters::from_table_extent)},
    {"from_frames_extent", 8, sizeof(read_box_b7c9e6e7_direct_parameters::from_frames_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_b7c9e6e7_kernel;
const glift::Kernel read_box_b7c9e6e7_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_b7c9e6e7_bindings,
    .direct = {.host = &read_box_b7c9e6e7_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &read_box_b7c9e6e7_general, .parameter_bytes = 28},
    .wide = {.host = &read_box_b7c9e6e7_wide, .parameter_bytes = 64},
    .parameters = read_box_b7c9e6e7_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, float>, Paged>

namespace {
struct write_box_a6c67e1e_direct_parameters {
    uint from_extent;
    uint to_extent;
    uint to_table_extent;
    uint2 to_frames_extent;
};
static_assert(offsetof(write_box_a6c67e1e_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_a6c67e1e_direct_parameters, to_extent) == 4);
static_assert(offsetof(write_box_a6c67e1e_direct_parameters, to_table_extent) == 8);
static_assert(offsetof(write_box_a6c67e1e_direct_parameters, to_frames_extent) == 12);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Paged> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_a6c67e1e_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_a6c67e1e_direct_parameters*>(call.parameters);
    const uint to_extent = parameters.to_extent;
    const uint to_table_extent = parameters.to_table_extent;
    const uint2 to_frames_extent = parameters.to_frames_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_frames_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:20
            bool to_either = address >= to_extent;
            if (!to_either) {
                const uint to_table_address = address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_result = uint2(address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const uint to_at = to_place.y * to_frames_extent.x + to_place.x;
            const bool to_found_2 = to_found && to_place.y < to_frames_extent.y;
            // transfer.glift:21
            if (to_found_2) {
                to_frames_data[to_at] = from_data[address];
            }
        }
    }
}

static void write_box_a6c67e1e_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_a6c67e1e_direct_rows(call,
        rows); });
}

struct write_box_a6c67e1e_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint to_extent;
    uint to_table_extent;
    uint2 to_frames_extent;
};
static_assert(offsetof(write_box_a6c67e1e_general_parameters, size) == 0);
static_assert(offsetof(write_box_a6c67e1e_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_a6c67e1e_general_parameters, to_origin) == 8);
static_assert(offsetof(write_box_a6c67e1e_general_parameters, to_extent) == 12);
static_assert(offsetof(write_box_a6c67e1e_general_parameters, to_table_extent) == 16);
static_assert(offsetof(write_box_a6c67e1e_general_parameters, to_frames_extent) == 20);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Paged> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_a6c67e1e_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_a6c67e1e_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint to_extent = parameters.to_extent;
    const uint to_table_extent = parameters.to_table_extent;
    const uint2 to_frames_extent = parameters.to_frames_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_frames_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:21
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            // transfer.glift:20
            bool to_either = to_address >= to_extent;
            if (!to_either) {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_result = uint2(to_address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const uint to_at = to_place.y * to_frames_extent.x + to_place.x;
            const bool to_found_2 = to_found && to_place.y < to_frames_extent.y;
            // transfer.glift:21
            if (to_found_2) {
                to_frames_data[to_at] = from_data[from_address];
            }
        }
    }
}

static void write_box_a6c67e1e_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_a6c67e1e_general_rows(call,
        rows); });
}

struct write_box_a6c67e1e_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint to_extent;
    uint to_table_extent;
    std::uint64_t to_frames_extent_x;
    uint to_frames_extent_y;
    std::uint64_t from_data_address;
    std::uint64_t to_table_data_address;
    std::uint64_t to_frames_data_address;
};
static_assert(offsetof(write_box_a6c67e1e_wide_parameters, size) == 0);
static_assert(offsetof(write_box_a6c67e1e_wide_parameters, from_origin) == 4);
static_assert(offsetof(write_box_a6c67e1e_wide_parameters, to_origin) == 8);
static_assert(offsetof(write_box_a6c67e1e_wide_parameters, to_extent) == 12);
static_assert(offsetof(write_box_a6c67e1e_wide_parameters, to_table_extent) == 16);
static_assert(offsetof(write_box_a6c67e1e_wide_parameters, to_frames_extent_x) == 24);
static_assert(offsetof(write_box_a6c67e1e_wide_parameters, to_frames_extent_y) == 32);
static_assert(offsetof(write_box_a6c67e1e_wide_parameters, from_data_address) == 40);
static_assert(offsetof(write_box_a6c67e1e_wide_parameters, to_table_data_address) == 48);
static_assert(offsetof(write_box_a6c67e1e_wide_parameters, to_frames_data_address) == 56);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Paged> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_a6c67e1e_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_a6c67e1e_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint to_extent = parameters.to_extent;
    const uint to_table_extent = parameters.to_table_extent;
    const std::uint64_t to_frames_extent_x = parameters.to_frames_extent_x;
    const uint to_frames_extent_y = parameters.to_frames_extent_y;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_frames_data = glift::host::elements<float>(call.memories[2]);
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
            bool to_either = to_address >= to_extent;
            if (!to_either) {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const std::uint64_t to_table_value_at = std::uint64_t(to_table_address);
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_value_at
                    : std::uint64_t{0u}];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const std::uint64_t to_table_value_at = std::uint64_t(to_table_address);
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_value_at
                    : std::uint64_t{0u}];
                to_result = uint2(to_address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const std::uint64_t to_at = std::uint64_t(to_place.y) * to_frames_extent_x + std::uint64_t(to_place.x);
            const bool to_found_2 = to_found && to_place.y < to_frames_extent_y;
            // transfer.glift:21
            if (to_found_2) {
                to_frames_data[to_at] = from_data[from_at];
            }
        }
    }
}

static void write_box_a6c67e1e_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_a6c67e1e_wide_rows(call, rows); });
}

const glift::Binding write_box_a6c67e1e_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 40,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 48,
        .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "to.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 56,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_a6c67e1e_parameters[] = {
    {"from_extent", 0, sizeof(write_box_a6c67e1e_direct_parameters::from_extent)},
    {"to_extent", 4, sizeof(write_box_a6c67e1e_direct_parameters::to_extent)},
    {"to_table_extent", 8, sizeof(write_box_a6c67e1e_direct_parameters::to_table_extent)},
    {"to_frames_extent", 12, sizeof(write_box_a6c67e1e_direct_parameters::to_frames_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_a6c67e1e_kernel;
const glift::Kernel write_box_a6c67e1e_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_a6c67e1e_bindings,
    .direct = {.host = &write_box_a6c67e1e_direct, .parameter_bytes = 20, .push_constants = true},
    .general = {.host = &write_box_a6c67e1e_general, .parameter_bytes = 28},
    .wide = {.host = &write_box_a6c67e1e_wide, .parameter_bytes = 64},
    .parameters = write_box_a6c67e1e_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Paged, float>

namespace {
struct fill_box_shared_Paged_float_direct_parameters {
    uint to_extent;
    uint to_table_extent;
    uint2 to_frames_extent;
    float value;
};
static_assert(offsetof(fill_box_shared_Paged_float_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_shared_Paged_float_direct_parameters, to_table_extent) == 4);
static_assert(offsetof(fill_box_shared_Paged_float_direct_parameters, to_frames_extent) == 8);
static_assert(offsetof(fill_box_shared_Paged_float_direct_parameters, value) == 16);

// transfer.glift:25: runs kernel fill_box<Paged, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_shared_Paged_float_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_shared_Paged_float_direct_parameters*>(call.parameters);
    const uint to_extent = parameters.to_extent;
    const uint to_table_extent = parameters.to_table_extent;
    const uint2 to_frames_extent = parameters.to_frames_extent;
    const float value = parameters.value;
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[0]);
    float* to_frames_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:25
            bool to_either = address >= to_extent;
            if (!to_either) {
                const uint to_table_address = address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_result = uint2(address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const uint to_at = to_place.y * to_frames_extent.x + to_place.x;
            const bool to_found_2 = to_found && to_place.y < to_frames_extent.y;
            // transfer.glift:26
            if (to_found_2) {
                to_frames_data[to_at] = value;
            }
        }
    }
}

static void fill_box_shared_Paged_float_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_shared_Paged_float_direct_rows(call,
        rows); });
}

struct fill_box_shared_Paged_float_general_parameters {
    uint size;
    uint to_origin;
    uint to_extent;
    uint to_table_extent;
    uint2 to_frames_extent;
    float value;
};
static_assert(offsetof(fill_box_shared_Paged_float_general_parameters, size) == 0);
static_assert(offsetof(fill_box_shared_Paged_float_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_shared_Paged_float_general_parameters, to_extent) == 8);
static_assert(offsetof(fill_box_shared_Paged_float_general_parameters, to_table_extent) == 12);
static_assert(offsetof(fill_box_shared_Paged_float_general_parameters, to_frames_extent) == 16);
static_assert(offsetof(fill_box_shared_Paged_float_general_parameters, value) == 24);

// transfer.glift:25: runs kernel fill_box<Paged, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_shared_Paged_float_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_shared_Paged_float_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint to_extent = parameters.to_extent;
    const uint to_table_extent = parameters.to_table_extent;
    const uint2 to_frames_extent = parameters.to_frames_extent;
    const float value = parameters.value;
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[0]);
    float* to_frames_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            // transfer.glift:25
            bool to_either = to_address >= to_extent;
            if (!to_either) {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_result = uint2(to_address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const uint to_at = to_place.y * to_frames_extent.x + to_place.x;
            const bool to_found_2 = to_found && to_place.y < to_frames_extent.y;
            // transfer.glift:26
            if (to_found_2) {
                to_frames_data[to_at] = value;
            }
        }
    }
}

static void fill_box_shared_Paged_float_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_shared_Paged_float_general_rows(call,
        rows); });
}

struct fill_box_shared_Paged_float_wide_parameters {
    uint size;
    uint to_origin;
    uint to_extent;
    uint to_table_extent;
    std::uint64_t to_frames_extent_x;
    uint to_frames_extent_y;
    float value;
    std::uint64_t to_table_data_address;
    std::uint64_t to_frames_data_address;
};
static_assert(offsetof(fill_box_shared_Paged_float_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_shared_Paged_float_wide_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_shared_Paged_float_wide_parameters, to_extent) == 8);
static_assert(offsetof(fill_box_shared_Paged_float_wide_parameters, to_table_extent) == 12);
static_assert(offsetof(fill_box_shared_Paged_float_wide_parameters, to_frames_extent_x) == 16);
static_assert(offsetof(fill_box_shared_Paged_float_wide_parameters, to_frames_extent_y) == 24);
static_assert(offsetof(fill_box_shared_Paged_float_wide_parameters, value) == 28);
static_assert(offsetof(fill_box_shared_Paged_float_wide_parameters, to_table_data_address) == 32);
static_assert(offsetof(fill_box_shared_Paged_float_wide_parameters, to_frames_data_address) == 40);

// transfer.glift:25: runs kernel fill_box<Paged, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_shared_Paged_float_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_shared_Paged_float_wide_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint to_extent = parameters.to_extent;
    const uint to_table_extent = parameters.to_table_extent;
    const std::uint64_t to_frames_extent_x = parameters.to_frames_extent_x;
    const uint to_frames_extent_y = parameters.to_frames_extent_y;
    const float value = parameters.value;
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[0]);
    float* to_frames_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            // transfer.glift:25
            bool to_either = to_address >= to_extent;
            if (!to_either) {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const std::uint64_t to_table_value_at = std::uint64_t(to_table_address);
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_value_at
                    : std::uint64_t{0u}];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const std::uint64_t to_table_value_at = std::uint64_t(to_table_address);
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_value_at
                    : std::uint64_t{0u}];
                to_result = uint2(to_address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const std::uint64_t to_at = std::uint64_t(to_place.y) * to_frames_extent_x + std::uint64_t(to_place.x);
            const bool to_found_2 = to_found && to_place.y < to_frames_extent_y;
            // transfer.glift:26
            if (to_found_2) {
                to_frames_data[to_at] = value;
            }
        }
    }
}

static void fill_box_shared_Paged_float_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_shared_Paged_float_wide_rows(call,
        rows); });
}

const glift::Binding fill_box_shared_Paged_float_bindings[] = {
    {.name = "to.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .element_bytes = sizeof(uint)},
    {.name = "to.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
};
constexpr glift::Parameter fill_box_shared_Paged_float_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_shared_Paged_float_direct_parameters::to_extent)},
    {"to_table_extent", 4, sizeof(fill_box_shared_Paged_float_direct_parameters::to_table_extent)},
    {"to_frames_extent", 8, sizeof(fill_box_shared_Paged_float_direct_parameters::to_frames_extent)},
    {"value", 16, sizeof(fill_box_shared_Paged_float_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_shared_Paged_float_kernel;
const glift::Kernel fill_box_shared_Paged_float_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_shared_Paged_float_bindings,
    .direct = {.host = &fill_box_shared_Paged_float_direct, .parameter_bytes = 20, .push_constants = true},
    .general = {.host = &fill_box_shared_Paged_float_general, .parameter_bytes = 28},
    .wide = {.host = &fill_box_shared_Paged_float_wide, .parameter_bytes = 48},
    .parameters = fill_box_shared_Paged_float_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:32: list_there<Paged, Paged, Box<1, uint>, Box<1, uint2>, Box<1, float>, Box<1, uint>>

namespace {
struct list_there_2c6db734_direct_parameters {
    uint a_extent;
    uint a_table_extent;
    uint2 a_frames_extent;
    glift::Bool counter_extent_value_0;
    uint addresses_extent;
    uint values_extent;
    uint translated_extent;
    uint translated_table_extent;
    uint translated_frames_extent_y;
    uint places_extent;
};
static_assert(offsetof(list_there_2c6db734_direct_parameters, a_extent) == 0);
static_assert(offsetof(list_there_2c6db734_direct_parameters, a_table_extent) == 4);
static_assert(offsetof(list_there_2c6db734_direct_parameters, a_frames_extent) == 8);
static_assert(offsetof(list_there_2c6db734_direct_parameters, counter_extent_value_0) == 16);
static_assert(offsetof(list_there_2c6db734_direct_parameters, addresses_extent) == 20);
static_assert(offsetof(list_there_2c6db734_direct_parameters, values_extent) == 24);
static_assert(offsetof(list_there_2c6db734_direct_parameters, translated_extent) == 28);
static_assert(offsetof(list_there_2c6db734_direct_parameters, translated_table_extent) == 32);
static_assert(offsetof(list_there_2c6db734_direct_parameters, translated_frames_extent_y) == 36);
static_assert(offsetof(list_there_2c6db734_direct_parameters, places_extent) == 40);

// transfer.glift:32: runs kernel list_there<Paged, Paged, Box<1, uint>, Box<1, uint2>, Box<1, float>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_2c6db734_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_2c6db734_direct_parameters*>(call.parameters);
    const uint a_extent = parameters.a_extent;
    const uint a_table_extent = parameters.a_table_extent;
    const uint2 a_frames_extent = parameters.a_frames_extent;
    const bool counter_extent_value_0 = parameters.counter_extent_value_0;
    const uint addresses_extent = parameters.addresses_extent;
    const uint values_extent = parameters.values_extent;
    const uint translated_extent = parameters.translated_extent;
    const uint translated_table_extent = parameters.translated_table_extent;
    const uint translated_frames_extent_y = parameters.translated_frames_extent_y;
    const uint places_extent = parameters.places_extent;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    uint* counter_data = glift::host::elements<uint>(call.memories[2]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[3]);
    float* values_data = glift::host::elements<float>(call.memories[4]);
    const uint* translated_table_data = glift::host::elements<const uint>(call.memories[5]);
    uint2* places_data = glift::host::elements<uint2>(call.memories[6]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:36
            const bool test = address >= a_extent;
            bool from_either = test;
            if (!from_either) {
                const uint from_table_address = address / 16u;
                const bool from_table_value_inside = from_table_address < a_table_extent;
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                from_either = (from_table_value_inside ? from_table_value : 0u) == 0u;
            }
            uint2 from_result{};
            bool from_found{};
            if (from_either) {
                from_result = uint2(0u);
                from_found = false;
            } else {
                const uint from_table_address = address / 16u;
                const bool from_table_value_inside = from_table_address < a_table_extent;
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                from_result = uint2(address % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                from_found = true;
            }
            const uint2 from_place = from_result;
            float result{};
            bool found{};
            if (from_found && from_place.y < a_frames_extent.y) {
                bool from_either_2 = test;
                if (!from_either_2) {
                    const uint from_table_address = address / 16u;
                    const bool from_table_value_inside = from_table_address < a_table_extent;
                    const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                    from_either_2 = (from_table_value_inside ? from_table_value : 0u) == 0u;
                }
                uint2 from_result_2{};
                bool from_found_2{};
                if (from_either_2) {
                    from_result_2 = uint2(0u);
                    from_found_2 = false;
                } else {
                    const uint from_table_address = address / 16u;
                    const bool from_table_value_inside = from_table_address < a_table_extent;
                    const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                    from_result_2 = uint2(address % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                    from_found_2 = true;
                }
                const uint2 from_place_2 = from_result_2;
                const bool from_value_inside = from_found_2 && from_place_2.y < a_frames_extent.y;
                const uint from_value_at = from_place_2.y * a_frames_extent.x + from_place_2.x;
                const float from_value = from_frames_data[from_value_inside ? from_value_at : 0u];
                result = from_value_inside ? from_value : -1.0f;
                found = true;
            } else {
                result = 0.0f;
                found = false;
            }
            const float found_2 = result;
            const bool found_found = found;
            if (found_found) {
                // transfer.glift:37
                uint counter_before = 0u;
                if (counter_extent_value_0) {
                    counter_before = glift::host::memory::atomicAdd(counter_data[0u], 1u);
                }
                const uint entry = counter_before;
                // transfer.glift:38
                if (entry < addresses_extent) {
                    addresses_data[entry] = address;
                }
                // transfer.glift:39
                if (entry < values_extent) {
                    values_data[entry] = found_2;
                }
                // transfer.glift:40
                const bool test_2 = address >= translated_extent;
                bool translated_either = test_2;
                if (!translated_either) {
                    const uint translated_table_address = address / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_either = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result{};
                if (translated_either) {
                    translated_result = uint2(0u);
                } else {
                    const uint translated_table_address = address / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_result = uint2(address % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                }
                bool translated_either_2 = test_2;
                if (!translated_either_2) {
                    const uint translated_table_address = address / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_either_2 = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result_2{};
                bool translated_found{};
                if (translated_either_2) {
                    translated_result_2 = uint2(0u);
                    translated_found = false;
                } else {
                    const uint translated_table_address = address / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_result_2 = uint2(address % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                    translated_found = true;
                }
                const uint2 translated_place = translated_result_2;
                const uint2 found_3 = translated_result;
                const bool found_found_2 = translated_found && translated_place.y < translated_frames_extent_y;
                if (found_found_2) {
                    // transfer.glift:41
                    if (entry < places_extent) {
                        places_data[entry] = found_3;
                    }
                }
            }
        }
    }
}

static void list_there_2c6db734_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_2c6db734_direct_rows(call,
        rows); });
}

struct list_there_2c6db734_general_parameters {
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
    uint from_extent;
    uint from_table_extent;
    uint2 from_frames_extent;
    uint translated_extent;
    uint translated_table_extent;
    uint translated_frames_extent_y;
};
static_assert(offsetof(list_there_2c6db734_general_parameters, size) == 0);
static_assert(offsetof(list_there_2c6db734_general_parameters, a_origin) == 4);
static_assert(offsetof(list_there_2c6db734_general_parameters, from_origin) == 8);
static_assert(offsetof(list_there_2c6db734_general_parameters, counter_origin) == 12);
static_assert(offsetof(list_there_2c6db734_general_parameters, counter_size) == 16);
static_assert(offsetof(list_there_2c6db734_general_parameters, addresses_origin) == 20);
static_assert(offsetof(list_there_2c6db734_general_parameters, addresses_size) == 24);
static_assert(offsetof(list_there_2c6db734_general_parameters, values_origin) == 28);
static_assert(offsetof(list_there_2c6db734_general_parameters, values_size) == 32);
static_assert(offsetof(list_there_2c6db734_general_parameters, translated_origin) == 36);
static_assert(offsetof(list_there_2c6db734_general_parameters, places_origin) == 40);
static_assert(offsetof(list_there_2c6db734_general_parameters, places_size) == 44);
static_assert(offsetof(list_there_2c6db734_general_parameters, from_extent) == 48);
static_assert(offsetof(list_there_2c6db734_general_parameters, from_table_extent) == 52);
static_assert(offsetof(list_there_2c6db734_general_parameters, from_frames_extent) == 56);
static_assert(offsetof(list_there_2c6db734_general_parameters, translated_extent) == 64);
static_assert(offsetof(list_there_2c6db734_general_parameters, translated_table_extent) == 68);
static_assert(offsetof(list_there_2c6db734_general_parameters, translated_frames_extent_y) == 72);

// transfer.glift:32: runs kernel list_there<Paged, Paged, Box<1, uint>, Box<1, uint2>, Box<1, float>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_2c6db734_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_2c6db734_general_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint from_origin = parameters.from_origin;
    const uint counter_origin = parameters.counter_origin;
    const uint counter_size = parameters.counter_size;
    const uint addresses_origin = parameters.addresses_origin;
    const uint addresses_size = parameters.addresses_size;
    const uint values_origin = parameters.values_origin;
    const uint values_size = parameters.values_size;
    const uint translated_origin = parameters.translated_origin;
    const uint places_origin = parameters.places_origin;
    const uint places_size = parameters.places_size;
    const uint from_extent = parameters.from_extent;
    const uint from_table_extent = parameters.from_table_extent;
    const uint2 from_frames_extent = parameters.from_frames_extent;
    const uint translated_extent = parameters.translated_extent;
    const uint translated_table_extent = parameters.translated_table_extent;
    const uint translated_frames_extent_y = parameters.translated_frames_extent_y;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    uint* counter_data = glift::host::elements<uint>(call.memories[2]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[3]);
    float* values_data = glift::host::elements<float>(call.memories[4]);
    const uint* translated_table_data = glift::host::elements<const uint>(call.memories[5]);
    uint2* places_data = glift::host::elements<uint2>(call.memories[6]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:36
            const uint a_address = a_origin + address;
            const uint from_virtual = from_origin + a_address;
            const bool test = from_virtual >= from_extent;
            bool from_either = test;
            if (!from_either) {
                const uint from_table_address = from_virtual / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                from_either = (from_table_value_inside ? from_table_value : 0u) == 0u;
            }
            uint2 from_result{};
            bool from_found{};
            if (from_either) {
                from_result = uint2(0u);
                from_found = false;
            } else {
                const uint from_table_address = from_virtual / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                from_result = uint2(from_virtual % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                from_found = true;
            }
            const uint2 from_place = from_result;
            float result{};
            bool found{};
            if (from_found && from_place.y < from_frames_extent.y) {
                bool from_either_2 = test;
                if (!from_either_2) {
                    const uint from_table_address = from_virtual / 16u;
                    const bool from_table_value_inside = from_table_address < from_table_extent;
                    const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                    from_either_2 = (from_table_value_inside ? from_table_value : 0u) == 0u;
                }
                uint2 from_result_2{};
                bool from_found_2{};
                if (from_either_2) {
                    from_result_2 = uint2(0u);
                    from_found_2 = false;
                } else {
                    const uint from_table_address = from_virtual / 16u;
                    const bool from_table_value_inside = from_table_address < from_table_extent;
                    const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                    from_result_2 = uint2(from_virtual % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                    from_found_2 = true;
                }
                const uint2 from_place_2 = from_result_2;
                const bool from_value_inside = from_found_2 && from_place_2.y < from_frames_extent.y;
                const uint from_value_at = from_place_2.y * from_frames_extent.x + from_place_2.x;
                const float from_value = from_frames_data[from_value_inside ? from_value_at : 0u];
                result = from_value_inside ? from_value : -1.0f;
                found = true;
            } else {
                result = 0.0f;
                found = false;
            }
            const float found_2 = result;
            const bool found_found = found;
            if (found_found) {
                // transfer.glift:37
                uint counter_before = 0u;
                if (0u < counter_size) {
                    counter_before = glift::host::memory::atomicAdd(counter_data[counter_origin], 1u);
                }
                const uint entry = counter_before;
                // transfer.glift:38
                const uint addresses_virtual = addresses_origin + entry;
                if (entry < addresses_size) {
                    addresses_data[addresses_virtual] = a_address;
                }
                // transfer.glift:39
                const uint values_virtual = values_origin + entry;
                if (entry < values_size) {
                    values_data[values_virtual] = found_2;
                }
                // transfer.glift:40
                const uint value = translated_origin + a_address;
                const bool test_2 = value >= translated_extent;
                bool translated_either = test_2;
                if (!translated_either) {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_either = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result{};
                if (translated_either) {
                    translated_result = uint2(0u);
                } else {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_result = uint2(value % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                }
                bool translated_either_2 = test_2;
                if (!translated_either_2) {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_either_2 = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result_2{};
                bool translated_found{};
                if (translated_either_2) {
                    translated_result_2 = uint2(0u);
                    translated_found = false;
                } else {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_result_2 = uint2(value % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                    translated_found = true;
                }
                const uint2 translated_place = translated_result_2;
                const uint2 found_3 = translated_result;
                const bool found_found_2 = translated_found && translated_place.y < translated_frames_extent_y;
                if (found_found_2) {
                    // transfer.glift:41
                    const uint places_virtual = places_origin + entry;
                    if (entry < places_size) {
                        places_data[places_virtual] = found_3;
                    }
                }
            }
        }
    }
}

static void list_there_2c6db734_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_2c6db734_general_rows(call,
        rows); });
}

struct list_there_2c6db734_wide_parameters {
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
    uint from_extent;
    uint from_table_extent;
    uint from_frames_extent_y;
    std::uint64_t from_frames_extent_x;
    uint translated_extent;
    uint translated_table_extent;
    uint translated_frames_extent_y;
    std::uint64_t from_table_data_address;
    std::uint64_t from_frames_data_address;
    std::uint64_t counter_data_address;
    std::uint64_t addresses_data_address;
    std::uint64_t values_data_address;
    std::uint64_t translated_table_data_address;
    std::uint64_t places_data_address;
};
static_assert(offsetof(list_there_2c6db734_wide_parameters, size) == 0);
static_assert(offsetof(list_there_2c6db734_wide_parameters, a_origin) == 4);
static_assert(offsetof(list_there_2c6db734_wide_parameters, from_origin) == 8);
static_assert(offsetof(list_there_2c6db734_wide_parameters, counter_origin) == 12);
static_assert(offsetof(list_there_2c6db734_wide_parameters, counter_size) == 16);
static_assert(offsetof(list_there_2c6db734_wide_parameters, addresses_origin) == 20);
static_assert(offsetof(list_there_2c6db734_wide_parameters, addresses_size) == 24);
static_assert(offsetof(list_there_2c6db734_wide_parameters, values_origin) == 28);
static_assert(offsetof(list_there_2c6db734_wide_parameters, values_size) == 32);
static_assert(offsetof(list_there_2c6db734_wide_parameters, translated_origin) == 36);
static_assert(offsetof(list_there_2c6db734_wide_parameters, places_origin) == 40);
static_assert(offsetof(list_there_2c6db734_wide_parameters, places_size) == 44);
static_assert(offsetof(list_there_2c6db734_wide_parameters, from_extent) == 48);
static_assert(offsetof(list_there_2c6db734_wide_parameters, from_table_extent) == 52);
static_assert(offsetof(list_there_2c6db734_wide_parameters, from_frames_extent_y) == 56);
static_assert(offsetof(list_there_2c6db734_wide_parameters, from_frames_extent_x) == 64);
static_assert(offsetof(list_there_2c6db734_wide_parameters, translated_extent) == 72);
static_assert(offsetof(list_there_2c6db734_wide_parameters, translated_table_extent) == 76);
static_assert(offsetof(list_there_2c6db734_wide_parameters, translated_frames_extent_y) == 80);
static_assert(offsetof(list_there_2c6db734_wide_parameters, from_table_data_address) == 88);
static_assert(offsetof(list_there_2c6db734_wide_parameters, from_frames_data_address) == 96);
static_assert(offsetof(list_there_2c6db734_wide_parameters, counter_data_address) == 104);
static_assert(offsetof(list_there_2c6db734_wide_parameters, addresses_data_address) == 112);
static_assert(offsetof(list_there_2c6db734_wide_parameters, values_data_address) == 120);
static_assert(offsetof(list_there_2c6db734_wide_parameters, translated_table_data_address) == 128);
static_assert(offsetof(list_there_2c6db734_wide_parameters, places_data_address) == 136);

// transfer.glift:32: runs kernel list_there<Paged, Paged, Box<1, uint>, Box<1, uint2>, Box<1, float>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_2c6db734_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_2c6db734_wide_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint from_origin = parameters.from_origin;
    const uint counter_origin = parameters.counter_origin;
    const uint counter_size = parameters.counter_size;
    const uint addresses_origin = parameters.addresses_origin;
    const uint addresses_size = parameters.addresses_size;
    const uint values_origin = parameters.values_origin;
    const uint values_size = parameters.values_size;
    const uint translated_origin = parameters.translated_origin;
    const uint places_origin = parameters.places_origin;
    const uint places_size = parameters.places_size;
    const uint from_extent = parameters.from_extent;
    const uint from_table_extent = parameters.from_table_extent;
    const uint from_frames_extent_y = parameters.from_frames_extent_y;
    const std::uint64_t from_frames_extent_x = parameters.from_frames_extent_x;
    const uint translated_extent = parameters.translated_extent;
    const uint translated_table_extent = parameters.translated_table_extent;
    const uint translated_frames_extent_y = parameters.translated_frames_extent_y;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    uint* counter_data = glift::host::elements<uint>(call.memories[2]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[3]);
    float* values_data = glift::host::elements<float>(call.memories[4]);
    const uint* translated_table_data = glift::host::elements<const uint>(call.memories[5]);
    uint2* places_data = glift::host::elements<uint2>(call.memories[6]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:36
            const uint a_address = a_origin + address;
            const uint from_virtual = from_origin + a_address;
            const bool test = from_virtual >= from_extent;
            bool from_either = test;
            if (!from_either) {
                const uint from_table_address = from_virtual / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const std::uint64_t from_table_value_at = std::uint64_t(from_table_address);
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_value_at
                    : std::uint64_t{0u}];
                from_either = (from_table_value_inside ? from_table_value : 0u) == 0u;
            }
            uint2 from_result{};
            bool from_found{};
            if (from_either) {
                from_result = uint2(0u);
                from_found = false;
            } else {
                const uint from_table_address = from_virtual / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const std::uint64_t from_table_value_at = std::uint64_t(from_table_address);
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_value_at
                    : std::uint64_t{0u}];
                from_result = uint2(from_virtual % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                from_found = true;
            }
            const uint2 from_place = from_result;
            float result{};
            bool found{};
            if (from_found && from_place.y < from_frames_extent_y) {
                bool from_either_2 = test;
                if (!from_either_2) {
                    const uint from_table_address = from_virtual / 16u;
                    const bool from_table_value_inside = from_table_address < from_table_extent;
                    const std::uint64_t from_table_value_at = std::uint64_t(from_table_address);
                    const uint from_table_value = from_table_data[from_table_value_inside ? from_table_value_at
                        : std::uint64_t{0u}];
                    from_either_2 = (from_table_value_inside ? from_table_value : 0u) == 0u;
                }
                uint2 from_result_2{};
                bool from_found_2{};
                if (from_either_2) {
                    from_result_2 = uint2(0u);
                    from_found_2 = false;
                } else {
                    const uint from_table_address = from_virtual / 16u;
                    const bool from_table_value_inside = from_table_address < from_table_extent;
                    const std::uint64_t from_table_value_at = std::uint64_t(from_table_address);
                    const uint from_table_value = from_table_data[from_table_value_inside ? from_table_value_at
                        : std::uint64_t{0u}];
                    from_result_2 = uint2(from_virtual % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                    from_found_2 = true;
                }
                const uint2 from_place_2 = from_result_2;
                const bool from_value_inside = from_found_2 && from_place_2.y < from_frames_extent_y;
                const std::uint64_t from_value_at = std::uint64_t(from_place_2.y) * from_frames_extent_x
                    + std::uint64_t(from_place_2.x);
                const float from_value = from_frames_data[from_value_inside ? from_value_at : std::uint64_t{0u}];
                result = from_value_inside ? from_value : -1.0f;
                found = true;
            } else {
                result = 0.0f;
                found = false;
            }
            const float found_2 = result;
            const bool found_found = found;
            if (found_found) {
                // transfer.glift:37
                uint counter_before = 0u;
                if (0u < counter_size) {
                    counter_before = glift::host::memory::atomicAdd(counter_data[std::uint64_t(counter_origin)], 1u);
                }
                const uint entry = counter_before;
                // transfer.glift:38
                const uint addresses_virtual = addresses_origin + entry;
                if (entry < addresses_size) {
                    addresses_data[std::uint64_t(addresses_virtual)] = a_address;
                }
                // transfer.glift:39
                const uint values_virtual = values_origin + entry;
                if (entry < values_size) {
                    values_data[std::uint64_t(values_virtual)] = found_2;
                }
                // transfer.glift:40
                const uint value = translated_origin + a_address;
                const bool test_2 = value >= translated_extent;
                bool translated_either = test_2;
                if (!translated_either) {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const std::uint64_t translated_table_value_at = std::uint64_t(translated_table_address);
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_value_at : std::uint64_t{0u}];
                    translated_either = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result{};
                if (translated_either) {
                    translated_result = uint2(0u);
                } else {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const std::uint64_t translated_table_value_at = std::uint64_t(translated_table_address);
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_value_at : std::uint64_t{0u}];
                    translated_result = uint2(value % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                }
                bool translated_either_2 = test_2;
                if (!translated_either_2) {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const std::uint64_t translated_table_value_at = std::uint64_t(translated_table_address);
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_value_at : std::uint64_t{0u}];
                    translated_either_2 = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result_2{};
                bool translated_found{};
                if (translated_either_2) {
                    translated_result_2 = uint2(0u);
                    translated_found = false;
                } else {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const std::uint64_t translated_table_value_at = std::uint64_t(translated_table_address);
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_value_at : std::uint64_t{0u}];
                    translated_result_2 = uint2(value % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                    translated_found = true;
                }
                const uint2 translated_place = translated_result_2;
                const uint2 found_3 = translated_result;
                const bool found_found_2 = translated_found && translated_place.y < translated_frames_extent_y;
                if (found_found_2) {
                    // transfer.glift:41
                    const uint places_virtual = places_origin + entry;
                    if (entry < places_size) {
                        places_data[std::uint64_t(places_virtual)] = found_3;
                    }
                }
            }
        }
    }
}

static void list_there_2c6db734_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_2c6db734_wide_rows(call, rows); });
}

const glift::Binding list_there_2c6db734_bindings[] = {
    {.name = "from.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 88,
        .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "from.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 96,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::range},
    {.name = "counter.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write,
        .address_offset = 104, .element_bytes = sizeof(uint), .parameter = 3, .reach = glift::Reach::range,
        .combine = glift::Combine::coherent},
    {.name = "addresses.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 112,
        .element_bytes = sizeof(uint), .parameter = 4, .reach = glift::Reach::range},
    {.name = "values.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 120,
        .element_bytes = sizeof(float), .parameter = 6, .reach = glift::Reach::range},
    {.name = "translated.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 128, .element_bytes = sizeof(uint), .parameter = 2},
    {.name = "places.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 136,
        .element_bytes = sizeof(uint2), .parameter = 5, .reach = glift::Reach::range},
};
constexpr glift::Parameter list_there_2c6db734_parameters[] = {
    {"a_extent", 0, sizeof(list_there_2c6db734_direct_parameters::a_extent)},
    {"a_table_extent", 4, sizeof(list_there_2c6db734_direct_parameters::a_table_extent)},
    {"a_frames_extent", 8, sizeof(list_there_2c6db734_direct_parameters::a_frames_extent)},
    {"counter_extent_value_0", 16, sizeof(list_there_2c6db734_direct_parameters::counter_extent_value_0)},
    {"addresses_extent", 20, sizeof(list_there_2c6db734_direct_parameters::addresses_extent)},
    {"values_extent", 24, sizeof(list_there_2c6db734_direct_parameters::values_extent)},
    {"translated_extent", 28, sizeof(list_there_2c6db734_direct_parameters::translated_extent)},
    {"translated_table_extent", 32, sizeof(list_there_2c6db734_direct_parameters::translated_table_extent)},
    {"translated_frames_extent_y", 36, sizeof(list_there_2c6db734_direct_parameters::translated_frames_extent_y)},
    {"places_extent", 40, sizeof(list_there_2c6db734_direct_parameters::places_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel list_there_2c6db734_kernel;
const glift::Kernel list_there_2c6db734_kernel = {
    .name = "list_there",
    .file = "transfer.glift",
    .line = 32,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = list_there_2c6db734_bindings,
    .direct = {.host = &list_there_2c6db734_direct, .parameter_bytes = 44, .push_constants = true},
    .general = {.host = &list_there_2c6db734_general, .parameter_bytes = 76},
    .wide = {.host = &list_there_2c6db734_wide, .parameter_bytes = 144},
    .parameters = list_there_2c6db734_parameters,
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
// transfer.glift:15: read_box<Array<2, float, none, buffer>, Box<2, float>>

namespace {
struct read_box_f3d15695_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_f3d15695_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_f3d15695_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: runs kernel read_box<Array<2, float, none, buffer>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_f3d15695_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_f3d15695_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const uint to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:15
            const uint from_at = address.y * from_extent.x + address.x;
            const uint to_at = address.y * to_extent_x + address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_f3d15695_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_f3d15695_direct_rows(call, rows); });
}

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

// transfer.glift:15: runs kernel read_box<Array<2, float, none, buffer>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_f3d15695_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_f3d15695_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const uint to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
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
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_f3d15695_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_f3d15695_general_rows(call,
        rows); });
}

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

// transfer.glift:15: runs kernel read_box<Array<2, float, none, buffer>, Box<2, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_f3d15695_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_f3d15695_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
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

static void read_box_f3d15695_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_f3d15695_wide_rows(call, rows); });
}

const glift::Binding read_box_f3d15695_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 64,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_f3d15695_parameters[] = {
    {"from_extent", 0, sizeof(read_box_f3d15695_direct_parameters::from_extent)},
    {"to_extent_x", 8, sizeof(read_box_f3d15695_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_f3d15695_kernel;
const glift::Kernel read_box_f3d15695_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_f3d15695_bindings,
    .direct = {.host = &read_box_f3d15695_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &read_box_f3d15695_general, .parameter_bytes = 32},
    .wide = {.host = &read_box_f3d15695_wide, .parameter_bytes = 72, .base_offset = 24},
    .parameters = read_box_f3d15695_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<2, float>, Array<2, float, none, buffer>>

namespace {
struct write_box_d5801374_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(write_box_d5801374_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_d5801374_direct_parameters, to_extent_x) == 8);

// transfer.glift:20: runs kernel write_box<Box<2, float>, Array<2, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_d5801374_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_d5801374_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const uint to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:20
            const uint from_at = address.y * from_extent.x + address.x;
            const uint to_at = address.y * to_extent_x + address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_d5801374_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_d5801374_direct_rows(call,
        rows); });
}

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

// transfer.glift:20: runs kernel write_box<Box<2, float>, Array<2, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_d5801374_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_d5801374_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const uint to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
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
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_d5801374_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_d5801374_general_rows(call,
        rows); });
}

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

// transfer.glift:20: runs kernel write_box<Box<2, float>, Array<2, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_d5801374_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_d5801374_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
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

static void write_box_d5801374_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_d5801374_wide_rows(call, rows); });
}

const glift::Binding write_box_d5801374_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 64,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_d5801374_parameters[] = {
    {"from_extent", 0, sizeof(write_box_d5801374_direct_parameters::from_extent)},
    {"to_extent_x", 8, sizeof(write_box_d5801374_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_d5801374_kernel;
const glift::Kernel write_box_d5801374_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = write_box_d5801374_bindings,
    .direct = {.host = &write_box_d5801374_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &write_box_d5801374_general, .parameter_bytes = 32},
    .wide = {.host = &write_box_d5801374_wide, .parameter_bytes = 72, .base_offset = 24},
    .parameters = write_box_d5801374_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<2, float, none, buffer>, float>

namespace {
struct fill_box_902cb707_direct_parameters {
    uint2 to_extent;
    float value;
};
static_assert(offsetof(fill_box_902cb707_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_902cb707_direct_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<Array<2, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_902cb707_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_902cb707_direct_parameters*>(call.parameters);
    const uint2 to_extent = parameters.to_extent;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:25
            const uint to_at = address.y * to_extent.x + address.x;
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_902cb707_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_902cb707_direct_rows(call, rows); });
}

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

// transfer.glift:25: runs kernel fill_box<Array<2, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_902cb707_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_902cb707_general_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const uint to_extent_x = parameters.to_extent_x;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            // transfer.glift:25
            const uint to_at = to_address.y * to_extent_x + to_address.x;
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_902cb707_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_902cb707_general_rows(call,
        rows); });
}

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

// transfer.glift:25: runs kernel fill_box<Array<2, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_902cb707_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_902cb707_wide_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
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

static void fill_box_902cb707_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_902cb707_wide_rows(call, rows); });
}

const glift::Binding fill_box_902cb707_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter fill_box_902cb707_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_902cb707_direct_parameters::to_extent)},
    {"value", 8, sizeof(fill_box_902cb707_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_902cb707_kernel;
const glift::Kernel fill_box_902cb707_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = fill_box_902cb707_bindings,
    .direct = {.host = &fill_box_902cb707_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &fill_box_902cb707_general, .parameter_bytes = 24},
    .wide = {.host = &fill_box_902cb707_wide, .parameter_bytes = 56, .base_offset = 16},
    .parameters = fill_box_902cb707_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Same, Box<1, float>>

namespace {
struct read_box_a62f9606_direct_parameters {
    uint from_field_extent;
    uint from_field_table_extent;
    uint2 from_field_frames_extent;
};
static_assert(offsetof(read_box_a62f9606_direct_parameters, from_field_extent) == 0);
static_assert(offsetof(read_box_a62f9606_direct_parameters, from_field_table_extent) == 4);
static_assert(offsetof(read_box_a62f9606_direct_parameters, from_field_frames_extent) == 8);

// transfer.glift:15: runs kernel read_box<Same, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_a62f9606_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_a62f9606_direct_parameters*>(call.parameters);
    const uint from_field_extent = parameters.from_field_extent;
    const uint from_field_table_extent = parameters.from_field_table_extent;
    const uint2 from_field_frames_extent = parameters.from_field_frames_extent;
    const uint* from_field_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_field_frames_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            float* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // transfer.glift:15
                bool from_field_either = address >= from_field_extent;
                if (!from_field_either) {
                    const uint from_field_table_address = address / 16u;
                    const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                    const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                        ? from_field_table_address : 0u];
                    from_field_either = (from_field_table_value_inside ? from_field_table_value : 0u) == 0u;
                }
                uint2 from_field_result{};
                bool from_field_found{};
                if (from_field_either) {
                    from_field_result = uint2(0u);
                    from_field_found = false;
                } else {
                    const uint from_field_table_address = address / 16u;
                    const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                    const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                        ? from_field_table_address : 0u];
                    from_field_result = uint2(address % 16u,
                        (from_field_table_value_inside ? from_field_table_value : 0u) - 1u);
                    from_field_found = true;
                }
                const uint2 from_field_place = from_field_result;
                const uint from_at = from_field_place.y * from_field_frames_extent.x + from_field_place.x;
                const bool from_found = from_field_found && from_field_place.y < from_field_frames_extent.y;
                // transfer.glift:16
                const float from_value = from_field_frames_data[from_found ? from_at : 0u];
                to_data_row[i] = from_found ? from_value : -1.0f;
            }
        }
    }
}

static void read_box_a62f9606_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_a62f9606_direct_rows(call, rows); });
}

struct read_box_a62f9606_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint from_field_extent;
    uint from_field_table_extent;
    uint2 from_field_frames_extent;
};
static_assert(offsetof(read_box_a62f9606_general_parameters, size) == 0);
static_assert(offsetof(read_box_a62f9606_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_a62f9606_general_parameters, to_origin) == 8);
static_assert(offsetof(read_box_a62f9606_general_parameters, from_field_extent) == 12);
static_assert(offsetof(read_box_a62f9606_general_parameters, from_field_table_extent) == 16);
static_assert(offsetof(read_box_a62f9606_general_parameters, from_field_frames_extent) == 20);

// transfer.glift:15: runs kernel read_box<Same, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_a62f9606_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_a62f9606_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint from_field_extent = parameters.from_field_extent;
    const uint from_field_table_extent = parameters.from_field_table_extent;
    const uint2 from_field_frames_extent = parameters.from_field_frames_extent;
    const uint* from_field_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_field_frames_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:16
            const uint to_address = to_origin + address;
            float* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // transfer.glift:16
                const uint from_address = from_origin + address;
                // transfer.glift:15
                bool from_field_either = from_address >= from_field_extent;
                if (!from_field_either) {
                    const uint from_field_table_address = from_address / 16u;
                    const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                    const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                        ? from_field_table_address : 0u];
                    from_field_either = (from_field_table_value_inside ? from_field_table_value : 0u) == 0u;
                }
                uint2 from_field_result{};
                bool from_field_found{};
                if (from_field_either) {
                    from_field_result = uint2(0u);
                    from_field_found = false;
                } else {
                    const uint from_field_table_address = from_address / 16u;
                    const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                    const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                        ? from_field_table_address : 0u];
                    from_field_result = uint2(from_address % 16u,
                        (from_field_table_value_inside ? from_field_table_value : 0u) - 1u);
                    from_field_found = true;
                }
                const uint2 from_field_place = from_field_result;
                const uint from_at = from_field_place.y * from_field_frames_extent.x + from_field_place.x;
                const bool from_found = from_field_found && from_field_place.y < from_field_frames_extent.y;
                // transfer.glift:16
                const float from_value = from_field_frames_data[from_found ? from_at : 0u];
                to_data_row[i] = from_found ? from_value : -1.0f;
            }
        }
    }
}

static void read_box_a62f9606_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_a62f9606_general_rows(call,
        rows); });
}

struct read_box_a62f9606_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint from_field_extent;
    uint from_field_table_extent;
    std::uint64_t from_field_frames_extent_x;
    uint from_field_frames_extent_y;
    std::uint64_t from_field_table_data_address;
    std::uint64_t from_field_frames_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_a62f9606_wide_parameters, size) == 0);
static_assert(offsetof(read_box_a62f9606_wide_parameters, from_origin) == 4);
static_assert(offsetof(read_box_a62f9606_wide_parameters, to_origin) == 8);
static_assert(offsetof(read_box_a62f9606_wide_parameters, from_field_extent) == 12);
static_assert(offsetof(read_box_a62f9606_wide_parameters, from_field_table_extent) == 16);
static_assert(offsetof(read_box_a62f9606_wide_parameters, from_field_frames_extent_x) == 24);
static_assert(offsetof(read_box_a62f9606_wide_parameters, from_field_frames_extent_y) == 32);
static_assert(offsetof(read_box_a62f9606_wide_parameters, from_field_table_data_address) == 40);
static_assert(offsetof(read_box_a62f9606_wide_parameters, from_field_frames_data_address) == 48);
static_assert(offsetof(read_box_a62f9606_wide_parameters, to_data_address) == 56);

// transfer.glift:15: runs kernel read_box<Same, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_a62f9606_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_a62f9606_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint from_field_extent = parameters.from_field_extent;
    const uint from_field_table_extent = parameters.from_field_table_extent;
    const std::uint64_t from_field_frames_extent_x = parameters.from_field_frames_extent_x;
    const uint from_field_frames_extent_y = parameters.from_field_frames_extent_y;
    const uint* from_field_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_field_frames_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            // transfer.glift:15
            bool from_field_either = from_address >= from_field_extent;
            if (!from_field_either) {
                const uint from_field_table_address = from_address / 16u;
                const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                const std::uint64_t from_field_table_value_at = std::uint64_t(from_field_table_address);
                const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                    ? from_field_table_value_at : std::uint64_t{0u}];
                from_field_either = (from_field_table_value_inside ? from_field_table_value : 0u) == 0u;
            }
            uint2 from_field_result{};
            bool from_field_found{};
            if (from_field_either) {
                from_field_result = uint2(0u);
                from_field_found = false;
            } else {
                const uint from_field_table_address = from_address / 16u;
                const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                const std::uint64_t from_field_table_value_at = std::uint64_t(from_field_table_address);
                const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                    ? from_field_table_value_at : std::uint64_t{0u}];
                from_field_result = uint2(from_address % 16u,
                    (from_field_table_value_inside ? from_field_table_value : 0u) - 1u);
                from_field_found = true;
            }
            const uint2 from_field_place = from_field_result;
            const std::uint64_t from_at = std::uint64_t(from_field_place.y) * from_field_frames_extent_x
                + std::uint64_t(from_field_place.x);
            const bool from_found = from_field_found && from_field_place.y < from_field_frames_extent_y;
            // transfer.glift:16
            const uint to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:16
            const float from_value = from_field_frames_data[from_found ? from_at : std::uint64_t{0u}];
            to_data[to_at] = from_found ? from_value : -1.0f;
        }
    }
}

static void read_box_a62f9606_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_a62f9606_wide_rows(call, rows); });
}

const glift::Binding read_box_a62f9606_bindings[] = {
    {.name = "from.field.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 40, .element_bytes = sizeof(uint)},
    {.name = "from.field.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 48, .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 56,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_a62f9606_parameters[] = {
    {"from_field_extent", 0, sizeof(read_box_a62f9606_direct_parameters::from_field_extent)},
    {"from_field_table_extent", 4, sizeof(read_box_a62f9606_direct_parameters::from_field_table_extent)},
    {"from_field_frames_extent", 8, sizeof(read_box_a62f9606_direct_parameters::from_field_frames_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_a62f9606_kernel;
const glift::Kernel read_box_a62f9606_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_a62f9606_bindings,
    .direct = {.host = &read_box_a62f9606_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &read_box_a62f9606_general, .parameter_bytes = 28},
    .wide = {.host = &read_box_a62f9606_wide, .parameter_bytes = 64},
    .parameters = read_box_a62f9606_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, float>, Same>

namespace {
struct write_box_416982b9_direct_parameters {
    uint from_extent;
    uint to_field_extent;
    uint to_field_table_extent;
    uint2 to_field_frames_extent;
};
static_assert(offsetof(write_box_416982b9_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_416982b9_direct_parameters, to_field_extent) == 4);
static_assert(offsetof(write_box_416982b9_direct_parameters, to_field_table_extent) == 8);
static_assert(offsetof(write_box_416982b9_direct_parameters, to_field_frames_extent) == 12);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Same> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_416982b9_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_416982b9_direct_parameters*>(call.parameters);
    const uint to_field_extent = parameters.to_field_extent;
    const uint to_field_table_extent = parameters.to_field_table_extent;
    const uint2 to_field_frames_extent = parameters.to_field_frames_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_field_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_field_frames_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:20
            bool to_field_either = address >= to_field_extent;
            if (!to_field_either) {
                const uint to_field_table_address = address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_address : 0u];
                to_field_either = (to_field_table_value_inside ? to_field_table_value : 0u) == 0u;
            }
            uint2 to_field_result{};
            bool to_field_found{};
            if (to_field_either) {
                to_field_result = uint2(0u);
                to_field_found = false;
            } else {
                const uint to_field_table_address = address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_address : 0u];
                to_field_result = uint2(address % 16u, (to_field_table_value_inside ? to_field_table_value : 0u) - 1u);
                to_field_found = true;
            }
            const uint2 to_field_place = to_field_result;
            const uint to_at = to_field_place.y * to_field_frames_extent.x + to_field_place.x;
            const bool to_found = to_field_found && to_field_place.y < to_field_frames_extent.y;
            // transfer.glift:21
            if (to_found) {
                to_field_frames_data[to_at] = from_data[address];
            }
        }
    }
}

static void write_box_416982b9_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_416982b9_direct_rows(call,
        rows); });
}

struct write_box_416982b9_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint to_field_extent;
    uint to_field_table_extent;
    uint2 to_field_frames_extent;
};
static_assert(offsetof(write_box_416982b9_general_parameters, size) == 0);
static_assert(offsetof(write_box_416982b9_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_416982b9_general_parameters, to_origin) == 8);
static_assert(offsetof(write_box_416982b9_general_parameters, to_field_extent) == 12);
static_assert(offsetof(write_box_416982b9_general_parameters, to_field_table_extent) == 16);
static_assert(offsetof(write_box_416982b9_general_parameters, to_field_frames_extent) == 20);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Same> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_416982b9_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_416982b9_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint to_field_extent = parameters.to_field_extent;
    const uint to_field_table_extent = parameters.to_field_table_extent;
    const uint2 to_field_frames_extent = parameters.to_field_frames_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_field_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_field_frames_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:21
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            // transfer.glift:20
            bool to_field_either = to_address >= to_field_extent;
            if (!to_field_either) {
                const uint to_field_table_address = to_address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_address : 0u];
                to_field_either = (to_field_table_value_inside ? to_field_table_value : 0u) == 0u;
            }
            uint2 to_field_result{};
            bool to_field_found{};
            if (to_field_either) {
                to_field_result = uint2(0u);
                to_field_found = false;
            } else {
                const uint to_field_table_address = to_address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_address : 0u];
                to_field_result = uint2(to_address % 16u,
                    (to_field_table_value_inside ? to_field_table_value : 0u) - 1u);
                to_field_found = true;
            }
            const uint2 to_field_place = to_field_result;
            const uint to_at = to_field_place.y * to_field_frames_extent.x + to_field_place.x;
            const bool to_found = to_field_found && to_field_place.y < to_field_frames_extent.y;
            // transfer.glift:21
            if (to_found) {
                to_field_frames_data[to_at] = from_data[from_address];
            }
        }
    }
}

static void write_box_416982b9_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_416982b9_general_rows(call,
        rows); });
}

struct write_box_416982b9_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint to_field_extent;
    uint to_field_table_extent;
    std::uint64_t to_field_frames_extent_x;
    uint to_field_frames_extent_y;
    std::uint64_t from_data_address;
    std::uint64_t to_field_table_data_address;
    std::uint64_t to_field_frames_data_address;
};
static_assert(offsetof(write_box_416982b9_wide_parameters, size) == 0);
static_assert(offsetof(write_box_416982b9_wide_parameters, from_origin) == 4);
static_assert(offsetof(write_box_416982b9_wide_parameters, to_origin) == 8);
static_assert(offsetof(write_box_416982b9_wide_parameters, to_field_extent) == 12);
static_assert(offsetof(write_box_416982b9_wide_parameters, to_field_table_extent) == 16);
static_assert(offsetof(write_box_416982b9_wide_parameters, to_field_frames_extent_x) == 24);
static_assert(offsetof(write_box_416982b9_wide_parameters, to_field_frames_extent_y) == 32);
static_assert(offsetof(write_box_416982b9_wide_parameters, from_data_address) == 40);
static_assert(offsetof(write_box_416982b9_wide_parameters, to_field_table_data_address) == 48);
static_assert(offsetof(write_box_416982b9_wide_parameters, to_field_frames_data_address) == 56);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Same> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_416982b9_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_416982b9_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint to_field_extent = parameters.to_field_extent;
    const uint to_field_table_extent = parameters.to_field_table_extent;
    const std::uint64_t to_field_frames_extent_x = parameters.to_field_frames_extent_x;
    const uint to_field_frames_extent_y = parameters.to_field_frames_extent_y;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_field_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_field_frames_data = glift::host::elements<float>(call.memories[2]);
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
            bool to_field_either = to_address >= to_field_extent;
            if (!to_field_either) {
                const uint to_field_table_address = to_address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const std::uint64_t to_field_table_value_at = std::uint64_t(to_field_table_address);
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_value_at : std::uint64_t{0u}];
                to_field_either = (to_field_table_value_inside ? to_field_table_value : 0u) == 0u;
            }
            uint2 to_field_result{};
            bool to_field_found{};
            if (to_field_either) {
                to_field_result = uint2(0u);
                to_field_found = false;
            } else {
                const uint to_field_table_address = to_address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const std::uint64_t to_field_table_value_at = std::uint64_t(to_field_table_address);
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_value_at : std::uint64_t{0u}];
                to_field_result = uint2(to_address % 16u,
                    (to_field_table_value_inside ? to_field_table_value : 0u) - 1u);
                to_field_found = true;
            }
            const uint2 to_field_place = to_field_result;
            const std::uint64_t to_at = std::uint64_t(to_field_place.y) * to_field_frames_extent_x
                + std::uint64_t(to_field_place.x);
            const bool to_found = to_field_found && to_field_place.y < to_field_frames_extent_y;
            // transfer.glift:21
            if (to_found) {
                to_field_frames_data[to_at] = from_data[from_at];
            }
        }
    }
}

static void write_box_416982b9_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_416982b9_wide_rows(call, rows); });
}

const glift::Binding write_box_416982b9_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 40,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.field.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 48, .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "to.field.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write,
        .address_offset = 56, .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_416982b9_parameters[] = {
    {"from_extent", 0, sizeof(write_box_416982b9_direct_parameters::from_extent)},
    {"to_field_extent", 4, sizeof(write_box_416982b9_direct_parameters::to_field_extent)},
    {"to_field_table_extent", 8, sizeof(write_box_416982b9_direct_parameters::to_field_table_extent)},
    {"to_field_frames_extent", 12, sizeof(write_box_416982b9_direct_parameters::to_field_frames_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_416982b9_kernel;
const glift::Kernel write_box_416982b9_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_416982b9_bindings,
    .direct = {.host = &write_box_416982b9_direct, .parameter_bytes = 20, .push_constants = true},
    .general = {.host = &write_box_416982b9_general, .parameter_bytes = 28},
    .wide = {.host = &write_box_416982b9_wide, .parameter_bytes = 64},
    .parameters = write_box_416982b9_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Same, float>

namespace {
struct fill_box_shared_Same_float_direct_parameters {
    uint to_field_extent;
    uint to_field_table_extent;
    uint2 to_field_frames_extent;
    float value;
};
static_assert(offsetof(fill_box_shared_Same_float_direct_parameters, to_field_extent) == 0);
static_assert(offsetof(fill_box_shared_Same_float_direct_parameters, to_field_table_extent) == 4);
static_assert(offsetof(fill_box_shared_Same_float_direct_parameters, to_field_frames_extent) == 8);
static_assert(offsetof(fill_box_shared_Same_float_direct_parameters, value) == 16);

// transfer.glift:25: runs kernel fill_box<Same, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_shared_Same_float_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_shared_Same_float_direct_parameters*>(call.parameters);
    const uint to_field_extent = parameters.to_field_extent;
    const uint to_field_table_extent = parameters.to_field_table_extent;
    const uint2 to_field_frames_extent = parameters.to_field_frames_extent;
    const float value = parameters.value;
    const uint* to_field_table_data = glift::host::elements<const uint>(call.memories[0]);
    float* to_field_frames_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:25
            bool to_field_either = address >= to_field_extent;
            if (!to_field_either) {
                const uint to_field_table_address = address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_address : 0u];
                to_field_either = (to_field_table_value_inside ? to_field_table_value : 0u) == 0u;
            }
            uint2 to_field_result{};
            bool to_field_found{};
            if (to_field_either) {
                to_field_result = uint2(0u);
                to_field_found = false;
            } else {
                const uint to_field_table_address = address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_address : 0u];
                to_field_result = uint2(address % 16u, (to_field_table_value_inside ? to_field_table_value : 0u) - 1u);
                to_field_found = true;
            }
            const uint2 to_field_place = to_field_result;
            const uint to_at = to_field_place.y * to_field_frames_extent.x + to_field_place.x;
            const bool to_found = to_field_found && to_field_place.y < to_field_frames_extent.y;
            // transfer.glift:26
            if (to_found) {
                to_field_frames_data[to_at] = value;
            }
        }
    }
}

static void fill_box_shared_Same_float_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_shared_Same_float_direct_rows(call,
        rows); });
}

struct fill_box_shared_Same_float_general_parameters {
    uint size;
    uint to_origin;
    uint to_field_extent;
    uint to_field_table_extent;
    uint2 to_field_frames_extent;
    float value;
};
static_assert(offsetof(fill_box_shared_Same_float_general_parameters, size) == 0);
static_assert(offsetof(fill_box_shared_Same_float_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_shared_Same_float_general_parameters, to_field_extent) == 8);
static_assert(offsetof(fill_box_shared_Same_float_general_parameters, to_field_table_extent) == 12);
static_assert(offsetof(fill_box_shared_Same_float_general_parameters, to_field_frames_extent) == 16);
static_assert(offsetof(fill_box_shared_Same_float_general_parameters, value) == 24);

// transfer.glift:25: runs kernel fill_box<Same, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_shared_Same_float_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_shared_Same_float_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint to_field_extent = parameters.to_field_extent;
    const uint to_field_table_extent = parameters.to_field_table_extent;
    const uint2 to_field_frames_extent = parameters.to_field_frames_extent;
    const float value = parameters.value;
    const uint* to_field_table_data = glift::host::elements<const uint>(call.memories[0]);
    float* to_field_frames_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            // transfer.glift:25
            bool to_field_either = to_address >= to_field_extent;
            if (!to_field_either) {
                const uint to_field_table_address = to_address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_address : 0u];
                to_field_either = (to_field_table_value_inside ? to_field_table_value : 0u) == 0u;
            }
            uint2 to_field_result{};
            bool to_field_found{};
            if (to_field_either) {
                to_field_result = uint2(0u);
                to_field_found = false;
            } else {
                const uint to_field_table_address = to_address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_address : 0u];
                to_field_result = uint2(to_address % 16u,
                    (to_field_table_value_inside ? to_field_table_value : 0u) - 1u);
                to_field_found = true;
            }
            const uint2 to_field_place = to_field_result;
            const uint to_at = to_field_place.y * to_field_frames_extent.x + to_field_place.x;
            const bool to_found = to_field_found && to_field_place.y < to_field_frames_extent.y;
            // transfer.glift:26
            if (to_found) {
                to_field_frames_data[to_at] = value;
            }
        }
    }
}

static void fill_box_shared_Same_float_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_shared_Same_float_general_rows(call,
        rows); });
}

struct fill_box_shared_Same_float_wide_parameters {
    uint size;
    uint to_origin;
    uint to_field_extent;
    uint to_field_table_extent;
    std::uint64_t to_field_frames_extent_x;
    uint to_field_frames_extent_y;
    float value;
    std::uint64_t to_field_table_data_address;
    std::uint64_t to_field_frames_data_address;
};
static_assert(offsetof(fill_box_shared_Same_float_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_shared_Same_float_wide_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_shared_Same_float_wide_parameters, to_field_extent) == 8);
static_assert(offsetof(fill_box_shared_Same_float_wide_parameters, to_field_table_extent) == 12);
static_assert(offsetof(fill_box_shared_Same_float_wide_parameters, to_field_frames_extent_x) == 16);
static_assert(offsetof(fill_box_shared_Same_float_wide_parameters, to_field_frames_extent_y) == 24);
static_assert(offsetof(fill_box_shared_Same_float_wide_parameters, value) == 28);
static_assert(offsetof(fill_box_shared_Same_float_wide_parameters, to_field_table_data_address) == 32);
static_assert(offsetof(fill_box_shared_Same_float_wide_parameters, to_field_frames_data_address) == 40);

// transfer.glift:25: runs kernel fill_box<Same, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_shared_Same_float_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_shared_Same_float_wide_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint to_field_extent = parameters.to_field_extent;
    const uint to_field_table_extent = parameters.to_field_table_extent;
    const std::uint64_t to_field_frames_extent_x = parameters.to_field_frames_extent_x;
    const uint to_field_frames_extent_y = parameters.to_field_frames_extent_y;
    const float value = parameters.value;
    const uint* to_field_table_data = glift::host::elements<const uint>(call.memories[0]);
    float* to_field_frames_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            // transfer.glift:25
            bool to_field_either = to_address >= to_field_extent;
            if (!to_field_either) {
                const uint to_field_table_address = to_address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const std::uint64_t to_field_table_value_at = std::uint64_t(to_field_table_address);
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_value_at : std::uint64_t{0u}];
                to_field_either = (to_field_table_value_inside ? to_field_table_value : 0u) == 0u;
            }
            uint2 to_field_result{};
            bool to_field_found{};
            if (to_field_either) {
                to_field_result = uint2(0u);
                to_field_found = false;
            } else {
                const uint to_field_table_address = to_address / 16u;
                const bool to_field_table_value_inside = to_field_table_address < to_field_table_extent;
                const std::uint64_t to_field_table_value_at = std::uint64_t(to_field_table_address);
                const uint to_field_table_value = to_field_table_data[to_field_table_value_inside
                    ? to_field_table_value_at : std::uint64_t{0u}];
                to_field_result = uint2(to_address % 16u,
                    (to_field_table_value_inside ? to_field_table_value : 0u) - 1u);
                to_field_found = true;
            }
            const uint2 to_field_place = to_field_result;
            const std::uint64_t to_at = std::uint64_t(to_field_place.y) * to_field_frames_extent_x
                + std::uint64_t(to_field_place.x);
            const bool to_found = to_field_found && to_field_place.y < to_field_frames_extent_y;
            // transfer.glift:26
            if (to_found) {
                to_field_frames_data[to_at] = value;
            }
        }
    }
}

static void fill_box_shared_Same_float_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_shared_Same_float_wide_rows(call,
        rows); });
}

const glift::Binding fill_box_shared_Same_float_bindings[] = {
    {.name = "to.field.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 32, .element_bytes = sizeof(uint)},
    {.name = "to.field.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write,
        .address_offset = 40, .element_bytes = sizeof(float), .reach = glift::Reach::element},
};
constexpr glift::Parameter fill_box_shared_Same_float_parameters[] = {
    {"to_field_extent", 0, sizeof(fill_box_shared_Same_float_direct_parameters::to_field_extent)},
    {"to_field_table_extent", 4, sizeof(fill_box_shared_Same_float_direct_parameters::to_field_table_extent)},
    {"to_field_frames_extent", 8, sizeof(fill_box_shared_Same_float_direct_parameters::to_field_frames_extent)},
    {"value", 16, sizeof(fill_box_shared_Same_float_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_shared_Same_float_kernel;
const glift::Kernel fill_box_shared_Same_float_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_shared_Same_float_bindings,
    .direct = {.host = &fill_box_shared_Same_float_direct, .parameter_bytes = 20, .push_constants = true},
    .general = {.host = &fill_box_shared_Same_float_general, .parameter_bytes = 28},
    .wide = {.host = &fill_box_shared_Same_float_wide, .parameter_bytes = 48},
    .parameters = fill_box_shared_Same_float_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:32: list_there<Same, Paged, Box<1, uint>, Box<1, uint2>, Box<1, float>, Box<1, uint>>

namespace {
struct list_there_ac7b7783_direct_parameters {
    uint a_field_extent;
    uint a_field_table_extent;
    uint2 a_field_frames_extent;
    glift::Bool counter_extent_value_0;
    uint addresses_extent;
    uint values_extent;
    uint translated_extent;
    uint translated_table_extent;
    uint translated_frames_extent_y;
    uint places_extent;
};
static_assert(offsetof(list_there_ac7b7783_direct_parameters, a_field_extent) == 0);
static_assert(offsetof(list_there_ac7b7783_direct_parameters, a_field_table_extent) == 4);
static_assert(offsetof(list_there_ac7b7783_direct_parameters, a_field_frames_extent) == 8);
static_assert(offsetof(list_there_ac7b7783_direct_parameters, counter_extent_value_0) == 16);
static_assert(offsetof(list_there_ac7b7783_direct_parameters, addresses_extent) == 20);
static_assert(offsetof(list_there_ac7b7783_direct_parameters, values_extent) == 24);
static_assert(offsetof(list_there_ac7b7783_direct_parameters, translated_extent) == 28);
static_assert(offsetof(list_there_ac7b7783_direct_parameters, translated_table_extent) == 32);
static_assert(offsetof(list_there_ac7b7783_direct_parameters, translated_frames_extent_y) == 36);
static_assert(offsetof(list_there_ac7b7783_direct_parameters, places_extent) == 40);

// transfer.glift:32: runs kernel list_there<Same, Paged, Box<1, uint>, Box<1, uint2>, Box<1, float>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_ac7b7783_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_ac7b7783_direct_parameters*>(call.parameters);
    const uint a_field_extent = parameters.a_field_extent;
    const uint a_field_table_extent = parameters.a_field_table_extent;
    const uint2 a_field_frames_extent = parameters.a_field_frames_extent;
    const bool counter_extent_value_0 = parameters.counter_extent_value_0;
    const uint addresses_extent = parameters.addresses_extent;
    const uint values_extent = parameters.values_extent;
    const uint translated_extent = parameters.translated_extent;
    const uint translated_table_extent = parameters.translated_table_extent;
    const uint translated_frames_extent_y = parameters.translated_frames_extent_y;
    const uint places_extent = parameters.places_extent;
    const uint* from_field_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_field_frames_data = glift::host::elements<const float>(call.memories[1]);
    uint* counter_data = glift::host::elements<uint>(call.memories[2]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[3]);
    float* values_data = glift::host::elements<float>(call.memories[4]);
    const uint* translated_table_data = glift::host::elements<const uint>(call.memories[5]);
    uint2* places_data = glift::host::elements<uint2>(call.memories[6]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:36
            const bool test = address >= a_field_extent;
            bool from_field_either = test;
            if (!from_field_either) {
                const uint from_field_table_address = address / 16u;
                const bool from_field_table_value_inside = from_field_table_address < a_field_table_extent;
                const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                    ? from_field_table_address : 0u];
                from_field_either = (from_field_table_value_inside ? from_field_table_value : 0u) == 0u;
            }
            uint2 from_field_result{};
            bool from_field_found{};
            if (from_field_either) {
                from_field_result = uint2(0u);
                from_field_found = false;
            } else {
                const uint from_field_table_address = address / 16u;
                const bool from_field_table_value_inside = from_field_table_address < a_field_table_extent;
                const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                    ? from_field_table_address : 0u];
                from_field_result = uint2(address % 16u,
                    (from_field_table_value_inside ? from_field_table_value : 0u) - 1u);
                from_field_found = true;
            }
            const uint2 from_field_place = from_field_result;
            float result{};
            bool found{};
            if (from_field_found && from_field_place.y < a_field_frames_extent.y) {
                bool from_field_either_2 = test;
                if (!from_field_either_2) {
                    const uint from_field_table_address = address / 16u;
                    const bool from_field_table_value_inside = from_field_table_address < a_field_table_extent;
                    const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                        ? from_field_table_address : 0u];
                    from_field_either_2 = (from_field_table_value_inside ? from_field_table_value : 0u) == 0u;
                }
                uint2 from_field_result_2{};
                bool from_field_found_2{};
                if (from_field_either_2) {
                    from_field_result_2 = uint2(0u);
                    from_field_found_2 = false;
                } else {
                    const uint from_field_table_address = address / 16u;
                    const bool from_field_table_value_inside = from_field_table_address < a_field_table_extent;
                    const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                        ? from_field_table_address : 0u];
                    from_field_result_2 = uint2(address % 16u,
                        (from_field_table_value_inside ? from_field_table_value : 0u) - 1u);
                    from_field_found_2 = true;
                }
                const uint2 from_field_place_2 = from_field_result_2;
                const bool from_value_inside = from_field_found_2 && from_field_place_2.y < a_field_frames_extent.y;
                const uint from_value_at = from_field_place_2.y * a_field_frames_extent.x + from_field_place_2.x;
                const float from_value = from_field_frames_data[from_value_inside ? from_value_at : 0u];
                result = from_value_inside ? from_value : -1.0f;
                found = true;
            } else {
                result = 0.0f;
                found = false;
            }
            const float found_2 = result;
            const bool found_found = found;
            if (found_found) {
                // transfer.glift:37
                uint counter_before = 0u;
                if (counter_extent_value_0) {
                    counter_before = glift::host::memory::atomicAdd(counter_data[0u], 1u);
                }
                const uint entry = counter_before;
                // transfer.glift:38
                if (entry < addresses_extent) {
                    addresses_data[entry] = address;
                }
                // transfer.glift:39
                if (entry < values_extent) {
                    values_data[entry] = found_2;
                }
                // transfer.glift:40
                const bool test_2 = address >= translated_extent;
                bool translated_either = test_2;
                if (!translated_either) {
                    const uint translated_table_address = address / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_either = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result{};
                if (translated_either) {
                    translated_result = uint2(0u);
                } else {
                    const uint translated_table_address = address / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_result = uint2(address % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                }
                bool translated_either_2 = test_2;
                if (!translated_either_2) {
                    const uint translated_table_address = address / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_either_2 = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result_2{};
                bool translated_found{};
                if (translated_either_2) {
                    translated_result_2 = uint2(0u);
                    translated_found = false;
                } else {
                    const uint translated_table_address = address / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_result_2 = uint2(address % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                    translated_found = true;
                }
                const uint2 translated_place = translated_result_2;
                const uint2 found_3 = translated_result;
                const bool found_found_2 = translated_found && translated_place.y < translated_frames_extent_y;
                if (found_found_2) {
                    // transfer.glift:41
                    if (entry < places_extent) {
                        places_data[entry] = found_3;
                    }
                }
            }
        }
    }
}

static void list_there_ac7b7783_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_ac7b7783_direct_rows(call,
        rows); });
}

struct list_there_ac7b7783_general_parameters {
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
    uint from_field_extent;
    uint from_field_table_extent;
    uint2 from_field_frames_extent;
    uint translated_extent;
    uint translated_table_extent;
    uint translated_frames_extent_y;
};
static_assert(offsetof(list_there_ac7b7783_general_parameters, size) == 0);
static_assert(offsetof(list_there_ac7b7783_general_parameters, a_origin) == 4);
static_assert(offsetof(list_there_ac7b7783_general_parameters, from_origin) == 8);
static_assert(offsetof(list_there_ac7b7783_general_parameters, counter_origin) == 12);
static_assert(offsetof(list_there_ac7b7783_general_parameters, counter_size) == 16);
static_assert(offsetof(list_there_ac7b7783_general_parameters, addresses_origin) == 20);
static_assert(offsetof(list_there_ac7b7783_general_parameters, addresses_size) == 24);
static_assert(offsetof(list_there_ac7b7783_general_parameters, values_origin) == 28);
static_assert(offsetof(list_there_ac7b7783_general_parameters, values_size) == 32);
static_assert(offsetof(list_there_ac7b7783_general_parameters, translated_origin) == 36);
static_assert(offsetof(list_there_ac7b7783_general_parameters, places_origin) == 40);
static_assert(offsetof(list_there_ac7b7783_general_parameters, places_size) == 44);
static_assert(offsetof(list_there_ac7b7783_general_parameters, from_field_extent) == 48);
static_assert(offsetof(list_there_ac7b7783_general_parameters, from_field_table_extent) == 52);
static_assert(offsetof(list_there_ac7b7783_general_parameters, from_field_frames_extent) == 56);
static_assert(offsetof(list_there_ac7b7783_general_parameters, translated_extent) == 64);
static_assert(offsetof(list_there_ac7b7783_general_parameters, translated_table_extent) == 68);
static_assert(offsetof(list_there_ac7b7783_general_parameters, translated_frames_extent_y) == 72);

// transfer.glift:32: runs kernel list_there<Same, Paged, Box<1, uint>, Box<1, uint2>, Box<1, float>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_ac7b7783_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_ac7b7783_general_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint from_origin = parameters.from_origin;
    const uint counter_origin = parameters.counter_origin;
    const uint counter_size = parameters.counter_size;
    const uint addresses_origin = parameters.addresses_origin;
    const uint addresses_size = parameters.addresses_size;
    const uint values_origin = parameters.values_origin;
    const uint values_size = parameters.values_size;
    const uint translated_origin = parameters.translated_origin;
    const uint places_origin = parameters.places_origin;
    const uint places_size = parameters.places_size;
    const uint from_field_extent = parameters.from_field_extent;
    const uint from_field_table_extent = parameters.from_field_table_extent;
    const uint2 from_field_frames_extent = parameters.from_field_frames_extent;
    const uint translated_extent = parameters.translated_extent;
    const uint translated_table_extent = parameters.translated_table_extent;
    const uint translated_frames_extent_y = parameters.translated_frames_extent_y;
    const uint* from_field_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_field_frames_data = glift::host::elements<const float>(call.memories[1]);
    uint* counter_data = glift::host::elements<uint>(call.memories[2]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[3]);
    float* values_data = glift::host::elements<float>(call.memories[4]);
    const uint* translated_table_data = glift::host::elements<const uint>(call.memories[5]);
    uint2* places_data = glift::host::elements<uint2>(call.memories[6]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:36
            const uint a_address = a_origin + address;
            const uint from_virtual = from_origin + a_address;
            const bool test = from_virtual >= from_field_extent;
            bool from_field_either = test;
            if (!from_field_either) {
                const uint from_field_table_address = from_virtual / 16u;
                const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                    ? from_field_table_address : 0u];
                from_field_either = (from_field_table_value_inside ? from_field_table_value : 0u) == 0u;
            }
            uint2 from_field_result{};
            bool from_field_found{};
            if (from_field_either) {
                from_field_result = uint2(0u);
                from_field_found = false;
            } else {
                const uint from_field_table_address = from_virtual / 16u;
                const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                    ? from_field_table_address : 0u];
                from_field_result = uint2(from_virtual % 16u,
                    (from_field_table_value_inside ? from_field_table_value : 0u) - 1u);
                from_field_found = true;
            }
            const uint2 from_field_place = from_field_result;
            float result{};
            bool found{};
            if (from_field_found && from_field_place.y < from_field_frames_extent.y) {
                bool from_field_either_2 = test;
                if (!from_field_either_2) {
                    const uint from_field_table_address = from_virtual / 16u;
                    const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                    const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                        ? from_field_table_address : 0u];
                    from_field_either_2 = (from_field_table_value_inside ? from_field_table_value : 0u) == 0u;
                }
                uint2 from_field_result_2{};
                bool from_field_found_2{};
                if (from_field_either_2) {
                    from_field_result_2 = uint2(0u);
                    from_field_found_2 = false;
                } else {
                    const uint from_field_table_address = from_virtual / 16u;
                    const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                    const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                        ? from_field_table_address : 0u];
                    from_field_result_2 = uint2(from_virtual % 16u,
                        (from_field_table_value_inside ? from_field_table_value : 0u) - 1u);
                    from_field_found_2 = true;
                }
                const uint2 from_field_place_2 = from_field_result_2;
                const bool from_value_inside = from_field_found_2 && from_field_place_2.y < from_field_frames_extent.y;
                const uint from_value_at = from_field_place_2.y * from_field_frames_extent.x + from_field_place_2.x;
                const float from_value = from_field_frames_data[from_value_inside ? from_value_at : 0u];
                result = from_value_inside ? from_value : -1.0f;
                found = true;
            } else {
                result = 0.0f;
                found = false;
            }
            const float found_2 = result;
            const bool found_found = found;
            if (found_found) {
                // transfer.glift:37
                uint counter_before = 0u;
                if (0u < counter_size) {
                    counter_before = glift::host::memory::atomicAdd(counter_data[counter_origin], 1u);
                }
                const uint entry = counter_before;
                // transfer.glift:38
                const uint addresses_virtual = addresses_origin + entry;
                if (entry < addresses_size) {
                    addresses_data[addresses_virtual] = a_address;
                }
                // transfer.glift:39
                const uint values_virtual = values_origin + entry;
                if (entry < values_size) {
                    values_data[values_virtual] = found_2;
                }
                // transfer.glift:40
                const uint value = translated_origin + a_address;
                const bool test_2 = value >= translated_extent;
                bool translated_either = test_2;
                if (!translated_either) {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_either = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result{};
                if (translated_either) {
                    translated_result = uint2(0u);
                } else {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_result = uint2(value % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                }
                bool translated_either_2 = test_2;
                if (!translated_either_2) {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_either_2 = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result_2{};
                bool translated_found{};
                if (translated_either_2) {
                    translated_result_2 = uint2(0u);
                    translated_found = false;
                } else {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_address : 0u];
                    translated_result_2 = uint2(value % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                    translated_found = true;
                }
                const uint2 translated_place = translated_result_2;
                const uint2 found_3 = translated_result;
                const bool found_found_2 = translated_found && translated_place.y < translated_frames_extent_y;
                if (found_found_2) {
                    // transfer.glift:41
                    const uint places_virtual = places_origin + entry;
                    if (entry < places_size) {
                        places_data[places_virtual] = found_3;
                    }
                }
            }
        }
    }
}

static void list_there_ac7b7783_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_ac7b7783_general_rows(call,
        rows); });
}

struct list_there_ac7b7783_wide_parameters {
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
    uint from_field_extent;
    uint from_field_table_extent;
    uint from_field_frames_extent_y;
    std::uint64_t from_field_frames_extent_x;
    uint translated_extent;
    uint translated_table_extent;
    uint translated_frames_extent_y;
    std::uint64_t from_field_table_data_address;
    std::uint64_t from_field_frames_data_address;
    std::uint64_t counter_data_address;
    std::uint64_t addresses_data_address;
    std::uint64_t values_data_address;
    std::uint64_t translated_table_data_address;
    std::uint64_t places_data_address;
};
static_assert(offsetof(list_there_ac7b7783_wide_parameters, size) == 0);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, a_origin) == 4);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, from_origin) == 8);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, counter_origin) == 12);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, counter_size) == 16);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, addresses_origin) == 20);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, addresses_size) == 24);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, values_origin) == 28);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, values_size) == 32);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, translated_origin) == 36);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, places_origin) == 40);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, places_size) == 44);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, from_field_extent) == 48);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, from_field_table_extent) == 52);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, from_field_frames_extent_y) == 56);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, from_field_frames_extent_x) == 64);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, translated_extent) == 72);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, translated_table_extent) == 76);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, translated_frames_extent_y) == 80);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, from_field_table_data_address) == 88);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, from_field_frames_data_address) == 96);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, counter_data_address) == 104);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, addresses_data_address) == 112);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, values_data_address) == 120);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, translated_table_data_address) == 128);
static_assert(offsetof(list_there_ac7b7783_wide_parameters, places_data_address) == 136);

// transfer.glift:32: runs kernel list_there<Same, Paged, Box<1, uint>, Box<1, uint2>, Box<1, float>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_ac7b7783_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_ac7b7783_wide_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint from_origin = parameters.from_origin;
    const uint counter_origin = parameters.counter_origin;
    const uint counter_size = parameters.counter_size;
    const uint addresses_origin = parameters.addresses_origin;
    const uint addresses_size = parameters.addresses_size;
    const uint values_origin = parameters.values_origin;
    const uint values_size = parameters.values_size;
    const uint translated_origin = parameters.translated_origin;
    const uint places_origin = parameters.places_origin;
    const uint places_size = parameters.places_size;
    const uint from_field_extent = parameters.from_field_extent;
    const uint from_field_table_extent = parameters.from_field_table_extent;
    const uint from_field_frames_extent_y = parameters.from_field_frames_extent_y;
    const std::uint64_t from_field_frames_extent_x = parameters.from_field_frames_extent_x;
    const uint translated_extent = parameters.translated_extent;
    const uint translated_table_extent = parameters.translated_table_extent;
    const uint translated_frames_extent_y = parameters.translated_frames_extent_y;
    const uint* from_field_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_field_frames_data = glift::host::elements<const float>(call.memories[1]);
    uint* counter_data = glift::host::elements<uint>(call.memories[2]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[3]);
    float* values_data = glift::host::elements<float>(call.memories[4]);
    const uint* translated_table_data = glift::host::elements<const uint>(call.memories[5]);
    uint2* places_data = glift::host::elements<uint2>(call.memories[6]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:36
            const uint a_address = a_origin + address;
            const uint from_virtual = from_origin + a_address;
            const bool test = from_virtual >= from_field_extent;
            bool from_field_either = test;
            if (!from_field_either) {
                const uint from_field_table_address = from_virtual / 16u;
                const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                const std::uint64_t from_field_table_value_at = std::uint64_t(from_field_table_address);
                const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                    ? from_field_table_value_at : std::uint64_t{0u}];
                from_field_either = (from_field_table_value_inside ? from_field_table_value : 0u) == 0u;
            }
            uint2 from_field_result{};
            bool from_field_found{};
            if (from_field_either) {
                from_field_result = uint2(0u);
                from_field_found = false;
            } else {
                const uint from_field_table_address = from_virtual / 16u;
                const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                const std::uint64_t from_field_table_value_at = std::uint64_t(from_field_table_address);
                const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                    ? from_field_table_value_at : std::uint64_t{0u}];
                from_field_result = uint2(from_virtual % 16u,
                    (from_field_table_value_inside ? from_field_table_value : 0u) - 1u);
                from_field_found = true;
            }
            const uint2 from_field_place = from_field_result;
            float result{};
            bool found{};
            if (from_field_found && from_field_place.y < from_field_frames_extent_y) {
                bool from_field_either_2 = test;
                if (!from_field_either_2) {
                    const uint from_field_table_address = from_virtual / 16u;
                    const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                    const std::uint64_t from_field_table_value_at = std::uint64_t(from_field_table_address);
                    const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                        ? from_field_table_value_at : std::uint64_t{0u}];
                    from_field_either_2 = (from_field_table_value_inside ? from_field_table_value : 0u) == 0u;
                }
                uint2 from_field_result_2{};
                bool from_field_found_2{};
                if (from_field_either_2) {
                    from_field_result_2 = uint2(0u);
                    from_field_found_2 = false;
                } else {
                    const uint from_field_table_address = from_virtual / 16u;
                    const bool from_field_table_value_inside = from_field_table_address < from_field_table_extent;
                    const std::uint64_t from_field_table_value_at = std::uint64_t(from_field_table_address);
                    const uint from_field_table_value = from_field_table_data[from_field_table_value_inside
                        ? from_field_table_value_at : std::uint64_t{0u}];
                    from_field_result_2 = uint2(from_virtual % 16u,
                        (from_field_table_value_inside ? from_field_table_value : 0u) - 1u);
                    from_field_found_2 = true;
                }
                const uint2 from_field_place_2 = from_field_result_2;
                const bool from_value_inside = from_field_found_2 && from_field_place_2.y < from_field_frames_extent_y;
                const std::uint64_t from_value_at = std::uint64_t(from_field_place_2.y) * from_field_frames_extent_x
                    + std::uint64_t(from_field_place_2.x);
                const float from_value = from_field_frames_data[from_value_inside ? from_value_at : std::uint64_t{0u}];
                result = from_value_inside ? from_value : -1.0f;
                found = true;
            } else {
                result = 0.0f;
                found = false;
            }
            const float found_2 = result;
            const bool found_found = found;
            if (found_found) {
                // transfer.glift:37
                uint counter_before = 0u;
                if (0u < counter_size) {
                    counter_before = glift::host::memory::atomicAdd(counter_data[std::uint64_t(counter_origin)], 1u);
                }
                const uint entry = counter_before;
                // transfer.glift:38
                const uint addresses_virtual = addresses_origin + entry;
                if (entry < addresses_size) {
                    addresses_data[std::uint64_t(addresses_virtual)] = a_address;
                }
                // transfer.glift:39
                const uint values_virtual = values_origin + entry;
                if (entry < values_size) {
                    values_data[std::uint64_t(values_virtual)] = found_2;
                }
                // transfer.glift:40
                const uint value = translated_origin + a_address;
                const bool test_2 = value >= translated_extent;
                bool translated_either = test_2;
                if (!translated_either) {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const std::uint64_t translated_table_value_at = std::uint64_t(translated_table_address);
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_value_at : std::uint64_t{0u}];
                    translated_either = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result{};
                if (translated_either) {
                    translated_result = uint2(0u);
                } else {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const std::uint64_t translated_table_value_at = std::uint64_t(translated_table_address);
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_value_at : std::uint64_t{0u}];
                    translated_result = uint2(value % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                }
                bool translated_either_2 = test_2;
                if (!translated_either_2) {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const std::uint64_t translated_table_value_at = std::uint64_t(translated_table_address);
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_value_at : std::uint64_t{0u}];
                    translated_either_2 = (translated_table_value_inside ? translated_table_value : 0u) == 0u;
                }
                uint2 translated_result_2{};
                bool translated_found{};
                if (translated_either_2) {
                    translated_result_2 = uint2(0u);
                    translated_found = false;
                } else {
                    const uint translated_table_address = value / 16u;
                    const bool translated_table_value_inside = translated_table_address < translated_table_extent;
                    const std::uint64_t translated_table_value_at = std::uint64_t(translated_table_address);
                    const uint translated_table_value = translated_table_data[translated_table_value_inside
                        ? translated_table_value_at : std::uint64_t{0u}];
                    translated_result_2 = uint2(value % 16u,
                        (translated_table_value_inside ? translated_table_value : 0u) - 1u);
                    translated_found = true;
                }
                const uint2 translated_place = translated_result_2;
                const uint2 found_3 = translated_result;
                const bool found_found_2 = translated_found && translated_place.y < translated_frames_extent_y;
                if (found_found_2) {
                    // transfer.glift:41
                    const uint places_virtual = places_origin + entry;
                    if (entry < places_size) {
                        places_data[std::uint64_t(places_virtual)] = found_3;
                    }
                }
            }
        }
    }
}

static void list_there_ac7b7783_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_ac7b7783_wide_rows(call, rows); });
}

const glift::Binding list_there_ac7b7783_bindings[] = {
    {.name = "from.field.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 88, .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "from.field.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 96, .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::range},
    {.name = "counter.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write,
        .address_offset = 104, .element_bytes = sizeof(uint), .parameter = 3, .reach = glift::Reach::range,
        .combine = glift::Combine::coherent},
    {.name = "addresses.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 112,
        .element_bytes = sizeof(uint), .parameter = 4, .reach = glift::Reach::range},
    {.name = "values.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 120,
        .element_bytes = sizeof(float), .parameter = 6, .reach = glift::Reach::range},
    {.name = "translated.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 128, .element_bytes = sizeof(uint), .parameter = 2},
    {.name = "places.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 136,
        .element_bytes = sizeof(uint2), .parameter = 5, .reach = glift::Reach::range},
};
constexpr glift::Parameter list_there_ac7b7783_parameters[] = {
    {"a_field_extent", 0, sizeof(list_there_ac7b7783_direct_parameters::a_field_extent)},
    {"a_field_table_extent", 4, sizeof(list_there_ac7b7783_direct_parameters::a_field_table_extent)},
    {"a_field_frames_extent", 8, sizeof(list_there_ac7b7783_direct_parameters::a_field_frames_extent)},
    {"counter_extent_value_0", 16, sizeof(list_there_ac7b7783_direct_parameters::counter_extent_value_0)},
    {"addresses_extent", 20, sizeof(list_there_ac7b7783_direct_parameters::addresses_extent)},
    {"values_extent", 24, sizeof(list_there_ac7b7783_direct_parameters::values_extent)},
    {"translated_extent", 28, sizeof(list_there_ac7b7783_direct_parameters::translated_extent)},
    {"translated_table_extent", 32, sizeof(list_there_ac7b7783_direct_parameters::translated_table_extent)},
    {"translated_frames_extent_y", 36, sizeof(list_there_ac7b7783_direct_parameters::translated_frames_extent_y)},
    {"places_extent", 40, sizeof(list_there_ac7b7783_direct_parameters::places_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel list_there_ac7b7783_kernel;
const glift::Kernel list_there_ac7b7783_kernel = {
    .name = "list_there",
    .file = "transfer.glift",
    .line = 32,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = list_there_ac7b7783_bindings,
    .direct = {.host = &list_there_ac7b7783_direct, .parameter_bytes = 44, .push_constants = true},
    .general = {.host = &list_there_ac7b7783_general, .parameter_bytes = 76},
    .wide = {.host = &list_there_ac7b7783_wide, .parameter_bytes = 144},
    .parameters = list_there_ac7b7783_parameters,
};

}  // namespace std_transfer

