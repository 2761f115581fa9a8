// The moving shell of examples/narrow_band, compared with a dense computation on the host: at each step how many pages
// are resident and were allocated; at some steps which pages, and every element of both fields, bit for bit. Steps are
// replays of one recording.
#include "property.h"

#include "moving_shell.glift.hpp"

#include <cmath>
#include <cstdlib>
#include <set>

namespace {

using glift::uint3;
using property::Round;

GLIFT_PROPERTY_SUITE(MovingBand);

constexpr std::uint32_t side = 64, page = 8, along = side / page, pages = along * along * along;
constexpr float background = 1.5f;

struct Dense {
    std::vector<float> now = std::vector<float>(side * side * side, background), next = now;
    std::set<std::uint32_t> there;
    std::size_t came = 0, went = 0;  ///< pages that were allocated and released, in all changes
    std::uint32_t granted = 0;       ///< pages that were allocated in the last change

    static std::size_t index(std::uint32_t x, std::uint32_t y, std::uint32_t z) { return (z * side + y) * side + x; }
    static std::uint32_t page_of(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        return (z / page * along + y / page) * along + x / page;
    }
    static bool is_wanted(std::uint32_t number, std::uint32_t step, float radius) {
        const auto from_middle = [](std::uint32_t p) { return static_cast<float>(p * page + page / 2) - side / 2.0f; };
        const float x = from_middle(number % along), y = from_middle(number / along % along),
                    z = from_middle(number / along / along);
        const float r = radius + 0.5f * static_cast<float>(std::abs(static_cast<int>(step % 64) - 32));
        return std::abs(std::sqrt(x * x + y * y + z * z) - r) < 9.6f;
    }

    template <class Visit> static void for_page(std::uint32_t number, const Visit& visit) {
        const std::uint32_t x = number % along * page, y = number / along % along * page,
                            z = number / along / along * page;
        for (std::uint32_t i = 0; i < page * page * page; ++i)
            visit(x + i % page, y + i / page % page, z + i / page / page);
    }

    void change(std::uint32_t step, float radius) {
        granted = 0;
        for (std::uint32_t number = 0; number < pages; ++number) {
            const bool wanted = is_wanted(number, step, radius), was = there.count(number) != 0;
            if (wanted == was) continue;
            for_page(number, [&](auto x, auto y, auto z) { now[index(x, y, z)] = next[index(x, y, z)] = background; });
            if (wanted) there.insert(number), ++came, ++granted;
            else there.erase(number), ++went;
        }
    }

    void number() {
        for (const std::uint32_t one : there)
            for_page(one, [&](auto x, auto y, auto z) {
                now[index(x, y, z)] =
                    static_cast<float>(x % 16) + 0.5f * static_cast<float>(y % 32) - static_cast<float>(z % 8);
            });
    }

    static float at(const std::vector<float>& field, std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        return x < side && y < side && z < side ? field[index(x, y, z)] : background;
    }

    void diffuse(const std::vector<float>& f, std::vector<float>& to) const {
        for (const std::uint32_t one : there)
            for_page(one, [&](auto x, auto y, auto z) {
                const float beside = at(f, x + 1, y, z) + at(f, x - 1, y, z) + at(f, x, y + 1, z) + at(f, x, y - 1, z) +
                                     at(f, x, y, z + 1) + at(f, x, y, z - 1);
                to[index(x, y, z)] = 0.5f * f[index(x, y, z)] + 0.0833333358f * beside;
            });
    }

    void step(std::uint32_t number, float radius) {
        change(number, radius);
        diffuse(now, next);
        diffuse(next, now);
    }
};

/// Each step is one submission without a wait. Pages that stay keep their values; new pages have the background value.
TEST_P(MovingBand, IsWhatADenseFieldIs) {
    struct Case {
        float radius;
        std::uint32_t steps;
    };
    // First a sphere that stays inside the domain, for a whole period; then one that the domain's faces cut. The shell
    // around either may reach beyond the domain.
    for (const auto& [radius, steps] : {Case{12, 66}, Case{0.39f * side, 27}}) {
        Round round("moving band", 1);
        Dense dense;
        band::Band band(device(), {side, side, side}, pages, {background, background});
        moving_shell::Clock clock(device(), 1);
        moving_shell::begin(device(), band, clock, radius);
        dense.change(0, radius);
        dense.number();
        const auto step = device().record(
            [&](const glift::Commands& commands) { moving_shell::step(commands, band, clock, radius); });
        for (std::uint32_t number = 0; number < steps; ++number) {
            device().wait();
            const glift::Statistics before = device().statistics();
            step.submit();
            EXPECT_LE(device().statistics().submissions - before.submissions, 1u);  // the host device has none
            EXPECT_EQ(device().statistics().waits - before.waits, 0u);
            dense.step(number, radius);
            const auto status = band.status(device());
            ASSERT_EQ(status.resident, dense.there.size()) << "step " << number;
            ASSERT_EQ(status.granted, dense.granted) << "step " << number;
            ASSERT_EQ(status.refused, 0u);
            if (number % 13 != 0) continue;
            std::vector<std::uint32_t> active = band.pages().active().read();
            active.resize(status.resident);
            ASSERT_TRUE(property::equal(round, {dense.there.begin(), dense.there.end()}, active, "pages"));
            std::vector<float> now, next;
            for (const band::Cell& cell : band.read()) {
                now.push_back(cell.now);
                next.push_back(cell.next);
            }
            ASSERT_TRUE(property::equal(round, dense.now, now, "now"));
            ASSERT_TRUE(property::equal(round, dense.next, next, "next"));
        }
        EXPECT_GT(dense.came, pages / 4);
        EXPECT_GT(dense.went, pages / 8);
    }
}

}  // namespace
