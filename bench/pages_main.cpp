// bench_pages [--seconds S] [--runs N] [--plane SIDE] [--volume SIDE] [--json FILE]: figure 6.1 of Lefohn's thesis
// (2006). How fast paged arrays are read, through page tables of one level and of two, by the size of a page, compared
// with an array without pages. Frames are in random order. Speeds count the bytes of the elements that are read, not
// those of tables.
#include "bench_input.h"
#include "pages.glift.hpp"
#include "timing.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace {

using Number = std::uint32_t;

struct Options {
    double seconds = 0.05;
    int runs = 5;
    Number plane = 0, volume = 0;  ///< sides of the arrays; 0: chosen by the kind of device
    std::string json;
};

/// What depends on the number of axes: here for planes, below for volumes.
struct Planar {
    using Dense = pages::Plane;
    using Address = glift::uint2;
    static constexpr int axes = 2;
    static Address box(Number side) { return {side, side}; }
    static Address results(Number side) { return {side, side / 8}; }
    static Address at(Number x) { return {x, x >> 16}; }
    static Number place(Address a, Number side) { return a.x + side * a.y; }
    static Address each(Address a, Number (*f)(Number, Number), Number b) { return {f(a.x, b), f(a.y, b)}; }
};
struct Spatial {
    using Dense = pages::Volume;
    using Address = glift::uint3;
    static constexpr int axes = 3;
    static Address box(Number side) { return {side, side, side}; }
    static Address results(Number side) { return {side, side, side / 8}; }
    static Address at(Number x) { return {x, x >> 10, x >> 20}; }
    static Number place(Address a, Number side) { return a.x + side * (a.y + side * a.z); }
    static Address each(Address a, Number (*f)(Number, Number), Number b) { return {f(a.x, b), f(a.y, b), f(a.z, b)}; }
};

Number power(Number base, int exponent) { return exponent == 0 ? 1 : base * power(base, exponent - 1); }
Number quotient(Number a, Number b) { return a / b; }
Number rest(Number a, Number b) { return a % b; }

/// 1 to n in random order. An entry of a page table is the frame's number + 1 (0: no page), so all pages are resident.
std::vector<Number> shuffled(Number n) {
    std::vector<Number> entries(n);
    for (Number i = 0; i < n; ++i) entries[i] = i + 1;
    for (Number i = n; i-- > 1;) std::swap(entries[i], entries[bench::hash32(i) % (i + 1)]);
    return entries;
}

template <class Axes> class Bench {
public:
    Bench(const glift::Device& device, Number side, const Options& options)
        : device_(device), options_(options), side_(side), all_(power(side, Axes::axes)),
          rows_(device, Axes::results(side)), random_(device, all_ / 8) {}

    nlohmann::ordered_json dense() {
        const typename Axes::Dense f(device_, Axes::box(side_));
        pages::fill(device_, f, side_);
        return measure(f, 0, 0, [&](typename Axes::Address a) { return Axes::place(a, side_); });
    }

    template <class Field> nlohmann::ordered_json one_level(Number page) {
        pages::Numbers table(device_, entries(page));
        const std::vector<Number> frames = shuffled(entries(page));
        table.write(frames);
        const Field f(device_, table, Axes::box(side_), entries(page), 0.0f);
        return in_pages(f, page, 1, frames);
    }

    template <class Field> nlohmann::ordered_json two_levels(Number page) {
        const Number leaves = (entries(page) + 255) / 256;
        pages::Numbers top(device_, leaves);
        top.write(shuffled(leaves));
        pages::Leaves table(device_, top, entries(page), leaves, 0u);
        const std::vector<Number> frames = shuffled(entries(page));
        table.write(frames);
        const Field f(device_, table, Axes::box(side_), entries(page), 0.0f);
        return in_pages(f, page, 2, frames);
    }

private:
    Number entries(Number page) const { return power(side_ / page, Axes::axes); }

    template <class Field>
    nlohmann::ordered_json in_pages(const Field& f, Number page, int levels, const std::vector<Number>& frames) {
        const Number volume = power(page, Axes::axes);
        pages::fill(device_, f.frames(), volume);
        return measure(f, page, levels, [&](typename Axes::Address a) {
            const Number frame = frames[Axes::place(Axes::each(a, quotient, page), side_ / page)] - 1;
            return volume * frame + Axes::place(Axes::each(a, rest, page), page);
        });
    }

    /// `number_of` gives the number from which the value at an address was computed.
    template <class Field, class NumberOf>
    nlohmann::ordered_json measure(const Field& f, Number page, int levels, const NumberOf& number_of) {
        const auto rows = [&](const glift::Commands& c) { pages::rows(c, f, rows_); };
        const auto random = [&](const glift::Commands& c) { pages::scattered(c, f, side_, random_); };
        random(device_);
        check(number_of, page, levels);
        const double bytes = 4.0 * all_;
        const double coherent = bytes / bench::time_of(device_, rows, options_.runs, options_.seconds) * 1e-9,
                     scattered = bytes / bench::time_of(device_, random, options_.runs, options_.seconds) * 1e-9;
        const std::string size = page == 0 ? "no pages" : std::to_string(page) + "^" + std::to_string(Axes::axes);
        std::printf("| %d-D | %s | %d | %.2f | %.2f |\n", Axes::axes, size.c_str(), levels, coherent, scattered);
        std::fflush(stdout);
        return {
            {"axes", Axes::axes}, {"page", page}, {"levels", levels}, {"coherent", coherent}, {"random", scattered}};
    }

    template <class NumberOf> void check(const NumberOf& number_of, Number page, int levels) {
        const std::vector<float> sums = random_.read(0, 1000);
        for (Number i = 0; i < sums.size(); ++i) {
            float sum = 0;
            for (Number k = 0; k < 8; ++k) {
                const auto at = Axes::each(Axes::at(bench::hash32(8 * i + k)), rest, side_);
                sum += static_cast<float>(bench::hash32(number_of(at)) % 1024);
            }
            if (sum != sums[i])
                throw std::runtime_error("wrong sum " + std::to_string(i) + " in pages of " + std::to_string(page) +
                                         ", levels " + std::to_string(levels));
        }
    }

    const glift::Device& device_;
    const Options& options_;
    Number side_, all_;
    typename Axes::Dense rows_;
    pages::Line random_;
};

nlohmann::ordered_json planes(const glift::Device& device, Number side, const Options& options) {
    Bench<Planar> bench(device, side, options);
    return {bench.dense(),
            bench.one_level<pages::One2x4>(4),
            bench.one_level<pages::One2x8>(8),
            bench.one_level<pages::One2x16>(16),
            bench.one_level<pages::One2x32>(32),
            bench.one_level<pages::One2x64>(64),
            bench.two_levels<pages::Two2x4>(4),
            bench.two_levels<pages::Two2x8>(8),
            bench.two_levels<pages::Two2x16>(16),
            bench.two_levels<pages::Two2x32>(32),
            bench.two_levels<pages::Two2x64>(64)};
}

nlohmann::ordered_json volumes(const glift::Device& device, Number side, const Options& options) {
    Bench<Spatial> bench(device, side, options);
    return {bench.dense(),
            bench.one_level<pages::One3x4>(4),
            bench.one_level<pages::One3x8>(8),
            bench.one_level<pages::One3x16>(16),
            bench.one_level<pages::One3x32>(32),
            bench.two_levels<pages::Two3x4>(4),
            bench.two_levels<pages::Two3x8>(8),
            bench.two_levels<pages::Two3x16>(16),
            bench.two_levels<pages::Two3x32>(32)};
}

nlohmann::ordered_json run_on(const glift::Device& device, const Options& options) {
    const bool is_gpu = device.properties().kind == glift::DeviceKind::gpu;
    const Number plane = options.plane ? options.plane
                         : is_gpu      ? 16384
                                       : 2048,
                 volume = options.volume ? options.volume
                          : is_gpu       ? 512
                                         : 128;
    std::printf("\n%s, %u^2 and %u^3 floats\n\n| axes | page | levels of the table | coherent, GB/s | random, GB/s |\n"
                "| --- | --- | ---: | ---: | ---: |\n",
                device.properties().name.c_str(), plane, volume);
    nlohmann::ordered_json rows = planes(device, plane, options);
    for (auto& row : volumes(device, volume, options)) rows.push_back(row);
    return {{"device", device.properties().name}, {"plane", plane}, {"volume", volume}, {"rows", rows}};
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("How fast arrays in pages are read, by the size of a page");
    Options options;
    app.add_option("--seconds", options.seconds, "of a run, about")->capture_default_str();
    app.add_option("--runs", options.runs, "of which the median counts")->capture_default_str();
    app.add_option("--plane", options.plane, "side of the array in 2-D, a power of two from 64 on");
    app.add_option("--volume", options.volume, "side of the array in 3-D, a power of two from 32 to 512");
    app.add_option("--json", options.json, "where the figures go");
    CLI11_PARSE(app, argc, argv);
    try {
        nlohmann::ordered_json all = nlohmann::ordered_json::array();
        const glift::Device device = glift::Device::open();
        all.push_back(run_on(device, options));
        if (!device.is_host()) all.push_back(run_on(glift::Device::open("host"), options));
        if (!options.json.empty()) std::ofstream(options.json) << all.dump(2) << "\n";
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_pages: %s\n", error.what());
        return 1;
    }
    return 0;
}
