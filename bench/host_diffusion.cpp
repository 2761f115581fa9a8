// bench_host: compares the generated kernel of examples/heat on the host device with a hand-written loop. Each run
// times both; which of them goes first alternates. The comparison is made twice: with a loop compiled for several
// vector widths, of which the widest that the CPU has is used, and with one compiled for the compiler's flags alone
// (handwritten/diffusion.h).
//
//     bench_host [--runs N] [--size N] [--steps N] [--json FILE]
#include "handwritten/diffusion.h"
#include "heat.glift.hpp"
#include "median.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <memory>
#include <random>

namespace {

constexpr float rate = 0.125f;

struct Options {
    int runs = 20;
    std::uint32_t size = 256;
    int steps = 8;  ///< pairs of steps that a run times
    std::string json;
};

[[noreturn]] void usage() {
    std::fprintf(stderr, "usage: bench_host [--runs N] [--size N] [--steps N] [--json FILE]\n");
    std::exit(2);
}

Options parse(int count, char** arguments) {
    Options options;
    if (count % 2 == 0) usage();
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string name = arguments[i], value = arguments[i + 1];
        const int number = std::max(1, std::atoi(value.c_str()));
        if (name == "--json") options.json = value;
        else if (name == "--runs") options.runs = number;
        else if (name == "--size") options.size = static_cast<std::uint32_t>(number);
        else if (name == "--steps") options.steps = number;
        else usage();
    }
    return options;
}

/// Zeroed memory, allocated and aligned like the memory of the host device.
class Aligned {
public:
    explicit Aligned(std::size_t count) : storage_(std::calloc(count + 32, sizeof(float)), &std::free) {
        if (!storage_) throw std::bad_alloc();
        const auto address = reinterpret_cast<std::uintptr_t>(storage_.get());
        data_ = reinterpret_cast<float*>((address + 63) / 64 * 64);
    }
    float* data() const { return data_; }

private:
    std::unique_ptr<void, decltype(&std::free)> storage_;
    float* data_;
};

/// Runs the work twice and times the second run: in the first one the caches still hold the other implementation's
/// data.
double seconds_of(const std::function<void()>& work) {
    work();
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

using Twin = void (*)(const float* u, float* v, handwritten::Extent3 extent, float rate);

struct Measured {
    const char* name;
    double generated, handwritten, ratio;  ///< medians of the runs: seconds of one step, and generated / handwritten
    bool agree;
};

Measured measure(const Options& options, const char* name, Twin twin) {
    const std::uint32_t n = options.size;
    const std::size_t count = std::size_t{n} * n * n;
    const glift::Device device = glift::Device::open("host");
    const heat::Volume u(device, {n, n, n}), v(device, {n, n, n});
    const Aligned p(count), q(count);
    std::mt19937 engine(7);
    std::vector<float> values(count);
    for (float& value : values) value = static_cast<float>(engine() % 1000) / 8.0f;
    heat::Volume(u).write(values);
    std::memcpy(p.data(), values.data(), count * sizeof(float));

    const auto generated = [&] {
        for (int step = 0; step < options.steps; ++step) {
            heat::step(device, u, v, rate);
            heat::step(device, v, u, rate);
        }
    };
    const handwritten::Extent3 extent{n, n, n};
    const auto by_hand = [&] {
        for (int step = 0; step < options.steps; ++step) {
            twin(p.data(), q.data(), extent, rate);
            twin(q.data(), p.data(), extent, rate);
        }
    };
    std::vector<double> first, second, ratios;
    for (int run = 0; run < options.runs; ++run) {
        double one = 0, other = 0;
        if (run % 2) one = seconds_of(generated), other = seconds_of(by_hand);
        else other = seconds_of(by_hand), one = seconds_of(generated);
        first.push_back(one / (2 * options.steps));
        second.push_back(other / (2 * options.steps));
        ratios.push_back(one / other);
    }
    const std::vector<float> outcome = u.read();
    return {name, bench::median(first), bench::median(second), bench::median(ratios),
            std::memcmp(outcome.data(), p.data(), count * sizeof(float)) == 0};
}

int run(const Options& options) {
    const Measured all[] = {measure(options, "wide vectors where there are any", handwritten::diffuse),
                            measure(options, "the compiler's flags alone", handwritten::diffuse_narrow)};
    std::printf("| twin | elements | generated | hand-written | time ratio | same result |\n");
    std::printf("| --- | ---: | ---: | ---: | ---: | --- |\n");
    const std::uint64_t elements = std::uint64_t{options.size} * options.size * options.size;
    nlohmann::ordered_json json = {{"runs", options.runs}, {"cases", nlohmann::ordered_json::array()}};
    bool all_agree = true;
    for (const Measured& one : all) {
        std::printf("| %s | %llu | %.4f ms | %.4f ms | %.3f | %s |\n", one.name,
                    static_cast<unsigned long long>(elements), one.generated * 1e3, one.handwritten * 1e3, one.ratio,
                    one.agree ? "yes" : "NO");
        json["cases"].push_back({{"name", one.name},
                                 {"elements", elements},
                                 {"generated_seconds", one.generated},
                                 {"handwritten_seconds", one.handwritten},
                                 {"ratio", one.ratio},
                                 {"agree", one.agree}});
        all_agree = all_agree && one.agree;
    }
    if (!options.json.empty()) std::ofstream(options.json) << json.dump(2) << "\n";
    return all_agree ? 0 : 1;
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
