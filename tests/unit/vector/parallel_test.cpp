// host::for_rows and for_tiles visit each element of a range exactly once, for any shape of range; for_strides does so
// with invocations. load_rows and store_rows copy between arrays and buffers; their index counts rows of four numbers.
// Also the middle of a row along x, where windows stay in the domain or clamps change nothing, and atomics of floats.
#include <glift/host/atomics.h>
#include <glift/host/parallel.h>
#include <glift/host/updates.h>

#include <gtest/gtest.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

using namespace glift;

TEST(Rows, CoverEveryElementOnce) {
    for (const std::array<std::uint32_t, 4> size : {std::array<std::uint32_t, 4>{1, 1, 1, 1},
                                                    {100000, 3, 1, 1},
                                                    {300000, 1, 1, 1},
                                                    {5, 7, 11, 3},
                                                    {256, 64, 9, 1},
                                                    {0, 5, 1, 1},
                                                    {3, 100000, 1, 1}}) {
        std::vector<std::uint8_t> seen(std::size_t{size[0]} * size[1] * size[2] * size[3]);
        host::for_rows(size, [&](const host::Rows& rows) {
            for (const host::Row row : rows) {
                const std::size_t first = ((std::size_t{row.w} * size[2] + row.z) * size[1] + row.y) * size[0];
                for (uint x = row.begin; x < row.end; ++x) ++seen[first + x];
            }
        });
        for (std::uint8_t count : seen) ASSERT_EQ(count, 1);
    }
}

template <unsigned axis> void cover_by_tiles(const std::array<std::uint32_t, 4>& size) {
    std::vector<std::uint8_t> seen(std::size_t{size[0]} * size[1] * size[2] * size[3]);
    host::for_tiles<axis>(size, [&](const host::Rows& rows) {
        for (const host::Row row : rows) {
            const std::size_t first = ((std::size_t{row.w} * size[2] + row.z) * size[1] + row.y) * size[0];
            for (uint x = row.begin; x < row.end; ++x) ++seen[first + x];
        }
    });
    for (std::uint8_t count : seen) ASSERT_EQ(count, 1);
}

TEST(Tiles, CoverEveryElementOnce) {
    for (const std::array<std::uint32_t, 4> size : {std::array<std::uint32_t, 4>{1, 1, 1, 1},
                                                    {33, 65, 1, 1},
                                                    {1, 100, 7, 1},
                                                    {64, 5, 40, 1},
                                                    {0, 5, 1, 1},
                                                    {5, 0, 1, 1},
                                                    {5, 7, 33, 3}}) {
        cover_by_tiles<1>(size);
        cover_by_tiles<2>(size);
    }
}

TEST(Strides, CoverEveryInvocationOnce) {
    for (const std::uint32_t size : {0u, 1u, 64u, 65u, 100000u, 1u << 20}) {
        std::vector<std::uint8_t> seen((size + 63) / 64);
        host::for_strides(size, 64, [&](const host::Rows& rows) {
            for (const host::Row row : rows)
                for (uint x = row.begin; x < row.end; ++x) ++seen[x];
        });
        for (std::uint8_t count : seen) ASSERT_EQ(count, 1);
    }
}

TEST(Elements, MoveAsRows) {
    std::vector<float> memory(128);
    for (std::size_t i = 0; i < memory.size(); ++i) memory[i] = static_cast<float>(i);
    array<float, 8> few{};
    array<float, 64> many{};
    host::load_rows(memory.data(), 3, few);
    host::load_rows(memory.data(), 5, many);
    EXPECT_EQ(few[7], 19.0f);
    EXPECT_EQ(many[63], 83.0f);
    host::store_rows(memory.data(), 0, few);
    host::store_rows(memory.data(), 16, many);
    EXPECT_EQ(memory[7], 19.0f);
    EXPECT_EQ(memory[8], 8.0f);
    EXPECT_EQ(memory[127], 83.0f);
}

TEST(Rows, KnowTheirInterior) {
    const host::Row row{0, 10, 3, 3, 0};
    const host::Part inside = host::interior_of(row, uint3(), uint3(10, 8, 8), 2);
    EXPECT_EQ(inside.begin, 2u);
    EXPECT_EQ(inside.end, 8u);
    const host::Part none = host::interior_of({0, 10, 1, 3, 0}, uint3(), uint3(10, 8, 8), 2);
    EXPECT_EQ(none.begin, none.end);
    const host::Part shifted = host::interior_of({0, 4, 0, 0, 0}, uint2(5, 4), uint2(10, 8), 2);
    EXPECT_EQ(shifted.begin, 0u);
    EXPECT_EQ(shifted.end, 3u);
}

TEST(Rows, KnowWhereAClampChangesNothing) {
    host::Unclamped low;
    low.keep(-1, 0, 9);
    EXPECT_EQ(low.of(0, 10).begin, 1u);
    EXPECT_EQ(low.of(0, 10).end, 10u);
    host::Unclamped both;
    both.keep(5, 0, 9);
    both.keep(-2, 0, 9);
    EXPECT_EQ(both.of(4, 10).begin, 6u);
    EXPECT_EQ(both.of(4, 10).end, 9u);
    host::Unclamped nowhere;
    nowhere.keep(0, 5, 3);
    EXPECT_EQ(nowhere.of(0, 4).begin, nowhere.of(0, 4).end);
}

TEST(Rows, LeaveAMiddleWithoutABlockToTheEnds) {
    const host::Part enough = host::in_blocks({3, 19}, 30);
    EXPECT_EQ(enough.begin, 3u);
    EXPECT_EQ(enough.end, 19u);
    const host::Part few = host::in_blocks({3, 18}, 30);
    EXPECT_EQ(few.begin, 30u);
    EXPECT_EQ(few.end, 30u);
    const auto sections = host::sections(2, few, 30);
    EXPECT_EQ(sections[0].begin, 2u);
    EXPECT_EQ(sections[0].end, 30u);
    EXPECT_EQ(sections[2].begin, sections[2].end);
}

/// Long rows are tasks of their own, however large a task may be.
TEST(Rows, AreSplitIfLong) {
    constexpr std::uint32_t width = 300'001, height = 5;
    for (const std::size_t task : {std::size_t{1} << 14, std::size_t{100'000}, std::size_t{5'000'000}}) {
        std::vector<std::atomic<unsigned char>> seen(std::size_t{width} * height);
        std::atomic<std::uint32_t> calls{0};
        host::for_rows(
            {width, height, 1, 1},
            [&](const host::Rows& rows) {
                ++calls;
                for (const host::Row row : rows)
                    for (uint x = row.begin; x < row.end; ++x) ++seen[std::size_t{row.y} * width + x];
            },
            task);
        EXPECT_TRUE(std::ranges::all_of(seen, [](const auto& count) { return count == 1; })) << task;
        EXPECT_GE(calls, height) << task;
    }
}

/// More elements than there are slots, few, and so many that most updates conflict; the numbers are exact in floats.
TEST(Updates, AreAllMade) {
    for (const uint count : {1u, 100u, 5000u, 1u << 20}) {
        std::vector<float> sums(count), wanted(count);
        std::vector<std::int32_t> lows(count, 1000), wanted_lows(count, 1000);
        {
            host::Updates<float, host::Add> add(sums.data());
            host::Updates<std::int32_t, host::Min> keep(lows.data());
            uint random = 1;
            for (int i = 0; i < 100'000; ++i) {
                random = random * 1664525u + 1013904223u;
                const uint at = (random >> 8) % count;
                add.add(at, static_cast<float>(i % 5));
                keep.add(at, 500 - i % 1000);
                wanted[at] += static_cast<float>(i % 5);
                wanted_lows[at] = std::min(wanted_lows[at], 500 - i % 1000);
            }
        }
        EXPECT_EQ(sums, wanted) << count;
        EXPECT_EQ(lows, wanted_lows) << count;
    }
}

/// Rows shorter and longer than the lanes, with elements that do not update.
TEST(Updates, OfARowAreCombined) {
    for (const std::size_t count : {1u, 2u, 63u, 64u, 65u, 1000u}) {
        std::vector<float> sums(3), lows(3, 10.0f);
        float wanted = 0;
        {
            host::Updates<float, host::Add> add(sums.data());
            host::Updates<float, host::Min> keep(lows.data());
            host::RowUpdate<float, host::Add> row(count), empty(count);
            host::RowUpdate<float, host::Min> low(count);
            for (std::size_t first = 0; first < count; first += host::row_lanes) {
                for (std::size_t lane = 0; lane < host::lanes_from(first, count); ++lane) {
                    const std::size_t i = first + lane;
                    if (i % 3 == 1) continue;
                    row.add(2, lane, static_cast<float>(i));
                    low.add(1, lane, 5.0f - static_cast<float>(i));
                    wanted += static_cast<float>(i);
                }
            }
            row.finish(add), empty.finish(add), low.finish(keep);
        }
        EXPECT_EQ(sums, (std::vector<float>{0, 0, wanted})) << count;
        const float last = static_cast<float>(count - 1 - ((count - 1) % 3 == 1 ? 1 : 0));
        EXPECT_EQ(lows, (std::vector<float>{10, std::min(10.0f, 5.0f - last), 10})) << count;
    }
}

TEST(Updates, NumbersReplaceNaN) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> least = {nan, 5.0f, 0.0f}, greatest = least;
    {
        host::Updates<float, host::Min> low(least.data());
        host::Updates<float, host::Max> high(greatest.data());
        for (const float value : {nan, 2.0f, nan, 3.0f}) low.add(0, value), high.add(0, value);
        low.add(1, nan), high.add(1, nan);
        for (const float value : {0.0f, -0.0f}) low.add(2, value), high.add(2, value);
    }
    EXPECT_EQ(least[0], 2.0f);
    EXPECT_EQ(greatest[0], 3.0f);
    EXPECT_EQ(least[1], 5.0f);
    EXPECT_EQ(greatest[1], 5.0f);
    EXPECT_TRUE(std::signbit(least[2]) && !std::signbit(greatest[2]));
}

TEST(Atomics, CombineFloats) {
    float least = 3, sum = 0;
    host::atomic_min(least, 1.0f);
    host::atomic_min(least, 2.0f);
    tbb::parallel_for(0, 1000, [&](int) { host::atomic_add(sum, 1.0f); });
    EXPECT_EQ(least, 1.0f);
    EXPECT_EQ(sum, 1000.0f);
}
