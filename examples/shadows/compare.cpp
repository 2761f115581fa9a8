#include "compare.h"

#include <algorithm>
#include <tuple>

using picture::Picture;

namespace {

/// Whether a pixel is lit (is_lit) where rays say shadowed, or the reverse; false where rays say nothing.
bool differs(float lit, rays::Light light) {
    return light != rays::Light::unknown && is_lit(lit) != (light == rays::Light::reached);
}

Agreement agreement_of(const Lighting& lighting, const rays::Reference& reference) {
    Agreement agreement;
    for (std::size_t i = 0; i < reference.light.size(); ++i) {
        if (reference.light[i] == rays::Light::unknown) continue;
        if (reference.at_edge[i]) {
            ++agreement.in_band;
            continue;
        }
        ++agreement.pixels;
        agreement.different += differs(lighting.lit[i], reference.light[i]);
    }
    return agreement;
}

/// A pixel's colour from that in ambient light and its share of light, as `shade` of shadows.glift computes it.
glift::float4 shaded(const glift::float4& own, float lit) {
    const float light = 1 + own.w * lit;
    return {own.x * light, own.y * light, own.z * light, 1};
}

}  // namespace

Agreement& Agreement::operator+=(const Agreement& other) {
    pixels += other.pixels;
    different += other.different;
    in_band += other.in_band;
    return *this;
}

Picture Compared::by(std::size_t method) const {
    const Lighting& from = lighting[method];
    Picture made{size.x, size.y, {}, {}};
    for (std::size_t i = 0; i < from.lit.size(); ++i) made.pixels.push_back(shaded(from.colours[i], from.lit[i]));
    return made;
}

Picture Compared::by_rays() const {
    Picture made{size.x, size.y, {}, {}};
    for (std::size_t i = 0; i < reference.light.size(); ++i)
        made.pixels.push_back(shaded(lighting[0].colours[i], reference.light[i] == rays::Light::reached ? 1.0f : 0.0f));
    return made;
}

Picture Compared::differences(std::size_t method) const {
    const Lighting& from = lighting[method];
    Picture made{size.x, size.y, {}, {}};
    for (std::size_t i = 0; i < from.lit.size(); ++i) {
        const glift::float4 own = from.colours[i];
        const float grey = 0.35f * (own.x + own.y + own.z);
        made.pixels.push_back(!differs(from.lit[i], reference.light[i]) ? glift::float4(grey, grey, grey, 1)
                              : reference.at_edge[i]                    ? glift::float4(0.1f, 0.25f, 0.7f, 1)
                                                                        : glift::float4(1, 0.1f, 0.05f, 1));
    }
    return made;
}

Compared compare(Frame& frame, float bias) {
    Compared compared;
    compared.size = frame.size();
    for (std::size_t k = 0; k < Compared::methods.size(); ++k) {
        frame.draw(Compared::methods[k]);
        std::ignore = frame.status();  // throws if depths are missing
        compared.lighting[k] = frame.lighting();
        compared.counts[k] = frame.counts();
    }
    compared.reference = rays::trace(frame, compared.lighting[0], bias, [&](std::size_t pixel, rays::Light light) {
        return std::ranges::any_of(compared.lighting,
                                   [&](const Lighting& some) { return differs(some.lit[pixel], light); });
    });
    for (std::size_t k = 0; k < Compared::methods.size(); ++k)
        compared.agreement[k] = agreement_of(compared.lighting[k], compared.reference);
    return compared;
}

Picture together(const std::vector<Picture>& parts) {
    const std::uint32_t width = parts[0].width, height = parts[0].height;
    const auto rows = static_cast<std::uint32_t>((parts.size() + 2) / 3);
    Picture all{3 * width, rows * height, {}, {}};
    all.pixels.resize(std::size_t{all.width} * all.height);
    for (std::size_t k = 0; k < parts.size(); ++k)
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x)
                all.pixels[(k / 3 * height + y) * all.width + k % 3 * width + x] =
                    parts[k].pixels[std::size_t{y} * width + x];
    return all;
}

Picture side_by_side(const Compared& compared) {
    return together({compared.by(0), compared.by(2), compared.by_rays(), compared.differences(0),
                     compared.differences(1), compared.differences(2)});
}
