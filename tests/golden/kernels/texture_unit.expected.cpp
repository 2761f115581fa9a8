// Made by gliftc from texture_unit.glift. Changes are lost when it is made again.
#include "texture_unit.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace texture_unit {

using namespace glift::types;

namespace {
struct splat_direct_parameters {
    uint p_extent;
    uint2 nearest_extent;
    uint farthest_extent;
    uint2 marks_extent;
    uint marks_data_extent_x;
};
static_assert(offsetof(splat_direct_parameters, p_extent) == 0);
static_assert(offsetof(splat_direct_parameters, nearest_extent) == 4);
static_assert(offsetof(splat_direct_parameters, farthest_extent) == 12);
static_assert(offsetof(splat_direct_parameters, marks_extent) == 16);
static_assert(offsetof(splat_direct_parameters, marks_data_extent_x) == 24);
struct splat_general_parameters {
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
};
static_assert(offsetof(splat_general_parameters, size) == 0);
static_assert(offsetof(splat_general_parameters, p_origin) == 4);
static_assert(offsetof(splat_general_parameters, nearest_origin) == 8);
static_assert(offsetof(splat_general_parameters, nearest_size) == 16);
static_assert(offsetof(splat_general_parameters, farthest_origin) == 24);
static_assert(offsetof(splat_general_parameters, farthest_size) == 28);
static_assert(offsetof(splat_general_parameters, marks_origin) == 32);
static_assert(offsetof(splat_general_parameters, marks_size) == 40);
static_assert(offsetof(splat_general_parameters, marks_extent_x) == 48);
static_assert(offsetof(splat_general_parameters, marks_data_extent_x) == 52);
struct splat_wide_parameters {
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
    std::uint64_t p_data_address;
    std::uint64_t farthest_data_address;
};
static_assert(offsetof(splat_wide_parameters, size) == 0);
static_assert(offsetof(splat_wide_parameters, p_origin) == 4);
static_assert(offsetof(splat_wide_parameters, nearest_origin) == 8);
static_assert(offsetof(splat_wide_parameters, nearest_size) == 16);
static_assert(offsetof(splat_wide_parameters, farthest_origin) == 24);
static_assert(offsetof(splat_wide_parameters, farthest_size) == 28);
static_assert(offsetof(splat_wide_parameters, marks_origin) == 32);
static_assert(offsetof(splat_wide_parameters, marks_size) == 40);
static_assert(offsetof(splat_wide_parameters, marks_extent_x) == 48);
static_assert(offsetof(splat_wide_parameters, marks_data_extent_x) == 52);
static_assert(offsetof(splat_wide_parameters, p_data_address) == 56);
static_assert(offsetof(splat_wide_parameters, farthest_data_address) == 64);
}  // namespace

extern const glift::Kernel splat_kernel;

void splat(const glift::Commands& commands, const glift::Range<Points>& p, const glift::Range<Heights>& nearest,
    const glift::Range<::std_array::Array_1_float_none_buffer>& farthest, const glift::Range<Marks>& marks) {
    glift::Iteration iteration(splat_kernel);
    iteration.each("p", p);
    iteration.any("nearest", nearest);
    iteration.any("farthest", farthest);
    iteration.any("marks", marks);
    const glift::Memory memories[] = {p->data(), nearest->data(), farthest->data(), marks->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {p, nearest, farthest, marks});
    if (commands.needs_wide(splat_kernel, memories, iteration.size())) {
        const splat_wide_parameters parameters = {
            .size = p.size(),
            .p_origin = p.origin(),
            .nearest_origin = nearest.origin(),
            .nearest_size = nearest.size(),
            .farthest_origin = farthest.origin(),
            .farthest_size = farthest.size(),
            .marks_origin = marks.origin(),
            .marks_size = marks.size(),
            .marks_extent_x = marks->extent().x,
            .marks_data_extent_x = glift::max(marks->data_extent().x, 1u),
            .p_data_address = 0u,
            .farthest_data_address = 0u,
        };
        iteration.count(nearest, offsetof(splat_wide_parameters, nearest_size));
        iteration.count(farthest, offsetof(splat_wide_parameters, farthest_size));
        iteration.count(marks, offsetof(splat_wide_parameters, marks_size));
        commands.dispatch(splat_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(splat_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const splat_direct_parameters parameters = {
            .p_extent = p->extent(),
            .nearest_extent = nearest->extent(),
            .farthest_extent = farthest->extent(),
            .marks_extent = marks->extent(),
            .marks_data_extent_x = glift::max(marks->data_extent().x, 1u),
        };
        commands.dispatch(splat_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const splat_general_parameters parameters = {
            .size = p.size(),
            .p_origin = p.origin(),
            .nearest_origin = nearest.origin(),
            .nearest_size = nearest.size(),
            .farthest_origin = farthest.origin(),
            .farthest_size = farthest.size(),
            .marks_origin = marks.origin(),
            .marks_size = marks.size(),
            .marks_extent_x = marks->extent().x,
            .marks_data_extent_x = glift::max(marks->data_extent().x, 1u),
        };
        iteration.count(nearest, offsetof(splat_general_parameters, nearest_size));
        iteration.count(farthest, offsetof(splat_general_parameters, farthest_size));
        iteration.count(marks, offsetof(splat_general_parameters, marks_size));
        commands.dispatch(splat_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(splat_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct light_direct_parameters {
    uint p_extent;
    float2 heights_data_extent;
    uint3 shadows_domain;
    float shadows_depths_extent_x;
    float shadows_depths_extent_y;
};
static_assert(offsetof(light_direct_parameters, p_extent) == 0);
static_assert(offsetof(light_direct_parameters, heights_data_extent) == 4);
static_assert(offsetof(light_direct_parameters, shadows_domain) == 12);
static_assert(offsetof(light_direct_parameters, shadows_depths_extent_x) == 24);
static_assert(offsetof(light_direct_parameters, shadows_depths_extent_y) == 28);
struct light_general_parameters {
    uint size;
    uint p_origin;
    uint3 shadows_origin;
    uint2 heights_origin;
    uint3 shadows_size;
    float2 heights_data_extent;
    float shadows_depths_extent_x;
    float shadows_depths_extent_y;
};
static_assert(offsetof(light_general_parameters, size) == 0);
static_assert(offsetof(light_general_parameters, p_origin) == 4);
static_assert(offsetof(light_general_parameters, shadows_origin) == 8);
static_assert(offsetof(light_general_parameters, heights_origin) == 20);
static_assert(offsetof(light_general_parameters, shadows_size) == 28);
static_assert(offsetof(light_general_parameters, heights_data_extent) == 40);
static_assert(offsetof(light_general_parameters, shadows_depths_extent_x) == 48);
static_assert(offsetof(light_general_parameters, shadows_depths_extent_y) == 52);
struct light_wide_parameters {
    uint size;
    uint p_origin;
    uint3 shadows_origin;
    uint2 heights_origin;
    uint3 shadows_size;
    float2 heights_data_extent;
    float shadows_depths_extent_x;
    float shadows_depths_extent_y;
    std::uint64_t p_data_address;
};
static_assert(offsetof(light_wide_parameters, size) == 0);
static_assert(offsetof(light_wide_parameters, p_origin) == 4);
static_assert(offsetof(light_wide_parameters, shadows_origin) == 8);
static_assert(offsetof(light_wide_parameters, heights_origin) == 20);
static_assert(offsetof(light_wide_parameters, shadows_size) == 28);
static_assert(offsetof(light_wide_parameters, heights_data_extent) == 40);
static_assert(offsetof(light_wide_parameters, shadows_depths_extent_x) == 48);
static_assert(offsetof(light_wide_parameters, shadows_depths_extent_y) == 52);
static_assert(offsetof(light_wide_parameters, p_data_address) == 56);
}  // namespace

extern const glift::Kernel light_kernel;

void light(const glift::Commands& commands, const glift::Range<Shadows>& shadows, const glift::Range<Heights>& heights,
    const glift::Range<Points>& p) {
    glift::Iteration iteration(light_kernel);
    iteration.each("p", p);
    iteration.any("shadows", shadows);
    iteration.any("heights", heights);
    const glift::Memory memories[] = {p->data(), shadows->depths(), heights->data(), shadows->depths()};
    if (commands.needs_wide(light_kernel, memories, iteration.size())) {
        const light_wide_parameters parameters = {
            .size = p.size(),
            .p_origin = p.origin(),
            .shadows_origin = shadows.origin(),
            .heights_origin = heights.origin(),
            .shadows_size = shadows.size(),
            .heights_data_extent = float2(heights->data_extent()),
            .shadows_depths_extent_x = float(shadows->depths_extent().x),
            .shadows_depths_extent_y = float(shadows->depths_extent().y),
            .p_data_address = 0u,
        };
        iteration.count(shadows, offsetof(light_wide_parameters, shadows_size));
        commands.dispatch(light_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(light_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const light_direct_parameters parameters = {
            .p_extent = p->extent(),
            .heights_data_extent = float2(heights->data_extent()),
            .shadows_domain = uint3(shadows->extent(), shadows->layers()),
            .shadows_depths_extent_x = float(shadows->depths_extent().x),
            .shadows_depths_extent_y = float(shadows->depths_extent().y),
        };
        commands.dispatch(light_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const light_general_parameters parameters = {
            .size = p.size(),
            .p_origin = p.origin(),
            .shadows_origin = shadows.origin(),
            .heights_origin = heights.origin(),
            .shadows_size = shadows.size(),
            .heights_data_extent = float2(heights->data_extent()),
            .shadows_depths_extent_x = float(shadows->depths_extent().x),
            .shadows_depths_extent_y = float(shadows->depths_extent().y),
        };
        iteration.count(shadows, offsetof(light_general_parameters, shadows_size));
        commands.dispatch(light_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(light_general_parameters, size)})});
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
