#include "host_rivals.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_reduce.h>
#include <oneapi/tbb/parallel_scan.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <functional>
#include <numeric>
#include <vector>

#define FOR_EACH_VECTOR_WIDTH __attribute__((target_clones("default", "avx2", "avx512f")))

namespace host_rivals {

namespace {

using Words = std::span<const std::uint32_t>;
using Range = tbb::blocked_range<std::size_t>;

constexpr std::size_t grain = std::size_t{1} << 16;  // oneTBB splits larger ranges only; also the size of a block

// The loops. Those that sum or count are compiled with function multiversioning (`Wide`) and without (`Narrow`), the
// others only without.

inline std::uint32_t sum_elements(const std::uint32_t* x, std::size_t count) {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += x[i];
    return sum;
}

// Sixteen independent sums: a single one would be limited by the latency of additions.
inline float sum_elements(const float* x, std::size_t count) {
    constexpr std::size_t lanes = 16;
    float sums[lanes] = {};
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        for (std::size_t k = 0; k < lanes; ++k) sums[k] += x[i + k];
    }
    for (; i < count; ++i) sums[i % lanes] += x[i];
    float sum = 0;
    for (float one : sums) sum += one;
    return sum;
}

// Four elements per round, so that the loop-carried dependency (`run`) is one addition for four elements: its latency
// is the bottleneck.
inline std::uint32_t scan_elements(const std::uint32_t* x, std::size_t count, std::uint32_t run, std::uint32_t* y) {
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        const std::uint32_t a = x[i], b = a + x[i + 1], c = b + x[i + 2], d = c + x[i + 3];
        y[i] = run;
        y[i + 1] = run + a;
        y[i + 2] = run + b;
        y[i + 3] = run + c;
        run += d;
    }
    for (; i < count; ++i) {
        const std::uint32_t value = x[i];  // y may be x
        y[i] = run;
        run += value;
    }
    return run;
}

inline bool is_kept(std::uint32_t value) { return value % 8 == 0; }

inline std::size_t count_elements(const std::uint32_t* x, std::size_t count) {
    std::uint32_t kept = 0;  // 32 bits are enough for a block
    for (std::size_t i = 0; i < count; ++i) kept += is_kept(x[i]);
    return kept;
}

// Function multiversioning, as in the generated code.
struct Wide {
    FOR_EACH_VECTOR_WIDTH static std::uint32_t sum(const std::uint32_t* x, std::size_t count) {
        return sum_elements(x, count);
    }
    FOR_EACH_VECTOR_WIDTH static float sum(const float* x, std::size_t count) { return sum_elements(x, count); }
    FOR_EACH_VECTOR_WIDTH static std::size_t count(const std::uint32_t* x, std::size_t count) {
        return count_elements(x, count);
    }
};

struct Narrow {
    static std::uint32_t sum(const std::uint32_t* x, std::size_t count) { return sum_elements(x, count); }
    static float sum(const float* x, std::size_t count) { return sum_elements(x, count); }
    static std::size_t count(const std::uint32_t* x, std::size_t count) { return count_elements(x, count); }
};

template <class Loops> std::uint32_t exclusive_scan_with(Words x, std::span<std::uint32_t> y) {
    const auto scan = [&](const Range& range, std::uint32_t before, bool is_final) {
        if (!is_final) return before + Loops::sum(x.data() + range.begin(), range.size());
        return scan_elements(x.data() + range.begin(), range.size(), before, y.data() + range.begin());
    };
    return tbb::parallel_scan(Range(0, x.size(), grain), 0u, scan, std::plus<>());
}

template <class Loops> std::uint32_t sum_with(Words x) {
    const auto add = [&](const Range& range, std::uint32_t before) {
        return before + Loops::sum(x.data() + range.begin(), range.size());
    };
    return tbb::parallel_reduce(Range(0, x.size(), grain), 0u, add, std::plus<>());
}

template <class Loops> float sum_with(std::span<const float> x) {
    const auto add = [&](const Range& range, float before) {
        return before + Loops::sum(x.data() + range.begin(), range.size());
    };
    return tbb::parallel_deterministic_reduce(Range(0, x.size(), grain), 0.0f, add, std::plus<>());
}

/// Copies the kept elements of a block to y, and returns their number. Without branches: each element is written to the
/// end of a small buffer; the end advances if the element is kept.
std::size_t copy_block(const std::uint32_t* x, std::size_t count, std::uint32_t* y) {
    constexpr std::size_t room = 1024;
    std::uint32_t buffer[room + 1];
    std::uint32_t* const start = y;
    for (std::size_t base = 0; base < count; base += room) {
        const std::size_t end = std::min(base + room, count);
        std::size_t kept = 0;
        for (std::size_t i = base; i < end; ++i) {
            buffer[kept] = x[i];
            kept += is_kept(x[i]);
        }
        std::memcpy(y, buffer, kept * sizeof *y);
        y += kept;
    }
    return static_cast<std::size_t>(y - start);
}

template <class Loops> std::size_t copy_multiples_with(Words x, std::span<std::uint32_t> y) {
    const std::size_t blocks = (x.size() + grain - 1) / grain;
    const auto size_of = [&](std::size_t block) { return std::min(grain, x.size() - block * grain); };
    std::vector<std::size_t> offsets(blocks + 1);
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
        offsets[block] = Loops::count(x.data() + block * grain, size_of(block));
    });
    std::exclusive_scan(offsets.begin(), offsets.end(), offsets.begin(), std::size_t{0});
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
        copy_block(x.data() + block * grain, size_of(block), y.data() + offsets[block]);
    });
    return offsets.back();
}

}  // namespace

std::uint32_t exclusive_scan(Words x, std::span<std::uint32_t> y) { return exclusive_scan_with<Wide>(x, y); }
std::uint32_t exclusive_scan_narrow(Words x, std::span<std::uint32_t> y) { return exclusive_scan_with<Narrow>(x, y); }

std::uint32_t sum(Words x) { return sum_with<Wide>(x); }
std::uint32_t sum_narrow(Words x) { return sum_with<Narrow>(x); }

float sum(std::span<const float> x) { return sum_with<Wide>(x); }
float sum_narrow(std::span<const float> x) { return sum_with<Narrow>(x); }

std::size_t copy_multiples_of_8(Words x, std::span<std::uint32_t> y) { return copy_multiples_with<Wide>(x, y); }
std::size_t copy_multiples_of_8_narrow(Words x, std::span<std::uint32_t> y) {
    return copy_multiples_with<Narrow>(x, y);
}

void sort(std::span<std::uint32_t> keys) { tbb::parallel_sort(keys.begin(), keys.end()); }

void sort(std::span<KeyValue> pairs) {
    tbb::parallel_sort(pairs.begin(), pairs.end(),
                       [](const KeyValue& one, const KeyValue& other) { return one.key < other.key; });
}

}  // namespace host_rivals
