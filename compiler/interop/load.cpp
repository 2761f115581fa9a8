// Opens libglift_clang.so at the first use and forwards to it.

#include "interop/interop.h"
#include "interop/plugin.h"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <system_error>

namespace gliftc {
namespace {

struct Plugin {
    decltype(&glift_clang_import_struct) import_struct = nullptr;
    decltype(&glift_clang_format) format = nullptr;
    std::string error;
};

/// The path of libglift_clang.so: the environment variable GLIFT_CLANG; else the path relative to the executable, which
/// is the same in build and install trees; if no file is there, the bare name, which dlopen searches for.
std::string plugin_path() {
    if (const char* path = std::getenv("GLIFT_CLANG")) return path;
    std::error_code error;
    const auto executable = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error) {
        const auto path = executable.parent_path().parent_path() / "lib/glift/libglift_clang.so";
        if (std::filesystem::exists(path, error)) return path.string();
    }
    return "libglift_clang.so";
}

Plugin open_plugin() {
    Plugin plugin;
    void* library = dlopen(plugin_path().c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        plugin.error = std::string("cannot load the clang tooling: ") + dlerror() +
                       "; it needs the package libclang-cpp14, or set GLIFT_CLANG to the path of libglift_clang.so";
        return plugin;
    }
    const auto version = reinterpret_cast<decltype(&glift_clang_version)>(dlsym(library, "glift_clang_version"));
    if (version == nullptr || version() != plugin_version) {
        plugin.error = "the clang tooling (libglift_clang.so) is of another version than gliftc";
        return plugin;
    }
    plugin.import_struct =
        reinterpret_cast<decltype(&glift_clang_import_struct)>(dlsym(library, "glift_clang_import_struct"));
    plugin.format = reinterpret_cast<decltype(&glift_clang_format)>(dlsym(library, "glift_clang_format"));
    return plugin;
}

const Plugin& plugin() {
    static const Plugin opened = open_plugin();
    return opened;
}

}  // namespace

ImportResult import_struct(const ImportRequest& request) {
    ImportResult result;
    if (plugin().import_struct == nullptr) {
        result.error = plugin().error;
    } else {
        plugin().import_struct(request, result);
    }
    return result;
}

FormatResult format_code(std::string_view text, std::string_view style) {
    FormatResult result;
    if (plugin().format == nullptr) {
        result.error = plugin().error;
    } else {
        plugin().format(text, style, result);
    }
    return result;
}

}  // namespace gliftc
