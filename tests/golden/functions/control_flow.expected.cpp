// Made by gliftc from control_flow.glift. Changes are lost when it is made again.
#include "control_flow.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace control_flow {

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

/// Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_1_uint : public glift::Structure<Box_1_uint, uint, uint> {
public:
    static constexpr const char* type_name = "Box<1, uint>";

    Box_1_uint() = default;
    [[maybe_unused]] Box_1_uint(const glift::Commands& commands, uint extent);
    /// Over parts that exist already.
    [[maybe_unused]] Box_1_uint(const glift::Commands& commands, uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    [[maybe_unused]] uint domain() const;
    uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    uint data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    [[maybe_unused]] bool same_state(const Box_1_uint& other) const;

private:
    uint extent_{};
    uint data_extent_{};
    glift::Memory data_;
};

// control_flow.glift:18: halves<3>
inline float halves(float x) {
    // control_flow.glift:19
    float y = x;
    // control_flow.glift:20
    for (uint i = 0u; i < 3u; ++i) {
        y *= 0.5f;
    }
    // control_flow.glift:21
    return y;
}

// control_flow.glift:29: collatz
inline uint collatz(uint start) {
    // control_flow.glift:30
    uint n = start;
    // control_flow.glift:31
    uint steps = 0u;
    // control_flow.glift:32
    while (n > 1u) {
        // control_flow.glift:33
        if (steps == 100u) {
            break;
        }
        // control_flow.glift:34
        if (n % 2u == 0u) {
            n = n / 2u;
        } else {
            n = 3u * n + 1u;
        }
        // control_flow.glift:35
        steps += 1u;
    }
    // control_flow.glift:37
    return steps;
}

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
// control_flow.glift:40: control_flow

struct control_flow_direct_parameters {
    uint a_extent;
    glift::Bool mode_value_0;
};
static_assert(offsetof(control_flow_direct_parameters, a_extent) == 0);
static_assert(offsetof(control_flow_direct_parameters, mode_value_0) == 4);

// control_flow.glift:40: control_flow, some rows.
GLIFT_HOST_KERNEL
static void control_flow_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const control_flow_direct_parameters*>(call.parameters);
    const bool mode_value_0 = parameters.mode_value_0;
    float* f_data = glift::host::elements<float>(call.memories[0]);
    uint* n_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            float* f_data_row = glift::host::row_pointer(f_data + address);
            uint* n_data_row = glift::host::row_pointer(n_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // control_flow.glift:41
                const Interval i_2 = Interval{1.0f, float(address)};
                // control_flow.glift:42
                float x_2 = i_2.high - i_2.low + halves(i_2.high);
                // control_flow.glift:43
                const uint found = address / 2u;
                const bool found_found = !(address % 2u == 0u);
                if (found_found) {
                    x_2 += float(found);
                } else {
                    x_2 = -x_2;
                }
                // control_flow.glift:44
                f_data_row[i] = mode_value_0 ? x_2 : glift::sqrt(glift::abs(x_2));
                // control_flow.glift:45
                n_data_row[i] = collatz(address) + (found_found ? found : 7u);
            }
        }
    }
}

static void control_flow_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { control_flow_direct_rows(call, rows); });
}

struct control_flow_general_parameters {
    uint size;
    uint a_origin;
    uint f_origin;
    uint n_origin;
    glift::Bool mode_value_0;
};
static_assert(offsetof(control_flow_general_parameters, size) == 0);
static_assert(offsetof(control_flow_general_parameters, a_origin) == 4);
static_assert(offsetof(control_flow_general_parameters, f_origin) == 8);
static_assert(offsetof(control_flow_general_parameters, n_origin) == 12);
static_assert(offsetof(control_flow_general_parameters, mode_value_0) == 16);

// control_flow.glift:40: control_flow, some rows.
GLIFT_HOST_KERNEL
static void control_flow_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const control_flow_general_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint f_origin = parameters.f_origin;
    const uint n_origin = parameters.n_origin;
    const bool mode_value_0 = parameters.mode_value_0;
    float* f_data = glift::host::elements<float>(call.memories[0]);
    uint* n_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // control_flow.glift:44
            const uint f_address = f_origin + address;
            // control_flow.glift:45
            const uint n_address = n_origin + address;
            float* f_data_row = glift::host::row_pointer(f_data + f_address);
            uint* n_data_row = glift::host::row_pointer(n_data + n_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // control_flow.glift:41
                const uint a_address = a_origin + address;
                const Interval i_2 = Interval{1.0f, float(a_address)};
                // control_flow.glift:42
                float x_2 = i_2.high - i_2.low + halves(i_2.high);
                // control_flow.glift:43
                const uint found = a_address / 2u;
                const bool found_found = !(a_address % 2u == 0u);
                if (found_found) {
                    x_2 += float(found);
                } else {
                    x_2 = -x_2;
                }
                // control_flow.glift:44
                f_data_row[i] = mode_value_0 ? x_2 : glift::sqrt(glift::abs(x_2));
                // control_flow.glift:45
                n_data_row[i] = collatz(a_address) + (found_found ? found : 7u);
            }
        }
    }
}

static void control_flow_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { control_flow_general_rows(call, rows); });
}

const glift::Binding control_flow_bindings[] = {
    {.name = "f.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::element},
    {.name = "n.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .parameter = 2, .reach = glift::Reach::element},
};
constexpr glift::Parameter control_flow_parameters[] = {
    {"a_extent", 0, sizeof(control_flow_direct_parameters::a_extent)},
    {"mode_value_0", 4, sizeof(control_flow_direct_parameters::mode_value_0)},
};
const glift::Kernel control_flow_kernel = {
    .name = "control_flow",
    .file = "control_flow.glift",
    .line = 40,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = UINT64_MAX,
    .bindings = control_flow_bindings,
    .direct = {.host = &control_flow_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &control_flow_general, .parameter_bytes = 20},
    .wide = {},
    .parameters = control_flow_parameters,
    .reports = true,
    .longest_loop = {"control_flow.glift", 32},
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

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<1, uint, none, buffer>, Box<1, uint>>

struct read_box_2_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(read_box_2_direct_parameters, from_extent) == 0);

// transfer.glift:15: read_box<Array<1, uint, none, buffer>, Box<1, uint>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
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

static void read_box_2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_2_direct_rows(call, rows); });
}

struct read_box_2_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_2_general_parameters, size) == 0);
static_assert(offsetof(read_box_2_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_2_general_parameters, to_origin) == 8);

// transfer.glift:15: read_box<Array<1, uint, none, buffer>, Box<1, uint>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_2_general_parameters*>(call.parameters);
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

static void read_box_2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_2_general_rows(call, rows); });
}

const glift::Binding read_box_2_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_2_parameters[] = {
    {"from_extent", 0, sizeof(read_box_2_direct_parameters::from_extent)},
};
const glift::Kernel read_box_2_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_2_bindings,
    .direct = {.host = &read_box_2_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &read_box_2_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = read_box_2_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, uint>, Array<1, uint, none, buffer>>

struct write_box_2_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_2_direct_parameters, from_extent) == 0);

// transfer.glift:20: write_box<Box<1, uint>, Array<1, uint, none, buffer>>, some rows.
GLIFT_HOST_KERNEL
static void write_box_2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
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

static void write_box_2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_2_direct_rows(call, rows); });
}

struct write_box_2_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_2_general_parameters, size) == 0);
static_assert(offsetof(write_box_2_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_2_general_parameters, to_origin) == 8);

// transfer.glift:20: write_box<Box<1, uint>, Array<1, uint, none, buffer>>, some rows.
GLIFT_HOST_KERNEL
static void write_box_2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_2_general_parameters*>(call.parameters);
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

static void write_box_2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_2_general_rows(call, rows); });
}

const glift::Binding write_box_2_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_2_parameters[] = {
    {"from_extent", 0, sizeof(write_box_2_direct_parameters::from_extent)},
};
const glift::Kernel write_box_2_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_2_bindings,
    .direct = {.host = &write_box_2_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &write_box_2_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = write_box_2_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<1, uint, none, buffer>, uint>

struct fill_box_2_direct_parameters {
    uint to_extent;
    uint value;
};
static_assert(offsetof(fill_box_2_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_2_direct_parameters, value) == 4);

// transfer.glift:25: fill_box<Array<1, uint, none, buffer>, uint>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_2_direct_parameters*>(call.parameters);
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

static void fill_box_2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_2_direct_rows(call, rows); });
}

struct fill_box_2_general_parameters {
    uint size;
    uint to_origin;
    uint value;
};
static_assert(offsetof(fill_box_2_general_parameters, size) == 0);
static_assert(offsetof(fill_box_2_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_2_general_parameters, value) == 8);

// transfer.glift:25: fill_box<Array<1, uint, none, buffer>, uint>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_2_general_parameters*>(call.parameters);
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

static void fill_box_2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_2_general_rows(call, rows); });
}

const glift::Binding fill_box_2_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 16},
};
constexpr glift::Parameter fill_box_2_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_2_direct_parameters::to_extent)},
    {"value", 4, sizeof(fill_box_2_direct_parameters::value)},
};
const glift::Kernel fill_box_2_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_2_bindings,
    .direct = {.host = &fill_box_2_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &fill_box_2_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = fill_box_2_parameters,
    .items = {2, 1, 1},
};

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

void read_box_2(const glift::Commands& commands, const glift::Range<Numbers>& from,
    const glift::Range<Box_1_uint>& to) {
    glift::Iteration iteration(read_box_2_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && !commands.needs_general(read_box_2_kernel, memories, iteration.size())) {
        const read_box_2_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(read_box_2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_2_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(read_box_2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_2_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void write_box_2(const glift::Commands& commands, const glift::Range<Box_1_uint>& from,
    const glift::Range<Numbers>& to) {
    glift::Iteration iteration(write_box_2_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && !commands.needs_general(write_box_2_kernel, memories, iteration.size())) {
        const write_box_2_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_2_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(write_box_2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_2_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void fill_box_2(const glift::Commands& commands, const glift::Range<Numbers>& to, uint value) {
    glift::Iteration iteration(fill_box_2_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.is_whole() && !commands.needs_general(fill_box_2_kernel, memories, iteration.size())) {
        const fill_box_2_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_2_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .value = value,
        };
        commands.dispatch(fill_box_2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_2_general_parameters, size)})});
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

Box_1_uint::Box_1_uint(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Box_1_uint.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

Box_1_uint::Box_1_uint(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box_1_uint.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

uint Box_1_uint::domain() const {
    return extent_;
}

bool Box_1_uint::same_state(const Box_1_uint& other) const {
    return extent_ == other.extent_;
}

}  // namespace

void control_flow(const glift::Commands& commands, const glift::Range<Line>& a, const glift::Range<Line>& f,
    const glift::Range<Numbers>& n, uint mode) {
    glift::Iteration iteration(control_flow_kernel);
    iteration.each("a", a);
    iteration.each("f", f);
    iteration.each("n", n);
    const glift::Memory memories[] = {f->data(), n->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {a, f, n});
    if (iteration.is_whole() && a->same_state(f.structure())
        && !commands.needs_general(control_flow_kernel, memories, iteration.size())) {
        const control_flow_direct_parameters parameters = {
            .a_extent = a->extent(),
            .mode_value_0 = mode == 0u,
        };
        commands.dispatch(control_flow_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const control_flow_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .f_origin = f.origin(),
            .n_origin = n.origin(),
            .mode_value_0 = mode == 0u,
        };
        commands.dispatch(control_flow_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(control_flow_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void control_flow(const glift::Commands& commands, const glift::Range<Line>& f, const glift::Range<Numbers>& n,
    uint mode) {
    control_flow(commands, f, f, n, mode);
}

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

Numbers::Numbers(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Numbers.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

Numbers::Numbers(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Numbers.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

uint Numbers::domain() const {
    return extent_;
}

bool Numbers::same_state(const Numbers& other) const {
    return extent_ == other.extent_;
}

std::uint64_t Numbers::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> uint {
        // linear.glift:12
        return linearize(va, extent);
    };
    return translate(address);
}

void Numbers::copy_out(const glift::Commands& commands, const glift::Range<Numbers>& range,
    const glift::Memory& box) const {
    read_box_2(commands, range, Box_1_uint(commands, range.size(), box));
}

void Numbers::copy_in(const glift::Commands& commands, const glift::Range<Numbers>& range,
    const glift::Memory& box) const {
    write_box_2(commands, Box_1_uint(commands, range.size(), box), range);
}

void Numbers::fill(uint value, const glift::Range<Numbers>& range) {
    fill_box_2(device(), range, value);
}
void Numbers::fill(uint value) {
    fill(value, *this);
}

}  // namespace control_flow
