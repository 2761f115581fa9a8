// Moves boxes of elements between host and device: rows along each axis, with and without gaps, Morton order, an image.
// Each element of a box must be moved once, and no others changed.
#include "calls.glift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace {

constexpr std::array<std::uint32_t, 3> extent = {9, 7, 5};

/// The expected contents of the structure, row-major.
struct Model {
    std::vector<std::uint32_t> values = std::vector<std::uint32_t>(extent[0] * extent[1] * extent[2]);

    template <class Visit> static void for_each(glift::uint3 origin, glift::uint3 size, Visit&& visit) {
        for (std::uint32_t z = 0; z < size.z; ++z)
            for (std::uint32_t y = 0; y < size.y; ++y)
                for (std::uint32_t x = 0; x < size.x; ++x)
                    visit(((origin.z + z) * extent[1] + origin.y + y) * extent[0] + origin.x + x);
    }
    void write(glift::uint3 origin, glift::uint3 size, const std::vector<std::uint32_t>& box) {
        auto next = box.begin();
        for_each(origin, size, [&](std::uint32_t at) { values[at] = *next++; });
    }
    std::vector<std::uint32_t> read(glift::uint3 origin, glift::uint3 size) const {
        std::vector<std::uint32_t> box;
        for_each(origin, size, [&](std::uint32_t at) { box.push_back(values[at]); });
        return box;
    }
};

template <class S> void write_and_read(const char* which) {
    const auto device = glift::Device::open(which);
    S structure(device, {extent[0], extent[1], extent[2]});
    Model model;
    std::mt19937 engine(5);
    const auto below = [&](std::uint32_t limit) { return static_cast<std::uint32_t>(engine() % limit); };
    for (int round = 0; round < 60; ++round) {
        glift::uint3 origin, size;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const bool whole = below(3) == 0;
            origin[axis] = whole ? 0 : below(extent[axis]);
            size[axis] = whole ? extent[axis] : below(extent[axis] - origin[axis] + 1);
        }
        if (round % 2 == 0) {
            std::vector<std::uint32_t> values(size.x * size.y * size.z);
            std::ranges::generate(values, std::ref(engine));
            structure.write(origin, size, values);
            model.write(origin, size, values);
        } else {
            ASSERT_EQ(structure.read(origin, size), model.read(origin, size)) << round;
        }
    }
    EXPECT_EQ(structure.read(), model.values);
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

template <class S> class Boxes : public testing::Test {};
using Structures =
    testing::Types<calls::Rows3, calls::Columns, calls::Middle, calls::Gapped, calls::Curve, calls::Picture>;
TYPED_TEST_SUITE(Boxes, Structures);

TYPED_TEST(Boxes, HoldWhatWasWrittenOnTheHost) { write_and_read<TypeParam>("host"); }
TYPED_TEST(Boxes, HoldWhatWasWrittenOnVulkan) { write_and_read<TypeParam>(""); }

TEST(Rows, AreCopiedAsOneWhereTheyFollowEachOther) {
    const auto device = glift::Device::open("host");
    const calls::Rows3 rows(device, {9, 7, 5});
    EXPECT_EQ(glift::detail::rows_of(rows, {0, 0, 0}, {9, 7, 5})->size(), 1u);
    EXPECT_EQ(glift::detail::rows_of(rows, {0, 2, 1}, {9, 3, 2})->size(), 2u);
    EXPECT_EQ(glift::detail::rows_of(rows, {1, 2, 1}, {4, 3, 2})->size(), 6u);
    const calls::Gapped gapped(device, {9, 7, 5});
    EXPECT_EQ(glift::detail::rows_of(gapped, {0, 0, 0}, {9, 7, 5})->size(), 35u);
    const calls::Middle middle(device, {9, 7, 5});
    EXPECT_FALSE(glift::detail::rows_of(middle, {0, 0, 0}, {9, 7, 5})) << "x is not contiguous";
    EXPECT_FALSE(glift::detail::HasRows<calls::Curve>) << "not affine";
    EXPECT_FALSE(glift::detail::HasRows<calls::Picture>) << "an image";
}

// An extent for which Morton order interleaves more than 32 bits: the size of its memory is computed exactly, so that
// no two elements share an address.
TEST(Sides, BeyondThirtyTwoBitsOfMortonOrderAreCountedExactly) {
    const auto device = glift::Device::open("host");
    try {
        calls::Curve(device, {1u << 20, 2, 2});
        ADD_FAILURE() << "585 PiB were allocated";
    } catch (const glift::Error& error) {
        EXPECT_NE(std::string(error.what()).find("658812288346769728 bytes"), std::string::npos) << error.what();
    }
}

}  // namespace
