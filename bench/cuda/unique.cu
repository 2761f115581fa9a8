// Finds the first element of each run of equal elements, and the runs' lengths; for runs of 1, 8 and 256 elements.
#include "rivals.cuh"

#include <cub/device/device_run_length_encode.cuh>
#include <cub/device/device_select.cuh>

namespace rivals {

namespace {

struct Runs {
    std::vector<std::uint32_t> values, lengths;
};

Runs expected_runs(std::size_t count, Hashed input) {
    Runs runs;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t value = input(i);
        if (runs.values.empty() || runs.values.back() != value) {
            runs.values.push_back(value);
            runs.lengths.push_back(0);
        }
        ++runs.lengths.back();
    }
    return runs;
}

void measure(Bench& bench, std::size_t count, Hashed input) {
    const DeviceArray<std::uint32_t> x(count), values(count), lengths(count), number(1);
    x.fill(input);
    const auto items = static_cast<int>(count);
    const Work unique = with_workspace([&, items](void* workspace, std::size_t& bytes) {
        return cub::DeviceSelect::Unique(workspace, bytes, x.data(), values.data(), number.data(), items);
    });
    const Work encode = with_workspace([&, items](void* workspace, std::size_t& bytes) {
        return cub::DeviceRunLengthEncode::Encode(workspace, bytes, x.data(), values.data(), lengths.data(),
                                                  number.data(), items);
    });
    if (bench.checks(count)) {
        const Runs expected = expected_runs(count, input);
        unique();
        require_equal("unique", values.first(number.front()), expected.values);
        values.poison();
        encode();
        require_equal("run-length encoding: values", values.first(number.front()), expected.values);
        require_equal("run-length encoding: lengths", lengths.first(number.front()), expected.lengths);
    }
    const std::string variant = "runs_" + std::to_string(input.run_length);
    const std::uint64_t runs = (count + input.run_length - 1) / input.run_length;
    bench.time("unique", variant, count, 4 * count + 4 * runs, unique);
    bench.time("run_length", variant, count, 4 * count + 8 * runs, encode);
}

}  // namespace

void unique(Bench& bench) {
    for (std::size_t count : bench.sizes()) {
        for (std::uint32_t run_length : {1u, 8u, 256u}) measure(bench, count, Hashed{run_length});
    }
}

}  // namespace rivals
