// Accesses of host kernels to memory that several threads write: writes through `scatter` parameters; reads, writes and
// atomics through `coherent` parameters.
#pragma once

#include <glift/host/atomic_ref.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <type_traits>

namespace glift::host {

// Writes through `scatter` parameters. They are relaxed, since no other access of the pass is ordered by them.

template <class T> void atomic_replace(T& target, T value) { AtomicRef<T>(target).store(value, __ATOMIC_RELAXED); }

template <class T> void atomic_min(T& target, T value) {
    AtomicRef<T> shared(target);
    T old = shared.load(__ATOMIC_RELAXED);
    while (value < old && !shared.compare_exchange(old, value, __ATOMIC_RELAXED)) {}
}
template <class T> void atomic_max(T& target, T value) {
    AtomicRef<T> shared(target);
    T old = shared.load(__ATOMIC_RELAXED);
    while (old < value && !shared.compare_exchange(old, value, __ATOMIC_RELAXED)) {}
}

/// The bits of a float, changed so that as integers they are in the order of the floats; -0 comes before 0.
inline std::int32_t ordered_bits(float value) {
    const std::int32_t bits = std::bit_cast<std::int32_t>(value);
    return bits < 0 ? bits ^ 0x7fffffff : bits;
}
/// Keeps the minimum if `before` is std::less, the maximum if it is std::greater. A NaN is not written; any number
/// replaces a NaN that is there.
template <class Before> void atomic_extremum(float& target, float value, const Before& before) {
    if (value != value) return;
    AtomicRef<float> shared(target);
    float old = shared.load(__ATOMIC_RELAXED);
    while ((old != old || before(ordered_bits(value), ordered_bits(old))) &&
           !shared.compare_exchange(old, value, __ATOMIC_RELAXED)) {}
}
inline void atomic_min(float& target, float value) { atomic_extremum(target, value, std::less<>()); }
inline void atomic_max(float& target, float value) { atomic_extremum(target, value, std::greater<>()); }

template <class T> void atomic_add(T& target, T value) { AtomicRef<T>(target).fetch_add(value, __ATOMIC_RELAXED); }
template <class T> void atomic_bit_and(T& target, T value) { AtomicRef<T>(target).fetch_and(value, __ATOMIC_RELAXED); }
template <class T> void atomic_bit_or(T& target, T value) { AtomicRef<T>(target).fetch_or(value, __ATOMIC_RELAXED); }
template <class T> void atomic_bit_xor(T& target, T value) { AtomicRef<T>(target).fetch_xor(value, __ATOMIC_RELAXED); }

// Accesses to elements that workgroups share within a pass (`coherent` parameters).
namespace memory {

/// The unit of one atomic access to an element. An element of an arithmetic type of C++ is accessed as a whole; any
/// other (a vector, a struct, a half) by 32-bit words if its type is aligned to four bytes, else by bytes.
template <class T> using Piece =
    std::conditional_t<std::is_arithmetic_v<T>, T,
                       std::conditional_t<alignof(T) % sizeof(std::uint32_t) == 0, std::uint32_t, unsigned char>>;

/// Relaxed atomic loads: not torn within a piece, and not replaced by a value that the compiler kept in a register.
template <class T> T read(T& place) {
    using P = Piece<T>;
    alignas(T) P pieces[sizeof(T) / sizeof(P)];
    for (std::size_t i = 0; i < std::size(pieces); ++i)
        pieces[i] = AtomicRef<P>(reinterpret_cast<P*>(&place)[i]).load(__ATOMIC_RELAXED);
    return std::bit_cast<T>(pieces);
}

template <class T> void write(T& place, const std::type_identity_t<T>& value) {
    using P = Piece<T>;
    for (std::size_t i = 0; i < sizeof(T) / sizeof(P); ++i)
        AtomicRef<P>(reinterpret_cast<P*>(&place)[i]).store(reinterpret_cast<const P*>(&value)[i], __ATOMIC_RELAXED);
}

// Atomics that order the accesses around them: a load acquires, a store releases, the others are sequentially
// consistent.
template <class T> T atomicLoad(T& target) { return AtomicRef<T>(target).load(__ATOMIC_ACQUIRE); }
template <class T> void atomicStore(T& target, T value) { AtomicRef<T>(target).store(value, __ATOMIC_RELEASE); }
template <class T> T atomicAdd(T& target, T value) { return AtomicRef<T>(target).fetch_add(value); }
template <class T> T atomicAnd(T& target, T value) { return AtomicRef<T>(target).fetch_and(value); }
template <class T> T atomicOr(T& target, T value) { return AtomicRef<T>(target).fetch_or(value); }
template <class T> T atomicXor(T& target, T value) { return AtomicRef<T>(target).fetch_xor(value); }
template <class T> T atomicExchange(T& target, T value) { return AtomicRef<T>(target).exchange(value); }
template <class T> T atomicCompareExchange(T& target, T expected, T value) {
    AtomicRef<T>(target).compare_exchange(expected, value);
    return expected;
}
template <class T> T atomicMin(T& target, T value) {
    AtomicRef<T> shared(target);
    T before = shared.load();
    while (value < before && !shared.compare_exchange(before, value)) {}
    return before;
}
template <class T> T atomicMax(T& target, T value) {
    AtomicRef<T> shared(target);
    T before = shared.load();
    while (before < value && !shared.compare_exchange(before, value)) {}
    return before;
}
}  // namespace memory

}  // namespace glift::host
