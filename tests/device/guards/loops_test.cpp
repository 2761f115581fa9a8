// Loops longer than a device allows: the result is right, or there is an error that names kernel and loop.
#include "on_every_device.h"

#include "loops.glift.hpp"

namespace {

using loops::Line;
using loops::Sum;
using testing::Each;
using testing::HasSubstr;

class Loops : public OnEveryDevice {
protected:
    bool is_cut() const { return device.properties().loop_round_limit != glift::unlimited; }

    /// Runs on a line of `elements` and expects all of them to be `expected`. If `beyond`, and if the device has a
    /// limit, expects an error that names kernel and loop instead.
    template <class Run> void expect(const char* kernel, const char* loop, bool beyond, std::uint32_t elements,
                                     std::uint32_t expected, Run run) {
        Line line(device, elements);
        std::vector<std::uint32_t> values;
        const auto error = thrown_by([&] {
            run(line);
            values = line.read({0}, {elements});
        });
        if (beyond && is_cut()) {
            ASSERT_TRUE(error) << kernel << " went on in silence";
            EXPECT_EQ(error->code(), glift::ErrorCode::loop_limit) << error->what();
            EXPECT_THAT(error->where(), HasSubstr(std::string("kernel ") + kernel));
            EXPECT_THAT(error->where(), HasSubstr(loop));
            EXPECT_THAT(error->remedy(), HasSubstr("GLIFT_DEVICE=host"));
            return;
        }
        ASSERT_FALSE(error) << error->what();
        EXPECT_THAT(values, Each(expected));
    }
};
GLIFT_ON_EVERY_DEVICE(Loops);

TEST_P(Loops, ToACountOfTheCall) {
    for (const std::uint32_t rounds : {0u, 1u, 65000u, 65533u}) {
        expect("count", "loops.glift:12", false, 100, rounds, [&](Line& line) { loops::count(device, line, rounds); });
    }
    for (const std::uint32_t rounds : {65534u, 65535u, 65536u, 100000u, 1000000u}) {
        expect("count", "loops.glift:12", true, 100, rounds, [&](Line& line) { loops::count(device, line, rounds); });
    }
    // The error is reported once: later calls are right again.
    expect("count", "loops.glift:12", false, 100, 7, [&](Line& line) { loops::count(device, line, 7); });
}

TEST_P(Loops, OfWhichEachInvocationRunsFew) {
    Line line(device, 64);
    loops::take_turns(device, line, 30000);
    const auto values = line.read({0}, {64});
    for (std::uint32_t i = 0; i < 64; ++i) ASSERT_EQ(values[i], 30000 * (1 + i % 2)) << i;
    const auto error = thrown_by([&] {
        loops::take_turns(device, line, 40000);
        line.read({0}, {64});
    });
    ASSERT_EQ(error.has_value(), is_cut());
    if (error) {
        EXPECT_EQ(error->code(), glift::ErrorCode::loop_limit) << error->what();
    }
}

// A device that runs both sides of every branch evaluates the inner loop's condition once per outer iteration, which
// counts as an iteration.
TEST_P(Loops, ThatNoInvocationEnters) {
    expect("rarely", "loops.glift:93", false, 64, 30000, [&](Line& line) { loops::rarely(device, line, 30000); });
    expect("rarely", "loops.glift:93", true, 64, 40000, [&](Line& line) { loops::rarely(device, line, 40000); });
}

TEST_P(Loops, InAConditionThatNoInvocationEvaluates) {
    expect("rarely_asks", "loops.glift:122", false, 64, 30000,
           [&](Line& line) { loops::rarely_asks(device, line, 30000); });
    expect("rarely_asks", "loops.glift:122", true, 64, 40000,
           [&](Line& line) { loops::rarely_asks(device, line, 40000); });
}

TEST_P(Loops, WhoseEndsWeighAsMuchAsTheirRounds) {
    expect("ends", "loops.glift:108", true, 64, 12000, [&](Line& line) { loops::ends(device, line); });
}

TEST_P(Loops, InAFunctionOfAnotherFile) {
    Line from(device, 3), to(device, 3);
    from.write({0}, {3}, std::vector<std::uint32_t>{27, 1, 97});
    loops::collatz(device, from, to);
    EXPECT_THAT(to.read({0}, {3}), testing::ElementsAre(111, 0, 118));
    // Starting from zero the loop never ends on a device without a limit.
    if (!is_cut()) return;
    from.write({0}, {3}, std::vector<std::uint32_t>{27, 1, 0});
    const auto error = thrown_by([&] {
        loops::collatz(device, from, to);
        to.read({0}, {3});
    });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), glift::ErrorCode::loop_limit);
    EXPECT_THAT(error->where(), HasSubstr("steps.glift:7"));
    EXPECT_THAT(error->where(), HasSubstr("kernel collatz (loops.glift:34)"));
}

TEST_P(Loops, KnownToRunTooLongAreRefusedBeforeTheyRun) {
    const auto passes = device.statistics().passes;
    Line line(device, 4);
    expect("nested", "loops.glift:41", true, 4, 90000, [&](Line& to) {
        const auto error = thrown_by([&] { loops::nested(device, to); });
        EXPECT_EQ(error.has_value(), is_cut()) << "not refused by the call itself";
        if (error) throw *error;
    });
    expect(
        "nearly", "loops.glift:52", true, 4,
        [] {
            std::uint32_t n = 0;
            for (std::uint32_t i = 0; i < 1000; ++i)
                for (std::uint32_t j = 0; j < 64; ++j) n += i ^ j;
            return n;
        }(),
        [&](Line& to) { loops::nearly(device, to); });
    if (is_cut()) {
        EXPECT_EQ(device.statistics().passes, passes);
    }
}

/// Devices with a limit add floats by one atomic operation, so that the number of updates has no limit.
TEST_P(Loops, UpdatesAreNotCounted) {
    Line from(device, 16);
    from.write({0}, {16}, std::vector<std::uint32_t>(16, 1));
    Sum sum(device, 1);
    loops::add_up(device, from, 1000, sum);
    EXPECT_THAT(sum.read({0}, {1}), testing::ElementsAre(16000.0f));
    sum.write({0}, {1}, std::vector<float>{0});
    loops::add_up(device, from, 20000, sum);
    EXPECT_THAT(sum.read({0}, {1}), testing::ElementsAre(320000.0f));
}

TEST_P(Loops, WithBarriers) {
    Line from(device, 128), to(device, 128);
    std::vector<std::uint32_t> numbers(128);
    for (std::uint32_t i = 0; i < 128; ++i) numbers[i] = i;
    from.write({0}, {128}, numbers);
    loops::sums(device, from, 1000, to);
    EXPECT_THAT(to.read({0}, {2}), testing::ElementsAre(2016, 6112));
    if (!is_cut()) return;
    const auto error = thrown_by([&] {
        loops::sums(device, from, 20000, to);
        to.read({0}, {2});
    });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), glift::ErrorCode::loop_limit);
    EXPECT_THAT(error->where(), testing::AnyOf(HasSubstr("loops.glift:71"), HasSubstr("loops.glift:76")));
}

}  // namespace
