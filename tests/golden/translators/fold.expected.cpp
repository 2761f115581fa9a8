// Made by gliftc from fold.glift. Changes are lost when it is made again.
#include "fold.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace fold {

using namespace glift::types;

extern const glift::Kernel twice_kernel;

void twice(const glift::Commands& commands, const glift::Range<Field>& f) {
    glift::Iteration iteration(twice_kernel);
    iteration.each("f", f);
    const glift::Memory memories[] = {f->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint3 f_extent;
        } parameters = {f->extent()};
        static_assert(sizeof parameters == 12);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint3 size;
            uint3 f_origin;
            uint3 base;
            uint3 f_extent;
        } parameters = {f.size(), f.origin(), {}, f->extent()};
        static_assert(sizeof parameters == 48);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
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
