// Made by gliftc from devices.glift. Changes are lost when it is made again.
#include "devices.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace devices {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// devices.glift:8: on_any

namespace {
struct on_any_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_any_direct_parameters, to_extent) == 0);

// devices.glift:8: runs kernel on_any for the given rows.
GLIFT_HOST_KERNEL
static void on_any_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // devices.glift:9
                to_data_row[i] = 1u;
            }
        }
    }
}

static void on_any_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { on_any_direct_rows(call, rows); });
}

struct on_any_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_any_general_parameters, size) == 0);
static_assert(offsetof(on_any_general_parameters, to_origin) == 4);

// devices.glift:8: runs kernel on_any for the given rows.
GLIFT_HOST_KERNEL
static void on_any_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const on_any_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // devices.glift:9
            const uint to_address = to_origin + address;
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // devices.glift:9
                to_data_row[i] = 1u;
            }
        }
    }
}

static void on_any_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { on_any_general_rows(call, rows); });
}

struct on_any_wide_parameters {
    uint size;
    uint to_origin;
    std::uint64_t to_data_address;
};
static_assert(offsetof(on_any_wide_parameters, size) == 0);
static_assert(offsetof(on_any_wide_parameters, to_origin) == 4);
static_assert(offsetof(on_any_wide_parameters, to_data_address) == 8);

// devices.glift:8: runs kernel on_any for the given rows.
GLIFT_HOST_KERNEL
static void on_any_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const on_any_wide_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // devices.glift:9
            const uint to_address = to_origin + address;
            // devices.glift:8
            const std::uint64_t to_at = std::uint64_t(to_address);
            // devices.glift:9
            to_data[to_at] = 1u;
        }
    }
}

static void on_any_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { on_any_wide_rows(call, rows); });
}

const glift::Binding on_any_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter on_any_parameters[] = {
    {"to_extent", 0, sizeof(on_any_direct_parameters::to_extent)},
};
}  // namespace

extern const glift::Kernel on_any_kernel;
const glift::Kernel on_any_kernel = {
    .name = "on_any",
    .file = "devices.glift",
    .line = 8,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = on_any_bindings,
    .direct = {.host = &on_any_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &on_any_general, .parameter_bytes = 8},
    .wide = {.host = &on_any_wide, .parameter_bytes = 16},
    .parameters = on_any_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// devices.glift:12: on_host

namespace {
struct on_host_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_host_direct_parameters, to_extent) == 0);

// devices.glift:12: runs kernel on_host for the given rows.
GLIFT_HOST_KERNEL
static void on_host_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // devices.glift:13
                to_data_row[i] = 2u;
            }
        }
    }
}

static void on_host_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { on_host_direct_rows(call, rows); });
}

struct on_host_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_host_general_parameters, size) == 0);
static_assert(offsetof(on_host_general_parameters, to_origin) == 4);

// devices.glift:12: runs kernel on_host for the given rows.
GLIFT_HOST_KERNEL
static void on_host_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const on_host_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // devices.glift:13
            const uint to_address = to_origin + address;
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // devices.glift:13
                to_data_row[i] = 2u;
            }
        }
    }
}

static void on_host_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { on_host_general_rows(call, rows); });
}

struct on_host_wide_parameters {
    uint size;
    uint to_origin;
    std::uint64_t to_data_address;
};
static_assert(offsetof(on_host_wide_parameters, size) == 0);
static_assert(offsetof(on_host_wide_parameters, to_origin) == 4);
static_assert(offsetof(on_host_wide_parameters, to_data_address) == 8);

// devices.glift:12: runs kernel on_host for the given rows.
GLIFT_HOST_KERNEL
static void on_host_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const on_host_wide_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // devices.glift:13
            const uint to_address = to_origin + address;
            // devices.glift:12
            const std::uint64_t to_at = std::uint64_t(to_address);
            // devices.glift:13
            to_data[to_at] = 2u;
        }
    }
}

static void on_host_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { on_host_wide_rows(call, rows); });
}

const glift::Binding on_host_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter on_host_parameters[] = {
    {"to_extent", 0, sizeof(on_host_direct_parameters::to_extent)},
};
}  // namespace

extern const glift::Kernel on_host_kernel;
const glift::Kernel on_host_kernel = {
    .name = "on_host",
    .file = "devices.glift",
    .line = 12,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = on_host_bindings,
    .direct = {.host = &on_host_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &on_host_general, .parameter_bytes = 8},
    .wide = {.host = &on_host_wide, .parameter_bytes = 16},
    .parameters = on_host_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// devices.glift:16: on_gpu

namespace {
struct on_gpu_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_gpu_direct_parameters, to_extent) == 0);

struct on_gpu_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_gpu_general_parameters, size) == 0);
static_assert(offsetof(on_gpu_general_parameters, to_origin) == 4);

struct on_gpu_wide_parameters {
    uint size;
    uint to_origin;
    std::uint64_t to_data_address;
};
static_assert(offsetof(on_gpu_wide_parameters, size) == 0);
static_assert(offsetof(on_gpu_wide_parameters, to_origin) == 4);
static_assert(offsetof(on_gpu_wide_parameters, to_data_address) == 8);

const glift::Binding on_gpu_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter on_gpu_parameters[] = {
    {"to_extent", 0, sizeof(on_gpu_direct_parameters::to_extent)},
};
}  // namespace

extern const glift::Kernel on_gpu_kernel;
const glift::Kernel on_gpu_kernel = {
    .name = "on_gpu",
    .file = "devices.glift",
    .line = 16,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = on_gpu_bindings,
    .direct = {.parameter_bytes = 4, .push_constants = true},
    .general = {.parameter_bytes = 8},
    .wide = {.parameter_bytes = 16},
    .parameters = on_gpu_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// devices.glift:20: on_wide_subgroups

namespace {
struct on_wide_subgroups_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_wide_subgroups_direct_parameters, to_extent) == 0);

struct on_wide_subgroups_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_wide_subgroups_general_parameters, size) == 0);
static_assert(offsetof(on_wide_subgroups_general_parameters, to_origin) == 4);

struct on_wide_subgroups_wide_parameters {
    uint size;
    uint to_origin;
    std::uint64_t to_data_address;
};
static_assert(offsetof(on_wide_subgroups_wide_parameters, size) == 0);
static_assert(offsetof(on_wide_subgroups_wide_parameters, to_origin) == 4);
static_assert(offsetof(on_wide_subgroups_wide_parameters, to_data_address) == 8);

const glift::Binding on_wide_subgroups_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter on_wide_subgroups_parameters[] = {
    {"to_extent", 0, sizeof(on_wide_subgroups_direct_parameters::to_extent)},
};
}  // namespace

extern const glift::Kernel on_wide_subgroups_kernel;
const glift::Kernel on_wide_subgroups_kernel = {
    .name = "on_wide_subgroups",
    .file = "devices.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = on_wide_subgroups_bindings,
    .direct = {.parameter_bytes = 4, .push_constants = true},
    .general = {.parameter_bytes = 8},
    .wide = {.parameter_bytes = 16},
    .parameters = on_wide_subgroups_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// devices.glift:24: on_vulkan

namespace {
struct on_vulkan_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_vulkan_direct_parameters, to_extent) == 0);

struct on_vulkan_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_vulkan_general_parameters, size) == 0);
static_assert(offsetof(on_vulkan_general_parameters, to_origin) == 4);

struct on_vulkan_wide_parameters {
    uint size;
    uint to_origin;
    std::uint64_t to_data_address;
};
static_assert(offsetof(on_vulkan_wide_parameters, size) == 0);
static_assert(offsetof(on_vulkan_wide_parameters, to_origin) == 4);
static_assert(offsetof(on_vulkan_wide_parameters, to_data_address) == 8);

const glift::Binding on_vulkan_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter on_vulkan_parameters[] = {
    {"to_extent", 0, sizeof(on_vulkan_direct_parameters::to_extent)},
};
}  // namespace

extern const glift::Kernel on_vulkan_kernel;
const glift::Kernel on_vulkan_kernel = {
    .name = "on_vulkan",
    .file = "devices.glift",
    .line = 24,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = on_vulkan_bindings,
    .direct = {.parameter_bytes = 4, .push_constants = true},
    .general = {.parameter_bytes = 8},
    .wide = {.parameter_bytes = 16},
    .parameters = on_vulkan_parameters,
    .items = {2, 1, 1},
};

}  // namespace devices

