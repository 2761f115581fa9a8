#include "commands.h"
#include "output.h"
#include "progress_line.h"

#include <glift/error.h>

#include <cerrno>
#include <cstring>

namespace gliftinfo {

using namespace glift::files;

namespace {

[[noreturn]] void throw_written(const std::string& path) {
    throw glift::Error(glift::ErrorCode::wrong_argument, "a file could not be written", path, std::strerror(errno),
                       "check the path, the permissions and the room on the disk");
}

}  // namespace

Output::Output(const std::string& path) : path_(path), file_(std::fopen(path.c_str(), "wb")) {
    if (!file_) throw_written(path_);
}

Output::~Output() {
    if (file_) std::fclose(file_);
}

void Output::write(std::span<const std::byte> bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) throw_written(path_);
}

void Output::write(const std::string& text) { write(std::as_bytes(std::span(text))); }

void Output::close() {
    if (std::fclose(std::exchange(file_, nullptr)) != 0) throw_written(path_);
}

int convert(const std::string& name, const std::string& path, const std::string& to) {
    VerifiedFile file(name);
    const Content content = content_at(file, path);
    ProgressLine line("convert", content.bytes());
    const Progress progress = [&](std::uint64_t bytes) { line.add(bytes); };
    if (to.ends_with(".npy")) write_npy(file, content, to, progress);
    else if (to.ends_with(".vti")) write_vti(file, content, to, progress);
    else if (to.ends_with(".nvdb")) write_nvdb(file, content, to, progress);
    else
        throw glift::Error(glift::ErrorCode::wrong_argument, "gliftinfo does not write files of this kind", to, "",
                           "give it a name that ends with .npy, .vti or .nvdb");
    return 0;
}

}  // namespace gliftinfo
