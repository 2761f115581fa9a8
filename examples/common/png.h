// Grey pictures in PNG files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace png {

/// Rows from top to bottom; 0 is black, 1 is white. Values are as in the file: nothing is converted from or to sRGB.
struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<float> values;
};

/// Reads a file; colours are converted to grey, alpha is ignored. Throws std::runtime_error, which names the file and
/// what is wrong.
Picture read(const std::string& path);

/// Writes 8 bits a pixel; values beyond [0, 1] are clamped. Throws std::runtime_error.
void write(const std::string& path, const Picture& picture);

}  // namespace png
