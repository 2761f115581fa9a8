// Made by gliftc from fold.glift. Changes are lost when it is made again.
#include "fold.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace fold {

using namespace glift::types;

namespace {
struct twice_direct_parameters {
    uint3 f_extent;
};
static_assert(offsetof(twice_direct_parameters, f_extent) == 0);
struct twice_general_parameters {
    uint3 size;
    uint3 f_origin;
    uint3 f_extent;
};
static_assert(offsetof(twice_general_parameters, size) == 0);
static_assert(offsetof(twice_general_parameters, f_origin) == 12);
static_assert(offsetof(twice_general_parameters, f_extent) == 24);
struct twice_wide_parameters {
    uint3 size;
    uint3 f_origin;
    uint3 base;
    uint3 f_extent;
};
static_assert(offsetof(twice_wide_parameters, size) == 0);
static_assert(offsetof(twice_wide_parameters, f_origin) == 12);
static_assert(offsetof(twice_wide_parameters, base) == 24);
static_assert(offsetof(twice_wide_parameters, f_extent) == 36);
}  // namespace

extern const glift::Kernel twice_kernel;

void twice(const glift::Commands& commands, const glift::Range<Field>& f) {
    glift::Iteration iteration(twice_kernel);
    iteration.each("f", f);
    const glift::Memory memories[] = {f->data()};
    if (commands.needs_wide(twice_kernel, memories, iteration.size())) {
        const twice_wide_parameters parameters = {
            .size = f.size(),
            .f_origin = f.origin(),
            .base = {},
            .f_extent = f->extent(),
        };
        commands.dispatch(twice_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(twice_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const twice_direct_parameters parameters = {
            .f_extent = f->extent(),
        };
        commands.dispatch(twice_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const twice_general_parameters parameters = {
            .size = f.size(),
            .f_origin = f.origin(),
            .f_extent = f->extent(),
        };
        commands.dispatch(twice_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(twice_general_parameters, size)})});
    }
}

Field::Field(const glift::Commands& commands, uint3 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(glift::fitted(glift::vec<std::uint64_t,
        2>(std::uint64_t{64u}, glift::saturated_sum(glift::saturated_product(glift::saturated_product(std::uint64_t(extent_.x), std::uint64_t(extent_.y)), std::uint64_t(extent_.z)), std::uint64_t{63u}) / std::uint64_t{64u}), "Field.data")),
      data_(commands.allocate({.name = "Field.data", .kind = glift::MemoryKind::image2d, .format = glift::Format::r32f,
        .extent = glift::image_extent(data_extent_)})) {}

Field::Field(const glift::Commands& commands, uint3 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(glift::fitted(glift::vec<std::uint64_t,
        2>(std::uint64_t{64u}, glift::saturated_sum(glift::saturated_product(glift::saturated_product(std::uint64_t(extent_.x), std::uint64_t(extent_.y)), std::uint64_t(extent_.z)), std::uint64_t{63u}) / std::uint64_t{64u}), "Field.data")),
      data_(commands.adopt(std::move(data),
        {.name = "Field.data", .kind = glift::MemoryKind::image2d, .format = glift::Format::r32f,
        .extent = glift::image_extent(data_extent_)})) {}

uint3 Field::domain() const {
    return extent_;
}

bool Field::same_state(const Field& other) const {
    return extent_ == other.extent_;
}

void Field::copy_out(const glift::Commands& commands, const glift::Range<Field>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_0059b9f4(commands, range, ::std_transfer::Box_3_float(commands, range.size(), box));
}

void Field::copy_in(const glift::Commands& commands, const glift::Range<Field>& range, const glift::Memory& box) const {
    ::std_transfer::write_box_16a1dc11(commands, ::std_transfer::Box_3_float(commands, range.size(), box), range);
}

void Field::fill(float value, const glift::Range<Field>& range) {
    ::std_transfer::fill_box_fold_Field_float(device(), range, value);
}
void Field::fill(float value) {
    fill(value, *this);
}

}  // namespace fold
