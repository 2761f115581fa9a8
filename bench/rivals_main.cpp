// bench_rivals: the hand-written rivals of stdlib/algorithms checked against the C++ standard library, and their speed.
//
//     bench_rivals [--device NAME] [--runs N] [--log2 22,24]
#include "algorithm_twins.h"
#include "bench_input.h"
#include "host_rivals.h"
#include "median.h"

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
    std::string device;
    int runs = 11;
    std::vector<unsigned> log2 = {22, 24};
};

[[noreturn]] void usage() {
    std::fprintf(stderr, "usage: bench_rivals [--device NAME] [--runs N] [--log2 22,24]\n");
    std::exit(2);
}

std::vector<unsigned> numbers_in(const std::string& text) {
    std::vector<unsigned> numbers;
    for (std::size_t at = 0; at < text.size(); at = text.find(',', at)) {
        if (text[at] == ',') ++at;
        numbers.push_back(static_cast<unsigned>(std::atoi(text.c_str() + at)));
    }
    return numbers;
}

Options parse(int count, char** arguments) {
    Options options;
    if (count % 2 == 0) usage();
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string name = arguments[i], value = arguments[i + 1];
        if (name == "--device") options.device = value;
        else if (name == "--runs") options.runs = std::max(1, std::atoi(value.c_str()));
        else if (name == "--log2") options.log2 = numbers_in(value);
        else usage();
    }
    for (unsigned log2 : options.log2) {
        if (log2 > 28) usage();
    }
    return options;
}

/// The three memories of an algorithm on a device, and what the host expects of it.
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
    void scan(std::uint32_t count) const { scan_.record(device_, x_, y_, count); }
    void compact(std::uint32_t count) const { compact_.record(device_, x_, y_, kept_, count); }
    void sort(std::uint32_t count) const { sort_.record(device_, x_, y_, count); }

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
        throw std::runtime_error(std::string(what) + ": wrong result of " + std::to_string(count) + " elements");
}

void check_device(const OnDevice& on, const Words& x, const Expected& expected) {
    const auto count = static_cast<std::uint32_t>(x.size());
    on.give(x);
    on.scan(count);
    require(on.result(count) == expected.scanned, "scan twin", count);
    on.poison(count);
    on.compact(count);
    const std::uint32_t kept = on.kept();
    require(kept == expected.compacted.size() && on.result(kept) == expected.compacted, "compact twin", count);
    on.poison(count);
    on.sort(count);
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

/// Hashes, numbers that are all kept, none, and keys of which many are equal.
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
            check_device(on, x, expected);
            check_host(x, expected);
        }
    }
}

void print(const char* name, std::uint32_t count, const std::vector<double>& seconds) {
    const double best = *std::min_element(seconds.begin(), seconds.end()), median = bench::median(seconds);
    std::printf("| %s | %u | %.3f ms | %.0f M/s | %.0f M/s |\n", name, count, median * 1e3, count / median / 1e6,
                count / best / 1e6);
}

void time_on_device(const glift::Device& device, const char* name, std::uint32_t count, int runs,
                    const std::function<void()>& work) {
    std::vector<double> seconds;
    for (int run = 0; run <= runs; ++run) {  // the first compiles
        const glift::Timestamp before = device.commands().timestamp();
        work();
        const glift::Timestamp after = device.commands().timestamp();
        device.wait();
        if (run) seconds.push_back(after - before);
    }
    print(name, count, seconds);
}

void time_on_host(const char* name, std::uint32_t count, int runs, const std::function<void()>& refill,
                  const std::function<void()>& work) {
    std::vector<double> seconds;
    for (int run = 0; run <= runs; ++run) {
        refill();
        const auto start = std::chrono::steady_clock::now();
        work();
        if (run) seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    print(name, count, seconds);
}

void time_twins(const glift::Device& device, std::uint32_t count, int runs) {
    const OnDevice on(device, count);
    on.give(bench::hashed(count));
    time_on_device(device, "GLSL: scan", count, runs, [&] { on.scan(count); });
    time_on_device(device, "GLSL: compact, 1 in 8", count, runs, [&] { on.compact(count); });
    time_on_device(device, "GLSL: radix sort", count, runs, [&] { on.sort(count); });
}

void time_host(std::uint32_t count, int runs) {
    const Words x = bench::hashed(count);
    const std::vector<float> floats(x.begin(), x.end());
    Words y(count);
    std::vector<host_rivals::KeyValue> pairs(count);
    const auto nothing = [] {};
    float sink = 0;
    using namespace host_rivals;
    time_on_host("C++: scan", count, runs, nothing, [&] { exclusive_scan(x, y); });
    time_on_host("C++: scan, narrow", count, runs, nothing, [&] { exclusive_scan_narrow(x, y); });
    time_on_host("C++: sum", count, runs, nothing, [&] { sink += static_cast<float>(sum(std::span(x))); });
    time_on_host("C++: sum, narrow", count, runs, nothing,
                 [&] { sink += static_cast<float>(sum_narrow(std::span(x))); });
    time_on_host("C++: sum of floats", count, runs, nothing, [&] { sink += sum(std::span(floats)); });
    time_on_host("C++: sum of floats, narrow", count, runs, nothing, [&] { sink += sum_narrow(std::span(floats)); });
    time_on_host("C++: copy_if, 1 in 8", count, runs, nothing, [&] { copy_multiples_of_8(x, y); });
    time_on_host("C++: copy_if, 1 in 8, narrow", count, runs, nothing, [&] { copy_multiples_of_8_narrow(x, y); });
    time_on_host(
        "C++: sort", count, runs, [&] { y = x; }, [&] { sort(y); });
    const auto refill_pairs = [&] {
        for (std::uint32_t i = 0; i < count; ++i) pairs[i] = {x[i], i};
    };
    time_on_host("C++: sort of pairs", count, runs, refill_pairs, [&] { sort(pairs); });
    if (sink == 1) std::puts("");  // the sums are used
}

int run(const Options& options) {
    const glift::Device device = glift::Device::open(options.device);
    check(device);
    const std::vector<std::string> messages = device.validation_messages();
    if (!messages.empty()) throw std::runtime_error(messages.front());
    std::printf("%s: results are right\n\n", device.properties().name.c_str());
    std::printf("| rival | elements | median | by median | by minimum |\n| --- | ---: | ---: | ---: | ---: |\n");
    for (unsigned log2 : options.log2) {
        time_twins(device, 1u << log2, options.runs);
        time_host(1u << log2, options.runs);
    }
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    const Options options = parse(count, arguments);
    try {
        return run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
