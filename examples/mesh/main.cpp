// A picture of a mesh from a file, or of a generated scene: mesh_picture.glift from C++.
#include "mesh_picture.glift.hpp"

#include "examples/common/camera.h"
#include "examples/common/mesh.h"
#include "examples/common/picture.h"
#include "examples/common/scenes/scenes.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace {

struct Arguments {
    std::string what = "robot", out = "mesh.png";
    std::vector<std::uint32_t> size = {960, 640};
    float turn = 0.6f, time = 0.4f;
    unsigned rounds = 0;
};

/// The generated scene of this name, with its own view; or a mesh from a file, seen from a little above, turned around
/// its middle.
scenes::Scene scene_of(const Arguments& arguments) {
    if (!std::filesystem::exists(arguments.what)) return scenes::make(arguments.what, arguments.time);
    scenes::Scene scene;
    scene.mesh = mesh::read(arguments.what);
    mesh::normalise(scene.mesh);
    const mesh::Box box = mesh::bounds_of(scene.mesh);
    scene.view.target = (box.low + box.high) * 0.5f;
    scene.view.eye =
        scene.view.target + glift::float3(std::sin(arguments.turn), 0.35f, std::cos(arguments.turn)) * 1.6f;
    scene.view.near = 0.05f;
    scene.view.far = 5.0f;
    scene.light.eye = scene.view.target + glift::float3(1, 2, 1.5f);
    scene.light.target = scene.view.target;
    return scene;
}

glift::float3 unit(const glift::float3& v) { return v * (1.0f / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z)); }

/// The shortest time of several runs, in milliseconds.
template <class Work> double shortest(unsigned rounds, const Work& work) {
    double best = 1e30;
    for (unsigned round = 0; round < rounds; ++round) {
        const auto start = std::chrono::steady_clock::now();
        work();
        best =
            std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

std::string picture_of(const Arguments& arguments) {
    const scenes::Scene scene = scene_of(arguments);
    const glift::Device device = glift::Device::open();
    const auto points = static_cast<std::uint32_t>(scene.mesh.points.size());
    mesh_picture::Corners corners(device, static_cast<std::uint32_t>(scene.mesh.corners.size()));
    mesh_picture::Points places(device, points), colours(device, points);
    mesh_picture::Colour picture(device, {arguments.size[0], arguments.size[1]});
    corners.write(scene.mesh.corners);
    places.write(scene.mesh.points);
    colours.write(scene.mesh.colours);
    const float aspect = static_cast<float>(arguments.size[0]) / static_cast<float>(arguments.size[1]);
    const auto draw = [&] {
        mesh_picture::render(device, corners, places, colours, camera::projection_of(scene.view, aspect),
                             scene.view.eye, unit(scene.light.eye - scene.light.target),
                             {scene.sky.x, scene.sky.y, scene.sky.z, 1}, picture);
        device.wait();
    };
    draw();
    if (arguments.rounds) std::printf("%.2f ms a picture\n", shortest(arguments.rounds, draw));
    picture::write(arguments.out, {arguments.size[0], arguments.size[1], picture.read(), {}});
    return device.properties().name + ": " + std::to_string(scene.mesh.triangles()) + " triangles in " + arguments.out;
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app{"Draws a mesh, or a generated scene, into a picture"};
    app.add_option("mesh", arguments.what,
                   "A file (PLY, OBJ, glTF, …), or hairball, fence, robot, skeletons, city, trees");
    app.add_option("-o,--out", arguments.out, "The picture: .png or .exr");
    app.add_option("--size", arguments.size, "Width and height")->expected(2)->check(CLI::Range(1, 16384));
    app.add_option("--turn", arguments.turn, "A mesh from a file: turned by so many radians");
    app.add_option("--rounds", arguments.rounds, "Draw so often, and say the shortest time");
    app.add_option("--time", arguments.time, "A scene: the moment, in seconds");
    CLI11_PARSE(app, argc, argv);
    try {
        std::printf("%s\n", picture_of(arguments).c_str());
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "mesh: %s\n", error.what());
        return 1;
    }
}
