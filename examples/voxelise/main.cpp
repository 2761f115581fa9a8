// A mesh from a file as voxels of a sparse grid and as distances in an adaptive octree: voxels.glift and
// distances.glift from C++.
#include "../common/mesh.h"
#include "../common/picture.h"
#include "../common/progress.h"
#include "../common/scenes/scenes.h"
#include "distances.glift.hpp"
#include "voxel_pictures.glift.hpp"
#include "voxels.glift.hpp"

#include <glift/host/math.h>
#include <glift/inspect.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

using glift::float3;

constexpr std::uint32_t most_columns = 1u << 30;  ///< equals `most_columns` in voxels.glift

struct Arguments {
    std::string what = "robot";
    std::uint32_t extent = 512, voxel_pages = 40000, tree_pages = 50000, size = 640;
    float turn = 0.6f, slice = 0.5f;
    std::filesystem::path out = ".";
    bool inspects = false;
};

void add_options(CLI::App& app, Arguments& a) {
    const auto is_power = [](const std::string& text) {
        return std::has_single_bit(std::stoul(text)) ? std::string() : "must be a power of two, such as 512";
    };
    app.add_option("mesh", a.what, "A file (PLY, OBJ, glTF, …), or hairball, fence, robot, skeletons, city, trees");
    app.add_option("--extent", a.extent, "voxels along each side: a power of two")
        ->check(CLI::Range(32u, 4096u))
        ->check(is_power)
        ->capture_default_str();
    app.add_option("--pages", a.voxel_pages, "of 8^3 voxels that there may be")->capture_default_str();
    app.add_option("--tree-pages", a.tree_pages, "of 8^3 cells that there may be")->capture_default_str();
    app.add_option("--turn", a.turn, "where it is seen from, in radians")->capture_default_str();
    app.add_option("--slice", a.slice, "how far along z the slices lie, 0 to 1")
        ->check(CLI::Range(0.0f, 1.0f))
        ->capture_default_str();
    app.add_option("--size", a.size, "of a picture's side")->check(CLI::Range(16u, 8192u))->capture_default_str();
    app.add_option("--out", a.out, "folder of the pictures")->capture_default_str();
    app.add_flag("--inspect", a.inspects, "also the structures themselves, for tools/inspect");
}

mesh::Mesh mesh_of(const std::string& what) {
    if (std::filesystem::exists(what)) return mesh::read(what);
    return scenes::make(what, 0.4f).mesh;
}

/// Places the mesh in the middle of the grid, with at least eight free voxels on each side.
voxels::Placement placement_of(const mesh::Mesh& mesh, std::uint32_t extent) {
    const mesh::Box box = mesh::bounds_of(mesh);
    const float3 size = box.high - box.low, middle = (box.low + box.high) * 0.5f;
    const float side = static_cast<float>(extent), longest = std::max({size.x, size.y, size.z, 1e-30f});
    const float scale = (side - 16) / longest;
    return {scale, float3{0.5f * side, 0.5f * side, 0.5f * side} - middle * scale};
}

/// A view from a little above the middle.
voxel_pictures::Viewpoint view_of(float turn, std::uint32_t extent) {
    const float side = static_cast<float>(extent);
    const float3 middle{0.5f * side, 0.5f * side, 0.5f * side};
    const float3 eye = middle + float3{std::sin(turn), 0.35f, std::cos(turn)} * (1.9f * side);
    const float3 forward = glift::normalize(middle - eye), right = glift::normalize(glift::cross(forward, {0, 1, 0}));
    const float3 light = glift::normalize(right * -0.5f + float3{0, 0.9f, 0} - forward * 0.5f);
    return {eye, forward, right, glift::cross(forward, right), 0.30f, light};
}

class Run {
public:
    Run(glift::Device device, const Arguments& arguments)
        : arguments_(arguments), device_(std::move(device)),
          grid_(device_, {arguments.extent, arguments.extent, arguments.extent}, arguments.voxel_pages, {}),
          tree_(device_, static_cast<std::uint32_t>(std::bit_width(arguments.extent / 8)), arguments.tree_pages),
          picture_(device_, {arguments.size, arguments.size}) {}

    /// The number of stages that the line of progress counts: the mesh, the voxels, the octree, the pictures.
    static constexpr std::uint64_t stages = 4;

    void voxelise(const mesh::Mesh& mesh) {
        voxels::Corners corners(device_, static_cast<std::uint32_t>(mesh.corners.size()));
        voxels::Points points(device_, static_cast<std::uint32_t>(mesh.points.size()));
        corners.write(mesh.corners);
        points.write(mesh.points);
        line_.show(1, stages, "voxels");
        const voxels::Placement place = placement_of(mesh, arguments_.extent);
        std::uint32_t columns = 0;
        const double seconds = timed([&] {
            const auto recorded = voxels::voxelise(device_, corners, points, place, grid_);
            columns = recorded.await(device_);
        });
        if (columns > most_columns)
            throw std::runtime_error("the triangles are too large and too many: choose a smaller --extent");
        const auto status = grid_.status(device_);
        line_.clear();
        std::printf(
            "%s: %zu triangles in %u^3: %u voxels in %u pages (%.2f %% of the domain), %.1f ms, submissions: %llu\n",
            device_.properties().name.c_str(), mesh.triangles(), arguments_.extent,
            voxels::touched(device_, grid_).await(device_), status.resident, percent(status.resident), 1e3 * seconds,
            static_cast<unsigned long long>(submissions_));
        if (status.refused != 0)
            throw std::runtime_error(std::to_string(status.refused) +
                                     " pages found no room: give more of them by --pages");
    }

    void measure() {
        line_.show(2, stages, "an octree of distances");
        const double seconds = timed([&] { distances::measure(device_, grid_, tree_); });
        const auto status = tree_.status(device_);
        line_.clear();
        std::printf("octree of distances: %u pages, %.1f ms, submissions: %llu\n", status.resident, 1e3 * seconds,
                    static_cast<unsigned long long>(submissions_));
        if (status.refused != 0)
            throw std::runtime_error(std::to_string(status.refused) +
                                     " pages found no room: give more of them by --tree-pages");
    }

    void draw() {
        const auto view = view_of(arguments_.turn, arguments_.extent);
        const auto z = static_cast<std::uint32_t>(arguments_.slice * static_cast<float>(arguments_.extent - 1));
        const auto side = static_cast<float>(arguments_.extent);
        line_.show(3, stages, "pictures");
        voxel_pictures::voxels_by_rays(device_, picture_, grid_, view, picture_);
        write("voxels.png");
        voxel_pictures::slice_of_grid(device_, picture_, grid_, z, picture_);
        write("voxels_slice.png");
        voxel_pictures::distances_by_rays(device_, picture_, tree_, side, view, picture_);
        write("distances.png");
        voxel_pictures::slice_of_tree(device_, picture_, tree_, z, side, picture_);
        write("distances_slice.png");
    }

    /// Saves the grid and the octree for tools/inspect; the octree as it is addressed by {node, level}.
    void inspect() {
        save(glift::inspect(grid_, "voxels"), "voxels_pages.inspection");
        const distances::Nodes nodes(device_, tree_.best(), tree_.frames(), tree_.levels());
        save(glift::inspect(nodes, "distances"), "distances_pages.inspection");
    }

private:
    template <class Work> double timed(const Work& work) {
        device_.wait();
        const std::uint64_t before = device_.statistics().submissions;
        const auto start = std::chrono::steady_clock::now();
        work();
        device_.wait();
        submissions_ = device_.statistics().submissions - before;
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    double percent(std::uint32_t pages) const { return 100 * pages / std::pow(arguments_.extent / 8.0, 3); }

    void save(const glift::Inspection& inspection, const std::string& name) {
        const std::filesystem::path file = arguments_.out / name;
        inspection.save(file.string());
        line_.clear();
        std::printf("tools/inspect %s draws it\n", file.c_str());
    }

    void write(const std::string& name) {
        const std::filesystem::path file = arguments_.out / name;
        picture::write(file.string(), {arguments_.size, arguments_.size, picture_.read(), {}});
        line_.clear();
        std::printf("picture: %s\n", file.c_str());
    }

    Arguments arguments_;
    glift::Device device_;
    voxels::Grid grid_;
    distances::Tree tree_;
    voxel_pictures::Picture picture_;
    progress::Line line_{"stage"};
    std::uint64_t submissions_ = 0;  ///< number of submissions of the work that was timed last
};

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app{"Makes voxels and an octree of distances of a mesh, and pictures of both."};
    add_options(app, arguments);
    CLI11_PARSE(app, argc, argv);
    try {
        std::filesystem::create_directories(arguments.out);
        const mesh::Mesh mesh = mesh_of(arguments.what);
        Run run(glift::Device::open(), arguments);
        run.voxelise(mesh);
        run.measure();
        run.draw();
        if (arguments.inspects) run.inspect();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "voxelise: %s\n", error.what());
        return 1;
    }
}
