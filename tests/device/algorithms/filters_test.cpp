// Compares recursive filters with a serial loop in double precision.
//
// The bound. In each step the five products and four sums have a rounding error of at most 5 u M, where M is the
// largest |b0 x| + |b1 x| + |b2 x| + |a1 y| + |a2 y| and u = 2^-24. The error of one result propagates as the impulse
// response h of 1 / (1 + a1 z + a2 z^2), z a delay by one, so that a serial filter's error is at most G 5 u M, where G
// is the sum of all |h|. A parallel scan computes the initial state of each piece from the states of earlier pieces,
// which have this error, and from powers of the matrix of a step, whose elements are at most G and are rounded a few
// times in each doubling: another factor of G, and 2 for each of log2(n) doublings. In all 10 (4 + log2 n) u G^2 M.
#include "box.h"
#include "input.h"

#include "filters.glift.hpp"

#include <cmath>

namespace {

using namespace property;
using forms::Area;
using forms::Part;
using std_recursive_filter::Recursion;
using Floats = Input<filters::Line, filters::Folded, filters::Folded, filters::Number>;

GLIFT_PROPERTY_SUITE(Filters);

/// A filter of order one with a pole of magnitude 0.95 at most, or of order two with poles of magnitude 0.8 at most:
/// with larger ones the bound would be too weak to find errors.
Recursion any_filter(Round& round) {
    Recursion f;
    f.b0 = float(round.real());
    if (round.chance(3)) {
        f.a1 = float(-0.95 * round.real());
        return f;
    }
    f.b1 = float(round.real());
    f.b2 = float(round.real());
    if (round.chance(2)) {
        const double p = 0.8 * round.real(), q = 0.8 * round.real();
        f.a1 = float(-p - q);
        f.a2 = float(p * q);
    } else {
        const double size = 0.8 * std::abs(round.real());
        f.a1 = float(-2 * size * round.real());
        f.a2 = float(size * size);
    }
    return f;
}

struct Filtered {
    std::vector<double> results;
    double bound = 0;
};

double growth(const Recursion& f) {
    double sum = 0, before = 0, now = 1;
    for (int i = 0; i < 2000; ++i) {
        sum += std::abs(now);
        const double next = -double(f.a1) * now - double(f.a2) * before;
        before = now;
        now = next;
    }
    return sum;
}

/// A serial filter in double precision; `x` is in the order of the filter. If `repeated`, the first element also stands
/// before the start.
Filtered serial(const Recursion& f, const std::vector<float>& x, bool repeated) {
    Filtered filtered;
    if (x.empty()) return filtered;
    double x1 = repeated ? x[0] : 0, x2 = x1, most = 0;
    const double rest = 1 + double(f.a1) + f.a2;
    double y1 = repeated ? x1 * (double(f.b0) + f.b1 + f.b2) / rest : 0, y2 = y1;
    const double g = growth(f), u = 0x1p-24;
    // The rounding error of y1 and y2 before the start, where they are the results of a constant input: it may be
    // large, since the sums in the quotient may cancel.
    const double of_b = std::abs(f.b0) + std::abs(f.b1) + std::abs(f.b2), of_a = 1 + std::abs(f.a1) + std::abs(f.a2);
    const double at_rest = repeated ? 4 * u * (of_b * std::abs(x1) + of_a * std::abs(y1)) / std::abs(rest) : 0;
    for (double now : x) {
        const double y = f.b0 * now + f.b1 * x1 + f.b2 * x2 - f.a1 * y1 - f.a2 * y2;
        most = std::max(most, std::abs(f.b0 * now) + std::abs(f.b1 * x1) + std::abs(f.b2 * x2) + std::abs(f.a1 * y1) +
                                  std::abs(f.a2 * y2));
        x2 = x1, x1 = now, y2 = y1, y1 = y;
        filtered.results.push_back(y);
    }
    filtered.bound = 10 * (4 + std::log2(double(x.size()))) * u * g * g * most + 2 * g * at_rest + 0x1p-126;
    return filtered;
}

/// The expected elements and their bounds; elements outside of all systems keep their values.
struct Expected {
    std::vector<double> exact, bounds;

    template <class Place> void filter(const Recursion& f, const std::vector<float>& x, bool repeated, Place place) {
        const Filtered filtered = serial(f, x, repeated);
        for (std::size_t i = 0; i < x.size(); ++i) {
            exact[place(i)] = filtered.results[i];
            bounds[place(i)] = filtered.bound;
        }
    }
};

std::vector<float> samples(Round& round, std::uint32_t count) {
    std::vector<float> x(count);
    const std::uint32_t kind = round.below(3);
    for (std::uint32_t i = 0; i < count; ++i)
        x[i] = kind == 0 ? float(round.real()) : kind == 1 ? (i / 50 % 2 ? 1.0f : 0.0f) : i == count / 3 ? 1000.0f : 0;
    return x;
}

TEST_P(Filters, LineForward) {
    for_all("filter_line forward", [&](Round& round) {
        round.only(round.seed() % 2 ? Form::folded : Form::dense);
        const Placed placed(round, round.size());
        const std::vector<float> x = samples(round, placed.count);
        const Recursion f = any_filter(round);
        const Floats in(device(), round, placed, x);
        Output<filters::Line> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after([&](const filters::Line& to) {
                filters::line_forward(device(), in.form, in.dense, in.folded, f, placed.part<Part>(), in.length, to);
            });
        });
        Expected expected{{out.before.begin(), out.before.end()}, std::vector<double>(placed.extent)};
        expected.filter(f, x, false, [&](std::size_t i) { return placed.first + i; });
        EXPECT_TRUE(near(round, expected.exact, expected.bounds, found));
    });
}

TEST_P(Filters, LineBackward) {
    for_all("filter_line backward, from views", [&](Round& round) {
        round.only(round.seed() % 2 ? Form::strided : Form::mapped);
        const Placed placed(round, round.size());
        std::vector<float> x = samples(round, placed.count);
        const Recursion f = any_filter(round);
        const Floats in(device(), round, placed, x);
        Output<filters::Line> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after([&](const filters::Line& to) {
                filters::line_backward(device(), in.form, in.dense, in.step, f, placed.part<Part>(), in.length, to);
            });
        });
        Expected expected{{out.before.begin(), out.before.end()}, std::vector<double>(placed.extent)};
        std::reverse(x.begin(), x.end());
        expected.filter(f, x, true, [&](std::size_t i) { return placed.first + placed.count - 1 - i; });
        EXPECT_TRUE(near(round, expected.exact, expected.bounds, found));
    });
}

TEST_P(Filters, RowsBackward) {
    for_all("filter_systems, rows backward", [&](Round& round) {
        round.only(Form::tiled);
        const Box box(round, 0);
        const Recursion f = any_filter(round);
        const auto all = samples(round, static_cast<std::uint32_t>(box.count()));
        filters::Tiles from(device(), box.extent);
        filters::Plane to(device(), box.extent);
        from.write(all);
        const auto n = box.size_on<filters::Extents>(device());
        const auto found = twice(round, [&] {
            to.fill(5);
            filters::rows_backward(device(), from, f, box.area<Area>(), n, to);
            return to.read();
        });
        Expected expected{std::vector<double>(box.count(), 5), std::vector<double>(box.count())};
        for (std::uint32_t system = 0; system < box.systems; ++system) {
            std::vector<float> x;
            for (std::uint32_t i = box.length; i-- > 0;) x.push_back(all[box.place(system, i)]);
            expected.filter(f, x, false,
                            [&](std::size_t i) { return box.place(system, box.length - 1 - std::uint32_t(i)); });
        }
        EXPECT_TRUE(near(round, expected.exact, expected.bounds, found));
    });
}

TEST_P(Filters, ColumnsForward) {
    for_all("filter_systems, columns forward of pairs", [&](Round& round) {
        round.only(Form::dense);
        const Box box(round, 1);
        const Recursion f = any_filter(round);
        const auto count = static_cast<std::uint32_t>(box.count());
        const auto all = samples(round, count), others = samples(round, count);
        std::vector<glift::float2> both;
        for (std::uint32_t i = 0; i < count; ++i) both.push_back({all[i], others[i]});
        filters::Picture2 from(device(), box.extent);
        filters::Plane2 to(device(), box.extent);
        from.write(both);
        const auto n = box.size_on<filters::Extents>(device());
        const auto found = twice(round, [&] {
            to.fill({5, 5});
            filters::columns_forward(device(), from, f, box.area<Area>(), n, to);
            return to.read();
        });
        for (unsigned k = 0; k < 2; ++k) {
            Expected expected{std::vector<double>(count, 5), std::vector<double>(count)};
            for (std::uint32_t system = 0; system < box.systems; ++system) {
                std::vector<float> x;
                for (std::uint32_t i = 0; i < box.length; ++i) x.push_back((k ? others : all)[box.place(system, i)]);
                expected.filter(f, x, true, [&](std::size_t i) { return box.place(system, std::uint32_t(i)); });
            }
            std::vector<float> component;
            for (const glift::float2& value : found) component.push_back(value[k]);
            EXPECT_TRUE(near(round, expected.exact, expected.bounds, component));
        }
    });
}

}  // namespace
