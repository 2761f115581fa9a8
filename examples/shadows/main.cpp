// Pictures with shadows: shadows.glift from C++.
#include "agreement.h"
#include "at_window.h"
#include "compare.h"
#include "popping.h"

#include <CLI/CLI.hpp>

#include "examples/common/shapes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>

namespace {

struct Arguments {
    std::string scene = "hairball", method = "rmsm", show = "picture", out = "shadows.png", path, write_path;
    std::string agreement, popping, pictures;
    float time = 0.4f;
    unsigned frames = 0;  // 0: one frame; along recorded paths all
    std::vector<std::uint32_t> size = {512, 512};
    float from_right = 0, from_above = 0, closer = 1, light_from_right = 0, light_closer = 1;
    bool is_sized = false, compare = false, window = false;
    Settings settings;
    path::Way way;
    Walk walk;
};

void save(const std::string& path, const picture::Picture& picture) {
    picture::write(path, picture);
    std::printf("wrote %s\n", path.c_str());
}

/// The name of a frame's picture: if there are several frames, with the frame's number before the extension.
std::string numbered(const Arguments& a, unsigned frame, std::size_t frames) {
    if (frames == 1) return a.out;
    char number[16];
    std::snprintf(number, sizeof number, ".%04u", frame);
    std::filesystem::path made(a.out);
    return made.replace_extension(number + made.extension().string()).string();
}

/// The scene at a time.
using SceneAt = std::function<scenes::Scene(float time)>;

/// The mesh of a file on a slab.
scenes::Scene scene_of_file(const std::string& file) {
    scenes::Scene scene = scenes::make("fence", 0);
    scene.mesh = mesh::read(file);
    mesh::normalise(scene.mesh);
    mesh::Box box = mesh::bounds_of(scene.mesh);
    const glift::float3 middle = (box.low + box.high) * 0.5f;
    mesh::add_box(scene.mesh, {-2, box.low.y - 0.1f, -2}, {3, box.low.y, 3}, {0.6f, 0.58f, 0.55f});
    scene.view = {middle + glift::float3(0.9f, 0.8f, 1.6f), middle, {0, 1, 0}, 0.7f, 0.05f, 20};
    scene.light = {middle + glift::float3(1.5f, 2.5f, 1), middle, {0, 1, 0}, 0.8f, 0.1f, 8};
    scene.light_half_size = 2.5f;
    return scene;
}

/// A generated scene of that name, or else a file, which is read once.
SceneAt scene_of(const std::string& name) {
    const bool is_generated = std::ranges::find(scenes::names(), name) != scenes::names().end();
    // A text that is neither is taken for a scene's name, so that the error lists the names, unless it looks like a
    // file's name.
    if (is_generated || (!std::filesystem::exists(name) && name.find_first_of("./") == std::string::npos))
        return [name](float time) { return scenes::make(name, time); };
    return [scene = scene_of_file(name)](float) { return scene; };
}

std::vector<path::Step> path_of(const Arguments& a, scenes::Scene scene) {
    if (!a.path.empty()) return path::some_of(path::read(a.path, scene), a.frames);
    scene.view = camera::orbited(scene.view, a.from_right, a.from_above, a.closer);
    scene.light = camera::orbited(scene.light, a.light_from_right, 0, a.light_closer);
    path::Way way = a.way;
    way.frames = std::max(a.frames, 1u), way.is_static = a.settings.cached;
    return path::around(scene, a.time, way);
}

void print_agreement(const char* name, const Agreement& agreement) {
    if (const std::optional<double> share = agreement.share())
        std::printf("  %-8s %8.4f %% of %zu pixels agree with rays (%zu in the band)\n", name, 100 * *share,
                    agreement.pixels, agreement.in_band);
    else std::printf("  %-8s has no pixels to compare (%zu in the band)\n", name, agreement.in_band);
}

void compare_all(const Arguments& a, Frame& frame, const SceneAt& scene_at, const std::vector<path::Step>& steps) {
    std::array<Agreement, 3> all;
    std::optional<double> least;
    for (unsigned i = 0; i < steps.size(); ++i) {
        scenes::Scene scene = scene_at(steps[i].time);
        scene.view = steps[i].view, scene.light = steps[i].light;
        frame.set_scene(scene);
        const Compared one = compare(frame, a.settings.bias);
        for (std::size_t k = 0; k < all.size(); ++k) all[k] += one.agreement[k];
        const std::optional<double> share = one.rmsm().share();
        if (share) least = std::min(least.value_or(1), *share);
        save(numbered(a, i, steps.size()), side_by_side(one));
    }
    std::printf("%s, %zu frames", a.scene.c_str(), steps.size());
    if (least) std::printf("; RMSM %.4f %% in the worst of them", 100 * *least);
    std::printf("\n");
    for (std::size_t k = 0; k < all.size(); ++k) print_agreement(Compared::names[k], all[k]);
}

/// The walk through scenes along their recorded paths that the command line asks for.
Walk walk_of(const Arguments& a) {
    Walk walk = a.walk;
    walk.frames = a.frames, walk.settings = a.settings;
    if (a.is_sized) walk.size = {a.size[0], a.size[1]};
    return walk;
}

void run_popping(const Arguments& a) {
    Walk walk = walk_of(a);
    walk.prefix = "slow_", walk.only_first = true;
    measure_popping(walk, a.popping, a.pictures);
}

void run(const Arguments& a) {
    Frame frame(glift::Device::open(), a.settings, {a.size[0], a.size[1]});
    const glift::Device& device = frame.device();
    const SceneAt scene_at = scene_of(a.scene);
    scenes::Scene scene = scene_at(a.time);
    const std::vector<path::Step> steps = path_of(a, scene);
    if (!a.write_path.empty()) path::write(a.write_path, steps);
    if (a.compare) return compare_all(a, frame, scene_at, steps);
    for (unsigned i = 0; i < steps.size(); ++i) {
        if (steps[i].time != (i > 0 ? steps[i - 1].time : a.time)) scene = scene_at(steps[i].time);
        scene.view = steps[i].view, scene.light = steps[i].light;
        frame.set_scene(scene);
        frame.prepare(method_of(a.method));
        device.wait();
        const std::uint64_t before = device.statistics().submissions;
        const auto start = std::chrono::steady_clock::now();
        frame.submit(method_of(a.method));
        device.wait();
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const std::uint64_t submissions = device.statistics().submissions - before;  // status() makes some of its own
        const std::string status = frame.status();
        std::printf("%s: %s, frame %u: %.2f ms, submissions: %llu%s%s\n", device.properties().name.c_str(),
                    a.method.c_str(), i, 1e3 * seconds, static_cast<unsigned long long>(submissions),
                    status.empty() ? "" : ", ", status.c_str());
        save(numbered(a, i, steps.size()), frame.picture(view_of(a.show)));
    }
}

void run_window(const Arguments& a) {
    window::Window window("Shadows", {a.size[0], a.size[1]});
    const SceneAt scene_at = scene_of(a.scene);
    path::Step start = path_of(a, scene_at(a.time)).front();
    Choice choice{a.settings, method_of(a.method), view_of(a.show), a.time, false};
    show_at(window, choice, start.view, start.light, scene_at,
            [&](const picture::Picture& picture) { save(a.out, picture); });
}

/// CLI::Range lets "nan" through.
const CLI::Validator finite(
    [](const std::string& text) {
        float value = 0;
        return CLI::detail::lexical_cast(text, value) && std::isfinite(value) ? "" : text + " is not a finite number";
    },
    "FINITE");

const CLI::Validator picture_name(
    [](const std::string& name) {
        const std::string end = std::filesystem::path(name).extension();
        return end == ".png" || end == ".exr" ? "" : name + ": pictures are .png or .exr files";
    },
    "PNG|EXR");

void add_knobs(CLI::App& app, Settings& s) {
    app.add_option("--cells", s.cells, "of a page along each axis")
        ->check(CLI::IsMember({16, 32, 64}))
        ->capture_default_str();
    app.add_option("--levels", s.levels,
                   "of a map, of a point light's six maps each (at most 11): the finest has cells * 2^(levels - 1) "
                   "cells a side")
        ->check(CLI::Range(2u, most_levels))
        ->capture_default_str();
    app.add_option("--pages", s.pages, "that the pool has room for")
        ->check(CLI::Range(1u, 65536u))
        ->capture_default_str();
    app.add_option("--pairs", s.pairs, "of a triangle and a page that there is room for")
        ->check(CLI::Range(1u, 50'000'000u))
        ->capture_default_str();
    app.add_option("--standard", s.standard,
                   "texels along each side of the standard map; of each of a point light's six half as many")
        ->check(CLI::Range(16u, 16384u))
        ->capture_default_str();
    app.add_option(
           "--bias", s.bias,
           "A distance, as a part of the light's range: so much nearer to the light is what it shines on taken to be")
        ->check(finite)
        ->capture_default_str();
    app.add_option("--analysis", s.step, "every so many pixels along each axis ask for pages")
        ->check(CLI::IsMember({1, 2, 4, 8}))
        ->capture_default_str();
    app.add_option("--finest", s.finest, "no finer level than this one, 0 to levels - 1")->capture_default_str();
    app.add_option("--seed-level", s.seed, "asm: the finest level that is there from the beginning")
        ->capture_default_str();
    app.add_option("--rounds", s.rounds, "asm: at most so many")->check(CLI::Range(1u, 32u))->capture_default_str();
    app.add_flag("--fill-by-kernel,!--fill-by-draws", s.by_kernel,
                 "How depths get into pages: by kernels unless by draws");
    app.add_option_function<std::string>(
           "--filter", [&s](const std::string& name) { s.filter = filter_of(name); },
           "nearest, bilinear (2 x 2 comparisons) or trilinear (between levels, too)")
        ->check(CLI::IsMember({"nearest", "bilinear", "trilinear"}))
        ->default_str("bilinear");
    app.add_flag("--cached", s.cached, "Pages stay from frame to frame; scene and light stand still");
    app.add_option_function<std::string>(
           "--light", [&s](const std::string& name) { s.light = light_of(name); },
           "directional, or where the light's eye is: spot or point, which has six maps in its quadtree")
        ->check(CLI::IsMember({"directional", "spot", "point"}))
        ->default_str("directional");
}

void add_walks(CLI::App& app, Arguments& a) {
    app.add_option("--agreement", a.agreement,
                   "Goes over all scenes along the recorded paths and writes to a file of JSON lines how many pixels "
                   "decide as rays do; 1024 x 1024 unless --size is given");
    app.add_option("--popping", a.popping,
                   "The same along slow paths: how many pixels change from frame to frame where nothing does");
    app.add_option("--scenes", a.walk.scenes, "Only these, with commas between them")->delimiter(',');
    app.add_option("--paths", a.walk.paths, "The folder of the recorded paths")->capture_default_str();
    app.add_option("--pictures", a.pictures, "The folder for pictures of the worst frames");
}

void add_options(CLI::App& app, Arguments& a) {
    app.add_option("--scene", a.scene,
                   "A generated scene (hairball, fence, robot, skeletons, city, trees) or a mesh file")
        ->capture_default_str();
    app.add_option("--method", a.method, "How shadows are made")
        ->check(CLI::IsMember({"rmsm", "asm", "standard"}))
        ->capture_default_str();
    app.add_option("--show", a.show, "What the picture shows")
        ->check(CLI::IsMember({"picture", "levels", "borders", "map", "pool"}))
        ->capture_default_str();
    app.add_option("--time", a.time, "The moment in the scene, in seconds")->check(finite)->capture_default_str();
    app.add_option("--frames", a.frames, "So many, on a way around the scene; of recorded paths at most so many")
        ->check(CLI::Range(1u, 100000u));
    app.add_option("--approach", a.way.closer, "and at the end of it so many times closer")
        ->check(CLI::Range(0.01f, 1000.0f) & finite)
        ->capture_default_str();
    app.add_option("--turn", a.way.turn, "and a frame so many radians to the left around it")
        ->check(finite)
        ->capture_default_str();
    app.add_option("--path", a.path, "A file that says where camera and light are in each frame");
    app.add_option("--write-path", a.write_path, "Writes such a file");
    app.add_option("--size", a.size, "Width and height in pixels")
        ->expected(2)
        ->check(CLI::Range(1, 8192))
        ->capture_default_str();
    app.add_option("--right", a.from_right, "The camera, so far to the right around the scene, in radians")
        ->check(finite)
        ->capture_default_str();
    app.add_option("--up", a.from_above, "and upwards")->check(finite)->capture_default_str();
    app.add_option("--closer", a.closer, "and so many times closer")
        ->check(CLI::Range(0.01, 1000.0) & finite)
        ->capture_default_str();
    app.add_option("--light-right", a.light_from_right, "The light, so far to the right around the scene")
        ->check(finite)
        ->capture_default_str();
    app.add_option("--light-closer", a.light_closer, "and so many times closer")
        ->check(CLI::Range(0.01, 1000.0) & finite)
        ->capture_default_str();
    app.add_flag("--compare", a.compare,
                 "All methods beside rays: shares that agree, and a picture of the differences");
    app.add_flag("--window", a.window, "Show it in a window: camera, light, knobs, and what the quadtree is made of");
    app.add_option("--out", a.out, "The picture to write, PNG or EXR")->check(picture_name)->capture_default_str();
    app.footer("GLIFT_DEVICE=gpu|lavapipe|host|NAME chooses the device.");
}

/// Makes options exclude each other: those whose values a path file gives exclude --path; those that a walk along
/// recorded paths (--agreement, --popping) does not use exclude these two.
void exclude(CLI::App& app) {
    for (const char* way : {"--right", "--up", "--closer", "--light-right", "--light-closer", "--approach", "--turn"})
        for (const char* path : {"--path", "--agreement", "--popping"})
            app.get_option(way)->excludes(app.get_option(path));
    for (const char* one :
         {"--scene", "--method", "--show", "--time", "--path", "--write-path", "--compare", "--window", "--out"})
        for (const char* walk : {"--agreement", "--popping"}) app.get_option(one)->excludes(app.get_option(walk));
    app.get_option("--path")->excludes("--time");
    app.get_option("--agreement")->excludes("--popping");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Shadow maps in a quadtree");
    Arguments arguments;
    add_options(app, arguments);
    add_walks(app, arguments);
    add_knobs(app, arguments.settings);
    exclude(app);
    CLI11_PARSE(app, argc, argv);
    arguments.is_sized = app.count("--size") > 0;
    try {
        if (arguments.window) run_window(arguments);
        else if (!arguments.agreement.empty())
            measure_agreement(walk_of(arguments), arguments.agreement, arguments.pictures);
        else if (!arguments.popping.empty()) run_popping(arguments);
        else run(arguments);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "shadows: %s\n", error.what());
        return 1;
    }
}
