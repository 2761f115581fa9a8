// The resident elements, listed from C++: compared with reads of boxes and with what requests and tables imply. Also
// boxes that lie across pages.
#include "resident.glift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ranges>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using glift::uint2;
using glift::uint3;

class Resident : public testing::TestWithParam<const char*> {
protected:
    const glift::Device& device() const { return device_; }

private:
    glift::Device device_ = glift::Device::open(GetParam());
};

resident::Grid grid_with(const glift::Device& device, const std::vector<uint3>& pages, std::uint32_t capacity = 20) {
    resident::Grid grid(device, {18, 9, 7}, capacity, -1.0f);
    resident::Places places(device, static_cast<std::uint32_t>(pages.size()));
    places.write(pages);
    resident::ask(device, places, grid);
    return grid;
}

/// Writes to each resident element of the field its row-major index.
void number(resident::Grid& grid) {
    std::vector<float> values(18 * 9 * 7);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
    grid.field().write(values);
}

TEST_P(Resident, PagesOfAField) {
    resident::Grid grid = grid_with(device(), {{1, 0, 2}, {4, 4, 3}, {0, 0, 0}});
    number(grid);
    const auto found = grid.field().read_resident();
    // Of the second page only 2 x 1 x 1 elements lie in the domain.
    ASSERT_EQ(found.size(), 16u + 2u + 16u);
    ASSERT_EQ(found.values.size(), found.size());
    const std::vector<float> all = grid.field().read();
    std::map<std::tuple<std::uint32_t, std::uint32_t>, int> places;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const uint3 at = found.addresses[i];
        const std::uint32_t index = (at.z * 9 + at.y) * 18 + at.x;
        EXPECT_EQ(found.values[i], static_cast<float>(index));
        EXPECT_EQ(all[index], found.values[i]);
        EXPECT_LT(found.places[i].y, 3u);
        ++places[{found.places[i].x, found.places[i].y}];
        if (i > 0) {
            const uint3 before = found.addresses[i - 1];
            EXPECT_LT((before.z * 9 + before.y) * 18 + before.x, index);
        }
    }
    EXPECT_EQ(places.size(), found.size());
    EXPECT_EQ(std::ranges::count(all, -1.0f), static_cast<std::ptrdiff_t>(all.size() - found.size()));
}

TEST_P(Resident, IsARange) {
    resident::Grid grid = grid_with(device(), {{1, 0, 2}, {0, 0, 0}});
    number(grid);
    auto found = grid.read_resident();
    static_assert(std::ranges::random_access_range<decltype(found)>);
    static_assert(std::ranges::random_access_range<const decltype(found)>);
    std::size_t elements = 0;
    for (const auto& [address, value] : found) {
        EXPECT_EQ(value, static_cast<float>((address.z * 9 + address.y) * 18 + address.x));
        ++elements;
    }
    EXPECT_EQ(elements, found.size());
    const auto last = std::ranges::max_element(found, {}, [](const auto& element) { return element.value; });
    EXPECT_EQ(last - found.begin(), static_cast<std::ptrdiff_t>(found.size()) - 1);
    EXPECT_EQ(std::ranges::count_if(std::as_const(found), [](const auto& e) { return e.address.z == 0; }), 8);
    for (const auto& [address, value] : found) value = 1.0f;
    EXPECT_EQ(found.values, std::vector<float>(found.size(), 1.0f));
}

TEST_P(Resident, BlocksAndBoxes) {
    resident::Grid grid = grid_with(device(), {{1, 0, 2}, {4, 4, 3}, {0, 0, 0}});
    number(grid);
    const resident::There there(device(), grid.field(), grid.pages().active(), grid.pages().residents());
    const auto whole = grid.field().read_resident(), by_blocks = there.read_resident();
    EXPECT_EQ(whole.addresses, by_blocks.addresses);
    EXPECT_EQ(whole.values, by_blocks.values);
    EXPECT_EQ(whole.places, by_blocks.places);
    const auto box = there.read_resident({2, 1, 0}, {4, 8, 6});
    EXPECT_EQ(box.addresses, grid.field().read_resident({2, 1, 0}, {4, 8, 6}).addresses);
    EXPECT_EQ(box.addresses.front(), (uint3{2, 1, 0}));
    EXPECT_EQ(box.size(), 2u * 1u * 2u + 2u * 1u * 2u);
    EXPECT_TRUE(there.read_resident({8, 4, 0}, {4, 4, 6}).empty());
    EXPECT_TRUE(there.read_resident({8, 4, 0}, {0, 4, 6}).empty());
}

TEST_P(Resident, NothingAndAll) {
    EXPECT_TRUE(grid_with(device(), {{99, 0, 0}}).field().read_resident().empty());
    EXPECT_TRUE(resident::Grid(device(), {0, 5, 5}, 3, 0.0f).field().read_resident().empty());
    resident::Plane plane(device(), {3, 2});
    plane.write(std::vector<float>{1, 2, 3, 4, 5, 6});
    const auto found = plane.read_resident({1, 0}, {2, 2});
    EXPECT_EQ(found.addresses, (std::vector<uint2>{{1, 0}, {2, 0}, {1, 1}, {2, 1}}));
    EXPECT_EQ(found.values, (std::vector<float>{2, 3, 5, 6}));
    EXPECT_TRUE(found.places.empty());
}

TEST_P(Resident, HolesAndBlocksOfTheHost) {
    resident::Holes holes(device(), 10);
    const auto found = holes.read_resident();
    EXPECT_EQ(found.addresses, (std::vector<std::uint32_t>{0, 3, 6, 9}));
    EXPECT_EQ(found.places, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    resident::Line line(device(), 48);
    std::vector<std::uint32_t> values(48);
    for (std::uint32_t i = 0; i < 48; ++i) values[i] = 100 + i;
    line.write(values);
    const auto some = resident::Stripes(device(), line).read_resident();
    ASSERT_EQ(some.size(), 24u);
    for (std::uint32_t i = 0; i < 24; ++i) {
        EXPECT_EQ(some.addresses[i], i / 8 * 16 + 8 + i % 8);
        EXPECT_EQ(some.values[i], 100 + some.addresses[i]);
        EXPECT_EQ(some.places[i], some.addresses[i]);
    }
}

TEST_P(Resident, StructsAndImages) {
    resident::Line table(device(), 6);
    table.write(
        std::vector<std::uint32_t>{0, 2, 0, 1, 0, 9});  // of 3 x 2 pages; the last entry is of a frame beyond the pool
    resident::Cells cells(device(), table, {11, 8}, 2, {-1.0f, 0, {}});
    cells.fill({0.5f, 7, {1, 2}});
    const auto found = cells.read_resident();
    ASSERT_EQ(found.size(), 32u);
    EXPECT_EQ(found.addresses[0], (uint2{4, 0}));
    EXPECT_EQ(found.places[0], (uint2{0, 1}));
    EXPECT_EQ(found.values[31], (resident::Cell{0.5f, 7, {1, 2}}));
    const resident::Texels texels(device(), 2);
    resident::InImage image(device(), table, texels, {11, 8}, -1.0f);
    image.fill(2.5f);
    const auto texel = image.read_resident();
    EXPECT_EQ(texel.addresses, found.addresses);
    EXPECT_EQ(texel.values, std::vector<float>(32, 2.5f));
}

TEST_P(Resident, TablesOfTwoLevelsAndOfAHash) {
    resident::Two two(device(), {100, 60}, 12, 5u);
    resident::Places2 places(device(), 3);
    places.write(std::vector<uint2>{{24, 14}, {0, 0}, {7, 3}});
    resident::ask(device(), places, two);
    const auto found = two.field().read_resident();
    ASSERT_EQ(found.size(), 48u);
    EXPECT_EQ(found.addresses.back(), (uint2{99, 59}));
    EXPECT_EQ(two.table().read_resident().size(), 8u + 8u + 7u);  // pages of 8 entries; the table ends within the last
    resident::Hashed hashed(device(), 8, 1.5f);
    places.write(std::vector<uint2>{{500000000, 3}, {0, 0}, {7, 400000000}});
    resident::ask(device(), places, hashed);
    const auto far = hashed.field().read_resident();
    ASSERT_EQ(far.size(), 3u * 64u);
    EXPECT_EQ(far.addresses.front(), (uint2{0, 0}));
    EXPECT_EQ(far.addresses.back(), (uint2{63, 3200000007}));
    EXPECT_EQ(far.values, std::vector<float>(192, 1.5f));
}

/// Boxes that lie across pages, some of which are not resident: written, filled, copied and read by one submission
/// each.
TEST_P(Resident, BoxesAcrossPages) {
    resident::Grid grid = grid_with(device(), {{0, 0, 0}, {1, 1, 1}, {2, 1, 1}}),
                   other = grid_with(device(), {{1, 1, 1}, {2, 1, 1}, {2, 0, 0}});
    number(grid);
    device().wait();
    const auto once = [&](const auto& work) {
        const std::uint64_t before = device().statistics().submissions;
        work();
        device().wait();
        EXPECT_LE(device().statistics().submissions - before, 1u);  // the host device has none
    };
    const uint3 origin{1, 1, 1}, size{10, 3, 2};
    std::vector<float> found, values(10 * 3 * 2, 7.0f);
    once([&] { grid.field().write(origin, size, values); });
    once([&] { other.field().copy_from(grid.field().range(origin, size), origin); });
    once([&] { found = other.field().read(origin, size); });
    EXPECT_EQ(std::ranges::count(found, 7.0f), 7 * 2);  // pages {1, 1, 1} and {2, 1, 1}: x 4 to 10, y 2 and 3, z 2
    EXPECT_EQ(std::ranges::count(found, -1.0f) + std::ranges::count(found, 7.0f) + std::ranges::count(found, 0.0f),
              static_cast<std::ptrdiff_t>(found.size()));
    once([&] { grid.field().fill(3.0f, grid.field().range({3, 2, 2}, {3, 2, 1})); });
    EXPECT_EQ(grid.field().read({3, 2, 2}, {3, 2, 1}), (std::vector<float>{-1, 3, 3, -1, 3, 3}));
    // A box of one page, and one over all pages: what is not resident stays the background.
    grid.field().map({4, 2, 2}, {4, 2, 2})[{1, 1, 1}] = 11.0f;
    EXPECT_EQ(grid.field().read({5, 3, 3}, {1, 1, 1}), std::vector<float>{11.0f});
    {
        auto mapped = grid.field().map({0, 0, 0}, {18, 9, 7});
        EXPECT_EQ((mapped[{5, 3, 3}]), 11.0f);
        mapped[{5, 3, 3}] = 12.0f;
        mapped[{17, 8, 6}] = 12.0f;
    }
    EXPECT_EQ(grid.field().read({5, 3, 3}, {1, 1, 1}), std::vector<float>{12.0f});
    EXPECT_EQ(grid.field().read({17, 8, 6}, {1, 1, 1}), std::vector<float>{-1.0f});
}

/// A box of 2^30 elements, of which three parts are accessed: these move, and of them the one that changes goes back.
TEST_P(Resident, MapsWhatIsAccessed) {
    resident::Two grid(device(), {32768, 32768}, 8, 1);
    grid.request_box(device(), {20000, 10000}, {20004, 10004});
    grid.request_box(device(), {0, 0}, {1, 1});
    grid.allocate(device());
    const uint2 page{20000, 10000};
    const auto element = [&](uint2 address) { return grid.read(address, {1, 1})[0]; };
    grid.write(page, {4, 4}, std::vector<std::uint32_t>(16, 3));
    {
        auto mapped = grid.map();
        EXPECT_EQ(mapped.size(), grid.domain());
        EXPECT_EQ(mapped[page], 3u);
        EXPECT_EQ((mapped[{1, 1}]), 1u);
        EXPECT_EQ((mapped[{32767, 32767}]), 1u);
        mapped[page] = 5;
        mapped[{20003, 10001}] += 1;
        mapped[{32767, 32767}] = 7;  // not resident: lost
        EXPECT_EQ(mapped[page], 5u);
        EXPECT_EQ(element(page), 3u);
    }
    EXPECT_EQ(element(page), 5u);
    EXPECT_EQ(element({20003, 10001}), 4u);
    EXPECT_EQ(element({32767, 32767}), 1u);
    // A box whose origin is inside a page, moved from, and unmapped.
    auto mapped = grid.map({20001, 10001}, {100, 17});
    auto moved = std::move(mapped);
    moved[{2, 1}] = 9;
    moved.unmap();
    EXPECT_EQ(element({20003, 10002}), 9u);
    const auto refuses = [](const std::string& with, const auto& call) {
        try {
            call();
            ADD_FAILURE() << with;
        } catch (const glift::Error& error) {
            EXPECT_NE(std::string(error.what()).find(with), std::string::npos) << error.what();
        }
    };
    refuses("no longer mapped", [&] { moved[{0, 0}] = 1; });
    refuses("no longer mapped", [&] { mapped[{0, 0}] = 1; });
    refuses("outside a mapped box", [&] { grid.map({0, 0}, {4, 4})[{0, 4}] = 1; });
    refuses("lies outside its domain", [&] { grid.map({32768, 0}, {1, 1}); });
    refuses("::map", [&] { device().record([&](const glift::Commands&) { grid.map(); }); });
}

TEST_P(Resident, RefusesWhatCannotBe) {
    resident::Grid grid = grid_with(device(), {{1, 0, 2}});
    const auto fails = [](const std::string& with, const auto& call) {
        try {
            call();
            ADD_FAILURE() << with;
        } catch (const glift::Error& error) {
            EXPECT_NE(std::string(error.what()).find(with), std::string::npos) << error.what();
        }
    };
    fails("read_resident", [&] { grid.field().read_resident({10, 0, 0}, {9, 1, 1}); });
    fails("read_resident", [&] { device().record([&](const glift::Commands&) { grid.field().read_resident(); }); });
    const resident::Line table(device(), 1);
    const resident::Field large(device(), table, {65535, 65535, 17}, 1, 0.0f);
    fails("ListedPages", [&] { large.read_resident(); });
    EXPECT_TRUE(large.read_resident({0, 0, 0}, {65535, 9, 1}).empty());
}

INSTANTIATE_TEST_SUITE_P(, Resident, testing::Values("host", "lavapipe"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
