#include "picture.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
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

namespace picture {

namespace {

using glift::float4;

/// The sRGB transfer functions (IEC 61966-2-1).
float linear_of(float coded) { return coded <= 0.04045f ? coded / 12.92f : std::pow((coded + 0.055f) / 1.055f, 2.4f); }
float coded_of(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

std::uint8_t byte_of(float value) {  // NaN gives 0
    return value > 0 ? static_cast<std::uint8_t>(std::min(value, 1.0f) * 255 + 0.5f) : std::uint8_t{0};
}

std::size_t count_of(const Picture& picture) { return std::size_t{picture.width} * picture.height; }

Picture read_png(const std::string& path) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_us, decltype(&stbi_image_free)> values(
        stbi_load_16(path.c_str(), &width, &height, &channels, 4), &stbi_image_free);
    if (!values) throw std::runtime_error(path + ": cannot be read as a PNG: " + stbi_failure_reason());
    Picture picture{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}, {}};
    picture.pixels.resize(count_of(picture));
    const auto value = [&](std::size_t i) { return static_cast<float>(values.get()[i]) / 65535; };
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] =
            float4(linear_of(value(4 * i)), linear_of(value(4 * i + 1)), linear_of(value(4 * i + 2)), value(4 * i + 3));
    return picture;
}

void write_png(const std::string& path, const Picture& picture) {
    std::vector<std::uint8_t> bytes;
    for (const float4& p : picture.pixels)
        bytes.insert(bytes.end(),
                     {byte_of(coded_of(p.x)), byte_of(coded_of(p.y)), byte_of(coded_of(p.z)), byte_of(p.w)});
    const int width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
    // stb_image_write does not see where a file cannot be written to its end.
    std::ofstream file(path, std::ios::binary);
    const auto write = [](void* to, void* data, int size) {
        static_cast<std::ofstream*>(to)->write(static_cast<const char*>(data), size);
    };
    const int made = stbi_write_png_to_func(write, &file, width, height, 4, bytes.data(), 4 * width);
    file.close();
    if (made == 0 || !file) throw std::runtime_error(path + ": cannot be written");
}

/// An OpenEXR slice for a channel whose values are `stride` floats apart in memory, from `first` on.
Imf::Slice slice_of(float* first, std::size_t stride, const Picture& picture, const Imath::Box2i& window,
                    float otherwise) {
    const std::size_t x = stride * sizeof(float), y = x * picture.width;
    return Imf::Slice::Make(Imf::FLOAT, first, window, x, y, 1, 1, otherwise);
}

constexpr const char* channels[] = {"R", "G", "B", "A"};

Imf::FrameBuffer frame_of(Picture& picture, const Imath::Box2i& window) {
    Imf::FrameBuffer frame;
    for (unsigned k = 0; k < 4; ++k)
        frame.insert(channels[k], slice_of(&picture.pixels[0][k], 4, picture, window, k == 3 ? 1.0f : 0.0f));
    if (!picture.depth.empty()) frame.insert("Z", slice_of(picture.depth.data(), 1, picture, window, 0));
    return frame;
}

Picture read_exr(const std::string& path) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const Imf::ChannelList& list = file.header().channels();
    Picture picture{static_cast<std::uint32_t>(window.max.x - window.min.x + 1),
                    static_cast<std::uint32_t>(window.max.y - window.min.y + 1),
                    {},
                    {}};
    picture.pixels.resize(count_of(picture));
    if (list.findChannel("Z")) picture.depth.resize(count_of(picture));
    file.setFrameBuffer(frame_of(picture, window));
    file.readPixels(window.min.y, window.max.y);
    if (!list.findChannel("Y")) return picture;
    std::vector<float> grey(count_of(picture));
    Imf::FrameBuffer frame;
    frame.insert("Y", slice_of(grey.data(), 1, picture, window, 0));
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    for (std::size_t i = 0; i < grey.size(); ++i)
        picture.pixels[i] = float4(grey[i], grey[i], grey[i], picture.pixels[i].w);
    return picture;
}

void write_exr(const std::string& path, const Picture& picture) {
    Imf::Header header(static_cast<int>(picture.width), static_cast<int>(picture.height));
    for (const char* name : channels) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    if (!picture.depth.empty()) header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    Picture copy = picture;  // OpenEXR's frame buffers take pointers to mutable data
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame_of(copy, header.dataWindow()));
    file.writePixels(static_cast<int>(picture.height));
}

}  // namespace

Picture read(const std::string& path) {
    const std::string end = std::filesystem::path(path).extension();
    if (end == ".png") return read_png(path);
    if (end != ".exr") throw std::runtime_error(path + ": pictures are .png or .exr files");
    try {
        return read_exr(path);
    } catch (const std::exception& error) {
        throw std::runtime_error(path + ": cannot be read as an OpenEXR file: " + error.what());
    }
}

void write(const std::string& path, const Picture& picture) {
    const std::size_t count = count_of(picture);
    const bool fits = picture.pixels.size() == count && (picture.depth.empty() || picture.depth.size() == count);
    if (count == 0 || !fits)
        throw std::runtime_error(path + ": the picture has no pixels, or not as many as its size says");
    const std::string end = std::filesystem::path(path).extension();
    if (end == ".png") return write_png(path, picture);
    if (end != ".exr") throw std::runtime_error(path + ": pictures are .png or .exr files");
    try {
        write_exr(path, picture);
    } catch (const std::exception& error) {
        throw std::runtime_error(path + ": cannot be written: " + error.what());
    }
}

}  // namespace picture
