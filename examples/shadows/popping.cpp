#include "popping.h"

#include "compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace {

constexpr std::array keys = {"rmsm", "asm", "standard"};

/// How the light of pixels changes from one frame to the next.
struct Changes {
    std::size_t pixels = 0;   ///< pixels that rays find lit, or shadowed, in both frames, outside the band
    std::size_t flipped = 0;  ///< those of `pixels` whose light changes by more than a half
    double largest = 0;       ///< largest change of light, 0 to 1
    double within = 0;        ///< 99.9 % of the pixels change by no more

    double share() const { return pixels == 0 ? 0 : static_cast<double>(flipped) / static_cast<double>(pixels); }
};

bool is_alike(const Compared& before, const Compared& now, std::size_t pixel) {
    const rays::Light light = now.reference.light[pixel];
    return light != rays::Light::unknown && light == before.reference.light[pixel] && !now.reference.at_edge[pixel] &&
           !before.reference.at_edge[pixel];
}

double change_of(const Compared& before, const Compared& now, std::size_t method, std::size_t pixel) {
    return std::abs(static_cast<double>(now.lighting[method].lit[pixel]) -
                    static_cast<double>(before.lighting[method].lit[pixel]));
}

Changes changes_of(const Compared& before, const Compared& now, std::size_t method) {
    std::vector<double> all;
    Changes changes;
    for (std::size_t i = 0; i < now.reference.light.size(); ++i) {
        if (!is_alike(before, now, i)) continue;
        all.push_back(change_of(before, now, method, i));
        changes.flipped += all.back() > 0.5;
    }
    changes.pixels = all.size();
    if (all.empty()) return changes;
    const auto at = all.begin() + static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(all.size() - 1));
    std::nth_element(all.begin(), at, all.end());
    changes.within = *at;
    changes.largest = *std::max_element(at, all.end());
    return changes;
}

/// Both frames, and the second one in grey with red where light changes by more than a half though rays say it does
/// not.
picture::Picture picture_of(const Compared& before, const Compared& now, std::size_t method) {
    picture::Picture changed{now.size.x, now.size.y, {}, {}};
    for (std::size_t i = 0; i < now.reference.light.size(); ++i) {
        const glift::float4 own = now.lighting[method].colours[i];
        const float grey = 0.35f * (own.x + own.y + own.z);
        const bool is_red = is_alike(before, now, i) && change_of(before, now, method, i) > 0.5;
        changed.pixels.push_back(is_red ? glift::float4(1, 0.1f, 0.05f, 1) : glift::float4(grey, grey, grey, 1));
    }
    return together({before.by(method), now.by(method), changed});
}

/// What was measured in a scene's pairs of frames so far, by one method.
struct Found {
    std::vector<double> shares, within, largest;
    std::size_t worst = 0;  ///< the second frame of the pair with the most changes
    picture::Picture picture;

    void add(const Compared& before, const Compared& now, std::size_t method, std::size_t frame, const Changes& changes,
             bool wants_picture) {
        const bool is_worst = shares.empty() || changes.share() > shares[worst - 1];
        shares.push_back(changes.share());
        within.push_back(changes.within);
        largest.push_back(changes.largest);
        if (!is_worst) return;
        worst = frame;
        if (wants_picture) picture = picture_of(before, now, method);
    }
    nlohmann::ordered_json json() const {
        return {{"flipped", spread_of(shares)},
                {"worst_frame", worst},
                {"within_999", spread_of(within)},
                {"largest", spread_of(largest)}};
    }
};

std::array<Found, 3> measure_scene(const Walk& walk, const std::string& scene, const glift::Device& device,
                                   JsonLines& lines, bool wants_pictures) {
    std::array<Found, 3> found;
    Compared before;
    walk.over(scene, device, [&](Frame& frame, std::size_t i) {
        Compared now = compare(frame, walk.settings.bias);
        nlohmann::ordered_json line = {{"kind", "pair"}, {"scene", scene}, {"frame", i}};
        for (std::size_t k = 0; k < keys.size() && i > 0; ++k) {
            const Changes changes = changes_of(before, now, k);
            found[k].add(before, now, k, i, changes, wants_pictures);
            line[keys[k]] = {{"flipped", changes.flipped},
                             {"share", changes.share()},
                             {"within_999", changes.within},
                             {"largest", changes.largest}};
            line["pixels"] = changes.pixels;
        }
        if (i > 0) lines.add(line);
        before = std::move(now);
    });
    return found;
}

}  // namespace

void measure_popping(const Walk& walk, const std::string& json, const std::string& pictures) {
    JsonLines lines(json);
    if (!pictures.empty()) std::filesystem::create_directories(pictures);
    const glift::Device device = glift::Device::open();
    std::printf("%s, %u x %u: pixels whose light changes by more than a half from a frame to the next where rays say "
                "that nothing does, in millionths: most, mean; and the change that 99.9 %% of the pixels stay within, "
                "in the worst pair\n\n| scene | pairs | RMSM | ASM | standard |\n| --- | ---: | --- | --- | --- |\n",
                device.properties().name.c_str(), walk.size.x, walk.size.y);
    for (const std::string& scene : walk.scenes) {
        const std::array<Found, 3> found = measure_scene(walk, scene, device, lines, !pictures.empty());
        if (found[0].shares.empty()) throw std::runtime_error(scene + ": its path has to have at least two frames");
        nlohmann::ordered_json line = {
            {"kind", "scene"},      {"scene", scene},        {"device", device.properties().name},
            {"width", walk.size.x}, {"height", walk.size.y}, {"pairs", found[0].shares.size()}};
        std::printf("| %s | %zu |", scene.c_str(), found[0].shares.size());
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const nlohmann::ordered_json own = line[keys[k]] = found[k].json();
            std::printf(" %.1f, %.1f; %.3f |", 1e6 * own["flipped"]["most"].get<double>(),
                        1e6 * own["flipped"]["mean"].get<double>(), own["within_999"]["most"].get<double>());
            if (!pictures.empty())
                picture::write(pictures + "/" + scene + "_" + keys[k] + "_popping.png", found[k].picture);
        }
        std::printf("\n");
        std::fflush(stdout);
        lines.add(line);
    }
}
