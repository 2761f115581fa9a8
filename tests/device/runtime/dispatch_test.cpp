// Passes: forms of kernels, grids that are folded or split, parameters from the device or fixed, and images.
#include "test_device.h"

#include <numeric>

namespace {

using namespace kernels;

class Dispatch : public OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(Dispatch);

std::vector<float> ramp(std::size_t count) {
    std::vector<float> values(count);
    std::iota(values.begin(), values.end(), 0.0f);
    return values;
}

void expect_scaled(const std::vector<float>& values, float factor) {
    for (std::size_t i = 0; i < values.size(); ++i) ASSERT_EQ(values[i], factor * static_cast<float>(i)) << i;
}

TEST_P(Dispatch, DirectFormComputes) {
    constexpr std::uint32_t n = 1000;
    const auto f = buffer(device, "f.data", 4 * n), g = buffer(device, "g.data", 4 * n);
    device.commands().upload(f, 0, bytes_of(ramp(n)));
    run_scale(device, f, g, n, 3.0f);
    expect_scaled(read<float>(device, g, n), 3.0f);
}

TEST_P(Dispatch, GeneralFormComputesTheSame) {
    constexpr std::uint32_t n = 1000;
    const glift::Memory memories[] = {buffer(device, "f.data", 4 * n), buffer(device, "g.data", 4 * n)};
    device.commands().upload(memories[0], 0, bytes_of(ramp(n)));
    const ScaleParameters block = {n, 2.0f};
    device.commands().dispatch(
        scale,
        {.form = glift::FormName::general, .memories = memories, .parameters = bytes_of(block), .size = {n, 1, 1, 1}});
    expect_scaled(read<float>(device, memories[1], n), 2.0f);
}

TEST_P(Dispatch, NothingRunsOverNothing) {
    const auto f = buffer(device, "f.data", 0), g = buffer(device, "g.data", 0);
    run_scale(device, f, g, 0, 3.0f);
    device.commands().upload(f, 0, {});
    EXPECT_TRUE(device.commands().download(g, 0, 0).get().empty());
}

// More workgroups than lavapipe allows along x: the grid is folded into y.
TEST_P(Dispatch, LongIterationsFold) {
    constexpr std::uint32_t n = 5'000'001;
    const auto f = buffer(device, "f.data", 4ull * n), g = buffer(device, "g.data", 4ull * n);
    device.commands().upload(f, 0, bytes_of(ramp(n)));
    run_scale(device, f, g, n, 1.0f);
    expect_scaled(read<float>(device, g, n), 1.0f);
}

TEST_P(Dispatch, TallIterationsSplit) {
    const std::array<std::uint32_t, 4> size = {1, 70000, 2, 1};
    const auto g = buffer(device, "g.data", 4 * 140000);
    const std::uint32_t block[8] = {size[0], size[1],
                                    size[2]};  // then the base and the address, which the runtime fills in
    const std::span<const std::byte> bytes = bytes_of(block);
    const glift::Commands commands = device;
    const bool is_direct = commands.can_be_direct(mark_grid, {&g, 1}, size);
    EXPECT_EQ(is_direct, device.is_host());
    commands.dispatch(mark_grid, {.form = is_direct ? glift::FormName::direct : glift::FormName::general,
                                  .memories = {&g, 1},
                                  .parameters = is_direct ? bytes.first(24) : bytes,
                                  .size = size});
    const auto visits = read<std::uint32_t>(device, g, 140000);
    for (std::uint32_t i = 0; i < 140000; ++i) ASSERT_EQ(visits[i], 1 + i % 70000) << i;
}

// Size and factor come from values on the device; elements beyond the size stay as they were.
TEST_P(Dispatch, DeviceValuesSetSizeAndParameters) {
    constexpr std::uint32_t n = 1000;
    for (const std::uint32_t wanted : {0u, 1u, 64u, 777u, 1000u, 5000u}) {
        const glift::Memory memories[] = {buffer(device, "f.data", 4 * n), buffer(device, "g.data", 4 * n)};
        const auto values = buffer(device, "counts.data", 16);
        device.commands().upload(memories[0], 0, bytes_of(ramp(n)));
        run_store(device, values, 2, wanted);
        const float factor = 5.0f;
        device.commands().upload(values, 8, bytes_of(factor));
        const ScaleParameters block = {n, 0.0f};
        const glift::Patch patches[] = {{{values, 4}, 0}, {{values, 8}, 4}};
        device.commands().dispatch(scale, {.form = glift::FormName::general,
                                           .memories = memories,
                                           .parameters = bytes_of(block),
                                           .size = {n, 1, 1, 1},
                                           .patches = patches});
        const auto result = read<float>(device, memories[1], n);
        for (std::uint32_t i = 0; i < n; ++i) {
            ASSERT_EQ(result[i], i < wanted ? factor * static_cast<float>(i) : 0.0f) << wanted << " " << i;
        }
    }
}

TEST_P(Dispatch, DeviceSizesFoldToo) {
    constexpr std::uint32_t n = 4'500'000;
    const glift::Memory memories[] = {buffer(device, "f.data", 4ull * n), buffer(device, "g.data", 4ull * n)};
    const auto count = buffer(device, "count.data", 4);
    device.commands().upload(memories[0], 0, bytes_of(ramp(n)));
    run_store(device, count, 1, n - 7);
    const ScaleParameters block = {n, 1.0f};
    const glift::Patch patch = {{count, 0}, 0};
    device.commands().dispatch(scale, {.form = glift::FormName::general,
                                       .memories = memories,
                                       .parameters = bytes_of(block),
                                       .size = {n, 1, 1, 1},
                                       .patches = {&patch, 1}});
    const auto result = read<float>(device, memories[1], n);
    for (std::uint32_t i = 0; i < n; ++i) ASSERT_EQ(result[i], i < n - 7 ? static_cast<float>(i) : 0.0f) << i;
}

// Each pass sees what the one before it wrote to the same memory. On a GPU the result would show a missing barrier.
TEST_P(Dispatch, PassesOverOneMemoryHappenInOrder) {
    constexpr std::uint32_t n = 4096;
    const auto g = buffer(device, "g.data", 4 * n);
    std::uint32_t expected = 0;
    for (std::uint32_t k = 0; k < 40; ++k) {
        run_add(device, g, n, k);
        expected = expected * 2 + k;
    }
    for (const std::uint32_t value : read<std::uint32_t>(device, g, n)) ASSERT_EQ(value, expected);
}

// On Vulkan each set of fixed values makes one pipeline, and a fixed value is not read from the parameter block.
TEST_P(Dispatch, FixedParametersAreConstantsOfThePipeline) {
    const auto g = buffer(device, "g.data", 64);
    for (const std::uint32_t value : {1u, 2u, 1u}) {
        const AddParameters block = {16, 100};
        const glift::FixedWord fixed = {offsetof(AddParameters, amount), 100 + value};
        device.commands().dispatch(store_value, {.form = glift::FormName::direct,
                                                 .memories = {&g, 1},
                                                 .parameters = bytes_of(block),
                                                 .size = {16, 1, 1, 1},
                                                 .fixed = {&fixed, 1}});
        EXPECT_EQ(read<std::uint32_t>(device, g, 16)[3], device.is_host() ? 100u : 100u + value);
    }
    run_store(device, g, 16, 100);
    EXPECT_EQ(read<std::uint32_t>(device, g, 16)[3], 100u);
    if (!device.is_host()) {
        EXPECT_EQ(device.statistics().pipelines, 3u);
    }
}

TEST_P(Dispatch, ImagesAreSampledAndStored) {
    constexpr std::uint32_t width = 13, height = 9;
    const glift::MemoryDescription description = {.name = "f.data",
                                                  .kind = glift::MemoryKind::image2d,
                                                  .format = glift::Format::r32f,
                                                  .extent = {width, height, 1}};
    const glift::Memory images[] = {device.allocate(description), device.allocate(description)};
    const auto values = ramp(width * height);
    const glift::ImageRegion all = {.extent = {width, height, 1}};
    device.commands().upload_image(images[0], {&all, 1}, bytes_of(values));
    const std::uint32_t block[2] = {width, height};
    device.commands().dispatch(image_step, {.form = glift::FormName::direct,
                                            .memories = images,
                                            .parameters = bytes_of(block),
                                            .size = {width, height, 1, 1}});
    const auto download = device.commands().download_image(images[1], {&all, 1}, 4 * width * height);
    const auto result = values_of<float>(download.get());
    for (std::uint32_t i = 0; i < width * height; ++i) {
        const float right = i % width + 1 < width ? 0.5f : 0.0f;
        ASSERT_NEAR(result[i], values[i] + right + 1.0f, 1e-3f) << i;
    }
}

// Simulates that a library with kernels is unloaded and another one is loaded at the same addresses.
TEST_P(Dispatch, KernelsAreKnownByWhatTheyHoldNotByTheirAddress) {
    const auto g = buffer(device, "g.data", 256);
    glift::Kernel kernel = store_value;
    const AddParameters block = {64, 5};
    const auto run = [&] {
        device.commands().dispatch(kernel, {.form = glift::FormName::direct,
                                            .memories = {&g, 1},
                                            .parameters = bytes_of(block),
                                            .size = {64, 1, 1, 1}});
    };
    run();
    const auto stored = read<std::uint32_t>(device, g, 64)[63];
    kernel = add_in_place;
    run();
    EXPECT_EQ(read<std::uint32_t>(device, g, 64)[63], 2 * stored + 5);
    const auto pipelines = device.statistics().pipelines;
    const glift::Kernel copy = kernel;
    device.commands().dispatch(
        copy,
        {.form = glift::FormName::direct, .memories = {&g, 1}, .parameters = bytes_of(block), .size = {64, 1, 1, 1}});
    EXPECT_EQ(device.statistics().pipelines, pipelines) << "the same kernel";
}

}  // namespace
