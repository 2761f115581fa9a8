#include "shadow_cases.h"

#include "median.h"

#include <algorithm>
#include <tuple>

namespace bench {

namespace {

/// Draws a case frame by frame along a path, with structures of its own.
class Along {
public:
    Along(const glift::Device& device, const ShadowCase& one, const std::vector<scenes::Scene>& scenes,
          glift::uint2 size)
        : one_(one), scenes_(scenes), frame_(device, one.settings, size) {}

    std::size_t frames() const { return scenes_.size(); }
    Frame& frame() { return frame_; }

    /// Prepares frame i. A static case keeps the scene of frame 0, and its pages: only the camera moves.
    void go_to(std::size_t i) {
        if (!one_.is_static || i == 0) frame_.set_scene(scenes_[i]);
        else frame_.set_view(scenes_[i].view);
        frame_.prepare(one_.method);
        frame_.device().wait();
    }
    void submit() { frame_.submit(one_.method); }
    double seconds() {
        const glift::Commands commands = frame_.device().commands();
        const glift::Timestamp before = commands.timestamp();
        submit();
        const glift::Timestamp after = commands.timestamp();
        frame_.device().wait();
        return after - before;
    }

private:
    const ShadowCase& one_;
    const std::vector<scenes::Scene>& scenes_;
    Frame frame_;
};

std::uint32_t first_of_level(std::uint32_t levels, std::uint32_t level) {
    return ((1u << 2 * (levels - 1 - level)) - 1) / 3;
}

/// Which texels of the resident pages the pixels of a frame look up. Each pixel counts as looking up the 2 x 2 texels
/// around its place in the map, whatever the filter; with the trilinear filter, those of two levels.
class Touched {
public:
    Touched(const Frame& frame, const ShadowCase& one) : one_(one), side_(one.settings.cells + 1) {
        const std::vector<std::uint32_t> owners = frame.owners();
        const std::uint32_t levels = one.settings.levels;
        frame_of_.resize(first_of_level(levels, 0) + (1u << 2 * (levels - 1)));
        for (std::uint32_t i = 0; i < owners.size(); ++i)
            if (owners[i] > 0) frame_of_[owners[i] - 1] = i + 1, ++pages_;
        texels_.resize(owners.size() * side_ * side_);
        const Lighting lighting = frame.lighting();
        for (const glift::float4& s : lighting.surface) {
            if (s.w < 0) continue;
            const auto level = std::max(static_cast<std::uint32_t>(s.w), one.settings.finest);
            look_up(s, level);
            if (one.settings.filter == Filter::trilinear) look_up(s, level + 1);
        }
    }
    double share() const {
        const auto touched = static_cast<double>(std::count(texels_.begin(), texels_.end(), 1));
        return pages_ == 0 ? 0 : touched / (static_cast<double>(pages_) * side_ * side_);
    }

private:
    /// Marks the texels that a pixel looks up in its page of this level or, if that is not resident, in the finest
    /// resident page of a coarser level. Marks none if the standard map is finer than that coarser level: the shader
    /// then reads the standard map.
    void look_up(const glift::float4& s, std::uint32_t level) {
        const std::uint32_t levels = one_.settings.levels;
        const std::uint32_t wanted = std::min(level, levels - 1);
        for (std::uint32_t l = wanted; l < levels; ++l) {
            const std::uint32_t pages = 1u << (levels - 1 - l), nodes = one_.settings.cells * pages;
            if (l > wanted && nodes < one_.settings.standard) return;
            const auto x = static_cast<std::uint32_t>(s.x * static_cast<float>(nodes)),
                       y = static_cast<std::uint32_t>(s.y * static_cast<float>(nodes));
            if (x >= nodes || y >= nodes) return;
            const std::uint32_t at =
                frame_of_[first_of_level(levels, l) + y / one_.settings.cells * pages + x / one_.settings.cells];
            if (at == 0) continue;
            const std::size_t first = (std::size_t{at} - 1) * side_ * side_ +
                                      std::size_t{y % one_.settings.cells} * side_ + x % one_.settings.cells;
            for (const std::size_t i : {first, first + 1, first + side_, first + side_ + 1}) texels_[i] = 1;
            return;
        }
    }

    const ShadowCase& one_;
    std::uint32_t side_;
    std::size_t pages_ = 0;
    std::vector<std::uint32_t> frame_of_;  ///< for each page, the number of its frame in the pool + 1; 0: none
    std::vector<char> texels_;
};

void note_pages(Along& along, const ShadowCase& one, ShadowFrames& found) {
    std::ignore = along.frame().status();  // throws if depths are missing
    const shadows::Status counts = along.frame().counts();
    found.pages.push_back(counts.pool.resident), found.granted.push_back(counts.pool.granted);
    found.refused.push_back(counts.pool.refused), found.asked.push_back(counts.asked);
    found.coarsened.push_back(counts.coarsened), found.rounds.push_back(counts.rounds);
    found.capacity = counts.pool.capacity;
    found.texels_a_page = std::uint64_t{one.settings.cells + 1} * (one.settings.cells + 1);
}

/// For each pass of a frame's submission, the mean of its times over the frames; all frames have the same passes. In a
/// moving case each frame is submitted twice, and the second submission counts; in a static case each frame is
/// submitted once, and the first frame does not count.
std::vector<PassTime> passes_of(const glift::Device& device, const ShadowCase& one,
                                const std::vector<scenes::Scene>& scenes, glift::uint2 size) {
    PassTimer timer(device);
    std::vector<PassTime> sums;
    unsigned number = 0;
    {
        Along along(timer.device(), one, scenes, size);
        for (std::size_t i = 0; i < along.frames(); ++i) {
            along.go_to(i);
            for (const bool counts : {false, true}) {
                if (one.is_static && !counts) continue;  // in a second submission, all pages would be there
                std::ignore = timer.passes();
                along.submit();
                const std::vector<PassTime> passes = timer.passes();
                if (!counts || (one.is_static && i == 0)) continue;
                ++number;
                sums.resize(std::max(sums.size(), passes.size()));
                for (std::size_t k = 0; k < passes.size(); ++k)
                    sums[k] = {passes[k].name, sums[k].seconds + passes[k].seconds};
            }
        }
    }
    for (PassTime& pass : sums) pass.seconds /= std::max(number, 1u);
    return sums;
}

}  // namespace

std::vector<ShadowCase> shadow_cases(const Settings& settings) {
    std::vector<ShadowCase> cases;
    const auto add = [&](const std::string& name, Method method, const auto& change) -> ShadowCase& {
        ShadowCase& one = cases.emplace_back(ShadowCase{name, method, settings});
        change(one.settings);
        return one;
    };
    const auto as_it_is = [](Settings&) {};
    const auto cached = [](Settings& s) { s.cached = true; };
    add("standard", Method::standard, as_it_is);
    add("asm", Method::adaptive, as_it_is);
    add("rmsm", Method::matched, as_it_is);
    add("standard static", Method::standard, cached).is_static = true;
    add("asm static", Method::adaptive, cached).is_static = true;
    add("rmsm static", Method::matched, cached).is_static = true;
    add("rmsm analysis 2", Method::matched, [](Settings& s) { s.step = 2; });
    add("rmsm analysis 4", Method::matched, [](Settings& s) { s.step = 4; });
    add("rmsm analysis 8", Method::matched, [](Settings& s) { s.step = 8; });
    add("rmsm trilinear", Method::matched, [](Settings& s) { s.filter = Filter::trilinear; });
    const auto nearest = [](Settings& s) { s.filter = Filter::nearest; };
    add("rmsm nearest", Method::matched, nearest);
    add("standard nearest", Method::standard, nearest);
    add("rmsm by draws", Method::matched, [](Settings& s) { s.by_kernel = false; });
    for (const unsigned cells : {16u, 64u}) {
        const std::string name = "rmsm pages of " + std::to_string(cells);
        // As many texels along the map as with pages of 32, and about as many in the pool.
        add(name, Method::matched, [&](Settings& s) {
            s.cells = cells;
            s.levels = cells == 16 ? settings.levels + 1 : settings.levels - 1;
            s.seed = cells == 16 ? settings.seed + 1 : settings.seed - 1;
            s.pages = cells == 16 ? 4 * settings.pages : settings.pages / 4;
        });
    }
    return cases;
}

std::vector<scenes::Scene> scenes_along(const std::string& name, const std::vector<path::Step>& steps) {
    std::vector<scenes::Scene> all;
    for (const path::Step& step : steps) {
        all.push_back(scenes::make(name, step.time));
        all.back().view = step.view, all.back().light = step.light;
    }
    return all;
}

ShadowFrames measure(const glift::Device& device, const ShadowCase& one, const std::vector<scenes::Scene>& scenes,
                     glift::uint2 size, unsigned runs) {
    ShadowFrames found;
    std::vector<std::vector<double>> seconds(scenes.size());
    std::vector<double> touched;
    // A moving case goes along the path once, and times each frame `runs` times after a first one that does not count.
    // In a static case a frame depends on the pages that earlier frames have left resident. Therefore the case goes
    // along the path once without timing, and then `runs` times from the beginning, timing each frame once.
    for (unsigned round = 0; round <= (one.is_static ? runs : 0); ++round) {
        Along along(device, one, scenes, size);
        for (std::size_t i = 0; i < along.frames(); ++i) {
            along.go_to(i);
            if (round > 0) {
                seconds[i].push_back(along.seconds());
                continue;
            }
            const glift::Statistics before = device.statistics();
            along.submit();
            const glift::Statistics after = device.statistics();
            found.submissions = std::max(found.submissions, after.submissions - before.submissions);
            found.waits = std::max(found.waits, after.waits - before.waits);
            device.wait();
            if (!one.is_static || i > 0) note_pages(along, one, found);
            if (one.method != Method::standard && !one.is_static && i % 5 == 0)
                touched.push_back(Touched(along.frame(), one).share());
            for (unsigned run = 0; run < runs && !one.is_static; ++run) seconds[i].push_back(along.seconds());
        }
    }
    for (std::size_t i = one.is_static ? 1 : 0; i < seconds.size(); ++i) found.seconds.push_back(median(seconds[i]));
    if (!touched.empty()) found.touched = median(touched);
    if (!device.is_host()) found.passes = passes_of(device, one, scenes, size);
    return found;
}

}  // namespace bench
