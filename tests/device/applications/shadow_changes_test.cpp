// Shadow maps in a quadtree in unusual cases: lights from any direction, scenes that reach beyond the light's range,
// pools that are too small, and cached pages when the scene, the light or the method changes.
#include "shadow_scenes.h"

#include "tests/device/guards/on_every_device.h"

#include "examples/shadows/compare.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace {

using glift::float3;

constexpr std::array kinds = {LightKind::directional, LightKind::spot, LightKind::point};

struct ShadowChanges : OnEveryDevice {
    Frame frame(const Settings& settings, const scenes::Scene& scene) {
        Frame made(device, settings, {96, 64});
        made.set_scene(scene);
        return made;
    }
    void expect_agreement(const Settings& settings, const scenes::Scene& scene, const std::string& what) {
        Frame some = frame(settings, scene);
        const Compared compared = compare(some, settings.bias);
        EXPECT_GT(compared.rmsm().pixels, 1500u) << what;
        EXPECT_GE(compared.rmsm().share(), 0.998) << what;
        EXPECT_GE(compared.adaptive().share(), 0.99) << what;
        EXPECT_GE(compared.standard().share(), 0.9) << what;
    }
};

/// The numbers of the resident pages, counted from 1.
std::set<std::uint32_t> pages_in(const Frame& frame) {
    const std::vector<std::uint32_t> owners = frame.owners();
    std::set<std::uint32_t> pages(owners.begin(), owners.end());
    pages.erase(0u);  // stands for a frame of the pool without a page
    return pages;
}

void expect_same_light(const Frame& some, const Frame& other, const std::string& what) {
    const std::vector<float> a = some.lighting().lit, b = other.lighting().lit;
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 1e-3) << what << ' ' << i;
}

/// What lies beyond the light's far plane, or nearer than the near plane of a directional light (behind its eye, too),
/// is lit and shadowed like everything else.
TEST_P(ShadowChanges, ReachAsFarAsTheScene) {
    for (const LightKind kind : kinds) {
        Settings settings = small();
        settings.light = kind;
        scenes::Scene scene = posts();
        scene.light.far = 5;
        expect_agreement(settings, scene, "far " + std::to_string(static_cast<int>(kind)));
    }
    scenes::Scene scene = posts();
    scene.light.target = scene.light.eye * -2.0f, scene.light.eye = scene.light.eye * -1.0f;
    expect_agreement(small(), scene, "all of it behind the light");
}

TEST_P(ShadowChanges, MayComeFromStraightAbove) {
    for (const LightKind kind : kinds) {
        Settings settings = small();
        settings.light = kind;
        scenes::Scene scene = posts();
        scene.light.eye = float3(0, 6, 0);
        scene.view.eye = float3(0, 7, 0), scene.view.target = float3(0, 0, 0);
        expect_agreement(settings, scene, std::to_string(static_cast<int>(kind)));
    }
}

/// Narrow boards a little in front of a wall, far from a spot or point light: their depths differ from the wall's by a
/// small part of the light's range of depths.
TEST_P(ShadowChanges, OfWhatStandsOutALittleFarAway) {
    scenes::Scene scene = posts();
    scene.mesh = {};
    add_quad(scene.mesh, {-4, -4, 0}, {8, 0, 0}, {0, 8, 0});
    for (int i = 0; i < 12; ++i)
        add_quad(scene.mesh, {-4, -3.3f + 0.6f * static_cast<float>(i), 0.1f}, {8, 0, 0}, {0, 0.1f, 0});
    scene.view = {float3(0.3f, 0.4f, 5), float3(0, 0, 0), float3(0, 1, 0), 0.8f, 0.1f, 20};
    scene.light = {float3(4, 24, 32), float3(0, 0, 0), float3(0, 1, 0), 0.3f, 1, 120};
    for (const LightKind kind : {LightKind::spot, LightKind::point}) {
        Settings settings = small();
        settings.light = kind;
        settings.levels = kind == LightKind::point ? 10 : 8, settings.standard = 2048;
        expect_agreement(settings, scene, std::to_string(static_cast<int>(kind)));
    }
}

/// Whatever the size of the pool, adaptive shadow maps (ASM) end before the last round, report how many pages coarser
/// ones replace, and give each pixel the light that it has on some level or by the standard map.
TEST_P(ShadowChanges, OfAsmDegradeByCoarserLevelsAlone) {
    Settings settings = small();
    settings.rounds = 20;
    std::vector<std::vector<float>> by_level;
    for (std::uint32_t level = 0; level < settings.levels; ++level) {
        Settings of_level = settings;
        of_level.finest = level;
        Frame made = frame(of_level, posts());
        made.draw(Method::matched);
        by_level.push_back(made.lighting().lit);
    }
    Frame whole = frame(settings, posts());
    whole.draw(Method::standard);
    by_level.push_back(whole.lighting().lit);
    whole.draw(Method::adaptive);
    const shadows::Status all = whole.counts();
    EXPECT_EQ(all.asked, all.pool.resident);
    EXPECT_EQ(all.coarsened, 0u);
    for (const std::uint32_t part : {1u, 2u, 16u}) {
        settings.pages = all.asked / part;
        Frame some = frame(settings, posts());
        some.draw(Method::adaptive);
        const shadows::Status counts = some.counts();
        EXPECT_LT(counts.rounds, 10u) << part;
        EXPECT_EQ(counts.coarsened > 0, part > 1) << part;
        EXPECT_LE(counts.pool.resident, settings.pages) << part;
        EXPECT_EQ(some.status().find("coarser ones in place of") != std::string::npos, part > 1) << some.status();
        if (part == 1) {
            EXPECT_EQ(pages_in(some), pages_in(whole));
        }
        const std::vector<float> lit = some.lighting().lit;
        for (std::size_t i = 0; i < lit.size(); ++i)
            ASSERT_TRUE(std::ranges::any_of(by_level, [&](const auto& l) { return std::abs(l[i] - lit[i]) < 1e-3f; }))
                << part << ' ' << i << ' ' << lit[i];
        const Compared compared = compare(some, settings.bias);
        EXPECT_GE(compared.adaptive().share(), compared.standard().share().value() - 0.005) << part;
    }
}

/// After a change of the scene or the light, a frame that keeps pages (`cached`) has the light of one that is drawn
/// anew.
TEST_P(ShadowChanges, AreNotKeptWhereSceneOrLightMoves) {
    Settings settings = small();
    settings.cached = true;
    for (const Method method : {Method::matched, Method::adaptive}) {
        scenes::Scene scene = posts();
        Frame cached = frame(settings, scene);
        cached.draw(method);
        const auto change = [&](const std::string& what) {
            cached.set_scene(scene);
            cached.draw(method);
            Frame anew = frame(small(), scene);
            anew.draw(method);
            expect_same_light(cached, anew, what);
            cached.draw(method);
            EXPECT_EQ(cached.pool().granted, 0u) << what;  // nothing has changed: all pages are kept
        };
        scene.light.eye.x = -3;
        change("light");
        for (float3& point : scene.mesh.points) point.x += 0.1f * point.y;
        change("points");
        scene.light_half_size = 5;
        change("size");
    }
}

TEST_P(ShadowChanges, OfOneMethodDoNotUsePagesOfAnother) {
    Settings settings = small();
    settings.cached = true;
    Frame both = frame(settings, posts()), one = frame(settings, posts());
    both.draw(Method::matched);
    both.draw(Method::adaptive);
    one.draw(Method::adaptive);
    EXPECT_EQ(both.owners(), one.owners());
}

TEST_P(ShadowChanges, AreShownWhateverTheFinestLevel) {
    Settings settings = small();
    settings.light = LightKind::point;
    settings.finest = 1000;
    Frame some = frame(settings, room());
    some.draw(Method::matched);
    const picture::Picture levels = some.picture(View::levels);
    settings.finest = settings.levels - 1;  // the coarsest
    Frame coarsest = frame(settings, room());
    coarsest.draw(Method::matched);
    EXPECT_TRUE(levels.pixels == coarsest.picture(View::levels).pixels);
}

GLIFT_ON_EVERY_DEVICE(ShadowChanges);

}  // namespace
