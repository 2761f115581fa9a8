// Atomic accesses to an object that is no std::atomic, by the built-in functions of GCC and Clang: libc++ has
// std::atomic_ref only from LLVM 19 on.
#pragma once

#include <type_traits>

namespace glift::host {

/// The operations of std::atomic_ref. `order` is __ATOMIC_RELAXED, __ATOMIC_SEQ_CST, or for loads __ATOMIC_ACQUIRE and
/// for stores __ATOMIC_RELEASE.
template <class T> class AtomicRef {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    explicit AtomicRef(T& target) : target_(&target) {}

    T load(int order = __ATOMIC_SEQ_CST) const {
        T value;
        __atomic_load(target_, &value, order);
        return value;
    }
    void store(T value, int order = __ATOMIC_SEQ_CST) const { __atomic_store(target_, &value, order); }
    T exchange(T value, int order = __ATOMIC_SEQ_CST) const {
        T before;
        __atomic_exchange(target_, &value, &before, order);
        return before;
    }
    /// Whether the object had the value `expected`; if not, `expected` becomes the one that it had.
    bool compare_exchange(T& expected, T value, int order = __ATOMIC_SEQ_CST) const {
        return __atomic_compare_exchange(target_, &expected, &value, false, order,
                                         order == __ATOMIC_SEQ_CST ? order : __ATOMIC_RELAXED);
    }
    T fetch_add(T value, int order = __ATOMIC_SEQ_CST) const {
        if constexpr (std::is_integral_v<T>) return __atomic_fetch_add(target_, value, order);
        else {
            T before = load(__ATOMIC_RELAXED);
            while (!compare_exchange(before, before + value, order)) {}
            return before;
        }
    }
    T fetch_and(T value, int order = __ATOMIC_SEQ_CST) const { return __atomic_fetch_and(target_, value, order); }
    T fetch_or(T value, int order = __ATOMIC_SEQ_CST) const { return __atomic_fetch_or(target_, value, order); }
    T fetch_xor(T value, int order = __ATOMIC_SEQ_CST) const { return __atomic_fetch_xor(target_, value, order); }

private:
    T* target_;
};

}  // namespace glift::host
