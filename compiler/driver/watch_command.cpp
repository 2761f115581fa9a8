// `gliftc watch`: compiles whenever a file that it has read changes, and builds a shared library, the object, which
// running programs load (glift/reload.h). The folder of -o then has
//   code/         generated C++ and object files
//   TIME.so       the objects; a name is never used twice, since the dynamic linker knows libraries by their names
//   reload        names the newest object: "glift-reload VERSION OBJECT BYTES end"
#include "base/lines.h"
#include "base/version.h"
#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/compile.h"
#include "driver/cxx_compiler.h"
#include "driver/environment.h"
#include "driver/include_folders.h"
#include "driver/shaders.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_looks{30};
constexpr std::chrono::milliseconds longest_rename{300};  ///< editors may remove a file before they write it anew
constexpr std::size_t objects_kept = 3;

double seconds_since(Clock::time_point moment) { return std::chrono::duration<double>(Clock::now() - moment).count(); }

void say(const std::string& line) {
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
}

std::string seconds_text(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f s", seconds);
    return text;
}

/// The state of files on the disk.
class Files {
public:
    /// Notes the files as they are now, before they are read.
    void note(const std::set<std::string>& paths) {
        for (const std::string& path : paths) states_.try_emplace(path, state_of(path));
    }
    /// The files that differ from what was noted, which it notes anew.
    std::set<std::string> changed() {
        std::set<std::string> found;
        for (auto& [path, state] : states_)
            if (const std::string now = state_of(path); now != state) {
                found.insert(path);
                state = now;
            }
        return found;
    }
    std::size_t size() const { return states_.size(); }

private:
    static std::string state_of(const std::string& path) {
        std::error_code missing;
        const auto size = fs::file_size(path, missing);
        if (missing) return {};
        return std::to_string(size) + " " +
               std::to_string(fs::last_write_time(path, missing).time_since_epoch().count());
    }

    std::map<std::string, std::string> states_;
};

/// Waits until files change and have been written: they are all there, and none has changed since the last look.
std::set<std::string> wait_for_change(Files& files) {
    std::set<std::string> changed;
    while ((changed = files.changed()).empty()) std::this_thread::sleep_for(between_looks);
    const auto is_there = [](const std::string& path) { return fs::exists(path); };
    for (const auto begin = Clock::now(); Clock::now() - begin < longest_rename;) {
        std::this_thread::sleep_for(between_looks);
        const std::set<std::string> more = files.changed();
        changed.insert(more.begin(), more.end());
        if (more.empty() && std::ranges::all_of(changed, is_there)) break;
    }
    return changed;
}

/// C++ without comments: they name lines, which an edit further up changes.
std::string without_comments(const std::string& text) { return without_lines(text, {"//"}); }

/// Whether a source has no code: of several sources for kernels (--shards) some may have none.
bool is_blank(const Output& source) {
    return without_comments(source.bytes).find_first_not_of(" \n") == std::string::npos;
}

/// The contents of a source and of all that it includes, but for comments and the runtime's headers.
std::string contents_of(const Output& source, const std::vector<Output>& outputs, const std::string& headers) {
    std::string text = without_comments(source.bytes) + headers;
    const std::string spirv = fs::path(source.name).replace_extension(".spirv").string();
    for (const Output& output : outputs)
        if (output.name == spirv) text += output.bytes;
    return text;
}

/// Builds objects in a folder.
class Objects {
public:
    explicit Objects(fs::path folder) : folder_(std::move(folder)), code_(folder_ / "code") {
        include_ = fs::canonical("/proc/self/exe").parent_path().parent_path() / "include";
        if (!fs::exists(include_ / "glift" / "reload.h"))
            throw EnvironmentError("no glift/reload.h in " + include_.string());
        std::error_code error;
        fs::create_directories(code_, error);
        if (error) throw EnvironmentError("cannot make the folder " + code_.string() + ": " + error.message());
        code_ = fs::absolute(code_);
    }

    /// Builds an object and announces it. False if the C++ compiler failed, whose messages are shown then.
    bool build(const std::vector<Output>& outputs, const std::vector<std::string>& include_folders);

private:
    std::vector<std::string> command(const std::vector<std::string>& include_folders) const;
    bool run(const std::vector<std::vector<std::string>>& commands);
    bool compile_headers();
    void announce(const fs::path& made);
    void remove_old() const;
    void write(const fs::path& path, const std::string& bytes) const {
        if (const auto error = write_if_changed(path.string(), bytes))
            throw EnvironmentError("cannot write " + path.string() + ": " + *error);
    }

    fs::path folder_, code_, include_;
    bool has_headers_ = false;
    std::map<std::string, std::string> compiled_;  ///< by name, the contents of the sources that have object files
};

std::vector<std::string> Objects::command(const std::vector<std::string>& include_folders) const {
    std::vector<std::string> words = compiler_words();
    // -O1 compiles fast. The empty GLIFT_HOST_KERNEL keeps kernels from being compiled once for each vector width.
    // Hidden symbols, since the program has symbols of the same names.
    words.insert(words.end(), {"-std=c++20", "-O1", "-fPIC", "-fvisibility=hidden", "-DGLIFT_HOST_KERNEL=",
                               "-ffp-contract=off", "-fwrapv", "-fno-math-errno", "-fno-trapping-math",
                               "-I" + include_.string(), "-DGLIFT_SPIRV_FOLDER=\"" + code_.string() + "\""});
    for (const std::string& folder : include_folders) words.push_back("-I" + folder);
    return words;
}

/// Runs the commands, as many at once as the machine has cores. True if all succeed.
bool Objects::run(const std::vector<std::vector<std::string>>& commands) {
    const std::size_t at_once = std::max(1u, std::thread::hardware_concurrency());
    bool succeeded = true;
    for (std::size_t first = 0; first < commands.size(); first += at_once) {
        std::vector<CompilerRun> runs;
        for (std::size_t i = first; i < std::min(first + at_once, commands.size()); ++i) runs.emplace_back(commands[i]);
        for (CompilerRun& run : runs) succeeded &= run.wait();
    }
    return succeeded;
}

/// Precompiles the runtime's headers: parsing them takes most of a small source's time.
bool Objects::compile_headers() {
    const fs::path header = code_ / "common.hpp";
    write(header, "#include <glift/glift.h>\n#include <glift/host/math.h>\n#include <glift/host/parallel.h>\n"
                  "#include <glift/reload.h>\n#include <glift/structure.h>\n#include <cstddef>\n#include <optional>\n");
    std::vector<std::string> words = command({});
    words.insert(words.end(), {"-x", "c++-header", header.string(), "-o", header.string() + ".gch"});
    return has_headers_ = run({words});
}

bool Objects::build(const std::vector<Output>& outputs, const std::vector<std::string>& include_folders) {
    if (!has_headers_ && !compile_headers()) return false;
    std::string headers;
    for (const Output& output : outputs) {
        write(code_ / output.name, output.bytes);
        if (output.name.ends_with(".hpp")) headers += without_comments(output.bytes);
    }
    std::vector<std::vector<std::string>> commands;
    std::map<std::string, std::string> contents;
    std::vector<std::string> link = compiler_words();
    const fs::path made = folder_ / "object.new";
    link.insert(link.end(), {"-shared", "-Wl,-Bsymbolic", "-o", made.string()});
    for (const Output& output : outputs) {
        if (!output.name.ends_with(".cpp") || is_blank(output)) continue;
        const std::string source = (code_ / output.name).string(), object = source + ".o";
        link.push_back(object);
        std::string text = contents_of(output, outputs, headers);
        if (const auto known = compiled_.find(output.name); known != compiled_.end() && known->second == text) continue;
        compiled_.erase(output.name);
        std::vector<std::string> words = command(include_folders);
        words.insert(words.end(), {"-include", (code_ / "common.hpp").string(), "-c", source, "-o", object});
        commands.push_back(std::move(words));
        contents[output.name] = std::move(text);
    }
    if (!run(commands)) return false;
    compiled_.merge(contents);
    if (!run({link})) return false;
    announce(made);
    return true;
}

/// Gives the object its name, and names it in the file `reload`. Each file is complete when it gets its name.
void Objects::announce(const fs::path& made) {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const std::string name = std::to_string(std::chrono::duration_cast<std::chrono::microseconds>(now).count()) + ".so";
    const std::string bytes = std::to_string(fs::file_size(made));
    fs::rename(made, folder_ / name);
    const fs::path announcement = folder_ / "reload.new";
    write(announcement, "glift-reload " + std::string(version()) + " " + name + " " + bytes + " end\n");
    fs::rename(announcement, folder_ / "reload");
    remove_old();
}

/// Removes all but the last few objects: a program may be about to load the one before the last.
void Objects::remove_old() const {
    std::vector<fs::path> objects;
    for (const auto& entry : fs::directory_iterator(folder_))
        if (entry.path().extension() == ".so") objects.push_back(entry.path());
    std::ranges::sort(objects);
    std::error_code ignored;
    for (std::size_t i = 0; i + objects_kept < objects.size(); ++i) fs::remove(objects[i], ignored);
}

std::set<std::string> files_of(const Options& options, const Compilation& compilation) {
    std::set<std::string> paths(options.files.begin(), options.files.end());
    for (std::uint32_t file = 0; file < compilation.sources.size(); ++file)
        paths.insert(compilation.sources[file].path);
    paths.insert(compilation.read_files.begin(), compilation.read_files.end());
    return paths;
}

/// Compiles the files and builds an object. `files` gets all files that were read. True if there is a new object.
bool build(const Options& options, Objects& objects, Files& files) {
    const auto compilation = std::make_unique<Compilation>();
    configure(compilation->diagnostics, options);
    const Result result = compile(options, disk(), *compilation);
    files.note(files_of(options, *compilation));
    if (report(*compilation, options) != 0) return false;
    if (objects.build(result.outputs, include_folders(options, *compilation))) return true;
    std::fprintf(stderr, "gliftc: the C++ compiler failed: programs keep the code that they have\n");
    return false;
}

}  // namespace

int run_watch(const Options& given) {
    Options options = given;
    options.targets = {Target::cpp, Target::host};
    options.spirv_files = options.reload = true;
    if (!options.source_lines) keep_shaders();
    Objects objects(options.output_folder);
    Files files;
    files.note({options.files.begin(), options.files.end()});
    const bool is_built = build(options, objects, files);
    say("watching " + std::to_string(files.size()) + " files" + (is_built ? "" : ", one of which has errors") +
        "; programs load from " + options.output_folder);
    for (;;) {
        const std::set<std::string> changed = wait_for_change(files);
        const auto begin = Clock::now();
        const std::string name = fs::path(*changed.begin()).filename().string();
        if (build(options, objects, files)) say(name + ": new code after " + seconds_text(seconds_since(begin)));
        else say(name + ": no new code");
    }
}

}  // namespace gliftc
