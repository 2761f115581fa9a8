// How host kernels run on several cores: parallel loops over parts of an iteration, and vectors within a row. Kept
// small: every kernel source includes it.
#pragma once

#include <glift/api.h>
#include <glift/kernel.h>
#include <glift/vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "kernels have the same results on every device: compile this file with -fno-fast-math -fno-finite-math-only"
#endif

// Function multiversioning: GCC compiles the function once for each of these instruction sets, and the dynamic linker
// picks the version with the widest vectors that the CPU has. Where the condition below does not hold, the function is
// compiled once.
#if !defined(GLIFT_HOST_KERNEL)
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__linux__) && defined(__OPTIMIZE__) &&  \
    !defined(__AVX2__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GLIFT_HOST_KERNEL __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define GLIFT_HOST_KERNEL
#endif
#endif

// Placed before a loop without dependences between its iterations.
#if defined(__clang__)
#define GLIFT_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define GLIFT_INDEPENDENT _Pragma("GCC ivdep")
#else
#define GLIFT_INDEPENDENT
#endif

// The same for a short loop: over `block_elements` elements, or over a row of a block of a structure
// (docs/reference/language.md, Blocks). GCC is told not to unroll such a loop, since it could not vectorise it
// afterwards.
#if defined(__clang__)
#define GLIFT_BLOCK _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define GLIFT_BLOCK _Pragma("GCC ivdep") _Pragma("GCC unroll 1")
#else
#define GLIFT_BLOCK
#endif

namespace glift::host {

// In place of std::min and std::max, since <algorithm> takes longer to compile than this header.
namespace detail {
template <class T> constexpr T least(T a, T b) { return b < a ? b : a; }
template <class T> constexpr T most(T a, T b) { return a < b ? b : a; }
}  // namespace detail

/// Elements [begin, end) along x of the row at y, z, w.
struct Row {
    uint begin, end;
    uint y, z, w;
};

/// Consecutive rows, all with the same begin and end.
class Rows {
public:
    Rows(const Row& first, std::size_t count, const std::array<std::uint32_t, 4>& size)
        : first_(first), size_y_(size[1]), size_z_(size[2]), count_(count) {}
    /// Rows that differ along z alone.
    static Rows along_z(const Row& first, std::size_t count) {
        Rows rows(first, count, {0, first.y + 1, UINT32_MAX, 1});
        rows.first_y_ = first.y;
        return rows;
    }

    struct End {};
    class Iterator {
    public:
        explicit Iterator(const Rows& rows)
            : row_(rows.first_), first_y_(rows.first_y_), size_y_(rows.size_y_), size_z_(rows.size_z_),
              left_(rows.count_) {}
        Row operator*() const { return row_; }
        Iterator& operator++() {
            --left_;
            if (++row_.y == size_y_) {
                row_.y = first_y_;
                if (++row_.z == size_z_) row_.z = 0, ++row_.w;
            }
            return *this;
        }
        bool operator!=(End) const { return left_ != 0; }

    private:
        Row row_;
        uint first_y_, size_y_, size_z_;
        std::size_t left_;
    };
    Iterator begin() const { return Iterator(*this); }
    End end() const { return {}; }

private:
    Row first_;
    uint first_y_ = 0, size_y_, size_z_;
    std::size_t count_;
};

namespace detail {

/// Elements of one task: enough to amortise its start, few enough to balance the load.
inline constexpr std::size_t task_elements = 1 << 14;

/// Calls `run(body, begin, end)` in parallel for parts that partition [0, count), none shorter than half of `grain`
/// unless `count` is. Defined in the runtime, since oneTBB's headers take longer to compile than most kernels.
GLIFT_API void spread(std::size_t count, std::size_t grain, void (*run)(const void* body, std::size_t, std::size_t),
                      const void* body);

/// How many threads `spread` uses at most.
GLIFT_API std::size_t thread_count();

/// `spread` with a function object that takes (begin, end).
template <class Body> void spread(std::size_t count, std::size_t grain, const Body& body) {
    const auto run = [](const void* called, std::size_t begin, std::size_t end) {
        (*static_cast<const Body*>(called))(begin, end);
    };
    spread(count, grain, run, &body);
}

/// Like `spread`, but for parts of `grain` (the last one may be shorter) that start in order: none before all earlier
/// ones have started.
GLIFT_API void spread_in_order(std::size_t count, std::size_t grain,
                               void (*run)(const void* body, std::size_t, std::size_t), const void* body);

template <class Body> void spread_in_order(std::size_t count, std::size_t grain, const Body& body) {
    const auto run = [](const void* called, std::size_t begin, std::size_t end) {
        (*static_cast<const Body*>(called))(begin, end);
    };
    spread_in_order(count, grain, run, &body);
}

}  // namespace detail

/// Calls `body(const Rows&)` in parallel for groups of rows, or parts of long rows, that partition `size`. A task has
/// about `task` elements.
template <class Body> void for_rows(const HostSize& size, const Body& body, std::size_t task = detail::task_elements) {
    const std::size_t all_rows = std::size_t{size[1]} * size[2] * size[3], before = size.rows_before();
    const uint left = size.first_along(0);
    if (all_rows <= before || size[0] <= left) return;
    const std::size_t rows = all_rows - before, length = size[0] - left;
    const auto run = [&](uint begin, uint end, std::size_t first, std::size_t count) {
        first += before;
        const Row row{begin, end, static_cast<uint>(first % size[1]), static_cast<uint>(first / size[1] % size[2]),
                      static_cast<uint>(first / size[1] / size[2])};
        body(Rows(row, count, size));
    };
    const std::size_t all = rows * length;
    if (rows == 1 || length > 16 * detail::task_elements) {  // long rows: split them
        const std::size_t pieces = (length + task - 1) / task;
        detail::spread(rows * pieces, 1, [&](std::size_t first, std::size_t last) {
            while (first < last) {  // the pieces of one row at once
                const std::size_t row = first / pieces, next = detail::least(last, (row + 1) * pieces);
                const std::size_t end = (next - row * pieces) * task;
                run(static_cast<uint>(left + first % pieces * task),
                    static_cast<uint>(left + detail::least<std::size_t>(end, length)), row, 1);
                first = next;
            }
        });
        return;
    }
    if (all <= task) return run(left, size[0], 0, rows);
    const std::size_t grain = detail::most<std::size_t>(1, task / length);
    detail::spread(rows, grain, [&](std::size_t first, std::size_t last) { run(left, size[0], first, last - first); });
}

/// Like for_rows, but for tiles: 32 elements along x, and 32 rows along `axis` (1: y, 2: z). If an address exchanges
/// these two axes, the rows of a tile share the cache lines that each of them accesses with a stride.
template <unsigned axis, class Body> void for_tiles(const HostSize& size, const Body& body) {
    static_assert(axis == 1 || axis == 2);
    constexpr std::size_t side = 32;
    if (size[axis] <= size.first_along(axis) || size[3 - axis] <= size.first_along(3 - axis)) return;
    if (size[3] <= size.first_along(3)) return;
    const std::size_t columns = (size[0] + side - 1) / side;
    const std::size_t bands = (size[axis] - size.first_along(axis) + side - 1) / side;
    const std::size_t other = size[3 - axis] - size.first_along(3 - axis);
    const auto run = [&](std::size_t i) {
        const std::size_t x = i % columns * side, band = i / columns % bands * side, rest = i / columns / bands;
        const uint begin = static_cast<uint>(x), end = static_cast<uint>(detail::least<std::size_t>(x + side, size[0]));
        const uint first = static_cast<uint>(band) + size.first_along(axis);
        const uint last = static_cast<uint>(detail::least<std::size_t>(first + side, size[axis]));
        const uint fixed = static_cast<uint>(rest % other) + size.first_along(3 - axis);
        const uint w = static_cast<uint>(rest / other) + size.first_along(3);
        if constexpr (axis == 1) {
            body(Rows({begin, end, first, fixed, w}, last - first, size));
        } else {
            for (uint z = first; z < last; ++z) body(Rows({begin, end, fixed, z, w}, 1, size));
        }
    };
    detail::spread(columns * bands * other * (size[3] - size.first_along(3)), detail::task_elements / (side * side),
                   [&](std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i) run(i);
                   });
}

/// Calls `body(const Rows&)` in parallel for parts of one row of invocations. Each invocation takes `items` consecutive
/// elements; all together take `size`. Invocations start in order, so that one which waits for its predecessors
/// (decoupled look-back) finds them running or done.
template <class Body> void for_strides(std::uint32_t size, std::uint32_t items, const Body& body) {
    const std::array<std::uint32_t, 4> count = {static_cast<std::uint32_t>((std::uint64_t{size} + items - 1) / items),
                                                1, 1, 1};
    const std::size_t grain = detail::most<std::size_t>(1, detail::task_elements / items);
    detail::spread_in_order(count[0], grain, [&](std::size_t begin, std::size_t end) {
        body(Rows({static_cast<uint>(begin), static_cast<uint>(end), 0, 0, 0}, 1, count));
    });
}

/// Calls `body(group id, group count)` in parallel for the workgroups of `group` elements that cover `size`, whose axes
/// z and w count as one.
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

/// The scalar type of an element that is a scalar or a vector.
template <class T> struct NumberOf { using type = T; };
template <class T, unsigned N> struct NumberOf<vec<T, N>> { using type = T; };
template <class T> using RowOf = vec<typename NumberOf<std::remove_const_t<T>>::type, 4>;

/// Scalars [4 * index, 4 * index + 4) of a buffer as one vector, however many of them an element has.
template <class T> RowOf<T> load_row(T* elements, std::size_t index) {
    RowOf<T> row;
    std::memcpy(&row, reinterpret_cast<const std::byte*>(elements) + index * sizeof row, sizeof row);
    return row;
}
template <class T> void store_row(T* elements, std::size_t index, const RowOf<T>& row) {
    std::memcpy(reinterpret_cast<std::byte*>(elements) + index * sizeof row, &row, sizeof row);
}

/// Up to this many elements, the C++ compiler splits an array into scalars and keeps them in registers.
inline constexpr unsigned longest_in_registers = 16;

template <unsigned N, class T> void copy_numbers(const T* from, T* to) {
    if constexpr (N > longest_in_registers) {
        std::memcpy(to, from, N * sizeof(T));
    } else {
        for (unsigned i = 0; i < N; ++i) to[i] = from[i];
    }
}

/// Copies all N numbers of an array from or to a buffer, where they are the scalars [4 * index, 4 * index + N).
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

/// Elements [begin, end) of a row along x.
struct Part {
    uint begin, end;
};

/// The part of a row's [begin, end) that is at least `radius` away from every side of `domain`. `first` is the address
/// of the range's first element.
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
    const uint begin = detail::least(detail::most(low, row.begin), row.end);
    return {begin, detail::least(detail::most(high, begin), row.end)};
}
inline Part interior_of(const Row& row, uint first, uint domain, uint radius) {
    const Row flat{row.begin, row.end, 0, 0, 0};
    return interior_of(flat, uint2{first, radius}, uint2{domain, 2 * radius + 1}, radius);
}

/// The part of a row where no clamp changes its operand, for operands that grow by one with each element.
class Unclamped {
public:
    /// Adds an operand that is `value` at the row's first element and is clamped to [low, high].
    void keep(std::int32_t value, std::int32_t low, std::int32_t high) {
        from_ = detail::most(from_, std::int64_t{low} - value);
        to_ = detail::least(to_, std::int64_t{high} - value + 1);
    }
    Part of(uint begin, uint end) const {
        const std::int64_t count = std::int64_t{end} - begin;
        const std::int64_t from = detail::least(from_, count), to = detail::most(from, detail::least(to_, count));
        return {begin + static_cast<uint>(from), begin + static_cast<uint>(to)};
    }

private:
    std::int64_t from_ = 0, to_ = INT64_MAX;
};

/// An array for the values in and around one block of a structure (docs/reference/language.md, Blocks). Not
/// initialised; indices are not checked.
template <class T, std::size_t N> struct Scratch {
    alignas(64) T values[N];

    T& operator[](std::size_t i) { return values[i]; }
    const T& operator[](std::size_t i) const { return values[i]; }
};

/// Copies N consecutive numbers from memory to an array. By memcpy, since a loop would be vectorised only with a proof,
/// or a check at run time, that the two do not overlap.
template <std::size_t N, class T> void copy_row(const T* from, T* to) {
    std::memcpy(static_cast<void*>(to), from, N * sizeof(T));
}

/// Parts of rows whose elements may be computed twice are computed in blocks of this many elements: of 32-bit elements,
/// one vector of the widest kind or a few narrow ones. Such a part has no scalar remainder: where its length is no
/// multiple of this, its last block overlaps the one before it. Parts shorter than a block are computed otherwise.
inline constexpr std::size_t block_elements = 16;

/// The first element of a block in a part of `count` elements; `count` is at least block_elements. `block`, a multiple
/// of block_elements, is where the block would begin; the last block is moved back so that it ends with the part.
inline std::size_t begin_of_block(std::size_t block, std::size_t count) {
    return detail::least(block, count - block_elements);
}

/// The part if it has at least block_elements elements, else an empty one at `end`.
inline Part in_blocks(const Part& part, uint end) {
    return part.end - part.begin < block_elements ? Part{end, end} : part;
}

/// A part of a row: its middle, or the rest before or after it.
struct Section {
    uint begin, end;
    bool is_middle;
};

/// The sections of [begin, end), in the order of their addresses.
inline std::array<Section, 3> sections(uint begin, const Part& middle, uint end) {
    return {Section{begin, middle.begin, false}, Section{middle.begin, middle.end, true},
            Section{middle.end, end, false}};
}

/// Hides from the optimiser how the pointer was computed, so that it stays in a register through the loop that follows
/// instead of being computed anew for each element.
template <class T> T* row_pointer(T* pointer) {
#if defined(__GNUC__)
    asm("" : "+r"(pointer));
#endif
    return pointer;
}

// Atomics on workgroup memory. A workgroup runs on one thread, between two barriers one invocation after the other.
template <class T> T atomicLoad(const T& target) { return target; }
template <class T> void atomicStore(T& target, T value) { target = value; }
template <class T> T atomicAdd(T& target, T value) { return std::exchange(target, glift::detail::add(target, value)); }
template <class T> T atomicMin(T& target, T value) { return std::exchange(target, value < target ? value : target); }
template <class T> T atomicMax(T& target, T value) { return std::exchange(target, target < value ? value : target); }
template <class T> T atomicAnd(T& target, T value) { return std::exchange(target, static_cast<T>(target & value)); }
template <class T> T atomicOr(T& target, T value) { return std::exchange(target, static_cast<T>(target | value)); }
template <class T> T atomicXor(T& target, T value) { return std::exchange(target, static_cast<T>(target ^ value)); }
template <class T> T atomicExchange(T& target, T value) { return std::exchange(target, value); }
template <class T> T atomicCompareExchange(T& target, T expected, T value) {
    const T before = target;
    if (before == expected) target = value;
    return before;
}

}  // namespace glift::host
