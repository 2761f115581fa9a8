// Made by gliftc from texture_unit.glift. Changes are lost when it is made again.
#include "texture_unit.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace texture_unit {

using namespace glift::types;

extern const glift::Kernel splat_kernel;

void splat(const glift::Commands& commands, const glift::Range<Points>& p, const glift::Range<Heights>& nearest,
    const glift::Range<::std_array::Array_1_float>& farthest, const glift::Range<Marks>& marks) {
    glift::Iteration iteration(splat_kernel);
    iteration.each("p", p);
    iteration.any("nearest", nearest);
    iteration.any("farthest", farthest);
    iteration.any("marks", marks);
    const glift::Memory memories[] = {p->data(), nearest->data(), farthest->data(), marks->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {p, nearest, farthest, marks});
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint p_extent;
            uint2 nearest_extent;
            uint farthest_extent;
            uint2 marks_extent;
            uint marks_data_extent_x;
        } parameters = {p->extent(), nearest->extent(), farthest->extent(), marks->extent(),
            glift::max(marks->data_extent().x, 1u)};
        static_assert(sizeof parameters == 28);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint p_origin;
            uint2 nearest_origin;
            uint2 nearest_size;
            uint farthest_origin;
            uint farthest_size;
            uint2 marks_origin;
            uint2 marks_size;
            uint marks_extent_x;
            uint marks_data_extent_x;
            std::uint64_t addresses[2];
        } parameters = {p.size(), p.origin(), nearest.origin(), nearest.size(), farthest.origin(), farthest.size(),
            marks.origin(), marks.size(), marks->extent().x, glift::max(marks->data_extent().x, 1u), {}};
        static_assert(sizeof parameters == 72);
        iteration.count(nearest, 16);
        iteration.count(farthest, 28);
        iteration.count(marks, 40);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel light_kernel;

void light(const glift::Commands& commands, const glift::Range<Shadows>& shadows, const glift::Range<Heights>& heights,
    const glift::Range<Points>& p) {
    glift::Iteration iteration(light_kernel);
    iteration.each("p", p);
    iteration.any("shadows", shadows);
    iteration.any("heights", heights);
    const glift::Memory memories[] = {p->data(), shadows->depths(), heights->data(), shadows->depths()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint p_extent;
            float2 heights_data_extent;
            uint3 shadows_domain;
            float shadows_depths_extent_x;
            float shadows_depths_extent_y;
        } parameters = {p->extent(), float2(heights->data_extent()), uint3(shadows->extent(), shadows->layers()),
            float(shadows->depths_extent().x), float(shadows->depths_extent().y)};
        static_assert(sizeof parameters == 32);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint p_origin;
            uint3 shadows_origin;
            uint2 heights_origin;
            uint3 shadows_size;
            float2 heights_data_extent;
            float shadows_depths_extent_x;
            float shadows_depths_extent_y;
            std::uint64_t addresses[1];
        } parameters = {p.size(), p.origin(), shadows.origin(), heights.origin(), shadows.size(),
            float2(heights->data_extent()), float(shadows->depths_extent().x), float(shadows->depths_extent().y), {}};
        static_assert(sizeof parameters == 64);
        iteration.count(shadows, 28);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

Shadows::Shadows(const glift::Commands& commands, uint2 extent, uint layers)
    : Structure(commands.device()),
      extent_(extent),
      layers_(layers),
      depths_extent_(uint3(extent_, layers_)),
      depths_(commands.allocate({.name = "Shadows.depths", .kind = glift::MemoryKind::image2darray,
        .format = glift::Format::d32, .extent = glift::image_extent(depths_extent_)})) {}

Shadows::Shadows(const glift::Commands& commands, uint2 extent, uint layers, glift::Memory depths)
    : Structure(commands.device()),
      extent_(extent),
      layers_(layers),
      depths_extent_(uint3(extent_, layers_)),
      depths_(commands.adopt(std::move(depths),
        {.name = "Shadows.depths", .kind = glift::MemoryKind::image2darray, .format = glift::Format::d32,
        .extent = glift::image_extent(depths_extent_)})) {}

uint3 Shadows::domain() const {
    return uint3(extent_, layers_);
}

bool Shadows::same_state(const Shadows& other) const {
    return extent_ == other.extent_ && layers_ == other.layers_;
}

void Shadows::copy_out(const glift::Commands& commands, const glift::Range<Shadows>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_89e7a8a0(commands, range, ::std_transfer::Box_3_float(commands, range.size(), box));
}

Heights::Heights(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(extent_),
      data_(commands.allocate({.name = "Heights.data", .kind = glift::MemoryKind::image2d,
        .format = glift::Format::r32f, .extent = glift::image_extent(data_extent_)})) {}

Heights::Heights(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(extent_),
      data_(commands.adopt(std::move(data),
        {.name = "Heights.data", .kind = glift::MemoryKind::image2d, .format = glift::Format::r32f,
        .extent = glift::image_extent(data_extent_)})) {}

uint2 Heights::domain() const {
    return extent_;
}

bool Heights::same_state(const Heights& other) const {
    return extent_ == other.extent_;
}

void Heights::copy_out(const glift::Commands& commands, const glift::Range<Heights>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_0976d8f6(commands, range, ::std_transfer::Box_2_float(commands, range.size(), box));
}

void Heights::copy_in(const glift::Commands& commands, const glift::Range<Heights>& range,
    const glift::Memory& box) const {
    ::std_transfer::write_box_c1315537(commands, ::std_transfer::Box_2_float(commands, range.size(), box), range);
}

void Heights::fill(float value, const glift::Range<Heights>& range) {
    ::std_transfer::fill_box_7c95e848(device(), range, value);
}
void Heights::fill(float value) {
    fill(value, *this);
}

}  // namespace texture_unit
