#include "paint_model.h"

#include "examples/common/shapes.h"

#include <glift/host/math.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace paint_model {

using glift::float2;
using glift::float3;
using strokes::Stroke;

namespace {

constexpr Word cells = 16, nodes = 17, texels_of_page = nodes * nodes * nodes;

}  // namespace

mesh::Mesh model() {
    mesh::Mesh made;
    mesh::add_sphere(made, {0.45f, 0.5f, 0.55f}, 0.35f, 24, {1, 1, 1});
    mesh::add_sheet(
        made, 7, 9, [](float u, float v) { return float3(u, 1 - v, 0.1f + 0.11f * u); },
        [](float, float) { return float3(1, 1, 1); });
    mesh::normalise(made);
    return made;
}

std::vector<Stroke> random_strokes(unsigned count, unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    std::vector<Stroke> made(count);
    for (Stroke& stroke : made) {
        const float x = number() - 0.5f, y = number() - 0.5f, z = 0.3f + number();
        stroke.camera = {float3(0.5f, 0.5f, 0.4f) + glift::normalize(float3(x, y, z)) * 1.7f,
                         {0.5f, 0.5f, 0.4f},
                         {0, 1, 0},
                         0.6f,
                         0.05f,
                         5};
        stroke.size = {160, 120};
        strokes::Brush& brush = stroke.brush;
        brush.radius = &stroke == made.data() ? 30.0f : 3 + 12 * number();
        brush.hardness = number();
        brush.grain = number() < 0.3f ? 0.8f : 0.0f;
        brush.flow = 0.2f + 0.8f * number();
        brush.opacity = brush.flow < 0.6f ? 1 : brush.flow;
        brush.cells = 6 + 10 * number();
        for (unsigned i = 0; i < 3; ++i) brush.colour[i] = number();
        brush.blend = random() % 8 == 0 ? 2u : static_cast<Word>(random() % 4 == 0);
        for (unsigned i = 0; i < 3; ++i) {
            const float left = 40 + 80 * number(), down = 30 + 60 * number();
            stroke.path.push_back({float2(left, down), 0.3f + 0.7f * number()});
        }
    }
    return made;
}

Stroke one_dab() {
    Stroke stroke;
    stroke.camera = {{0.5f, 0.5f, 1.75f}, {0.5f, 0.5f, 0.25f}, {0, 1, 0}, 0.8f, 0.05f, 5};
    stroke.size = {200, 200};
    stroke.brush.radius = 30;
    stroke.brush.flow = 0.6f;
    stroke.brush.cells = 8;
    stroke.brush.colour = {1, 0, 0.2f};
    stroke.path = {{float2(100, 100), 1}};
    return stroke;
}

OctreeSize small(Word pages) {
    OctreeSize size;
    size.resolution = 128;
    size.pages = pages;
    return size;
}

State state_of(Canvas& canvas) {
    State state;
    journal::Octree& octree = canvas.octree();
    state.table = octree.best().read();
    state.pages = octree.pages().active().read(0, octree.status(canvas.device()).resident);
    const auto n = static_cast<Word>(state.pages.size());
    journal::PageList list(canvas.device(), n);
    list.write(state.pages);
    journal::Texels texels(canvas.device(), {texels_of_page, n});
    mark(canvas.device(), octree, list);
    journal::store(canvas.device(), octree, octree.frames(), texels);
    const Words all = texels.read();
    for (auto at = all.begin(); at != all.end(); at += texels_of_page)
        state.texels.emplace_back(at, at + texels_of_page);
    return state;
}

Field::Field(const State& state, Word levels) : levels_(levels) {
    for (std::size_t i = 0; i < state.pages.size(); ++i) {
        Word number = state.pages[i];
        Page page{levels - 1, {}};
        const auto count = [&] { return along(page.level) * along(page.level) * along(page.level); };
        for (; number >= count(); --page.level) number -= count();
        for (Word& at : page.at) {
            at = number % along(page.level);
            number /= along(page.level);
        }
        pages_[page] = &state.texels[i];
    }
}

Field::Colour Field::texel(const Page& page, const Place& inside) const {
    const Word word = (*pages_.at(page))[inside[0] + nodes * (inside[1] + nodes * inside[2])];
    Colour colour{};
    for (unsigned i = 0; i < 4; ++i) colour[i] = (word >> 8 * i & 255) / 255.0;
    return colour;
}

Field::Colour Field::sample(const std::array<double, 3>& x, double level) const {
    const double l = std::clamp(level, 0.0, levels_ - 1.0);
    const auto below = static_cast<Word>(l);
    const Colour a = sample(x, below), b = sample(x, std::min(below + 1, levels_ - 1));
    Colour mixed{};
    for (unsigned i = 0; i < 4; ++i) mixed[i] = a[i] + (b[i] - a[i]) * (l - below);
    return mixed;
}

Field::Colour Field::sample(const std::array<double, 3>& x, Word level) const {
    Page page{level, {}};
    for (unsigned axis = 0; axis < 3; ++axis)
        page.at[axis] = std::min(static_cast<Word>(x[axis] / (cells << level)), along(level) - 1);
    while (!has(page)) {
        if (++page.level == levels_) return {};
        for (Word& at : page.at) at /= 2;
    }
    Place low{};
    std::array<double, 3> part{};
    for (unsigned axis = 0; axis < 3; ++axis) {
        const double node =
            std::clamp(x[axis] / (1u << page.level) - cells * page.at[axis], 0.0, static_cast<double>(cells));
        low[axis] = std::min(static_cast<Word>(node), cells - 1);
        part[axis] = node - low[axis];
    }
    Colour sum{};
    for (unsigned corner = 0; corner < 8; ++corner) {
        Place at = low;
        double weight = 1;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const bool up = (corner >> axis & 1) != 0;
            at[axis] += up;
            weight *= up ? part[axis] : 1 - part[axis];
        }
        const Colour c = texel(page, at);
        for (unsigned i = 0; i < 4; ++i) sum[i] += weight * c[i];
    }
    return sum;
}

std::vector<Field::Page> Field::around(const Place& node, Word level) const {
    std::vector<Page> found;
    for (unsigned corner = 0; corner < 8; ++corner) {
        Page page{level, {}};
        for (unsigned axis = 0; axis < 3; ++axis) {
            const bool back = (corner >> axis & 1) != 0 && node[axis] > 0;
            page.at[axis] = std::min((node[axis] - back) / cells, along(level) - 1);
        }
        found.push_back(page);
    }
    return found;
}

bool Field::all_around(const Place& node, Word level) const {
    return std::ranges::all_of(around(node, level), [&](const Page& page) { return has(page); });
}

Field::Colour Field::node(const Place& node, Word level) const {
    for (const Page& page : around(node, level)) {
        if (!has(page)) continue;
        Place inside{};
        for (unsigned axis = 0; axis < 3; ++axis) inside[axis] = node[axis] - cells * page.at[axis];
        return texel(page, inside);
    }
    return {};
}

std::optional<Field::Colour> Field::mean(const Place& at, Word level) const {
    if (level == 0 || !all_around({2 * at[0], 2 * at[1], 2 * at[2]}, level - 1)) return std::nullopt;
    const int last = static_cast<int>(cells * along(level - 1));
    Colour sum{};
    double weight = 0, finest = 0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const std::array<int, 3> o{x, y, z};
                Place fine{};
                bool is_inside = true;
                for (unsigned axis = 0; axis < 3; ++axis) {
                    const int place = 2 * static_cast<int>(at[axis]) + o[axis];
                    is_inside = is_inside && place >= 0 && place <= last;
                    fine[axis] = static_cast<Word>(place);
                }
                if (!is_inside) continue;
                const Colour c = node(fine, level - 1);
                const double painted = std::round(255 * c[3]);
                if (painted == 0) continue;
                const double w = std::exp2(painted) / (1 << (std::abs(x) + std::abs(y) + std::abs(z)));
                for (unsigned i = 0; i < 3; ++i) sum[i] += w * c[i];
                weight += w;
                finest = std::max(finest, painted);
            }
    if (weight == 0) return std::nullopt;
    return Colour{sum[0] / weight, sum[1] / weight, sum[2] / weight, finest / 255};
}

}  // namespace paint_model
