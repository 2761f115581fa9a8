// bench_paint: times a dab of paint and the end of its stroke (paint_dab.h), then five ways to draw a painted model
// (examples/paint). All clear a picture and its depths and draw all triangles with the same light; they differ in where
// colours come from and when. Colours come from the octree ("paint", as in the example, and "paint at once"), from a
// dense 3-D image of the same paint ("dense", "dense after"), or are one colour ("plain"). In "paint" and "dense after"
// the draw finds the point that each pixel sees, and a kernel over pixels then looks up its colour; in "dense" and
// "paint at once" each fragment looks up its colour in the draw.
//
//     bench_paint [MODEL] [--strokes FILE | --load FILE] [--sizes 512x512,1920x1080] [--runs N] [--json FILE]
//     bench_paint [MODEL] --only-dabs [--dab-sizes 512,1024] [--dab-radius 64]
#include "paint_dab.h"
#include "picture_size.h"
#include "timing.h"

#include "examples/paint/canvas.h"
#include "examples/paint/model.h"

// After canvas.h: the first generated header that is included defines the octree's class, and paint_draws.glift.hpp
// would define it without member functions that canvas.h calls.
#include "paint_draws.glift.hpp"

#include <glift/host/math.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <bit>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using glift::float3;
using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 5> ways = {"plain", "dense", "paint", "dense_after", "paint_at_once"};

struct Options {
    std::string model = "knot", strokes, load, json, pictures;
    std::vector<std::string> sizes = {"512x512", "1024x1024", "1920x1080", "3840x2160"};
    std::vector<glift::uint> dab_sizes = {512, 1024};
    float dab_radius = 64;
    bool only_dabs = false;
    OctreeSize octree;
    std::uint32_t dense = 256;
    int runs = 11;
    double seconds = 0.02, turn = 0.35, upwards = 0.2, near = 8, far = 1;
};

camera::Camera looking_at(const float3& target, float right, float upwards, float closer) {
    camera::Camera camera;
    camera.target = target;
    camera.eye = target + float3(0, 0, 1.6f);
    camera.near = 0.005f;
    camera.far = 8;
    return camera::orbited(camera, right, upwards, closer);
}

struct View {
    const char* name;
    camera::Camera camera;
};

/// Two views: of the whole model, and from near of what is in the middle of the first view.
std::vector<View> views_of(const mesh::Mesh& mesh, const Options& o) {
    const mesh::Box box = mesh::bounds_of(mesh);
    const auto right = static_cast<float>(o.turn), upwards = static_cast<float>(o.upwards);
    const camera::Camera far = looking_at((box.low + box.high) * 0.5f, right, upwards, static_cast<float>(o.far));
    const float3 towards = glift::normalize(far.target - far.eye);
    float3 nearest = far.target;
    float least = 1e9f;
    for (const float3& p : mesh.points) {
        const float along = glift::dot(p - far.eye, towards), aside = glift::length(p - far.eye - towards * along);
        const float from = along + 20 * aside;
        if (from < least) nearest = p;
        least = std::min(least, from);
    }
    return {{"far", far}, {"near", looking_at(nearest, right, upwards, static_cast<float>(o.near))}};
}

/// Strokes in rows that cover the model, painted from four sides and from above; then one with a smaller brush through
/// the middle of each view.
std::vector<strokes::Stroke> generated_strokes(const mesh::Mesh& mesh, const std::vector<View>& views) {
    const mesh::Box box = mesh::bounds_of(mesh);
    std::vector<strokes::Stroke> made;
    const auto add = [&](const camera::Camera& camera, float radius, float cells, float y) {
        strokes::Stroke stroke;
        stroke.camera = camera;
        stroke.size = {400, 400};
        stroke.brush.radius = radius;
        stroke.brush.cells = cells;
        const auto i = static_cast<float>(made.size());
        stroke.brush.colour = {0.5f + 0.4f * std::sin(i), 0.5f + 0.4f * std::sin(2 * i), 0.5f + 0.4f * std::cos(i)};
        stroke.path = {{{40, y}, 1}, {{360, y}, 1}};
        made.push_back(stroke);
    };
    const float3 middle = (box.low + box.high) * 0.5f;
    for (unsigned side = 0; side < 5; ++side)
        for (const float y : {80.0f, 160.0f, 240.0f, 320.0f})
            add(looking_at(middle, -1.5708f * static_cast<float>(side), side == 4 ? 1.4f : 0, 1), 60, 6, y);
    for (const View& view : views) add(view.camera, 16, 8, 200);
    return made;
}

void paint(const Options& o, const mesh::Mesh& mesh, const std::vector<View>& views, Canvas& canvas) {
    if (!o.load.empty()) return canvas.load(o.load);
    glift::uint lost = 0;
    for (const strokes::Stroke& stroke : o.strokes.empty() ? generated_strokes(mesh, views) : strokes::read(o.strokes))
        lost += canvas.paint(stroke);
    if (lost != 0) throw std::runtime_error("the pool is full: give more of them by --pages");
}

/// The ways to draw the model in one view, with pictures of one size.
class Draws {
public:
    Draws(Canvas& canvas, const paint_draws::Volume& volume, const camera::Camera& camera, glift::uint2 size)
        : canvas_(canvas), volume_(volume), view_(strokes::viewpoint_of(camera, size)), light_(light_of(camera)),
          film_(canvas.device(), size) {}

    void draw(const glift::Commands& commands, std::size_t way) const {
        const Model& m = canvas_.model();
        if (way == 0)
            paint_draws::render_plain(commands, m.corners(), m.posed(), view_, light_, sky, canvas_.ground(), film_);
        else if (way == 1)
            paint_draws::render_dense(commands, m.corners(), m.rest(), m.posed(), view_, light_, sky, volume_, film_);
        else if (way == 2)
            painted::render(commands, m.corners(), m.rest(), m.posed(), view_, light_, sky, canvas_.octree(), {},
                            film_);
        else if (way == 3)
            paint_draws::render_dense_after(commands, m.corners(), m.rest(), m.posed(), view_, light_, sky,
                                            canvas_.octree().levels(), volume_, film_);
        else
            paint_draws::render_at_once(commands, m.corners(), m.rest(), m.posed(), view_, light_, sky,
                                        canvas_.octree(), film_);
    }

    picture::Picture picture(std::size_t way) const {
        draw(canvas_.device().commands(), way);
        return {film_.extent().x, film_.extent().y, film_.read(), {}};
    }

private:
    Canvas& canvas_;
    const paint_draws::Volume& volume_;
    surface::Viewpoint view_;
    float3 light_;
    painted::Film film_;
};

Json measured(const Options& o, const Canvas& canvas, const Draws& draws) {
    std::vector<std::function<void(const glift::Commands&)>> works;
    for (std::size_t way = 0; way < ways.size(); ++way)
        works.emplace_back([&draws, way](const glift::Commands& commands) { draws.draw(commands, way); });
    const std::vector<double> seconds = bench::times_of(canvas.device(), works, o.runs, o.seconds);
    Json row;
    for (std::size_t way = 0; way < ways.size(); ++way) row[std::string(ways[way]) + "_seconds"] = seconds[way];
    row["paint_to_plain"] = seconds[2] / seconds[0];
    row["paint_to_dense"] = seconds[2] / seconds[1];
    row["paint_to_dense_after"] = seconds[2] / seconds[3];
    row["paint_at_once_to_dense"] = seconds[4] / seconds[1];
    return row;
}

Json rows_of(const Options& o, Canvas& canvas, const std::vector<View>& views) {
    paint_draws::Volume volume(canvas.device(), {o.dense, o.dense, o.dense});
    paint_draws::fill_volume(canvas.device(), canvas.octree(), volume);
    std::printf("| view | size | plain | dense | paint | dense after | paint at once | paint / plain | paint / dense "
                "| paint / dense after | paint at once / dense |\n"
                "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
    Json rows = Json::array();
    for (const View& view : views)
        for (const std::string& size : o.sizes) {
            const Draws draws(canvas, volume, view.camera, bench::picture_size(size));
            Json row{{"view", view.name}, {"size", size}};
            if (!o.pictures.empty())
                for (std::size_t way = 0; way < ways.size(); ++way)
                    picture::write(o.pictures + "/" + view.name + "_" + size + "_" + ways[way] + ".png",
                                   draws.picture(way));
            row.update(measured(o, canvas, draws));
            const auto of = [&](const std::string& name) { return row[name].get<double>(); };
            std::printf("| %s | %s ", view.name, size.c_str());
            for (const char* way : ways) std::printf("| %.4f ms ", 1e3 * of(std::string(way) + "_seconds"));
            std::printf("| %.3f | %.3f | %.3f | %.3f |\n", of("paint_to_plain"), of("paint_to_dense"),
                        of("paint_to_dense_after"), of("paint_at_once_to_dense"));
            std::fflush(stdout);
            rows.push_back(std::move(row));
        }
    return rows;
}

/// Dabs in the far view.
Json dabs_of(const Options& o, const glift::Device& device, const mesh::Mesh& mesh, const View& far) {
    std::printf(
        "A dab of radius %.0f on %s without paint; medians of %d runs. Device: by timestamps. Wall: of the host, "
        "a submission and the wait for it.\n\n"
        "| picture | part | device | wall | submissions | waits | new pages |\n"
        "| --- | --- | ---: | ---: | ---: | ---: | ---: |\n",
        static_cast<double>(o.dab_radius), o.model.c_str(), o.runs);
    Json rows = Json::array();
    for (const glift::uint side : o.dab_sizes)
        for (const bench::DabTime& one :
             bench::dab_times(device, mesh, o.octree, {far.camera, side, o.dab_radius, o.runs})) {
            std::printf("| %u x %u | %s | %.3f ms | %.3f ms | %llu | %llu | %u |\n", side, side, one.name,
                        1e3 * one.device, 1e3 * one.wall, static_cast<unsigned long long>(one.submissions),
                        static_cast<unsigned long long>(one.waits), one.new_pages);
            rows.push_back({{"side", side},
                            {"radius", o.dab_radius},
                            {"part", one.name},
                            {"device_seconds", one.device},
                            {"wall_seconds", one.wall},
                            {"submissions", one.submissions},
                            {"waits", one.waits},
                            {"new_pages", one.new_pages}});
            if (!device.is_host() && one.submissions != 1)  // the host device has none
                throw std::runtime_error(std::string(one.name) + " takes more than one submission");
        }
    std::printf("\n");
    std::fflush(stdout);
    return rows;
}

/// Adds the draws of the painted model.
void add_draws(const Options& o, const glift::Device& device, const mesh::Mesh& mesh, const std::vector<View>& views,
               Json& all) {
    Canvas canvas(device, mesh, o.octree);
    paint(o, mesh, views, canvas);
    if (!o.pictures.empty()) std::filesystem::create_directories(o.pictures);
    const Canvas::Bytes bytes = canvas.bytes();
    std::printf("%u pages of %u^3, pool %.1f MB, table %.1f MB; dense %u^3, %.1f MB\n\n", canvas.pages(),
                o.octree.resolution, 1e-6 * static_cast<double>(bytes.pool), 1e-6 * static_cast<double>(bytes.table),
                o.dense, 4e-6 * o.dense * o.dense * o.dense);
    all.update({{"pages", canvas.pages()},
                {"pool_bytes", bytes.pool},
                {"table_bytes", bytes.table},
                {"dense", o.dense},
                {"rows", rows_of(o, canvas, views)}});
}

void run(const Options& o) {
    for (const std::string& size : o.sizes) bench::picture_size(size);
    const mesh::Mesh mesh = model_of(o.model);
    const std::vector<View> views = views_of(mesh, o);
    const glift::Device device = glift::Device::open();
    const std::string name = device.properties().name;
    std::printf("%s: %s, %zu triangles\n\n", name.c_str(), o.model.c_str(), mesh.triangles());
    Json all{{"device", name},
             {"model", o.model},
             {"triangles", mesh.triangles()},
             {"resolution", o.octree.resolution},
             {"runs", o.runs},
             {"dabs", dabs_of(o, device, mesh, views[0])}};
    if (!o.only_dabs) add_draws(o, device, mesh, views, all);
    if (o.json.empty()) return;
    std::ofstream file(o.json);
    file << all.dump(2) << "\n";
    if (!file.flush()) throw std::runtime_error(o.json + ": cannot be written");
}

void add_options(CLI::App& app, Options& o) {
    const auto is_power = [](const std::string& text) {
        return std::has_single_bit(std::stoul(text)) ? std::string() : "must be a power of two, such as 512";
    };
    app.add_option("model", o.model, "a mesh, or the name of a generated one: knot, robot, …")->capture_default_str();
    app.add_option("--strokes", o.strokes, "paint these, instead of generated ones");
    app.add_option("--load", o.load, "paint from a file, instead of strokes");
    app.add_option("--resolution", o.octree.resolution, "of the octree")
        ->check(CLI::Range(64u, 2048u))
        ->check(is_power)
        ->capture_default_str();
    app.add_option("--pages", o.octree.pages, "that there may be")->check(CLI::Range(1u, 1u << 18));
    app.add_option("--dab-sizes", o.dab_sizes, "of the pictures in which dabs are painted, pixels a side")
        ->delimiter(',')
        ->check(CLI::Range(16u, 8192u));
    app.add_option("--dab-radius", o.dab_radius, "of such a dab, pixels")
        ->check(CLI::Range(2.0, 2048.0))
        ->capture_default_str();
    app.add_flag("--only-dabs", o.only_dabs, "Draws nothing");
    app.add_option("--dense", o.dense, "the side of the dense image")->check(CLI::Range(2u, 1024u));
    app.add_option("--sizes", o.sizes, "WIDTHxHEIGHT")->delimiter(',');
    app.add_option("--turn", o.turn, "where it is seen from, in radians around it");
    app.add_option("--upwards", o.upwards, "and above it");
    app.add_option("--far", o.far, "how close the far view is")->check(CLI::Range(0.1, 100.0));
    app.add_option("--near", o.near, "how close the near one is")->check(CLI::Range(0.1, 100.0));
    app.add_option("--runs", o.runs, "of which the median counts")->check(CLI::PositiveNumber)->capture_default_str();
    app.add_option("--seconds", o.seconds, "of a run, about");
    app.add_option("--pictures", o.pictures, "a folder for what was drawn");
    app.add_option("--json", o.json, "where the figures go");
    app.footer("GLIFT_DEVICE=gpu|lavapipe|host|NAME chooses the device.");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("A painted model drawn beside one without paint, and with a dense image of it");
    Options options;
    add_options(app, options);
    CLI11_PARSE(app, argc, argv);
    try {
        run(options);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_paint: %s\n", error.what());
        return 1;
    }
}
