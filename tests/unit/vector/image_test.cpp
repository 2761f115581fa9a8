// Loads, stores and filtering of texels on the host device: conversion and bounds checks.
#include <glift/host/image.h>

#include <gtest/gtest.h>

#include <vector>

using namespace glift;
using namespace glift::host;

namespace {

struct TestImage {
    std::vector<std::byte> bytes;
    HostMemory memory;

    TestImage(Format format, std::size_t texel, std::array<std::uint32_t, 3> extent)
        : bytes(texel * extent[0] * extent[1] * extent[2]), memory{bytes.data(), bytes.size(), extent, format, 1} {}
};

}  // namespace

TEST(Image, StoresFractionsRoundedToEven) {
    TestImage image(Format::rgba8, 4, {4, 2, 1});
    store_texel<Format::rgba8, float4>(image.memory, int2(3, 1), float4(0.5f, 2.0f, -1.0f, 1.0f / 255.0f));
    EXPECT_EQ(image.bytes[7 * 4], std::byte{128});
    EXPECT_EQ((load_texel<Format::rgba8, float4>(image.memory, int2(3, 1))),
              float4(128.0f / 255.0f, 1, 0, 1.0f / 255.0f));
}

TEST(Image, IsSafeOutside) {
    TestImage image(Format::r32ui, 4, {2, 2, 2});
    store_texel<Format::r32ui, uint>(image.memory, int3(2, 0, 0), 7u);
    store_texel<Format::r32ui, uint>(image.memory, int3(0, -1, 0), 7u);
    for (std::byte byte : image.bytes) EXPECT_EQ(byte, std::byte{});
    EXPECT_EQ((load_texel<Format::r32ui, uint>(image.memory, int3(0, 0, 9))), 0u);
}

TEST(Image, FiltersBetweenCentresAndClampsAtTheEdge) {
    TestImage image(Format::r32f, 4, {4, 1, 1});
    for (int x = 0; x < 4; ++x) store_texel<Format::r32f, float>(image.memory, int2(x, 0), float(x));
    EXPECT_EQ((sample_linear<Format::r32f, float>(image.memory, float2(0.5f, 0.5f))), 1.5f);
    EXPECT_EQ((sample_linear<Format::r32f, float>(image.memory, float2(0.0f, 0.5f))), 0.0f);
    EXPECT_EQ((sample_linear<Format::r32f, float>(image.memory, float2(2.0f, 0.5f))), 3.0f);
    EXPECT_EQ((sample_nearest<Format::r32f, float>(image.memory, float2(0.6f, 0.5f))), 2.0f);
}
