// Pictures with shadows: shadows.glift from C++.
#include "frame.h"

#include "examples/common/picture.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>

namespace {

struct Arguments {
    std::string scene = "hairball", method = "rmsm", out = "shadows.png";
    float time = 0.4f;
    std::vector<std::uint32_t> size = {512, 512};
    Settings settings;
};

void save(const std::string& path, const picture::Picture& picture) {
    picture::write(path, picture);
    std::printf("wrote %s\n", path.c_str());
}

void run(const Arguments& a) {
    Frame frame(glift::Device::open(), a.settings, {a.size[0], a.size[1]});
    frame.set_scene(scenes::make(a.scene, a.time));
    const glift::Device& device = frame.device();
    device.wait();
    const std::uint64_t before = device.statistics().submissions;
    frame.draw(method_of(a.method));
    device.wait();
    const auto submissions = device.statistics().submissions - before;
    std::printf("%s: %s, submissions: %llu\n", device.properties().name.c_str(), a.method.c_str(),
                static_cast<unsigned long long>(submissions));
    std::printf("%s\n", frame.status().c_str());
    save(a.out, frame.picture());
}

void add_options(CLI::App& app, Arguments& a) {
    app.add_option("--scene", a.scene, "A generated scene (hairball, fence, robot, skeletons, city, trees)")
        ->capture_default_str();
    app.add_option("--method", a.method, "How shadows are made")
        ->check(CLI::IsMember({"rmsm", "asm", "standard"}))
        ->capture_default_str();
    app.add_option("--time", a.time, "The moment in the scene, in seconds")->capture_default_str();
    app.add_option("--size", a.size, "Width and height in pixels")
        ->expected(2)
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    app.add_option("--levels", a.settings.levels, "of the quadtree: its finest has 32 * 2^(levels - 1) cells a side")
        ->check(CLI::Range(1u, 13u))
        ->capture_default_str();
    app.add_option("--pages", a.settings.pages, "that the pool has room for")
        ->check(CLI::Range(1u, 65536u))
        ->capture_default_str();
    app.add_option("--pairs", a.settings.pairs, "of a triangle and a page that there is room for")
        ->capture_default_str();
    app.add_option("--bias", a.settings.bias, "of depths, a part of the light's range")->capture_default_str();
    app.add_option("--out", a.out, "The picture to write, PNG or EXR")->capture_default_str();
    app.footer("GLIFT_DEVICE=gpu|lavapipe|host|NAME chooses the device.");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Shadow maps in a quadtree");
    Arguments arguments;
    add_options(app, arguments);
    CLI11_PARSE(app, argc, argv);
    try {
        run(arguments);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "shadows: %s\n", error.what());
        return 1;
    }
}
