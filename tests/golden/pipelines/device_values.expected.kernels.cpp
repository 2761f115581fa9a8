// Made by gliftc from device_values.glift. Changes are lost when it is made again.
#include "device_values.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace device_values {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// device_values.glift:8: scale

namespace {
struct scale_direct_parameters {
    uint a_extent;
    uint by;
};
static_assert(offsetof(scale_direct_parameters, a_extent) == 0);
static_assert(offsetof(scale_direct_parameters, by) == 4);

// device_values.glift:8: runs kernel scale for the given rows.
GLIFT_HOST_KERNEL
static void scale_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const scale_direct_parameters*>(call.parameters);
    const uint by = parameters.by;
    uint* a_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* a_data_row = glift::host::row_pointer(a_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // device_values.glift:9
                const uint a_value = a_data_row[i];
                a_data_row[i] = a_value * by;
            }
        }
    }
}

static void scale_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { scale_direct_rows(call, rows); });
}

struct scale_general_parameters {
    uint size;
    uint a_origin;
    uint by;
};
static_assert(offsetof(scale_general_parameters, size) == 0);
static_assert(offsetof(scale_general_parameters, a_origin) == 4);
static_assert(offsetof(scale_general_parameters, by) == 8);

// device_values.glift:8: runs kernel scale for the given rows.
GLIFT_HOST_KERNEL
static void scale_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const scale_general_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint by = parameters.by;
    uint* a_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // device_values.glift:9
            const uint a_address = a_origin + address;
            uint* a_data_row = glift::host::row_pointer(a_data + a_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // device_values.glift:9
                const uint a_value = a_data_row[i];
                a_data_row[i] = a_value * by;
            }
        }
    }
}

static void scale_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { scale_general_rows(call, rows); });
}

struct scale_wide_parameters {
    uint size;
    uint a_origin;
    uint by;
    std::uint64_t a_data_address;
};
static_assert(offsetof(scale_wide_parameters, size) == 0);
static_assert(offsetof(scale_wide_parameters, a_origin) == 4);
static_assert(offsetof(scale_wide_parameters, by) == 8);
static_assert(offsetof(scale_wide_parameters, a_data_address) == 16);

// device_values.glift:8: runs kernel scale for the given rows.
GLIFT_HOST_KERNEL
static void scale_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const scale_wide_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint by = parameters.by;
    uint* a_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // device_values.glift:9
            const uint a_address = a_origin + address;
            // device_values.glift:8
            const std::uint64_t a_at = std::uint64_t(a_address);
            // device_values.glift:9
            const uint a_value = a_data[a_at];
            a_data[a_at] = a_value * by;
        }
    }
}

static void scale_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { scale_wide_rows(call, rows); });
}

const glift::Binding scale_bindings[] = {
    {.name = "a.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write, .address_offset = 16,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter scale_parameters[] = {
    {"a_extent", 0, sizeof(scale_direct_parameters::a_extent)},
    {"by", 4, sizeof(scale_direct_parameters::by)},
};
}  // namespace

extern const glift::Kernel scale_kernel;
const glift::Kernel scale_kernel = {
    .name = "scale",
    .file = "device_values.glift",
    .line = 8,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = scale_bindings,
    .direct = {.host = &scale_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &scale_general, .parameter_bytes = 12},
    .wide = {.host = &scale_wide, .parameter_bytes = 24},
    .parameters = scale_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// device_values.glift:14: value

namespace {
struct value_a0d1f05f_2_direct_parameters {
    uint element_index;
    uint element_2_index;
    uint result_extent;
    uint by;
};
static_assert(offsetof(value_a0d1f05f_2_direct_parameters, element_index) == 0);
static_assert(offsetof(value_a0d1f05f_2_direct_parameters, element_2_index) == 4);
static_assert(offsetof(value_a0d1f05f_2_direct_parameters, result_extent) == 8);
static_assert(offsetof(value_a0d1f05f_2_direct_parameters, by) == 12);

// device_values.glift:14: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_a0d1f05f_2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_a0d1f05f_2_direct_parameters*>(call.parameters);
    const uint element_index = parameters.element_index;
    const uint element_2_index = parameters.element_2_index;
    const uint by = parameters.by;
    const uint* element_data = glift::host::elements<const uint>(call.memories[0]);
    const uint* element_2_data = glift::host::elements<const uint>(call.memories[1]);
    uint* result_data = glift::host::elements<uint>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* result_data_row = glift::host::row_pointer(result_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint element = element_data[element_index];
                const uint element_2 = element_2_data[element_2_index];
                // device_values.glift:14
                result_data_row[i] = glift::min(element + element_2, by);
            }
        }
    }
}

static void value_a0d1f05f_2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_a0d1f05f_2_direct_rows(call, rows); });
}

struct value_a0d1f05f_2_general_parameters {
    uint size;
    uint element_index;
    uint element_2_index;
    uint result_origin;
    uint by;
};
static_assert(offsetof(value_a0d1f05f_2_general_parameters, size) == 0);
static_assert(offsetof(value_a0d1f05f_2_general_parameters, element_index) == 4);
static_assert(offsetof(value_a0d1f05f_2_general_parameters, element_2_index) == 8);
static_assert(offsetof(value_a0d1f05f_2_general_parameters, result_origin) == 12);
static_assert(offsetof(value_a0d1f05f_2_general_parameters, by) == 16);

// device_values.glift:14: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_a0d1f05f_2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_a0d1f05f_2_general_parameters*>(call.parameters);
    const uint element_index = parameters.element_index;
    const uint element_2_index = parameters.element_2_index;
    const uint result_origin = parameters.result_origin;
    const uint by = parameters.by;
    const uint* element_data = glift::host::elements<const uint>(call.memories[0]);
    const uint* element_2_data = glift::host::elements<const uint>(call.memories[1]);
    uint* result_data = glift::host::elements<uint>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // device_values.glift:14
            const uint result_address = result_origin + address;
            uint* result_data_row = glift::host::row_pointer(result_data + result_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint element = element_data[element_index];
                const uint element_2 = element_2_data[element_2_index];
                // device_values.glift:14
                result_data_row[i] = glift::min(element + element_2, by);
            }
        }
    }
}

static void value_a0d1f05f_2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_a0d1f05f_2_general_rows(call, rows); });
}

struct value_a0d1f05f_2_wide_parameters {
    uint size;
    uint element_index;
    uint element_2_index;
    uint result_origin;
    uint by;
    std::uint64_t element_data_address;
    std::uint64_t element_2_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, size) == 0);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, element_index) == 4);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, element_2_index) == 8);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, result_origin) == 12);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, by) == 16);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, element_data_address) == 24);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, element_2_data_address) == 32);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, result_data_address) == 40);

// device_values.glift:14: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_a0d1f05f_2_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_a0d1f05f_2_wide_parameters*>(call.parameters);
    const uint element_index = parameters.element_index;
    const uint element_2_index = parameters.element_2_index;
    const uint result_origin = parameters.result_origin;
    const uint by = parameters.by;
    const uint* element_data = glift::host::elements<const uint>(call.memories[0]);
    const uint* element_2_data = glift::host::elements<const uint>(call.memories[1]);
    uint* result_data = glift::host::elements<uint>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // device_values.glift:14
            const uint result_address = result_origin + address;
            const std::uint64_t result_at = std::uint64_t(result_address);
            const uint element = element_data[std::uint64_t(element_index)];
            const uint element_2 = element_2_data[std::uint64_t(element_2_index)];
            result_data[result_at] = glift::min(element + element_2, by);
        }
    }
}

static void value_a0d1f05f_2_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_a0d1f05f_2_wide_rows(call, rows); });
}

const glift::Binding value_a0d1f05f_2_bindings[] = {
    {.name = "element.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint), .reach = glift::Reach::memory},
    {.name = "element_2.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::memory},
    {.name = "result.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::element},
};
constexpr glift::Parameter value_a0d1f05f_2_parameters[] = {
    {"element_index", 0, sizeof(value_a0d1f05f_2_direct_parameters::element_index)},
    {"element_2_index", 4, sizeof(value_a0d1f05f_2_direct_parameters::element_2_index)},
    {"result_extent", 8, sizeof(value_a0d1f05f_2_direct_parameters::result_extent)},
    {"by", 12, sizeof(value_a0d1f05f_2_direct_parameters::by)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel value_a0d1f05f_2_kernel;
const glift::Kernel value_a0d1f05f_2_kernel = {
    .name = "value",
    .file = "device_values.glift",
    .line = 14,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = value_a0d1f05f_2_bindings,
    .direct = {.host = &value_a0d1f05f_2_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &value_a0d1f05f_2_general, .parameter_bytes = 20},
    .wide = {.host = &value_a0d1f05f_2_wide, .parameter_bytes = 48},
    .parameters = value_a0d1f05f_2_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// device_values.glift:16: value

namespace {
struct value_324e3ecf_2_direct_parameters {
    uint n_index;
    uint result_extent;
};
static_assert(offsetof(value_324e3ecf_2_direct_parameters, n_index) == 0);
static_assert(offsetof(value_324e3ecf_2_direct_parameters, result_extent) == 4);

// device_values.glift:16: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_324e3ecf_2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_324e3ecf_2_direct_parameters*>(call.parameters);
    const uint n_index = parameters.n_index;
    const uint* n_data = glift::host::elements<const uint>(call.memories[0]);
    glift::Bool* result_data = glift::host::elements<glift::Bool>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            glift::Bool* result_data_row = glift::host::row_pointer(result_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint n = n_data[n_index];
                // device_values.glift:16
                result_data_row[i] = n > 3u;
            }
        }
    }
}

static void value_324e3ecf_2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_324e3ecf_2_direct_rows(call, rows); });
}

struct value_324e3ecf_2_general_parameters {
    uint size;
    uint n_index;
    uint result_origin;
};
static_assert(offsetof(value_324e3ecf_2_general_parameters, size) == 0);
static_assert(offsetof(value_324e3ecf_2_general_parameters, n_index) == 4);
static_assert(offsetof(value_324e3ecf_2_general_parameters, result_origin) == 8);

// device_values.glift:16: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_324e3ecf_2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_324e3ecf_2_general_parameters*>(call.parameters);
    const uint n_index = parameters.n_index;
    const uint result_origin = parameters.result_origin;
    const uint* n_data = glift::host::elements<const uint>(call.memories[0]);
    glift::Bool* result_data = glift::host::elements<glift::Bool>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // device_values.glift:16
            const uint result_address = result_origin + address;
            glift::Bool* result_data_row = glift::host::row_pointer(result_data + result_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint n = n_data[n_index];
                // device_values.glift:16
                result_data_row[i] = n > 3u;
            }
        }
    }
}

static void value_324e3ecf_2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_324e3ecf_2_general_rows(call, rows); });
}

struct value_324e3ecf_2_wide_parameters {
    uint size;
    uint n_index;
    uint result_origin;
    std::uint64_t n_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_324e3ecf_2_wide_parameters, size) == 0);
static_assert(offsetof(value_324e3ecf_2_wide_parameters, n_index) == 4);
static_assert(offsetof(value_324e3ecf_2_wide_parameters, result_origin) == 8);
static_assert(offsetof(value_324e3ecf_2_wide_parameters, n_data_address) == 16);
static_assert(offsetof(value_324e3ecf_2_wide_parameters, result_data_address) == 24);

// device_values.glift:16: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_324e3ecf_2_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_324e3ecf_2_wide_parameters*>(call.parameters);
    const uint n_index = parameters.n_index;
    const uint result_origin = parameters.result_origin;
    const uint* n_data = glift::host::elements<const uint>(call.memories[0]);
    glift::Bool* result_data = glift::host::elements<glift::Bool>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // device_values.glift:16
            const uint result_address = result_origin + address;
            const std::uint64_t result_at = std::uint64_t(result_address);
            const uint n = n_data[std::uint64_t(n_index)];
            result_data[result_at] = n > 3u;
        }
    }
}

static void value_324e3ecf_2_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_324e3ecf_2_wide_rows(call, rows); });
}

const glift::Binding value_324e3ecf_2_bindings[] = {
    {.name = "n.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(uint), .reach = glift::Reach::memory},
    {.name = "result.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(glift::Bool), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter value_324e3ecf_2_parameters[] = {
    {"n_index", 0, sizeof(value_324e3ecf_2_direct_parameters::n_index)},
    {"result_extent", 4, sizeof(value_324e3ecf_2_direct_parameters::result_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel value_324e3ecf_2_kernel;
const glift::Kernel value_324e3ecf_2_kernel = {
    .name = "value",
    .file = "device_values.glift",
    .line = 16,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = value_324e3ecf_2_bindings,
    .direct = {.host = &value_324e3ecf_2_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &value_324e3ecf_2_general, .parameter_bytes = 12},
    .wide = {.host = &value_324e3ecf_2_wide, .parameter_bytes = 32},
    .parameters = value_324e3ecf_2_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// device_values.glift:8: scale

namespace {
struct scale_device_by_direct_parameters {
    uint by_index;
    uint a_extent;
};
static_assert(offsetof(scale_device_by_direct_parameters, by_index) == 0);
static_assert(offsetof(scale_device_by_direct_parameters, a_extent) == 4);

// device_values.glift:8: runs kernel scale for the given rows.
GLIFT_HOST_KERNEL
static void scale_device_by_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const scale_device_by_direct_parameters*>(call.parameters);
    const uint by_index = parameters.by_index;
    const uint* by_data = glift::host::elements<const uint>(call.memories[0]);
    uint* a_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* a_data_row = glift::host::row_pointer(a_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint by = by_data[by_index];
                // device_values.glift:9
                const uint a_value = a_data_row[i];
                a_data_row[i] = a_value * by;
            }
        }
    }
}

static void scale_device_by_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { scale_device_by_direct_rows(call, rows); });
}

struct scale_device_by_general_parameters {
    uint size;
    uint by_index;
    uint a_origin;
};
static_assert(offsetof(scale_device_by_general_parameters, size) == 0);
static_assert(offsetof(scale_device_by_general_parameters, by_index) == 4);
static_assert(offsetof(scale_device_by_general_parameters, a_origin) == 8);

// device_values.glift:8: runs kernel scale for the given rows.
GLIFT_HOST_KERNEL
static void scale_device_by_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const scale_device_by_general_parameters*>(call.parameters);
    const uint by_index = parameters.by_index;
    const uint a_origin = parameters.a_origin;
    const uint* by_data = glift::host::elements<const uint>(call.memories[0]);
    uint* a_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // device_values.glift:9
            const uint a_address = a_origin + address;
            uint* a_data_row = glift::host::row_pointer(a_data + a_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint by = by_data[by_index];
                // device_values.glift:9
                const uint a_value = a_data_row[i];
                a_data_row[i] = a_value * by;
            }
        }
    }
}

static void scale_device_by_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { scale_device_by_general_rows(call, rows); });
}

struct scale_device_by_wide_parameters {
    uint size;
    uint by_index;
    uint a_origin;
    std::uint64_t by_data_address;
    std::uint64_t a_data_address;
};
static_assert(offsetof(scale_device_by_wide_parameters, size) == 0);
static_assert(offsetof(scale_device_by_wide_parameters, by_index) == 4);
static_assert(offsetof(scale_device_by_wide_parameters, a_origin) == 8);
static_assert(offsetof(scale_device_by_wide_parameters, by_data_address) == 16);
static_assert(offsetof(scale_device_by_wide_parameters, a_data_address) == 24);

// device_values.glift:8: runs kernel scale for the given rows.
GLIFT_HOST_KERNEL
static void scale_device_by_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const scale_device_by_wide_parameters*>(call.parameters);
    const uint by_index = parameters.by_index;
    const uint a_origin = parameters.a_origin;
    const uint* by_data = glift::host::elements<const uint>(call.memories[0]);
    uint* a_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // device_values.glift:9
            const uint a_address = a_origin + address;
            // device_values.glift:8
            const std::uint64_t a_at = std::uint64_t(a_address);
            const uint by = by_data[std::uint64_t(by_index)];
            // device_values.glift:9
            const uint a_value = a_data[a_at];
            a_data[a_at] = a_value * by;
        }
    }
}

static void scale_device_by_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { scale_device_by_wide_rows(call, rows); });
}

const glift::Binding scale_device_by_bindings[] = {
    {.name = "by.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::memory},
    {.name = "a.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write, .address_offset = 24,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
};
constexpr glift::Parameter scale_device_by_parameters[] = {
    {"by_index", 0, sizeof(scale_device_by_direct_parameters::by_index)},
    {"a_extent", 4, sizeof(scale_device_by_direct_parameters::a_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel scale_device_by_kernel;
const glift::Kernel scale_device_by_kernel = {
    .name = "scale",
    .file = "device_values.glift",
    .line = 8,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = scale_device_by_bindings,
    .direct = {.host = &scale_device_by_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &scale_device_by_general, .parameter_bytes = 12},
    .wide = {.host = &scale_device_by_wide, .parameter_bytes = 32},
    .parameters = scale_device_by_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// device_values.glift:22: value

namespace {
struct value_true_2_direct_parameters {
    uint result_extent;
};
static_assert(offsetof(value_true_2_direct_parameters, result_extent) == 0);

// device_values.glift:22: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_true_2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    glift::Bool* result_data = glift::host::elements<glift::Bool>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            glift::Bool* result_data_row = glift::host::row_pointer(result_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // device_values.glift:22
                result_data_row[i] = true;
            }
        }
    }
}

static void value_true_2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_true_2_direct_rows(call, rows); });
}

struct value_true_2_general_parameters {
    uint size;
    uint result_origin;
};
static_assert(offsetof(value_true_2_general_parameters, size) == 0);
static_assert(offsetof(value_true_2_general_parameters, result_origin) == 4);

// device_values.glift:22: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_true_2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_true_2_general_parameters*>(call.parameters);
    const uint result_origin = parameters.result_origin;
    glift::Bool* result_data = glift::host::elements<glift::Bool>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // device_values.glift:22
            const uint result_address = result_origin + address;
            glift::Bool* result_data_row = glift::host::row_pointer(result_data + result_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // device_values.glift:22
                result_data_row[i] = true;
            }
        }
    }
}

static void value_true_2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_true_2_general_rows(call, rows); });
}

struct value_true_2_wide_parameters {
    uint size;
    uint result_origin;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_true_2_wide_parameters, size) == 0);
static_assert(offsetof(value_true_2_wide_parameters, result_origin) == 4);
static_assert(offsetof(value_true_2_wide_parameters, result_data_address) == 8);

// device_values.glift:22: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_true_2_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_true_2_wide_parameters*>(call.parameters);
    const uint result_origin = parameters.result_origin;
    glift::Bool* result_data = glift::host::elements<glift::Bool>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // device_values.glift:22
            const uint result_address = result_origin + address;
            const std::uint64_t result_at = std::uint64_t(result_address);
            result_data[result_at] = true;
        }
    }
}

static void value_true_2_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_true_2_wide_rows(call, rows); });
}

const glift::Binding value_true_2_bindings[] = {
    {.name = "result.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8,
        .element_bytes = sizeof(glift::Bool)},
};
constexpr glift::Parameter value_true_2_parameters[] = {
    {"result_extent", 0, sizeof(value_true_2_direct_parameters::result_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel value_true_2_kernel;
const glift::Kernel value_true_2_kernel = {
    .name = "value",
    .file = "device_values.glift",
    .line = 22,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = value_true_2_bindings,
    .direct = {.host = &value_true_2_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &value_true_2_general, .parameter_bytes = 8},
    .wide = {.host = &value_true_2_wide, .parameter_bytes = 16},
    .parameters = value_true_2_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// device_values.glift:15: value

namespace {
struct value_0u_2_direct_parameters {
    uint result_extent;
};
static_assert(offsetof(value_0u_2_direct_parameters, result_extent) == 0);

// device_values.glift:15: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_0u_2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    uint* result_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* result_data_row = glift::host::row_pointer(result_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // device_values.glift:15
                result_data_row[i] = 0u;
            }
        }
    }
}

static void value_0u_2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_0u_2_direct_rows(call, rows); });
}

struct value_0u_2_general_parameters {
    uint size;
    uint result_origin;
};
static_assert(offsetof(value_0u_2_general_parameters, size) == 0);
static_assert(offsetof(value_0u_2_general_parameters, result_origin) == 4);

// device_values.glift:15: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_0u_2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_0u_2_general_parameters*>(call.parameters);
    const uint result_origin = parameters.result_origin;
    uint* result_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // device_values.glift:15
            const uint result_address = result_origin + address;
            uint* result_data_row = glift::host::row_pointer(result_data + result_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // device_values.glift:15
                result_data_row[i] = 0u;
            }
        }
    }
}

static void value_0u_2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_0u_2_general_rows(call, rows); });
}

struct value_0u_2_wide_parameters {
    uint size;
    uint result_origin;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_0u_2_wide_parameters, size) == 0);
static_assert(offsetof(value_0u_2_wide_parameters, result_origin) == 4);
static_assert(offsetof(value_0u_2_wide_parameters, result_data_address) == 8);

// device_values.glift:15: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_0u_2_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_0u_2_wide_parameters*>(call.parameters);
    const uint result_origin = parameters.result_origin;
    uint* result_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // device_values.glift:15
            const uint result_address = result_origin + address;
            const std::uint64_t result_at = std::uint64_t(result_address);
            result_data[result_at] = 0u;
        }
    }
}

static void value_0u_2_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_0u_2_wide_rows(call, rows); });
}

const glift::Binding value_0u_2_bindings[] = {
    {.name = "result.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter value_0u_2_parameters[] = {
    {"result_extent", 0, sizeof(value_0u_2_direct_parameters::result_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel value_0u_2_kernel;
const glift::Kernel value_0u_2_kernel = {
    .name = "value",
    .file = "device_values.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = value_0u_2_bindings,
    .direct = {.host = &value_0u_2_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &value_0u_2_general, .parameter_bytes = 8},
    .wide = {.host = &value_0u_2_wide, .parameter_bytes = 16},
    .parameters = value_0u_2_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// device_values.glift:18: value

namespace {
struct value_53ad928e_2_direct_parameters {
    uint condition_index;
    uint times_index;
    uint result_extent;
};
static_assert(offsetof(value_53ad928e_2_direct_parameters, condition_index) == 0);
static_assert(offsetof(value_53ad928e_2_direct_parameters, times_index) == 4);
static_assert(offsetof(value_53ad928e_2_direct_parameters, result_extent) == 8);

// device_values.glift:18: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_53ad928e_2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_53ad928e_2_direct_parameters*>(call.parameters);
    const uint condition_index = parameters.condition_index;
    const uint times_index = parameters.times_index;
    const glift::Bool* condition_data = glift::host::elements<const glift::Bool>(call.memories[0]);
    const uint* times_data = glift::host::elements<const uint>(call.memories[1]);
    uint* result_data = glift::host::elements<uint>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* result_data_row = glift::host::row_pointer(result_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const bool condition = condition_data[condition_index];
                const uint times = times_data[times_index];
                // device_values.glift:18
                result_data_row[i] = condition ? 1u : times;
            }
        }
    }
}

static void value_53ad928e_2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_53ad928e_2_direct_rows(call, rows); });
}

struct value_53ad928e_2_general_parameters {
    uint size;
    uint condition_index;
    uint times_index;
    uint result_origin;
};
static_assert(offsetof(value_53ad928e_2_general_parameters, size) == 0);
static_assert(offsetof(value_53ad928e_2_general_parameters, condition_index) == 4);
static_assert(offsetof(value_53ad928e_2_general_parameters, times_index) == 8);
static_assert(offsetof(value_53ad928e_2_general_parameters, result_origin) == 12);

// device_values.glift:18: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_53ad928e_2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_53ad928e_2_general_parameters*>(call.parameters);
    const uint condition_index = parameters.condition_index;
    const uint times_index = parameters.times_index;
    const uint result_origin = parameters.result_origin;
    const glift::Bool* condition_data = glift::host::elements<const glift::Bool>(call.memories[0]);
    const uint* times_data = glift::host::elements<const uint>(call.memories[1]);
    uint* result_data = glift::host::elements<uint>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // device_values.glift:18
            const uint result_address = result_origin + address;
            uint* result_data_row = glift::host::row_pointer(result_data + result_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const bool condition = condition_data[condition_index];
                const uint times = times_data[times_index];
                // device_values.glift:18
                result_data_row[i] = condition ? 1u : times;
            }
        }
    }
}

static void value_53ad928e_2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_53ad928e_2_general_rows(call, rows); });
}

struct value_53ad928e_2_wide_parameters {
    uint size;
    uint condition_index;
    uint times_index;
    uint result_origin;
    std::uint64_t condition_data_address;
    std::uint64_t times_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_53ad928e_2_wide_parameters, size) == 0);
static_assert(offsetof(value_53ad928e_2_wide_parameters, condition_index) == 4);
static_assert(offsetof(value_53ad928e_2_wide_parameters, times_index) == 8);
static_assert(offsetof(value_53ad928e_2_wide_parameters, result_origin) == 12);
static_assert(offsetof(value_53ad928e_2_wide_parameters, condition_data_address) == 16);
static_assert(offsetof(value_53ad928e_2_wide_parameters, times_data_address) == 24);
static_assert(offsetof(value_53ad928e_2_wide_parameters, result_data_address) == 32);

// device_values.glift:18: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_53ad928e_2_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_53ad928e_2_wide_parameters*>(call.parameters);
    const uint condition_index = parameters.condition_index;
    const uint times_index = parameters.times_index;
    const uint result_origin = parameters.result_origin;
    const glift::Bool* condition_data = glift::host::elements<const glift::Bool>(call.memories[0]);
    const uint* times_data = glift::host::elements<const uint>(call.memories[1]);
    uint* result_data = glift::host::elements<uint>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // device_values.glift:18
            const uint result_address = result_origin + address;
            const std::uint64_t result_at = std::uint64_t(result_address);
            const bool condition = condition_data[std::uint64_t(condition_index)];
            const uint times = times_data[std::uint64_t(times_index)];
            result_data[result_at] = condition ? 1u : times;
        }
    }
}

static void value_53ad928e_2_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_53ad928e_2_wide_rows(call, rows); });
}

const glift::Binding value_53ad928e_2_bindings[] = {
    {.name = "condition.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(glift::Bool), .reach = glift::Reach::memory},
    {.name = "times.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::memory},
    {.name = "result.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::element},
};
constexpr glift::Parameter value_53ad928e_2_parameters[] = {
    {"condition_index", 0, sizeof(value_53ad928e_2_direct_parameters::condition_index)},
    {"times_index", 4, sizeof(value_53ad928e_2_direct_parameters::times_index)},
    {"result_extent", 8, sizeof(value_53ad928e_2_direct_parameters::result_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel value_53ad928e_2_kernel;
const glift::Kernel value_53ad928e_2_kernel = {
    .name = "value",
    .file = "device_values.glift",
    .line = 18,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = value_53ad928e_2_bindings,
    .direct = {.host = &value_53ad928e_2_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &value_53ad928e_2_general, .parameter_bytes = 16},
    .wide = {.host = &value_53ad928e_2_wide, .parameter_bytes = 40},
    .parameters = value_53ad928e_2_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// device_values.glift:22: value

namespace {
struct value_b207683c_2_direct_parameters {
    uint running_index;
    uint element_index;
    uint times_index;
    uint result_extent;
};
static_assert(offsetof(value_b207683c_2_direct_parameters, running_index) == 0);
static_assert(offsetof(value_b207683c_2_direct_parameters, element_index) == 4);
static_assert(offsetof(value_b207683c_2_direct_parameters, times_index) == 8);
static_assert(offsetof(value_b207683c_2_direct_parameters, result_extent) == 12);

// device_values.glift:22: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_b207683c_2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_b207683c_2_direct_parameters*>(call.parameters);
    const uint running_index = parameters.running_index;
    const uint element_index = parameters.element_index;
    const uint times_index = parameters.times_index;
    const glift::Bool* running_data = glift::host::elements<const glift::Bool>(call.memories[0]);
    const uint* element_data = glift::host::elements<const uint>(call.memories[1]);
    const uint* times_data = glift::host::elements<const uint>(call.memories[2]);
    glift::Bool* result_data = glift::host::elements<glift::Bool>(call.memories[3]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            glift::Bool* result_data_row = glift::host::row_pointer(result_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const bool running = running_data[running_index];
                const uint element = element_data[element_index];
                const uint times = times_data[times_index];
                // device_values.glift:22
                result_data_row[i] = running && element > times;
            }
        }
    }
}

static void value_b207683c_2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_b207683c_2_direct_rows(call, rows); });
}

struct value_b207683c_2_general_parameters {
    uint size;
    uint running_index;
    uint element_index;
    uint times_index;
    uint result_origin;
};
static_assert(offsetof(value_b207683c_2_general_parameters, size) == 0);
static_assert(offsetof(value_b207683c_2_general_parameters, running_index) == 4);
static_assert(offsetof(value_b207683c_2_general_parameters, element_index) == 8);
static_assert(offsetof(value_b207683c_2_general_parameters, times_index) == 12);
static_assert(offsetof(value_b207683c_2_general_parameters, result_origin) == 16);

// device_values.glift:22: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_b207683c_2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_b207683c_2_general_parameters*>(call.parameters);
    const uint running_index = parameters.running_index;
    const uint element_index = parameters.element_index;
    const uint times_index = parameters.times_index;
    const uint result_origin = parameters.result_origin;
    const glift::Bool* running_data = glift::host::elements<const glift::Bool>(call.memories[0]);
    const uint* element_data = glift::host::elements<const uint>(call.memories[1]);
    const uint* times_data = glift::host::elements<const uint>(call.memories[2]);
    glift::Bool* result_data = glift::host::elements<glift::Bool>(call.memories[3]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // device_values.glift:22
            const uint result_address = result_origin + address;
            glift::Bool* result_data_row = glift::host::row_pointer(result_data + result_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const bool running = running_data[running_index];
                const uint element = element_data[element_index];
                const uint times = times_data[times_index];
                // device_values.glift:22
                result_data_row[i] = running && element > times;
            }
        }
    }
}

static void value_b207683c_2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_b207683c_2_general_rows(call, rows); });
}

struct value_b207683c_2_wide_parameters {
    uint size;
    uint running_index;
    uint element_index;
    uint times_index;
    uint result_origin;
    std::uint64_t running_data_address;
    std::uint64_t element_data_address;
    std::uint64_t times_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_b207683c_2_wide_parameters, size) == 0);
static_assert(offsetof(value_b207683c_2_wide_parameters, running_index) == 4);
static_assert(offsetof(value_b207683c_2_wide_parameters, element_index) == 8);
static_assert(offsetof(value_b207683c_2_wide_parameters, times_index) == 12);
static_assert(offsetof(value_b207683c_2_wide_parameters, result_origin) == 16);
static_assert(offsetof(value_b207683c_2_wide_parameters, running_data_address) == 24);
static_assert(offsetof(value_b207683c_2_wide_parameters, element_data_address) == 32);
static_assert(offsetof(value_b207683c_2_wide_parameters, times_data_address) == 40);
static_assert(offsetof(value_b207683c_2_wide_parameters, result_data_address) == 48);

// device_values.glift:22: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_b207683c_2_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_b207683c_2_wide_parameters*>(call.parameters);
    const uint running_index = parameters.running_index;
    const uint element_index = parameters.element_index;
    const uint times_index = parameters.times_index;
    const uint result_origin = parameters.result_origin;
    const glift::Bool* running_data = glift::host::elements<const glift::Bool>(call.memories[0]);
    const uint* element_data = glift::host::elements<const uint>(call.memories[1]);
    const uint* times_data = glift::host::elements<const uint>(call.memories[2]);
    glift::Bool* result_data = glift::host::elements<glift::Bool>(call.memories[3]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // device_values.glift:22
            const uint result_address = result_origin + address;
            const std::uint64_t result_at = std::uint64_t(result_address);
            const bool running = running_data[std::uint64_t(running_index)];
            const uint element = element_data[std::uint64_t(element_index)];
            const uint times = times_data[std::uint64_t(times_index)];
            result_data[result_at] = running && element > times;
        }
    }
}

static void value_b207683c_2_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_b207683c_2_wide_rows(call, rows); });
}

const glift::Binding value_b207683c_2_bindings[] = {
    {.name = "running.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(glift::Bool), .reach = glift::Reach::memory},
    {.name = "element.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::memory},
    {.name = "times.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 40,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::memory},
    {.name = "result.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(glift::Bool), .parameter = 3, .reach = glift::Reach::element},
};
constexpr glift::Parameter value_b207683c_2_parameters[] = {
    {"running_index", 0, sizeof(value_b207683c_2_direct_parameters::running_index)},
    {"element_index", 4, sizeof(value_b207683c_2_direct_parameters::element_index)},
    {"times_index", 8, sizeof(value_b207683c_2_direct_parameters::times_index)},
    {"result_extent", 12, sizeof(value_b207683c_2_direct_parameters::result_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel value_b207683c_2_kernel;
const glift::Kernel value_b207683c_2_kernel = {
    .name = "value",
    .file = "device_values.glift",
    .line = 22,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = value_b207683c_2_bindings,
    .direct = {.host = &value_b207683c_2_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &value_b207683c_2_general, .parameter_bytes = 20},
    .wide = {.host = &value_b207683c_2_wide, .parameter_bytes = 56},
    .parameters = value_b207683c_2_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// device_values.glift:24: value

namespace {
struct value_7992094a_2_direct_parameters {
    uint running_index;
    uint times_index;
    uint result_extent;
};
static_assert(offsetof(value_7992094a_2_direct_parameters, running_index) == 0);
static_assert(offsetof(value_7992094a_2_direct_parameters, times_index) == 4);
static_assert(offsetof(value_7992094a_2_direct_parameters, result_extent) == 8);

// device_values.glift:24: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_7992094a_2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_7992094a_2_direct_parameters*>(call.parameters);
    const uint running_index = parameters.running_index;
    const uint times_index = parameters.times_index;
    const glift::Bool* running_data = glift::host::elements<const glift::Bool>(call.memories[0]);
    const uint* times_data = glift::host::elements<const uint>(call.memories[1]);
    uint* result_data = glift::host::elements<uint>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* result_data_row = glift::host::row_pointer(result_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const bool running = running_data[running_index];
                const uint times = times_data[times_index];
                // device_values.glift:24
                result_data_row[i] = times + (running ? 1u : 0u);
            }
        }
    }
}

static void value_7992094a_2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_7992094a_2_direct_rows(call, rows); });
}

struct value_7992094a_2_general_parameters {
    uint size;
    uint running_index;
    uint times_index;
    uint result_origin;
};
static_assert(offsetof(value_7992094a_2_general_parameters, size) == 0);
static_assert(offsetof(value_7992094a_2_general_parameters, running_index) == 4);
static_assert(offsetof(value_7992094a_2_general_parameters, times_index) == 8);
static_assert(offsetof(value_7992094a_2_general_parameters, result_origin) == 12);

// device_values.glift:24: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_7992094a_2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_7992094a_2_general_parameters*>(call.parameters);
    const uint running_index = parameters.running_index;
    const uint times_index = parameters.times_index;
    const uint result_origin = parameters.result_origin;
    const glift::Bool* running_data = glift::host::elements<const glift::Bool>(call.memories[0]);
    const uint* times_data = glift::host::elements<const uint>(call.memories[1]);
    uint* result_data = glift::host::elements<uint>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // device_values.glift:24
            const uint result_address = result_origin + address;
            uint* result_data_row = glift::host::row_pointer(result_data + result_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const bool running = running_data[running_index];
                const uint times = times_data[times_index];
                // device_values.glift:24
                result_data_row[i] = times + (running ? 1u : 0u);
            }
        }
    }
}

static void value_7992094a_2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_7992094a_2_general_rows(call, rows); });
}

struct value_7992094a_2_wide_parameters {
    uint size;
    uint running_index;
    uint times_index;
    uint result_origin;
    std::uint64_t running_data_address;
    std::uint64_t times_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_7992094a_2_wide_parameters, size) == 0);
static_assert(offsetof(value_7992094a_2_wide_parameters, running_index) == 4);
static_assert(offsetof(value_7992094a_2_wide_parameters, times_index) == 8);
static_assert(offsetof(value_7992094a_2_wide_parameters, result_origin) == 12);
static_assert(offsetof(value_7992094a_2_wide_parameters, running_data_address) == 16);
static_assert(offsetof(value_7992094a_2_wide_parameters, times_data_address) == 24);
static_assert(offsetof(value_7992094a_2_wide_parameters, result_data_address) == 32);

// device_values.glift:24: runs kernel value for the given rows.
GLIFT_HOST_KERNEL
static void value_7992094a_2_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const value_7992094a_2_wide_parameters*>(call.parameters);
    const uint running_index = parameters.running_index;
    const uint times_index = parameters.times_index;
    const uint result_origin = parameters.result_origin;
    const glift::Bool* running_data = glift::host::elements<const glift::Bool>(call.memories[0]);
    const uint* times_data = glift::host::elements<const uint>(call.memories[1]);
    uint* result_data = glift::host::elements<uint>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // device_values.glift:24
            const uint result_address = result_origin + address;
            const std::uint64_t result_at = std::uint64_t(result_address);
            const bool running = running_data[std::uint64_t(running_index)];
            const uint times = times_data[std::uint64_t(times_index)];
            result_data[result_at] = times + (running ? 1u : 0u);
        }
    }
}

static void value_7992094a_2_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { value_7992094a_2_wide_rows(call, rows); });
}

const glift::Binding value_7992094a_2_bindings[] = {
    {.name = "running.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(glift::Bool), .reach = glift::Reach::memory},
    {.name = "times.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::memory},
    {.name = "result.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::element},
};
constexpr glift::Parameter value_7992094a_2_parameters[] = {
    {"running_index", 0, sizeof(value_7992094a_2_direct_parameters::running_index)},
    {"times_index", 4, sizeof(value_7992094a_2_direct_parameters::times_index)},
    {"result_extent", 8, sizeof(value_7992094a_2_direct_parameters::result_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel value_7992094a_2_kernel;
const glift::Kernel value_7992094a_2_kernel = {
    .name = "value",
    .file = "device_values.glift",
    .line = 24,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = value_7992094a_2_bindings,
    .direct = {.host = &value_7992094a_2_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &value_7992094a_2_general, .parameter_bytes = 16},
    .wide = {.host = &value_7992094a_2_wide, .parameter_bytes = 40},
    .parameters = value_7992094a_2_parameters,
    .items = {2, 1, 1},
};

}  // namespace device_values

