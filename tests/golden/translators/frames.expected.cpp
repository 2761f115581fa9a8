// Made by gliftc from frames.glift. Changes are lost when it is made again.
#include "frames.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace frames {

using namespace glift::types;

extern const glift::Kernel double_there_kernel;

void double_there(const glift::Commands& commands, const glift::Range<Pool>& s, const glift::Range<Pool>& g) {
    glift::Iteration iteration(double_there_kernel);
    iteration.each("g", g);
    iteration.any("s", s);
    const glift::Memory memories[] = {g->frames().data(), g->data(), s->frames().data(), s->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {s, g});
    if (iteration.can_be_direct(commands, memories) && s->same_state(g.structure())) {
        const struct {
            uint s_frames_n;
            uint s_data_extent;
        } parameters = {s->frames().n(), glift::fitted(s->data_extent())};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint g_origin;
            uint s_origin;
            uint g_frames_n;
            uint g_data_extent;
            uint s_frames_n;
            uint s_data_extent;
            std::uint64_t addresses[4];
        } parameters = {g.size(), g.origin(), s.origin(), g->frames().n(), glift::fitted(g->data_extent()),
            s->frames().n(), glift::fitted(s->data_extent()), {}};
        static_assert(sizeof parameters == 64);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

Frames::Frames(const glift::Commands& commands, uint n)
    : Structure(commands.device()),
      n_(n),
      data_extent_(std::uint64_t(n_)),
      data_(commands.allocate({.name = "Frames.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

Frames::Frames(const glift::Commands& commands, uint n, glift::Memory data)
    : Structure(commands.device()),
      n_(n),
      data_extent_(std::uint64_t(n_)),
      data_(commands.adopt(std::move(data),
        {.name = "Frames.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

uint Frames::domain() const {
    return n_;
}

bool Frames::same_state(const Frames& other) const {
    return n_ == other.n_;
}

std::uint64_t Frames::place(uint address) const {
    [[maybe_unused]] const uint n = n_;
    const auto translate = [&](uint va) -> uint {
        // frames.glift:8
        return va;
    };
    return translate(address);
}

void Frames::copy_out(const glift::Commands& commands, const glift::Range<Frames>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_c62e930d(commands, range, ::std_transfer::Box_1_uint(commands, range.size(), box));
}

void Frames::list(const glift::Commands& commands, const glift::Range<Frames>& range, glift::uint most,
    const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
    const glift::Memory& values) const {
    ::std_transfer::list_there_ba0d4190(commands, range, *this, *this, ::std_transfer::Box_1_uint(commands, 1, counter),
        ::std_transfer::Box_1_uint(commands, most, addresses), ::std_transfer::Box_1_uint(commands, most, places),
        ::std_transfer::Box_1_uint(commands, most, values));
}

void Frames::copy_in(const glift::Commands& commands, const glift::Range<Frames>& range,
    const glift::Memory& box) const {
    ::std_transfer::write_box_32448ca0(commands, ::std_transfer::Box_1_uint(commands, range.size(), box), range);
}

void Frames::fill(uint value, const glift::Range<Frames>& range) {
    ::std_transfer::fill_box_frames_Frames_uint(device(), range, value);
}
void Frames::fill(uint value) {
    fill(value, *this);
}

Pool::Pool(const glift::Commands& commands, uint pages, uint capacity)
    : Structure(commands.device()),
      pages_(pages),
      capacity_(capacity),
      frames_(Frames(commands, pages_)),
      data_extent_(glift::saturated_product(std::uint64_t(capacity_), std::uint64_t{4u})),
      data_(commands.allocate({.name = "Pool.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

Pool::Pool(const glift::Commands& commands, uint pages, uint capacity, Frames frames, glift::Memory data)
    : Structure(commands.device()),
      pages_(pages),
      capacity_(capacity),
      frames_(glift::detail::part(std::move(frames), frames.n() == pages_, "Pool.frames")),
      data_extent_(glift::saturated_product(std::uint64_t(capacity_), std::uint64_t{4u})),
      data_(commands.adopt(std::move(data),
        {.name = "Pool.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

uint Pool::domain() const {
    return frames_.n() * 4u;
}

bool Pool::same_state(const Pool& other) const {
    return pages_ == other.pages_ && capacity_ == other.capacity_ && frames_.same_state(other.frames_);
}

void Pool::copy_out(const glift::Commands& commands, const glift::Range<Pool>& range, const glift::Memory& box) const {
    ::std_transfer::read_box_1f848e0d(commands, range, ::std_transfer::Box_1_float(commands, range.size(), box));
}

void Pool::list(const glift::Commands& commands, const glift::Range<Pool>& range, glift::uint most,
    const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
    const glift::Memory& values) const {
    ::std_transfer::list_there_d62ad97a(commands, range, *this, *this, ::std_transfer::Box_1_uint(commands, 1, counter),
        ::std_transfer::Box_1_uint(commands, most, addresses), ::std_transfer::Box_1_uint(commands, most, places),
        ::std_transfer::Box_1_float(commands, most, values));
}

void Pool::copy_in(const glift::Commands& commands, const glift::Range<Pool>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_31432b0a(commands, ::std_transfer::Box_1_float(commands, range.size(), box), range);
}

void Pool::fill(float value, const glift::Range<Pool>& range) {
    ::std_transfer::fill_box_frames_Pool_float(device(), range, value);
}
void Pool::fill(float value) {
    fill(value, *this);
}

}  // namespace frames
