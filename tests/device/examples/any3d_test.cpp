#include "run_example.h"

#include <gmock/gmock.h>

namespace {

struct Any3d : testing::TestWithParam<const char*> {};

// {51, 20, 7} / 255, of texels of 8 bits and of floats.
TEST_P(Any3d, EachStructureHasTheSameElements) {
    const auto result = run_example(GLIFT_ANY3D, {"--device", GetParam()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "image          0.2000 0.0784 0.0275   0.000000\n"
                          "dense array    0.2000 0.0784 0.0275   0.000000\n"
                          "sparse volume  0.2000 0.0784 0.0275   0.000000\n"
                          "octree         0.2000 0.0784 0.0275   0.000000\n"
                          "formula        0.2000 0.0784 0.0275   0.000000\n"
                          "layers         0.2000 0.0784 0.0275   0.000000\n");
}

TEST(OwnShader, AShaderOfTheProgramReadsTheOctree) {
    const auto result = run_example(GLIFT_ANY3D, {"--own-shader"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "octree, by octree.frag  0.2000 0.0784 0.0275\n");
}

INSTANTIATE_TEST_SUITE_P(Devices, Any3d, testing::Values("host", "lavapipe"));

}  // namespace
