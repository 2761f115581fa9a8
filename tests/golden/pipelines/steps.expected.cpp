// Made by gliftc from steps.glift. Changes are lost when it is made again.
#include "steps.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace steps {

using namespace glift::types;

namespace {

/// Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_1_float : public glift::Structure<Box_1_float, uint, float> {
public:
    static constexpr const char* type_name = "Box<1, float>";

    Box_1_float() = default;
    [[maybe_unused]] Box_1_float(const glift::Commands& commands, uint extent);
    /// Over parts that exist already.
    [[maybe_unused]] Box_1_float(const glift::Commands& commands, uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    [[maybe_unused]] uint domain() const;
    uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    uint data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    [[maybe_unused]] bool same_state(const Box_1_float& other) const;

private:
    uint extent_{};
    uint data_extent_{};
    glift::Memory data_;
};

// address.glift:17: volume<1>
inline uint volume(uint extent) {
    // address.glift:18
    uint product = extent;
    // address.glift:19
    for (uint axis = 1u; axis < 1u; ++axis) {
        // address.glift:20
        product *= extent;
    }
    // address.glift:22
    return product;
}

// address.glift:26: linearize<1>
inline uint linearize(uint address, uint extent) {
    // address.glift:27
    uint index = address;
    // address.glift:28
    for (uint back = 1u; back < 1u; ++back) {
        // address.glift:29
        index = index * extent + address;
    }
    // address.glift:31
    return index;
}

// ----------------------------------------------------------------------------------------------------
// steps.glift:8: ramp

struct ramp_direct_parameters {
    uint a_extent;
};
static_assert(offsetof(ramp_direct_parameters, a_extent) == 0);

// steps.glift:8: ramp, some rows.
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

// steps.glift:8: ramp, some rows.
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

const glift::Binding ramp_bindings[] = {
    {.name = "f.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 16},
};
constexpr glift::Parameter ramp_parameters[] = {
    {"a_extent", 0, sizeof(ramp_direct_parameters::a_extent)},
};
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
    .wide = {},
    .parameters = ramp_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// steps.glift:9: smooth

struct smooth_direct_parameters {
    uint f_extent;
};
static_assert(offsetof(smooth_direct_parameters, f_extent) == 0);

// steps.glift:9: smooth, some rows.
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
                // All neighbours exist.
                if (part.begin < part.end) {
                    const uint address = part.begin;
                    const float* f_data_row = glift::host::row_pointer(f_data + (address - 1u));
                    const float* f_data_row_2 = glift::host::row_pointer(f_data + address);
                    const float* f_data_row_3 = glift::host::row_pointer(f_data + (address + 1u));
                    float* g_data_row = glift::host::row_pointer(g_data + address);
                    const std::size_t count = part.end - part.begin;
                    for (std::size_t block = 0; block < count; block += glift::host::block_elements) {
                        const std::size_t first = std::min(block, count - glift::host::block_elements);
                        GLIFT_BLOCK
                        for (std::size_t lane = 0; lane < glift::host::block_elements; ++lane) {
                            const std::size_t i = first + lane;
                            // steps.glift:9
                            g_data_row[i] = 0.25f * (f_data_row[i] + 2.0f * f_data_row_2[i] + f_data_row_3[i]);
                        }
                    }
                }
            } else {
                // Near the sides of the domain.
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

// steps.glift:9: smooth, some rows.
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
                // All neighbours exist.
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
                        const std::size_t first = std::min(block, count - glift::host::block_elements);
                        GLIFT_BLOCK
                        for (std::size_t lane = 0; lane < glift::host::block_elements; ++lane) {
                            const std::size_t i = first + lane;
                            // steps.glift:9
                            g_data_row[i] = 0.25f * (f_data_row[i] + 2.0f * f_data_row_2[i] + f_data_row_3[i]);
                        }
                    }
                }
            } else {
                // Near the sides of the domain.
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

const glift::Binding smooth_bindings[] = {
    {.name = "f.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .reach = glift::Reach::window, .radius = 1},
    {.name = "g.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter smooth_parameters[] = {
    {"f_extent", 0, sizeof(smooth_direct_parameters::f_extent)},
};
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
    .wide = {},
    .parameters = smooth_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<1, float, none, buffer>, Box<1, float>>

struct read_box_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(read_box_direct_parameters, from_extent) == 0);

// transfer.glift:15: read_box<Array<1, float, none, buffer>, Box<1, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
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

static void read_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_direct_rows(call, rows); });
}

struct read_box_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_general_parameters, size) == 0);
static_assert(offsetof(read_box_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_general_parameters, to_origin) == 8);

// transfer.glift:15: read_box<Array<1, float, none, buffer>, Box<1, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_general_parameters*>(call.parameters);
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

static void read_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_general_rows(call, rows); });
}

const glift::Binding read_box_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_parameters[] = {
    {"from_extent", 0, sizeof(read_box_direct_parameters::from_extent)},
};
const glift::Kernel read_box_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_bindings,
    .direct = {.host = &read_box_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &read_box_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = read_box_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, float>, Array<1, float, none, buffer>>

struct write_box_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_direct_parameters, from_extent) == 0);

// transfer.glift:20: write_box<Box<1, float>, Array<1, float, none, buffer>>, some rows.
GLIFT_HOST_KERNEL
static void write_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
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

static void write_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_direct_rows(call, rows); });
}

struct write_box_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_general_parameters, size) == 0);
static_assert(offsetof(write_box_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_general_parameters, to_origin) == 8);

// transfer.glift:20: write_box<Box<1, float>, Array<1, float, none, buffer>>, some rows.
GLIFT_HOST_KERNEL
static void write_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_general_parameters*>(call.parameters);
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

static void write_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_general_rows(call, rows); });
}

const glift::Binding write_box_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_parameters[] = {
    {"from_extent", 0, sizeof(write_box_direct_parameters::from_extent)},
};
const glift::Kernel write_box_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_bindings,
    .direct = {.host = &write_box_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &write_box_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = write_box_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<1, float, none, buffer>, float>

struct fill_box_direct_parameters {
    uint to_extent;
    float value;
};
static_assert(offsetof(fill_box_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_direct_parameters, value) == 4);

// transfer.glift:25: fill_box<Array<1, float, none, buffer>, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_direct_parameters*>(call.parameters);
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

static void fill_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_direct_rows(call, rows); });
}

struct fill_box_general_parameters {
    uint size;
    uint to_origin;
    float value;
};
static_assert(offsetof(fill_box_general_parameters, size) == 0);
static_assert(offsetof(fill_box_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_general_parameters, value) == 8);

// transfer.glift:25: fill_box<Array<1, float, none, buffer>, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_general_parameters*>(call.parameters);
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

static void fill_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_general_rows(call, rows); });
}

const glift::Binding fill_box_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 16},
};
constexpr glift::Parameter fill_box_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_direct_parameters::to_extent)},
    {"value", 4, sizeof(fill_box_direct_parameters::value)},
};
const glift::Kernel fill_box_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_bindings,
    .direct = {.host = &fill_box_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &fill_box_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = fill_box_parameters,
    .items = {2, 1, 1},
};

void ramp(const glift::Commands& commands, const glift::Range<Line>& a, const glift::Range<Line>& f) {
    glift::Iteration iteration(ramp_kernel);
    iteration.each("a", a);
    iteration.each("f", f);
    const glift::Memory memories[] = {f->data()};
    if (iteration.is_whole() && a->same_state(f.structure())
        && !commands.needs_general(ramp_kernel, memories, iteration.size())) {
        const ramp_direct_parameters parameters = {
            .a_extent = a->extent(),
        };
        commands.dispatch(ramp_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const ramp_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .f_origin = f.origin(),
        };
        commands.dispatch(ramp_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(ramp_general_parameters, size)})});
    }
}

void smooth(const glift::Commands& commands, const glift::Range<Line>& f, const glift::Range<Line>& g) {
    glift::Iteration iteration(smooth_kernel);
    iteration.each("g", g);
    iteration.near("f", f);
    const glift::Memory memories[] = {f->data(), g->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (iteration.is_whole() && f->same_state(g.structure())
        && !commands.needs_general(smooth_kernel, memories, iteration.size())) {
        const smooth_direct_parameters parameters = {
            .f_extent = f->extent(),
        };
        commands.dispatch(smooth_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const smooth_general_parameters parameters = {
            .size = g.size(),
            .f_origin = iteration.centre(f),
            .g_origin = g.origin(),
            .f_extent = f->extent(),
        };
        commands.dispatch(smooth_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(smooth_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

void read_box(const glift::Commands& commands, const glift::Range<Line>& from, const glift::Range<Box_1_float>& to) {
    glift::Iteration iteration(read_box_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && !commands.needs_general(read_box_kernel, memories, iteration.size())) {
        const read_box_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(read_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(read_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(read_box_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void write_box(const glift::Commands& commands, const glift::Range<Box_1_float>& from, const glift::Range<Line>& to) {
    glift::Iteration iteration(write_box_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && !commands.needs_general(write_box_kernel, memories, iteration.size())) {
        const write_box_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(write_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(write_box_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void fill_box(const glift::Commands& commands, const glift::Range<Line>& to, float value) {
    glift::Iteration iteration(fill_box_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.is_whole() && !commands.needs_general(fill_box_kernel, memories, iteration.size())) {
        const fill_box_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const fill_box_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(fill_box_general_parameters, size)})});
    }
}

Box_1_float::Box_1_float(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Box_1_float.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

Box_1_float::Box_1_float(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box_1_float.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

uint Box_1_float::domain() const {
    return extent_;
}

bool Box_1_float::same_state(const Box_1_float& other) const {
    return extent_ == other.extent_;
}

}  // namespace

Line::Line(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Line.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

Line::Line(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Line.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

uint Line::domain() const {
    return extent_;
}

bool Line::same_state(const Line& other) const {
    return extent_ == other.extent_;
}

std::uint64_t Line::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> uint {
        // linear.glift:12
        return linearize(va, extent);
    };
    return translate(address);
}

void Line::copy_out(const glift::Commands& commands, const glift::Range<Line>& range, const glift::Memory& box) const {
    read_box(commands, range, Box_1_float(commands, range.size(), box));
}

void Line::copy_in(const glift::Commands& commands, const glift::Range<Line>& range, const glift::Memory& box) const {
    write_box(commands, Box_1_float(commands, range.size(), box), range);
}

void Line::fill(float value, const glift::Range<Line>& range) {
    fill_box(device(), range, value);
}
void Line::fill(float value) {
    fill(value, *this);
}

// steps.glift:11: smoothed
void smoothed(const glift::Commands& commands, const Line& g, uint rounds) {
    // steps.glift:12
    Line a(commands, g.extent());
    // steps.glift:13
    Line b(commands, g.extent());
    // steps.glift:14
    ramp(commands, a, a);
    // steps.glift:15
    for (uint i = 0u; i < rounds; ++i) {
        // steps.glift:16
        smooth(commands, a, b);
        // steps.glift:17
        smooth(commands, b, a);
    }
    b = {};
    // steps.glift:19
    smooth(commands, a, g);
    a = {};
}

}  // namespace steps
