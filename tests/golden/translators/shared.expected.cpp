// Made by gliftc from shared.glift. Changes are lost when it is made again.
#include "shared.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace shared {

using namespace glift::types;

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
    if (iteration.can_be_direct(commands, memories) && f->same_state(to.structure())) {
        const struct {
            uint f_extent;
            uint f_table_extent;
            uint2 f_frames_extent;
            uint g_field_extent;
            uint g_field_table_extent;
            uint2 g_field_frames_extent;
        } parameters = {f->extent(), f->table().extent(), f->frames().extent(), g->field().extent(),
            g->field().table().extent(), g->field().frames().extent()};
        static_assert(sizeof parameters == 32);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
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
            std::uint64_t addresses[6];
        } parameters = {f.size(), f.origin(), iteration.centre(g), to.origin(), f->extent(), f->table().extent(),
            f->frames().extent(), to->extent(), to->table().extent(), to->frames().extent(), g->field().extent(),
            g->field().table().extent(), g->field().frames().extent(), {}};
        static_assert(sizeof parameters == 112);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

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
    if (iteration.can_be_direct(commands, memories) && from->same_state(a.structure())
        && a->same_state(to.structure())) {
        const struct {
            uint from_extent;
            uint from_table_extent;
            uint2 from_frames_extent;
        } parameters = {from->extent(), from->table().extent(), from->frames().extent()};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
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
            std::uint64_t addresses[4];
        } parameters = {a.size(), a.origin(), from.origin(), to.origin(), to->extent(), to->table().extent(),
            to->frames().extent(), from->extent(), from->table().extent(), from->frames().extent(), {}};
        static_assert(sizeof parameters == 80);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
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
    const glift::PipelineMark _mark("grow", "shared.glift:52");
    // shared.glift:53
    Plane larger(commands, uint2(16u, 2u * capacity_.get()));
    // shared.glift:54
    commands.replace(frames_.get(), std::move(larger), {frames_.get().data()});
    larger = {};
    // shared.glift:55
    capacity_.get() = 2u * capacity_.get();
}

}  // namespace shared
