// Compares tridiagonal solvers with the Thomas algorithm in double precision.
//
// The bound. Elimination without pivoting of a tridiagonal matrix A that is diagonally dominant solves (A + E) x = b
// with |E| <= 12 u |A|, u = 2^-24: the factors and the two substitutions contribute f(u) = 4 u, and |L| |U| <= 3 |A|
// (Higham, Accuracy and Stability of Numerical Algorithms, 9.6). Methods that eliminate in log2(n) levels do this once
// per level, to matrices that stay at least as dominant: 12 (1 + log2 n) u. So |x' - x| <= 12 (1 + log2 n) u |A^-1| |A|
// |x|. For a matrix that is dominant by rows, with coefficients a, b, c before, on and after the diagonal of a row,
// |A^-1| is at most 1 / min (|b| - |a| - |c|) in the maximum norm, and |A| is max (|b| + |a| + |c|). Where sums of rows
// are given in place of diagonals, and off-diagonals are negative, the sum is that difference.
#include "box.h"

#include "tridiagonals.glift.hpp"

#include <cmath>

namespace {

using namespace property;
using forms::Area;

GLIFT_PROPERTY_SUITE(Tridiagonals);

/// An equation: its coefficients and right-hand side.
struct Row {
    double lower = 0, diagonal = 0, upper = 0, right = 0;
};

std::vector<double> thomas(std::vector<Row> rows) {
    std::vector<double> x(rows.size());
    double upper = 0, right = 0;
    for (Row& row : rows) {
        const double pivot = row.diagonal - row.lower * upper;
        row.upper = upper = row.upper / pivot;
        row.right = right = (row.right - row.lower * right) / pivot;
    }
    double after = 0;
    for (std::size_t i = rows.size(); i-- > 0;) x[i] = after = rows[i].right - rows[i].upper * after;
    return x;
}

/// The bound on the error of a solver's solution of a system whose exact solution is x.
double bound_of(const std::vector<Row>& rows, const std::vector<double>& x) {
    double least = INFINITY, most = 0, size = 0;
    for (const Row& row : rows) {
        const double beside = std::abs(row.lower) + std::abs(row.upper);
        least = std::min(least, std::abs(row.diagonal) - beside);
        most = std::max(most, std::abs(row.diagonal) + beside);
    }
    for (double value : x) size = std::max(size, std::abs(value));
    const double levels = 1 + std::log2(static_cast<double>(rows.size()));
    return 12 * levels * 0x1p-24 * most / least * size + 0x1p-149;
}

/// The expected elements and their bounds; elements outside of the box keep their values.
struct Expected {
    std::vector<double> exact, bounds;

    explicit Expected(std::size_t count, double before) : exact(count, before), bounds(count) {}

    void solve(const Box& box, std::uint32_t system, const std::vector<Row>& rows) {
        const std::vector<double> x = thomas(rows);
        const double bound = bound_of(rows, x);
        for (std::uint32_t i = 0; i < box.length; ++i) {
            exact[box.place(system, i)] = x[i];
            bounds[box.place(system, i)] = bound;
        }
    }
};

TEST_P(Tridiagonals, Rows) {
    for_all("solve_tridiagonal, rows", [&](Round& round) {
        const Box box(round, 0);
        std::vector<float> lower(box.count(), 7), diagonal(box.count()), upper(box.count(), 7), right(box.count());
        const double margin = std::exp2(round.real() * 5 - 4);
        const bool spans_powers = round.chance(2);
        for (std::size_t i = 0; i < box.count(); ++i) {
            lower[i] = float(round.real());
            upper[i] = float(round.real());
            const double size = (std::abs(lower[i]) + std::abs(upper[i])) * (1 + margin) + margin;
            diagonal[i] = float(round.chance(2) ? size : -size);
            right[i] = float(round.real() * (spans_powers ? std::exp2(round.real() * 20) : 1));
        }
        Expected expected(box.count(), 5);
        for (std::uint32_t system = 0; system < box.systems && box.length > 0; ++system) {
            // Unused coefficients may have any value.
            lower[box.place(system, 0)] = NAN;
            upper[box.place(system, box.length - 1)] = NAN;
            std::vector<Row> rows;
            for (std::uint32_t i = 0; i < box.length; ++i) {
                const std::size_t p = box.place(system, i);
                rows.push_back({lower[p], diagonal[p], upper[p], right[p]});
            }
            rows.front().lower = rows.back().upper = 0;
            expected.solve(box, system, rows);
        }
        tridiagonals::Plane a(device(), box.extent), r(device(), box.extent), x(device(), box.extent);
        tridiagonals::Tiles b(device(), box.extent);
        tridiagonals::Picture c(device(), box.extent);
        a.write(lower), b.write(diagonal), c.write(upper), r.write(right);
        const auto n = box.size_on<tridiagonals::Extents>(device());
        const auto found = twice(round, [&] {
            x.fill(5);
            tridiagonals::solve_rows(device(), a, b, c, r, box.area<Area>(), n, x);
            return x.read();
        });
        EXPECT_TRUE(near(round, expected.exact, expected.bounds, found));
    });
}

TEST_P(Tridiagonals, ColumnsOfDiffusion) {
    for_all("solve_tridiagonal, columns, sums, three right-hand sides", [&](Round& round) {
        const Box box(round, 1);
        std::vector<float> conductivity(box.count()), sums(box.count());
        std::vector<glift::float3> right(box.count());
        const double most = std::exp2(round.real() * 8);
        for (std::size_t i = 0; i < box.count(); ++i) {
            conductivity[i] = round.chance(10) ? 0 : float((round.real() + 1) * most);
            sums[i] = float(1.5 + round.real());
            right[i] = {float(round.real()), float(round.real() * 100), float(round.real() * 0.01)};
        }
        std::vector<Expected> expected(3, Expected(box.count(), 5));
        for (std::uint32_t system = 0; system < box.systems; ++system) {
            for (unsigned k = 0; k < 3; ++k) {
                std::vector<Row> rows;
                for (std::uint32_t i = 0; i < box.length; ++i) {
                    const std::size_t p = box.place(system, i);
                    Row row{.right = right[p][k]};
                    if (i > 0) row.lower = -conductivity[p];
                    if (i + 1 < box.length) row.upper = -conductivity[box.place(system, i + 1)];
                    row.diagonal = sums[p] - row.lower - row.upper;
                    rows.push_back(row);
                }
                if (!rows.empty()) expected[k].solve(box, system, rows);
            }
        }
        tridiagonals::Plane c(device(), box.extent), s(device(), box.extent);
        tridiagonals::Plane3 r(device(), box.extent), x(device(), box.extent);
        c.write(conductivity), s.write(sums), r.write(right);
        const auto n = box.size_on<tridiagonals::Extents>(device());
        const auto found = twice(round, [&] {
            x.fill({5, 5, 5});
            tridiagonals::diffuse_columns(device(), c, s, r, box.area<Area>(), n, x);
            return x.read();
        });
        for (unsigned k = 0; k < 3; ++k) {
            std::vector<float> component;
            for (const glift::float3& value : found) component.push_back(value[k]);
            EXPECT_TRUE(near(round, expected[k].exact, expected[k].bounds, component));
        }
    });
}

TEST_P(Tridiagonals, RowsOfAMatrix) {
    for_all("solve_tridiagonal_matrix, rows, sums, two right-hand sides", [&](Round& round) {
        const Box box(round, 0);
        std::vector<std_tridiagonal::Coefficients> matrix(box.count());
        std::vector<glift::float2> right(box.count());
        const double most = std::exp2(round.real() * 4);
        for (std::size_t i = 0; i < box.count(); ++i) {
            matrix[i] = {.lower = float((round.real() - 1) * most),
                         .middle = float(1.5 + round.real()),
                         .upper = round.chance(10) ? 0 : float((round.real() - 1) * most)};
            right[i] = {float(round.real()), float(round.real() * 100)};
        }
        std::vector<Expected> expected(2, Expected(box.count(), 5));
        for (std::uint32_t system = 0; system < box.systems && box.length > 0; ++system) {
            matrix[box.place(system, 0)].lower = NAN;
            matrix[box.place(system, box.length - 1)].upper = NAN;
            for (unsigned k = 0; k < 2; ++k) {
                std::vector<Row> rows;
                for (std::uint32_t i = 0; i < box.length; ++i) {
                    const std::size_t p = box.place(system, i);
                    Row row{.right = right[p][k]};
                    if (i > 0) row.lower = matrix[p].lower;
                    if (i + 1 < box.length) row.upper = matrix[p].upper;
                    row.diagonal = matrix[p].middle - row.lower - row.upper;
                    rows.push_back(row);
                }
                expected[k].solve(box, system, rows);
            }
        }
        tridiagonals::Matrix m(device(), box.extent);
        tridiagonals::Picture2 r(device(), box.extent), x(device(), box.extent);
        m.write(matrix), r.write(right);
        const auto n = box.size_on<tridiagonals::Extents>(device());
        const auto found = twice(round, [&] {
            x.fill({5, 5});
            tridiagonals::solve_matrix(device(), m, r, box.area<Area>(), n, x);
            return x.read();
        });
        for (unsigned k = 0; k < 2; ++k) {
            std::vector<float> component;
            for (const glift::float2& value : found) component.push_back(value[k]);
            EXPECT_TRUE(near(round, expected[k].exact, expected[k].bounds, component));
        }
    });
}

}  // namespace
