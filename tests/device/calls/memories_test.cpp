// C++ classes of structures that share memory: each keeps the memory alive, calls that would race on it are refused,
// and so is the use of memory that a container's member has given up.
#include "memories.glift.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace {

const char* const devices[] = {"host", "lavapipe"};

std::vector<std::uint32_t> numbers_from(std::uint32_t first, std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
}

TEST(Memories, a_structure_over_another_is_the_same_memory) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        memories::Numbers numbers(device, 5);
        memories::Backwards backwards(device, numbers);
        numbers.write(numbers_from(1, 5));
        EXPECT_EQ(backwards.domain(), 5u);
        EXPECT_EQ(backwards.read(), (std::vector<std::uint32_t>{5, 4, 3, 2, 1}));
        backwards.write(std::vector<std::uint32_t>{10, 20, 30, 40, 50});
        EXPECT_EQ(numbers.read(), (std::vector<std::uint32_t>{50, 40, 30, 20, 10}));
        memories::number_back(device, backwards);
        EXPECT_EQ(numbers.read(), (std::vector<std::uint32_t>{5, 4, 3, 2, 1}));
        backwards.elements().fill(7u);
        EXPECT_EQ(backwards.read({1}, {2}), (std::vector<std::uint32_t>{7, 7}));
    }
}

TEST(Memories, both_live_while_either_does) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        std::optional<memories::Numbers> numbers(std::in_place, device, 4u);
        std::optional<memories::Backwards> backwards(std::in_place, device, *numbers);
        numbers->write(numbers_from(1, 4));
        numbers.reset();
        EXPECT_EQ(backwards->read(), (std::vector<std::uint32_t>{4, 3, 2, 1}));
        numbers = backwards->numbers();
        backwards.reset();
        EXPECT_EQ(numbers->read(), numbers_from(1, 4));
    }
}

TEST(Memories, memory_made_there_is_reached_by_its_name) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        memories::Offset offset(device, 3, 2);
        offset.own().write(numbers_from(1, 5));
        EXPECT_EQ(offset.read(), numbers_from(3, 3));
        const memories::Offset other(device, 3, 2, offset.own());
        offset.fill(9u);
        EXPECT_EQ(other.own().read(), (std::vector<std::uint32_t>{1, 2, 9, 9, 9}));
        EXPECT_THROW(memories::Offset(device, 3, 4, offset.own()), glift::Error);
    }
}

TEST(Memories, fields_share_a_table) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        std_paged::PageNumbers table(device, 4);
        memories::Field one(device, table, {8, 8}, 2, -1.0f);
        memories::Field other(device, table, {8, 8}, 2, -2.0f);
        table.write(std::vector<std::uint32_t>{0, 2, 3, 1});
        one.fill(5.0f);
        memories::scaled(device, one, other, 2.0f);
        EXPECT_EQ(other.read({3, 0}, {2, 1}), (std::vector<float>{-2.0f, 10.0f}));
        EXPECT_EQ(other.read({3, 4}, {2, 1}), (std::vector<float>{-2.0f, 10.0f}));  // frames 2 (beyond the pool), 0
        table.write(std::vector<std::uint32_t>{1, 0, 0, 0});
        EXPECT_EQ(other.read({0, 0}, {1, 1}), std::vector<float>{10.0f});
        EXPECT_EQ(one.frames().read({0, 0}, {1, 2}), (std::vector<float>{5.0f, 5.0f}));
    }
}

/// Expects that the call is refused because arguments share memory, with both parameters' names.
template <class Call> void expect_refused(Call&& call) {
    try {
        call();
        ADD_FAILURE() << "was not refused";
    } catch (const glift::Error& error) {
        EXPECT_EQ(error.code(), glift::ErrorCode::aliased_memory);
        EXPECT_NE(std::string(error.what()).find("'from'"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("'to'"), std::string::npos) << error.what();
    }
}

TEST(Memories, one_memory_by_two_translators_is_seen) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        memories::Numbers numbers(device, 6);
        const memories::Numbers others(device, 6);
        const memories::Backwards backwards(device, numbers);
        numbers.write(numbers_from(1, 6));
        expect_refused([&] { memories::twice(device, numbers, backwards); });
        memories::twice(device, numbers, memories::Backwards(device, others));
        EXPECT_EQ(others.read(), (std::vector<std::uint32_t>{12, 10, 8, 6, 4, 2}));
    }
}

TEST(Memories, who_has_a_container_sees_its_members_replaced) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        memories::Growing growing(device, 2);
        memories::Growing same = growing;
        growing.items().write(numbers_from(5, 2));
        growing.grow(device);
        EXPECT_EQ(same.capacity(), 4u);
        EXPECT_EQ(same.items().read(), (std::vector<std::uint32_t>{5, 6, 0, 0}));
        same.grow(device);
        EXPECT_EQ(growing.items().domain(), 8u);
    }
}

constexpr glift::ErrorCode given_up = glift::ErrorCode::given_up;

/// Expects that the call throws an error of this kind that contains the text.
template <class Call> void expect_error(glift::ErrorCode code, const char* text, Call&& call) {
    try {
        call();
        ADD_FAILURE() << "did not throw: " << text;
    } catch (const glift::Error& error) {
        EXPECT_EQ(error.code(), code);
        EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
}

TEST(Memories, recordings_do_not_outlive_the_memory_of_a_member) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        memories::Growing growing(device, 2);
        const memories::Growing other(device, 2);
        const auto record = [&](memories::Growing of) {
            return device.record([&](const glift::Commands& commands) { of.count_up(commands); });
        };
        const glift::Recording recording = record(growing), of_other = record(other);
        recording.submit();
        EXPECT_EQ(growing.items().read(), (std::vector<std::uint32_t>{1, 2}));
        growing.grow(device);
        expect_error(given_up, "record again", [&] { recording.submit(); });
        of_other.submit();
        record(growing).submit();
        EXPECT_EQ(growing.items().read(), (std::vector<std::uint32_t>{1, 2, 3, 4}));
        expect_error(glift::ErrorCode::wrong_argument, "in a recording",
                     [&] { device.record([&](const glift::Commands& commands) { growing.grow(commands); }); });
        expect_error(glift::ErrorCode::wrong_argument, "in a recording",
                     [&] { device.workspace_bytes([&](const glift::Commands& commands) { growing.grow(commands); }); });
    }
}

TEST(Memories, what_was_made_over_a_member_that_got_other_memory_is_refused) {
    constexpr const char* text = "memory is used that its container has given up";
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        memories::Growing growing(device, 2);
        growing.items().write(numbers_from(5, 2));
        const memories::Shown shown(device, growing.items());
        EXPECT_EQ(shown.read(), (std::vector<std::uint32_t>{5, 6}));
        const memories::Numbers to(device, 2);
        memories::keep_first(device, growing, to);
        EXPECT_EQ(to.read(), (std::vector<std::uint32_t>{5, 5}));
        expect_error(given_up, text, [&] { shown.read(); });
        expect_error(given_up, text, [&] { memories::Shown(shown).fill(1); });
        EXPECT_EQ(memories::Shown(device, growing.items()).read(), (std::vector<std::uint32_t>{9, 9, 9, 9}));
        expect_error(given_up, text, [&] { memories::number_too_late(device, growing); });
    }
}

TEST(Memories, views_are_read) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        const memories::BackwardSquares squares(memories::Squares(4));
        const memories::Numbers numbers(device, 4);
        memories::read_back(device, squares, numbers);
        EXPECT_EQ(numbers.read(), (std::vector<std::uint32_t>{9, 4, 1, 0}));
    }
}

}  // namespace
