#include "algorithm_cases.h"

#include "solvers.glift.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace bench {

namespace {

constexpr std::uint32_t systems_checked = 16;  // evenly spread, the first and the last among them

struct Coefficients {
    solvers::Grid lower, middle, upper;
};

float component(float x, int) { return x; }
float component(const glift::float3& x, int k) { return k == 0 ? x.x : k == 1 ? x.y : x.z; }

/// Thomas' algorithm in double precision, for component k of the right-hand sides of a system.
template <class T> std::vector<double> solved(const std::vector<float>& lower, const std::vector<float>& middle,
                                              const std::vector<float>& upper, const std::vector<T>& right, int k) {
    const std::size_t n = middle.size();
    std::vector<double> c(n), x(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double before_c = i ? c[i - 1] : 0, before_x = i ? x[i - 1] : 0;
        const double pivot = middle[i] - lower[i] * before_c;
        c[i] = upper[i] / pivot;
        x[i] = (component(right[i], k) - lower[i] * before_x) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 0;) x[i] -= c[i] * x[i + 1];
    return x;
}

/// The largest max |x - exact| / max |exact| of the systems that are checked.
template <class Grid> double largest_error(const Coefficients& a, const Grid& right, const Grid& found, int sides) {
    const std::uint32_t n = found.domain().x, rows = found.domain().y, checked = std::min(rows, systems_checked);
    double largest = 0;
    for (std::uint32_t system = 0; system < checked; ++system) {
        const glift::uint2 at(0, checked == 1 ? 0 : system * (rows - 1) / (checked - 1)), size(n, 1);
        const auto lower = a.lower.read(at, size), middle = a.middle.read(at, size), upper = a.upper.read(at, size);
        const auto b = right.read(at, size), x = found.read(at, size);
        for (int k = 0; k < sides; ++k) {
            const std::vector<double> exact = solved(lower, middle, upper, b, k);
            double difference = 0, size_of_exact = 0;
            for (std::uint32_t i = 0; i < n; ++i) {
                const double distance = std::abs(component(x[i], k) - exact[i]);
                difference = distance <= difference ? difference : distance;  // keeps a NaN
                size_of_exact = std::max(size_of_exact, std::abs(exact[i]));
            }
            const double error = difference / size_of_exact;
            largest = error <= largest ? largest : error;
        }
    }
    return largest;
}

struct Systems {
    Coefficients a;
    solvers::Grid right;
    solvers::Grid3 right3;
};

Systems systems_of(const glift::Device& device, std::uint32_t n) {
    const glift::uint2 size(n, n);
    Systems made{{{device, size}, {device, size}, {device, size}}, {device, size}, {device, size}};
    solvers::make_systems(device, n, made.a.lower, made.a.middle, made.a.upper, made.right);
    solvers::make_right(device, n, made.right3);
    return made;
}

/// The solutions, shared by all cases, which run one after the other.
struct Unknowns {
    solvers::Grid one;
    solvers::Grid3 three;
};

void solve_one(const glift::Commands& commands, const Systems& s, const Unknowns& x) {
    solvers::solve(commands, s.a.lower, s.a.middle, s.a.upper, s.right, x.one);
}
void solve_three(const glift::Commands& commands, const Systems& s, const Unknowns& x) {
    solvers::solve_three(commands, s.a.lower, s.a.middle, s.a.upper, s.right3, x.three);
}

/// More bytes than most GPUs' caches hold: cycling through so many leaves none of them there.
constexpr std::uint64_t beyond_caches = std::uint64_t{128} << 20;

}  // namespace

std::vector<AlgorithmCase> tridiagonal_cases(const glift::Device& device, std::uint32_t n) {
    const std::uint64_t count = std::uint64_t{n} * n, bytes = 20 * count;
    auto all = std::make_shared<std::vector<Systems>>();
    do all->push_back(systems_of(device, n));
    while (all->size() * bytes < beyond_caches);
    const glift::uint2 size(n, n);
    const Unknowns x{{device, size}, {device, size}};
    const std::string variant = "n_" + std::to_string(n);
    const auto first = [=](const auto& solve) {
        return [=](const glift::Commands& commands) { solve(commands, all->front(), x); };
    };
    const auto in_turn = [=](const auto& solve) {
        return [=, turn = std::make_shared<std::size_t>(0)](const glift::Commands& commands) {
            solve(commands, (*all)[(*turn)++ % all->size()], x);
        };
    };
    // All sets of systems in `all` have the same coefficients and right-hand sides, so that the first stands for all.
    const auto error = [=] { return largest_error(all->front().a, all->front().right, x.one, 1); };
    const auto error3 = [=] { return largest_error(all->front().a, all->front().right3, x.three, 3); };
    return {{"tridiagonal", variant, count, bytes, first(solve_one), error},
            {"tridiagonal", variant + "_three", 3 * count, 36 * count, first(solve_three), error3},
            {"tridiagonal", variant + "_from_memory", count, bytes, in_turn(solve_one), error},
            {"tridiagonal", variant + "_three_from_memory", 3 * count, 36 * count, in_turn(solve_three), error3}};
}

}  // namespace bench
