// Draws: coverage, blending, depth test, counts from the device; on the host device and on Vulkan, and compared between
// the two.
#include "draw_kernels.h"
#include "plain_vulkan.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace kernels;
using glift::uint2;

/// A list of corners, the images to draw to, and the calls that draw.
struct Scene {
    glift::Device device;
    uint2 extent;
    glift::Memory corners, counts, image, depth;
    std::uint32_t corner_count;

    Scene(const glift::Device& device, uint2 extent, const std::vector<Corner>& list)
        : device(device), extent(extent),
          corners(buffer(device, "corners", std::max<std::size_t>(1, list.size()) * sizeof(Corner))),
          counts(buffer(device, "counts", 4)), image(texture("image", glift::Format::rgba32f)),
          depth(texture("depth", glift::Format::d32)), corner_count(static_cast<std::uint32_t>(list.size())) {
        if (!list.empty()) device.commands().upload(corners, 0, bytes_of(list));
        clear_depth();
    }
    glift::Memory texture(const char* name, glift::Format format, std::uint32_t mips = 1) const {
        return device.allocate({.name = name,
                                .kind = glift::MemoryKind::image2d,
                                .format = format,
                                .extent = {extent.x, extent.y, 1},
                                .mips = mips});
    }
    void clear_depth() const {
        const std::vector<float> ones(std::size_t{extent.x} * extent.y, 1.0f);
        const glift::ImageRegion all[] = {{.extent = {extent.x, extent.y, 1}}};
        device.commands().upload_image(depth, all, bytes_of(ones));
    }
    struct How {
        uint2 origin = {0, 0}, extent = {0, 0};  ///< the viewport; no extent: the whole image
        std::uint32_t instances = 1;
        float shift = 0.0f;
        std::vector<glift::Patch> patches = {};
    };
    void draw(const glift::Kernel& kernel, const How& how) const { draw(device.commands(), kernel, how); }
    void draw(const glift::Commands& commands, const glift::Kernel& kernel, const How& how) const {
        const glift::Memory memories[] = {corners, counts};
        const glift::Attachment colours[] = {{image}};
        const glift::DrawTargets targets = {colours,
                                            kernel.drawing->depth ? glift::Attachment{depth} : glift::Attachment{},
                                            how.origin, how.extent.x ? how.extent : extent};
        const DrawParameters parameters = {corner_count, how.instances, how.shift};
        commands.dispatch(kernel, {.form = glift::FormName::general,
                                   .memories = memories,
                                   .parameters = bytes_of(parameters),
                                   .size = {corner_count, how.instances, 1, 1},
                                   .patches = how.patches,
                                   .targets = &targets});
    }
    template <class T> std::vector<T> texels(const glift::Memory& texture) const {
        const glift::ImageRegion all[] = {{.extent = {extent.x, extent.y, 1}}};
        return values_of<T>(
            device.commands()
                .download_image(texture, all,
                                std::uint64_t{extent.x} * extent.y * glift::texel_bytes(texture.description().format))
                .get());
    }
    std::vector<float> colours() const { return texels<float>(image); }
    std::uint32_t count() const { return read<std::uint32_t>(device, counts, 1)[0]; }
};

Corner corner(float x, float y, float z, float r, float a = 1.0f) { return {{x, y, z, 1.0f}, {r, 0.0f, 0.0f, a}}; }

/// Two triangles that cover the whole viewport.
std::vector<Corner> sheet(float z, float r, float a = 1.0f) {
    const Corner p = corner(-1, -1, z, r, a), q = corner(1, -1, z, r, a), s = corner(-1, 1, z, r, a),
                 t = corner(1, 1, z, r, a);
    return {p, s, q, q, s, t};
}

std::vector<Corner> joined(std::vector<Corner> a, const std::vector<Corner>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

class Draw : public OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(Draw);

TEST_P(Draw, CoversEachPixelOnce) {
    const Scene scene(device, uint2(37, 21), sheet(0.5f, 0.25f));
    scene.draw(draw_replacing, {});
    EXPECT_EQ(scene.count(), 37u * 21u);
    const std::vector<float> colours = scene.colours(), depths = scene.texels<float>(scene.depth);
    for (std::size_t i = 0; i < 37 * 21; ++i) {
        ASSERT_FLOAT_EQ(colours[4 * i], 0.25f);
        ASSERT_FLOAT_EQ(colours[4 * i + 3], 1.0f);
        ASSERT_FLOAT_EQ(depths[i], 0.5f);
    }
}

TEST_P(Draw, DepthHidesWhatIsBehind) {
    const Scene scene(device, uint2(16, 16), joined(joined(sheet(0.5f, 1), sheet(0.75f, 2)), sheet(0.25f, 3)));
    scene.draw(draw_replacing, {});
    EXPECT_EQ(scene.count(), 2u * 256u);
    EXPECT_EQ(scene.colours()[0], 3.0f);
}

TEST_P(Draw, BlendsInOrder) {
    const Scene scene(device, uint2(16, 16), joined(sheet(0.5f, 0.5f, 0.5f), sheet(0.5f, 0.25f, 0.25f)));
    scene.draw(draw_over, {});
    EXPECT_FLOAT_EQ(scene.colours()[0], 0.5f * 0.75f + 0.25f);
    EXPECT_FLOAT_EQ(scene.colours()[3], 0.5f * 0.75f + 0.25f);
}

TEST_P(Draw, TheRangeOfTheTargetsIsTheViewport) {
    const Scene scene(device, uint2(32, 16), sheet(0.5f, 1));
    scene.draw(draw_replacing, {.origin = {5, 3}, .extent = {9, 7}});
    EXPECT_EQ(scene.count(), 63u);
    const std::vector<float> colours = scene.colours();
    for (std::size_t y = 0; y < 16; ++y)
        for (std::size_t x = 0; x < 32; ++x)
            ASSERT_EQ(colours[4 * (32 * y + x)], x >= 5 && x < 14 && y >= 3 && y < 10 ? 1.0f : 0.0f) << x << ' ' << y;
}

TEST_P(Draw, InstancesAreDrawnOneAfterTheOther) {
    const float w = 0.5f;  // the left quarter of the viewport
    const Scene scene(device, uint2(40, 8),
                      {corner(-1, -1, 0.5f, 1), corner(-1, 1, 0.5f, 1), corner(-1 + w, -1, 0.5f, 1),
                       corner(-1 + w, -1, 0.5f, 1), corner(-1, 1, 0.5f, 1), corner(-1 + w, 1, 0.5f, 1)});
    scene.draw(draw_replacing, {.instances = 3, .shift = w});
    EXPECT_EQ(scene.count(), 30u * 8u);
}

TEST_P(Draw, CountsMayLiveOnTheDevice) {
    const Scene scene(device, uint2(16, 16), joined(sheet(0.5f, 1), sheet(0.25f, 2)));
    const glift::Memory number = buffer(device, "number", 8);
    device.commands().upload(number, 0,
                             bytes_of(std::vector<std::uint32_t>{8, 1}));  // two triangles and two more vertices
    scene.draw(draw_replacing,
               {.instances = 4, .patches = {{.value = {number, 0}, .offset = 0}, {.value = {number, 4}, .offset = 4}}});
    EXPECT_EQ(scene.count(), 256u);
    EXPECT_EQ(scene.colours()[0], 1.0f);
    device.commands().fill(number, 0, 4, 0);
    scene.draw(draw_replacing, {.patches = {{.value = {number, 0}, .offset = 0}}});
    EXPECT_EQ(scene.count(), 256u);
}

TEST_P(Draw, FacesAreCulled) {
    const Scene scene(device, uint2(16, 16), sheet(0.5f, 1));  // counter-clockwise
    scene.draw(draw_culled, {});
    EXPECT_EQ(scene.count(), 256u);
    std::vector<Corner> turned = sheet(0.25f, 1);
    std::swap(turned[0], turned[1]);
    std::swap(turned[3], turned[4]);
    const Scene back(device, uint2(16, 16), turned);
    back.draw(draw_culled, {});
    EXPECT_EQ(back.count(), 0u);
}

/// Draws, compute passes and copies that depend on each other are ordered by barriers.
TEST_P(Draw, PassesBeforeAndAfterAreOrdered) {
    const Scene scene(device, uint2(64, 64), sheet(0.5f, 1));
    for (int round = 1; round <= 20; ++round) {
        device.commands().fill(scene.counts, 0, 4, 0);
        scene.clear_depth();
        scene.draw(draw_replacing, {});
        run_add(device, scene.counts, 1, 7);
        ASSERT_EQ(scene.count(), 2u * 4096u + 7u) << round;
    }
}

TEST_P(Draw, RecordingsDrawAtEachReplay) {
    const Scene scene(device, uint2(16, 16), sheet(0.5f, 0.5f, 0.5f));
    const glift::Recording recording =
        device.record([&](const glift::Commands& commands) { scene.draw(commands, draw_over, {}); });
    for (int round = 0; round < 3; ++round) recording.submit();
    EXPECT_FLOAT_EQ(scene.colours()[0], 0.875f);
    EXPECT_EQ(scene.count(), 3u * 256u);
}

TEST_P(Draw, RecordingsDoNotOutliveTheirTargets) {
    const Scene scene(device, uint2(16, 16), sheet(0.5f, 0.5f, 0.5f));
    const glift::Recording recording =
        device.record([&](const glift::Commands& commands) { scene.draw(commands, draw_over, {}); });
    glift::Memory member = scene.image;
    device.commands().replace(member, scene.texture("other", glift::Format::rgba32f), {scene.image});
    EXPECT_THROW(recording.submit(), glift::Error);
}

TEST_P(Draw, NothingIsDrawnOfNothing) {
    const Scene scene(device, uint2(8, 8), {});
    scene.draw(draw_replacing, {});
    EXPECT_EQ(scene.count(), 0u);
}

TEST_P(Draw, WrongTargetsAreErrors) {
    const Scene scene(device, uint2(16, 16), sheet(0.5f, 1));
    const glift::Memory memories[] = {scene.corners, scene.counts};
    const DrawParameters parameters = {6, 1, 0};
    const auto code = [&](const glift::Kernel& kernel, const glift::DrawTargets* targets) {
        return error_of([&] {
                   device.commands().dispatch(kernel, {.form = glift::FormName::general,
                                                       .memories = memories,
                                                       .parameters = bytes_of(parameters),
                                                       .size = {6, 1, 1, 1},
                                                       .targets = targets});
               })
            .code();
    };
    const glift::Attachment image[] = {{scene.image}}, missing_level[] = {{scene.image, 1}}, depth[] = {{scene.depth}};
    const uint2 all(16, 16), none(0, 0);
    const glift::DrawTargets no_colour = {{}, {scene.depth}, none, all}, no_depth = {image, {}, none, all},
                             beyond = {image, {scene.depth}, uint2(1, 0), all},
                             level = {missing_level, {scene.depth}, none, all},
                             twice = {depth, {scene.depth}, none, all};
    EXPECT_EQ(code(draw_replacing, nullptr), glift::ErrorCode::wrong_argument);
    for (const glift::DrawTargets* targets : {&no_colour, &no_depth, &beyond, &level, &twice})
        EXPECT_EQ(code(draw_replacing, targets), glift::ErrorCode::wrong_argument);
    EXPECT_EQ(scene.count(), 0u);
}

/// The device's limits are checked before Vulkan is called: each error says what was asked for and what is allowed.
TEST(DrawLimits, AreErrorsThatNameBothSizes) {
    const PlainVulkan mine;
    auto objects = mine.objects();
    objects.get_instance_proc_addr = pretending_loader;
    pretence.largest_viewport = 32;
    pretence.largest_framebuffer = 64;
    pretence.most_colours = 1;
    const auto device = glift::vulkan::adopt(objects);
    const auto refused = [](const auto& draw, const std::string& given, const std::string& allowed) {
        const glift::Error error = error_of(draw);
        EXPECT_EQ(error.code(), glift::ErrorCode::too_large) << error.what();
        EXPECT_NE(error.why().find(given), std::string::npos) << error.what();
        EXPECT_NE(error.why().find(allowed), std::string::npos) << error.what();
        EXPECT_FALSE(error.remedy().empty());
    };
    const Scene scene(device, uint2(64, 64), sheet(0.5f, 1));
    scene.draw(draw_replacing, {.origin = {32, 32}, .extent = {32, 32}});
    EXPECT_EQ(scene.count(), 1024u);
    refused([&] { scene.draw(draw_replacing, {}); }, "64 x 64", "32 x 32");
    const Scene wide(device, uint2(65, 8), sheet(0.5f, 1));
    refused([&] { wide.draw(draw_replacing, {.extent = {8, 8}}); }, "65 x 8", "64 x 64");
    const glift::Memory part = wide.texture("levels", glift::Format::rgba32f, 2).mip(1);
    const glift::ColourTarget two[] = {{"first", glift::Format::rgba32f}, {"second", glift::Format::rgba32f}};
    const glift::Drawing drawing = {.colours = two};
    glift::Kernel kernel = draw_over;
    kernel.drawing = &drawing;
    const glift::Memory memories[] = {scene.corners, scene.counts};
    const auto draw_to = [&](const glift::Kernel& kernel, std::span<const glift::Attachment> colours) {
        const DrawParameters parameters = {6, 1, 0};
        const glift::DrawTargets targets = {colours, {}, {0, 0}, {4, 4}};
        device.commands().dispatch(kernel, {.form = glift::FormName::general,
                                            .memories = memories,
                                            .parameters = bytes_of(parameters),
                                            .size = {6, 1, 1, 1},
                                            .targets = &targets});
    };
    const glift::Attachment level[] = {{part}}, images[] = {{scene.image}, {part}};
    refused([&] { draw_to(draw_over, level); }, "65 x 8", "64 x 64");
    refused([&] { draw_to(kernel, images); }, "2 colour targets", "allows 1");
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

/// Triangles within twice the viewport: lavapipe clips larger ones, which makes new vertices.
std::vector<Corner> random_triangles(std::size_t count) {
    std::mt19937 random(11);
    const auto number = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random()) / 4294967296.0f;
    };
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < count; ++i) {
        const float x = number(-1.2f, 1.2f), y = number(-1.2f, 1.2f), z = number(0.1f, 0.9f);
        const float size = i % 3 == 0 ? 0.02f : i % 3 == 1 ? 0.2f : 0.75f;
        for (int k = 0; k < 3; ++k) {
            const float w = number(0.5f, 2.0f);
            corners.push_back(
                {{(x + number(-size, size)) * w, (y + number(-size, size)) * w, (z + number(-0.1f, 0.1f)) * w, w},
                 {static_cast<float>(i + 1), number(0, 1), number(0, 1), number(0, 1)}});
        }
    }
    return corners;
}

/// The largest change of depth of a triangle from a pixel to one beside or diagonal to it, which is large for thin
/// triangles. Devices round vertices, so how far their depths may differ grows with it.
float depth_slope(uint2 extent, const Corner* corners) {
    double x[3], y[3], z[3];
    for (int i = 0; i < 3; ++i) {
        x[i] = corners[i].place[0] / corners[i].place[3] * extent.x / 2;
        y[i] = corners[i].place[1] / corners[i].place[3] * extent.y / 2;
        z[i] = corners[i].place[2] / corners[i].place[3];
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    const double dx = ((z[1] - z[0]) * (y[2] - y[0]) - (z[2] - z[0]) * (y[1] - y[0])) / area;
    const double dy = ((x[1] - x[0]) * (z[2] - z[0]) - (x[2] - x[0]) * (z[1] - z[0])) / area;
    return static_cast<float>(std::abs(dx) + std::abs(dy));
}

/// At most four pixels show another triangle on the host device than on Vulkan. In all others, depths and colours agree
/// within bounds of rounding.
TEST(DrawBeside, HostAndVulkanShowTheSame) {
    const glift::Device host = glift::Device::open("host"), vulkan = glift::Device::open(vulkan_name());
    const uint2 extent(320, 200);
    const auto corners = random_triangles(600);
    const Scene a(host, extent, corners), b(vulkan, extent, corners);
    a.draw(draw_replacing, {});
    b.draw(draw_replacing, {});
    const auto first = a.colours(), second = b.colours();
    const auto depth = a.texels<float>(a.depth), other_depth = b.texels<float>(b.depth);
    std::size_t others = 0, deep = 0, drawn = 0;
    float worst_colour = 0;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const auto triangle = std::lround(first[4 * i]);
        if (triangle != std::lround(second[4 * i])) {
            ++others;
            continue;
        }
        if (triangle == 0) continue;
        ++drawn;
        const float slope = depth_slope(extent, &corners[3 * static_cast<std::size_t>(triangle - 1)]);
        deep += std::abs(depth[i] - other_depth[i]) > 1e-6f + slope / 128;
        for (std::size_t k = 1; k < 4; ++k)
            worst_colour = std::max(worst_colour, std::abs(first[4 * i + k] - second[4 * i + k]));
    }
    EXPECT_LE(others, 4u);
    EXPECT_EQ(deep, 0u);
    EXPECT_GT(drawn, 40000u);
    EXPECT_LT(worst_colour, 1e-3f);
    for (const std::string& message : vulkan.validation_messages()) ADD_FAILURE() << message;
}

/// Each triangle drawn separately covers as many pixels on the host device as on Vulkan.
TEST(DrawBeside, EveryTriangleHasTheSamePixels) {
    const glift::Device host = glift::Device::open("host"), vulkan = glift::Device::open(vulkan_name());
    const uint2 extent(160, 100);
    const auto corners = random_triangles(150);
    for (std::size_t t = 0; t < 150; ++t) {
        const std::vector<Corner> one(corners.begin() + static_cast<long>(3 * t),
                                      corners.begin() + static_cast<long>(3 * t + 3));
        const Scene a(host, extent, one), b(vulkan, extent, one);
        a.draw(draw_replacing, {});
        b.draw(draw_replacing, {});
        ASSERT_EQ(a.count(), b.count()) << "triangle " << t;
    }
    for (const std::string& message : vulkan.validation_messages()) ADD_FAILURE() << message;
}

}  // namespace
