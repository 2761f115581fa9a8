// Wrong uses of generated classes: each throws a glift::Error that says where it happened and what to do. Also which
// commands recordings contain, and that a measurement of workspace runs nothing.
#include "misuse.glift.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace {

using misuse::Counter;
using misuse::Doubled;
using misuse::Line;
using misuse::Ordered;
using misuse::Picture;
using misuse::Tiles;

class Misuse : public testing::TestWithParam<const char*> {
protected:
    ~Misuse() override {
        for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
    }
    glift::Device device = glift::Device::open(GetParam());
};
INSTANTIATE_TEST_SUITE_P(, Misuse, testing::Values("host", "lavapipe"),
                         [](const testing::TestParamInfo<const char*>& which) { return which.param; });

/// The text of the Error that the action throws, which must say where it is and what to do.
std::string error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const glift::Error& error) {
        EXPECT_FALSE(error.remedy().empty()) << error.what();
        EXPECT_FALSE(error.where().empty()) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "no glift::Error was thrown";
    return "";
}

void expect_error(const char* words, const std::function<void()>& action) {
    const std::string text = error_of(action);
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
}

/// Calls the methods of a structure that is empty (default-constructed or moved from). Those that need memory must
/// throw.
template <class S> void use_empty(S& s, const S& other, const glift::Commands& commands) {
    using Address = typename S::Address;
    using Element = typename S::Element;
    const std::string name = std::string("an empty ") + S::type_name + " was used";
    const auto fails = [&](const std::function<void()>& action) { expect_error(name.c_str(), action); };
    EXPECT_FALSE(s);
    fails([&] { s.device(); });
    fails([&] { s.range(Address(0), Address(1)); });
    fails([&] { s.read(); });
    fails([&] { s.read(Address(0), Address(1)); });
    fails([&] { s.write(std::vector<Element>(1)); });
    fails([&] { s.write(Address(0), Address(1), std::vector<Element>(1)); });
    fails([&] { s.map(); });
    fails([&] { s.map(Address(0), Address(1)); });
    fails([&] { s.element(commands, Address(0)); });
    fails([&] { s.element_in_place(commands, Address(0)); });
    fails([&] { s.copy_from(other); });
    fails([&] { s.copy_from(glift::Range<S>(other)); });
    fails([&] { s.fill(Element(1)); });
    fails([&] { s.fill(Element(1), s); });
    const glift::Range<S> range(s);
    fails([&] { range.read(); });
    EXPECT_TRUE(s.same_state(s));
    s.domain();
}

template <class S> void empty_and_moved_from(const glift::Device& device, typename S::Address size) {
    const S other(device, size);
    S none;
    use_empty(none, other, device);
    S moved(device, size);
    S target = std::move(moved);
    use_empty(moved, other, device);
    target.fill(3);
    EXPECT_EQ(target.read()[0], 3);
    moved = target;  // usable again after assignment
    EXPECT_EQ(moved.read()[0], 3);
}

TEST_P(Misuse, OfEmptyStructures) {
    empty_and_moved_from<Line>(device, 10);
    empty_and_moved_from<Tiles>(device, {6, 5});
    empty_and_moved_from<Picture>(device, {6, 5});
    empty_and_moved_from<Ordered>(device, 10);
}

TEST_P(Misuse, OfEmptyViewsAdaptorsAndArguments) {
    Line line(device, 10), none;
    expect_error("an empty memory handle was passed", [&] { misuse::sum_of(device, Doubled(), none); });
    expect_error("ranges of different sizes", [&] { misuse::copy(device, none, line); });
    expect_error("an empty memory handle was passed", [&] { misuse::copy(device, none, Line()); });
    expect_error("an empty memory handle was passed", [&] { misuse::add_one(device, glift::Range<Line>()); });
    expect_error("an empty Device handle was used", [&] { Line made(glift::Device(), 4); });
    Counter counter;
    expect_error("an empty Counter was used", [&] { counter.device(); });
    expect_error("an empty memory handle was passed", [&] { counter.step(device); });
    Counter full(device, 4);
    const Counter moved = std::move(full);
    expect_error("an empty Counter was used", [&] { full.device(); });
}

TEST_P(Misuse, OfPartsThatDoNotFit) {
    const auto bytes = [&](std::uint64_t count) { return device.allocate({.name = "mine", .bytes = count}); };
    const auto picture = [&](std::array<std::uint32_t, 3> extent, glift::Format format) {
        return device.allocate(
            {.name = "mine", .kind = glift::MemoryKind::image2d, .format = format, .extent = extent});
    };
    Line exact(device, 100, bytes(400));
    exact.fill(1);
    EXPECT_EQ(exact.read()[99], 1.0f);
    Line larger(device, 100, bytes(404));
    expect_error("Array<1, float>.data", [&] { Line small(device, 100, bytes(396)); });
    expect_error("Array<1, float>.data", [&] { Line empty(device, 100, glift::Memory()); });
    expect_error("Array<1, float>.data", [&] { Line image(device, 4, picture({4, 4, 1}, glift::Format::r32f)); });
    expect_error("another device", [&] {
        const auto other = glift::Device::open("host");
        Line made(device, 4, other.allocate({.name = "theirs", .bytes = 16}));
    });
    Picture fits(device, {4, 3}, picture({4, 3, 1}, glift::Format::r32f));
    expect_error("Array<2, float, none, image2d>.data", [&] {
        Picture small(device, {4, 3}, picture({4, 2, 1}, glift::Format::r32f));
    });
    expect_error("Array<2, float, none, image2d>.data", [&] {
        Picture other(device, {4, 3}, picture({4, 3, 1}, glift::Format::r32ui));
    });
    expect_error("Array<2, float, none, image2d>.data", [&] { Picture buffer(device, {4, 3}, bytes(400)); });
    using Order = std::decay_t<decltype(std::declval<Ordered>().order())>;
    Ordered made(device, 4, Order(device, 4), bytes(16));
    expect_error("Ordered.order", [&] { Ordered shorter(device, 4, Order(device, 3), bytes(16)); });
    expect_error("empty", [&] { Ordered none(device, 4, Order(), bytes(16)); });
    expect_error("Ordered.data", [&] { Ordered small(device, 4, Order(device, 4), bytes(12)); });
}

TEST_P(Misuse, OfMappedBoxes) {
    Line line(device, 10);
    {
        auto box = line.map(2, 4);
        box[0] = 5, box[3] = 6;
        EXPECT_EQ(box.values().size(), 4u);
        expect_error("address {4}, the box is {4}", [&] { box[4] = 1; });
        expect_error("address {4294967295}", [&] { box[~0u] = 1; });
        auto moved = std::move(box);
        expect_error("no longer mapped", [&] { box[0] = 1; });
        moved.unmap();
        expect_error("no longer mapped", [&] { moved[0] = 1; });
        expect_error("no longer mapped", [&] { moved.values(); });
        moved.unmap();
    }
    EXPECT_EQ(line.read(), (std::vector<float>{0, 0, 5, 0, 0, 6, 0, 0, 0, 0}));
    Tiles tiles(device, {6, 5});
    auto box = tiles.map({1, 1}, {2, 3});
    expect_error("address {2, 0}, the box is {2, 3}", [&] { box[{2, 0}] = 1; });
    expect_error("address {0, 3}", [&] { box[{0, 3}] = 1; });
}

TEST_P(Misuse, OfBoxes) {
    Line line(device, 10);
    expect_error("lies outside its domain", [&] { line.range(8, 3); });
    expect_error("lies outside its domain", [&] { line.range(~0u, 2); });
    expect_error("lies outside its domain", [&] { line.read(11, 0); });
    expect_error("lies outside its domain", [&] { line.element(device, 10); });
    expect_error("do not fill the box", [&] { line.write(std::vector<float>(9)); });
    const auto part = line.range(2, 4);
    expect_error("outside the range of Array<1, float>", [&] { part.range(2, 3); });
    expect_error("outside the range of Array<1, float>", [&] { part.range(~0u, 1); });
    expect_error("outside the range of Array<1, float>", [&] { part.element(device, 4); });
    expect_error("outside the range of Array<1, float>", [&] { part.element_in_place(device, 4); });
    EXPECT_EQ(part.range(1, 3).read().size(), 3u);
    expect_error("f is {10} and g is {4}", [&] { misuse::copy(device, line, line.range(0, 4)); });
    const std::string around = error_of([&] { misuse::around(device, Line(device, 4), line); });
    EXPECT_NE(around.find("structures of different sizes"), std::string::npos) << around;
    EXPECT_NE(around.find("the domain of f is {4}"), std::string::npos) << around;
}

/// What windows read outside of their range counts, too: the elements 9 to 20 here.
TEST_P(Misuse, WindowsReachBeyondTheirRange) {
    const Line line(device, 100);
    expect_error("'f' reads windows in", [&] { misuse::around(device, line.range(10, 10), line.range(20, 10)); });
    misuse::around(device, line.range(10, 10), line.range(21, 10));
}

TEST_P(Misuse, OfSlices) {
    Line line(device, 10);
    misuse::add_to_part(device, line, 2, 7);
    misuse::add_to_part(device, line, 3, 3);
    misuse::add_to_part(device, line, 10, 10);
    EXPECT_EQ(line.read(), (std::vector<float>{0, 0, 1, 1, 1, 1, 1, 0, 0, 0}));
    const std::string backwards = error_of([&] { misuse::add_to_part(device, line, 7, 2); });
    EXPECT_NE(backwards.find("a slice ends before it begins"), std::string::npos) << backwards;
    EXPECT_NE(backwards.find("misuse.glift:"), std::string::npos) << backwards;
    EXPECT_NE(backwards.find("from {7} to before {2}"), std::string::npos) << backwards;
    expect_error("lies outside", [&] { misuse::add_to_part(device, line, 7, 11); });
    expect_error("lies outside", [&] { misuse::add_to_part(device, line, 11, 11); });
}

TEST_P(Misuse, RangesAndMappedBoxesKeepTheMemory) {
    const auto part_of_a_line_that_is_gone = [&] {
        Line line(device, 10);
        line.fill(4);
        return line.range(2, 3);
    };
    const auto part = part_of_a_line_that_is_gone();
    EXPECT_EQ(part.read(), std::vector<float>(3, 4.0f));
    Line other(device, 3);
    misuse::copy(device, part, other);
    EXPECT_EQ(other.read(), std::vector<float>(3, 4.0f));
    const glift::Range<Line> whole = Line(device, 2);
    EXPECT_EQ(whole.read(), std::vector<float>(2, 0.0f));
    auto mapped = Line(device, 5).map();
    mapped[4] = 2;
    mapped.unmap();
}

TEST_P(Misuse, BoxesLargerThanTheHostsMemoryAreErrors) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address sanitizer ends the program where memory is short";
#endif
    misuse::Repeated all(device, {65535, 65535, 65535});
    expect_error("the host has no memory left for the values of a box", [&] { all.map(); });
    expect_error("{65535, 65535, 65535} elements", [&] { all.read(); });
}

TEST_P(Misuse, RecordingsHoldWhatTheirBodiesDo) {
    Line line(device, 4), other(device, 4);
    line.fill(7);
    const auto recording = device.record([&](const glift::Commands& commands) {
        line.fill(1);
        misuse::add_one(commands, line);
        misuse::add_one(device, line);  // within a recording, the device's own stream is the recording's
        Line made(device, 4);
        made.write(std::vector<float>(4, 0.5f));
        misuse::add_one(commands, made);
        other.copy_from(made);
        line.write(3, 1, std::vector<float>(1, 9.0f));
    });
    EXPECT_EQ(line.read(), std::vector<float>(4, 7.0f)) << "nothing ran";
    EXPECT_EQ(other.read(), std::vector<float>(4, 0.0f));
    for (int round = 0; round < 2; ++round) {
        recording.submit();
        EXPECT_EQ(line.read(), (std::vector<float>{3, 3, 3, 9}));
        EXPECT_EQ(other.read(), std::vector<float>(4, 1.5f));
        line.fill(0), other.fill(0);
    }
}

TEST_P(Misuse, RecordingsRefuseWhatWaits) {
    Line line(device, 4);
    const auto earlier = device.record([&](const glift::Commands& commands) { misuse::add_one(commands, line); });
    auto mapped = line.map();
    const auto fails = [&](const char* words, const std::function<void(const glift::Commands&)>& body) {
        expect_error(words, [&] { device.record(body); });
    };
    using Commands = glift::Commands;
    fails("Array<1, float>::read", [&](const Commands&) { line.read(); });
    fails("Array<1, float>::map", [&](const Commands&) { line.map(); });
    fails("cannot be recorded", [&](const Commands& c) { line.element(c, 0).await(c); });
    fails("cannot be recorded", [&](const Commands&) { line.element(device, 0).await(device); });
    fails("Recording::submit", [&](const Commands&) { earlier.submit(); });
    fails("Device::wait", [&](const Commands&) { device.wait(); });
    fails("cannot be recorded", [&](const Commands&) { device.commands().flush(); });
    line.fill(3);  // after the errors the device's own stream is used again
    EXPECT_EQ(line.read()[0], 3.0f);
}

TEST_P(Misuse, MeasuringRunsNothing) {
    Line line(device, 4), kept;
    line.fill(1);
    const auto bytes = device.workspace_bytes([&](const glift::Commands&) {
        line.fill(2);
        misuse::add_one(device, line);
        kept = Line(device, 1000);
        kept.fill(1);
    });
    EXPECT_GE(bytes, 4000u);
    EXPECT_EQ(line.read(), std::vector<float>(4, 1.0f));
    expect_error("kept beyond", [&] { kept.fill(1); });
    expect_error("Device::workspace_bytes",
                 [&] { device.workspace_bytes([&](const glift::Commands&) { line.read(); }); });
}

TEST_P(Misuse, CommandsKeptBeyondTheirRecording) {
    Line line(device, 4);
    glift::Commands kept(device);
    const auto recording = device.record([&](const glift::Commands& commands) {
        kept = commands;
        misuse::add_one(commands, line);
    });
    expect_error("kernel add_one (misuse.glift", [&] { misuse::add_one(kept, line); });
    expect_error("kept beyond", [&] { Line made(kept, 4); });
    expect_error("kept beyond", [&] { kept.fill(line.data(), 0, 4); });
    EXPECT_ANY_THROW(device.record([&](const glift::Commands& commands) {
        kept = commands;
        throw 1;
    }));
    expect_error("kept beyond", [&] { misuse::add_one(kept, line); });
    recording.submit();
    EXPECT_EQ(line.read()[0], 1.0f);
}

TEST_P(Misuse, DifferentBlocksThroughAView) {
    misuse::Numbers list(device, 2), other_list(device, 2);
    list.write(std::vector<glift::uint>{1, 3});
    other_list.write(std::vector<glift::uint>{0, 2});
    misuse::Listed a(device, list, 32), b(device, list, 32), c(device, other_list, 32);
    misuse::fill_both(device, a, b);
    EXPECT_EQ(b.read(7, 3), (std::vector<float>{0, 2, 2}));
    expect_error("different blocks", [&] { misuse::fill_both(device, a, c); });
}

TEST_P(Misuse, DifferentBlocksThroughATable) {
    misuse::Numbers list(device, 2), table(device, 2), other_table(device, 2);
    list.write(std::vector<glift::uint>{1, 3});
    table.write(std::vector<glift::uint>{0, 1});
    other_table.write(std::vector<glift::uint>{1, 1});
    misuse::ListedThrough a(device, list, table, 32), b(device, list, table, 32), c(device, list, other_table, 32);
    misuse::fill_both_through(device, a, b);
    EXPECT_EQ(b.read(7, 3), (std::vector<float>{0, 2, 2}));
    expect_error("different blocks", [&] { misuse::fill_both_through(device, a, c); });
}

TEST_P(Misuse, SumsWhosePartsTakeTooMuchMemory) {
    misuse::Line sums(device, 3);
    const misuse::Ones high(glift::uint2(3, 1000)), large(glift::uint2(1u << 31, 65));
    misuse::add_columns(device, high, sums);
    EXPECT_EQ(sums.read(), std::vector<float>(3, 1000));
    expect_error("too many sums", [&] { misuse::add_columns(device, large, sums); });
}

}  // namespace
