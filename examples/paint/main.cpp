// Paint on any mesh, kept in an octree by positions on the mesh at rest: paint.glift from C++.
#include "at_window.h"
#include "canvas.h"
#include "command_line.h"
#include "model.h"
#include "strokes.h"

#include "examples/common/npy.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

using glift::float3;

struct Arguments {
    std::string model, strokes, brush, load, save, record, npy, out = "paint.png";
    std::vector<std::uint32_t> size = {1024, 768};
    OctreeSize octree;
    unsigned undo = 0, redo = 0, npy_side = 128;
    float turn = 0.6f, upwards = 0.3f, closer = 1, bend = 0;
    std::vector<float> target;
    painted::Layers layers;
    bool window = false;
};

Orbit orbit_of(const Arguments& a, const mesh::Mesh& mesh) {
    const mesh::Box box = mesh::bounds_of(mesh);
    const float3 target =
        a.target.empty() ? (box.low + box.high) * 0.5f : float3(a.target[0], a.target[1], a.target[2]);
    return {target, a.turn, a.upwards, a.closer};
}

void say_lost(std::size_t stroke, glift::uint lost) {
    if (lost != 0)
        std::fprintf(
            stderr,
            "paint: the pool is full: at stroke %zu, %u requests for pages found no room, and there is no paint "
            "there; give more of them by --pages\n",
            stroke + 1, lost);
}

/// The stroke from which the first stroke of a file takes what it leaves out. A window begins with its brush, too.
strokes::Stroke first_of(const Arguments& a) {
    strokes::Stroke stroke;
    stroke.brush.picture = a.brush;
    return stroke;
}

std::vector<strokes::Stroke> paint_all(const Arguments& a, Canvas& canvas) {
    if (!a.load.empty()) canvas.load(a.load);
    if (a.strokes.empty()) return {};
    const std::vector<strokes::Stroke> all = strokes::read(a.strokes, first_of(a));
    canvas.device().wait();
    const std::uint64_t passes = canvas.device().statistics().passes;
    const auto start = std::chrono::steady_clock::now();
    std::size_t dabs = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        say_lost(i, canvas.paint(all[i]));
        dabs += strokes::dabs_of(all[i]).size();
    }
    canvas.device().wait();
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    const auto each = static_cast<double>(std::max<std::size_t>(dabs, 1));
    std::printf("%zu strokes, %zu dabs: %.1f ms, %.2f a dab; %.1f passes a dab\n", all.size(), dabs, ms, ms / each,
                static_cast<double>(canvas.device().statistics().passes - passes) / each);
    return all;
}

void say_size(Canvas& canvas, const mesh::Mesh& mesh) {
    const Canvas::Bytes bytes = canvas.bytes();
    const glift::uint pages = canvas.pages();
    constexpr double page_bytes = 4.0 * 17 * 17 * 17;
    std::printf("%s: %zu triangles, %u^3; %u of %u pages: %.1f MB of texels in a pool of %.1f MB, table %.1f MB\n",
                canvas.device().properties().name.c_str(), mesh.triangles(), 16u << (canvas.octree().levels() - 1),
                pages, canvas.octree().capacity(), 1e-6 * page_bytes * pages, 1e-6 * static_cast<double>(bytes.pool),
                1e-6 * static_cast<double>(bytes.table));
}

void write_results(const Arguments& a, Canvas& canvas) {
    if (!a.save.empty()) canvas.save(a.save);
    if (!a.npy.empty()) npy::write(a.npy, canvas.samples(a.npy_side));
}

void run(const Arguments& a) {
    const mesh::Mesh mesh = model_of(a.model);
    Canvas canvas(glift::Device::open(), mesh, a.octree);
    canvas.prepare(first_of(a).brush);
    paint_all(a, canvas);
    for (unsigned i = 0; i < a.undo && canvas.undo(); ++i) {}
    for (unsigned i = 0; i < a.redo && canvas.redo(); ++i) {}
    say_size(canvas, mesh);
    write_results(a, canvas);
    if (a.bend != 0) canvas.model().pose(bent(mesh, a.bend));
    picture::write(a.out, canvas.render(orbit_of(a, mesh).camera(), {a.size[0], a.size[1]}, a.layers));
    std::printf("wrote %s\n", a.out.c_str());
}

bool are_one_file(const std::string& a, const std::string& b) {
    std::error_code error;
    return std::filesystem::equivalent(a, b, error);
}

/// The command line that makes the window's last picture again from the recorded strokes, without the layers shown over
/// the paint. If saving has overwritten the file that was loaded (--load and --save name one file), that file has all
/// strokes already, and they are left out.
std::string words_of(const Arguments& a, const Orbit& orbit, glift::uint2 size) {
    char view[200];
    std::snprintf(view, sizeof view, " --turn %.9g --upwards %.9g --closer %.9g --target %.9g %.9g %.9g",
                  static_cast<double>(orbit.turn), static_cast<double>(orbit.upwards),
                  static_cast<double>(orbit.closer), static_cast<double>(orbit.target.x),
                  static_cast<double>(orbit.target.y), static_cast<double>(orbit.target.z));
    const bool is_replaced = !a.load.empty() && are_one_file(a.load, a.save);
    return "paint " + command_line::quoted(a.model) +
           (a.load.empty() ? "" : " --load " + command_line::quoted(a.load)) +
           (is_replaced ? "" : " --strokes " + command_line::quoted(a.record)) + " --resolution " +
           std::to_string(a.octree.resolution) + " --pages " + std::to_string(a.octree.pages) + " --size " +
           std::to_string(size.x) + " " + std::to_string(size.y) + view + " --out " + command_line::quoted(a.out);
}

/// Prints an error of `work` instead of throwing it, since other files are still to be written. Returns whether there
/// was none.
template <class Work> bool tried(const Work& work) {
    try {
        work();
        return true;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "paint: %s\n", error.what());
        return false;
    }
}

/// Runs the window. Returns whether it ended without an error and all files were written.
bool run_window(const Arguments& a) {
    const std::vector<strokes::Stroke> first = {first_of(a)};
    if (!a.record.empty()) strokes::text_of(first);  // refuses what could not be recorded at the end
    window::Window window("Paint", {a.size[0], a.size[1]});
    const mesh::Mesh mesh = model_of(a.model);
    Canvas canvas(window.device(), mesh, a.octree);
    canvas.prepare(first[0].brush);
    std::vector<strokes::Stroke> strokes = paint_all(a, canvas);
    Orbit orbit = orbit_of(a, mesh);
    const auto save = [&] {
        picture::write(a.out, canvas.render(orbit.camera(), window.size(), {}));
        write_results(a, canvas);
    };
    const bool has_ended = tried([&] { paint_at(window, canvas, orbit, a.layers, first[0].brush, strokes, save); });
    // The strokes first: they must not be lost if something else cannot be written.
    const bool is_recorded = a.record.empty() || tried([&] { strokes::write(a.record, strokes); });
    const bool is_saved = tried([&] { write_results(a, canvas); });
    const bool is_whole = has_ended && is_recorded && is_saved;
    if (is_whole && !a.record.empty()) std::printf("the same picture: %s\n", words_of(a, orbit, window.size()).c_str());
    return is_whole;
}

void add_octree_options(CLI::App& app, Arguments& a) {
    const auto is_power = [](const std::string& text) {
        return std::has_single_bit(std::stoul(text)) ? std::string() : "must be a power of two, such as 512";
    };
    app.add_option("--resolution", a.octree.resolution, "Cells of the octree along each side, 64 to 2048")
        ->check(CLI::Range(64u, 2048u))
        ->check(is_power)
        ->capture_default_str();
    app.add_option("--pages", a.octree.pages, "of 17^3 texels that there may be")
        ->check(CLI::Range(1u, 1u << 18))
        ->capture_default_str();
    app.add_option("--load", a.load, "Paint from a file, to begin with")->check(CLI::ExistingFile);
    app.add_option("--save", a.save, "A file for the paint")->check(command_line::can_be_made);
    auto* npy =
        app.add_option("--npy", a.npy, "A file for samples of it, as a NumPy array of shape (side, side, side, 4)")
            ->check(command_line::can_be_made);
    app.add_option("--npy-side", a.npy_side, "Its side")
        ->needs(npy)
        ->check(CLI::Range(2u, 512u))
        ->capture_default_str();
}

/// Options of strokes, from a file or in a window.
void add_stroke_options(CLI::App& app, Arguments& a) {
    auto* strokes = app.add_option("--strokes", a.strokes, "A file of strokes to paint, a JSON object a line");
    app.add_option("--brush", a.brush, "A PNG as the brush, where strokes name none: white paints, black does not")
        ->check(CLI::ExistingFile);
    auto* window = app.add_flag("--window", a.window, "Paint in a window");
    app.add_option("--record", a.record, "A file for the strokes that there are at its end")
        ->needs(window)
        ->check(command_line::can_be_made);
    app.final_callback([&a] {
        if (!a.brush.empty() && a.strokes.empty() && !a.window)
            throw CLI::RequiresError("--brush", "--strokes or --window");
    });
    auto* undo = app.add_option("--undo", a.undo, "Undo so many strokes at the end")->needs(strokes)->excludes(window);
    app.add_option("--redo", a.redo, "and do so many of them again")->needs(undo);
    app.add_option("--bend", a.bend, "Bend the painted model by so many radians")
        ->excludes(window)
        ->check(command_line::is_finite)
        ->check(CLI::Range(-6.0f, 6.0f));
}

void add_view_options(CLI::App& app, Arguments& a) {
    app.add_option("--size", a.size, "Width and height of the picture: 800 600, or 800x600")
        ->expected(2)
        ->delimiter('x')
        ->check(CLI::Range(1, 16384));
    app.add_option("--turn", a.turn, "Where it is seen from, in radians around it")
        ->check(command_line::is_finite)
        ->capture_default_str();
    app.add_option("--upwards", a.upwards, "and above it")->check(command_line::is_finite)->capture_default_str();
    app.add_option("--closer", a.closer, "by a factor")
        ->check(command_line::is_finite)
        ->check(CLI::Range(Orbit::least_closer, Orbit::most_closer))
        ->capture_default_str();
    app.add_option("--target", a.target, "What is looked at, instead of the middle")
        ->expected(3)
        ->check(command_line::is_finite);
    app.add_flag("--levels", a.layers.levels, "Show the levels of pages by colours");
    app.add_flag("--borders", a.layers.borders, "Show where pages meet");
    app.add_flag("--pool", a.layers.pool, "Show all frames of the pool");
    app.add_flag("--table", a.layers.table, "Show all levels of the table");
    app.add_option("--out", a.out, "The picture to write, PNG or EXR")
        ->check(command_line::is_picture)
        ->check(command_line::can_be_made)
        ->capture_default_str();
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Paint on a mesh, in an octree");
    Arguments arguments;
    app.add_option(
           "model", arguments.model,
           "A mesh: any file that assimp reads (PLY, OBJ, glTF, …), or the name of a generated one: knot, robot, …")
        ->required();
    add_stroke_options(app, arguments);
    add_octree_options(app, arguments);
    add_view_options(app, arguments);
    app.footer("GLIFT_DEVICE=gpu|lavapipe|host|NAME chooses the device.");
    CLI11_PARSE(app, argc, argv);
    try {
        if (arguments.window) return run_window(arguments) ? 0 : 1;
        run(arguments);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "paint: %s\n", error.what());
        return 1;
    }
}
