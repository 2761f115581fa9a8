#include "run_example.h"

#include "examples/common/npy.h"
#include "examples/common/png.h"

#include <gmock/gmock.h>

namespace {

using testing::HasSubstr;

struct Laplacian : testing::TestWithParam<const char*> {
    glift::test::TemporaryFolder folder;
    std::string file(const std::string& name) const { return folder.path() / name; }
    glift::test::ProcessResult run(const std::string& in, const std::string& out) {
        return run_example(GLIFT_LAPLACIAN, {file(in), file(out), "--device", GetParam()});
    }
};

// Whole numbers, so that the sums are exact in any order.
TEST_P(Laplacian, OfAnArrayWithFourAxes) {
    const int n[4] = {5, 4, 3, 2};
    npy::Array array{{5, 4, 3, 2}, std::vector<float>(120)};
    for (std::size_t i = 0; i < 120; ++i) array.values[i] = float(i * i % 71);
    npy::write(file("in.npy"), array);
    const auto result = run("in.npy", "out.npy");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const npy::Array out = npy::read(file("out.npy"));
    EXPECT_EQ(out.extent, array.extent);
    for (int i = 0; i < 120; ++i) {
        float expected = -8 * array.values[i];
        for (int axis = 0, stride = 1; axis < 4; stride *= n[axis++]) {
            const int place = i / stride % n[axis];
            if (place > 0) expected += array.values[i - stride];
            if (place + 1 < n[axis]) expected += array.values[i + stride];
        }
        ASSERT_EQ(out.values[i], expected) << i;
    }
}

TEST_P(Laplacian, OfAPicture) {
    png::Picture picture{9, 7, std::vector<float>(63, 0.0f)};
    picture.values[3 * 9 + 4] = 0.2f;
    png::write(file("in.png"), picture);
    const auto result = run("in.png", "out.png");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const png::Picture out = png::read(file("out.png"));
    ASSERT_EQ(out.width, 9u);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 9; ++x) {
            const int distance = std::abs(x - 4) + std::abs(y - 3);
            const float value = distance == 0 ? -0.8f : distance == 1 ? 0.2f : 0.0f;
            ASSERT_NEAR(out.values[y * 9 + x], 0.5f + 0.5f * value, 1.0 / 255) << x << ' ' << y;
        }
}

TEST_P(Laplacian, RefusesWhatItCannotUse) {
    npy::write(file("flat.npy"), {{4, 4}, std::vector<float>(16)});
    const auto flat = run("flat.npy", "out.npy");
    EXPECT_EQ(flat.exit_code, 1);
    EXPECT_THAT(flat.err, HasSubstr("has 2 axes; 4 are wanted"));
    EXPECT_EQ(run("in.txt", "out.txt").exit_code, 2);
    EXPECT_EQ(run("in.npy", "out.png").exit_code, 2);
    EXPECT_EQ(run_example(GLIFT_LAPLACIAN, {}).exit_code, 2);
}

INSTANTIATE_TEST_SUITE_P(Devices, Laplacian, testing::Values("host", "lavapipe"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
