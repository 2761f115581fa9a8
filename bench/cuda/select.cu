// Keeps about one element in eight: selected by an array of 8-bit flags, and by a predicate.
#include "rivals.cuh"

#include <cub/device/device_select.cuh>

#include <algorithm>
#include <iterator>

namespace rivals {

namespace {

struct IsKept {
    __host__ __device__ bool operator()(std::uint32_t value) const { return value % 8 == 0; }
};

struct Flags {
    __host__ __device__ std::uint8_t operator()(std::size_t i) const { return IsKept{}(Hashed{}(i)); }
};

void require_right(const char* what, const Work& run, const DeviceArray<std::uint32_t>& y,
                   const DeviceArray<std::uint32_t>& number, std::size_t count) {
    y.poison();
    run();
    const std::vector<std::uint32_t> values = on_host<std::uint32_t>(count, Hashed{});
    std::vector<std::uint32_t> expected;
    std::copy_if(values.begin(), values.end(), std::back_inserter(expected), IsKept{});
    require_equal(what, y.first(number.front()), expected);
}

}  // namespace

void select(Bench& bench) {
    for (std::size_t count : bench.sizes()) {
        const DeviceArray<std::uint32_t> x(count), y(count), number(1);
        const DeviceArray<std::uint8_t> flags(count);
        x.fill(Hashed{});
        flags.fill(Flags{});
        const auto items = static_cast<int>(count);
        const Work flagged = with_workspace([&, items](void* workspace, std::size_t& bytes) {
            return cub::DeviceSelect::Flagged(workspace, bytes, x.data(), flags.data(), y.data(), number.data(), items);
        });
        const Work by_predicate = with_workspace([&, items](void* workspace, std::size_t& bytes) {
            return cub::DeviceSelect::If(workspace, bytes, x.data(), y.data(), number.data(), items, IsKept{});
        });
        if (bench.checks(count)) {
            require_right("select flagged", flagged, y, number, count);
            require_right("select if", by_predicate, y, number, count);
        }
        by_predicate();
        const std::uint64_t moved = 4 * count + 4 * std::uint64_t{number.front()};
        bench.time("select", "flagged_1_in_8", count, moved + count, flagged);
        bench.time("select", "if_1_in_8", count, moved, by_predicate);
    }
}

}  // namespace rivals
