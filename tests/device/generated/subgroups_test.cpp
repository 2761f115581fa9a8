// Kernels that use features that the device lacks are refused with an error that names them; others run.
#include "plain_vulkan.h"
#include "subgroups.glift.hpp"

#include <gmock/gmock.h>

namespace {

using testing::HasSubstr;

void expect_refused(const std::function<void()>& call, const char* kernel, const char* missing) {
    try {
        call();
        ADD_FAILURE() << kernel << " runs without " << missing;
    } catch (const glift::Error& error) {
        EXPECT_EQ(error.code(), glift::ErrorCode::missing_feature);
        EXPECT_THAT(error.what(), HasSubstr(kernel));
        EXPECT_THAT(error.what(), HasSubstr(missing));
    }
}

TEST(Subgroups, WhatTheDeviceLacksIsNamed) {
    const PlainVulkan mine;
    auto objects = mine.objects();
    objects.get_instance_proc_addr = pretending_loader;
    pretence.no_shuffles = true;
    const auto device = glift::vulkan::adopt(objects);
    subgroups::Line line(device, 64);
    expect_refused([&] { subgroups::swap_neighbours(device, line); }, "swap_neighbours", "subgroup shuffles");
    expect_refused([&] { subgroups::shift(device, line); }, "shift", "relative subgroup shuffles");
    expect_refused([&] { subgroups::sum_wide(device, line); }, "sum_wide",
                   "subgroup operations on 16-bit and 64-bit types");
    line.fill(1);
    subgroups::sum(device, line);
    EXPECT_EQ(line.read()[0], device.properties().subgroup_size);
}

TEST(Subgroups, WhatTheDeviceHasRuns) {
    for (const char* name : {"host", "lavapipe"}) {
        const auto device = glift::Device::open(name);
        const glift::uint size = device.properties().subgroup_size;
        subgroups::Line line(device, 64);
        line.fill(6);
        subgroups::swap_neighbours(device, line);
        subgroups::shift(device, line);
        if (device.properties().subgroup_extended_types) subgroups::sum_wide(device, line);
        EXPECT_EQ(line.read(),
                  std::vector<glift::uint>(64, device.properties().subgroup_extended_types ? 3 * size : 6));
    }
}

}  // namespace
