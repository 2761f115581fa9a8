#include "run_example.h"

#include "examples/common/npy.h"
#include "examples/common/png.h"

#include <gmock/gmock.h>

#include <numeric>

namespace {

using testing::HasSubstr;
using testing::Not;

struct Heat : testing::Test {
    glift::test::TemporaryFolder folder;
    std::string file(const std::string& name) const { return folder.path() / name; }
};

/// Computes the scheme of heat.glift in double precision.
std::vector<double> diffused(const npy::Array& volume, int steps) {
    const int n[3] = {int(volume.extent[0]), int(volume.extent[1]), int(volume.extent[2])};
    std::vector<double> u(volume.values.begin(), volume.values.end());
    for (int step = 0; step < steps; ++step) {
        std::vector<double> v(u.size());
        const auto at = [&](int x, int y, int z) {
            const auto inside = [](int i, int length) { return std::clamp(i, 0, length - 1); };
            return u[(std::size_t(inside(z, n[2])) * n[1] + inside(y, n[1])) * n[0] + inside(x, n[0])];
        };
        for (int z = 0, i = 0; z < n[2]; ++z)
            for (int y = 0; y < n[1]; ++y)
                for (int x = 0; x < n[0]; ++x, ++i) {
                    const double around = at(x - 1, y, z) + at(x + 1, y, z) + at(x, y - 1, z) + at(x, y + 1, z) +
                                          at(x, y, z - 1) + at(x, y, z + 1);
                    v[i] = u[i] + 0.125 * (around - 6 * u[i]);
                }
        u = std::move(v);
    }
    return u;
}

TEST_F(Heat, DiffusesAVolumeAlikeOnBothDevices) {
    npy::Array volume{{7, 5, 6}, std::vector<float>(7 * 5 * 6)};
    for (std::size_t i = 0; i < volume.values.size(); ++i) volume.values[i] = float(i * 37 % 101) - 20.0f;
    npy::write(file("in.npy"), volume);
    for (const int steps : {1, 8}) {
        const auto result = run_example(GLIFT_HEAT, {file("in.npy"), "--steps", std::to_string(steps), "--out",
                                                     file("pictures"), "--save", file("out.npy")});
        ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
        EXPECT_THAT(result.out, HasSubstr("7 x 5 x 6 voxels"));
        EXPECT_THAT(result.out, HasSubstr("llvmpipe"));
        EXPECT_THAT(result.out, HasSubstr("agree bit for bit"));
        const npy::Array out = npy::read(file("out.npy"));
        EXPECT_EQ(out.extent, volume.extent);
        const auto expected = diffused(volume, steps);
        for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_NEAR(out.values[i], expected[i], 1e-4) << i;
        const double before = std::accumulate(volume.values.begin(), volume.values.end(), 0.0);
        EXPECT_NEAR(std::accumulate(out.values.begin(), out.values.end(), 0.0), before, 1e-3);
    }
    // In the left part of the picture is the middle slice across z.
    const png::Picture picture = png::read(file("pictures/before.png"));
    const auto [low, high] = std::minmax_element(volume.values.begin(), volume.values.end());
    const std::uint32_t zoom = picture.height / 6;
    for (std::uint32_t y = 0; y < 5; ++y)
        for (std::uint32_t x = 0; x < 7; ++x)
            ASSERT_NEAR(picture.values[y * zoom * picture.width + x * zoom],
                        (volume.values[(3 * 5 + y) * 7 + x] - *low) / (*high - *low), 1.0 / 255);
    EXPECT_TRUE(std::filesystem::exists(file("pictures/after.png")));
}

TEST_F(Heat, WithoutVulkanItSaysSoAndGoesOn) {
    const auto result = run_example(GLIFT_HEAT, {"--steps", "2", "--out", file("pictures")},
                                    {"GLIFT_VULKAN_LOADER=/no/such/libvulkan.so"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("No Vulkan device"));
    EXPECT_THAT(result.out, HasSubstr("remedy"));
    EXPECT_THAT(result.out, HasSubstr("generated, 96 x 96 x 96"));
    EXPECT_THAT(result.out, HasSubstr("host"));
    EXPECT_THAT(result.out, Not(HasSubstr("agree")));
}

TEST_F(Heat, RefusesWhatItCannotUse) {
    npy::write(file("flat.npy"), {{4, 4}, std::vector<float>(16)});
    const auto flat = run_example(GLIFT_HEAT, {file("flat.npy")});
    EXPECT_EQ(flat.exit_code, 1);
    EXPECT_THAT(flat.err, HasSubstr("has 2 axes, a volume has 3"));
    EXPECT_THAT(run_example(GLIFT_HEAT, {file("missing.npy")}).err, HasSubstr("No such file"));
    EXPECT_EQ(run_example(GLIFT_HEAT, {"--steps", "many"}).exit_code, 2);
    EXPECT_EQ(run_example(GLIFT_HEAT, {"--colour"}).exit_code, 2);
}

}  // namespace
