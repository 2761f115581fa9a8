// host::for_rows and for_tiles visit each element of a range exactly once, for any shape of range; for_strides does so
// with invocations. load_rows and store_rows copy between arrays and buffers; their index counts rows of four numbers.
// Also the middle of a row along x, where windows stay in the domain or clamps change nothing, and atomics of floats.
#include <glift/host/atomics.h>
#include <glift/host/parallel.h>
#include <glift/host/runs.h>
#include <glift/host/sums.h>
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

/// Whether `visit(size, body)` visits each element from `first` on along the last axis once, and no other.
template <class Visit> void cover_a_part(const HostSize& size, Visit visit) {
    std::vector<std::uint8_t> seen(std::size_t{size[0]} * size[1] * size[2] * size[3]);
    visit(size, [&](const host::Rows& rows) {
        for (const host::Row row : rows) {
            const std::size_t first = ((std::size_t{row.w} * size[2] + row.z) * size[1] + row.y) * size[0];
            for (uint x = row.begin; x < row.end; ++x) ++seen[first + x];
        }
    });
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const std::size_t at[] = {i % size[0], i / size[0] % size[1], i / size[0] / size[1] % size[2],
                                  i / size[0] / size[1] / size[2]};
        ASSERT_EQ(seen[i], at[size.rank - 1] >= size.first) << "rank " << size.rank << ", first " << size.first;
    }
}

TEST(Parts, AreVisitedOnceAndNothingElse) {
    const std::array<std::uint32_t, 4> sizes[] = {{40000, 1, 1, 1}, {70, 40, 1, 1}, {33, 9, 40, 1}, {5, 7, 33, 4}};
    for (std::uint32_t rank = 1; rank <= 4; ++rank) {
        for (const std::uint32_t first : {0u, 1u, 3u, sizes[rank - 1][rank - 1]}) {
            HostSize size = sizes[rank - 1];
            size.rank = rank;
            size.first = first;
            cover_a_part(size, [](const HostSize& s, const auto& body) { host::for_rows(s, body); });
            cover_a_part(size, [](const HostSize& s, const auto& body) { host::for_runs(s, body); });
            if (rank == 1) continue;
            cover_a_part(size, [](const HostSize& s, const auto& body) { host::for_tiles<1>(s, body); });
            cover_a_part(size, [](const HostSize& s, const auto& body) { host::for_tiles<2>(s, body); });
        }
    }
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

/// A call over `size` elements that updates a buffer, whose updates are in memory when this ends.
template <class T, class Operation> struct Updated {
    Updated(std::vector<T>& elements, std::uint32_t size)
        : memory{reinterpret_cast<std::byte*>(elements.data()), elements.size() * sizeof(T), {}, {}, 0},
          call{nullptr, {&memory, 1}, {size, 1, 1, 1}}, copies(call, 0) {}
    Updated(const Updated&) = delete;
    ~Updated() { copies.finish(); }

    HostMemory memory;
    HostCall call;
    host::UpdateCopies<T, Operation> copies;
};

/// One page, some, more than a thread copies; so few updates that none is copied. The numbers are exact in floats.
TEST(Updates, AreAllMade) {
    for (const uint count : {1u, 100u, 5000u, 1u << 20, 1u << 22}) {
        for (const int updates : {10, 100'000}) {
            std::vector<float> sums(count), wanted(count);
            std::vector<std::int32_t> lows(count, 1000), wanted_lows(count, 1000);
            {
                Updated<float, host::Add> sums_of(sums, static_cast<std::uint32_t>(updates));
                Updated<std::int32_t, host::Min> lows_of(lows, static_cast<std::uint32_t>(updates));
                host::Updates add(sums_of.copies);
                host::Updates keep(lows_of.copies);
                uint random = 1;
                for (int i = 0; i < updates; ++i) {
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
}

TEST(Updates, OfSeveralTasksAreAllMade) {
    std::vector<uint> counts(1000);
    {
        Updated<uint, host::Add> updated(counts, 1'000'000);
        tbb::parallel_for(0, 100, [&](int task) {
            host::Updates updates(updated.copies);
            host::Updates inner(updated.copies);  // as in a task that another one waits for
            for (uint i = 0; i < 10'000; ++i)
                (i % 2 == 0 ? updates : inner).add((i + static_cast<uint>(task)) % 1000, 1);
        });
    }
    EXPECT_TRUE(std::ranges::all_of(counts, [](uint count) { return count == 1000; }));
}

/// Rows shorter and longer than the lanes, with elements that do not update.
TEST(Updates, OfARowAreCombined) {
    for (const std::uint32_t count : {1u, 2u, 63u, 255u, 256u, 257u, 1000u}) {
        std::vector<float> sums(3), lows(3, 10.0f);
        float wanted = 0;
        {
            Updated<float, host::Add> sums_of(sums, count);
            Updated<float, host::Min> lows_of(lows, count);
            host::Updates add(sums_of.copies);
            host::Updates keep(lows_of.copies);
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
        Updated<float, host::Min> least_of(least, 100);
        Updated<float, host::Max> greatest_of(greatest, 100);
        host::Updates low(least_of.copies);
        host::Updates high(greatest_of.copies);
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

/// What a row's elements combine to: NaN is left out, unless there is nothing else.
TEST(Updates, OfARowLeaveOutNaN) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const auto combined = [](auto row, std::initializer_list<float> values) {
        std::size_t lane = 0;
        for (const float value : values) row.add(0, lane++, value);
        return row.value();
    };
    const host::RowUpdate<float, host::Min> low(4);
    const host::RowUpdate<float, host::Max> high(4);
    EXPECT_EQ(combined(low, {nan, 3, -infinity, -nan}), -infinity);
    EXPECT_EQ(combined(high, {nan, 3, -infinity, -nan}), 3.0f);
    EXPECT_TRUE(std::isnan(combined(low, {nan, -nan})) && std::isnan(combined(high, {nan, -nan})));
    EXPECT_TRUE(std::signbit(combined(low, {0.0f, -0.0f})) && !std::signbit(combined(high, {0.0f, -0.0f})));
}

/// Each element once, in parts of as many elements or rows as are asked for.
TEST(Sums, HavePartsThatCoverEveryElementOnce) {
    for (const std::array<std::uint32_t, 4> size : {std::array{1u, 1u, 1u, 1u},
                                                    {5000u, 3u, 2u, 1u},
                                                    {3u, 130u, 5u, 1u},
                                                    {1030u, 2u, 65u, 1u},
                                                    {0u, 4u, 1u, 1u}}) {
        std::vector<std::atomic<int>> seen(std::size_t{size[0]} * size[1] * size[2]);
        const auto note = [&](const host::Rows& rows) {
            for (const host::Row row : rows)
                for (uint x = row.begin; x < row.end; ++x) ++seen[(std::size_t{row.z} * size[1] + row.y) * size[0] + x];
        };
        host::for_row_parts(size, 4096, note);
        host::for_column_parts<1>(size, 64, note);
        host::for_column_parts<2>(size, 64, note);
        EXPECT_TRUE(std::ranges::all_of(seen, [](const auto& count) { return count == 3; })) << size[0];
    }
}

/// Sums of columns and of all elements of a picture, with the memory in which their parts meet.
TEST(Sums, AreInMemoryWhenTheyAreFinished) {
    const std::array<std::uint32_t, 4> size = {3, 200, 1, 1};
    const SumOrder orders[] = {{2, 1, 64, 100}, {3, 0, 4096, 1000}};
    std::vector<float> columns(3), all(1);
    std::vector<uint> words(count_of(orders[0], size).words() + count_of(orders[1], size).words());
    EXPECT_EQ(words.size(), 3u * (2 + 4) + 1 * (2 + 200));
    const HostCall call{nullptr, {}, size};
    host::for_column_parts<1>(size, 64, [&](const host::Rows& rows) {
        host::ColumnSums<uint> sums(call, orders, 0, columns.data(), words.data(), rows);
        for (const host::Row row : rows)
            for (uint x = row.begin; x < row.end; ++x) sums.add(x, x, static_cast<float>(x + row.y));
    });
    host::for_row_parts(size, 4096, [&](const host::Rows& rows) {
        host::RowSums sums(call, orders, 1, all.data(), words.data());
        for (const host::Row row : rows) {
            sums.begin(row);
            host::RowUpdate<float, host::Add> part(row.end - row.begin);
            for (uint x = row.begin; x < row.end; ++x) part.add(0, x, static_cast<float>(x + row.y));
            part.finish(sums);
        }
    });
    EXPECT_EQ(columns, std::vector<float>(3));
    for (std::size_t number = 0; number < 2; ++number)
        host::PartialSums(call, orders, number, number == 0 ? columns.data() : all.data(), words.data()).finish();
    EXPECT_EQ(columns, (std::vector<float>{19900, 20100, 20300}));
    EXPECT_EQ(all[0], 60300.0f);
}

TEST(Atomics, CombineFloats) {
    float least = 3, sum = 0;
    host::atomic_min(least, 1.0f);
    host::atomic_min(least, 2.0f);
    tbb::parallel_for(0, 1000, [&](int) { host::atomic_add(sum, 1.0f); });
    EXPECT_EQ(least, 1.0f);
    EXPECT_EQ(sum, 1000.0f);
}
