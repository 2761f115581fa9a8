// Names and labels for debuggers: what reaches Vulkan's functions of VK_EXT_debug_utils.
#include "plain_vulkan.h"

namespace {

using namespace kernels;

using Lines = std::vector<std::string>;

/// A device over a program's Vulkan, whose loader notes labels and names, and says how many tools look at it.
glift::Device adopted(const PlainVulkan& mine, std::uint32_t tools) {
    pretence.tools = tools;
    pretence.notes_labels = true;
    auto objects = mine.objects();
    objects.get_instance_proc_addr = pretending_loader;
    return glift::vulkan::adopt(objects);
}

TEST(Labels, EnclosePassesAndPipelines) {
    const PlainVulkan mine;
    const auto device = adopted(mine, 1);
    const auto g = buffer(device, "g.data", 256);
    device.wait();
    pretence.labels.clear();
    {
        const glift::PipelineMark outer("outer", "a.glift:1");
        run_add(device, g, 64, 1);
        for (int k = 0; k < 2; ++k) {
            const glift::PipelineMark inner("inner", "a.glift:9");
            run_store(device, g, 64, 1);
        }
    }
    device.commands().fill(g, 0, 256, 1);
    device.wait();
    const Lines expected = {"begin outer", std::string("begin ") + add_in_place.name,
                            "end",  // outer stays open
                            "begin inner", std::string("begin ") + store_value.name,
                            "end",         "end",
                            "begin inner", std::string("begin ") + store_value.name,
                            "end",         "end",
                            "end",         "begin fill",
                            "end"};
    EXPECT_EQ(pretence.labels, expected);
}

TEST(Labels, EndWithTheCommandBuffer) {
    const PlainVulkan mine;
    const auto device = adopted(mine, 1);
    const auto g = buffer(device, "g.data", 256);
    device.wait();
    pretence.labels.clear();
    const glift::PipelineMark outer("outer", "a.glift:1");
    run_add(device, g, 64, 1);
    device.wait();
    const auto recording = device.record([&](const glift::Commands& commands) { run_add(commands, g, 64, 1); });
    const Lines once = {"begin outer", std::string("begin ") + add_in_place.name, "end", "end"};
    Lines twice = once;
    twice.insert(twice.end(), once.begin(), once.end());
    EXPECT_EQ(pretence.labels, twice);
}

TEST(Labels, LeaveTheUsersCommandBufferAsItWas) {
    const PlainVulkan mine;
    const auto device = adopted(mine, 1);
    const auto g = buffer(device, "g.data", 256);
    device.wait();
    const glift::PipelineMark outer("outer", "a.glift:1");
    const VkCommandBuffer own = mine.begin();
    const auto commands = glift::vulkan::record_into(device, own);
    pretence.labels.clear();
    run_add(commands, g, 64, 1);
    EXPECT_EQ(std::ranges::count(pretence.labels, "end"), std::ssize(pretence.labels) / 2);
    glift::vulkan::finish(commands);
    mine.run(own);
}

TEST(Labels, AreLeftOutWhereNoToolLooks) {
    const PlainVulkan mine;
    const auto device = adopted(mine, 0);
    const auto g = buffer(device, "g.data", 256);
    run_add(device, g, 64, 1);
    device.wait();
    EXPECT_EQ(pretence.labels, Lines());
}

TEST(Names, AreThoseOfMemoriesAndKernels) {
    const PlainVulkan mine;
    const auto device = adopted(mine, 0);
    const auto g = buffer(device, "grid.pages.data", 256);
    run_add(device, g, 64, 1);
    device.wait();
    for (const char* name : {"grid.pages.data", add_in_place.name})
        EXPECT_EQ(std::ranges::count(pretence.names, name), 1) << name;
}

// The validation layer is such a tool.
TEST(Labels, AreWrittenUnderTheValidationLayer) {
    const char* wanted = std::getenv("GLIFT_VALIDATE");
    if (wanted == nullptr || std::string(wanted) != "1") GTEST_SKIP() << "without the validation layer";
    const PlainVulkan mine;
    const auto device = glift::vulkan::adopt(mine.objects());
    EXPECT_GE(glift::detail::mark_users.load(), 1u) << "the device wants marks";
    const auto g = buffer(device, "g.data", 256);
    {
        const glift::PipelineMark outer("outer", "a.glift:1");
        run_add(device, g, 64, 1);
    }
    run_add(device, g, 64, 1);
    device.wait();
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

}  // namespace
