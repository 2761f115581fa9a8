// Draws declared in Glift: in recordings, in the command buffer of a program that uses Vulkan itself, and into that
// program's images. Also derivatives of values that draws load.
#include "draws.glift.hpp"
#include "plain_vulkan.h"
#include "user_image.h"

#include <bit>

namespace {

using glift::float4;
using glift::uint2;

constexpr uint2 size = {40, 24};

/// `left_half`: a triangle at depth z in the window's left half, which covers the left half of the window's first row;
/// `everything`: a triangle at depth z that covers the whole window.
std::vector<float4> left_half(float z) { return {{-1, -1, z, 1}, {-1, 3, z, 1}, {0, -1, z, 1}}; }
std::vector<float4> everything(float z) { return {{-1, -1, z, 1}, {-1, 3, z, 1}, {3, -1, z, 1}}; }

std::vector<float4> joined(std::vector<float4> a, const std::vector<float4>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

struct Drawing {
    draws::Corners corners;
    draws::Line count;
    draws::Picture picture;

    explicit Drawing(const glift::Device& device) : corners(device, 6), count(device, 1), picture(device, size) {
        corners.write(joined(everything(0.5f), left_half(0.25f)));
        count.fill(6);
    }
    void show(const glift::Commands& commands) const { draws::show(commands, corners, count, picture); }
    /// The pixels at the left and at the right end of the first row.
    std::pair<glift::uint, glift::uint> ends() const {
        const std::vector<glift::uint> pixels = picture.read();
        return {pixels.front(), pixels[size.x - 1]};
    }
};
using Ends = std::pair<glift::uint, glift::uint>;

constexpr glift::uint shade_of(float z) { return 1 + static_cast<glift::uint>(255 * z); }

TEST(Draws, AreReplayedWithOneSubmission) {
    const PlainVulkan mine;
    const auto device = glift::vulkan::adopt(mine.objects());
    Drawing drawing(device);
    const auto recording = device.record([&](const glift::Commands& commands) { drawing.show(commands); });
    const auto replayed = [&] {
        device.wait();  // earlier writes are done
        const auto before = device.statistics().submissions;
        recording.submit();
        EXPECT_EQ(device.statistics().submissions - before, 1u);
        return drawing.ends();
    };
    EXPECT_EQ(replayed(), Ends(shade_of(0.25f), shade_of(0.5f)));
    // A replay reads the corners and the count as they are then; the depth is cleared each time.
    drawing.corners.write(joined(everything(0.75f), left_half(0.875f)));
    EXPECT_EQ(replayed(), Ends(shade_of(0.75f), shade_of(0.75f)));
    drawing.corners.write(joined(left_half(0.125f), everything(0.5f)));
    drawing.count.fill(5);  // one triangle, and two corners without a third
    EXPECT_EQ(replayed(), Ends(shade_of(0.125f), 0));
    drawing.count.fill(0);
    EXPECT_EQ(replayed(), Ends(0, 0));
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

TEST(Draws, AreReplayedOnTheHost) {
    const auto device = glift::Device::open("host");
    Drawing drawing(device);
    const auto recording = device.record([&](const glift::Commands& commands) { drawing.show(commands); });
    recording.submit();
    EXPECT_EQ(drawing.ends(), Ends(shade_of(0.25f), shade_of(0.5f)));
    drawing.count.fill(3);
    recording.submit();
    EXPECT_EQ(drawing.ends(), Ends(shade_of(0.5f), shade_of(0.5f)));
}

TEST(Draws, GoIntoTheProgramsCommandBuffer) {
    const PlainVulkan mine;
    const auto device = glift::vulkan::adopt(mine.objects());
    Drawing drawing(device);
    device.commands().flush();  // submitted before the program's own commands
    const VkCommandBuffer commands = mine.begin();
    {
        const glift::Commands into = glift::vulkan::record_into(device, commands);
        drawing.show(into);
        glift::vulkan::finish(into);
        mine.run(commands);
    }
    EXPECT_EQ(drawing.ends(), Ends(shade_of(0.25f), shade_of(0.5f)));
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

/// Draws into one layer of one level of images that the program made, after the clears in the program's command buffer:
/// `left_half`, and `everything` behind the program's depths. All other texels keep what they were cleared to.
TEST(Draws, GoIntoTheProgramsImages) {
    const PlainVulkan mine;
    const auto device = glift::vulkan::adopt(mine.objects());
    const uint2 level(20, 12);
    const UserImage colours(mine, {.format = VK_FORMAT_R32_UINT,
                                   .extent = size,
                                   .mips = 2,
                                   .layers = 3,
                                   .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                            VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    const UserImage depths(mine,
                           {.format = VK_FORMAT_D32_SFLOAT,
                            .extent = level,
                            .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    const glift::Memory image = glift::vulkan::adopt_image(device, colours.description());
    const draws::Picture part(device, level, image.mip(1).layer(2));
    const draws::Depth depth(device, level, glift::vulkan::adopt_image(device, depths.description()));
    draws::Corners corners(device, 6);
    corners.write(joined(left_half(0.25f), everything(0.75f)));  // the second is behind the program's depths
    device.commands().flush();
    const VkCommandBuffer commands = mine.begin();
    {
        colours.clear(commands, VkClearColorValue{.uint32 = {77, 0, 0, 0}});
        depths.clear(commands, VkClearDepthStencilValue{0.5f, 0});
        const glift::Commands into = glift::vulkan::record_into(device, commands);
        draws::show_over(into, corners, part, depth);
        glift::vulkan::finish(into);
        mine.run(commands);
    }
    const auto ends = [](const std::vector<std::uint32_t>& texels, std::uint32_t width) {
        return Ends(texels.front(), texels[width - 1]);
    };
    EXPECT_EQ(ends(colours.texels(mine, 1, 2), level.x), Ends(shade_of(0.25f), 77));
    EXPECT_EQ(ends(colours.texels(mine, 1, 1), level.x), Ends(77, 77));
    EXPECT_EQ(ends(colours.texels(mine, 0, 2), size.x), Ends(77, 77));
    // A download in Glift's own stream reads the same texels.
    const glift::ImageRegion first[] = {{.extent = {1, 1, 1}}};
    EXPECT_EQ(kernels::values_of<std::uint32_t>(device.commands().download_image(part.data(), first, 4).get()).front(),
              shade_of(0.25f));
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

/// Floats in images are combined through a view of integers, which only an image of mutable format may have.
TEST(Draws, FloatsOfTheProgramsImagesAreCombined) {
    const PlainVulkan mine;
    const auto device = glift::vulkan::adopt(mine.objects());
    const glift::vulkan::UserImage wanted = {.format = VK_FORMAT_R32_SFLOAT,
                                             .extent = size,
                                             .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                                      VK_IMAGE_USAGE_TRANSFER_DST_BIT};
    glift::vulkan::UserImage free = wanted;
    free.flags = VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT;
    const UserImage plain(mine, wanted), combined(mine, free);
    const VkCommandBuffer commands = mine.begin();
    for (const UserImage* image : {&plain, &combined})
        image->clear(commands, VkClearColorValue{.float32 = {-1.0f, 0, 0, 0}});
    mine.run(commands);
    const draws::Line line(device, 3);
    const draws::Slope slope(device, size, glift::vulkan::adopt_image(device, combined.description()));
    draws::lift(device, line, slope);
    device.wait();
    const std::vector<std::uint32_t> texels = combined.texels(mine, 0, 0);
    for (std::uint32_t i = 0; i < 4; ++i)
        EXPECT_EQ(std::bit_cast<float>(texels[i]), i < 2 ? 0.5f - static_cast<float>(i) : -1.0f);
    const draws::Slope refused(device, size, glift::vulkan::adopt_image(device, plain.description()));
    const glift::Error error = error_of([&] { draws::lift(device, line, refused); });
    EXPECT_EQ(error.code(), glift::ErrorCode::missing_feature) << error.what();
    EXPECT_NE(error.remedy().find("VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT"), std::string::npos) << error.what();
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

TEST(Draws, ToTheProgramsImagesNeedWhatTheyAreMadeFor) {
    const PlainVulkan mine;
    const auto device = glift::vulkan::adopt(mine.objects());
    const UserImage colours(mine, {.format = VK_FORMAT_R32_UINT,
                                   .extent = size,
                                   .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    const UserImage drawn(mine, {.format = VK_FORMAT_R32_UINT,
                                 .extent = size,
                                 .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    const VkCommandBuffer commands = mine.begin();
    for (const UserImage* image : {&colours, &drawn}) image->clear(commands, VkClearColorValue{.uint32 = {3, 0, 0, 0}});
    mine.run(commands);
    const draws::Picture stored(device, size, glift::vulkan::adopt_image(device, colours.description())),
        target(device, size, glift::vulkan::adopt_image(device, drawn.description()));
    const draws::Depth depth(device, size);
    const draws::Corners corners(device, 3);
    const auto refused = [](const glift::Error& error, const char* why) {
        EXPECT_EQ(error.code(), glift::ErrorCode::missing_feature) << error.what();
        EXPECT_NE(error.why().find(why), std::string::npos) << error.what();
        EXPECT_NE(error.remedy().find("UserImage::usage"), std::string::npos);
    };
    draws::make_double(device, stored);
    refused(error_of([&] { draws::show_over(device, corners, stored, depth); }), "COLOR_ATTACHMENT_BIT");
    refused(error_of([&] { draws::make_double(device, target); }), "STORAGE_BIT");
    draws::show_over(device, corners, target, depth);
    refused(error_of([&] { (void)device.commands().download_image(target.data(), {}, 4).get(); }), "TRANSFER_SRC_BIT");
    const auto wrong = [&](glift::vulkan::UserImage image, const char* why) {
        const auto error = error_of([&] { glift::vulkan::adopt_image(device, image); });
        EXPECT_EQ(error.code(), glift::ErrorCode::wrong_argument) << error.what();
        EXPECT_NE(error.why().find(why), std::string::npos) << error.what();
    };
    glift::vulkan::UserImage other = colours.description();
    other.format = VK_FORMAT_B8G8R8A8_UNORM;
    wrong(other, "no texel format");
    other = colours.description();
    other.image = VK_NULL_HANDLE;
    wrong(other, "null");
    other = colours.description();
    other.extent.y = 0;
    wrong(other, "no texels");
    // A structure of another size does not accept the image.
    EXPECT_EQ(error_of([&] {
                  draws::Picture(device, {41, 24}, glift::vulkan::adopt_image(device, colours.description()));
              }).code(),
              glift::ErrorCode::wrong_argument);
    device.wait();
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

/// On lavapipe, helper invocations (the pixels beside a triangle that derivatives need) load zeros from buffers. Draws
/// whose derivatives would be wrong are refused there, and no others.
TEST(Draws, DeriveWhatTheyLoadWhereTheDeviceCan) {
    for (const char* name : {"host", "lavapipe"}) {
        const auto device = glift::Device::open(name);
        EXPECT_EQ(device.properties().helpers_load, device.properties().kind == glift::DeviceKind::host);
        draws::Corners corners(device, 3);
        corners.write(left_half(0.25f));
        draws::Line line(device, 3 * size.x);
        std::vector<std::uint32_t> rising(3 * size.x);
        for (std::uint32_t i = 0; i < rising.size(); ++i) rising[i] = 5 * i;
        line.write(rising);
        const draws::Slope slope(device, size);
        const auto attempt = [&](auto&& draw) {
            if (device.properties().helpers_load) return draw();
            const glift::Error error = error_of(draw);
            EXPECT_EQ(error.code(), glift::ErrorCode::missing_feature) << error.what();
            EXPECT_NE(error.problem().find("derive"), std::string::npos) << error.what();
        };
        attempt([&] { draws::rise(device, corners, line, 2, slope); });
        if (device.properties().helpers_load) {
            EXPECT_EQ(slope.read({0, 0}, {1, 1}).front(), 10.0f);
        }
        attempt([&] { draws::rise_beyond(device, corners, line, slope); });
        draws::rise_of_place(device, corners, line, slope);
        EXPECT_NEAR(slope.read({0, 0}, {1, 1}).front(), 40.0f / static_cast<float>(size.x), 1e-4f);
        for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
    }
}

}  // namespace
