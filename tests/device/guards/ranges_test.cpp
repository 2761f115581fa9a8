// Modules compiled by gliftc --checked: reads `s[a]` and writes `s[a] = x` outside of a domain are reported. Not
// reported are accesses that are meant for addresses outside (`find`, `sample`, `near`, and all of a kernel declared
// `@accesses_outside`), and those of structures that define what lies outside.
#include "on_every_device.h"

#include "ranges.glift.hpp"

namespace {

using testing::HasSubstr;

class Ranges : public OnEveryDevice {
protected:
    /// Runs and waits. Expects an out_of_range error whose place names the line and the kernel, and whose reason
    /// contains `why`: parts of the memory's name and the virtual address.
    template <class Run> void expect_report(Run run, const char* line, const char* kernel, const char* why) {
        const auto error = thrown_by([&] {
            run();
            device.wait();
        });
        ASSERT_TRUE(error) << kernel << " reported nothing";
        EXPECT_EQ(error->code(), glift::ErrorCode::out_of_range) << error->what();
        EXPECT_THAT(error->where(), HasSubstr(line));
        EXPECT_THAT(error->where(), HasSubstr(std::string("kernel ") + kernel));
        EXPECT_THAT(error->why(), HasSubstr(why));
        EXPECT_FALSE(error->remedy().empty());
        device.wait();  // must not report it again
    }

    template <class Run> void expect_silence(Run run) {
        const auto error = thrown_by([&] {
            run();
            device.wait();
        });
        EXPECT_FALSE(error) << error->what();
    }

    ranges::Grid from{device, {5, 4}}, to{device, {5, 4}};
};
GLIFT_ON_EVERY_DEVICE(Ranges);

TEST_P(Ranges, AReadOutsideIsReported) {
    expect_silence([&] { ranges::shifted(device, from, {0, 0}, to); });
    expect_report(
        [&] {
            ranges::shifted(device, from, {0, 3}, to);
        },
        "ranges.glift:19", "shifted", "from.data at virtual address (");
    ranges::Grid one(device, {1, 1});
    expect_report([&] { ranges::shifted(device, from, {7, 2}, one); }, "ranges.glift:19", "shifted", "(7, 2)");
    expect_report(
        [&] {
            ranges::shifted(device, from, {0xffffffffu, 0}, one);
        },
        "ranges.glift:19", "shifted", "(-1, 0)");
}

TEST_P(Ranges, WhatTheStructureDefinesIsNot) {
    ranges::Clamped clamped(device, {5, 4});
    ranges::Edged edged(device, {5, 4}, 1.5f);
    expect_silence([&] { ranges::shifted_clamped(device, clamped, {9, 0}, to); });
    expect_silence([&] { ranges::shifted_border(device, edged, {9, 0}, to); });
    EXPECT_EQ(to.read({0, 0}, {1, 1})[0], 1.5f);
}

TEST_P(Ranges, WhatAKernelDeclaresIsNot) {
    expect_silence([&] { ranges::shifted_on_purpose(device, from, {3, 3}, to); });
    EXPECT_EQ(to.read({4, 3}, {1, 1})[0], 1.0f);
}

TEST_P(Ranges, WhatIsAskedForIsNot) {
    expect_silence([&] { ranges::asked(device, from, {3, 3}, to); });
    EXPECT_EQ(to.read({4, 3}, {1, 1})[0], -1.0f);
    expect_silence([&] { ranges::tested(device, from, {3, 3}, to); });
    EXPECT_EQ(to.read({4, 3}, {1, 1})[0], -1.0f);
    expect_silence([&] { ranges::sampled(device, from, to); });
    expect_silence([&] { ranges::beside(device, from, to); });
}

TEST_P(Ranges, AViewReadOutsideIsReported) {
    expect_silence([&] { ranges::view_shifted(device, from, {0, 0}, to); });
    expect_report(
        [&] {
            ranges::view_shifted(device, from, {5, 0}, to);
        },
        "ranges.glift:51", "viewed", "at virtual address (");
}

TEST_P(Ranges, AWriteOutsideIsReported) {
    ranges::Volume a(device, {3, 3, 3}), b(device, {3, 3, 3});
    a.fill(7);
    expect_silence([&] { ranges::put(device, a, {0, 0, 0}, b); });
    expect_report(
        [&] {
            ranges::put(device, a, {0, 0, 2}, b);
        },
        "ranges.glift:60", "put", "to.data at virtual address (");
    EXPECT_EQ(b.read({0, 0, 2}, {1, 1, 1})[0], 7u);
}

TEST_P(Ranges, AnAtomicWriteOutsideIsReported) {
    ranges::Line values(device, 4), bins(device, 3);
    values.write({0}, {4}, std::vector<std::uint32_t>{0, 1, 2, 1});
    expect_silence([&] { ranges::histogram(device, values, bins); });
    EXPECT_THAT(bins.read({0}, {3}), testing::ElementsAre(1, 2, 1));
    values.write({0}, {4}, std::vector<std::uint32_t>{0, 9, 2, 1});
    expect_report([&] { ranges::histogram(device, values, bins); }, "ranges.glift:64", "histogram",
                  "to.data at virtual address (9)");
}

TEST_P(Ranges, AReadInAFunctionOfAnotherFileNamesThatFile) {
    ranges::Line start(device, 2), links(device, 3), end(device, 2);
    links.write({0}, {3}, std::vector<std::uint32_t>{1, 2, 11});
    expect_silence([&] { ranges::followed(device, start, links, 3, end); });
    EXPECT_THAT(end.read({0}, {2}), testing::ElementsAre(11, 11));
    expect_report([&] { ranges::followed(device, start, links, 4, end); }, "chains.glift:11",
                  "followed (ranges.glift:67)", "links.data at virtual address (11)");
}

TEST_P(Ranges, SlicesAreReportedWithWholeAddresses) {
    ranges::Grid large(device, {8, 8});
    expect_silence([&] { ranges::shifted(device, from, {0, 0}, large.range({0, 0}, {2, 2})); });
    expect_report(
        [&] {
            ranges::shifted(device, from, {0, 0}, large.range({6, 1}, {1, 1}));
        },
        "ranges.glift:19", "shifted", "(6, 1)");
}

TEST_P(Ranges, InvocationsThatFillUpAGroupDoNotCount) {
    ranges::Line a(device, 70), b(device, 70);
    expect_silence([&] { ranges::grouped(device, a, 0, b); });
    expect_report([&] { ranges::grouped(device, a, 1, b); }, "ranges.glift:73", "grouped", "(70)");
}

TEST_P(Ranges, ARecordingReportsWhenItRuns) {
    const glift::Recording recording = device.record([&](const glift::Commands& commands) {
        ranges::shifted(commands, from, {5, 0}, to);
    });
    device.wait();
    for (int round = 0; round < 2; ++round)
        expect_report([&] { recording.submit(); }, "ranges.glift:19", "shifted", "from.data");
}

}  // namespace
