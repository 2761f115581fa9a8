// Devices whose subgroups may have several sizes: kernels that use subgroups require the size that the host goes by.
#include "plain_vulkan.h"

namespace {

using namespace kernels;

glift::Device adopt_pretending(const PlainVulkan& mine) {
    auto objects = mine.objects();
    objects.get_instance_proc_addr = pretending_loader;
    return glift::vulkan::adopt(objects);
}

TEST(SubgroupSizes, KernelsWithSubgroupsRequireTheSize) {
    const PlainVulkan mine;
    pretence.sizes_vary = true;
    const auto device = adopt_pretending(mine);
    const std::uint32_t size = device.properties().subgroup_size;
    const auto g = buffer(device, "g.data", 256);
    run_lanes(device, g, 64);
    EXPECT_EQ(pretence.required_size, size);
    EXPECT_EQ(pretence.stage_flags, VkFlags(VK_PIPELINE_SHADER_STAGE_CREATE_REQUIRE_FULL_SUBGROUPS_BIT));
    EXPECT_EQ(read<std::uint32_t>(device, g, 64)[63], size - 1);
    run_store(device, g, 64, 5);
    EXPECT_EQ(pretence.required_size, 0u) << "a kernel without subgroups";
    EXPECT_EQ(pretence.stage_flags, 0u);
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

TEST(SubgroupSizes, OneSizeNeedsNoRequirement) {
    const PlainVulkan mine;
    const auto device = adopt_pretending(mine);
    run_lanes(device, buffer(device, "g.data", 256), 64);
    EXPECT_EQ(pretence.required_size, 0u);
}

// Then nothing says which size subgroups have: pipelines that ask `device` choose kernels without subgroups.
TEST(SubgroupSizes, WithoutRequirementsThereAreNoSubgroups) {
    const PlainVulkan mine;
    pretence.sizes_vary = pretence.no_required_size = true;
    const auto device = adopt_pretending(mine);
    EXPECT_EQ(device.properties().subgroup_size, 1u);
    EXPECT_FALSE(device.properties().subgroup_arithmetic);
    const auto g = buffer(device, "g.data", 256);
    const auto error = error_of([&] { run_lanes(device, g, 64); });
    EXPECT_EQ(error.code(), glift::ErrorCode::missing_feature);
    EXPECT_NE(error.where().find("number_lanes"), std::string::npos) << error.what();
    run_store(device, g, 64, 5);
    EXPECT_EQ(read<std::uint32_t>(device, g, 64)[63], 5u);
}

TEST(SubgroupSizes, MoreSubgroupsThanAWorkgroupMayHave) {
    const PlainVulkan mine;
    pretence.sizes_vary = true;
    pretence.most_subgroups = 1;
    const auto device = adopt_pretending(mine);
    const auto g = buffer(device, "g.data", 256);
    const auto error = error_of([&] { run_lanes(device, g, 64); });
    EXPECT_EQ(error.code(), glift::ErrorCode::too_large);
    EXPECT_NE(error.why().find("1 subgroups"), std::string::npos) << error.what();
}

}  // namespace
