// Colour pictures with depth, in PNG and OpenEXR files.
#pragma once

#include <glift/vector.h>

#include <cstdint>
#include <string>
#include <vector>

namespace picture {

/// Rows from top to bottom. Colours are linear, with alpha; values beyond [0, 1] are allowed. `depth` is empty, or
/// holds a number for every pixel.
struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<glift::float4> pixels;
    std::vector<float> depth;
};

/// Reads a file with the extension `.png` (sRGB, no depth) or `.exr` (channels R, G, B, or Y for grey, and A and Z,
/// which is depth; missing colours are 0, missing alpha is 1). Throws std::runtime_error, which names the file and what
/// is wrong.
Picture read(const std::string& path);

/// Writes a `.png` file (8 bits a channel, sRGB, clamped to [0, 1], no depth) or an `.exr` file (float channels R, G,
/// B, A, and Z if there is depth). Throws std::runtime_error.
void write(const std::string& path, const Picture& picture);

}  // namespace picture
