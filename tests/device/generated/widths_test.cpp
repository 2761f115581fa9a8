// Rows of every width around the host device's block size, compared with plain loops.
#include "widths.glift.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace {

constexpr int height = 5;

using Read = std::function<float(int x, int y)>;

std::vector<float> values_of(int width) {
    std::vector<float> values(static_cast<std::size_t>(width * height));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i * 7 % 64);
    return values;
}

std::vector<float> each(int width, const Read& element) {
    std::vector<float> values;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) values.push_back(element(x, y));
    return values;
}

class Widths : public testing::TestWithParam<const char*> {
protected:
    glift::Device device = glift::Device::open(GetParam());
};
INSTANTIATE_TEST_SUITE_P(, Widths, testing::Values("host", "lavapipe"),
                         [](const testing::TestParamInfo<const char*>& which) { return which.param; });

TEST_P(Widths, NeighboursOutsideAreZero) {
    for (int width = 1; width <= 70; ++width) {
        const glift::uint2 extent(static_cast<glift::uint>(width), height);
        widths::Open f(device, extent), g(device, extent);
        const std::vector<float> values = values_of(width);
        f.write(values);
        widths::blur_open(device, f, g);
        const Read at = [&](int x, int y) {
            const bool inside = x >= 0 && x < width && y >= 0 && y < height;
            return inside ? values[static_cast<std::size_t>(y * width + x)] : 0.0f;
        };
        ASSERT_EQ(g.read(), each(width,
                                 [&](int x, int y) {
                                     return at(x, y) + 2 * at(x + 1, y) + 4 * at(x - 1, y) + 8 * at(x, y + 1) +
                                            16 * at(x, y - 1);
                                 }))
            << width;
    }
}

TEST_P(Widths, NeighboursOutsideAreTheNearestInside) {
    for (int width = 1; width <= 70; ++width) {
        const glift::uint2 extent(static_cast<glift::uint>(width), height);
        widths::Closed f(device, extent), g(device, extent);
        const std::vector<float> values = values_of(width);
        f.write(values);
        const Read at = [&](int x, int y) {
            return values[static_cast<std::size_t>(std::clamp(y, 0, height - 1) * width + std::clamp(x, 0, width - 1))];
        };
        widths::blur_closed(device, f, g);
        ASSERT_EQ(g.read(), each(width,
                                 [&](int x, int y) {
                                     return at(x, y) + 2 * at(x + 2, y) + 4 * at(x - 1, y) + 8 * at(x, y + 1) +
                                            16 * at(x, y - 1);
                                 }))
            << width;
        g.fill(1000.0f);
        widths::gain(device, f, g);
        ASSERT_EQ(g.read(), each(width, [&](int x, int y) { return 1000 + at(x + 1, y); })) << width;
    }
}

}  // namespace
