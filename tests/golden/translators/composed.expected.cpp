// Made by gliftc from composed.glift. Changes are lost when it is made again.
#include "composed.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace composed {

using namespace glift::types;

extern const glift::Kernel copy_kernel;

void copy(const glift::Commands& commands, const glift::Range<Turned>& f, const glift::Range<Turned>& g) {
    glift::Iteration iteration(copy_kernel);
    iteration.each("f", f);
    iteration.each("g", g);
    const glift::Memory memories[] = {f->data(), g->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (iteration.can_be_direct(commands, memories) && f->same_state(g.structure())) {
        const struct {
            uint2 f_extent;
        } parameters = {f->extent()};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint2 size;
            uint2 f_origin;
            uint2 g_origin;
            uint3 base;
            uint f_extent_y;
            uint g_extent_y;
            std::uint64_t addresses[2];
        } parameters = {f.size(), f.origin(), g.origin(), {}, f->extent().y, g->extent().y, {}};
        static_assert(sizeof parameters == 64);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

Turned::Turned(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(glift::saturated_product(std::uint64_t(extent_.x), std::uint64_t(extent_.y))),
      data_(commands.allocate({.name = "Turned.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

Turned::Turned(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(glift::saturated_product(std::uint64_t(extent_.x), std::uint64_t(extent_.y))),
      data_(commands.adopt(std::move(data),
        {.name = "Turned.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

uint2 Turned::domain() const {
    return extent_;
}

bool Turned::same_state(const Turned& other) const {
    return extent_ == other.extent_;
}

std::uint64_t Turned::index_of(uint2 address) const {
    const auto step_0 = [&](auto address) {
        [[maybe_unused]] const uint2 extent = extent_;
        const auto translate = [&](uint2 va) -> uint2 {
            // composed.glift:8
            return glift::swizzle<1, 0>(va);
        };
        return translate(address);
    };
    const auto at_0 = step_0(address);
    const auto step_1 = [&](auto address) {
        [[maybe_unused]] const uint width = extent_.y;
        const auto translate = [&](uint2 va) -> uint {
            // composed.glift:15
            return va.y * width + va.x;
        };
        return translate(address);
    };
    const auto at_1 = step_1(at_0);
    return at_1;
}

void Turned::copy_out(const glift::Commands& commands, const glift::Range<Turned>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_fa044b2c(commands, range, ::std_transfer::Box_2_float(commands, range.size(), box));
}

void Turned::copy_in(const glift::Commands& commands, const glift::Range<Turned>& range,
    const glift::Memory& box) const {
    ::std_transfer::write_box_1eb09855(commands, ::std_transfer::Box_2_float(commands, range.size(), box), range);
}

void Turned::fill(float value, const glift::Range<Turned>& range) {
    ::std_transfer::fill_box_composed_Turned_float(device(), range, value);
}
void Turned::fill(float value) {
    fill(value, *this);
}

}  // namespace composed
