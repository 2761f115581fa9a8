// Made by gliftc from coherent.glift. Changes are lost when it is made again.
#include "coherent.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace coherent {

using namespace glift::types;

namespace {

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
// coherent.glift:8: take_turns

struct take_turns_direct_parameters {
    uint a_extent;
    uint state_value_inside;
    glift::Bool state_value_inside_2;
};
static_assert(offsetof(take_turns_direct_parameters, a_extent) == 0);
static_assert(offsetof(take_turns_direct_parameters, state_value_inside) == 4);
static_assert(offsetof(take_turns_direct_parameters, state_value_inside_2) == 8);

// coherent.glift:8: take_turns, some rows.
GLIFT_HOST_KERNEL
static void take_turns_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const take_turns_direct_parameters*>(call.parameters);
    const uint a_extent = parameters.a_extent;
    const uint state_value_inside = parameters.state_value_inside;
    const bool state_value_inside_2 = parameters.state_value_inside_2;
    uint* state_data = glift::host::elements<uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // coherent.glift:9
                const uint state_value = glift::host::memory::read(state_data[state_value_inside]);
                const uint state_value_2 = state_value_inside_2 ? state_value : 0u;
                // coherent.glift:10
                const uint state_address = address + 1u;
                if (state_address < a_extent) {
                    glift::host::memory::write(state_data[state_address], state_value_2);
                }
                // coherent.glift:11
                uint state_before = 0u;
                if (state_value_inside_2) {
                    state_before = glift::host::memory::atomicAdd(state_data[0u], 1u);
                }
                const uint state_value_3 = glift::host::memory::read(state_data[state_value_inside]);
                const uint state_value_4 = state_value_inside_2 ? state_value_3 : 0u;
                to_data_row[i] = state_before + state_value_4 - state_value_2;
            }
        }
    }
}

static void take_turns_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { take_turns_direct_rows(call, rows); });
}

struct take_turns_general_parameters {
    uint size;
    uint state_origin;
    uint state_size;
    uint a_origin;
    uint to_origin;
};
static_assert(offsetof(take_turns_general_parameters, size) == 0);
static_assert(offsetof(take_turns_general_parameters, state_origin) == 4);
static_assert(offsetof(take_turns_general_parameters, state_size) == 8);
static_assert(offsetof(take_turns_general_parameters, a_origin) == 12);
static_assert(offsetof(take_turns_general_parameters, to_origin) == 16);

// coherent.glift:8: take_turns, some rows.
GLIFT_HOST_KERNEL
static void take_turns_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const take_turns_general_parameters*>(call.parameters);
    const uint state_origin = parameters.state_origin;
    const uint state_size = parameters.state_size;
    const uint a_origin = parameters.a_origin;
    const uint to_origin = parameters.to_origin;
    uint* state_data = glift::host::elements<uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // coherent.glift:11
            const uint to_address = to_origin + address;
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // coherent.glift:10
                const uint a_address = a_origin + address;
                // coherent.glift:9
                const bool state_value_inside = 0u < state_size;
                const uint value = state_value_inside ? state_origin : 0u;
                const uint state_value = glift::host::memory::read(state_data[value]);
                const uint state_value_2 = state_value_inside ? state_value : 0u;
                // coherent.glift:10
                const uint state_address = a_address + 1u;
                const uint state_virtual = state_origin + state_address;
                if (state_address < state_size) {
                    glift::host::memory::write(state_data[state_virtual], state_value_2);
                }
                // coherent.glift:11
                uint state_before = 0u;
                if (state_value_inside) {
                    state_before = glift::host::memory::atomicAdd(state_data[state_origin], 1u);
                }
                const uint state_value_3 = glift::host::memory::read(state_data[value]);
                const uint state_value_4 = state_value_inside ? state_value_3 : 0u;
                to_data_row[i] = state_before + state_value_4 - state_value_2;
            }
        }
    }
}

static void take_turns_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { take_turns_general_rows(call, rows); });
}

const glift::Binding take_turns_bindings[] = {
    {.name = "state.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::range, .combine = glift::Combine::coherent},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .parameter = 2, .reach = glift::Reach::element},
};
constexpr glift::Parameter take_turns_parameters[] = {
    {"a_extent", 0, sizeof(take_turns_direct_parameters::a_extent)},
    {"state_value_inside", 4, sizeof(take_turns_direct_parameters::state_value_inside)},
    {"state_value_inside_2", 8, sizeof(take_turns_direct_parameters::state_value_inside_2)},
};
const glift::Kernel take_turns_kernel = {
    .name = "take_turns",
    .file = "coherent.glift",
    .line = 8,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = take_turns_bindings,
    .direct = {.host = &take_turns_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &take_turns_general, .parameter_bytes = 20},
    .wide = {},
    .parameters = take_turns_parameters,
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<1, uint, none, buffer>, Box<1, uint>>

struct read_box_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(read_box_direct_parameters, from_extent) == 0);

// transfer.glift:15: read_box<Array<1, uint, none, buffer>, Box<1, uint>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
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

// transfer.glift:15: read_box<Array<1, uint, none, buffer>, Box<1, uint>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_general_parameters*>(call.parameters);
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
// transfer.glift:20: write_box<Box<1, uint>, Array<1, uint, none, buffer>>

struct write_box_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_direct_parameters, from_extent) == 0);

// transfer.glift:20: write_box<Box<1, uint>, Array<1, uint, none, buffer>>, some rows.
GLIFT_HOST_KERNEL
static void write_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
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

// transfer.glift:20: write_box<Box<1, uint>, Array<1, uint, none, buffer>>, some rows.
GLIFT_HOST_KERNEL
static void write_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_general_parameters*>(call.parameters);
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
// transfer.glift:25: fill_box<Array<1, uint, none, buffer>, uint>

struct fill_box_direct_parameters {
    uint to_extent;
    uint value;
};
static_assert(offsetof(fill_box_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_direct_parameters, value) == 4);

// transfer.glift:25: fill_box<Array<1, uint, none, buffer>, uint>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_direct_parameters*>(call.parameters);
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

static void fill_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_direct_rows(call, rows); });
}

struct fill_box_general_parameters {
    uint size;
    uint to_origin;
    uint value;
};
static_assert(offsetof(fill_box_general_parameters, size) == 0);
static_assert(offsetof(fill_box_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_general_parameters, value) == 8);

// transfer.glift:25: fill_box<Array<1, uint, none, buffer>, uint>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_general_parameters*>(call.parameters);
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

void read_box(const glift::Commands& commands, const glift::Range<Values>& from, const glift::Range<Box_1_uint>& to) {
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

void write_box(const glift::Commands& commands, const glift::Range<Box_1_uint>& from, const glift::Range<Values>& to) {
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

void fill_box(const glift::Commands& commands, const glift::Range<Values>& to, uint value) {
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

void take_turns(const glift::Commands& commands, const glift::Range<Values>& a, const glift::Range<Values>& state,
    const glift::Range<Values>& to) {
    glift::Iteration iteration(take_turns_kernel);
    iteration.each("a", a);
    iteration.each("to", to);
    iteration.any("state", state);
    const glift::Memory memories[] = {state->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {a, state, to});
    if (iteration.is_whole() && a->same_state(state.structure()) && state->same_state(to.structure())
        && !commands.needs_general(take_turns_kernel, memories, iteration.size())) {
        const take_turns_direct_parameters parameters = {
            .a_extent = a->extent(),
            .state_value_inside = 0u < a->extent() ? 0u : 0u,
            .state_value_inside_2 = 0u < a->extent(),
        };
        commands.dispatch(take_turns_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const take_turns_general_parameters parameters = {
            .size = a.size(),
            .state_origin = state.origin(),
            .state_size = state.size(),
            .a_origin = a.origin(),
            .to_origin = to.origin(),
        };
        iteration.count(state, offsetof(take_turns_general_parameters, state_size));
        commands.dispatch(take_turns_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(take_turns_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void take_turns(const glift::Commands& commands, const glift::Range<Values>& state, const glift::Range<Values>& to) {
    take_turns(commands, to, state, to);
}

Values::Values(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Values.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

Values::Values(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Values.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

uint Values::domain() const {
    return extent_;
}

bool Values::same_state(const Values& other) const {
    return extent_ == other.extent_;
}

std::uint64_t Values::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> uint {
        // linear.glift:12
        return linearize(va, extent);
    };
    return translate(address);
}

void Values::copy_out(const glift::Commands& commands, const glift::Range<Values>& range,
    const glift::Memory& box) const {
    read_box(commands, range, Box_1_uint(commands, range.size(), box));
}

void Values::copy_in(const glift::Commands& commands, const glift::Range<Values>& range,
    const glift::Memory& box) const {
    write_box(commands, Box_1_uint(commands, range.size(), box), range);
}

void Values::fill(uint value, const glift::Range<Values>& range) {
    fill_box(device(), range, value);
}
void Values::fill(uint value) {
    fill(value, *this);
}

}  // namespace coherent
