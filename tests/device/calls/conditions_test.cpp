// Conditions, counts and loops whose values stay on the device: called, recorded and replayed.
#include "conditions.glift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace {

using Values = std::vector<std::uint32_t>;

const char* const devices[] = {"host", "lavapipe"};

Values counted(std::size_t n) {
    Values values(n);
    std::iota(values.begin(), values.end(), 0u);
    return values;
}

/// Does what `settle` does, on the host; returns the number of rounds.
std::uint32_t settled(Values& a, const Values& counts) {
    std::uint32_t rounds = 0;
    while (std::ranges::any_of(a, [&](std::uint32_t x) { return x > counts[0]; })) {
        for (std::uint32_t& x : a) x = x > counts[0] ? x / 2 : x;
        ++rounds;
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(counts[1], a.size()); ++i) a[i] *= counts[2] + 1;
    return rounds;
}

TEST(Conditions, loops_end_where_their_condition_ends) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        conditions::Line a(device, 500), counts(device, 3);
        Values expected = counted(500);
        a.write(expected);
        counts.write(Values{9, 100, 4});
        const auto rounds = conditions::settle(device, a, counts);
        EXPECT_EQ(rounds.await(device), settled(expected, {9, 100, 4})) << name;
        EXPECT_EQ(a.read(), expected) << name;
    }
}

TEST(Conditions, replays_evaluate_them_anew) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        conditions::Line a(device, 500), counts(device, 3), rounds(device, 1);
        const auto recording =
            device.record([&](const glift::Commands& c) { conditions::settle_into(c, a, counts, rounds); });
        for (const Values& now : {Values{9, 100, 4}, Values{600, 3, 1}, Values{0, 1000, 0}, Values{250, 0, 7}}) {
            Values expected = counted(500);
            a.write(expected);
            counts.write(now);
            recording.submit();
            recording.submit();
            const std::uint32_t first = settled(expected, now), second = settled(expected, now);
            EXPECT_EQ(rounds.read(), (Values{second})) << name << ", the first time " << first;
            EXPECT_EQ(a.read(), expected) << name;
        }
        const auto bytes =
            device.workspace_bytes([&](const glift::Commands& c) { conditions::settle_into(c, a, counts, rounds); });
        EXPECT_EQ(bytes, recording.workspace_bytes()) << name;
    }
}

TEST(Conditions, one_arm_runs) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        conditions::Line a(device, 100), counts(device, 1);
        const auto recording = device.record([&](const glift::Commands& c) { conditions::choose(c, a, counts); });
        std::uint32_t sum = 0;
        for (std::uint32_t which : {1u, 2u, 0u, 3u, 2u, 1u}) {
            counts.write(Values{which});
            conditions::choose(device, a, counts);
            recording.submit();
            sum += which == 1 ? 4 : which == 2 ? 6000 : 0;
            EXPECT_EQ(a.read(), Values(100, sum)) << name << ", " << which;
        }
    }
}

TEST(Conditions, commands_of_programs_may_have_them) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        conditions::Line a(device, 100), flag(device, 1);
        const auto is_set = conditions::is_set(device, flag);
        const glift::Commands commands = device.commands();
        conditions::add_one(commands.where(is_set), a);
        conditions::add_one(commands.where_not(is_set), a);
        conditions::scale(commands.where_not(is_set), a, 5u);
        conditions::scale(commands.where_not(is_set).where(is_set), a, 7u);
        commands.where(is_set).fill(a.data(), 0, 8, 3u);
        commands.where_not(is_set).fill(a.data(), 0, 4, 4u);
        Values expected(100, 5);
        expected[0] = 4;
        EXPECT_EQ(a.read(), expected) << name;
        try {
            commands.where(is_set).copy(a.data(), 0, a.data(), 40, 8);
            ADD_FAILURE() << name;
        } catch (const glift::Error& error) {
            EXPECT_NE(std::string(error.what()).find("under a condition"), std::string::npos) << error.what();
        }
    }
}

}  // namespace
