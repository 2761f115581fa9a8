// Glift's commands in a command buffer of the program's own.
#include "plain_vulkan.h"

#include "nothing.h"

namespace {

using namespace kernels;

void expect_no_messages(const glift::Device& device) {
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

/// A compute pipeline of the program's own, which does nothing.
class OwnPipeline {
public:
    explicit OwnPipeline(VkDevice device) : device_(device) {
        const VkPipelineLayoutCreateInfo layout = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
        EXPECT_EQ(vkCreatePipelineLayout(device, &layout, nullptr, &layout_), VK_SUCCESS);
        const VkShaderModuleCreateInfo code = {
            .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = sizeof nothing, .pCode = nothing};
        VkShaderModule module = VK_NULL_HANDLE;
        EXPECT_EQ(vkCreateShaderModule(device, &code, nullptr, &module), VK_SUCCESS);
        const VkComputePipelineCreateInfo info = {
            .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
            .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                      .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                      .module = module,
                      .pName = "main"},
            .layout = layout_};
        EXPECT_EQ(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_), VK_SUCCESS);
        vkDestroyShaderModule(device, module, nullptr);
    }
    ~OwnPipeline() {
        vkDestroyPipeline(device_, pipeline_, nullptr);
        vkDestroyPipelineLayout(device_, layout_, nullptr);
    }
    void run(VkCommandBuffer commands) const {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
        vkCmdDispatch(commands, 1, 1, 1);
    }

private:
    VkDevice device_;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

TEST(RecordInto, PassesGoIntoTheProgramsCommandBuffer) {
    const PlainVulkan mine;
    const auto device = glift::vulkan::adopt(mine.objects());
    const auto g = buffer(device, "g.data", 256), copy = buffer(device, "copy.data", 256);
    run_store(device, g, 64, 5);  // submitted before the program's own work
    const VkCommandBuffer commands = mine.begin();
    {
        const auto into = glift::vulkan::record_into(device, commands);
        run_add(into, g, 64, 1);
        run_add(into, g, 64, 2);
        glift::vulkan::finish(into);
        // A command of the program's own that reads what Glift wrote.
        const auto from = glift::vulkan::buffer(g), to = glift::vulkan::buffer(copy);
        const VkBufferCopy region = {from.offset, to.offset, 256};
        vkCmdCopyBuffer(commands, from.buffer, to.buffer, 1, &region);
        mine.run(commands);
    }
    EXPECT_EQ(read<std::uint32_t>(device, copy, 64)[63], (5u * 2 + 1) * 2 + 2);
    expect_no_messages(device);
}

TEST(RecordInto, CommandsOfTheProgramsMayComeBetween) {
    const PlainVulkan mine;
    const OwnPipeline own(mine.device);
    const auto device = glift::vulkan::adopt(mine.objects());
    const auto g = buffer(device, "g.data", 256);
    run_store(device, g, 64, 5);
    const VkCommandBuffer commands = mine.begin();
    const auto into = glift::vulkan::record_into(device, commands);
    run_add(into, g, 64, 1);
    own.run(commands);
    run_add(into, g, 64, 1);
    glift::vulkan::finish(into);
    mine.run(commands);
    EXPECT_EQ(read<std::uint32_t>(device, g, 64)[63], (5u * 2 + 1) * 2 + 1);
    expect_no_messages(device);
}

TEST(RecordInto, TemporariesShareStorageAndSubmitNothing) {
    constexpr std::uint64_t bytes = 1 << 20;
    const PlainVulkan mine;
    const auto device = glift::vulkan::adopt(mine.objects());
    const auto g = buffer(device, "g.data", 256);
    device.wait();
    const glift::Statistics before = device.statistics();
    const VkCommandBuffer commands = mine.begin();
    {
        const auto into = glift::vulkan::record_into(device, commands);
        for (std::uint32_t k = 0; k < 20; ++k) {
            const auto temporary = into.allocate({.name = "temporary", .bytes = bytes});
            run_add(into, temporary, 64, k);
            into.copy(temporary, 0, g, 0, 256);
        }
        EXPECT_LT(device.statistics().bytes_used - before.bytes_used, 2 * bytes);
        glift::vulkan::finish(into);
        EXPECT_EQ(device.statistics().submissions, before.submissions);
        mine.run(commands);
    }
    EXPECT_EQ(read<std::uint32_t>(device, g, 64)[63], 19u);
    expect_no_messages(device);
}

}  // namespace
