// Made by gliftc from composed.glift. Changes are lost when it is made again.
#include "composed.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace composed {

using namespace glift::types;

namespace {

/// Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_2_float : public glift::Structure<Box_2_float, uint2, float> {
public:
    static constexpr const char* type_name = "Box<2, float>";

    Box_2_float() = default;
    [[maybe_unused]] Box_2_float(const glift::Commands& commands, uint2 extent);
    /// Over parts that exist already.
    [[maybe_unused]] Box_2_float(const glift::Commands& commands, uint2 extent, glift::Memory data);

    /// The extent of the virtual domain.
    [[maybe_unused]] uint2 domain() const;
    uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    uint data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    [[maybe_unused]] bool same_state(const Box_2_float& other) const;

private:
    uint2 extent_{};
    uint data_extent_{};
    glift::Memory data_;
};

// address.glift:17: volume<2>
inline uint volume(uint2 extent) {
    // address.glift:18
    uint product = extent.x;
    // address.glift:19
    for (uint axis = 1u; axis < 2u; ++axis) {
        // address.glift:20
        product *= extent[axis];
    }
    // address.glift:22
    return product;
}

// ----------------------------------------------------------------------------------------------------
// composed.glift:24: copy

struct copy_direct_parameters {
    uint2 f_extent;
};
static_assert(offsetof(copy_direct_parameters, f_extent) == 0);

// composed.glift:24: copy, some rows.
GLIFT_HOST_KERNEL
static void copy_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const copy_direct_parameters*>(call.parameters);
    const uint2 f_extent = parameters.f_extent;
    const float* f_data = glift::host::elements<const float>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // composed.glift:24
            const uint f_at = address.x * f_extent.y + address.y;
            g_data[f_at] = f_data[f_at];
        }
    }
}

static void copy_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { copy_direct_rows(call, rows); });
}

struct copy_general_parameters {
    uint2 size;
    uint2 f_origin;
    uint2 g_origin;
    uint f_extent_y;
    uint g_extent_y;
};
static_assert(offsetof(copy_general_parameters, size) == 0);
static_assert(offsetof(copy_general_parameters, f_origin) == 8);
static_assert(offsetof(copy_general_parameters, g_origin) == 16);
static_assert(offsetof(copy_general_parameters, f_extent_y) == 24);
static_assert(offsetof(copy_general_parameters, g_extent_y) == 28);

// composed.glift:24: copy, some rows.
GLIFT_HOST_KERNEL
static void copy_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const copy_general_parameters*>(call.parameters);
    const uint2 f_origin = parameters.f_origin;
    const uint2 g_origin = parameters.g_origin;
    const uint f_extent_y = parameters.f_extent_y;
    const uint g_extent_y = parameters.g_extent_y;
    const float* f_data = glift::host::elements<const float>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // composed.glift:24
            const uint2 f_address = f_origin + address;
            const uint f_at = f_address.x * f_extent_y + f_address.y;
            const uint2 g_address = g_origin + address;
            const uint g_at = g_address.x * g_extent_y + g_address.y;
            const float f_value = f_data[f_at];
            g_data[g_at] = f_value;
        }
    }
}

static void copy_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { copy_general_rows(call, rows); });
}

const glift::Binding copy_bindings[] = {
    {.name = "f.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .reach = glift::Reach::element},
    {.name = "g.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter copy_parameters[] = {
    {"f_extent", 0, sizeof(copy_direct_parameters::f_extent)},
};
const glift::Kernel copy_kernel = {
    .name = "copy",
    .file = "composed.glift",
    .line = 24,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = copy_bindings,
    .direct = {.host = &copy_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &copy_general, .parameter_bytes = 32},
    .wide = {},
    .parameters = copy_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Turned, Box<2, float>>

struct read_box_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: read_box<Turned, Box<2, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const uint to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
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
                // transfer.glift:15
                const uint from_at = address.x * from_extent.y + address.y;
                // transfer.glift:16
                to_data_row[i] = from_data[from_at];
            }
        }
    }
}

static void read_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_direct_rows(call, rows); });
}

struct read_box_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_y;
    uint to_extent_x;
};
static_assert(offsetof(read_box_general_parameters, size) == 0);
static_assert(offsetof(read_box_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_general_parameters, from_extent_y) == 24);
static_assert(offsetof(read_box_general_parameters, to_extent_x) == 28);

// transfer.glift:15: read_box<Turned, Box<2, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_y = parameters.from_extent_y;
    const uint to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
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
                // transfer.glift:15
                const uint from_at = from_address.x * from_extent_y + from_address.y;
                // transfer.glift:16
                to_data_row[i] = from_data[from_at];
            }
        }
    }
}

static void read_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_general_rows(call, rows); });
}

const glift::Binding read_box_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_parameters[] = {
    {"from_extent", 0, sizeof(read_box_direct_parameters::from_extent)},
    {"to_extent_x", 8, sizeof(read_box_direct_parameters::to_extent_x)},
};
const glift::Kernel read_box_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_bindings,
    .direct = {.host = &read_box_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &read_box_general, .parameter_bytes = 32},
    .wide = {},
    .parameters = read_box_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<2, float>, Turned>

struct write_box_direct_parameters {
    uint2 from_extent;
    uint to_extent_y;
};
static_assert(offsetof(write_box_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_direct_parameters, to_extent_y) == 8);

// transfer.glift:20: write_box<Box<2, float>, Turned>, some rows.
GLIFT_HOST_KERNEL
static void write_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const uint to_extent_y = parameters.to_extent_y;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:20
            const uint from_at = address.y * from_extent.x + address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:20
                const uint to_at = address.x * to_extent_y + address.y;
                // transfer.glift:21
                to_data[to_at] = from_data_row[i];
            }
        }
    }
}

static void write_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_direct_rows(call, rows); });
}

struct write_box_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
    uint to_extent_y;
};
static_assert(offsetof(write_box_general_parameters, size) == 0);
static_assert(offsetof(write_box_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_general_parameters, from_extent_x) == 24);
static_assert(offsetof(write_box_general_parameters, to_extent_y) == 28);

// transfer.glift:20: write_box<Box<2, float>, Turned>, some rows.
GLIFT_HOST_KERNEL
static void write_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const uint to_extent_y = parameters.to_extent_y;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
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
                // transfer.glift:20
                const uint to_at = to_address.x * to_extent_y + to_address.y;
                // transfer.glift:21
                to_data[to_at] = from_data_row[i];
            }
        }
    }
}

static void write_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_general_rows(call, rows); });
}

const glift::Binding write_box_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_parameters[] = {
    {"from_extent", 0, sizeof(write_box_direct_parameters::from_extent)},
    {"to_extent_y", 8, sizeof(write_box_direct_parameters::to_extent_y)},
};
const glift::Kernel write_box_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = write_box_bindings,
    .direct = {.host = &write_box_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &write_box_general, .parameter_bytes = 32},
    .wide = {},
    .parameters = write_box_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Turned, float>

struct fill_box_direct_parameters {
    uint2 to_extent;
    float value;
};
static_assert(offsetof(fill_box_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_direct_parameters, value) == 8);

// transfer.glift:25: fill_box<Turned, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_direct_parameters*>(call.parameters);
    const uint2 to_extent = parameters.to_extent;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:25
            const uint to_at = address.x * to_extent.y + address.y;
            // transfer.glift:26
            to_data[to_at] = value;
        }
    }
}

static void fill_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_direct_rows(call, rows); });
}

struct fill_box_general_parameters {
    uint2 size;
    uint2 to_origin;
    uint to_extent_y;
    float value;
};
static_assert(offsetof(fill_box_general_parameters, size) == 0);
static_assert(offsetof(fill_box_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_general_parameters, to_extent_y) == 16);
static_assert(offsetof(fill_box_general_parameters, value) == 20);

// transfer.glift:25: fill_box<Turned, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_general_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const uint to_extent_y = parameters.to_extent_y;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            // transfer.glift:25
            const uint to_at = to_address.x * to_extent_y + to_address.y;
            // transfer.glift:26
            to_data[to_at] = value;
        }
    }
}

static void fill_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_general_rows(call, rows); });
}

const glift::Binding fill_box_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24},
};
constexpr glift::Parameter fill_box_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_direct_parameters::to_extent)},
    {"value", 8, sizeof(fill_box_direct_parameters::value)},
};
const glift::Kernel fill_box_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = fill_box_bindings,
    .direct = {.host = &fill_box_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &fill_box_general, .parameter_bytes = 24},
    .wide = {},
    .parameters = fill_box_parameters,
    .items = {1, 2, 1},
};

void read_box(const glift::Commands& commands, const glift::Range<Turned>& from, const glift::Range<Box_2_float>& to) {
    glift::Iteration iteration(read_box_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && !commands.needs_general(read_box_kernel, memories, iteration.size())) {
        const read_box_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_y = from->extent().y,
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(read_box_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void write_box(const glift::Commands& commands, const glift::Range<Box_2_float>& from, const glift::Range<Turned>& to) {
    glift::Iteration iteration(write_box_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && !commands.needs_general(write_box_kernel, memories, iteration.size())) {
        const write_box_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_y = to->extent().y,
        };
        commands.dispatch(write_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
            .to_extent_y = to->extent().y,
        };
        commands.dispatch(write_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(write_box_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void fill_box(const glift::Commands& commands, const glift::Range<Turned>& to, float value) {
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
            .to_extent_y = to->extent().y,
            .value = value,
        };
        commands.dispatch(fill_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(fill_box_general_parameters, size)})});
    }
}

Box_2_float::Box_2_float(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Box_2_float.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

Box_2_float::Box_2_float(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box_2_float.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

uint2 Box_2_float::domain() const {
    return extent_;
}

bool Box_2_float::same_state(const Box_2_float& other) const {
    return extent_ == other.extent_;
}

}  // namespace

void copy(const glift::Commands& commands, const glift::Range<Turned>& f, const glift::Range<Turned>& g) {
    glift::Iteration iteration(copy_kernel);
    iteration.each("f", f);
    iteration.each("g", g);
    const glift::Memory memories[] = {f->data(), g->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (iteration.is_whole() && f->same_state(g.structure()) && iteration.sharing() != glift::Sharing::one_place
        && !commands.needs_general(copy_kernel, memories, iteration.size())) {
        const copy_direct_parameters parameters = {
            .f_extent = f->extent(),
        };
        commands.dispatch(copy_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const copy_general_parameters parameters = {
            .size = f.size(),
            .f_origin = f.origin(),
            .g_origin = g.origin(),
            .f_extent_y = f->extent().y,
            .g_extent_y = g->extent().y,
        };
        commands.dispatch(copy_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(copy_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

Turned::Turned(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(extent_.x * extent_.y),
      data_(commands.allocate({.name = "Turned.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

Turned::Turned(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(extent_.x * extent_.y),
      data_(commands.adopt(std::move(data),
        {.name = "Turned.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

uint2 Turned::domain() const {
    return extent_;
}

bool Turned::same_state(const Turned& other) const {
    return extent_ == other.extent_;
}

void Turned::copy_out(const glift::Commands& commands, const glift::Range<Turned>& range,
    const glift::Memory& box) const {
    read_box(commands, range, Box_2_float(commands, range.size(), box));
}

void Turned::copy_in(const glift::Commands& commands, const glift::Range<Turned>& range,
    const glift::Memory& box) const {
    write_box(commands, Box_2_float(commands, range.size(), box), range);
}

void Turned::fill(float value, const glift::Range<Turned>& range) {
    fill_box(device(), range, value);
}
void Turned::fill(float value) {
    fill(value, *this);
}

}  // namespace composed
