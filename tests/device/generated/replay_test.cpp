// Generated pipelines, recorded once and replayed: each replay is one submission, and its temporaries start as zeros.
#include "chain.glift.hpp"
#include "plain_vulkan.h"

namespace {

constexpr glift::uint passes = 1000;

TEST(GeneratedPipeline, AThousandPassesReplayWithOneSubmission) {
    const PlainVulkan mine;
    auto objects = mine.objects();
    objects.get_instance_proc_addr = pretending_loader;
    const auto device = glift::vulkan::adopt(objects);
    chain::Line f(device, 100), g(device, 100);
    const auto recording =
        device.record([&](const glift::Commands& commands) { chain::chain(commands, f, g, passes / 2); });
    device.wait();  // until f and g are initialised

    glift::uint expected = 0;
    for (int replay = 0; replay < 3; ++replay) {
        const auto submissions = pretence.submissions, command_buffers = pretence.command_buffers;
        const auto before = device.statistics();
        recording.submit();
        EXPECT_EQ(pretence.submissions - submissions, 1u);
        EXPECT_EQ(pretence.command_buffers - command_buffers, 1u);
        EXPECT_EQ(device.statistics().submissions - before.submissions, 1u);
        EXPECT_EQ(device.statistics().passes - before.passes, passes);
        for (glift::uint k = 0; k < passes; ++k) expected = 2 * expected + k;
    }
    EXPECT_EQ(f.read(), std::vector<glift::uint>(100, expected));
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

TEST(GeneratedPipeline, TemporariesAreZerosAtEachReplay) {
    for (const char* name : {"host", "lavapipe"}) {
        const auto device = glift::Device::open(name);
        chain::Line f(device, 10), g(device, 10);
        f.fill(5);
        const auto recording =
            device.record([&](const glift::Commands& commands) { chain::count_in_temporaries(commands, f, g); });
        for (int replay = 0; replay < 3; ++replay) {
            recording.submit();
            EXPECT_EQ(g.read(), std::vector<glift::uint>(10, 57)) << name << ", replay " << replay;
        }
        for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
    }
}

}  // namespace
