// Compiles arbitrary text, without writing outputs. The text can import the standard library. There must be no crash,
// hang or sanitizer report.

#include "diag/render.h"
#include "driver/compile.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace {

/// The files of the disk, each read once: the library does not change while the fuzzer runs.
gliftc::FileSystem library_once() {
    static std::map<std::string, gliftc::ReadResult> read_already;
    static const gliftc::FileSystem disk = gliftc::disk();
    gliftc::FileSystem files = disk;
    files.read = [](const std::string& path) {
        const auto known = read_already.find(path);
        return known != read_already.end() ? known->second : read_already.emplace(path, disk.read(path)).first->second;
    };
    return files;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    static const gliftc::FileSystem library = library_once();
    gliftc::FileSystem files = library;
    files.read = [&text](const std::string& path) {
        return path == "input.glift" ? gliftc::ReadResult{text, {}} : library.read(path);
    };
    // Only the library is visible, so that imports in the input cannot read other files.
    files.exists = [](const std::string& path) {
        return path == "input.glift" || (path.starts_with(GLIFT_SOURCE_DIR "/stdlib/") && library.exists(path));
    };
    gliftc::Options options;
    options.files = {"input.glift"};
    options.library_folder = GLIFT_SOURCE_DIR "/stdlib";
    options.check_only = true;
    gliftc::Compilation compilation;
    gliftc::compile(options, files, compilation);
    gliftc::render_text(compilation.diagnostics, compilation.sources, gliftc::Colour::plain);
    return 0;
}
