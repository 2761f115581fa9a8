// Updates of buffers, by `scatter` parameters with an operation: a thread combines what it writes to one element before
// it updates memory, where other threads update the same elements.
#pragma once

#include <glift/host/atomics.h>
#include <glift/vector.h>

#include <array>

namespace glift::host {

// The operations. combine: of two values of one thread. update: atomically, of an element.

struct Add {
    template <class T> static void combine(T& kept, T value) { kept += value; }
    template <class T> static void update(T& element, T value) { atomic_add(element, value); }
};
struct BitAnd {
    template <class T> static void combine(T& kept, T value) { kept &= value; }
    template <class T> static void update(T& element, T value) { atomic_bit_and(element, value); }
};
struct BitOr {
    template <class T> static void combine(T& kept, T value) { kept |= value; }
    template <class T> static void update(T& element, T value) { atomic_bit_or(element, value); }
};
struct BitXor {
    template <class T> static void combine(T& kept, T value) { kept ^= value; }
    template <class T> static void update(T& element, T value) { atomic_bit_xor(element, value); }
};

namespace detail {
/// As atomic_extremum: NaN only where there is no number.
template <class Before> void keep_extremum(float& kept, float value, const Before& before) {
    if (value == value && (kept != kept || before(ordered_bits(value), ordered_bits(kept)))) kept = value;
}
}  // namespace detail

struct Min {
    template <class T> static void combine(T& kept, T value) { kept = value < kept ? value : kept; }
    static void combine(float& kept, float value) { detail::keep_extremum(kept, value, std::less<>()); }
    template <class T> static void update(T& element, T value) { atomic_min(element, value); }
};
struct Max {
    template <class T> static void combine(T& kept, T value) { kept = kept < value ? value : kept; }
    static void combine(float& kept, float value) { detail::keep_extremum(kept, value, std::greater<>()); }
    template <class T> static void update(T& element, T value) { atomic_max(element, value); }
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
        const uint slot = index % slots;
        if (used_count_ != 0 && tags_[slot] == index) return Operation::combine(values_[slot], value);
        if (conflicts_ > most_conflicts) return Operation::update(elements_[index], value);
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
