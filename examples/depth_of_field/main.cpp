// Photographs of scenes, and of pinhole pictures with distances: photograph.glift and dof.glift from C++.
#include "../common/progress.h"
#include "at_window.h"
#include "subject.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace {

using picture::Picture;

struct Arguments {
    std::string scene = "fence", colour, depth, foreground;
    float time = 0.4f;
    std::vector<std::uint32_t> size = {960, 640};
    Settings settings;
    unsigned reference = 0;
    bool window = false;
    std::string visualise, out = "depth_of_field.png", pinhole, reload;
};

std::unique_ptr<Subject> subject_of(const Arguments& a, const glift::Device& device) {
    if (!a.colour.empty()) return picture_subject(a.settings, device, input::pictures(a.colour, a.depth, a.foreground));
    return scene_subject(a.settings, device, input::scene(a.scene, a.time), {a.size[0], a.size[1]});
}

void time(Subject& subject) {
    const glift::Device& device = subject.device();
    constexpr unsigned rounds = 5;
    progress::Line line("photograph");
    line.show(0, rounds + 1, "shaders are compiled");
    subject.photograph();  // not timed: compiles shaders
    device.wait();
    const std::uint64_t before = device.statistics().submissions;
    double best = 1e30;
    for (unsigned round = 0; round < rounds; ++round) {
        const auto start = std::chrono::steady_clock::now();
        subject.photograph();
        device.wait();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        line.show(round + 2, rounds + 1);
    }
    line.clear();
    const double submissions = static_cast<double>(device.statistics().submissions - before) / rounds;
    std::printf("%s: %.2f ms and %g submissions a photograph\n", device.properties().name.c_str(), 1e3 * best,
                submissions);
}

/// The root mean square difference of two pictures, in display values (about sRGB: the square root of linear ones).
double difference(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (unsigned k = 0; k < 3; ++k) {
            const auto shown = [](float x) { return std::sqrt(std::clamp(x, 0.0f, 1.0f)); };
            const double d = shown(a.pixels[i][k]) - shown(b.pixels[i][k]);
            sum += d * d;
        }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels.size())));
}

/// Inserts a suffix into a file name: `name.png` becomes `name.suffix.png`.
std::string beside(const std::string& path, const std::string& suffix) {
    std::filesystem::path made(path);
    return made.replace_extension("." + suffix + made.extension().string()).string();
}

void save(const std::string& path, const Picture& picture) {
    picture::write(path, picture);
    std::printf("wrote %s\n", path.c_str());
}

void compare(const Arguments& a, const Picture& result, const Picture& reference) {
    Picture apart{result.width, result.height, {}, {}};
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        const glift::float4 d = result.pixels[i] - reference.pixels[i];
        apart.pixels.emplace_back(4 * std::abs(d.x), 4 * std::abs(d.y), 4 * std::abs(d.z), 1);
    }
    save(beside(a.out, "reference"), reference);
    save(beside(a.out, "difference"), apart);
    std::printf("difference to %u lens samples: %.4f (root of the mean square, of 1)\n", a.reference,
                difference(result, reference));
}

/// The command line that makes the picture again.
std::string words_of(const Arguments& a, glift::uint2 size) {
    const auto number = [](const char* name, float value) {
        char text[64];
        std::snprintf(text, sizeof text, " %s %.9g", name, static_cast<double>(value));
        return std::string(text);
    };
    const input::Camera& camera = a.settings.camera;
    std::string words = "depth_of_field";
    if (a.colour.empty()) {
        words += " --scene " + a.scene + number("--time", a.time) + " --size " + std::to_string(size.x) + " " +
                 std::to_string(size.y);
    } else {
        words += " --colour " + a.colour;
        if (!a.depth.empty()) words += " --depth " + a.depth;
        if (!a.foreground.empty()) words += " --foreground " + a.foreground;
    }
    words += number("--focal", camera.focal) + number("--f-stop", camera.f_stop) + number("--focus", camera.focus) +
             number("--film", camera.film_width) + " --layers " + std::to_string(a.settings.layers) +
             number("--front-cut", a.settings.cuts.front) + number("--back-cut", a.settings.cuts.back);
    return words + (a.settings.blurred ? " --blurred" : "") + " --out " + a.out;
}

void run_window(Arguments& a) {
    window::Window window("Depth of field", {a.size[0], a.size[1]});
    const std::unique_ptr<Subject> subject = subject_of(a, window.device());
    show_at(window, *subject, a.settings, a.reload, [&] { save(a.out, subject->result()); });
    std::printf("the same picture: %s\n", words_of(a, subject->image().extent()).c_str());
}

void run(const Arguments& a) {
    const std::unique_ptr<Subject> subject = subject_of(a, glift::Device::open());
    time(*subject);
    const Picture result = subject->result();
    if (!a.pinhole.empty()) save(a.pinhole, subject->pinhole().read());
    if (a.visualise == "circles") return save(a.out, subject->circles());
    if (a.visualise == "layers") return save(a.out, subject->layers());
    save(a.out, result);
    if (a.reference) compare(a, result, subject->reference(a.reference));
}

void add_options(CLI::App& app, Arguments& a) {
    app.add_option("--scene", a.scene,
                   "A generated scene (hairball, fence, robot, skeletons, city, trees) or a mesh file")
        ->capture_default_str();
    app.add_option("--time", a.time, "The moment in the scene, in seconds")->capture_default_str();
    app.add_option("--size", a.size, "Width and height in pixels")
        ->expected(2)
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    app.add_option("--colour", a.colour, "A picture instead of a scene: PNG or EXR");
    app.add_option("--depth", a.depth, "Its distances in metres: EXR, channel Z or Y");
    app.add_option("--foreground", a.foreground, "A layer before it: EXR with R, G, B, A, Z");
    app.add_option("--focal", a.settings.camera.focal, "Focal length in metres")->capture_default_str();
    app.add_option("--f-stop", a.settings.camera.f_stop, "Focal length / aperture")->capture_default_str();
    app.add_option("--focus", a.settings.camera.focus, "Distance of what is sharp, in metres")->capture_default_str();
    app.add_option("--film", a.settings.camera.film_width, "Width of the film in metres")->capture_default_str();
    app.add_option("--layers", a.settings.layers, "1; 2: the background by itself; 3: the foreground, too")
        ->check(CLI::Range(1, 3))
        ->capture_default_str();
    app.add_option("--front-cut", a.settings.cuts.front, "Where the foreground ends, as a part of the largest circle")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    app.add_option("--back-cut", a.settings.cuts.back, "Where the background begins, likewise")
        ->check(CLI::Range(0.01, 0.99))
        ->capture_default_str();
    app.add_flag("--blurred", a.settings.blurred, "Two layers: blur the background's circles instead of raising them");
    app.add_option("--visualise", a.visualise, "Write circles or layers instead")
        ->check(CLI::IsMember({"circles", "layers"}));
    app.add_option("--pinhole", a.pinhole, "Also write the picture that is begun with, PNG or EXR");
    app.add_option("--reference", a.reference, "Also draw the scene through so many points of the lens, and compare");
    app.add_flag("--window", a.window,
                 "Show it in a window: sliders, a click sets the focus, S writes the picture, Tab hides the sliders");
    app.add_option("--reload", a.reload, "In the window: the folder of `gliftc watch`, for edits of photograph.glift");
    app.add_option("--out", a.out, "The picture to write, PNG or EXR")->capture_default_str();
    app.footer("GLIFT_DEVICE=gpu|lavapipe|host|NAME chooses the device.");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Depth of field by heat diffusion");
    Arguments arguments;
    add_options(app, arguments);
    CLI11_PARSE(app, argc, argv);
    try {
        input::check(arguments.settings.camera);
        if (arguments.window) run_window(arguments);
        else run(arguments);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "depth_of_field: %s\n", error.what());
        return 1;
    }
}
