// Sums of floats in one order, whatever the device (glift::SumOrder): the host device adds in the order of the shaders.
#pragma once

#include <glift/host/parallel.h>
#include <glift/host/updates.h>

namespace glift::host {

/// The parts of one update's sums, which meet in a memory: for each sum two words, the index of its element plus one,
/// or 0 where nothing is added; then the parts.
class PartialSums {
public:
    /// An element's address in the iteration.
    using Address = std::array<std::uint32_t, 4>;
    /// In place of the index of an element of memory: nothing is added.
    static constexpr std::uint64_t none = ~std::uint64_t{0};

    /// `orders`: those of the kernel; `number`: that of this update; `words`: where the parts of all meet.
    PartialSums(const HostCall& call, std::span<const SumOrder> orders, std::size_t number, float* elements,
                uint* words)
        : order_(orders[number]), size_(call.size), count_(count_of(order_, size_)), elements_(elements),
          words_(words) {
        for (std::size_t before = 0; before < number; ++before) words_ += count_of(orders[before], size_).words();
    }

    /// The number of the sum, and of its part, that has the element.
    std::size_t sum_of(const Address& at) const { return number_of<false>(at); }
    std::size_t part_of(const Address& at) const { return number_of<true>(at); }

    /// Takes the sum of a part; `index`: that of its element of memory.
    void put(std::size_t sum, std::size_t part, std::uint64_t index, float value) const {
        if (!meets()) return update(index, value);
        parts(sum)[part * step()] = value;
        if (index == none) return;
        __atomic_store_n(words_ + 2 * sum, static_cast<uint>(index + 1), __ATOMIC_RELAXED);
        __atomic_store_n(words_ + 2 * sum + 1, static_cast<uint>((index + 1) >> 32), __ATOMIC_RELAXED);
    }

    /// Adds the parts of all sums, after all have been put.
    void finish() const {
        if (!meets()) return;
        const std::size_t grain = detail::most<std::size_t>(1, detail::task_elements / count_.parts);
        detail::spread(count_.sums, grain, [this](std::size_t begin, std::size_t end) {
            for (std::size_t sum = begin; sum < end; ++sum)
                update(index_of(sum), order_.axis == 0 ? tree_of(sum) : column_of(sum));
        });
    }

private:
    bool meets() const { return count_.parts > 1 && count_.parts <= order_.most_parts; }
    std::size_t step() const { return order_.axis == 0 ? 1 : count_.sums; }
    float* parts(std::size_t sum) const {
        return reinterpret_cast<float*>(words_ + 2 * count_.sums) + (order_.axis == 0 ? sum * count_.parts : sum);
    }

    std::uint64_t index_of(std::size_t sum) const {
        return (std::uint64_t{words_[2 * sum + 1]} << 32 | words_[2 * sum]) - 1;  // 0 gives `none`
    }

    template <bool are_parts> std::size_t number_of(const Address& at) const {
        std::size_t number = 0, count = 1;
        for (unsigned axis = 0; axis < 3; ++axis) {
            if (((order_.axes >> axis & 1) != 0) != are_parts) continue;
            const uint cut = are_parts && axis == order_.axis ? order_.part : 1;
            number += at[axis] / cut * count;
            count *= (std::size_t{size_[axis]} + cut - 1) / cut;
        }
        return number;
    }

    float column_of(std::size_t sum) const {
        float value = Add::identity<float>();
        for (std::size_t part = 0; part < count_.parts; ++part) value += parts(sum)[part * step()];
        return value;
    }

    float tree_of(std::size_t sum) const {
        RowUpdate<float, Add> lanes(count_.parts);
        for (std::size_t part = 0; part < count_.parts; ++part) lanes.add(0, part % row_lanes, parts(sum)[part]);
        return lanes.value();
    }

    void update(std::uint64_t index, float value) const {
        const bool adds_nothing = value == 0 && __builtin_signbit(value);  // -0
        if (index != none && !adds_nothing) Add::update(elements_[index], value);
    }

    const SumOrder& order_;
    const Address& size_;
    SumCount count_;
    float* elements_;
    uint* words_;
};

/// Sums along rows. RowUpdate adds the elements of a part.
class RowSums : public PartialSums {
public:
    using PartialSums::PartialSums;

    /// Says which part is added next.
    void begin(const Row& row) {
        const Address at{row.begin, row.y, row.z, 0};
        sum_ = sum_of(at);
        part_ = part_of(at);
        put(sum_, part_, none, Add::identity<float>());
    }
    void add(std::uint64_t index, float value) const { put(sum_, part_, index, value); }

private:
    std::size_t sum_ = 0, part_ = 0;
};

/// The widest part of a row in which for_column_parts adds columns.
inline constexpr uint columns_of_task = 1024;

/// Sums along y or z: one part of each column of the rows. `Index`: the type of indices of memory, whose largest value
/// is that of no element.
template <class Index> class ColumnSums : public PartialSums {
public:
    ColumnSums(const HostCall& call, std::span<const SumOrder> orders, std::size_t number, float* elements, uint* words,
               const Rows& rows)
        : PartialSums(call, orders, number, elements, words), first_(*rows.begin()) {
        for (uint i = 0; i < first_.end - first_.begin; ++i) {
            values_[i] = Add::identity<float>();
            indices_[i] = no_element;
        }
    }
    ColumnSums(const ColumnSums&) = delete;
    ~ColumnSums() {
        const Address at{first_.begin, first_.y, first_.z, 0};
        const std::size_t sum = sum_of(at), part = part_of(at);
        for (uint i = 0; i < first_.end - first_.begin; ++i)
            put(sum + i, part, indices_[i] == no_element ? none : indices_[i], values_[i]);
    }

    void add(uint x, Index index, float value) {
        const uint i = x - first_.begin;
        indices_[i] = index;
        values_[i] += value;
    }

private:
    static constexpr Index no_element = static_cast<Index>(~Index{0});

    const Row first_;
    alignas(64) float values_[columns_of_task];
    alignas(64) Index indices_[columns_of_task];
};

/// Calls `body(const Rows&)` in parallel for parts of rows of `part` elements.
template <class Body> void for_row_parts(const std::array<std::uint32_t, 4>& size, uint part, const Body& body) {
    const std::size_t rows = std::size_t{size[1]} * size[2] * size[3];
    const std::size_t parts = (std::size_t{size[0]} + part - 1) / part;
    if (rows == 0 || parts == 0) return;
    const auto run = [&](std::size_t i) {
        const std::size_t x = i % parts * part, row = i / parts;
        const uint past = static_cast<uint>(detail::least<std::size_t>(x + part, size[0]));
        body(Rows({static_cast<uint>(x), past, static_cast<uint>(row % size[1]),
                   static_cast<uint>(row / size[1] % size[2]), static_cast<uint>(row / size[1] / size[2])},
                  1, size));
    };
    const std::size_t elements = detail::least<std::size_t>(part, size[0]);
    detail::spread(rows * parts, detail::most<std::size_t>(1, detail::task_elements / elements),
                   [&](std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i) run(i);
                   });
}

/// Calls `body(const Rows&)` in parallel for `part` rows along `axis` (1: y, 2: z) of columns_of_task elements.
template <unsigned axis, class Body>
void for_column_parts(const std::array<std::uint32_t, 4>& size, uint part, const Body& body) {
    static_assert(axis == 1 || axis == 2);
    const std::size_t runs = (std::size_t{size[0]} + columns_of_task - 1) / columns_of_task;
    const std::size_t bands = (std::size_t{size[axis]} + part - 1) / part, other = size[3 - axis];
    const auto run = [&](std::size_t i) {
        const std::size_t x = i % runs * columns_of_task, first = i / runs % bands * part;
        const uint past = static_cast<uint>(detail::least<std::size_t>(x + columns_of_task, size[0]));
        const std::size_t count = detail::least<std::size_t>(part, size[axis] - first);
        const uint fixed = static_cast<uint>(i / runs / bands);
        const uint y = axis == 1 ? static_cast<uint>(first) : fixed, z = axis == 1 ? fixed : static_cast<uint>(first);
        const Row row{static_cast<uint>(x), past, y, z, 0};
        if constexpr (axis == 1) body(Rows(row, count, size));
        else body(Rows::along_z(row, count));
    };
    detail::spread(runs * bands * other, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) run(i);
    });
}

}  // namespace glift::host
