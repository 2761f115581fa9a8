// Shadow maps in a quadtree: what shadows.glift promises, on a small scene, on the host device and on Vulkan.
#include "shadow_scenes.h"

#include "tests/device/guards/on_every_device.h"

#include "examples/shadows/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace {

/// A page: its level, and its numbers along both axes.
using Page = std::array<std::uint32_t, 3>;

/// The page that a pixel asks for, if any. `s`: the place in the shadow map, from 0 to 1, in x and y, the level in w.
std::optional<Page> page_of(const glift::float4& s, const Settings& settings) {
    if (s.w < 0 || std::min(s.x, s.y) < 0 || std::max(s.x, s.y) >= 1) return {};
    const auto level = std::min(std::max(static_cast<std::uint32_t>(s.w), settings.finest), settings.levels - 1);
    const float side = static_cast<float>(settings.cells << (settings.levels - 1)),
                page = static_cast<float>(settings.cells << level);
    const auto number = [&](float at) { return static_cast<std::uint32_t>((at * side + 0.5f - 0.5f) / page); };
    return Page{level, number(s.x), number(s.y)};
}

/// The pages that some pixel asks for, if no level finer than `finest` may be used.
std::set<Page> pages_of(const Lighting& lighting, Settings settings, std::uint32_t finest) {
    settings.finest = finest;
    std::set<Page> wanted;
    for (const glift::float4& s : lighting.surface)
        if (const auto page = page_of(s, settings)) wanted.insert(*page);
    return wanted;
}

/// The first `most` of the pages of a level, row by row, that a frame without finer levels asks for.
std::set<Page> first_pages(const Lighting& lighting, const Settings& settings, std::uint32_t level, std::size_t most) {
    std::vector<Page> all;
    for (const Page& page : pages_of(lighting, settings, level))
        if (page[0] == level) all.push_back(page);
    std::ranges::sort(all, {}, [](const Page& page) { return std::pair(page[2], page[1]); });
    all.resize(std::min(most, all.size()));
    return {all.begin(), all.end()};
}

/// The owners of the pool's frames where these pages are resident: the pages' numbers plus one, and 0, the owner of a
/// frame without a page.
std::set<std::uint32_t> owners_of(const std::set<Page>& pages, const Settings& settings) {
    std::set<std::uint32_t> owners{0u};
    for (const auto& [level, x, y] : pages) {
        const std::uint32_t along = 1u << (settings.levels - 1 - level);
        owners.insert((along * along - 1) / 3 + y * along + x + 1);
    }
    return owners;
}

struct Shadows : OnEveryDevice {
    Frame frame(const Settings& settings) {
        Frame made(device, settings, {96, 64});
        made.set_scene(posts());
        return made;
    }
};

TEST_P(Shadows, AgreeWithRays) {
    for (const LightKind kind : {LightKind::directional, LightKind::spot, LightKind::point}) {
        Settings settings = small();
        settings.light = kind;
        if (kind == LightKind::point) settings.standard = 64;
        Frame some = frame(settings);
        if (kind == LightKind::point) some.set_scene(room());
        const Compared compared = compare(some, settings.bias);
        EXPECT_GT(compared.rmsm().pixels, 1500u) << static_cast<int>(kind);
        EXPECT_GT(compared.rmsm().in_band, 100u) << static_cast<int>(kind);
        EXPECT_GE(compared.rmsm().share(), 0.998) << static_cast<int>(kind);
        EXPECT_GE(compared.adaptive().share(), 0.99) << static_cast<int>(kind);
        EXPECT_LT(compared.standard().share(), compared.rmsm().share()) << static_cast<int>(kind);
        EXPECT_LT(compared.standard().share(), compared.adaptive().share()) << static_cast<int>(kind);
    }
}

/// Checks the directions beside the edges of a point light's cube.
TEST_P(Shadows, HaveNoSeamsAtTheEdgesOfACube) {
    Settings settings = small();
    settings.light = LightKind::point;
    Frame some = frame(settings);
    some.set_scene(room());
    const Compared compared = compare(some, settings.bias);
    std::set<int> faces;
    for (std::size_t i = 0; i < compared.reference.light.size(); ++i) {
        const glift::float4& s = compared.lighting[0].surface[i];
        if (s.w < 0) continue;
        const float x = 4 * s.x - std::floor(4 * s.x), y = 4 * s.y - std::floor(4 * s.y);
        faces.insert(static_cast<int>(4 * std::floor(4 * s.y) + std::floor(4 * s.x)));
        if (std::min({x, y, 1 - x, 1 - y}) > 0.02f || compared.reference.at_edge[i]) continue;
        EXPECT_EQ(is_lit(compared.lighting[0].lit[i]), compared.reference.light[i] == rays::Light::reached) << i;
    }
    EXPECT_THAT(faces, testing::ElementsAre(0, 1, 2, 3, 4, 5));
}

/// A point light and a spot at the same place: the faces of the cube point in other directions than the spot, but of
/// the pixels that the spot can light and that are not at the edge of a shadow, at most 1 in 500 has different light.
TEST_P(Shadows, OfAPointLightAreThoseOfASpot) {
    Settings settings = small();
    std::array<Compared, 2> found;
    for (const bool is_point : {false, true}) {
        settings.light = is_point ? LightKind::point : LightKind::spot;
        Frame some = frame(settings);
        found.at(is_point) = compare(some, settings.bias);
    }
    std::size_t both = 0, differ = 0;
    for (std::size_t i = 0; i < found[0].reference.light.size(); ++i) {
        if (found[0].reference.light[i] == rays::Light::unknown) continue;
        EXPECT_EQ(found[1].reference.light[i], found[0].reference.light[i]) << i;
        if (found[0].reference.at_edge[i] || found[1].reference.at_edge[i]) continue;
        ++both, differ += is_lit(found[0].lighting[0].lit[i]) != is_lit(found[1].lighting[0].lit[i]);
    }
    EXPECT_GT(both, 1500u);
    EXPECT_LE(differ, both / 500);
}

TEST_P(Shadows, AreOneSubmissionAFrame) {
    Settings settings = small();
    settings.light = LightKind::point;
    Frame directional = frame(small()), point = frame(settings);
    for (const auto& [frame, method] : {std::pair{&directional, Method::matched},
                                        {&directional, Method::adaptive},
                                        {&directional, Method::standard},
                                        {&point, Method::matched},
                                        {&point, Method::adaptive}}) {
        Frame& some = *frame;
        some.prepare(method);
        device.wait();
        const glift::Statistics before = device.statistics();
        some.submit(method);
        const glift::Statistics after = device.statistics();
        EXPECT_LE(after.submissions - before.submissions, 1u);
        EXPECT_EQ(after.waits, before.waits);
        if (method == Method::adaptive) {
            EXPECT_GT(some.rounds(), 1u);
        }  // more than one round: it has refined something
    }
}

TEST_P(Shadows, HaveTheSameDepthsByDrawsAndByAKernel) {
    // The numbers of passes differ, which shows that two ways were taken.
    const auto passes_of = [&](Frame& some) {
        some.prepare(Method::matched);
        device.wait();
        const std::uint64_t before = device.statistics().passes;
        some.submit(Method::matched);
        device.wait();
        return device.statistics().passes - before;
    };
    for (const std::uint32_t cells : {16u, 32u, 64u}) {
        Settings settings = small();
        settings.light = cells == 32 ? LightKind::point : LightKind::spot, settings.cells = cells;
        settings.by_kernel = false;
        Frame draws = frame(settings);
        settings.by_kernel = true;
        Frame kernel = frame(settings);
        EXPECT_NE(passes_of(draws), passes_of(kernel));
        const std::vector<std::uint32_t> owners = draws.owners();
        ASSERT_EQ(owners, kernel.owners());
        const std::vector<float> depths = kernel.depths_of_pages();
        EXPECT_TRUE(draws.depths_of_pages() == depths) << cells;
        EXPECT_TRUE(std::ranges::any_of(depths, [](float depth) { return depth > 0 && depth < 1; })) << cells;
    }
}

/// Other sizes of pages give the same light. Other filters change the pixels near the borders of shadows.
TEST_P(Shadows, AgreeByAllPagesAndFilters) {
    Settings settings = small();
    Frame first = frame(settings);
    first.draw(Method::matched);
    const Lighting usual = first.lighting();
    for (const auto& [cells, filter] : {std::pair{16u, Filter::bilinear},
                                        {64u, Filter::bilinear},
                                        {32u, Filter::nearest},
                                        {32u, Filter::trilinear}}) {
        settings.cells = cells, settings.filter = filter;
        settings.levels = cells == 16 ? 9 : cells == 64 ? 7 : 8;  // 4096 cells per side, whatever the size of a page
        Frame some = frame(settings);
        some.draw(Method::matched);
        const Lighting lighting = some.lighting();
        std::size_t differ = 0, between = 0;
        for (std::size_t i = 0; i < usual.lit.size(); ++i) {
            const glift::float4 own = lighting.surface[i], first = usual.surface[i];
            EXPECT_TRUE(own.x == first.x && own.y == first.y && own.z == first.z);
            EXPECT_EQ(std::min(own.w, 6.0f), std::min(first.w, 6.0f));  // the coarsest of seven levels
            differ += (lighting.lit[i] > 0.5f) != (usual.lit[i] > 0.5f);
            between += lighting.lit[i] > 0 && lighting.lit[i] < 1;
            if (filter == Filter::bilinear) {
                EXPECT_NEAR(lighting.lit[i], usual.lit[i], 1e-3) << cells << ' ' << i;
            }
        }
        EXPECT_LT(differ, filter == Filter::bilinear ? 1u : 200u);
        EXPECT_EQ(between == 0, filter == Filter::nearest);
    }
}

TEST_P(Shadows, HaveThePagesThatPixelsNeed) {
    for (const std::uint32_t step : {1u, 4u}) {
        Settings settings = small();
        settings.step = step;
        Frame some = frame(settings);
        some.draw(Method::matched);
        const Lighting lighting = some.lighting();
        std::set<Page> wanted;
        for (std::uint32_t y = 0; y < 64; y += step)
            for (std::uint32_t x = 0; x < 96; x += step)
                if (const auto page = page_of(lighting.surface[std::size_t{y} * 96 + x], settings))
                    wanted.insert(*page);
        EXPECT_EQ(some.pool().resident, wanted.size()) << step;
        EXPECT_GT(wanted.size(), 30u) << step;
    }
}

TEST_P(Shadows, DegradeWithTheirPool) {
    Settings settings = small();
    Frame whole = frame(settings);
    whole.draw(Method::matched);
    const std::uint32_t wanted = whole.pool().resident;
    for (const std::uint32_t part : {2u, 16u}) {
        settings.pages = wanted / part;
        Frame some = frame(settings);
        const Compared compared = compare(some, settings.bias);
        EXPECT_LE(some.pool().resident, settings.pages) << part;
        // Instead of a page that is coarser than the pixel needs and than the standard shadow map, that map is used.
        EXPECT_GE(compared.rmsm().share(), compared.standard().share().value() - 0.005) << part;
    }
}

/// If the pool is too small for the pages asked for, the finest level is made coarser until they fit. The room that is
/// left goes to the first pages, row by row, of the next finer level. Light changes only where a coarser page or the
/// standard map takes the place of a page.
TEST_P(Shadows, DegradeByCoarserLevelsAlone) {
    Settings settings = small();
    Frame whole = frame(settings);
    whole.draw(Method::matched);
    const Lighting usual = whole.lighting();
    whole.draw(Method::standard);
    const std::vector<float> standard = whole.lighting().lit;
    const auto wanted = static_cast<std::uint32_t>(pages_of(usual, settings, 0).size());
    for (const std::uint32_t part : {1u, 2u, 4u, 16u}) {
        settings.pages = wanted / part;
        std::uint32_t finest = 0;
        while (pages_of(usual, settings, finest).size() > settings.pages) ++finest;
        const std::uint32_t below = finest == 0 ? 0 : finest - 1;
        std::set<Page> expected = pages_of(usual, settings, finest), back;
        if (finest > 0) back = first_pages(usual, settings, below, settings.pages - expected.size());
        expected.insert(back.begin(), back.end());
        Frame some = frame(settings);
        some.draw(Method::matched);

        std::set<std::uint32_t> there{0u};
        for (const std::uint32_t owner : some.owners()) there.insert(owner);
        EXPECT_EQ(there, owners_of(expected, settings)) << part;
        std::uint32_t coarsened = 0;
        for (const Page& page : pages_of(usual, settings, 0)) coarsened += !expected.contains(page);
        const shadows::Status counts = some.counts();
        EXPECT_EQ(counts.asked, wanted) << part;
        EXPECT_EQ(counts.coarsened, coarsened) << part;
        EXPECT_EQ(counts.coarsened > 0, part > 1) << part;
        EXPECT_EQ(counts.pool.refused, 0u) << part;
        EXPECT_EQ(some.status().find("coarser ones in place of") != std::string::npos, part > 1) << some.status();

        // Frames with room for all their pages, whose finest level is `finest`, or `below`.
        std::array<Lighting, 2> coarser;
        for (const bool is_back : {false, true}) {
            Settings of_level = small();
            of_level.finest = is_back ? below : finest;
            Frame made = frame(of_level);
            made.draw(Method::matched);
            coarser.at(is_back) = made.lighting();
        }
        const Lighting lighting = some.lighting();
        EXPECT_TRUE(lighting.surface == usual.surface && lighting.slopes == usual.slopes &&
                    lighting.colours == usual.colours);
        Settings of_below = settings;
        of_below.finest = below;
        for (std::size_t i = 0; i < usual.lit.size(); ++i) {
            const auto page = page_of(usual.surface[i], settings);
            const auto raised = page_of(usual.surface[i], of_below);
            const bool is_back = raised && back.contains(*raised);
            const std::uint32_t level = is_back ? below : finest;
            const float cell =
                static_cast<float>(1u << level) / static_cast<float>(settings.cells << (settings.levels - 1));
            const float light = !page || (*page)[0] >= level                        ? usual.lit[i]
                                : cell * static_cast<float>(settings.standard) <= 1 ? coarser.at(is_back).lit[i]
                                                                                    : standard[i];
            ASSERT_NEAR(lighting.lit[i], light, 1e-3) << part << ' ' << i;
        }
    }
}

TEST_P(Shadows, StayWhereSceneAndLightDo) {
    Settings settings = small();
    settings.cached = true;
    Frame cached = frame(settings), anew = frame(small());
    const camera::Camera start = posts().view;
    for (unsigned i = 0; i < 4; ++i) {
        const camera::Camera view = camera::orbited(start, -0.05f * static_cast<float>(i), 0, 1);
        for (Frame* some : {&cached, &anew}) {
            some->set_view(view);
            some->draw(Method::matched);
        }
        if (i > 0) {
            EXPECT_LT(cached.pool().granted, anew.pool().resident / 2);
        }
        // Each pixel finds the page that it needs, with the same depths, with and without kept pages. But the page may
        // lie at another place in the pool, where coordinates are rounded differently.
        const std::vector<float> a = cached.lighting().lit, b = anew.lighting().lit;
        for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 1e-3) << i << ' ' << k;
    }
}

TEST_P(Shadows, SayWhatFoundNoRoom) {
    Settings settings = small();
    settings.pairs = 10;
    Frame some = frame(settings);
    some.draw(Method::matched);
    const auto error = [&]() -> std::string {
        try {
            return some.status();
        } catch (const std::exception& thrown) {
            return thrown.what();
        }
    }();
    EXPECT_THAT(error, testing::HasSubstr("--pairs"));
}

GLIFT_ON_EVERY_DEVICE(Shadows);

/// Expects the same pages at the same places in the pool, the same depths and the same light on both devices, bit for
/// bit.
TEST(ShadowsOnDevices, AreTheSame) {
    const char* vulkan = std::getenv("GLIFT_TEST_DEVICE");
    for (const LightKind kind : {LightKind::directional, LightKind::spot, LightKind::point}) {
        Settings settings = small();
        settings.light = kind;
        Frame host(glift::Device::open("host"), settings, {96, 64});
        Frame other(glift::Device::open(vulkan ? vulkan : "lavapipe"), settings, {96, 64});
        for (const Method method : {Method::matched, Method::adaptive}) {
            for (Frame* some : {&host, &other}) {
                some->set_scene(kind == LightKind::point ? all_of_room() : posts());
                some->draw(method);
            }
            EXPECT_TRUE(host.lighting().surface == other.lighting().surface);  // places in the map, and levels
            EXPECT_EQ(host.owners(), other.owners());
            EXPECT_TRUE(host.depths_of_pages() == other.depths_of_pages());
            EXPECT_EQ(host.lighting().lit, other.lighting().lit);
        }
        EXPECT_THAT(other.device().validation_messages(), testing::IsEmpty());
    }
}

}  // namespace
