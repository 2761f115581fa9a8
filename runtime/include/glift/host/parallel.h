// How host kernels spread over the cores: blocks of rows, and atomic combination of values.
#pragma once

#include <glift/api.h>
#include <glift/pass.h>
#include <glift/vector.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <utility>

// Compiled once for each width of vectors; the dynamic linker takes the widest that this machine has.
#if !defined(GLIFT_HOST_KERNEL)
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__linux__) && defined(__OPTIMIZE__) &&  \
    !defined(__AVX2__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GLIFT_HOST_KERNEL __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define GLIFT_HOST_KERNEL
#endif
#endif

// Before a loop whose rounds are independent.
#if defined(__clang__)
#define GLIFT_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define GLIFT_INDEPENDENT _Pragma("GCC ivdep")
#else
#define GLIFT_INDEPENDENT
#endif

// Before a loop over one block of independent rounds: a few vectors, with nothing left over.
#if defined(__clang__)
#define GLIFT_BLOCK _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define GLIFT_BLOCK _Pragma("GCC ivdep") _Pragma("GCC unroll 1")
#else
#define GLIFT_BLOCK
#endif

namespace glift::host {

/// Elements [begin, end) along x of the row at y, z, w.
struct Row {
    uint begin, end;
    uint y, z, w;
};

/// Rows one after the other, all with the same begin and end.
class Rows {
public:
    Rows(const Row& first, std::size_t count, const std::array<std::uint32_t, 4>& size)
        : first_(first), size_y_(size[1]), size_z_(size[2]), count_(count) {}

    class Iterator {
    public:
        explicit Iterator(const Rows& rows)
            : row_(rows.first_), size_y_(rows.size_y_), size_z_(rows.size_z_), left_(rows.count_) {}
        Row operator*() const { return row_; }
        Iterator& operator++() {
            --left_;
            if (++row_.y == size_y_) {
                row_.y = 0;
                if (++row_.z == size_z_) row_.z = 0, ++row_.w;
            }
            return *this;
        }
        bool operator!=(std::default_sentinel_t) const { return left_ != 0; }

    private:
        Row row_;
        uint size_y_, size_z_;
        std::size_t left_;
    };
    Iterator begin() const { return Iterator(*this); }
    std::default_sentinel_t end() const { return {}; }

private:
    Row first_;
    uint size_y_, size_z_;
    std::size_t count_;
};

namespace detail {

/// Work for one task: enough to pay for starting it, little enough to share evenly.
inline constexpr std::size_t task_elements = 1 << 14;

/// Calls `run(body, begin, end)` for parts of [0, count) that together cover it once, in parallel, none shorter than
/// half of `grain`. In the runtime: oneTBB's headers take longer to compile than most kernels.
GLIFT_API void spread(std::size_t count, std::size_t grain, void (*run)(const void* body, std::size_t, std::size_t),
                      const void* body);

/// How many threads `spread` uses at most.
GLIFT_API std::size_t thread_count();

/// The same with a function object that takes (begin, end).
template <class Body> void spread(std::size_t count, std::size_t grain, const Body& body) {
    const auto run = [](const void* called, std::size_t begin, std::size_t end) {
        (*static_cast<const Body*>(called))(begin, end);
    };
    spread(count, grain, run, &body);
}

/// The same, with a function object, part by part: a part is begun once all before it are.
template <class Body> void spread_in_order(std::size_t count, std::size_t grain, const Body& body) {
    const std::size_t parts = (count + grain - 1) / grain;
    std::atomic<std::size_t> next{0};
    const auto take_parts = [&](std::size_t, std::size_t) {
        for (std::size_t part = next++; part < parts; part = next++)
            body(part * grain, std::min((part + 1) * grain, count));
    };
    spread(std::min(parts, thread_count()), 1, take_parts);
}

}  // namespace detail

/// Calls `body(const Rows&)` for rows that together cover `size` once. Blocks of rows run in parallel.
template <class Body> void for_rows(const std::array<std::uint32_t, 4>& size, const Body& body) {
    const std::size_t rows = std::size_t{size[1]} * size[2] * size[3];
    if (rows == 0 || size[0] == 0) return;
    const auto run = [&](uint begin, uint end, std::size_t first, std::size_t count) {
        const Row row{begin, end, static_cast<uint>(first % size[1]), static_cast<uint>(first / size[1] % size[2]),
                      static_cast<uint>(first / size[1] / size[2])};
        body(Rows(row, count, size));
    };
    const std::size_t all = rows * size[0];
    if (rows == 1 || size[0] > 16 * detail::task_elements) {  // long rows: split them
        const std::size_t pieces = (size[0] + detail::task_elements - 1) / detail::task_elements;
        const auto piece = [&](std::size_t i) {
            const std::size_t begin = i % pieces * detail::task_elements;
            const std::size_t end = std::min<std::size_t>(begin + detail::task_elements, size[0]);
            run(static_cast<uint>(begin), static_cast<uint>(end), i / pieces, 1);
        };
        detail::spread(rows * pieces, 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) piece(i);
        });
        return;
    }
    if (all <= detail::task_elements) return run(0, size[0], 0, rows);
    const std::size_t grain = std::max<std::size_t>(1, detail::task_elements / size[0]);
    detail::spread(rows, grain, [&](std::size_t first, std::size_t last) { run(0, size[0], first, last - first); });
}

/// Calls `body(const Rows&)` for parts of one row that together cover `size` elements, `items` to an invocation, once.
/// Later invocations do not begin before earlier ones: what looks back at them finds them at work.
template <class Body> void for_strides(std::uint32_t size, std::uint32_t items, const Body& body) {
    const std::array<std::uint32_t, 4> count = {static_cast<std::uint32_t>((std::uint64_t{size} + items - 1) / items),
                                                1, 1, 1};
    const std::size_t grain = std::max<std::size_t>(1, detail::task_elements / items);
    detail::spread_in_order(count[0], grain, [&](std::size_t begin, std::size_t end) {
        body(Rows({static_cast<uint>(begin), static_cast<uint>(end), 0, 0, 0}, 1, count));
    });
}

/// Calls `body(group id, group count)` for the workgroups that cover `size`, each so many elements, in parallel.
template <class Body> void for_each_group(const std::array<std::uint32_t, 4>& size, uint3 group, const Body& body) {
    const auto div_ceil = [](std::uint64_t a, uint b) { return static_cast<uint>((a + b - 1) / b); };
    const uint3 count(div_ceil(size[0], group.x), div_ceil(size[1], group.y),
                      div_ceil(std::uint64_t{size[2]} * size[3], group.z));
    const std::size_t total = std::size_t{count.x} * count.y * count.z;
    const auto run = [&](std::size_t i) {
        body(uint3(static_cast<uint>(i % count.x), static_cast<uint>(i / count.x % count.y),
                   static_cast<uint>(i / count.x / count.y)),
             count);
    };
    if (total == 1) return run(0);
    detail::spread(total, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) run(i);
    });
}

/// What elements are made of: themselves, or a vector's components.
template <class T> struct NumberOf { using type = T; };
template <class T, unsigned N> struct NumberOf<vec<T, N>> { using type = T; };
template <class T> using RowOf = vec<typename NumberOf<std::remove_const_t<T>>::type, 4>;

/// Numbers 4 * index, … of a buffer as one vector, whatever an element has of them.
template <class T> RowOf<T> load_row(T* elements, std::size_t index) {
    RowOf<T> row;
    std::memcpy(&row, reinterpret_cast<const std::byte*>(elements) + index * sizeof row, sizeof row);
    return row;
}
template <class T> void store_row(T* elements, std::size_t index, const RowOf<T>& row) {
    std::memcpy(reinterpret_cast<std::byte*>(elements) + index * sizeof row, &row, sizeof row);
}

/// The longest array that the C++ compiler takes apart, so that its numbers stay in registers.
inline constexpr unsigned longest_in_registers = 16;

template <unsigned N, class T> void copy_numbers(const T* from, T* to) {
    if constexpr (N > longest_in_registers) {
        std::memcpy(to, from, N * sizeof(T));
    } else {
        for (unsigned i = 0; i < N; ++i) to[i] = from[i];
    }
}

/// All of an array from or to numbers 4 * index, … of a buffer.
template <class T, unsigned N>
void load_rows(const T* elements, std::size_t index, array<typename NumberOf<T>::type, N>& numbers) {
    copy_numbers<N>(reinterpret_cast<const typename NumberOf<T>::type*>(elements) + 4 * index, numbers.values);
}
template <class T, unsigned N>
void store_rows(T* elements, std::size_t index, const array<typename NumberOf<T>::type, N>& numbers) {
    copy_numbers<N>(numbers.values, reinterpret_cast<typename NumberOf<T>::type*>(elements) + 4 * index);
}

/// The elements of a buffer.
template <class T> T* elements(const HostMemory& memory) { return reinterpret_cast<T*>(memory.data); }

/// Whether `count` elements from `first` on all lie before `extent`.
inline bool fits(uint first, uint count, uint extent) { return count <= extent && first <= extent - count; }

/// Elements [begin, end) of a row along x.
struct Part {
    uint begin, end;
};

/// The part of a row's [begin, end) that is at least `radius` away from every side of `domain`. `first` is the address
/// of the range's first element; axes that the range does not have are 1 long in `domain` and not looked at.
template <unsigned N>
Part interior_of(const Row& row, const vec<uint, N>& first, const vec<uint, N>& domain, uint radius) {
    const auto inside = [radius](uint a, uint n) { return a >= radius && n > radius && a < n - radius; };
    bool rest = inside(first.y + row.y, domain.y);
    if constexpr (N > 2) rest = rest && inside(first.z + row.z, domain.z);
    if constexpr (N > 3) rest = rest && inside(first.w + row.w, domain.w);
    if (!rest || domain.x <= radius) return {row.end, row.end};
    const uint low = radius > first.x ? radius - first.x : 0;
    const uint past = domain.x - radius;
    const uint high = past > first.x ? past - first.x : 0;
    const uint begin = std::clamp(low, row.begin, row.end);
    return {begin, std::clamp(high, begin, row.end)};
}
inline Part interior_of(const Row& row, uint first, uint domain, uint radius) {
    const Row flat{row.begin, row.end, 0, 0, 0};
    return interior_of(flat, uint2{first, radius}, uint2{domain, 2 * radius + 1}, radius);
}

/// The part of a row where values that advance by one all stay within their bounds.
class Unclamped {
public:
    /// A value that is `value` at the row's first element.
    void keep(std::int32_t value, std::int32_t low, std::int32_t high) {
        from_ = std::max(from_, std::int64_t{low} - value);
        to_ = std::min(to_, std::int64_t{high} - value + 1);
    }
    Part of(uint begin, uint end) const {
        const std::int64_t count = std::int64_t{end} - begin;
        const std::int64_t from = std::min(from_, count), to = std::max(from, std::min(to_, count));
        return {begin + static_cast<uint>(from), begin + static_cast<uint>(to)};
    }

private:
    std::int64_t from_ = 0, to_ = INT64_MAX;
};

/// Elements that are worked on together: a vector of the widest kind, or a few narrow ones. What is left over at the
/// end of a part is not worked on one by one: the last block overlaps the one before it.
inline constexpr std::size_t block_elements = 16;

/// The part where it has a block, else nothing, at `end`.
inline Part in_blocks(const Part& part, uint end) {
    return part.end - part.begin < block_elements ? Part{end, end} : part;
}

/// A part of a row: its middle, or what lies before or after.
struct Section {
    uint begin, end;
    bool is_middle;
};

/// In the order of their addresses.
inline std::array<Section, 3> sections(uint begin, const Part& middle, uint end) {
    return {Section{begin, middle.begin, false}, Section{middle.begin, middle.end, true},
            Section{middle.end, end, false}};
}

/// The pointer, and nothing known of where it came from: so it stays in a register of its own in the loop that follows,
/// where the compiler would compute it anew for each element from all that it was computed from.
template <class T> T* row_pointer(T* pointer) {
#if defined(__GNUC__)
    asm("" : "+r"(pointer));
#endif
    return pointer;
}

// ---------------------------------------------------------------------------------- scatter: combine with what is
// there

template <class T> void atomic_replace(T& target, T value) {
    std::atomic_ref<T>(target).store(value, std::memory_order_relaxed);
}

template <class T, class Combine> T atomic_update(T& target, const Combine& combine) {
    std::atomic_ref<T> shared(target);
    T old = shared.load(std::memory_order_relaxed);
    while (!shared.compare_exchange_weak(old, combine(old), std::memory_order_relaxed)) {}
    return old;
}
template <class T> void atomic_min(T& target, T value) {
    std::atomic_ref<T> shared(target);
    T old = shared.load(std::memory_order_relaxed);
    while (value < old && !shared.compare_exchange_weak(old, value, std::memory_order_relaxed)) {}
}
template <class T> void atomic_max(T& target, T value) {
    std::atomic_ref<T> shared(target);
    T old = shared.load(std::memory_order_relaxed);
    while (old < value && !shared.compare_exchange_weak(old, value, std::memory_order_relaxed)) {}
}
template <class T> void atomic_add(T& target, T value) {
    std::atomic_ref<T>(target).fetch_add(value, std::memory_order_relaxed);
}
template <class T> void atomic_bit_and(T& target, T value) {
    std::atomic_ref<T>(target).fetch_and(value, std::memory_order_relaxed);
}
template <class T> void atomic_bit_or(T& target, T value) {
    std::atomic_ref<T>(target).fetch_or(value, std::memory_order_relaxed);
}
template <class T> void atomic_bit_xor(T& target, T value) {
    std::atomic_ref<T>(target).fetch_xor(value, std::memory_order_relaxed);
}

// Atomics on workgroup memory. A workgroup runs on one thread, one invocation after the other.
template <class T> T atomicLoad(const T& target) { return target; }
template <class T> void atomicStore(T& target, T value) { target = value; }
template <class T> T atomicAdd(T& target, T value) { return std::exchange(target, glift::detail::add(target, value)); }
template <class T> T atomicMin(T& target, T value) { return std::exchange(target, value < target ? value : target); }
template <class T> T atomicMax(T& target, T value) { return std::exchange(target, target < value ? value : target); }
template <class T> T atomicAnd(T& target, T value) { return std::exchange(target, static_cast<T>(target & value)); }
template <class T> T atomicOr(T& target, T value) { return std::exchange(target, static_cast<T>(target | value)); }
template <class T> T atomicXor(T& target, T value) { return std::exchange(target, static_cast<T>(target ^ value)); }
template <class T> T atomicExchange(T& target, T value) { return std::exchange(target, value); }

// Memory that workgroups share within a pass.
namespace memory {

/// What an element moves by in one piece: all of a number, else as much as its alignment allows.
template <class T> using Piece =
    std::conditional_t<std::is_arithmetic_v<T>, T,
                       std::conditional_t<alignof(T) % sizeof(std::uint32_t) == 0, std::uint32_t, unsigned char>>;

/// Reads from memory itself each time, whatever others write meanwhile.
template <class T> T read(T& place) {
    using P = Piece<T>;
    alignas(T) P pieces[sizeof(T) / sizeof(P)];
    for (std::size_t i = 0; i < std::size(pieces); ++i)
        pieces[i] = std::atomic_ref<P>(reinterpret_cast<P*>(&place)[i]).load(std::memory_order_relaxed);
    return std::bit_cast<T>(pieces);
}

template <class T> void write(T& place, const std::type_identity_t<T>& value) {
    using P = Piece<T>;
    for (std::size_t i = 0; i < sizeof(T) / sizeof(P); ++i)
        std::atomic_ref<P>(reinterpret_cast<P*>(&place)[i])
            .store(reinterpret_cast<const P*>(&value)[i], std::memory_order_relaxed);
}

// Atomics: what is read and written around them is ordered.
template <class T> T atomicLoad(T& target) { return std::atomic_ref<T>(target).load(std::memory_order_acquire); }
template <class T> void atomicStore(T& target, T value) {
    std::atomic_ref<T>(target).store(value, std::memory_order_release);
}
template <class T> T atomicAdd(T& target, T value) { return std::atomic_ref<T>(target).fetch_add(value); }
template <class T> T atomicAnd(T& target, T value) { return std::atomic_ref<T>(target).fetch_and(value); }
template <class T> T atomicOr(T& target, T value) { return std::atomic_ref<T>(target).fetch_or(value); }
template <class T> T atomicXor(T& target, T value) { return std::atomic_ref<T>(target).fetch_xor(value); }
template <class T> T atomicExchange(T& target, T value) { return std::atomic_ref<T>(target).exchange(value); }
template <class T> T atomicMin(T& target, T value) {
    std::atomic_ref<T> shared(target);
    T before = shared.load();
    while (value < before && !shared.compare_exchange_weak(before, value)) {}
    return before;
}
template <class T> T atomicMax(T& target, T value) {
    std::atomic_ref<T> shared(target);
    T before = shared.load();
    while (before < value && !shared.compare_exchange_weak(before, value)) {}
    return before;
}
}  // namespace memory

}  // namespace glift::host
