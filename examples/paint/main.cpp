// Paint on any mesh, kept in an octree by its rest position: paint.glift from C++.
#include "canvas.h"
#include "strokes.h"

#include <glift/host/math.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

namespace {

using glift::float3;

struct Arguments {
    std::string model, strokes, load, save, out = "paint.png";
    std::vector<std::uint32_t> size = {1024, 1024};
    OctreeSize octree;
    unsigned undo = 0, redo = 0;
    float turn = 0.6f, upwards = 0.3f, closer = 1;
    std::vector<float> target;
    painted::Layers layers;
};

camera::Camera camera_of(const Arguments& a, const mesh::Mesh& mesh) {
    const mesh::Box box = mesh::bounds_of(mesh);
    camera::Camera camera;
    camera.target = a.target.empty() ? (box.low + box.high) * 0.5f : float3(a.target[0], a.target[1], a.target[2]);
    camera.eye = camera.target + float3(0, 0, 1.6f);
    camera.near = 0.02f;
    camera.far = 6;
    return camera::orbited(camera, -a.turn, a.upwards, a.closer);
}

void run(const Arguments& a) {
    mesh::Mesh mesh = mesh::read(a.model);
    mesh::normalise(mesh);
    std::vector<strokes::Stroke> all;
    if (!a.strokes.empty()) all = strokes::read(a.strokes);
    Canvas canvas(glift::Device::open(), mesh, a.octree);
    canvas.device().wait();
    const auto start = std::chrono::steady_clock::now();
    std::size_t dabs = 0;
    if (!a.load.empty()) canvas.load(a.load);
    for (const strokes::Stroke& stroke : all) {
        if (const glift::uint lost = canvas.paint(stroke))
            std::printf("stroke %td: %u requests for pages found no room: give more of them by --pages\n",
                        &stroke - all.data() + 1, lost);
        dabs += strokes::dabs_of(stroke).size();
    }
    for (unsigned i = 0; i < a.undo && canvas.undo(); ++i) {}
    for (unsigned i = 0; i < a.redo && canvas.redo(); ++i) {}
    canvas.device().wait();
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    const auto status = canvas.octree().status(canvas.device());
    std::printf("%s: %zu triangles, %zu strokes, %zu dabs, %.1f ms a dab; %u of %u pages\n",
                canvas.device().properties().name.c_str(), mesh.triangles(), all.size(), dabs,
                ms / static_cast<double>(std::max<std::size_t>(dabs, 1)), status.resident, status.capacity);
    if (!a.save.empty()) canvas.save(a.save);
    picture::write(a.out, canvas.render(camera_of(a, mesh), {a.size[0], a.size[1]}, a.layers));
    std::printf("wrote %s\n", a.out.c_str());
}

void add_options(CLI::App& app, Arguments& a) {
    const auto is_power = [](const std::string& text) {
        return std::has_single_bit(std::stoul(text)) ? std::string() : "must be a power of two, such as 512";
    };
    app.add_option("model", a.model, "A mesh: any file that assimp reads (PLY, OBJ, glTF, …)")->required();
    app.add_option("--strokes", a.strokes, "A file of strokes to paint, a JSON object a line");
    app.add_option("--load", a.load, "Paint from a file, to begin with");
    app.add_option("--save", a.save, "A file for the paint");
    app.add_option("--undo", a.undo, "Undo so many strokes at the end")->capture_default_str();
    app.add_option("--redo", a.redo, "and do so many of them again")->capture_default_str();
    app.add_option("--size", a.size, "Width and height of the picture")->expected(2)->check(CLI::Range(1, 16384));
    app.add_option("--resolution", a.octree.resolution, "Cells of the octree along each side, 64 to 2048")
        ->check(CLI::Range(64u, 2048u))
        ->check(is_power)
        ->capture_default_str();
    app.add_option("--pages", a.octree.pages, "of 17^3 texels that there may be")
        ->check(CLI::Range(1u, 1u << 20))
        ->capture_default_str();
    app.add_option("--turn", a.turn, "Where it is seen from, in radians around it")->capture_default_str();
    app.add_option("--upwards", a.upwards, "and above it")->capture_default_str();
    app.add_option("--closer", a.closer, "by a factor")->check(CLI::Range(0.1f, 1000.0f))->capture_default_str();
    app.add_option("--target", a.target, "What is looked at, instead of the middle")->expected(3);
    app.add_flag("--levels", a.layers.levels, "Show the levels of pages by colours");
    app.add_flag("--borders", a.layers.borders, "Show where pages meet");
    app.add_option("--out", a.out, "The picture to write, PNG or EXR")->capture_default_str();
    app.footer("GLIFT_DEVICE=gpu|lavapipe|host|NAME chooses the device.");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Paint on a mesh, in an octree");
    Arguments arguments;
    add_options(app, arguments);
    CLI11_PARSE(app, argc, argv);
    try {
        run(arguments);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "paint: %s\n", error.what());
        return 1;
    }
}
