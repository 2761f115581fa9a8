// bench_rivals: checks the hand-written rivals of stdlib/algorithms against the C++ standard library, and times them.
//
//     bench_rivals [--device NAME] [--log2 22,24] [--host-log2 22,24] [--runs N] [--unchecked] [--json FILE]
//
// The GLSL versions ("twins") run on the device given by --device or GLIFT_DEVICE (else the best there is), which
// cannot be the host device; those in C++ run on the host. --unchecked only times.
#include "algorithm_twins.h"
#include "bench_input.h"
#include "figures.h"
#include "host_rivals.h"
#include "median.h"
#include "timing.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Words = std::vector<std::uint32_t>;

struct Options {
    std::string device, json;
    std::vector<unsigned> log2 = {22, 24}, host_log2 = {22, 24};
    int runs = 11;
    bool unchecked = false;
};

/// The memories and the GLSL versions on a device; checks read results from here.
class OnDevice {
public:
    OnDevice(const glift::Device& device, std::uint32_t most)
        : device_(device), x_(device.allocate({.name = "x", .bytes = 4ull * most})),
          y_(device.allocate({.name = "y", .bytes = 4ull * most})),
          kept_(device.allocate({.name = "kept", .bytes = 4})), scan_(device, most), compact_(device, most),
          sort_(device, most) {}

    void give(const Words& values) const {
        device_.commands().upload(x_, 0, std::as_bytes(std::span(values)));
        poison(static_cast<std::uint32_t>(values.size()));
    }
    void scan(const glift::Commands& commands, std::uint32_t count) const { scan_.record(commands, x_, y_, count); }
    void compact(const glift::Commands& commands, std::uint32_t count) const {
        compact_.record(commands, x_, y_, kept_, count);
    }
    void sort(const glift::Commands& commands, std::uint32_t count) const { sort_.record(commands, x_, y_, count); }

    Words result(std::uint32_t count) const { return words(y_, count); }
    std::uint32_t kept() const { return words(kept_, 1)[0]; }
    void poison(std::uint32_t count) const { device_.commands().fill(y_, 0, 4ull * count, 0xdeadbeefu); }

private:
    Words words(const glift::Memory& memory, std::uint32_t count) const {
        Words values(count);
        const glift::Download download = device_.commands().download(memory, 0, 4ull * count);
        if (count) std::memcpy(values.data(), download.get().data(), 4ull * count);
        return values;
    }

    glift::Device device_;
    glift::Memory x_, y_, kept_;
    bench::ScanTwin scan_;
    bench::CompactTwin compact_;
    bench::RadixSortTwin sort_;
};

struct Expected {
    Words scanned, compacted, sorted;
};

Expected expected_of(const Words& x) {
    Expected expected{x, {}, x};
    std::exclusive_scan(x.begin(), x.end(), expected.scanned.begin(), 0u);
    std::copy_if(x.begin(), x.end(), std::back_inserter(expected.compacted),
                 [](std::uint32_t value) { return value % 8 == 0; });
    std::sort(expected.sorted.begin(), expected.sorted.end());
    return expected;
}

void require(bool holds, const char* what, std::uint32_t count) {
    if (!holds)
        throw std::runtime_error(std::string(what) + ": wrong result for " + std::to_string(count) +
                                 " elements as input");
}

void check_device(const glift::Device& device, const OnDevice& on, const Words& x, const Expected& expected) {
    const auto count = static_cast<std::uint32_t>(x.size());
    on.give(x);
    on.scan(device, count);
    require(on.result(count) == expected.scanned, "scan twin", count);
    on.poison(count);
    on.compact(device, count);
    const std::uint32_t kept = on.kept();
    require(kept == expected.compacted.size() && on.result(kept) == expected.compacted, "compact twin", count);
    on.poison(count);
    on.sort(device, count);
    require(on.result(count) == expected.sorted, "radix sort twin", count);
}

using Scan = std::uint32_t (*)(std::span<const std::uint32_t>, std::span<std::uint32_t>);
using Copy = std::size_t (*)(std::span<const std::uint32_t>, std::span<std::uint32_t>);

void check_sorts(const Words& x, const Expected& expected) {
    const auto count = static_cast<std::uint32_t>(x.size());
    Words keys = x;
    host_rivals::sort(keys);
    require(keys == expected.sorted, "host sort", count);
    std::vector<host_rivals::KeyValue> pairs(count);
    for (std::uint32_t i = 0; i < count; ++i) pairs[i] = {x[i], i};
    host_rivals::sort(pairs);
    for (std::uint32_t i = 0; i < count; ++i) {
        require(pairs[i].key == expected.sorted[i] && x[pairs[i].value] == pairs[i].key, "host sort of pairs", count);
    }
}

void check_host(const Words& x, const Expected& expected) {
    const auto count = static_cast<std::uint32_t>(x.size());
    const std::uint32_t sum = std::accumulate(x.begin(), x.end(), 0u);
    for (Scan scan : {Scan(host_rivals::exclusive_scan), Scan(host_rivals::exclusive_scan_narrow)}) {
        Words y(count, 0xdeadbeefu);
        require(scan(x, y) == sum && y == expected.scanned, "host scan", count);
    }
    for (Copy copy : {Copy(host_rivals::copy_multiples_of_8), Copy(host_rivals::copy_multiples_of_8_narrow)}) {
        Words y(count, 0xdeadbeefu);
        y.resize(copy(x, y));
        require(y == expected.compacted, "host copy_if", count);
    }
    const std::span<const std::uint32_t> words = x;
    require(host_rivals::sum(words) == sum && host_rivals::sum_narrow(words) == sum, "host sum", count);
    std::vector<float> floats(count);
    for (std::uint32_t i = 0; i < count; ++i) floats[i] = static_cast<float>(x[i] >> 8) * 0x1p-24f;
    const double exact = std::accumulate(floats.begin(), floats.end(), 0.0), bound = 1e-5 * exact;
    const std::span<const float> span = floats;
    require(std::abs(host_rivals::sum(span) - exact) <= bound &&
                std::abs(host_rivals::sum_narrow(span) - exact) <= bound,
            "host sum of floats", count);
    check_sorts(x, expected);
}

/// Inputs: hashes; multiples of 8 only, which compaction keeps; no multiples of 8; keys many of which are equal.
std::vector<Words> inputs_of(std::uint32_t count) {
    Words all = bench::hashed(count), none = all, equal = all;
    for (std::uint32_t& value : all) value &= ~7u;
    for (std::uint32_t& value : none) value |= 1u;
    for (std::uint32_t& value : equal) value %= 3u;
    return {bench::hashed(count), all, none, equal};
}

void check(const glift::Device& device) {
    constexpr std::uint32_t sizes[] = {0,
                                       1,
                                       2,
                                       3,
                                       4,
                                       5,
                                       7,
                                       31,
                                       33,
                                       63,
                                       64,
                                       65,
                                       255,
                                       511,
                                       512,
                                       513,
                                       1025,
                                       2047,
                                       2048,
                                       2049,
                                       4095,
                                       4097,
                                       8191,
                                       16385,
                                       65537,
                                       100003,
                                       131071,
                                       (1u << 19) + 1023,
                                       (1u << 20) + 7,
                                       (1u << 22) + 1025};
    const OnDevice on(device, *std::max_element(std::begin(sizes), std::end(sizes)));
    for (std::uint32_t count : sizes) {
        for (const Words& x : inputs_of(count)) {
            const Expected expected = expected_of(x);
            check_device(device, on, x, expected);
            check_host(x, expected);
        }
    }
}

/// What a row of results is about: names, as in bench_algorithms (but for sum_f32, as in the CUDA rivals), and traffic.
struct What {
    const char *by, *algorithm, *variant;
    std::uint64_t bytes;  ///< traffic per element, counted as in algorithm_cases.h
};

constexpr double seconds_of_a_run = 0.005;

bench::Figure figure_of(const What& what, std::uint32_t count, double seconds, int runs) {
    const bench::Figure figure{what.by, what.algorithm, what.variant, count, seconds, what.bytes * count, runs};
    bench::print(figure);
    return figure;
}

bench::Figure time_on_host(const What& what, std::uint32_t count, int runs, const std::function<void()>& refill,
                           const std::function<void()>& work) {
    std::vector<double> seconds;
    for (int run = 0; run <= runs; ++run) {
        refill();
        const auto start = std::chrono::steady_clock::now();
        work();
        if (run) seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return figure_of(what, count, bench::median(seconds), runs);
}

std::vector<bench::Figure> time_twins(const glift::Device& device, std::uint32_t count, int runs) {
    const OnDevice on(device, count);
    on.give(bench::hashed(count));
    const auto timed = [&](const What& what, const std::function<void(const glift::Commands&)>& work) {
        return figure_of(what, count, bench::time_of(device, work, runs, seconds_of_a_run), runs);
    };
    return {
        timed({"GLSL", "scan", "exclusive_sum_u32", 8}, [&](const auto& commands) { on.scan(commands, count); }),
        timed({"GLSL", "select", "if_1_in_8", 4}, [&](const auto& commands) { on.compact(commands, count); }),
        timed({"GLSL", "radix_sort", "keys_u32", 8}, [&](const auto& commands) { on.sort(commands, count); }),
    };
}

std::vector<bench::Figure> time_host(std::uint32_t count, int runs) {
    const Words x = bench::hashed(count);
    const std::vector<float> floats(x.begin(), x.end());
    Words y(count);
    std::vector<host_rivals::KeyValue> pairs(count);
    const auto nothing = [] {};
    const auto refill_keys = [&] { y = x; };
    const auto refill_pairs = [&] {
        for (std::uint32_t i = 0; i < count; ++i) pairs[i] = {x[i], i};
    };
    volatile std::uint32_t sink = 0;  // keeps the sums from being optimised away
    volatile float float_sink = 0;
    constexpr const char *wide = "oneTBB", *narrow = "oneTBB, narrow";
    using namespace host_rivals;
    return {
        time_on_host({wide, "scan", "exclusive_sum_u32", 8}, count, runs, nothing, [&] { exclusive_scan(x, y); }),
        time_on_host({narrow, "scan", "exclusive_sum_u32", 8}, count, runs, nothing,
                     [&] { exclusive_scan_narrow(x, y); }),
        time_on_host({wide, "reduce", "sum_u32", 4}, count, runs, nothing, [&] { sink = sum(std::span(x)); }),
        time_on_host({narrow, "reduce", "sum_u32", 4}, count, runs, nothing, [&] { sink = sum_narrow(std::span(x)); }),
        time_on_host({wide, "reduce", "sum_f32", 4}, count, runs, nothing,
                     [&] { float_sink = sum(std::span(floats)); }),
        time_on_host({narrow, "reduce", "sum_f32", 4}, count, runs, nothing,
                     [&] { float_sink = sum_narrow(std::span(floats)); }),
        time_on_host({wide, "select", "if_1_in_8", 4}, count, runs, nothing, [&] { copy_multiples_of_8(x, y); }),
        time_on_host({narrow, "select", "if_1_in_8", 4}, count, runs, nothing,
                     [&] { copy_multiples_of_8_narrow(x, y); }),
        time_on_host({wide, "radix_sort", "keys_u32", 8}, count, runs, refill_keys, [&] { sort(y); }),
        time_on_host({wide, "radix_sort", "pairs_u32", 16}, count, runs, refill_pairs, [&] { sort(pairs); }),
    };
}

void append(std::vector<bench::Figure>& all, const std::vector<bench::Figure>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

void run(const Options& options) {
    const glift::Device device = glift::Device::open(options.device);
    if (!options.unchecked) check(device);
    const std::vector<std::string> messages = device.validation_messages();
    if (!messages.empty()) throw std::runtime_error(messages.front());
    bench::DeviceFigures twins{device.properties().name, {}}, host{"host", {}};
    for (unsigned log2 : options.log2) append(twins.rows, time_twins(device, 1u << log2, options.runs));
    for (unsigned log2 : options.host_log2) append(host.rows, time_host(1u << log2, options.runs));
    if (!options.json.empty()) bench::write_json(options.json, {twins, host});
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App app("the hand-written rivals of stdlib/algorithms: checked, and timed");
    Options options;
    app.add_option("--device", options.device, "device of the GLSL versions: gpu, lavapipe or a part of its name");
    app.add_option("--log2", options.log2, "base-2 logarithms of the numbers of elements, GLSL")
        ->delimiter(',')
        ->check(CLI::Range(0u, 28u));
    app.add_option("--host-log2", options.host_log2, "base-2 logarithms of the numbers of elements, C++")
        ->delimiter(',')
        ->check(CLI::Range(0u, 28u));
    app.add_option("--runs", options.runs, "number of timed runs; the median is reported")->check(CLI::PositiveNumber);
    app.add_flag("--unchecked", options.unchecked, "only time, do not check the results");
    app.add_option("--json", options.json, "file to write the results to");
    CLI11_PARSE(app, count, arguments);
    try {
        run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_rivals: %s\n", error.what());
        return 1;
    }
}
