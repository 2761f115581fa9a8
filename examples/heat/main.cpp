// Heat diffusion in a volume, on the Vulkan device and on the host device: heat.glift from C++.
#include "../common/npy.h"
#include "../common/png.h"
#include "heat.glift.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr const char* usage = "usage: heat [volume.npy] [--steps N] [--out DIR] [--save FILE.npy]\n"
                              "\n"
                              "  volume.npy   a 3-D array; without one a volume is generated\n"
                              "  --steps N    how many time steps (default 40)\n"
                              "  --out DIR    where the pictures go (default .)\n"
                              "  --save FILE  writes the outcome as a .npy file\n"
                              "\n"
                              "GLIFT_DEVICE=gpu|lavapipe|NAME chooses the Vulkan device.\n";

/// The fraction of the difference to each neighbour that flows in one step; the explicit scheme is stable up to 1/6.
constexpr float rate = 0.125f;

struct Arguments {
    std::string file;
    std::uint32_t steps = 40;
    std::filesystem::path folder = ".";
    std::string outcome;  ///< file for the result; empty: it is not saved
};

struct WrongUsage : std::runtime_error {
    using std::runtime_error::runtime_error;
};

std::uint32_t step_count(const std::string& word) {
    char* end = nullptr;
    const unsigned long value = std::strtoul(word.c_str(), &end, 10);
    if (word.empty() || word[0] < '0' || word[0] > '9' || *end || value == 0 || value > 1000000) {
        throw WrongUsage("--steps takes a number from 1 to 1000000, not '" + word + "'");
    }
    return static_cast<std::uint32_t>(value);
}

Arguments read_arguments(int argc, char** argv) {
    Arguments arguments;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--steps" || word == "--out" || word == "--save") {
            if (++i == argc) throw WrongUsage(word + " is followed by nothing");
            if (word == "--steps") arguments.steps = step_count(argv[i]);
            else if (word == "--out") arguments.folder = argv[i];
            else arguments.outcome = argv[i];
        } else if (word.starts_with("-")) {
            throw WrongUsage("there is no option " + word);
        } else if (!arguments.file.empty()) {
            throw WrongUsage("one volume at a time: '" + arguments.file + "' or '" + word + "'");
        } else {
            arguments.file = word;
        }
    }
    return arguments;
}

/// A hot shell around a ball with cold bars through it.
npy::Array generated_volume() {
    constexpr std::uint32_t n = 96;
    npy::Array volume{{n, n, n}, std::vector<float>(n * n * n)};
    for (std::uint32_t z = 0; z < n; ++z)
        for (std::uint32_t y = 0; y < n; ++y)
            for (std::uint32_t x = 0; x < n; ++x) {
                const auto centred = [](std::uint32_t i) { return (static_cast<float>(i) + 0.5f) / (n / 2.0f) - 1.0f; };
                const float px = centred(x), py = centred(y), pz = centred(z);
                const float radius = std::sqrt(px * px + py * py + pz * pz);
                const bool shell = radius > 0.75f && radius < 0.85f, ball = radius < 0.5f;
                const bool bar = std::fabs(std::sin(9.0f * px)) < 0.3f && std::fabs(std::sin(9.0f * py)) < 0.3f;
                volume.values[(z * n + y) * n + x] = shell ? 1.0f : ball && !bar ? 0.6f : 0.05f;
            }
    return volume;
}

npy::Array load(const std::string& file) {
    if (file.empty()) return generated_volume();
    npy::Array volume = npy::read(file);
    if (volume.extent.size() != 3) {
        throw std::runtime_error(file + ": the array has " + std::to_string(volume.extent.size()) +
                                 " axes, a volume has 3");
    }
    if (volume.values.empty()) throw std::runtime_error(file + ": the volume has no voxels");
    return volume;
}

/// The result of one device.
struct Outcome {
    std::vector<float> values;
    double seconds = 0;  ///< time of all steps, in the fastest of a few runs
};

Outcome diffuse_on(const glift::Device& device, const npy::Array& volume, std::uint32_t steps) {
    heat::Volume u(device, {volume.extent[0], volume.extent[1], volume.extent[2]});
    Outcome outcome;
    // The first run compiles shaders and allocates; it is not counted.
    constexpr int runs = 4;
    for (int run = 0; run < runs; ++run) {
        u.write(volume.values);
        device.wait();
        const auto start = std::chrono::steady_clock::now();
        heat::diffuse(device, u, rate, steps);
        device.wait();
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        outcome.seconds = run <= 1 ? seconds : std::min(outcome.seconds, seconds);
    }
    outcome.values = u.read();
    std::printf("%-32s %8.1f million voxels/s   (%.2f ms for %u steps)\n", device.properties().name.c_str(),
                1e-6 * static_cast<double>(volume.values.size()) * steps / outcome.seconds, 1e3 * outcome.seconds,
                steps);
    return outcome;
}

/// The Vulkan device. None, after printing why, if there is none or GLIFT_DEVICE asks for the host device.
std::optional<glift::Device> vulkan_device() {
    try {
        glift::Device device = glift::Device::open();
        if (!device.is_host()) return device;
        std::printf("GLIFT_DEVICE asks for the host device: no Vulkan device to compare with.\n");
    } catch (const glift::Error& error) {
        std::printf("No Vulkan device: %s\nGoing on with the host device alone.\n", error.what());
    }
    return std::nullopt;
}

/// The middle slices across z, y and x, side by side, magnified so that small volumes can be looked at.
png::Picture middle_slices(const npy::Array& volume, const std::vector<float>& values, float low, float high) {
    const std::uint32_t nx = volume.extent[0], ny = volume.extent[1], nz = volume.extent[2];
    const std::uint32_t zoom = std::max(1u, 320 / std::max({nx, ny, nz})), gap = 2;
    png::Picture picture{zoom * (nx + nx + ny + 2 * gap), zoom * std::max(ny, nz), {}};
    picture.values.assign(std::size_t{picture.width} * picture.height, 1.0f);
    const auto grey = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        const float value = values[(std::size_t{z} * ny + y) * nx + x];
        return high > low ? (value - low) / (high - low) : 0.0f;
    };
    for (std::uint32_t row = 0; row < picture.height; ++row)
        for (std::uint32_t column = 0; column < picture.width; ++column) {
            const std::uint32_t i = row / zoom;
            std::uint32_t k = column / zoom;
            float& pixel = picture.values[std::size_t{row} * picture.width + column];
            if (k < nx) {
                if (i < ny) pixel = grey(k, i, nz / 2);
            } else if ((k -= nx) >= gap && k < nx + gap) {
                if (i < nz) pixel = grey(k - gap, ny / 2, nz - 1 - i);
            } else if (k >= nx + 2 * gap && i < nz) {
                pixel = grey(nx / 2, k - nx - 2 * gap, nz - 1 - i);
            }
        }
    return picture;
}

void write_pictures(const Arguments& arguments, const npy::Array& volume, const std::vector<float>& after) {
    std::filesystem::create_directories(arguments.folder);
    const auto [low, high] = std::minmax_element(volume.values.begin(), volume.values.end());
    const std::string first = (arguments.folder / "before.png").string(),
                      second = (arguments.folder / "after.png").string();
    png::write(first, middle_slices(volume, volume.values, *low, *high));
    png::write(second, middle_slices(volume, after, *low, *high));
    std::printf("pictures: %s, %s (the middle slices across z, y and x)\n", first.c_str(), second.c_str());
}

/// Prints how the two results compare; false if they differ.
bool agree(const Outcome& vulkan, const Outcome& host) {
    const std::size_t bytes = host.values.size() * sizeof(float);
    if (std::memcmp(vulkan.values.data(), host.values.data(), bytes) == 0) {
        std::printf("agreement: the two devices agree bit for bit\n");
        return true;
    }
    std::size_t differing = 0;
    float largest = 0;
    for (std::size_t i = 0; i < host.values.size(); ++i) {
        differing += std::memcmp(&vulkan.values[i], &host.values[i], sizeof(float)) != 0;
        largest = std::max(largest, std::fabs(vulkan.values[i] - host.values[i]));
    }
    std::printf("agreement: the two devices DIFFER in %zu of %zu voxels, by %g at most\n", differing,
                host.values.size(), largest);
    return false;
}

int run(const Arguments& arguments) {
    const npy::Array volume = load(arguments.file);
    std::printf("volume: %s, %s voxels\n", arguments.file.empty() ? "generated" : arguments.file.c_str(),
                npy::text_of(volume.extent).c_str());
    const std::optional<glift::Device> vulkan = vulkan_device();
    std::optional<Outcome> there;
    if (vulkan) there = diffuse_on(*vulkan, volume, arguments.steps);
    const Outcome here = diffuse_on(glift::Device::open("host"), volume, arguments.steps);

    const bool good = !there || agree(*there, here);
    const auto sum = [](const std::vector<float>& values) {
        return std::accumulate(values.begin(), values.end(), 0.0);
    };
    std::printf("sum of all temperatures: %.9g before, %.9g after (the surface is insulated)\n", sum(volume.values),
                sum(here.values));
    write_pictures(arguments, volume, here.values);
    if (!arguments.outcome.empty()) npy::write(arguments.outcome, {volume.extent, here.values});
    return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc == 2 && std::string(argv[1]) == "--help") {
            std::fputs(usage, stdout);
            return 0;
        }
        return run(read_arguments(argc, argv));
    } catch (const WrongUsage& error) {
        std::fprintf(stderr, "heat: %s\n\n%s", error.what(), usage);
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "heat: %s\n", error.what());
        return 1;
    }
}
