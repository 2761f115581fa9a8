// Made by gliftc from steps.glift. Changes are lost when it is made again.
#include "steps.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace steps {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// steps.glift:8: ramp

namespace {
struct ramp_direct_parameters {
    uint a_extent;
};
static_assert(offsetof(ramp_direct_parameters, a_extent) == 0);

// steps.glift:8: runs kernel ramp for the given rows.
GLIFT_HOST_KERNEL
static void ramp_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    float* f_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            float* f_data_row = glift::host::row_pointer(f_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // steps.glift:8
                f_data_row[i] = float(address);
            }
        }
    }
}

static void ramp_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { ramp_direct_rows(call, rows); });
}

struct ramp_general_parameters {
    uint size;
    uint a_origin;
    uint f_origin;
};
static_assert(offsetof(ramp_general_parameters, size) == 0);
static_assert(offsetof(ramp_general_parameters, a_origin) == 4);
static_assert(offsetof(ramp_general_parameters, f_origin) == 8);

// steps.glift:8: runs kernel ramp for the given rows.
GLIFT_HOST_KERNEL
static void ramp_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const ramp_general_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint f_origin = parameters.f_origin;
    float* f_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // steps.glift:8
            const uint f_address = f_origin + address;
            float* f_data_row = glift::host::row_pointer(f_data + f_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // steps.glift:8
                const uint a_address = a_origin + address;
                f_data_row[i] = float(a_address);
            }
        }
    }
}

static void ramp_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { ramp_general_rows(call, rows); });
}

struct ramp_wide_parameters {
    uint size;
    uint a_origin;
    uint f_origin;
    std::uint64_t f_data_address;
};
static_assert(offsetof(ramp_wide_parameters, size) == 0);
static_assert(offsetof(ramp_wide_parameters, a_origin) == 4);
static_assert(offsetof(ramp_wide_parameters, f_origin) == 8);
static_assert(offsetof(ramp_wide_parameters, f_data_address) == 16);

// steps.glift:8: runs kernel ramp for the given rows.
GLIFT_HOST_KERNEL
static void ramp_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const ramp_wide_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint f_origin = parameters.f_origin;
    float* f_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // steps.glift:8
            const uint a_address = a_origin + address;
            const uint f_address = f_origin + address;
            const std::uint64_t f_at = std::uint64_t(f_address);
            f_data[f_at] = float(a_address);
        }
    }
}

static void ramp_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { ramp_wide_rows(call, rows); });
}

const glift::Binding ramp_bindings[] = {
    {.name = "f.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 16,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter ramp_parameters[] = {
    {"a_extent", 0, sizeof(ramp_direct_parameters::a_extent)},
};
}  // namespace

extern const glift::Kernel ramp_kernel;
const glift::Kernel ramp_kernel = {
    .name = "ramp",
    .file = "steps.glift",
    .line = 8,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = ramp_bindings,
    .direct = {.host = &ramp_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &ramp_general, .parameter_bytes = 12},
    .wide = {.host = &ramp_wide, .parameter_bytes = 24},
    .parameters = ramp_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// steps.glift:9: smooth

namespace {
struct smooth_direct_parameters {
    uint f_extent;
};
static_assert(offsetof(smooth_direct_parameters, f_extent) == 0);

// steps.glift:9: runs kernel smooth for the given rows.
GLIFT_HOST_KERNEL
static void smooth_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const smooth_direct_parameters*>(call.parameters);
    const uint f_extent = parameters.f_extent;
    const float* f_data = glift::host::elements<const float>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        const glift::host::Part interior = glift::host::in_blocks(glift::host::interior_of(row, 0u, f_extent, 1),
            row.end);
        for (const glift::host::Section& part : glift::host::sections(row.begin, interior, row.end)) {
            if (part.is_middle) {
                // Interior: all neighbours of these elements are in the domain.
                if (part.begin < part.end) {
                    const uint address = part.begin;
                    const float* f_data_row = glift::host::row_pointer(f_data + (address - 1u));
                    const float* f_data_row_2 = glift::host::row_pointer(f_data + address);
                    const float* f_data_row_3 = glift::host::row_pointer(f_data + (address + 1u));
                    float* g_data_row = glift::host::row_pointer(g_data + address);
                    const std::size_t count = part.end - part.begin;
                    for (std::size_t block = 0; block < count; block += glift::host::block_elements) {
                        const std::size_t first = glift::host::begin_of_block(block, count);
                        GLIFT_BLOCK
                        for (std::size_t lane = 0; lane < glift::host::block_elements; ++lane) {
                            const std::size_t i = first + lane;
                            // steps.glift:9
                            g_data_row[i] = 0.25f * (f_data_row[i] + 2.0f * f_data_row_2[i] + f_data_row_3[i]);
                        }
                    }
                }
            } else {
                // Elsewhere: neighbours may be outside the domain.
                if (part.begin < part.end) {
                    const uint address = part.begin;
                    const float* f_data_row = glift::host::row_pointer(f_data + address);
                    float* g_data_row = glift::host::row_pointer(g_data + address);
                    GLIFT_INDEPENDENT
                    for (std::size_t i = 0, count = part.end - part.begin; i < count; ++i) {
                        const uint address = part.begin + static_cast<uint>(i);
                        // steps.glift:9
                        const bool f_xm1_inside = address >= 1u;
                        const float f_xm1 = f_data[address - (f_xm1_inside ? 1u : 0u)];
                        const uint f_xp1_at = address + 1u;
                        const bool f_xp1_inside = f_xp1_at < f_extent;
                        const float f_xp1 = f_data[f_xp1_inside ? f_xp1_at : address];
                        g_data_row[i] = 0.25f * ((f_xm1_inside ? f_xm1 : 0.0f) + 2.0f * f_data_row[i]
                            + (f_xp1_inside ? f_xp1 : 0.0f));
                    }
                }
            }
        }
    }
}

static void smooth_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { smooth_direct_rows(call, rows); });
}

struct smooth_general_parameters {
    uint size;
    uint f_origin;
    uint g_origin;
    uint f_extent;
};
static_assert(offsetof(smooth_general_parameters, size) == 0);
static_assert(offsetof(smooth_general_parameters, f_origin) == 4);
static_assert(offsetof(smooth_general_parameters, g_origin) == 8);
static_assert(offsetof(smooth_general_parameters, f_extent) == 12);

// steps.glift:9: runs kernel smooth for the given rows.
GLIFT_HOST_KERNEL
static void smooth_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const smooth_general_parameters*>(call.parameters);
    const uint f_origin = parameters.f_origin;
    const uint g_origin = parameters.g_origin;
    const uint f_extent = parameters.f_extent;
    const float* f_data = glift::host::elements<const float>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        const glift::host::Part interior = glift::host::in_blocks(glift::host::interior_of(row, f_origin, f_extent, 1),
            row.end);
        for (const glift::host::Section& part : glift::host::sections(row.begin, interior, row.end)) {
            if (part.is_middle) {
                // Interior: all neighbours of these elements are in the domain.
                if (part.begin < part.end) {
                    const uint address = part.begin;
                    // steps.glift:9
                    const uint f_address = f_origin + address;
                    const uint g_address = g_origin + address;
                    const float* f_data_row = glift::host::row_pointer(f_data + (f_address - 1u));
                    const float* f_data_row_2 = glift::host::row_pointer(f_data + f_address);
                    const float* f_data_row_3 = glift::host::row_pointer(f_data + (f_address + 1u));
                    float* g_data_row = glift::host::row_pointer(g_data + g_address);
                    const std::size_t count = part.end - part.begin;
                    for (std::size_t block = 0; block < count; block += glift::host::block_elements) {
                        const std::size_t first = glift::host::begin_of_block(block, count);
                        GLIFT_BLOCK
                        for (std::size_t lane = 0; lane < glift::host::block_elements; ++lane) {
                            const std::size_t i = first + lane;
                            // steps.glift:9
                            g_data_row[i] = 0.25f * (f_data_row[i] + 2.0f * f_data_row_2[i] + f_data_row_3[i]);
                        }
                    }
                }
            } else {
                // Elsewhere: neighbours may be outside the domain.
                if (part.begin < part.end) {
                    const uint address = part.begin;
                    // steps.glift:9
                    const uint f_address = f_origin + address;
                    const uint g_address = g_origin + address;
                    const float* f_data_row = glift::host::row_pointer(f_data + f_address);
                    float* g_data_row = glift::host::row_pointer(g_data + g_address);
                    GLIFT_INDEPENDENT
                    for (std::size_t i = 0, count = part.end - part.begin; i < count; ++i) {
                        const uint address = part.begin + static_cast<uint>(i);
                        // steps.glift:9
                        const uint f_address_2 = f_origin + address;
                        const bool f_xm1_inside = f_address_2 >= 1u;
                        const float f_xm1 = f_data[f_address_2 - (f_xm1_inside ? 1u : 0u)];
                        const uint f_xp1_at = f_address_2 + 1u;
                        const bool f_xp1_inside = f_xp1_at < f_extent;
                        const float f_xp1 = f_data[f_xp1_inside ? f_xp1_at : f_address_2];
                        g_data_row[i] = 0.25f * ((f_xm1_inside ? f_xm1 : 0.0f) + 2.0f * f_data_row[i]
                            + (f_xp1_inside ? f_xp1 : 0.0f));
                    }
                }
            }
        }
    }
}

static void smooth_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { smooth_general_rows(call, rows); });
}

struct smooth_wide_parameters {
    uint size;
    uint f_origin;
    uint g_origin;
    uint f_extent;
    std::uint64_t f_data_address;
    std::uint64_t g_data_address;
};
static_assert(offsetof(smooth_wide_parameters, size) == 0);
static_assert(offsetof(smooth_wide_parameters, f_origin) == 4);
static_assert(offsetof(smooth_wide_parameters, g_origin) == 8);
static_assert(offsetof(smooth_wide_parameters, f_extent) == 12);
static_assert(offsetof(smooth_wide_parameters, f_data_address) == 16);
static_assert(offsetof(smooth_wide_parameters, g_data_address) == 24);

// steps.glift:9: runs kernel smooth for the given rows.
GLIFT_HOST_KERNEL
static void smooth_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const smooth_wide_parameters*>(call.parameters);
    const uint f_origin = parameters.f_origin;
    const uint g_origin = parameters.g_origin;
    const uint f_extent = parameters.f_extent;
    const float* f_data = glift::host::elements<const float>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // steps.glift:9
            const uint f_address = f_origin + address;
            const std::uint64_t f_at = std::uint64_t(f_address);
            const uint g_address = g_origin + address;
            const std::uint64_t g_at = std::uint64_t(g_address);
            const bool f_xm1_inside = f_address >= 1u;
            const std::uint64_t f_xm1_at = std::uint64_t(f_address - 1u);
            const float f_xm1 = f_data[f_xm1_inside ? f_xm1_at : f_at];
            const uint value = f_address + 1u;
            const bool f_xp1_inside = value < f_extent;
            const std::uint64_t f_xp1_at = std::uint64_t(value);
            const float f_xp1 = f_data[f_xp1_inside ? f_xp1_at : f_at];
            g_data[g_at] = 0.25f * ((f_xm1_inside ? f_xm1 : 0.0f) + 2.0f * f_data[f_at]
                + (f_xp1_inside ? f_xp1 : 0.0f));
        }
    }
}

static void smooth_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { smooth_wide_rows(call, rows); });
}

const glift::Binding smooth_bindings[] = {
    {.name = "f.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(float), .reach = glift::Reach::window, .radius = 1},
    {.name = "g.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter smooth_parameters[] = {
    {"f_extent", 0, sizeof(smooth_direct_parameters::f_extent)},
};
}  // namespace

extern const glift::Kernel smooth_kernel;
const glift::Kernel smooth_kernel = {
    .name = "smooth",
    .file = "steps.glift",
    .line = 9,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = smooth_bindings,
    .direct = {.host = &smooth_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &smooth_general, .parameter_bytes = 16},
    .wide = {.host = &smooth_wide, .parameter_bytes = 32},
    .parameters = smooth_parameters,
    .items = {2, 1, 1},
};

}  // namespace steps

