#include "agreement.h"

#include "compare.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>

namespace {

constexpr std::array keys = {"rmsm", "asm", "standard"};

/// What was measured in a scene's frames so far, by method.
struct Found {
    std::array<std::vector<double>, 3> shares;  ///< of the pixels, for each frame that has pixels to compare
    std::size_t frames = 0;
    std::array<std::uint32_t, 2>
        coarsened{};                     ///< RMSM, ASM: pages with coarser ones in their place, maximum over frames
    std::array<std::size_t, 3> worst{};  ///< the frame with the lowest share
    std::array<picture::Picture, 3> pictures;
    std::size_t in_band = 0, pixels = 0;

    void add(const Compared& one, std::size_t frame, bool wants_pictures) {
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const std::optional<double> share = one.agreement[k].share();
            if (!share) continue;
            const bool is_worst = shares[k].empty() || *share < *std::ranges::min_element(shares[k]);
            shares[k].push_back(*share);
            if (!is_worst) continue;
            worst[k] = frame;
            if (wants_pictures) pictures[k] = together({one.by(k), one.by_rays(), one.differences(k)});
        }
        for (std::size_t k = 0; k < coarsened.size(); ++k)
            coarsened[k] = std::max(coarsened[k], one.counts[k].coarsened);
        in_band += one.rmsm().in_band, pixels += one.rmsm().pixels, ++frames;
    }
};

/// The value as JSON; null if there is none.
nlohmann::ordered_json number_of(const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

nlohmann::ordered_json frame_line(const std::string& scene, std::size_t frame, const Compared& one) {
    nlohmann::ordered_json line = {{"kind", "frame"}, {"scene", scene}, {"frame", frame}};
    for (std::size_t k = 0; k < keys.size(); ++k)
        line[keys[k]] = {{"share", number_of(one.agreement[k].share())}, {"different", one.agreement[k].different}};
    line["pixels"] = one.rmsm().pixels, line["in_band"] = one.rmsm().in_band;
    line["pages"] = one.counts[0].pool.resident, line["coarsened"] = one.counts[0].coarsened;
    line["asm_pages"] = one.counts[1].pool.resident, line["asm_coarsened"] = one.counts[1].coarsened;
    return line;
}

nlohmann::ordered_json scene_line(const std::string& scene, const Walk& walk, const glift::Device& device,
                                  const Found& found, double seconds) {
    nlohmann::ordered_json line = {{"kind", "scene"},
                                   {"scene", scene},
                                   {"device", device.properties().name},
                                   {"width", walk.size.x},
                                   {"height", walk.size.y},
                                   {"frames", found.frames},
                                   {"levels", walk.settings.levels},
                                   {"standard_side", walk.settings.standard}};
    for (std::size_t k = 0; k < keys.size(); ++k) {
        if (found.shares[k].empty()) continue;
        line[keys[k]] = spread_of(found.shares[k]);
        line[keys[k]]["worst_frame"] = found.worst[k];
    }
    line["band"] = static_cast<double>(found.in_band) /
                   static_cast<double>(std::max<std::size_t>(found.in_band + found.pixels, 1));
    line["coarsened"] = found.coarsened[0], line["asm_coarsened"] = found.coarsened[1];
    line["seconds"] = seconds;
    return line;
}

/// Prints a scene's row of the table.
void print_row(const nlohmann::ordered_json& line) {
    std::printf("| %s | %d |", line["scene"].get<std::string>().c_str(), line["frames"].get<int>());
    for (const char* key : keys) {
        if (line.contains(key))
            std::printf(" %.4f, %.4f, %.4f |", 100 * line[key]["least"].get<double>(),
                        100 * line[key]["middle"].get<double>(), 100 * line[key]["mean"].get<double>());
        else std::printf(" nothing to compare |");
    }
    std::printf(" %.2f %% | %d, %d | %.1f |\n", 100 * line["band"].get<double>(), line["coarsened"].get<int>(),
                line["asm_coarsened"].get<int>(), line["seconds"].get<double>());
    std::fflush(stdout);
}

}  // namespace

void measure_agreement(const Walk& walk, const std::string& json, const std::string& pictures) {
    JsonLines lines(json);
    if (!pictures.empty()) std::filesystem::create_directories(pictures);
    const glift::Device device = glift::Device::open();
    std::printf("%s, %u x %u: least, middle and mean share of pixels that decide as rays do, in %%\n\n"
                "| scene | frames | RMSM | ASM | standard | band | coarser pages, RMSM, ASM | seconds |\n"
                "| --- | ---: | --- | --- | --- | ---: | --- | ---: |\n",
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
        print_row(line);
        for (std::size_t k = 0; k < keys.size() && !pictures.empty(); ++k)
            if (!found.shares[k].empty())
                picture::write(pictures + "/" + scene + "_" + keys[k] + ".png", found.pictures[k]);
    }
}
