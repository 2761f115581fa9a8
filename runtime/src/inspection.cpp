#include <glift/inspect.h>

#include <cstdio>
#include <filesystem>

namespace glift {

void Inspection::save(const std::string& path) const {
    const std::string part = path + ".part";  // renamed at the end: a reader sees the old file or the new one
    std::FILE* file = std::fopen(part.c_str(), "wb");
    bool is_written = file && std::fwrite(text_.data(), 1, text_.size(), file) == text_.size();
    is_written = !(file && std::fclose(file) != 0) && is_written;
    std::error_code failed;
    if (is_written) std::filesystem::rename(part, path, failed);
    if (is_written && !failed) return;
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw Error(ErrorCode::wrong_argument, "the file cannot be written", "Inspection::save", path,
                "name a file in a folder that exists and has room");
}

}  // namespace glift
