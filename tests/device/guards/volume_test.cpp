// A dense volume whose kernels compute addresses in 64 bits: written, computed on, summed, gathered, read back.
// GLIFT_TEST_GIB is its size in GiB, a power of two; without it the volume is small. GLIFT_GENERAL_FORM=1, which ctest
// sets (CMakeLists.txt), makes Vulkan devices run the kernels' general form, which has them, at any size.
#include "on_every_device.h"

#include "volume.glift.hpp"

#include <algorithm>
#include <cstdlib>
#include <thread>
#include <tuple>

namespace {

class Volume : public OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(Volume);

std::uint64_t gibibytes() {
    const char* text = std::getenv("GLIFT_TEST_GIB");
    return text ? std::strtoull(text, nullptr, 10) : 0;
}

/// The volume's sides: powers of two, as nearly equal as possible, for 2^28 elements for each GiB; or small odd
/// numbers.
glift::uint3 extent_of_volume() {
    if (gibibytes() == 0) return {67, 45, 33};
    glift::uint3 extent{1024, 512, 512};
    for (std::uint64_t doubled = 1, axis = 2; doubled < gibibytes(); doubled *= 2, axis = (axis + 2) % 3)
        extent[axis] *= 2;
    return extent;
}

std::uint64_t bytes_of(const glift::uint3& extent) { return 4 * (std::uint64_t{extent.x} * extent.y * extent.z); }

std::uint32_t mark(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return ((x * 2654435761u) ^ (y * 2246822519u) ^ (z * 3266489917u)) >> 22u;
}

/// The sum of 2 * mark + 1 over the volume, modulo 2^32.
std::uint32_t expected_sum(const glift::uint3& extent) {
    const unsigned count = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::uint32_t> sums(count);
    std::vector<std::thread> threads;
    for (unsigned part = 0; part < count; ++part)
        threads.emplace_back([&, part] {
            std::uint32_t sum = 0;
            for (std::uint32_t z = part; z < extent.z; z += count)
                for (std::uint32_t y = 0; y < extent.y; ++y)
                    for (std::uint32_t x = 0; x < extent.x; ++x) sum += 2 * mark(x, y, z) + 1;
            sums[part] = sum;
        });
    for (std::thread& thread : threads) thread.join();
    std::uint32_t total = 0;
    for (const std::uint32_t sum : sums) total += sum;
    return total;
}

/// The corners; and for each power of two from 1024 on, the element at that physical address and the one before it.
/// Each element once: they are written by `scatter`.
std::vector<glift::uint3> sites_of(const glift::uint3& extent) {
    std::vector<glift::uint3> sites;
    for (const std::uint32_t z : {0u, extent.z - 1})
        for (const std::uint32_t y : {0u, extent.y - 1})
            for (const std::uint32_t x : {0u, extent.x - 1}) sites.emplace_back(x, y, z);
    const std::uint64_t elements = bytes_of(extent) / 4;
    for (std::uint64_t power = 1024; power < elements; power *= 2)
        for (const std::uint64_t at : {power - 1, power})
            sites.emplace_back(static_cast<std::uint32_t>(at % extent.x),
                               static_cast<std::uint32_t>(at / extent.x % extent.y),
                               static_cast<std::uint32_t>(at / extent.x / extent.y));
    const auto key = [](const glift::uint3& site) { return std::tuple(site.z, site.y, site.x); };
    std::ranges::sort(sites, {}, key);
    const auto repeated = std::ranges::unique(sites, {}, key);
    sites.erase(repeated.begin(), repeated.end());
    return sites;
}

bool has_memory_for(const glift::Device& device, std::uint64_t bytes) {
    const std::uint64_t spare = std::uint64_t{1} << 30;
    return device.properties().memory_bytes > spare && bytes <= device.properties().memory_bytes - spare &&
           bytes <= device.properties().max_allocation_bytes;
}

TEST_P(Volume, IsWrittenComputedOnSummedAndReadBack) {
    const glift::uint3 extent = extent_of_volume();
    if (!has_memory_for(device, bytes_of(extent)))
        GTEST_SKIP() << device.properties().name << " has no room for " << bytes_of(extent) << " bytes";
    volume::Volume volume(device, extent);
    EXPECT_EQ(volume.data_extent(), bytes_of(extent) / 4);
    volume::number(device, volume);
    volume::twice(device, volume);
    volume::Counts wrong(device, 1);
    volume::count_wrong(device, volume, volume, wrong);
    EXPECT_EQ(wrong.read()[0], 0u);
    const volume::Plane plane(device, {extent.x, extent.y});
    const volume::Counts line(device, extent.y);
    EXPECT_EQ(volume::sum_of(device, volume, plane, line).await(device), expected_sum(extent));
    for (const glift::uint3& at : sites_of(extent))
        ASSERT_EQ(volume.read(at, {1, 1, 1})[0], static_cast<float>(2 * mark(at.x, at.y, at.z) + 1))
            << at.x << " " << at.y << " " << at.z;
}

TEST_P(Volume, IsGatheredFromAndScatteredTo) {
    const glift::uint3 extent = extent_of_volume();
    if (!has_memory_for(device, bytes_of(extent)))
        GTEST_SKIP() << device.properties().name << " has no room for " << bytes_of(extent) << " bytes";
    volume::Volume volume(device, extent);
    volume.fill(3.0f);
    const std::vector<glift::uint3> at = sites_of(extent);
    const auto count = static_cast<std::uint32_t>(at.size());
    volume::Sites sites(device, count);
    sites.write(at);
    std::vector<float> numbers(count);
    for (std::uint32_t i = 0; i < count; ++i) numbers[i] = static_cast<float>(mark(at[i].x, at[i].y, at[i].z));
    volume::Line values(device, count), gathered(device, count);
    values.write(numbers);
    volume::scatter(device, sites, values, volume);
    volume::gather(device, sites, volume, gathered);
    EXPECT_EQ(gathered.read(), numbers);
    for (std::uint32_t i = 0; i < count; ++i) EXPECT_EQ(volume.read(at[i], {1, 1, 1})[0], numbers[i]) << i;
    EXPECT_EQ(volume.read({1, 1, 1}, {2, 1, 1}), (std::vector<float>{3.0f, 3.0f}));
}

// With GLIFT_TEST_GIB=8 the line has 2^31 elements, more than a signed 32-bit number can hold.
TEST_P(Volume, AsALineIsReducedByTheLibrary) {
    const std::uint64_t elements = std::min<std::uint64_t>(bytes_of(extent_of_volume()) / 4, std::uint64_t{1} << 31);
    if (!has_memory_for(device, 4 * elements))
        GTEST_SKIP() << device.properties().name << " has no room for " << 4 * elements << " bytes";
    volume::Line line(device, static_cast<std::uint32_t>(elements));
    double sum = 0;
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(elements, 64); ++i) sum += static_cast<double>(i);
    sum *= static_cast<double>(elements / 64);
    for (std::uint64_t i = 0; i < elements % 64; ++i) sum += static_cast<double>(i);
    EXPECT_NEAR(volume::sum_of_line(device, line).await(device), sum, 1e-4 * sum);
    const auto last = static_cast<std::uint32_t>(elements - 1);
    EXPECT_EQ(line.read({last}, {1})[0], static_cast<float>(last % 64));
}

}  // namespace
