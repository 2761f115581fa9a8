#include "png.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_FAILURE_USERMSG
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace png {

Picture read(const std::string& path) {
    int width = 0, height = 0, channels = 0;
    constexpr int grey = 1;
    const std::unique_ptr<stbi_us, decltype(&stbi_image_free)> pixels(
        stbi_load_16(path.c_str(), &width, &height, &channels, grey), &stbi_image_free);
    if (!pixels) throw std::runtime_error(path + ": cannot be read as a PNG: " + stbi_failure_reason());
    Picture picture{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
    picture.values.resize(std::size_t{picture.width} * picture.height);
    std::transform(pixels.get(), pixels.get() + picture.values.size(), picture.values.begin(),
                   [](stbi_us value) { return static_cast<float>(value) / 65535.0f; });
    return picture;
}

void write(const std::string& path, const Picture& picture) {
    std::vector<std::uint8_t> pixels(picture.values.size());
    std::transform(picture.values.begin(), picture.values.end(), pixels.begin(), [](float value) {
        return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
    });
    const int width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
    if (!stbi_write_png(path.c_str(), width, height, 1, pixels.data(), width)) {
        throw std::runtime_error(path + ": cannot be written");
    }
}

}  // namespace png
