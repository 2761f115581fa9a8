// Uses a struct that is declared in a C++ header of the program.
#include "voxels.glift.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

TEST(Voxels, are_of_the_struct_in_the_header) {
    const glift::Device device = glift::Device::open("host");
    voxels::Voxels all(device, 2);
    all.write(std::vector<Voxel>{{1.0f, 4}, {2.0f, 9}});
    voxels::age(device, all);
    EXPECT_EQ(all.read()[1].age, 10u);
}

}  // namespace
