// The diffusion of dof.glift in double precision: the Thomas algorithm, line by line. `circle` is each pixel's diameter
// of the circle of confusion.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace direct {

/// One value for each pixel of a picture, row by row.
struct Plane {
    std::size_t width = 0, height = 0;
    std::vector<double> values;

    double& at(std::size_t x, std::size_t y) { return values[y * width + x]; }
    double at(std::size_t x, std::size_t y) const { return values[y * width + x]; }
};

/// Solves one line for x: weight[i] * (x[i] - value[i]) = b[i - 1] * (x[i - 1] - x[i]) + b[i] * (x[i + 1] - x[i]),
/// where b[i] is the conductivity between i and i + 1.
inline std::vector<double> solved(const std::vector<double>& value, const std::vector<double>& weight,
                                  const std::vector<double>& circle) {
    const std::size_t n = value.size();
    const auto flow = [&](std::size_t i) {  // b[i], as in dof.glift: the smaller circle squared, over 32
        const double least = std::min(circle[i], circle[i + 1]);
        return least * least / 32;
    };
    // The pivot of row i is rest + after. `rest` is computed as a sum of positive numbers, not as a difference, so that
    // nothing cancels.
    std::vector<double> upper(n), x(n);
    double rest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double before = i > 0 ? flow(i - 1) : 0, after = i + 1 < n ? flow(i) : 0;
        rest = weight[i] + (i > 0 ? before * rest / (rest + before) : 0);
        upper[i] = after / (rest + after);
        x[i] = (weight[i] * value[i] + (i > 0 ? before * x[i - 1] : 0)) / (rest + after);
    }
    for (std::size_t i = n - 1; i-- > 0;) x[i] += upper[i] * x[i + 1];
    return x;
}

/// Solves all rows, or all columns.
inline Plane along(const Plane& value, const Plane& weight, const Plane& circle, bool is_row) {
    Plane made = value;
    const std::size_t lines = is_row ? value.height : value.width, length = is_row ? value.width : value.height;
    for (std::size_t line = 0; line < lines; ++line) {
        const auto place = [&](std::size_t i) { return is_row ? line * value.width + i : i * value.width + line; };
        std::vector<double> v(length), w(length), c(length);
        for (std::size_t i = 0; i < length; ++i) {
            v[i] = value.values[place(i)];
            w[i] = weight.values[place(i)];
            c[i] = circle.values[place(i)];
        }
        const std::vector<double> x = solved(v, w, c);
        for (std::size_t i = 0; i < length; ++i) made.values[place(i)] = x[i];
    }
    return made;
}

/// Diffuses `value` along rows with `weight`, then along columns. The columns' weights are `weight` itself diffused
/// along rows, and at least `least`.
inline Plane spread(const Plane& value, const Plane& weight, const Plane& circle, double least) {
    Plane second = along(weight, weight, circle, true);
    for (double& w : second.values) w = std::max(w, least);
    return along(along(value, weight, circle, true), second, circle, false);
}

}  // namespace direct
