// bench_depth_of_field: all passes of depth of field in two layers (examples/depth_of_field), beside a copy of the
// bytes that they have to move.
//
//     bench_depth_of_field [--device NAME] [--sizes 512x512,1920x1080] [--runs N] [--seconds S] [--json FILE]
#include "figures.h"
#include "median.h"
#include "picture_size.h"
#include "timing.h"

#include "dof.glift.hpp"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// The blur solves a tridiagonal system of equations for each row, then one for each column. This is the least traffic
/// per pixel, each value read or written once in each of the two steps. Rows: colour (16 bytes) and distance (4) are
/// read, two layers (32) written. Columns: the two layers (32) and the distance (4) are read, the picture (16) is
/// written.
constexpr std::uint64_t bytes_a_pixel = 104;

struct Options {
    std::string device, json;
    std::vector<std::string> sizes = {"256x256", "512x512", "1024x1024", "1920x1080", "2048x2048", "4096x4096"};
    int runs = 11;
    double seconds = 0.02;
};

/// A lens of 50 mm at f/0.7 before 36 mm of film, focused at 4 m.
dof::Lens lens_of(std::uint32_t width) { return {0.05f, 0.05f / 0.7f, 4.0f, static_cast<float>(width) / 0.036f}; }

/// A picture of pseudo-random colours, and stripes of several distances.
struct Input {
    dof::Picture colour, result;
    dof::Distances distances;

    Input(const glift::Device& device, glift::uint2 size)
        : colour(device, size), result(device, size), distances(device, size) {
        std::vector<glift::float4> colours;
        std::vector<float> z;
        const std::size_t count = std::size_t{size.x} * size.y;
        colours.reserve(count);
        z.reserve(count);
        std::uint32_t x = 1;
        for (std::size_t i = 0; i < count; ++i) {
            x = x * 1664525 + 1013904223;
            const auto part = [&](unsigned shift) { return static_cast<float>(x >> shift & 255) / 255.0f; };
            colours.emplace_back(part(8), part(16), part(24), 1.0f);
            z.push_back(2.0f + static_cast<float>(i % size.x * 16 / size.x % 5));
        }
        colour.write(colours);
        distances.write(z);
    }
};

void photograph(const glift::Commands& commands, const Input& input) {
    dof::two_layers(commands, input.colour, input.distances, lens_of(input.colour.extent().x), 0.5f, dof::Holes::raised,
                    input.result);
}

/// The median time of a single picture, in seconds: wall-clock time from the call until the device has finished. A
/// picture is one submission; the host device, which computes on the CPU, makes none.
double alone(const glift::Device& device, const Input& input, int runs) {
    std::vector<double> seconds;
    const std::uint64_t before = device.statistics().submissions;
    for (int run = 0; run < runs; ++run) {
        const auto start = std::chrono::steady_clock::now();
        photograph(device, input);
        device.wait();
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    if (device.statistics().submissions - before > static_cast<std::uint64_t>(runs))
        throw std::runtime_error("a picture took more than one submission");
    return bench::median(seconds);
}

void run(const Options& options) {
    const glift::Device device = glift::Device::open(options.device);
    bench::DeviceFigures figures{device.properties().name, {}};
    for (const std::string& text : options.sizes) {
        const glift::uint2 size = bench::picture_size(text);
        const Input input(device, size);
        const std::uint64_t pixels = std::uint64_t{size.x} * size.y, bytes = bytes_a_pixel * pixels;
        const glift::MemoryDescription half{.name = "copied", .bytes = bytes / 2};
        const glift::Memory from = device.allocate(half), to = device.allocate(half);
        const auto add = [&](const char* by, const char* what, double seconds) {
            figures.rows.push_back({by, what, text, pixels, seconds, bytes, options.runs, -1});
            bench::print(figures.rows.back());
        };
        const auto time = [&](const auto& work) { return bench::time_of(device, work, options.runs, options.seconds); };
        add("Glift", "two_layers", time([&](const glift::Commands& commands) { photograph(commands, input); }));
        add("Glift", "one_image", alone(device, input, options.runs));
        add("copy", "two_layers",
            time([&](const glift::Commands& commands) { commands.copy(from, 0, to, 0, bytes / 2); }));
    }
    if (!options.json.empty()) bench::write_json(options.json, {figures});
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App app("Two layers of depth of field beside a copy of the bytes that have to be moved");
    Options options;
    app.add_option("--device", options.device, "as Device::open takes it");
    app.add_option("--sizes", options.sizes, "WIDTHxHEIGHT")->delimiter(',');
    app.add_option("--runs", options.runs, "of which the median is taken")->check(CLI::PositiveNumber);
    app.add_option("--seconds", options.seconds, "of a run");
    app.add_option("--json", options.json, "where the figures go");
    CLI11_PARSE(app, count, arguments);
    try {
        run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_depth_of_field: %s\n", error.what());
        return 1;
    }
}
