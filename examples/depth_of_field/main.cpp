// Pictures through a lens, from pinhole pictures with distances: dof.glift from C++.
#include "dof.glift.hpp"
#include "input.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace {

using picture::Picture;

struct Arguments {
    std::string scene = "fence", colour, depth, foreground;
    float time = 0.4f;
    std::vector<std::uint32_t> size = {960, 640};
    input::Camera camera;
    input::Cuts cuts;
    unsigned layers = 2, reference = 0;
    bool blurred = false;
    std::string visualise, out = "depth_of_field.png", pinhole;
};

/// The structures of one picture on a device.
struct Images {
    dof::Picture colour;
    dof::Distances distances;

    Images(const glift::Device& device, const Picture& picture)
        : colour(device, {picture.width, picture.height}), distances(device, {picture.width, picture.height}) {
        colour.write(picture.pixels);
        distances.write(picture.depth);
    }
};

dof::Lens lens_of(const input::Camera& camera, std::uint32_t width) {
    return {camera.focal, camera.aperture(), camera.focus, static_cast<float>(width) / camera.film_width};
}

class Solver {
public:
    Solver(const Arguments& arguments, const input::Layers& layers)
        : arguments_(arguments), lens_(lens_of(arguments.camera, layers.all.width)), device_(glift::Device::open()),
          all_(device_, layers.behind ? *layers.behind : layers.all),
          result_(device_, {layers.all.width, layers.all.height}),
          composed_(device_, {layers.all.width, layers.all.height}) {
        if (layers.front) front_.emplace(device_, *layers.front);
        if (layers.back) back_.emplace(device_, *layers.back);
    }

    /// One submission for each call.
    void run() {
        if (arguments_.layers == 1) dof::one_layer(device_, all_.colour, all_.distances, lens_, result_);
        else if (back_)
            dof::two_pictures(device_, all_.colour, all_.distances, back_->colour, back_->distances, lens_,
                              arguments_.cuts.back, result_);
        else if (arguments_.blurred)
            dof::two_layers_blurred(device_, all_.colour, all_.distances, lens_, arguments_.cuts.back, result_);
        else dof::two_layers_raised(device_, all_.colour, all_.distances, lens_, arguments_.cuts.back, result_);
        if (front_) {
            dof::foreground(device_, front_->colour, front_->distances, lens_, arguments_.cuts.front, result_,
                            composed_);
        }
        device_.wait();
    }
    Picture result() {
        const dof::Picture& last = front_ ? composed_ : result_;
        return {last.extent().x, last.extent().y, last.read(), {}};
    }
    const std::string& device_name() const { return device_.properties().name; }
    const dof::Lens& lens() const { return lens_; }

private:
    const Arguments& arguments_;
    dof::Lens lens_;
    glift::Device device_;
    Images all_;
    std::optional<Images> front_, back_;
    dof::Picture result_, composed_;
};

Picture of_circles(const Picture& picture, const dof::Lens& lens) {
    const glift::Device device = glift::Device::open();
    const Images images(device, picture);
    dof::Picture circles(device, {picture.width, picture.height});
    dof::circle_picture(device, images.distances, lens, circles);
    return {picture.width, picture.height, circles.read(), {}};
}

/// Foreground red, midground green, background blue.
Picture of_layers(const Picture& picture, const input::Camera& camera, const input::Cuts& cuts) {
    Picture made{picture.width, picture.height, {}, {}};
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const float z = picture.depth[i];
        const unsigned layer = z < cuts.front_distance(camera) ? 0 : z < cuts.back_distance(camera) ? 1 : 2;
        glift::float4 colour = picture.pixels[i] * 0.4f;
        colour[layer] += 0.4f;
        colour.w = 1;
        made.pixels.push_back(colour);
    }
    return made;
}

void time(Solver& solver, const Picture& picture) {
    solver.run();  // compiles shaders
    double best = 1e30;
    for (int round = 0; round < 3; ++round) {
        const auto start = std::chrono::steady_clock::now();
        solver.run();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::printf("%s: %.2f ms a picture of %u x %u\n", solver.device_name().c_str(), 1e3 * best, picture.width,
                picture.height);
}

/// Root of the mean squared difference of what screens show.
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

/// `name.png` becomes `name.suffix.png`.
std::string beside(const std::string& path, const std::string& suffix) {
    std::filesystem::path made(path);
    return made.replace_extension("." + suffix + made.extension().string()).string();
}

void save(const std::string& path, const Picture& picture) {
    picture::write(path, picture);
    std::printf("wrote %s\n", path.c_str());
}

void compare(const Arguments& a, const Picture& result) {
    if (!a.colour.empty()) throw std::runtime_error("--reference needs a scene: many pinholes are drawn of it");
    const Picture reference = input::reference(a.scene, a.time, result.width, result.height, a.camera, a.reference);
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

void run(const Arguments& a) {
    input::check(a.camera);
    const input::Layers layers =
        a.colour.empty() ? input::of_scene(a.scene, a.time, a.size[0], a.size[1], a.camera, a.cuts, a.layers)
                         : input::of_files(a.colour, a.depth, a.foreground);
    if (!a.pinhole.empty()) save(a.pinhole, layers.all);
    const dof::Lens lens = lens_of(a.camera, layers.all.width);
    if (a.visualise == "circles") return save(a.out, of_circles(layers.all, lens));
    if (a.visualise == "layers") return save(a.out, of_layers(layers.all, a.camera, a.cuts));
    Solver solver(a, layers);
    time(solver, layers.all);
    const Picture result = solver.result();
    save(a.out, result);
    if (a.reference) compare(a, result);
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
    app.add_option("--focal", a.camera.focal, "Focal length in metres")->capture_default_str();
    app.add_option("--f-stop", a.camera.f_stop, "Focal length / aperture")->capture_default_str();
    app.add_option("--focus", a.camera.focus, "Distance of what is sharp, in metres")->capture_default_str();
    app.add_option("--film", a.camera.film_width, "Width of the film in metres")->capture_default_str();
    app.add_option("--layers", a.layers, "1; 2: the background by itself; 3: the foreground, too")
        ->check(CLI::Range(1, 3))
        ->capture_default_str();
    app.add_option("--front-cut", a.cuts.front, "Where the foreground ends, as a part of the largest circle")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    app.add_option("--back-cut", a.cuts.back, "Where the background begins, likewise")
        ->check(CLI::Range(0.01, 0.99))
        ->capture_default_str();
    app.add_flag("--blurred", a.blurred, "Two layers: blur the background's circles instead of raising them");
    app.add_option("--visualise", a.visualise, "Write circles or layers instead")
        ->check(CLI::IsMember({"circles", "layers"}));
    app.add_option("--pinhole", a.pinhole, "Also write the picture that is begun with, PNG or EXR");
    app.add_option("--reference", a.reference, "Also draw the scene through so many points of the lens, and compare");
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
        run(arguments);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "depth_of_field: %s\n", error.what());
        return 1;
    }
}
