// Made by gliftc from shared.glift. Changes are lost when it is made again.
#include "shared.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace shared {

using namespace glift::types;

namespace {
struct add_direct_parameters {
    uint f_extent;
    uint f_table_extent;
    uint2 f_frames_extent;
    uint g_field_extent;
    uint g_field_table_extent;
    uint2 g_field_frames_extent;
};
static_assert(offsetof(add_direct_parameters, f_extent) == 0);
static_assert(offsetof(add_direct_parameters, f_table_extent) == 4);
static_assert(offsetof(add_direct_parameters, f_frames_extent) == 8);
static_assert(offsetof(add_direct_parameters, g_field_extent) == 16);
static_assert(offsetof(add_direct_parameters, g_field_table_extent) == 20);
static_assert(offsetof(add_direct_parameters, g_field_frames_extent) == 24);
struct add_general_parameters {
    uint size;
    uint f_origin;
    uint g_origin;
    uint to_origin;
    uint f_extent;
    uint f_table_extent;
    uint2 f_frames_extent;
    uint to_extent;
    uint to_table_extent;
    uint2 to_frames_extent;
    uint g_field_extent;
    uint g_field_table_extent;
    uint2 g_field_frames_extent;
};
static_assert(offsetof(add_general_parameters, size) == 0);
static_assert(offsetof(add_general_parameters, f_origin) == 4);
static_assert(offsetof(add_general_parameters, g_origin) == 8);
static_assert(offsetof(add_general_parameters, to_origin) == 12);
static_assert(offsetof(add_general_parameters, f_extent) == 16);
static_assert(offsetof(add_general_parameters, f_table_extent) == 20);
static_assert(offsetof(add_general_parameters, f_frames_extent) == 24);
static_assert(offsetof(add_general_parameters, to_extent) == 32);
static_assert(offsetof(add_general_parameters, to_table_extent) == 36);
static_assert(offsetof(add_general_parameters, to_frames_extent) == 40);
static_assert(offsetof(add_general_parameters, g_field_extent) == 48);
static_assert(offsetof(add_general_parameters, g_field_table_extent) == 52);
static_assert(offsetof(add_general_parameters, g_field_frames_extent) == 56);
struct add_wide_parameters {
    uint size;
    uint f_origin;
    uint g_origin;
    uint to_origin;
    uint f_extent;
    uint f_table_extent;
    std::uint64_t f_frames_extent_x;
    uint f_frames_extent_y;
    uint to_extent;
    uint to_table_extent;
    std::uint64_t to_frames_extent_x;
    uint to_frames_extent_y;
    uint g_field_extent;
    uint g_field_table_extent;
    uint g_field_frames_extent_y;
    std::uint64_t g_field_frames_extent_x;
    std::uint64_t f_table_data_address;
    std::uint64_t f_frames_data_address;
    std::uint64_t g_field_table_data_address;
    std::uint64_t g_field_frames_data_address;
    std::uint64_t to_table_data_address;
    std::uint64_t to_frames_data_address;
};
static_assert(offsetof(add_wide_parameters, size) == 0);
static_assert(offsetof(add_wide_parameters, f_origin) == 4);
static_assert(offsetof(add_wide_parameters, g_origin) == 8);
static_assert(offsetof(add_wide_parameters, to_origin) == 12);
static_assert(offsetof(add_wide_parameters, f_extent) == 16);
static_assert(offsetof(add_wide_parameters, f_table_extent) == 20);
static_assert(offsetof(add_wide_parameters, f_frames_extent_x) == 24);
static_assert(offsetof(add_wide_parameters, f_frames_extent_y) == 32);
static_assert(offsetof(add_wide_parameters, to_extent) == 36);
static_assert(offsetof(add_wide_parameters, to_table_extent) == 40);
static_assert(offsetof(add_wide_parameters, to_frames_extent_x) == 48);
static_assert(offsetof(add_wide_parameters, to_frames_extent_y) == 56);
static_assert(offsetof(add_wide_parameters, g_field_extent) == 60);
static_assert(offsetof(add_wide_parameters, g_field_table_extent) == 64);
static_assert(offsetof(add_wide_parameters, g_field_frames_extent_y) == 68);
static_assert(offsetof(add_wide_parameters, g_field_frames_extent_x) == 72);
static_assert(offsetof(add_wide_parameters, f_table_data_address) == 80);
static_assert(offsetof(add_wide_parameters, f_frames_data_address) == 88);
static_assert(offsetof(add_wide_parameters, g_field_table_data_address) == 96);
static_assert(offsetof(add_wide_parameters, g_field_frames_data_address) == 104);
static_assert(offsetof(add_wide_parameters, to_table_data_address) == 112);
static_assert(offsetof(add_wide_parameters, to_frames_data_address) == 120);
}  // namespace

extern const glift::Kernel add_kernel;

void add(const glift::Commands& commands, const glift::Range<Paged>& f, const glift::Range<Same>& g,
    const glift::Range<Paged>& to) {
    glift::Iteration iteration(add_kernel);
    iteration.each("f", f);
    iteration.each("to", to);
    iteration.near("g", g);
    const glift::Memory memories[] = {f->table().data(), f->frames().data(), g->field().table().data(),
        g->field().frames().data(), to->table().data(), to->frames().data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g, to});
    if (commands.needs_wide(add_kernel, memories, iteration.size(), iteration.sharing())) {
        const add_wide_parameters parameters = {
            .size = f.size(),
            .f_origin = f.origin(),
            .g_origin = iteration.centre(g),
            .to_origin = to.origin(),
            .f_extent = f->extent(),
            .f_table_extent = f->table().extent(),
            .f_frames_extent_x = std::uint64_t(f->frames().extent().x),
            .f_frames_extent_y = f->frames().extent().y,
            .to_extent = to->extent(),
            .to_table_extent = to->table().extent(),
            .to_frames_extent_x = std::uint64_t(to->frames().extent().x),
            .to_frames_extent_y = to->frames().extent().y,
            .g_field_extent = g->field().extent(),
            .g_field_table_extent = g->field().table().extent(),
            .g_field_frames_extent_y = g->field().frames().extent().y,
            .g_field_frames_extent_x = std::uint64_t(g->field().frames().extent().x),
            .f_table_data_address = 0u,
            .f_frames_data_address = 0u,
            .g_field_table_data_address = 0u,
            .g_field_frames_data_address = 0u,
            .to_table_data_address = 0u,
            .to_frames_data_address = 0u,
        };
        commands.dispatch(add_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(add_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && f->same_state(to.structure())
        && iteration.sharing() != glift::Sharing::one_place) {
        const add_direct_parameters parameters = {
            .f_extent = f->extent(),
            .f_table_extent = f->table().extent(),
            .f_frames_extent = f->frames().extent(),
            .g_field_extent = g->field().extent(),
            .g_field_table_extent = g->field().table().extent(),
            .g_field_frames_extent = g->field().frames().extent(),
        };
        commands.dispatch(add_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const add_general_parameters parameters = {
            .size = f.size(),
            .f_origin = f.origin(),
            .g_origin = iteration.centre(g),
            .to_origin = to.origin(),
            .f_extent = f->extent(),
            .f_table_extent = f->table().extent(),
            .f_frames_extent = f->frames().extent(),
            .to_extent = to->extent(),
            .to_table_extent = to->table().extent(),
            .to_frames_extent = to->frames().extent(),
            .g_field_extent = g->field().extent(),
            .g_field_table_extent = g->field().table().extent(),
            .g_field_frames_extent = g->field().frames().extent(),
        };
        commands.dispatch(add_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(add_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct move_direct_parameters {
    uint from_extent;
    uint from_table_extent;
    uint2 from_frames_extent;
};
static_assert(offsetof(move_direct_parameters, from_extent) == 0);
static_assert(offsetof(move_direct_parameters, from_table_extent) == 4);
static_assert(offsetof(move_direct_parameters, from_frames_extent) == 8);
struct move_general_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint to_origin;
    uint to_extent;
    uint to_table_extent;
    uint2 to_frames_extent;
    uint from_extent;
    uint from_table_extent;
    uint2 from_frames_extent;
};
static_assert(offsetof(move_general_parameters, size) == 0);
static_assert(offsetof(move_general_parameters, a_origin) == 4);
static_assert(offsetof(move_general_parameters, from_origin) == 8);
static_assert(offsetof(move_general_parameters, to_origin) == 12);
static_assert(offsetof(move_general_parameters, to_extent) == 16);
static_assert(offsetof(move_general_parameters, to_table_extent) == 20);
static_assert(offsetof(move_general_parameters, to_frames_extent) == 24);
static_assert(offsetof(move_general_parameters, from_extent) == 32);
static_assert(offsetof(move_general_parameters, from_table_extent) == 36);
static_assert(offsetof(move_general_parameters, from_frames_extent) == 40);
struct move_wide_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint to_origin;
    uint to_extent;
    uint to_table_extent;
    std::uint64_t to_frames_extent_x;
    uint to_frames_extent_y;
    uint from_extent;
    uint from_table_extent;
    uint from_frames_extent_y;
    std::uint64_t from_frames_extent_x;
    std::uint64_t from_table_data_address;
    std::uint64_t from_frames_data_address;
    std::uint64_t to_table_data_address;
    std::uint64_t to_frames_data_address;
};
static_assert(offsetof(move_wide_parameters, size) == 0);
static_assert(offsetof(move_wide_parameters, a_origin) == 4);
static_assert(offsetof(move_wide_parameters, from_origin) == 8);
static_assert(offsetof(move_wide_parameters, to_origin) == 12);
static_assert(offsetof(move_wide_parameters, to_extent) == 16);
static_assert(offsetof(move_wide_parameters, to_table_extent) == 20);
static_assert(offsetof(move_wide_parameters, to_frames_extent_x) == 24);
static_assert(offsetof(move_wide_parameters, to_frames_extent_y) == 32);
static_assert(offsetof(move_wide_parameters, from_extent) == 36);
static_assert(offsetof(move_wide_parameters, from_table_extent) == 40);
static_assert(offsetof(move_wide_parameters, from_frames_extent_y) == 44);
static_assert(offsetof(move_wide_parameters, from_frames_extent_x) == 48);
static_assert(offsetof(move_wide_parameters, from_table_data_address) == 56);
static_assert(offsetof(move_wide_parameters, from_frames_data_address) == 64);
static_assert(offsetof(move_wide_parameters, to_table_data_address) == 72);
static_assert(offsetof(move_wide_parameters, to_frames_data_address) == 80);
}  // namespace

extern const glift::Kernel move_kernel;

void move(const glift::Commands& commands, const glift::Range<Paged>& from, const glift::Range<Paged>& a,
    const glift::Range<Paged>& to) {
    glift::Iteration iteration(move_kernel);
    iteration.each("a", a);
    iteration.each("to", to);
    iteration.any("from", from);
    const glift::Memory memories[] = {from->table().data(), from->frames().data(), to->table().data(),
        to->frames().data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, a, to});
    if (commands.needs_wide(move_kernel, memories, iteration.size())) {
        const move_wide_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_extent = to->extent(),
            .to_table_extent = to->table().extent(),
            .to_frames_extent_x = std::uint64_t(to->frames().extent().x),
            .to_frames_extent_y = to->frames().extent().y,
            .from_extent = from->extent(),
            .from_table_extent = from->table().extent(),
            .from_frames_extent_y = from->frames().extent().y,
            .from_frames_extent_x = std::uint64_t(from->frames().extent().x),
            .from_table_data_address = 0u,
            .from_frames_data_address = 0u,
            .to_table_data_address = 0u,
            .to_frames_data_address = 0u,
        };
        commands.dispatch(move_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(move_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && from->same_state(a.structure()) && a->same_state(to.structure())) {
        const move_direct_parameters parameters = {
            .from_extent = from->extent(),
            .from_table_extent = from->table().extent(),
            .from_frames_extent = from->frames().extent(),
        };
        commands.dispatch(move_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const move_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_extent = to->extent(),
            .to_table_extent = to->table().extent(),
            .to_frames_extent = to->frames().extent(),
            .from_extent = from->extent(),
            .from_table_extent = from->table().extent(),
            .from_frames_extent = from->frames().extent(),
        };
        commands.dispatch(move_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(move_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

Paged::Paged(const glift::Commands& commands, const Table& table, uint extent, uint capacity)
    : Structure(commands.device()),
      extent_(extent),
      capacity_(capacity),
      table_(table),
      frames_(Plane(commands, uint2(16u, capacity_))) {}

Paged::Paged(const glift::Commands& commands, const Table& table, uint extent, uint capacity, Plane frames)
    : Structure(commands.device()),
      extent_(extent),
      capacity_(capacity),
      table_(table),
      frames_(glift::detail::part(std::move(frames), frames.extent() == uint2(16u, capacity_), "Paged.frames")) {}

uint Paged::domain() const {
    return extent_;
}

bool Paged::same_state(const Paged& other) const {
    return extent_ == other.extent_ && capacity_ == other.capacity_ && table_.same_state(other.table_)
        && frames_.same_state(other.frames_);
}

void Paged::copy_out(const glift::Commands& commands, const glift::Range<Paged>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_b7c9e6e7(commands, range, ::std_transfer::Box_1_float(commands, range.size(), box));
}

void Paged::list(const glift::Commands& commands, const glift::Range<Paged>& range, glift::uint most,
    const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
    const glift::Memory& values) const {
    ::std_transfer::list_there_2c6db734(commands, range, *this, *this, ::std_transfer::Box_1_uint(commands, 1, counter),
        ::std_transfer::Box_1_uint(commands, most, addresses), ::std_transfer::Box_1_uint2(commands, most, places),
        ::std_transfer::Box_1_float(commands, most, values));
}

void Paged::copy_in(const glift::Commands& commands, const glift::Range<Paged>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_a6c67e1e(commands, ::std_transfer::Box_1_float(commands, range.size(), box), range);
}

void Paged::fill(float value, const glift::Range<Paged>& range) {
    ::std_transfer::fill_box_shared_Paged_float(device(), range, value);
}
void Paged::fill(float value) {
    fill(value, *this);
}

Same::Same(const glift::Commands& commands, const Paged& field)
    : Structure(commands.device()),
      field_(field) {}

uint Same::domain() const {
    return field_.domain();
}

bool Same::same_state(const Same& other) const {
    return field_.same_state(other.field_);
}

void Same::copy_out(const glift::Commands& commands, const glift::Range<Same>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_a62f9606(commands, range, ::std_transfer::Box_1_float(commands, range.size(), box));
}

void Same::list(const glift::Commands& commands, const glift::Range<Same>& range, glift::uint most,
    const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
    const glift::Memory& values) const {
    ::std_transfer::list_there_ac7b7783(commands, range, *this, field(),
        ::std_transfer::Box_1_uint(commands, 1, counter), ::std_transfer::Box_1_uint(commands, most, addresses),
        ::std_transfer::Box_1_uint2(commands, most, places), ::std_transfer::Box_1_float(commands, most, values));
}

void Same::copy_in(const glift::Commands& commands, const glift::Range<Same>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_416982b9(commands, ::std_transfer::Box_1_float(commands, range.size(), box), range);
}

void Same::fill(float value, const glift::Range<Same>& range) {
    ::std_transfer::fill_box_shared_Same_float(device(), range, value);
}
void Same::fill(float value) {
    fill(value, *this);
}

Growing::Growing(const glift::Commands& commands, uint n)
    : device_(commands.device()),
      n_(n),
      frames_(Plane(commands, uint2(16u, n_))),
      capacity_(n_) {}

bool Growing::same_state(const Growing& other) const {
    return n_ == other.n_ && frames_.get().same_state(other.frames_.get());
}

// shared.glift:52: grow
void Growing::grow(const glift::Commands& commands) {
    // shared.glift:53
    Plane larger(commands, uint2(16u, 2u * capacity_.get()));
    // shared.glift:54
    commands.replace(frames_.get(), std::move(larger), {frames_.get().data()});
    larger = {};
    // shared.glift:55
    capacity_.get() = 2u * capacity_.get();
}

}  // namespace shared
