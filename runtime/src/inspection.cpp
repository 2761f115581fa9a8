#include <glift/inspect.h>

#include <cstdio>

namespace glift {

void Inspection::save(const std::string& path) const {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    const bool is_written = file && std::fwrite(text_.data(), 1, text_.size(), file) == text_.size();
    if ((file && std::fclose(file) != 0) || !is_written)
        throw Error(ErrorCode::wrong_argument, "the file cannot be written", "Inspection::save", path,
                    "name a file in a folder that exists and has room");
}

}  // namespace glift
