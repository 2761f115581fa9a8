// Objects, made by `gliftc watch`, are shared libraries. The constructors of their static objects, of the same types as
// those in the program, list their functions and types while dlopen() runs.
#include "reload.h"

#include <glift/log.h>
#include <glift/reload.h>
#include <glift/version.h>

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <sys/stat.h>
#include <vector>

namespace glift {

namespace fs = std::filesystem;

namespace {

/// The functions and types of the program and its libraries, or those of an object.
struct Listed {
    std::vector<const ReloadableFunction*> functions;
    std::vector<const ReloadableType*> types;
};

/// What is known of a function of the program.
struct Own {
    fs::path file;                                ///< the program or library that holds it
    const ReloadableFunction* current = nullptr;  ///< the version that is called
};

/// What the program has. Never destroyed: static objects leave it in their destructors. No function of the dynamic
/// linker is called while `mutex` is locked, since that one locks it in constructors of libraries.
struct Program : Listed {
    std::mutex mutex;
    std::map<const ReloadableFunction*, Own> own;  ///< for each of `functions`
};

Program& program() {
    static Program& only = *new Program;
    return only;
}

std::mutex poll_mutex;                   ///< locked while code is loaded
std::set<std::string> said;              ///< messages; under poll_mutex
thread_local Listed* loading = nullptr;  ///< where this thread lists what dlopen() constructs; null: in the program

fs::path file_of(const void* code) {
    Dl_info found{};
    std::error_code error;
    if (dladdr(code, &found) == 0 || !found.dli_fname) return {};
    fs::path file = fs::absolute(found.dli_fname, error);
    return fs::exists(file, error) ? file : "/proc/self/exe";  // started by a name without a folder
}

/// Logs a message, unless it was logged before.
void say_once(const std::string& message) {
    if (said.insert(message).second) detail::log(message);
}

/// A text that differs for two versions of a file; empty if there is no such file.
std::string identity_of(const std::string& path) {
    struct stat found {};
    if (stat(path.c_str(), &found) != 0) return {};
    std::ostringstream text;
    text << found.st_ino << ' ' << found.st_size << ' ' << found.st_mtim.tv_sec << ' ' << found.st_mtim.tv_nsec;
    return text.str();
}

/// The contents of the file `reload`: the version of gliftc, and the name and size of the object.
struct Announcement {
    std::string version, object;
    std::uintmax_t bytes = 0;
};

/// Absent if the file is not complete: its last line is "end".
std::optional<Announcement> read_announcement(const fs::path& path) {
    std::ifstream file(path);
    std::string title, end;
    Announcement read;
    if (file >> title >> read.version >> read.object >> read.bytes >> end && title == "glift-reload" && end == "end")
        return read;
    return std::nullopt;
}

std::string version() {
    return std::to_string(GLIFT_VERSION_MAJOR) + "." + std::to_string(GLIFT_VERSION_MINOR) + "." +
           std::to_string(GLIFT_VERSION_PATCH);
}

/// Whether the file that holds a function of the program is newer than the object: then the program was built after the
/// last save.
bool is_newer(const fs::path& file, const fs::path& object) {
    std::error_code error, missing;
    const fs::file_time_type built = fs::last_write_time(file, error), made = fs::last_write_time(object, missing);
    return !error && !missing && built > made;
}

bool does_the_same(const ReloadableFunction& a, const ReloadableFunction& b) {
    return a.digest == b.digest && (a.kernel ? a.kernel->digest : 0) == (b.kernel ? b.kernel->digest : 0);
}

std::string kind_of(const ReloadableFunction& function) { return function.kernel ? "kernel " : "pipeline "; }

std::string joined(const std::set<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// The types and structures that the object declares in another way than the program.
std::set<std::string> changed_types(const Listed& loaded) {
    std::set<std::string> changed;
    for (const ReloadableType* own : program().types)
        for (const ReloadableType* other : loaded.types)
            if (std::string_view(own->name) == other->name && own->digest != other->digest) changed.insert(own->name);
    return changed;
}

/// Finds the version of a program's function in the object. Null if there is none; says so if that one has other
/// parameters.
const ReloadableFunction* find_version(const ReloadableFunction& own, const Listed& loaded) {
    const auto is_of = [](const ReloadableFunction* a, const ReloadableFunction* b) {
        return std::string_view(a->name) == b->name && std::string_view(a->type) == b->type;
    };
    const ReloadableFunction* other_parameters = nullptr;
    for (const ReloadableFunction* each : loaded.functions) {
        if (is_of(each, &own)) return each;
        const auto is_overload = [&](const ReloadableFunction* function) { return is_of(function, each); };
        if (std::string_view(each->name) == own.name && std::ranges::none_of(program().functions, is_overload))
            other_parameters = each;
    }
    if (!other_parameters) return nullptr;
    const std::string before = own.signature, now = other_parameters->signature;
    say_once("reload: " + kind_of(own) + own.name + " keeps its old code, since " +
             (before == now ? "types of its parameters changed: '" + now + "'"
                            : "its parameters changed from '" + before + "' to '" + now + "'") +
             "; build the program again");
    return nullptr;
}

/// Makes the program's functions call those of the object. Returns the names of those that changed.
std::set<std::string> replace_functions(const Listed& loaded, const fs::path& object) {
    std::set<std::string> replaced;
    for (auto& [function, own] : program().own) {
        if (is_newer(own.file, object)) continue;
        const ReloadableFunction* const version = find_version(*function, loaded);
        if (!version) continue;
        if (!does_the_same(*own.current, *version)) replaced.insert(function->name);
        const bool is_original = does_the_same(*function, *version);
        // Of a function that did not change, too: the functions that the version in an earlier object calls are old.
        function->newer.store(is_original ? nullptr : version->own, std::memory_order_release);
        own.current = is_original ? function : version;
    }
    return replaced;
}

/// Loads an object, which is never unloaded: recordings and pipelines may use its code. Returns whether some function
/// changed.
bool load(const fs::path& object) {
    Listed& loaded = *new Listed;
    loading = &loaded;
    void* const handle = dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL);
    loading = nullptr;
    if (!handle) {
        const char* const error = dlerror();
        say_once("reload: cannot load " + object.string() + ": " + (error ? error : "unknown error") +
                 "; a program that links libglift statically has to export its symbols (CMake: ENABLE_EXPORTS)");
        return false;
    }
    const std::lock_guard lock(program().mutex);
    if (program().functions.empty()) {
        say_once("reload: this program has no functions that take newer code; generate its C++ with gliftc --reload "
                 "(CMake: -DGLIFT_RELOAD=ON)");
        return false;
    }
    if (const std::set<std::string> changed = changed_types(loaded); !changed.empty()) {
        say_once("reload: nothing is loaded, since declarations changed: " + joined(changed) +
                 ". Structures that the program has made cannot be converted; build the program again");
        return false;
    }
    const std::set<std::string> replaced = replace_functions(loaded, object);
    if (!replaced.empty()) detail::log("reload: " + joined(replaced));
    return !replaced.empty();
}

}  // namespace

void ReloadableFunction::add() const {
    if (loading) return loading->functions.push_back(this);
    Own found{file_of(own), this};
    const std::lock_guard lock(program().mutex);
    program().functions.push_back(this);
    program().own[this] = std::move(found);
}
void ReloadableFunction::remove() const {
    const std::lock_guard lock(program().mutex);
    std::erase(program().functions, this);
    program().own.erase(this);
}
void ReloadableType::add() const {
    if (loading) return loading->types.push_back(this);
    const std::lock_guard lock(program().mutex);
    program().types.push_back(this);
}
void ReloadableType::remove() const {
    const std::lock_guard lock(program().mutex);
    std::erase(program().types, this);
}

struct Reload::Folder {
    fs::path path;
    std::string seen;  ///< identity of the announcement that was read last

    bool poll() {
        const fs::path announced = path / "reload";
        const std::string identity = identity_of(announced.string());
        if (identity.empty() || identity == seen) return false;
        seen = identity;
        const std::optional<Announcement> read = read_announcement(announced);
        if (!read) return false;  // its identity changes when it is complete
        if (read->version != version()) {
            say_once("reload: gliftc watch is of version " + read->version + ", and this runtime of " + version() +
                     "; run the gliftc that belongs to it");
            return false;
        }
        const fs::path object = fs::absolute(path / read->object);
        std::error_code error;
        if (fs::file_size(object, error) != read->bytes || error) {
            say_once("reload: " + object.string() + " is not complete, and is not loaded; save the file again");
            return false;
        }
        return load(object);
    }
};

Reload::Reload(std::string folder)
    : folder_(folder.empty() ? nullptr : std::make_unique<Folder>(Folder{std::move(folder), {}})) {}
Reload::~Reload() = default;
Reload::Reload(Reload&&) noexcept = default;
Reload& Reload::operator=(Reload&&) noexcept = default;

bool Reload::poll() {
    const std::lock_guard lock(poll_mutex);
    return folder_ && folder_->poll();
}

namespace detail {

static Reload* reload_of_environment() {
    const char* const folder = std::getenv("GLIFT_RELOAD");
    return folder && *folder ? new Reload(folder) : nullptr;
}

std::atomic<Reload*> named_reload = reload_of_environment();

void poll_named_reload(Reload& reload) { reload.poll(); }

}  // namespace detail

}  // namespace glift
