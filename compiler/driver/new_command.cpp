// `gliftc new NAME`: a project of one kernel with a test, and a program that calls it.
#include "base/version.h"
#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/environment.h"
#include "driver/file_system.h"
#include "emit/cpp/reserved.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string_view>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

constexpr const char* module_text = R"(/// A field of numbers on a grid, and a kernel that smooths it.
module @MODULE@;

/// Elements outside are those of the edge.
pub structure Field = Array<2, float, edge: clamp>;

/// Each element of `to` becomes the mean of five elements of `from`: the one at its address, and that one's neighbours.
pub kernel smooth(from: in near<Field, 1>, to: out each<Field>) {
    var sum = from[0];
    for axis in 0..2 {
        sum += from[+unit(axis)] + from[-unit(axis)];
    }
    to = sum / 5.0;
}

/// 5 at one address, and 0 elsewhere.
kernel set_peak(a: at<Field>, field: out each<Field>, peak: uint2) {
    field = a == peak ? 5.0 : 0.0;
}

test "a peak spreads to its neighbours" {
    temp from = Field(uint2(8, 8));
    temp to = Field(uint2(8, 8));
    set_peak(from, uint2(3, 4));
    smooth(from, to);
    expect_near(await to[uint2(3, 4)], 1.0, 0.00001);
    expect_near(await to[uint2(4, 4)], 1.0, 0.00001);
    expect(await to[uint2(4, 5)] == 0.0);
}
)";

constexpr const char* program_text = R"(// Smooths a peak, and prints the elements around it.
#include "@FILE@.glift.hpp"

#include <cstdio>
#include <exception>
#include <vector>

int main() {
    try {
        const auto device = glift::Device::open();  // a GPU if there is one; GLIFT_DEVICE=host: the CPU's cores
        @MODULE@::Field from(device, {8, 8}), to(device, {8, 8});
        std::vector<float> peak(64, 0.0f);
        peak[4 * 8 + 3] = 5.0f;
        from.write(peak);
        @MODULE@::smooth(device, from, to);
        const std::vector<float> values = to.read({1, 3}, {5, 3});  // 5 x 3 elements from {1, 3} on
        std::printf("%s:\n", device.properties().name.c_str());
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 5; ++x) std::printf(" %4.1f", values[y * 5 + x]);
            std::printf("\n");
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
)";

constexpr const char* lists_text = R"(cmake_minimum_required(VERSION 3.25)
project(@NAME@ LANGUAGES CXX)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release)
endif()

find_package(glift @VERSION@ REQUIRED)

add_executable(@NAME@ main.cpp)
glift_compile(TARGET @NAME@ SOURCES @FILE@.glift)

enable_testing()
add_test(NAME kernels COMMAND glift::gliftc test ${CMAKE_CURRENT_SOURCE_DIR}/@FILE@.glift)
add_test(NAME program COMMAND @NAME@)
)";

/// Names of targets that CMake or its generators have, and of modules that would hide Glift's own.
constexpr std::array reserved = {"all",     "clean",          "edit_cache",    "glift",   "glift_runtime",
                                 "gliftc",  "help",           "install",       "kernels", "main",
                                 "package", "package_source", "rebuild_cache", "std",     "test"};

constexpr std::string_view keywords[] = {
#define PUNCTUATION(name, text)
#define KEYWORD(text) #text,
#define WORD(text)
#include "syntax/tokens.def"
#undef PUNCTUATION
#undef KEYWORD
#undef WORD
};

std::string module_of(std::string name) {
    std::ranges::replace(name, '-', '_');
    return name;
}

/// Why no project can have this name; empty: it can.
std::string fault_of(const std::string& name) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto is_allowed = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; };
    if (name.empty() || !is_letter(name[0]) || !std::ranges::all_of(name, is_allowed))
        return "a name is a letter, then letters, digits, '_' and '-'";
    const std::string module = module_of(name);
    if (std::ranges::find(reserved, name) != reserved.end() || std::ranges::count(keywords, module) != 0 ||
        cpp::is_word(module) || cpp::is_macro(module) || cpp::is_global(module))
        return "CMake, C++ or Glift uses that name";
    return {};
}

std::string filled(std::string_view pattern, const std::string& name) {
    std::string text(pattern);
    const std::pair<std::string, std::string> words[] = {
        {"@NAME@", name}, {"@FILE@", name}, {"@MODULE@", module_of(name)}, {"@VERSION@", std::string(version())}};
    for (const auto& [word, value] : words)
        for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + value.size()))
            text.replace(at, word.size(), value);
    return text;
}

void write(const fs::path& file, const std::string& text) {
    if (const auto error = write_if_changed(file.string(), text))
        throw EnvironmentError("cannot write '" + file.string() + "': " + *error);
}

/// What CMake needs to find this gliftc: nothing where it is installed for the whole system.
std::string prefix_setting() {
    const fs::path prefix = fs::canonical("/proc/self/exe").parent_path().parent_path();
    if (prefix == "/usr" || prefix == "/usr/local") return {};
    return " -DCMAKE_PREFIX_PATH=" + prefix.string();
}

}  // namespace

int make_project(const Options& options) {
    const fs::path folder = options.project;
    const std::string name = folder.filename().string();
    if (const std::string fault = fault_of(name); !fault.empty()) {
        std::fprintf(stderr, "gliftc: no project can be named '%s': %s\n", name.c_str(), fault.c_str());
        return static_cast<int>(ExitCode::wrong_usage);
    }
    if (fs::exists(folder)) {
        std::fprintf(stderr, "gliftc: '%s' is there already: choose another name, or remove it\n",
                     folder.string().c_str());
        return static_cast<int>(ExitCode::wrong_usage);
    }
    write(folder / (name + ".glift"), filled(module_text, name));
    write(folder / "main.cpp", filled(program_text, name));
    write(folder / "CMakeLists.txt", filled(lists_text, name));
    const std::string path = folder.string();
    std::printf("made %s: %s.glift, main.cpp, CMakeLists.txt\n\n"
                "    gliftc test %s/%s.glift\n"
                "    cmake -S %s -B %s/build%s\n"
                "    cmake --build %s/build\n"
                "    %s/build/%s\n",
                path.c_str(), name.c_str(), path.c_str(), name.c_str(), path.c_str(), path.c_str(),
                prefix_setting().c_str(), path.c_str(), path.c_str(), name.c_str());
    return static_cast<int>(ExitCode::done);
}

}  // namespace gliftc
