// Made by gliftc from shared.glift. Changes are lost when it is made again.
#include "shared.glift.types.hpp"

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

// transfer.glift:15: read_box<Paged, Box<1, float>>, some rows.
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

// transfer.glift:15: read_box<Paged, Box<1, float>>, some rows.
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

// transfer.glift:15: read_box<Paged, Box<1, float>>, some rows.
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

// transfer.glift:20: write_box<Box<1, float>, Paged>, some rows.
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

// transfer.glift:20: write_box<Box<1, float>, Paged>, some rows.
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

// transfer.glift:20: write_box<Box<1, float>, Paged>, some rows.
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

// transfer.glift:25: fill_box<Paged, float>, some rows.
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

// transfer.glift:25: fill_box<Paged, float>, some rows.
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

// transfer.glift:25: fill_box<Paged, float>, some rows.
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

// transfer.glift:15: read_box<Same, Box<1, float>>, some rows.
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

// transfer.glift:15: read_box<Same, Box<1, float>>, some rows.
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

// transfer.glift:15: read_box<Same, Box<1, float>>, some rows.
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

// transfer.glift:20: write_box<Box<1, float>, Same>, some rows.
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

// transfer.glift:20: write_box<Box<1, float>, Same>, some rows.
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

// transfer.glift:20: write_box<Box<1, float>, Same>, some rows.
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

// transfer.glift:25: fill_box<Same, float>, some rows.
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

// transfer.glift:25: fill_box<Same, float>, some rows.
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

// transfer.glift:25: fill_box<Same, float>, some rows.
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
// transfer.glift:15: read_box<Array<2, float, none, buffer>, Box<2, float>>

namespace {
struct read_box_f3d15695_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_f3d15695_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_f3d15695_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: read_box<Array<2, float, none, buffer>, Box<2, float>>, some rows.
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

// transfer.glift:15: read_box<Array<2, float, none, buffer>, Box<2, float>>, some rows.
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

// transfer.glift:15: read_box<Array<2, float, none, buffer>, Box<2, float>>, some rows.
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

// transfer.glift:20: write_box<Box<2, float>, Array<2, float, none, buffer>>, some rows.
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

// transfer.glift:20: write_box<Box<2, float>, Array<2, float, none, buffer>>, some rows.
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

// transfer.glift:20: write_box<Box<2, float>, Array<2, float, none, buffer>>, some rows.
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

// transfer.glift:25: fill_box<Array<2, float, none, buffer>, float>, some rows.
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

// transfer.glift:25: fill_box<Array<2, float, none, buffer>, float>, some rows.
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

// transfer.glift:25: fill_box<Array<2, float, none, buffer>, float>, some rows.
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

}  // namespace std_transfer

