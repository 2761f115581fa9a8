// Photographs of scenes, and of pinhole pictures with distances: photograph.glift and dof.glift from C++.
#include "dof.glift.hpp"
#include "input.h"
#include "photograph.glift.hpp"

#include <glift/host/math.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace {

using picture::Picture;

struct Arguments {
    std::string scene = "fence", colour, depth, foreground;
    float time = 0.4f;
    std::vector<std::uint32_t> size = {960, 640};
    input::Camera camera;
    photograph::Cuts cuts{0.1f, 0.5f};
    unsigned layers = 2, reference = 0;
    bool blurred = false;
    std::string visualise, out = "depth_of_field.png", pinhole;

    glift::uint holes() const { return blurred ? dof::Holes::blurred : dof::Holes::raised; }
};

/// A picture on a device.
struct Images {
    dof::Picture colour;
    dof::Distances distances;

    Images(const glift::Device& device, glift::uint2 size) : colour(device, size), distances(device, size) {}
    Images(const glift::Device& device, const Picture& picture)
        : Images(device, glift::uint2(picture.width, picture.height)) {
        colour.write(picture.pixels);
        distances.write(picture.depth);
    }
    Picture read() const { return {colour.extent().x, colour.extent().y, colour.read(), distances.read()}; }
};

Picture read(const dof::Picture& made) { return {made.extent().x, made.extent().y, made.read(), {}}; }

dof::Lens lens_of(const input::Camera& camera, std::uint32_t width) {
    return {camera.focal, camera.aperture(), camera.focus, static_cast<float>(width) / camera.film_width};
}

/// What is in front of the lens: pinhole pictures, and photographs of them.
class Subject {
public:
    Subject(const Arguments& arguments, glift::Device device, glift::uint2 size)
        : arguments_(arguments), device_(std::move(device)), lens_(lens_of(arguments.camera, size.x)),
          result_(device_, size) {}
    virtual ~Subject() = default;

    /// One submission for each call.
    virtual void photograph() = 0;
    virtual const Images& pinhole() const = 0;
    /// Of so many pinholes all over the lens.
    virtual Picture reference(unsigned places) = 0;

    Picture result() const { return read(result_); }
    Picture circles() const {
        photograph::circle_picture(device_, pinhole().distances, lens_, result_);
        return result();
    }
    Picture layers() const {
        photograph::layer_picture(device_, pinhole().colour, pinhole().distances, lens_, arguments_.cuts, result_);
        return result();
    }
    const glift::Device& device() const { return device_; }

protected:
    const Arguments& arguments_;
    glift::Device device_;
    dof::Lens lens_;
    dof::Picture result_;
};

/// Triangles, which are drawn for each photograph.
class Scene : public Subject {
public:
    Scene(const Arguments& arguments, glift::Device device, const scenes::Scene& scene)
        : Subject(arguments, std::move(device), {arguments.size[0], arguments.size[1]}),
          corners_(device_, static_cast<std::uint32_t>(scene.mesh.corners.size())),
          points_(device_, static_cast<std::uint32_t>(scene.mesh.points.size())),
          colours_(device_, static_cast<std::uint32_t>(scene.mesh.points.size())), pinhole_(device_, result_.extent()) {
        corners_.write(scene.mesh.corners);
        points_.write(scene.mesh.points);
        colours_.write(scene.mesh.colours);
        view_ = {camera::projection_of(scene.view, aspect_of(arguments)), scene.view.eye,
                 glift::normalize(scene.light.eye - scene.light.target), scene.sky, scene.view.far};
    }
    static float aspect_of(const Arguments& arguments) {
        return static_cast<float>(arguments.size[0]) / static_cast<float>(arguments.size[1]);
    }

    void photograph() override {
        photograph::photograph(device_, corners_, points_, colours_, view_, lens_, arguments_.layers, arguments_.cuts,
                               arguments_.holes(), pinhole_.colour, pinhole_.distances, result_);
    }
    const Images& pinhole() const override { return pinhole_; }
    Picture reference(unsigned places) override {
        const dof::Picture mean(device_, result_.extent());
        photograph::many_pinholes(device_, corners_, points_, colours_, view_, lens_, places, mean);
        return read(mean);
    }

private:
    photograph::Corners corners_;
    photograph::Points points_, colours_;
    photograph::Viewpoint view_;
    Images pinhole_;
};

/// Pictures from files.
class Files : public Subject {
public:
    Files(const Arguments& arguments, glift::Device device, const input::Pictures& pictures)
        : Subject(arguments, std::move(device), {pictures.all.width, pictures.all.height}), all_(device_, pictures.all),
          without_front_(device_, result_.extent()) {
        if (pictures.front) front_.emplace(device_, *pictures.front);
        else if (arguments.layers == 3) throw std::runtime_error("a third layer of a picture needs --foreground");
    }

    void photograph() override {
        const dof::Picture& to = front_ ? without_front_ : result_;
        if (arguments_.layers == 1) dof::one_layer(device_, all_.colour, all_.distances, lens_, to);
        else dof::two_layers(device_, all_.colour, all_.distances, lens_, arguments_.cuts.back, arguments_.holes(), to);
        if (front_)
            dof::foreground(device_, front_->colour, front_->distances, lens_, arguments_.cuts.front, to, result_);
    }
    const Images& pinhole() const override { return all_; }
    Picture reference(unsigned) override {
        throw std::runtime_error("--reference needs a scene: many pinholes are drawn of it");
    }

private:
    Images all_;
    std::optional<Images> front_;
    dof::Picture without_front_;
};

std::unique_ptr<Subject> subject_of(const Arguments& a) {
    if (!a.colour.empty())
        return std::make_unique<Files>(a, glift::Device::open(), input::pictures(a.colour, a.depth, a.foreground));
    return std::make_unique<Scene>(a, glift::Device::open(),
                                   input::scene(a.scene, a.time, a.camera, Scene::aspect_of(a)));
}

void time(Subject& subject) {
    const glift::Device& device = subject.device();
    subject.photograph();  // compiles shaders
    device.wait();
    const std::uint64_t before = device.statistics().submissions;
    constexpr unsigned rounds = 5;
    double best = 1e30;
    for (unsigned round = 0; round < rounds; ++round) {
        const auto start = std::chrono::steady_clock::now();
        subject.photograph();
        device.wait();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    const double submissions = static_cast<double>(device.statistics().submissions - before) / rounds;
    std::printf("%s: %.2f ms and %g submissions a photograph\n", device.properties().name.c_str(), 1e3 * best,
                submissions);
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

void run(const Arguments& a) {
    input::check(a.camera);
    const std::unique_ptr<Subject> subject = subject_of(a);
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
