// A program passes structs without fields, alone and as fields of others.
#include "operators.glift.hpp"

#include <gtest/gtest.h>

namespace {

class Operators : public testing::TestWithParam<const char*> {
protected:
    glift::Device device = glift::Device::open(GetParam());
};
INSTANTIATE_TEST_SUITE_P(, Operators, testing::Values("host", "lavapipe"),
                         [](const testing::TestParamInfo<const char*>& which) { return which.param; });

TEST_P(Operators, TakeNoPlaceInParameters) {
    operators::Line line(device, 4);
    line.write(std::vector<glift::uint>{0, 3, 5, 9});
    operators::clamp_up(device, line, operators::Max{}, {.op = {}, .bound = 4});
    EXPECT_EQ(line.read(), (std::vector<glift::uint>{4, 4, 5, 9}));
    operators::clamp_twice(device, line, {}, {.op = {}, .bound = 6});
    EXPECT_EQ(line.read(), (std::vector<glift::uint>{7, 7, 7, 9}));
}

}  // namespace
