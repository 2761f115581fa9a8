#include "driver/test_program.h"

#include "driver/cxx_compiler.h"
#include "driver/digest.h"
#include "driver/environment.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <unistd.h>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t entries_kept = 512;  ///< in the cache: programs, objects, records of runs, precompiled headers

/// The headers that all sources of test programs except those of kernels include.
constexpr const char* common_headers = "#include <glift/host/math.h>\n#include <glift/structure.h>\n"
                                       "#include <glift/translation_checks.h>\n";

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A text that identifies a version of a file: path, size and modification time.
std::string identity_of(const fs::path& path) {
    std::error_code error;
    const auto size = fs::file_size(path, error);
    const auto time = fs::last_write_time(path, error).time_since_epoch().count();
    return path.string() + ":" + std::to_string(size) + ":" + std::to_string(time);
}

/// The program that a shell would run for this name, by its path without symbolic links. The name itself if it has a
/// '/', or if no folder of PATH has such a program.
fs::path find_program(const std::string& name) {
    if (name.find('/') != std::string::npos) return name;
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + name).c_str(), X_OK) == 0) return fs::canonical(folder + "/" + name);
    return name;
}

fs::path cache_folder() {
    if (const char* named = std::getenv("GLIFT_CACHE_DIR")) return named;
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg) return fs::path(xdg) / "glift";
    if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache" / "glift";
    return {};
}

/// The folder of the runtime's library below `root`, a build tree or an installation. Throws EnvironmentError if there
/// is none.
fs::path library_folder(const fs::path& root) {
    for (const char* folder : {"lib", "lib64", "lib/x86_64-linux-gnu", "lib/aarch64-linux-gnu"})
        if (fs::exists(root / folder / "libglift.so") || fs::exists(root / folder / "libglift.a")) return root / folder;
    throw EnvironmentError("no libglift in " + (root / "lib").string());
}

/// A new unique folder beside `folder`, so that it can be renamed to it.
fs::path new_folder(const fs::path& folder) {
    std::string pattern = folder.string() + ".XXXXXX";
    if (!mkdtemp(pattern.data())) throw EnvironmentError("cannot make a folder in " + folder.parent_path().string());
    return pattern;
}

/// Renames the finished folder to its final name, unless another process was faster.
void publish(const fs::path& made, const fs::path& name) {
    std::error_code error;
    fs::rename(made, name, error);
    if (error) fs::remove_all(made, error);
}

/// Makes a file or folder of the cache the newest one, the last to be removed.
void touch(const fs::path& path) {
    std::error_code ignored;
    fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
}

/// A path as it stands between quotes in text that the compiler and then the assembler read: escaped for each.
std::string quoted_for_assembler(const fs::path& path) {
    std::string text = path.string();
    for (int reader = 0; reader < 2; ++reader) {
        std::string escaped;
        for (char c : text) {
            if (c == '"' || c == '\\') escaped += '\\';
            escaped += c;
        }
        text = std::move(escaped);
    }
    return text;
}

/// The file of SPIR-V that a source of kernels includes; null if it has none.
const Output* spirv_of(const Output& source, const std::vector<Output>& outputs) {
    const std::string name = fs::path(source.name).replace_extension(".spirv");
    const auto found = std::ranges::find(outputs, name, &Output::name);
    return found == outputs.end() ? nullptr : &*found;
}

/// The paths of a source and of its object file.
struct Object {
    fs::path source, object;
    fs::path cached;  ///< the object in the cache

    /// Takes the object from the cache; false if it is not there.
    bool take() const {
        std::error_code error;
        fs::create_hard_link(cached, object, error);
        if (!error) touch(cached);
        return !error;
    }
    /// Puts the object into the cache, unless another process was faster.
    void keep() const {
        std::error_code ignored;
        fs::create_hard_link(object, cached, ignored);
    }
};

}  // namespace

TestPrograms::TestPrograms() {
    const fs::path root = fs::canonical("/proc/self/exe").parent_path().parent_path();
    include_ = root / "include";
    if (!fs::exists(include_ / "glift" / "testing.h"))
        throw EnvironmentError("no glift/testing.h in " + include_.string());
    library_ = library_folder(root);

    Digest tools;
    for (const std::string& word : compiler_words()) tools.add(word + identity_of(find_program(word)));
    for (const char* name : {"libglift.so", "libglift.a"})
        if (fs::exists(library_ / name)) tools.add(identity_of(fs::canonical(library_ / name)));
    std::set<std::string> headers;
    for (const auto& entry :
         fs::recursive_directory_iterator(include_ / "glift", fs::directory_options::follow_directory_symlink))
        if (entry.is_regular_file()) headers.insert(identity_of(entry.path()));
    for (const std::string& header : headers) tools.add(header);
    tools_ = tools.digits();

    std::error_code error;
    if (const fs::path cache = cache_folder(); !cache.empty()) {
        folder_ = cache / "tests";
        fs::create_directories(folder_, error);
        if (!error && access(folder_.c_str(), W_OK) == 0) return;
    }
    const fs::path temporary = fs::temp_directory_path(error);
    if (error) throw EnvironmentError("there is no folder for test programs: set GLIFT_CACHE_DIR, or TMPDIR");
    folder_ = new_folder(temporary / "gliftc-test");
    is_temporary_ = true;
}

TestPrograms::~TestPrograms() {
    std::error_code ignored;
    if (is_temporary_) fs::remove_all(folder_, ignored);
}

std::vector<std::string> TestPrograms::compile_command() const {
    std::vector<std::string> words = compiler_words();
    // -Og compiles faster than -O1 and suits debuggers. The empty GLIFT_HOST_KERNEL keeps kernels from being compiled
    // once for each vector width.
    words.insert(words.end(), {"-std=c++20", "-Og", "-DGLIFT_HOST_KERNEL=", "-ffp-contract=off", "-fwrapv",
                               "-fno-math-errno", "-fno-trapping-math", "-I" + include_.string()});
    return words;
}

/// The common headers, precompiled, for a run that compiles `sources` sources with them: parsing them takes most of a
/// small program's build, but precompiling takes as long as parsing them twice. So the cache precompiles them for the
/// first run with which more than four sources in all need them. Returns the header to be included first; empty if it
/// is not precompiled yet, the C++ compiler cannot do it, or the cache is temporary.
fs::path TestPrograms::compiled_headers(std::size_t sources) {
    constexpr std::size_t parsed_at_most = 4;
    if (is_temporary_ || sources == 0) return {};
    const fs::path folder = folder_ / ("headers-" + tools_);
    const fs::path header = folder / "common.hpp";
    if (fs::exists(header)) {
        touch(folder);
        return header;
    }
    const fs::path count = folder_ / ("parsed-" + tools_);
    std::error_code ignored;
    const std::size_t in_all = sources + (fs::exists(count) ? fs::file_size(count, ignored) : 0);
    if (in_all <= parsed_at_most) {
        write_if_changed(count.string(), std::string(in_all, '.'));
        return {};
    }
    const fs::path made = new_folder(folder);
    write_if_changed((made / "common.hpp").string(), common_headers);
    std::vector<std::string> words = compile_command();
    words.insert(words.end(),
                 {"-x", "c++-header", (made / "common.hpp").string(), "-o", (made / "common.hpp.gch").string()});
    try {
        if (CompilerRun(words).wait() && fs::exists(made / "common.hpp.gch")) {
            publish(made, folder);
            return header;
        }
    } catch (...) {
        fs::remove_all(made, ignored);
        throw;
    }
    fs::remove_all(made, ignored);
    return {};
}

/// A hash of what all sources of a program are compiled with.
Digest TestPrograms::digest_of_surroundings(const TestSources& sources) const {
    Digest digest;
    digest.add(tools_);
    for (const std::string& word : compile_command()) digest.add(word);
    for (const std::string& folder : sources.include_folders) digest.add(folder);
    for (const std::string& file : sources.read_files) digest.add(text_of(file));
    return digest;
}

/// The path of a source's object file in the cache. Its name is a hash of the source, its SPIR-V, all headers but the
/// system's, the include folders, the compiler's options and tools_.
fs::path TestPrograms::object_of(const Output& source, const TestSources& sources) const {
    Digest digest = digest_of_surroundings(sources);
    for (const Output& output : sources.outputs)
        if (output.name.ends_with(".hpp")) digest.add(output.bytes);
    digest.add(source.bytes);
    if (const Output* spirv = spirv_of(source, sources.outputs)) digest.add(spirv->bytes);
    return folder_ / ("object-" + digest.digits() + ".o");
}

void TestPrograms::compile(const fs::path& folder, const TestSources& sources) {
    for (const Output& output : sources.outputs)
        if (auto error = write_if_changed((folder / output.name).string(), output.bytes))
            throw EnvironmentError("cannot write " + output.name + ": " + *error);
    const auto command_of = [&](const Object& object) {
        std::vector<std::string> words = compile_command();
        for (const std::string& include : sources.include_folders) words.push_back("-I" + include);
        words.push_back("-DGLIFT_SPIRV_FOLDER=\"" + quoted_for_assembler(folder) + "\"");
        words.insert(words.end(), {"-c", object.source.string(), "-o", object.object.string()});
        return words;
    };
    std::vector<std::vector<std::string>> of_kernels, others;
    std::vector<std::string> link = compiler_words();
    std::vector<Object> compiled;
    std::string stem;
    for (const Output& output : sources.outputs) {
        if (!output.name.ends_with(".cpp")) continue;
        if (stem.empty()) stem = output.name.substr(0, output.name.find(".glift."));
        const fs::path source = folder / output.name;
        const Object object{source, source.string() + ".o", object_of(output, sources)};
        link.push_back(object.object.string());
        if (object.take()) continue;
        const bool is_of_kernels = output.name.find(".kernels.") != std::string::npos;
        (is_of_kernels ? of_kernels : others).push_back(command_of(object));
        compiled.push_back(object);
    }
    // Sources of kernels include only one of the common headers: they do not wait until these are precompiled.
    std::vector<CompilerRun> runs(of_kernels.begin(), of_kernels.end());
    if (const fs::path headers = compiled_headers(others.size()); !headers.empty())
        for (std::vector<std::string>& words : others) words.insert(words.end(), {"-include", headers.string()});
    for (const std::vector<std::string>& words : others) runs.emplace_back(words);
    for (CompilerRun& run : runs) run.wait();
    for (const CompilerRun& run : runs)
        if (run.ended.code != 0) refuse(run, "compile", stem, folder);
    std::ranges::for_each(compiled, &Object::keep);
    link.insert(link.end(), {"-L" + library_.string(), "-Wl,-rpath," + library_.string(), "-lglift", "-ltbb", "-o",
                             (folder / "program").string()});
    CompilerRun linked(link);
    if (!linked.wait()) refuse(linked, "link", stem, folder);
    if (!fs::exists(folder / "program"))
        throw EnvironmentError("the C++ compiler '" + compiler_words()[0] +
                               "' reported no error, but made no program: CXX must name a compiler that links");
}

/// Throws an error for a run that failed: the blame is gliftc's only if the compiler, which compiles the runtime's
/// headers alone, reports an error about a generated file.
void TestPrograms::refuse(const CompilerRun& run, const std::string& step, const std::string& stem,
                          const fs::path& folder) {
    std::string cause = lack_of_resources(run, folder_);
    const bool compiles = step == "compile";
    if (cause.empty() && compiles && !can_compile_headers(folder))
        cause = "it compiles Glift's headers neither: see that CXX names a C++20 compiler (g++ 12, clang 14)";
    if (cause.empty() && compiles && has_error_in(folder, run.messages))
        throw std::runtime_error("the C++ compiler refused what gliftc wrote for " + stem);
    if (cause.empty() && !compiles)
        cause = "the program needs libglift in " + library_.string() + ", and libtbb (Debian: libtbb-dev)";
    throw EnvironmentError("the C++ compiler could not " + step + " the tests of " + stem + " (" +
                           how_it_ended(run.ended) + ")" + (cause.empty() ? "" : ": " + cause));
}

bool TestPrograms::can_compile_headers(const fs::path& folder) const {
    const std::string source = (folder / "headers.cpp").string();
    if (write_if_changed(source, common_headers)) return true;  // the failed run's messages say why
    std::vector<std::string> words = compile_command();
    words.insert(words.end(), {"-fsyntax-only", source});
    return CompilerRun(words).wait();
}

std::string TestPrograms::name_of(const TestSources& sources) const {
    Digest digest = digest_of_surroundings(sources);
    for (const Output& output : sources.outputs) {
        digest.add(output.name);
        digest.add(output.bytes);
    }
    return digest.digits();
}

bool TestPrograms::has(const std::string& name) const { return fs::exists(folder_ / name / "program"); }

void TestPrograms::build(const std::string& name, const TestSources& sources) {
    const fs::path made = new_folder(folder_ / name);
    try {
        compile(made, sources);
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(made, ignored);
        throw;
    }
    publish(made, folder_ / name);
    remove_oldest();
}

std::string TestPrograms::use(const std::string& name) const {
    touch(folder_ / name);
    return (folder_ / name / "program").string();
}

std::string TestPrograms::record_of(const Options& options) const {
    Digest digest;
    digest.add(tools_);
    digest.add(identity_of(fs::canonical("/proc/self/exe")));
    const auto add_paths = [&](const std::vector<std::string>& paths) {
        for (const std::string& path : paths) digest.add(fs::absolute(path).string());
        digest.add("");
    };
    add_paths(options.files);
    add_paths(options.import_folders);
    if (!options.library_folder.empty()) add_paths({options.library_folder});
    for (const auto& [name, value] : options.defines) digest.add(name + "=" + value);
    for (const std::vector<Diag>* list : {&options.silenced, &options.promoted}) {
        for (Diag diag : *list) digest.add(std::to_string(static_cast<int>(diag)));
        digest.add("");
    }
    for (bool flag : {options.checked, options.messages, options.host_only, options.warnings_are_errors,
                      options.source_lines, options.optimize})
        digest.add(flag ? "1" : "0");
    digest.add(std::to_string(options.shards));
    digest.add(std::to_string(options.address_bits));
    digest.add(options.style);
    return (folder_ / ("run-" + digest.digits())).string();
}

void TestPrograms::remove_oldest() const {
    std::vector<std::pair<fs::file_time_type, fs::path>> folders;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder_, error))
        folders.emplace_back(entry.last_write_time(error), entry);
    if (folders.size() <= entries_kept) return;
    std::ranges::sort(folders);
    for (std::size_t i = 0; i + entries_kept < folders.size(); ++i) fs::remove_all(folders[i].second, error);
}

}  // namespace gliftc
