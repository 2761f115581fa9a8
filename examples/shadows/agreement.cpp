#include "agreement.h"

#include "compare.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>

namespace {

constexpr std::array keys = {"rmsm", "asm", "standard"};

/// What was measured in a scene's frames so far, by method.
struct Found {
    std::array<std::vector<double>, 3> shares;
    std::array<std::size_t, 3> worst{};  ///< the frame with the lowest share
    std::array<picture::Picture, 3> pictures;
    std::size_t in_band = 0, pixels = 0;

    void add(const Compared& one, std::size_t frame, bool wants_pictures) {
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const double share = one.agreement[k].share();
            const bool is_worst = shares[k].empty() || share < shares[k][worst[k]];
            shares[k].push_back(share);
            if (!is_worst) continue;
            worst[k] = frame;
            if (wants_pictures) pictures[k] = together({one.by(k), one.by_rays(), one.differences(k)});
        }
        in_band += one.rmsm().in_band, pixels += one.rmsm().pixels;
    }
};

nlohmann::ordered_json frame_line(const std::string& scene, std::size_t frame, const Compared& one) {
    nlohmann::ordered_json line = {{"kind", "frame"}, {"scene", scene}, {"frame", frame}};
    for (std::size_t k = 0; k < keys.size(); ++k)
        line[keys[k]] = {{"share", one.agreement[k].share()}, {"different", one.agreement[k].different}};
    line["pixels"] = one.rmsm().pixels, line["in_band"] = one.rmsm().in_band;
    line["pages"] = one.pages[0].resident, line["refused"] = one.pages[0].refused;
    line["asm_pages"] = one.pages[1].resident, line["asm_refused"] = one.pages[1].refused;
    return line;
}

nlohmann::ordered_json scene_line(const std::string& scene, const Walk& walk, const glift::Device& device,
                                  const Found& found, double seconds) {
    nlohmann::ordered_json line = {{"kind", "scene"},
                                   {"scene", scene},
                                   {"device", device.properties().name},
                                   {"width", walk.size.x},
                                   {"height", walk.size.y},
                                   {"frames", found.shares[0].size()},
                                   {"levels", walk.settings.levels},
                                   {"standard_side", walk.settings.standard}};
    for (std::size_t k = 0; k < keys.size(); ++k) {
        line[keys[k]] = spread_of(found.shares[k]);
        line[keys[k]]["worst_frame"] = found.worst[k];
    }
    line["band"] = static_cast<double>(found.in_band) / static_cast<double>(found.in_band + found.pixels);
    line["seconds"] = seconds;
    return line;
}

}  // namespace

void measure_agreement(const Walk& walk, const std::string& json, const std::string& pictures) {
    JsonLines lines(json);
    if (!pictures.empty()) std::filesystem::create_directories(pictures);
    const glift::Device device = glift::Device::open();
    std::printf("%s, %u x %u: least, middle and mean share of pixels that decide as rays do, in %%\n\n"
                "| scene | frames | RMSM | ASM | standard | band | seconds |\n"
                "| --- | ---: | --- | --- | --- | ---: | ---: |\n",
                device.properties().name.c_str(), walk.size.x, walk.size.y);
    for (const std::string& scene : walk.scenes) {
        const auto start = std::chrono::steady_clock::now();
        Found found;
        walk.over(scene, device, [&](Frame& frame, std::size_t i) {
            const Compared one = compare(frame, walk.settings.bias);
            found.add(one, i, !pictures.empty());
            lines.add(frame_line(scene, i, one));
        });
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const nlohmann::ordered_json line = scene_line(scene, walk, device, found, seconds);
        lines.add(line);
        std::printf("| %s | %zu |", scene.c_str(), found.shares[0].size());
        for (const char* key : keys)
            std::printf(" %.4f, %.4f, %.4f |", 100 * line[key]["least"].get<double>(),
                        100 * line[key]["middle"].get<double>(), 100 * line[key]["mean"].get<double>());
        std::printf(" %.2f %% | %.1f |\n", 100 * line["band"].get<double>(), seconds);
        std::fflush(stdout);
        for (std::size_t k = 0; k < keys.size() && !pictures.empty(); ++k)
            picture::write(pictures + "/" + scene + "_" + keys[k] + ".png", found.pictures[k]);
    }
}
