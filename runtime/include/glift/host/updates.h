// Updates of buffers, by `scatter` parameters with an operation: a thread combines what it writes to one element before
// it updates memory, where other threads update the same elements.
#pragma once

#include <glift/host/atomics.h>
#include <glift/vector.h>

#include <array>

namespace glift::host {

// The operations. combine: of two values of one thread. update: atomically, of an element. identity: combined with it,
// any value but NaN is itself.

namespace detail {
template <class T> constexpr T largest() {
    if constexpr (static_cast<T>(-1) < 0) return 0x7fffffff;
    else return 0xffffffff;
}
template <class T> constexpr T smallest() { return static_cast<T>(~largest<T>()); }
template <> constexpr float largest<float>() { return __builtin_nanf(""); }
template <> constexpr float smallest<float>() { return __builtin_nanf(""); }
}  // namespace detail

struct Add {
    template <class T> static constexpr T identity() { return -T(); }  // -0 for floats
    template <class T> static void combine(T& kept, T value) { kept += value; }
    template <class T> static void update(T& element, T value) { atomic_add(element, value); }
};
struct BitAnd {
    template <class T> static constexpr T identity() { return ~T(); }
    template <class T> static void combine(T& kept, T value) { kept &= value; }
    template <class T> static void update(T& element, T value) { atomic_bit_and(element, value); }
};
struct BitOr {
    template <class T> static constexpr T identity() { return 0; }
    template <class T> static void combine(T& kept, T value) { kept |= value; }
    template <class T> static void update(T& element, T value) { atomic_bit_or(element, value); }
};
struct BitXor {
    template <class T> static constexpr T identity() { return 0; }
    template <class T> static void combine(T& kept, T value) { kept ^= value; }
    template <class T> static void update(T& element, T value) { atomic_bit_xor(element, value); }
};

namespace detail {
/// As atomic_extremum: NaN only where there is no number.
template <class Before> void keep_extremum(float& kept, float value, const Before& before) {
    const bool is_better = kept != kept || before(ordered_bits(value), ordered_bits(kept));
    kept = value == value && is_better ? value : kept;
}
}  // namespace detail

struct Min {
    template <class T> static constexpr T identity() { return detail::largest<T>(); }
    template <class T> static void combine(T& kept, T value) { kept = value < kept ? value : kept; }
    static void combine(float& kept, float value) { detail::keep_extremum(kept, value, std::less<>()); }
    template <class T> static void update(T& element, T value) { atomic_min(element, value); }
};
struct Max {
    template <class T> static constexpr T identity() { return detail::smallest<T>(); }
    template <class T> static void combine(T& kept, T value) { kept = kept < value ? value : kept; }
    static void combine(float& kept, float value) { detail::keep_extremum(kept, value, std::greater<>()); }
    template <class T> static void update(T& element, T value) { atomic_max(element, value); }
};

/// The updates of one element by the elements of a row: lane i combines those of the elements i, i + row_lanes, …, so
/// that the C++ compiler can make a loop over the lanes vectors.
inline constexpr std::size_t row_lanes = 64;

/// The number of lanes that the elements [first, count) of a row take.
inline std::size_t lanes_from(std::size_t first, std::size_t count) {
    return count - first < row_lanes ? count - first : row_lanes;
}

template <class T, class Operation> class RowUpdate {
public:
    /// `count`: the number of elements in the row.
    explicit RowUpdate(std::size_t count) : lanes_(lanes_from(0, count)) {
        for (std::size_t i = 0; i < lanes_; ++i) values_[i] = Operation::template identity<T>();
    }

    void add(uint index, std::size_t lane, T value) {
        index_ = index;
        Operation::combine(values_[lane], value);
    }

    /// Makes the update, unless no element has.
    template <class Updates> void finish(Updates& updates) {
        if (index_ == ~0u) return;
        for (std::size_t width = row_lanes / 2; width != 0; width /= 2)
            for (std::size_t i = 0; i < width && i + width < lanes_; ++i)
                Operation::combine(values_[i], values_[i + width]);
        updates.add(index_, values_[0]);
    }

private:
    uint index_ = ~0u;
    std::size_t lanes_;
    T values_[row_lanes];
};

/// The updates of one buffer by one thread: a cache of the elements that it has updated, each in the one slot that its
/// index chooses. Memory is updated where two elements need one slot, and in the end. After many such conflicts every
/// update goes to memory at once.
template <class T, class Operation> class Updates {
public:
    explicit Updates(T* elements) : elements_(elements) {}
    Updates(const Updates&) = delete;
    ~Updates() {
        for (uint i = 0; i < used_count_; ++i) Operation::update(elements_[tags_[used_[i]]], values_[used_[i]]);
    }

    void add(uint index, T value) {
        if (conflicts_ > most_conflicts) return Operation::update(elements_[index], value);
        const uint slot = index % slots;
        if (used_count_ != 0 && tags_[slot] == index) return Operation::combine(values_[slot], value);
        put(slot, index, value);
    }

private:
    /// `empty`: an index that no element has, since buffers of 2^32 elements have other kernels.
    static constexpr uint slots = 4096, empty = ~0u, most_conflicts = 2 * slots;

    void put(uint slot, uint index, T value) {
        if (used_count_ == 0) tags_.fill(empty);
        if (tags_[slot] == empty) {
            used_[used_count_++] = static_cast<std::uint16_t>(slot);
        } else {
            Operation::update(elements_[tags_[slot]], values_[slot]);
            ++conflicts_;
        }
        tags_[slot] = index;
        values_[slot] = value;
    }

    T* elements_;
    uint used_count_ = 0, conflicts_ = 0;
    std::array<uint, slots> tags_;  ///< the indices of the elements in the slots
    std::array<T, slots> values_;
    std::array<std::uint16_t, slots> used_;  ///< the slots that are not empty
};

}  // namespace glift::host
