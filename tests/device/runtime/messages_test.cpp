// Messages of kernels: their text, their order, what is lost, and assertions. The kernel is hand-written.
#include "plain_vulkan.h"

#include "print.h"

#include <glift/host/messages.h>

#include <tuple>

namespace {

using glift::Message;
using namespace kernels;

struct PrintParameters {
    std::uint32_t size, limit;
};

void host_print(const glift::HostCall& call) {
    const auto& p = *static_cast<const PrintParameters*>(call.parameters);
    auto* g = reinterpret_cast<std::uint32_t*>(call.memories[0].data);
    for (std::uint32_t i = p.size; i-- > 0; ++g[i]) {  // messages are sorted whatever the order of elements
        glift::host::print(call, 0, {i, g[i]});
        if (i >= p.limit)
            glift::host::print(
                call, 1,
                {i, 0u - i, 0x3dcccccdu, 0x3dccc000u, 0u, 0x3fe00000u, 0xfffffffeu, 0xffffffffu, 1u, 1u, 1u, 4u, 5u});
    }
}

const glift::Binding bindings[] = {{.name = "g.data", .access = glift::Access::read_write}};
const glift::MessageFormat formats[] = {
    {"g is {u}", "print.glift", 7},
    {"{i} {f} {h} {d} {I} {U} {b} {e 0=red 4=green} {e 0=red 4=green} {{}}", "other.glift", 9, true}};
const glift::Kernel print_kernel = {
    .name = "print",
    .file = "print.glift",
    .line = 5,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = bindings,
    .direct = {.spirv = ::print, .host = host_print, .parameter_bytes = 8, .push_constants = true},
    .general = {},
    .messages = formats,
    .address_rank = 1};

void run_print(const glift::Commands& commands, const glift::Memory& g, std::uint32_t size,
               std::uint32_t limit = UINT32_MAX) {
    const PrintParameters parameters = {size, limit};
    commands.dispatch(print_kernel, {glift::FormName::direct, std::span(&g, 1), bytes_of(parameters), {size, 1, 1, 1}});
}

class MessagesOfKernels : public OnEveryDevice {
protected:
    MessagesOfKernels() {
        device.on_message([this](const Message& message) { lines.push_back(to_text(message)); });
        device.wait();
    }
    /// What was printed since the last call.
    std::vector<std::string> waited() {
        device.wait();
        return std::exchange(lines, {});
    }

    std::vector<std::string> lines;
    glift::Memory g = buffer(device, "g.data", 4096 * 4);
};
GLIFT_ON_EVERY_DEVICE(MessagesOfKernels);

using Lines = std::vector<std::string>;

TEST_P(MessagesOfKernels, ComeInTheOrderOfPassesAndAddresses) {
    run_print(device, g, 2);
    run_print(device, g, 3);
    EXPECT_EQ(waited(),
              (Lines{"print.glift:7: at (0): g is 0", "print.glift:7: at (1): g is 0", "print.glift:7: at (0): g is 1",
                     "print.glift:7: at (1): g is 1", "print.glift:7: at (2): g is 0"}));
    EXPECT_TRUE(waited().empty());
    run_print(device, g, 4000);
    run_print(device, g, 4000);
    const Lines many = waited();
    ASSERT_EQ(many.size(), 8000u);
    for (std::size_t i = 3; i < 4000; ++i) {
        ASSERT_EQ(many[i], "print.glift:7: at (" + std::to_string(i) + "): g is 0");
        ASSERT_EQ(many[4000 + i], "print.glift:7: at (" + std::to_string(i) + "): g is 1");
    }
}

TEST_P(MessagesOfKernels, HaveScalarsOfEveryType) {
    run_print(device, g, 3, 2);
    EXPECT_THROW(device.wait(), glift::Error);
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_EQ(lines[2], "print.glift:7: at (2): g is 0");
    EXPECT_EQ(lines[3], "other.glift:9: at (2): assertion failed: "
                        "-2 0.1 0.1 0.5 -2 4294967297 true green 5 {}");
}

TEST_P(MessagesOfKernels, OfRecordingsComeWithEachReplay) {
    const auto recording = device.record([&](const glift::Commands& commands) { run_print(commands, g, 1); });
    EXPECT_TRUE(waited().empty());
    for (int replay = 0; replay < 3; ++replay) recording.submit();
    EXPECT_EQ(waited(), (Lines{"print.glift:7: at (0): g is 0", "print.glift:7: at (0): g is 1",
                               "print.glift:7: at (0): g is 2"}));
}

TEST_P(MessagesOfKernels, DependOnConditions) {
    const auto truth = buffer(device, "truth", 4);
    for (const std::uint32_t truth_value : {0u, 1u}) {
        device.commands().fill(truth, 0, 4, truth_value);
        run_print(device.commands().where({truth, 0}), g, 1);
    }
    EXPECT_EQ(waited(), (Lines{"print.glift:7: at (0): g is 0"}));
}

TEST_P(MessagesOfKernels, BeyondTheBufferAreCounted) {
    setenv("GLIFT_PRINT_BYTES", "4K", 1);
    const auto small = glift::Device::open(device.is_host() ? "host" : vulkan_name());
    std::vector<Message> found;
    small.on_message([&](const Message& message) { found.push_back(message); });
    const auto memory = buffer(small, "g.data", 4096 * 4);
    for (int round = 0; round < 2; ++round) {
        found.clear();
        run_print(small, memory, 3000);
        small.wait();
        ASSERT_FALSE(found.empty());
        EXPECT_EQ(found.back().kind, Message::Kind::lost);
        EXPECT_EQ(found.back().text, std::to_string(found.back().count) +
                                         " messages were lost: the buffer has 4.0 KiB (4096 bytes); the environment "
                                         "variable GLIFT_PRINT_BYTES makes it larger");
        // Each has three words; four words are the header, one names the kernel.
        EXPECT_EQ(found.size() - 1, (1024u - 4 - 1) / 3);
        EXPECT_EQ(found.size() - 1 + found.back().count, 3000u);
    }
    unsetenv("GLIFT_PRINT_BYTES");
}

TEST_P(MessagesOfKernels, OfFailedAssertionsAreErrorsOfTheNextWait) {
    run_print(device, g, 4, 2);
    const glift::Error error = error_of([&] { device.wait(); });
    EXPECT_EQ(error.code(), glift::ErrorCode::assertion_failed);
    EXPECT_EQ(error.problem(), "2 assertions failed");
    EXPECT_EQ(error.where(), "kernel print (print.glift:5)");
    EXPECT_EQ(error.why(), lines[3]);
    EXPECT_EQ(lines.size(), 6u);
    EXPECT_NO_THROW(device.wait()) << "it is thrown once";
    run_print(device, g, 4, 2);
    EXPECT_EQ(error_of([&] { read<std::uint32_t>(device, g, 4); }).code(), glift::ErrorCode::assertion_failed);
    EXPECT_EQ(read<std::uint32_t>(device, g, 4), (std::vector<std::uint32_t>{2, 2, 2, 2}))
        << "no invocation is stopped";
}

TEST_P(MessagesOfKernels, ArriveBeforeTheDeviceIsGone) {
    Lines last;
    {
        const auto other = glift::Device::open(device.is_host() ? "host" : vulkan_name());
        other.on_message([&](const Message& message) { last.push_back(to_text(message)); });
        run_print(other, buffer(other, "g.data", 16), 2);
    }
    EXPECT_EQ(last.size(), 2u);
}

TEST_P(MessagesOfKernels, GoToStandardErrorAtFirst) {
    const auto other = glift::Device::open(device.is_host() ? "host" : vulkan_name());
    const auto memory = buffer(other, "g.data", 16);
    testing::internal::CaptureStderr();
    run_print(other, memory, 1);
    other.wait();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "print.glift:7: at (0): g is 0\n");
    other.on_message({});
    testing::internal::CaptureStderr();
    run_print(other, memory, 1);
    other.wait();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_P(MessagesOfKernels, NeedABufferOfAUsableSize) {
    for (const char* bytes : {"7", "2G", "much"}) {
        setenv("GLIFT_PRINT_BYTES", bytes, 1);
        const auto other = glift::Device::open(device.is_host() ? "host" : vulkan_name());
        const auto memory = buffer(other, "g.data", 16);
        const glift::Error error = error_of([&] { run_print(other, memory, 1); });
        EXPECT_EQ(error.code(), glift::ErrorCode::wrong_argument);
        EXPECT_EQ(error.where(), std::string("GLIFT_PRINT_BYTES=") + bytes);
    }
    unsetenv("GLIFT_PRINT_BYTES");
}

TEST(MessagesOfTheProgramsCommands, ArriveAtTheNextWait) {
    const PlainVulkan mine;
    const auto device = glift::vulkan::adopt(mine.objects());
    Lines lines;
    device.on_message([&](const Message& message) { lines.push_back(to_text(message)); });
    const auto g = buffer(device, "g.data", 16);
    const VkCommandBuffer commands = mine.begin();
    const auto into = glift::vulkan::record_into(device, commands);
    run_print(into, g, 1);
    run_print(into, g, 1);
    glift::vulkan::finish(into);
    mine.run(commands);
    device.wait();
    EXPECT_EQ(lines, (Lines{"print.glift:7: at (0): g is 0", "print.glift:7: at (0): g is 1"}));
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

}  // namespace
