// Sizes of pictures on the command lines of benches.
#pragma once

#include <glift/glift.h>

#include <cstdio>
#include <stdexcept>
#include <string>

namespace bench {

/// WIDTHxHEIGHT; throws std::runtime_error where the text is not that, or a side is 0.
inline glift::uint2 picture_size(const std::string& text) {
    unsigned width = 0, height = 0;
    char beyond = 0;
    if (std::sscanf(text.c_str(), "%ux%u%c", &width, &height, &beyond) != 2 || width == 0 || height == 0)
        throw std::runtime_error("a size is WIDTHxHEIGHT, not " + text);
    return {width, height};
}

}  // namespace bench
