// Memories: contents, copies, images, sizes, and release.
#include "test_device.h"

#include <numeric>

namespace {

using namespace kernels;
using glift::Format;
using glift::MemoryKind;

class Memories : public OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(Memories);

std::vector<std::uint32_t> counting(std::size_t count, std::uint32_t first = 1) {
    std::vector<std::uint32_t> values(count);
    std::iota(values.begin(), values.end(), first);
    return values;
}

TEST_P(Memories, StartAsZeros) {
    for (int round = 0; round < 3; ++round) {  // from the second round on, memory is reused
        const auto f = buffer(device, "f", 4 * 5000);
        for (const std::uint32_t value : read<std::uint32_t>(device, f, 5000)) ASSERT_EQ(value, 0u);
        device.commands().fill(f, 0, 4 * 5000, 0xDEADBEEF);
        device.wait();
    }
}

TEST_P(Memories, StartAsZerosUnderAConditionThatHolds) {
    const auto is_set = buffer(device, "set", 4);
    device.commands().fill(is_set, 0, 4, 1);
    const glift::Commands commands = device.commands().where({is_set});
    const std::vector<std::byte> ones(7, std::byte(0xff));
    for (int round = 0; round < 3; ++round) {  // from the second round on, memory is reused
        const auto f = commands.allocate({.name = "f", .bytes = 7});
        EXPECT_EQ(read<std::byte>(device, f, 7), std::vector<std::byte>(7)) << round;
        device.commands().upload(f, 0, ones);
        device.wait();
    }
}

TEST_P(Memories, OddSizesAreKept) {
    for (const std::uint64_t bytes : {0, 1, 3, 5, 17}) {
        const auto f = buffer(device, "f", bytes);
        EXPECT_EQ(f.description().bytes, bytes);
        const std::vector<std::uint8_t> values(bytes, 7);
        device.commands().upload(f, 0, bytes_of(values));
        EXPECT_EQ(values_of<std::uint8_t>(device.commands().download(f, 0, bytes).get()), values);
    }
}

TEST_P(Memories, RegionsGoWhereTheySay) {
    const auto f = buffer(device, "f", 400), g = buffer(device, "g", 400);
    const auto values = counting(100);
    const glift::CopyRegion up[] = {{0, 40, 80}, {200, 200, 100}};
    device.commands().upload(f, up, bytes_of(values));
    const glift::CopyRegion across[] = {{40, 0, 40}, {200, 100, 8}};
    device.commands().copy(f, g, across);
    device.commands().fill(g, 4, 8, 77);
    const glift::CopyRegion down[] = {{0, 8, 16}, {100, 0, 8}};
    const auto download = device.commands().download(g, down, 24);
    EXPECT_EQ(values_of<std::uint32_t>(download.get()), (std::vector<std::uint32_t>{51, 52, 1, 77, 77, 4}));
}

TEST_P(Memories, CopyWithinOneMemory) {
    const auto f = buffer(device, "f", 400);
    device.commands().upload(f, 0, bytes_of(counting(100)));
    device.commands().copy(f, 0, f, 200, 200);
    EXPECT_EQ(read<std::uint32_t>(device, f, 100)[99], 50u);
}

TEST_P(Memories, DownloadsSeeTheMomentTheyWereAskedFor) {
    const auto g = buffer(device, "g", 256);
    run_store(device, g, 64, 1);
    const auto first = device.commands().download(g, 0, 256);
    run_store(device, g, 64, 2);
    const auto second = device.commands().download(g, 0, 256);
    EXPECT_EQ(values_of<std::uint32_t>(second.get())[5], 2u);
    EXPECT_EQ(values_of<std::uint32_t>(first.get())[5], 1u);
    EXPECT_TRUE(first.ready());
}

struct ImageCase {
    MemoryKind kind;
    Format format;
    std::array<std::uint32_t, 3> extent;
    std::uint32_t mips, mip, face;
};

TEST_P(Memories, ImagesKeepTheirTexels) {
    const ImageCase cases[] = {{MemoryKind::image1d, Format::r32f, {17, 1, 1}, 1, 0, 0},
                               {MemoryKind::image2d, Format::rgba8, {9, 7, 1}, 1, 0, 0},
                               {MemoryKind::image2d, Format::r8, {16, 8, 1}, 3, 1, 0},
                               {MemoryKind::image3d, Format::rgba32f, {5, 6, 7}, 1, 0, 0},
                               {MemoryKind::image3d, Format::r32ui, {8, 8, 8}, 4, 2, 0},
                               {MemoryKind::imagecube, Format::rgba16f, {8, 8, 1}, 1, 0, 4},
                               {MemoryKind::imagecube, Format::r32f, {8, 8, 1}, 2, 1, 5},
                               {MemoryKind::image2d, Format::d32, {9, 7, 1}, 1, 0, 0},
                               {MemoryKind::image2d, Format::rg32i, {9, 7, 1}, 1, 0, 0},
                               {MemoryKind::image2d, Format::r16ui, {10, 6, 1}, 1, 0, 0}};
    for (const ImageCase& c : cases) {
        SCOPED_TRACE(static_cast<int>(c.kind) * 100 + static_cast<int>(c.format));
        const auto image =
            device.allocate({.name = "image", .kind = c.kind, .format = c.format, .extent = c.extent, .mips = c.mips});
        glift::ImageRegion region = {.extent = {}, .mip = c.mip, .face = c.face};
        std::size_t texels = 1;
        for (int axis = 0; axis < 3; ++axis) {
            region.extent[axis] = std::max(c.extent[axis] >> c.mip, 1u);
            texels *= region.extent[axis];
        }
        // Bytes that are valid depths, 0 to 1, when read as floats.
        std::vector<std::byte> values(texels * texel_bytes(c.format));
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::byte(i % 60);
        const auto zeros = device.commands().download_image(image, {&region, 1}, values.size());
        device.commands().upload_image(image, {&region, 1}, values);
        const auto download = device.commands().download_image(image, {&region, 1}, values.size());
        EXPECT_EQ(values_of<std::byte>(zeros.get()), std::vector<std::byte>(values.size()));
        EXPECT_EQ(values_of<std::byte>(download.get()), values);
    }
}

TEST_P(Memories, BoxesOfImagesAndBuffers) {
    const auto make = [&](std::array<std::uint32_t, 3> extent) {
        return device.allocate({.name = "v", .kind = MemoryKind::image3d, .format = Format::r32ui, .extent = extent});
    };
    const auto a = make({6, 5, 4}), b = make({4, 4, 4});
    const auto values = counting(6 * 5 * 4, 0);
    const auto f = buffer(device, "f", 480), g = buffer(device, "g", 480);
    device.commands().upload(f, 0, bytes_of(values));
    const glift::ImageRegion whole = {.extent = {6, 5, 4}};
    device.commands().copy_to_image(f, a, {&whole, 1});
    const glift::ImageCopyRegion box = {.from = {2, 1, 1}, .to = {1, 0, 2}, .extent = {3, 2, 2}};
    device.commands().copy_images(a, b, {&box, 1});
    const glift::ImageRegion part = {.offset = 16, .origin = {1, 0, 2}, .extent = {3, 2, 2}};
    device.commands().copy_from_image(b, g, {&part, 1});
    const auto result = read<std::uint32_t>(device, g, 16);
    for (std::uint32_t z = 0; z < 2; ++z) {
        for (std::uint32_t y = 0; y < 2; ++y) {
            for (std::uint32_t x = 0; x < 3; ++x) {
                EXPECT_EQ(result[4 + (z * 2 + y) * 3 + x], ((z + 1) * 5 + y + 1) * 6 + x + 2);
            }
        }
    }
}

TEST_P(Memories, AreFreedWhenTheLastHandleIsGone) {
    const auto f = buffer(device, "f", 1024);
    device.wait();
    const auto before = device.statistics();
    for (int round = 0; round < 20; ++round) {
        const auto g = buffer(device, "g", 8 << 20);
        run_store(device, g, 1024, 5);
        device.wait();
    }
    buffer(device, "h", 16);
    device.wait();
    buffer(device, "h", 16);  // an allocation reclaims memory that the device has finished using
    const auto after = device.statistics();
    EXPECT_LE(after.memories, before.memories + 2);
    EXPECT_LE(after.bytes_used, before.bytes_used + (9 << 20));
    EXPECT_LE(after.bytes_reserved, before.bytes_reserved + (100 << 20));
}

/// A pipeline's temporary, which each call makes anew: the device keeps its block, and puts nothing small there.
TEST_P(Memories, OfLargeTemporariesAreKeptForTheNextOnes) {
    const std::uint64_t large = std::uint64_t{300} << 20;
    const auto make_and_drop = [&] {
        const auto f = buffer(device, "f", large);
        device.wait();
    };
    make_and_drop();
    const auto small = buffer(device, "g", 1024);  // an allocation reclaims memory that the device has finished using
    const auto first = device.statistics();
    const glift::DeviceProperties& properties = device.properties();
    if (properties.kind != glift::DeviceKind::host && properties.memory_bytes / 32 >= large) {
        EXPECT_GE(first.bytes_reserved, large);
    }
    for (int round = 0; round < 3; ++round) {
        make_and_drop();
        buffer(device, "h", 16);
    }
    const auto after = device.statistics();
    EXPECT_EQ(after.bytes_reserved, first.bytes_reserved);
    EXPECT_LT(after.bytes_used, large);
}

TEST_P(Memories, HandlesMayGoBeforeTheDeviceIsDone) {
    glift::Download download;
    {
        const auto f = buffer(device, "f", 4 << 20), g = buffer(device, "g", 4 << 20);
        const std::vector<float> values(1 << 20, 2.0f);
        device.commands().upload(f, 0, bytes_of(values));
        run_scale(device, f, g, 1 << 20, 3.0f);
        download = device.commands().download(g, 0, 4 << 20);
    }
    const auto other = buffer(device, "other", 4 << 20);
    device.commands().fill(other, 0, 4 << 20, 9);
    for (const float value : values_of<float>(download.get())) ASSERT_EQ(value, 6.0f);
}

// Larger than lavapipe's maxStorageBufferRange, so that kernels access it by address, in the general form.
TEST_P(Memories, LargeOnesGoThroughAddresses) {
    constexpr std::uint32_t n = 40'000'000;
    const auto f = buffer(device, "f", 4ull * n), g = buffer(device, "g", 4ull * n);
    device.commands().fill(f, 0, 4ull * n, 0x3F800000);  // 1.0f
    const float last = 5.0f;
    device.commands().upload(f, 4ull * (n - 1), bytes_of(last));
    run_scale(device, f, g, n, 2.0f);
    const auto tail = values_of<float>(device.commands().download(g, 4ull * (n - 100), 400).get());
    for (int i = 0; i < 99; ++i) ASSERT_EQ(tail[i], 2.0f);
    EXPECT_EQ(tail[99], 10.0f);
}

// Two memories of 1.25 GiB: written from the host, computed on, and read back completely.
TEST_P(Memories, OverAGibibyte) {
    constexpr std::uint32_t n = 335'544'320, part = 16'777'216;
    const auto f = buffer(device, "f", 4ull * n), g = buffer(device, "g", 4ull * n);
    const auto at = [](std::uint32_t i) { return static_cast<float>(i % 1'000'003); };
    {
        std::vector<float> values(n);
        for (std::uint32_t i = 0; i < n; ++i) values[i] = at(i);
        device.commands().upload(f, 0, bytes_of(values));
    }
    run_scale(device, f, g, n, 2.0f);
    for (std::uint32_t first = 0; first < n; first += part) {
        const auto download = device.commands().download(g, 4ull * first, 4ull * part);
        const auto* values = reinterpret_cast<const float*>(download.get().data());
        for (std::uint32_t i = 0; i < part; ++i) ASSERT_EQ(values[i], 2.0f * at(first + i)) << first + i;
    }
}

TEST_P(Memories, TimestampsTellHowLong) {
    const auto f = buffer(device, "f", 4 << 20), g = buffer(device, "g", 4 << 20);
    const auto begin = device.commands().timestamp();
    run_scale(device, f, g, 1 << 20, 1.0f);
    const auto end = device.commands().timestamp();
    EXPECT_GT(end - begin, 0.0);
    EXPECT_LT(end - begin, 10.0);
}

}  // namespace
