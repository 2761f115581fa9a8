// Structures larger than lavapipe's descriptors can cover: there kernels access them by device address, in their
// general form.
#include "on_every_device.h"

#include "large.glift.hpp"

namespace {

class Large : public OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(Large);

constexpr std::uint32_t count = 300'000'000;
constexpr std::uint32_t piece = 1000;

float mark(std::uint32_t address) { return static_cast<float>(address % 16777213u); }

/// First addresses of pieces in which a 32-bit byte count, a descriptor or a grid could overflow: both ends, and around
/// powers of two.
std::vector<std::uint32_t> origins() {
    std::vector<std::uint32_t> result{0, count - piece};
    for (const std::uint32_t power : {24u, 25u, 26u, 27u, 28u}) result.push_back((1u << power) - piece / 2);
    return result;
}

TEST_P(Large, AGibibyteIsWrittenComputedOnAndReadBack) {
    if (name() == "lavapipe") {
        ASSERT_LT(device.properties().max_storage_buffer_range, 4ull * count);  // the general form runs
    }
    large::Line line(device, count);
    EXPECT_EQ(line.read({count - 1}, {1})[0], 0.0f);
    large::number(device, line);
    large::halve(device, line);
    for (const std::uint32_t origin : origins()) {
        const std::vector<float> values = line.read({origin}, {piece});
        for (std::uint32_t i = 0; i < piece; ++i) ASSERT_EQ(values[i], 0.5f * mark(origin + i)) << origin + i;
    }

    // Elements that the host writes are where kernels read them, and nowhere else.
    for (const std::uint32_t origin : origins()) line.write({origin}, {1}, std::vector<float>{-1.0f});
    large::halve(device, line);
    for (const std::uint32_t origin : origins()) {
        const std::vector<float> values = line.read({origin}, {2});
        EXPECT_EQ(values[0], -0.5f) << origin;
        EXPECT_EQ(values[1], 0.25f * mark(origin + 1)) << origin;
    }
}

TEST_P(Large, AddressesFarApartAreGatheredAndScattered) {
    large::Line line(device, count);
    const std::vector<std::uint32_t> at = origins();
    const auto n = static_cast<std::uint32_t>(at.size());
    large::Places places(device, n);
    large::Line values(device, n), gathered(device, n);
    places.write(at);
    std::vector<float> numbers(n);
    for (std::uint32_t i = 0; i < n; ++i) numbers[i] = mark(at[i]) + 0.5f;
    values.write(numbers);
    large::scatter(device, places, values, line);
    large::gather(device, places, line, gathered);
    EXPECT_EQ(gathered.read(), numbers);
    for (std::uint32_t i = 0; i < n; ++i) EXPECT_EQ(line.read({at[i]}, {1})[0], numbers[i]);
    // Beyond the end writes are discarded and reads give zero.
    places.write(std::vector<std::uint32_t>(n, count));
    large::scatter(device, places, values, line);
    large::gather(device, places, line, gathered);
    EXPECT_THAT(gathered.read(), testing::Each(0.0f));
}

TEST_P(Large, SmallElementsInThreeDimensions) {
    const glift::uint3 extent{512, 512, 300};  // 150 MiB each
    large::Halves from(device, extent), to(device, extent);
    large::number_halves(device, from);
    large::slope(device, from, to);
    const auto value = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        if (x >= extent.x || y >= extent.y) return 0.0f;
        return static_cast<float>(x % 1024 + y % 32 + z % 8);
    };
    for (const std::uint32_t z : {0u, 255u, 256u, 299u}) {
        const auto row = to.read({0, 511, z}, {512, 1, 1});
        for (std::uint32_t x = 0; x < 512; ++x)
            ASSERT_EQ(static_cast<float>(row[x]), value(x + 1, 511, z) - value(x, 510, z)) << x << " " << z;
    }
}

}  // namespace
