// Memories that are a level or a layer of an image: they share its texels.
#include "test_device.h"

#include <numeric>

namespace {

using namespace kernels;
using glift::ErrorCode;
using glift::Format;
using glift::Memory;
using glift::MemoryKind;

constexpr std::uint32_t width = 12, height = 9;

std::vector<float> ramp(std::size_t count) {
    std::vector<float> values(count);
    std::iota(values.begin(), values.end(), 1.0f);
    return values;
}

class ImageParts : public OnEveryDevice {
protected:
    Memory layers(std::uint32_t count, std::uint32_t mips = 1) {
        return device.allocate({.name = "layers",
                                .kind = MemoryKind::image2darray,
                                .format = Format::r32f,
                                .extent = {width, height, count},
                                .mips = mips});
    }
    std::vector<float> texels(const Memory& image, const glift::ImageRegion& region) {
        const std::uint64_t bytes = 4ull * region.extent[0] * region.extent[1] * region.extent[2];
        return values_of<float>(device.commands().download_image(image, {&region, 1}, bytes).get());
    }
    void step(const glift::Commands& commands, const Memory& from, const Memory& to) {
        const Memory images[] = {from, to};
        const std::uint32_t block[2] = {width, height};
        commands.dispatch(image_step, {.form = glift::FormName::direct,
                                       .memories = images,
                                       .parameters = bytes_of(block),
                                       .size = {width, height, 1, 1}});
    }
    template <class Call> ErrorCode code_of(const Call& call) { return error_of(call).code(); }
};
GLIFT_ON_EVERY_DEVICE(ImageParts);

TEST_P(ImageParts, HaveTheTexelsOfTheImage) {
    const Memory image = layers(3, 2);
    const Memory level = image.mip(1), part = level.layer(2);
    EXPECT_EQ(level.extent(), (std::array<std::uint32_t, 3>{6, 4, 3}));
    EXPECT_EQ(part.extent(), (std::array<std::uint32_t, 3>{6, 4, 1}));
    EXPECT_EQ(part.description().kind, MemoryKind::image2d);
    const auto values = ramp(6 * 4);
    const glift::ImageRegion own = {.extent = {6, 4, 1}};
    device.commands().upload_image(part, {&own, 1}, bytes_of(values));
    EXPECT_EQ(texels(image, {.extent = {6, 4, 1}, .mip = 1, .face = 2}), values);
    EXPECT_EQ(texels(level, {.extent = {6, 4, 1}, .face = 2}), values);
    EXPECT_EQ(texels(image, {.extent = {6, 4, 1}, .mip = 1, .face = 1}), std::vector<float>(24));
    EXPECT_EQ(texels(image, {.extent = {6, 4, 1}, .mip = 0, .face = 2}), std::vector<float>(24));
}

TEST_P(ImageParts, AreReadAndWrittenInOnePass) {
    const Memory image = layers(2);
    const auto values = ramp(width * height);
    const glift::ImageRegion all = {.extent = {width, height, 1}};
    device.commands().upload_image(image, {&all, 1}, bytes_of(values));
    step(device, image.layer(0), image.layer(1));
    const auto stepped = texels(image, {.extent = {width, height, 1}, .face = 1});
    for (std::uint32_t i = 0; i < width * height; ++i)
        ASSERT_NEAR(stepped[i], values[i] + (i % width + 1 < width ? 0.5f : 0.0f) + 1.0f, 1e-3f) << i;
}

TEST_P(ImageParts, AreOneMemoryWhereTheyMeet) {
    const Memory image = device.allocate({.name = "levels",
                                          .kind = MemoryKind::image2d,
                                          .format = Format::r32f,
                                          .extent = {width, height, 1},
                                          .mips = 3});
    EXPECT_EQ(code_of([&] { step(device, image.mip(0), image.mip(0)); }), ErrorCode::aliased_memory);
    EXPECT_EQ(code_of([&] { step(device, image, image.mip(2)); }), ErrorCode::aliased_memory);
    EXPECT_NO_THROW(step(device, layers(2).layer(1), image.mip(0)));
}

TEST_P(ImageParts, OutliveTheHandleThatTheyWereMadeFrom) {
    glift::Recording recording;
    Memory second;
    {
        const Memory image = layers(2);
        second = image.layer(1);
        recording = device.record([&](const glift::Commands& commands) { step(commands, image.layer(0), second); });
    }
    recording.submit();
    recording.submit();
    EXPECT_EQ(texels(second, {.extent = {width, height, 1}})[5], 1.0f);
}

TEST_P(ImageParts, LieInTemporariesOfRecordings) {
    const Memory out = layers(1);
    const glift::Recording recording = device.record([&](const glift::Commands& commands) {
        const Memory image = commands.allocate(
            {.name = "layers", .kind = MemoryKind::image2darray, .format = Format::r32f, .extent = {width, height, 2}});
        step(commands, image.layer(0), image.layer(1));
        step(commands, image.layer(1), out.layer(0));
    });
    recording.submit();
    recording.submit();
    EXPECT_EQ(texels(out, {.extent = {width, height, 1}})[5], 2.0f);
}

TEST_P(ImageParts, ThatAreNotThereAreErrors) {
    const Memory image = layers(3, 2);
    EXPECT_EQ(code_of([&] { image.mip(2); }), ErrorCode::wrong_argument);
    EXPECT_EQ(code_of([&] { image.layer(3); }), ErrorCode::wrong_argument);
    EXPECT_EQ(code_of([&] { image.layer(0).layer(0); }), ErrorCode::wrong_argument);
    EXPECT_EQ(code_of([&] { image.layer(0).mip(1); }), ErrorCode::wrong_argument);
    EXPECT_EQ(code_of([&] { buffer(device, "f", 16).mip(0); }), ErrorCode::wrong_argument);
    EXPECT_EQ(code_of([&] { Memory().layer(0); }), ErrorCode::wrong_argument);
}

}  // namespace
