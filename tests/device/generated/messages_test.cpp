// Messages of `print` and `assert` in programs: the same lines, in the same order, on every device.
#include "messages.glift.hpp"
#include "plain_vulkan.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <optional>

namespace {

using glift::Message;
using testing::ElementsAre;
using testing::HasSubstr;

class Messages : public testing::TestWithParam<const char*> {
protected:
    Messages() { listen(device, lines); }
    ~Messages() override {
        for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
    }

    static void listen(const glift::Device& device, std::vector<std::string>& lines) {
        device.on_message([&lines](const Message& message) { lines.push_back(to_text(message)); });
    }

    messages::Line line(std::vector<glift::uint> values) const {
        messages::Line made(device, static_cast<glift::uint>(values.size()));
        made.write(values);
        return made;
    }

    /// The error of the next wait, if there is one.
    std::optional<glift::Error> error_of_wait() const {
        try {
            device.wait();
        } catch (const glift::Error& error) {
            return error;
        }
        return std::nullopt;
    }

    glift::Device device = glift::Device::open(GetParam());
    std::vector<std::string> lines;
};
INSTANTIATE_TEST_SUITE_P(, Messages, testing::Values("host", "lavapipe"),
                         [](const testing::TestParamInfo<const char*>& which) { return which.param; });

TEST_P(Messages, ComeInTheOrderOfAddresses) {
    messages::show(device, line({5, 7, 9}));
    device.wait();
    EXPECT_THAT(lines, ElementsAre("messages.glift:9: at (0): x is 5", "messages.glift:9: at (1): x is 7",
                                   "messages.glift:9: at (2): x is 9"));
}

TEST_P(Messages, HaveAddressesInTheStructure) {
    messages::Plane plane(device, {4, 3});
    plane.write({1, 0}, {2, 2}, std::vector<float>{0.1f, 1.0f / 3, -0.0f, 1e20f});
    messages::show_plane(device, plane.range({1, 0}, {3, 3}));
    device.wait();
    EXPECT_THAT(lines,
                ElementsAre("messages.glift:13: at (1, 0): x = 0.1", "messages.glift:13: at (2, 0): x = 0.33333334",
                            "messages.glift:13: at (2, 1): x = 1e+20"));
}

TEST_P(Messages, OfManyElementsAreSorted) {
    messages::Line many(device, 5000);
    messages::show(device, many);
    messages::show(device, many);
    device.wait();
    ASSERT_EQ(lines.size(), 10000u);
    for (std::size_t i = 0; i < lines.size(); ++i)
        ASSERT_EQ(lines[i], "messages.glift:9: at (" + std::to_string(i % 5000) + "): x is 0");
}

TEST_P(Messages, OfPassesComeInTheirOrder) {
    auto x = line({1, 5});
    messages::twice(device, x);
    EXPECT_EQ(x.read(), (std::vector<glift::uint>{3, 7}));
    EXPECT_THAT(lines, ElementsAre(HasSubstr("(0): x = 1"), HasSubstr("(1): x = 5"), HasSubstr("(0): x = 2"),
                                   HasSubstr("(1): x = 6")));
}

TEST_P(Messages, OfARecordingComeWithEachReplay) {
    auto x = line({1});
    const auto recording = device.record([&](const glift::Commands& commands) { messages::twice(commands, x); });
    device.wait();
    EXPECT_TRUE(lines.empty());
    for (int replay = 0; replay < 3; ++replay) recording.submit();
    device.wait();
    EXPECT_THAT(lines, ElementsAre(HasSubstr("x = 1"), HasSubstr("x = 2"), HasSubstr("x = 3"), HasSubstr("x = 4"),
                                   HasSubstr("x = 5"), HasSubstr("x = 6")));
}

TEST_P(Messages, DependOnConditionsAndSizesOfTheDevice) {
    const auto x = line({4, 5, 6});
    messages::show_if(device, line({0, 2}), x);
    device.wait();
    EXPECT_THAT(lines, ElementsAre(HasSubstr("(0): x is 4"), HasSubstr("(1): x is 5")));
    lines.clear();
    messages::show_if(device, line({1, 0}), x);
    device.wait();
    EXPECT_EQ(lines.size(), 3u);
}

TEST_P(Messages, BeyondTheBufferAreCounted) {
    setenv("GLIFT_PRINT_BYTES", "4K", 1);
    const auto small = glift::Device::open(GetParam());
    std::vector<Message> found;
    small.on_message([&](const Message& message) { found.push_back(message); });
    messages::Line many(small, 3000);
    for (int round = 0; round < 2; ++round) {
        found.clear();
        messages::show(small, many);
        small.wait();
        unsetenv("GLIFT_PRINT_BYTES");
        ASSERT_FALSE(found.empty());
        const Message last = found.back();
        EXPECT_EQ(last.kind, Message::Kind::lost);
        EXPECT_THAT(last.text, HasSubstr(std::to_string(last.count) + " messages were lost: the buffer has 4.0 KiB"));
        // Each has three words; four words are the header, one names the kernel.
        EXPECT_EQ(found.size() - 1, (1024u - 4 - 1) / 3);
        EXPECT_EQ(found.size() - 1 + last.count, 3000u);
    }
}

TEST_P(Messages, OfFailedAssertionsAreErrorsOfTheNextWait) {
    const auto x = line({3, 9, 4, 8});
    messages::bounded(device, x, 8);
    const auto error = error_of_wait();
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), glift::ErrorCode::assertion_failed);
    EXPECT_EQ(error->problem(), "2 assertions failed");
    EXPECT_THAT(error->where(), HasSubstr("kernel bounded (messages.glift:"));
    EXPECT_EQ(error->why(), "messages.glift:22: at (1): assertion failed: x < limit (x = 9, limit = 8): of {8}");
    EXPECT_EQ(lines.size(), 2u);
    EXPECT_FALSE(error_of_wait()) << "it is thrown once";
    messages::bounded(device, x, 10);
    EXPECT_FALSE(error_of_wait());
    EXPECT_EQ(lines.size(), 2u);
}

TEST_P(Messages, AreErrorsOfAReadToo) {
    const auto x = line({3});
    messages::bounded(device, x, 3);
    EXPECT_THROW(std::ignore = x.read(), glift::Error);
    EXPECT_EQ(x.read(), std::vector<glift::uint>{3});
}

TEST_P(Messages, ArriveBeforeTheDeviceIsGone) {
    std::vector<std::string> last;
    {
        const auto other = glift::Device::open(GetParam());
        listen(other, last);
        messages::Line x(other, 2);
        messages::show(other, x);
    }
    EXPECT_EQ(last.size(), 2u);
}

TEST_P(Messages, GoToStandardErrorAtFirst) {
    const auto other = glift::Device::open(GetParam());
    messages::Line x(other, 1);
    testing::internal::CaptureStderr();
    messages::show(other, x);
    other.wait();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "messages.glift:9: at (0): x is 0\n");
}

TEST_P(Messages, ABufferOfNoUsableSizeIsAnError) {
    setenv("GLIFT_PRINT_BYTES", "7", 1);
    const auto other = glift::Device::open(GetParam());
    messages::Line x(other, 1);
    EXPECT_THROW(
        {
            messages::show(other, x);
            other.wait();
        },
        glift::Error);
    unsetenv("GLIFT_PRINT_BYTES");
}

TEST(MessagesRecorded, IntoTheProgramsCommandBufferArriveAtTheNextWait) {
    const PlainVulkan mine;
    const auto device = glift::vulkan::adopt(mine.objects());
    std::vector<std::string> lines;
    device.on_message([&](const Message& message) { lines.push_back(to_text(message)); });
    messages::Line x(device, 2);
    const VkCommandBuffer commands = mine.begin();
    const auto into = glift::vulkan::record_into(device, commands);
    messages::twice(into, x);
    glift::vulkan::finish(into);
    mine.run(commands);
    device.wait();
    EXPECT_THAT(lines, ElementsAre(HasSubstr("(0): x = 0"), HasSubstr("(1): x = 0"), HasSubstr("(0): x = 1"),
                                   HasSubstr("(1): x = 1")));
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

}  // namespace
