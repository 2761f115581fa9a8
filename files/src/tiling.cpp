#include "tiling.h"

#include <algorithm>

namespace glift::files {

namespace {

std::uint64_t product(const std::vector<std::uint64_t>& lengths, std::size_t begin, std::size_t end) {
    std::uint64_t all = 1;
    for (std::size_t i = begin; i < end; ++i) all *= lengths[i];
    return all;
}

}  // namespace

Tiling Tiling::of(std::vector<std::uint64_t> shape, std::uint64_t most, std::size_t first_axis) {
    Tiling tiling;
    std::size_t axis = std::min(first_axis, shape.size() - 1);
    while (axis + 1 < shape.size() && product(shape, axis + 1, shape.size()) > most) ++axis;
    const std::uint64_t inner = std::max<std::uint64_t>(product(shape, axis + 1, shape.size()), 1);
    tiling.axis = axis;
    tiling.length = std::clamp<std::uint64_t>(most / inner, 1, std::max<std::uint64_t>(shape[axis], 1));
    tiling.shape = std::move(shape);
    return tiling;
}

std::uint64_t Tiling::elements() const { return product(shape, 0, shape.size()); }

std::vector<std::uint64_t> Tiling::chunk() const {
    std::vector<std::uint64_t> size = shape;
    std::fill_n(size.begin(), axis, 1);
    size[axis] = length;
    for (std::uint64_t& along : size) along = std::max<std::uint64_t>(along, 1);
    return size;
}

std::uint64_t Tiling::chunk_elements() const {
    const std::vector<std::uint64_t> size = chunk();
    return product(size, 0, size.size());
}

std::uint64_t Tiling::count() const {
    if (elements() == 0) return 0;
    return product(shape, 0, axis) * ((shape[axis] + length - 1) / length);
}

Batch Tiling::batch(std::uint64_t number) const {
    const std::uint64_t along = (shape[axis] + length - 1) / length;
    const std::uint64_t inner = product(shape, axis + 1, shape.size());
    Batch batch;
    batch.origin.assign(shape.size(), 0);
    batch.size = shape;
    std::fill_n(batch.size.begin(), axis, 1);
    batch.origin[axis] = number % along * length;
    batch.size[axis] = std::min(length, shape[axis] - batch.origin[axis]);
    std::uint64_t rest = number / along;
    batch.first = (rest * shape[axis] + batch.origin[axis]) * inner;
    batch.count = batch.size[axis] * inner;
    for (std::size_t i = axis; i-- > 0; rest /= shape[i]) batch.origin[i] = rest % shape[i];
    return batch;
}

}  // namespace glift::files
