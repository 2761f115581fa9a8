// Draws of the language in recordings, and in a program's own command buffer.
#include "draws.glift.hpp"
#include "plain_vulkan.h"

namespace {

using glift::float4;
using glift::uint2;

constexpr uint2 size = {40, 24};

/// A triangle at a depth, which covers the window's left half; and one that covers all of it.
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
    /// Of the first row: at the left, at the right.
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
        device.wait();  // what was written before
        const auto before = device.statistics().submissions;
        recording.submit();
        EXPECT_EQ(device.statistics().submissions - before, 1u);
        return drawing.ends();
    };
    EXPECT_EQ(replayed(), Ends(shade_of(0.25f), shade_of(0.5f)));
    // The same commands see what corners and counts are by then; the depth is cleared each time.
    drawing.corners.write(joined(everything(0.75f), left_half(0.875f)));
    EXPECT_EQ(replayed(), Ends(shade_of(0.75f), shade_of(0.75f)));
    drawing.corners.write(joined(left_half(0.125f), everything(0.5f)));
    drawing.count.fill(5);  // one triangle, and two corners of none
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
    device.commands().flush();  // before the program's own commands
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

}  // namespace
