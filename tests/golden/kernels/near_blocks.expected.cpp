// Made by gliftc from near_blocks.glift. Changes are lost when it is made again.
#include "near_blocks.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace near_blocks {

using namespace glift::types;

namespace {

// address.glift:53: div_ceil<2>
inline uint2 div_ceil(uint2 a, uint2 b) {
    // address.glift:54
    const uint2 any = glift::min(a, uint2(1u));
    // address.glift:55
    return (a - any) / b + any;
}

}  // namespace

extern const glift::Kernel right_kernel;

void right(const glift::Commands& commands, const glift::Range<Listed>& f, const glift::Range<Listed>& g) {
    glift::Iteration iteration(right_kernel);
    iteration.each("g", g);
    iteration.near("f", f);
    iteration.blocks(uint2(64u, g->capacity()));
    const glift::Memory memories[] = {g->active().data(), f->table().data(), f->frames().data(), g->table().data(),
        g->frames().data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (iteration.can_be_direct(commands, memories) && f->same_state(g.structure())) {
        const struct {
            uint2 size;
            uint f_active_extent;
            uint div_ceil_x;
            uint div_ceil_x_2;
            uint f_table_extent;
            uint2 f_frames_extent;
            uint2 f_extent;
        } parameters = {iteration.visited(), f->active().extent(),
            glift::max(div_ceil(f->extent(), uint2(8u, 8u)).x, 1u), div_ceil(f->extent(), uint2(8u, 8u)).x,
            f->table().extent(), f->frames().extent(), f->extent()};
        static_assert(sizeof parameters == 40);
        iteration.count_blocks(0);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint2 size;
            uint2 g_origin;
            uint2 f_origin;
            uint2 g_size;
            uint g_active_extent;
            uint div_ceil_x;
            uint div_ceil_x_2;
            uint g_table_extent;
            uint2 g_frames_extent;
            uint div_ceil_x_3;
            uint f_table_extent;
            uint2 f_frames_extent;
            uint2 f_extent;
            std::uint64_t addresses[5];
        } parameters = {iteration.visited(), g.origin(), iteration.centre(f), g.size(), g->active().extent(),
            glift::max(div_ceil(g->extent(), uint2(8u, 8u)).x, 1u), div_ceil(g->extent(), uint2(8u, 8u)).x,
            g->table().extent(), g->frames().extent(), div_ceil(f->extent(), uint2(8u, 8u)).x, f->table().extent(),
            f->frames().extent(), f->extent(), {}};
        static_assert(sizeof parameters == 120);
        iteration.count_blocks(0);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {24});
    }
}

Listed::Listed(const glift::Commands& commands, const Numbers& table, const Numbers& active, uint2 extent,
    uint capacity)
    : Structure(commands.device()),
      extent_(extent),
      capacity_(capacity),
      table_(table),
      active_(active),
      frames_(::std_array::Array_2_float(commands, uint2(64u, capacity_))) {}

Listed::Listed(const glift::Commands& commands, const Numbers& table, const Numbers& active, uint2 extent,
    uint capacity, ::std_array::Array_2_float frames)
    : Structure(commands.device()),
      extent_(extent),
      capacity_(capacity),
      table_(table),
      active_(active),
      frames_(glift::detail::part(std::move(frames), frames.extent() == uint2(64u, capacity_), "Listed.frames")) {}

uint2 Listed::domain() const {
    return extent_;
}

bool Listed::same_state(const Listed& other) const {
    return extent_ == other.extent_ && capacity_ == other.capacity_ && table_.same_state(other.table_)
        && active_.same_state(other.active_) && frames_.same_state(other.frames_);
}

uint2 Listed::block_extent() const {
    return uint2(8u, 8u);
}

void Listed::copy_out(const glift::Commands& commands, const glift::Range<Listed>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_9bb01b1e(commands, range, ::std_transfer::Box_2_float(commands, range.size(), box));
}

void Listed::list(const glift::Commands& commands, const glift::Range<Listed>& range, glift::uint most,
    const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
    const glift::Memory& values) const {
    ::std_transfer::list_there_d7a68012(commands, range, *this, *this, ::std_transfer::Box_1_uint(commands, 1, counter),
        ::std_transfer::Box_1_uint2(commands, most, addresses), ::std_transfer::Box_1_uint2(commands, most, places),
        ::std_transfer::Box_1_float(commands, most, values));
}

void Listed::copy_in(const glift::Commands& commands, const glift::Range<Listed>& range,
    const glift::Memory& box) const {
    ::std_transfer::write_box_bdc9234f(commands, ::std_transfer::Box_2_float(commands, range.size(), box), range);
}

void Listed::fill(float value, const glift::Range<Listed>& range) {
    ::std_transfer::fill_box_c2b13d34(device(), range, value);
}
void Listed::fill(float value) {
    fill(value, *this);
}

}  // namespace near_blocks
