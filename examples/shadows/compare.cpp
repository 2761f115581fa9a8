#include "compare.h"

#include <algorithm>
#include <array>

using picture::Picture;

namespace {

bool is_lit(float share) { return share > 0.5f; }

Agreement agreement_of(const Lighting& lighting, const rays::Reference& reference, Picture& differences) {
    Agreement agreement;
    for (std::size_t i = 0; i < reference.light.size(); ++i) {
        const glift::float4 own = lighting.colours[i];
        const float grey = 0.35f * (own.x + own.y + own.z);
        differences.pixels.emplace_back(grey, grey, grey, 1);
        if (reference.light[i] == rays::Light::unknown) continue;
        const bool differs = is_lit(lighting.lit[i]) != (reference.light[i] == rays::Light::reached);
        if (reference.at_edge[i]) {
            ++agreement.in_band;
            if (differs) differences.pixels.back() = glift::float4(0.1f, 0.25f, 0.7f, 1);
            continue;
        }
        ++agreement.pixels;
        if (!differs) continue;
        ++agreement.different;
        differences.pixels.back() = glift::float4(1, 0.1f, 0.05f, 1);
    }
    return agreement;
}

Picture by_rays(const Lighting& lighting, const rays::Reference& reference, glift::uint2 size) {
    Picture made{size.x, size.y, {}, {}};
    for (std::size_t i = 0; i < reference.light.size(); ++i) {
        const glift::float4 own = lighting.colours[i];
        const float light = 1 + (reference.light[i] == rays::Light::reached ? own.w : 0);
        made.pixels.emplace_back(own.x * light, own.y * light, own.z * light, 1);
    }
    return made;
}

/// Two rows of three.
Picture together(const std::array<Picture, 6>& parts) {
    const std::uint32_t width = parts[0].width, height = parts[0].height;
    Picture all{3 * width, 2 * height, {}, {}};
    all.pixels.resize(std::size_t{6} * width * height);
    for (std::size_t k = 0; k < parts.size(); ++k)
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x)
                all.pixels[(k / 3 * height + y) * all.width + k % 3 * width + x] =
                    parts[k].pixels[std::size_t{y} * width + x];
    return all;
}

}  // namespace

Agreement& Agreement::operator+=(const Agreement& other) {
    pixels += other.pixels;
    different += other.different;
    in_band += other.in_band;
    return *this;
}

Compared compare(Frame& frame, float bias) {
    const glift::uint2 size = frame.size();
    constexpr std::array methods = {Method::matched, Method::adaptive, Method::standard};
    std::array<Lighting, 3> lighting;
    std::array<Picture, 3> pictures, differences;
    for (std::size_t k = 0; k < methods.size(); ++k) {
        frame.draw(methods[k]);
        lighting[k] = frame.lighting();
        pictures[k] = frame.picture();
        differences[k] = {size.x, size.y, {}, {}};
    }
    const auto is_doubted = [&](std::size_t pixel, rays::Light light) {
        return std::ranges::any_of(
            lighting, [&](const Lighting& some) { return is_lit(some.lit[pixel]) != (light == rays::Light::reached); });
    };
    const rays::Reference reference = rays::trace(frame, lighting[0], bias, is_doubted);
    Compared compared;
    compared.rmsm = agreement_of(lighting[0], reference, differences[0]);
    compared.adaptive = agreement_of(lighting[1], reference, differences[1]);
    compared.standard = agreement_of(lighting[2], reference, differences[2]);
    compared.side_by_side = together({pictures[0], pictures[2], by_rays(lighting[0], reference, size), differences[0],
                                      differences[1], differences[2]});
    return compared;
}
