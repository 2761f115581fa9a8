// Compares the exact functions of a Vulkan device with the host's, bit for bit, and the other functions of both with
// double precision.
#include "functions.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using accuracy::Exact;
using accuracy::Near;
using accuracy::Numbers;

constexpr std::uint32_t count = 1 << 20;

const glift::Device& vulkan() {
    static const glift::Device device = [] {
        const char* name = std::getenv("GLIFT_TEST_DEVICE");
        return glift::Device::open(name ? name : "lavapipe");
    }();
    return device;
}

std::vector<float> results(const glift::Device& device, accuracy::Kernel kernel, const std::vector<float>& x,
                           const std::vector<float>& y) {
    const auto size = static_cast<std::uint32_t>(x.size());
    Numbers a(device, size), b(device, size), r(device, size);
    a.write(0, size, x);
    b.write(0, size, y);
    kernel(device, a, b, r);
    return r.read(0, size);
}

/// Pairs of operands: all pairs of special values, random bits (with uniformly distributed exponents), and numbers in
/// [1, 2).
std::pair<std::vector<float>, std::vector<float>> any_numbers() {
    std::mt19937 bits(3);
    std::vector<float> x, y;
    std::vector<float> special;
    for (std::uint32_t word :
         {0u,          1u,          2u,          0x7fffffu,   0x800000u,   0x800001u,   0x3f7fffffu,
          0x3f800000u, 0x3f800001u, 0x40000000u, 0x40400000u, 0x4b000000u, 0x4effffffu, 0x4f000000u,
          0x4f7fffffu, 0x4f800000u, 0x7e800000u, 0x7f7fffffu, 0x7f800000u, 0x7fc00000u})
        for (std::uint32_t sign : {0u, 0x80000000u}) special.push_back(std::bit_cast<float>(word | sign));
    for (float a : special)
        for (float b : special) {
            x.push_back(a);
            y.push_back(b);
        }
    while (x.size() < count) {
        x.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(bits())));
        y.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(bits())));
    }
    // Numbers in [1, 2): of similar magnitude, so that sums and differences have to be rounded or cancel.
    for (std::size_t i = 0; i < count; ++i) {
        x.push_back(std::bit_cast<float>(0x3f800000u | static_cast<std::uint32_t>(bits() & 0xffffffu)));
        y.push_back(std::bit_cast<float>(0x3f800000u | static_cast<std::uint32_t>(bits() & 0xffffffu)));
    }
    return {x, y};
}

/// The bits of a value; the same word for all NaNs and, with `Zero::either`, the same for both zeros.
std::uint32_t word_of(float value, accuracy::Zero zero) {
    if (value != value) return 0x7fc00000u;
    return value == 0 && zero == accuracy::Zero::either ? 0 : std::bit_cast<std::uint32_t>(value);
}

class Arithmetic : public testing::TestWithParam<Exact> {};

TEST_P(Arithmetic, HasTheSameBitsOnBothDevices) {
    const auto [x, y] = any_numbers();
    const std::vector<float> host = results(glift::Device::open("host"), GetParam().kernel, x, y);
    const std::vector<float> device = results(vulkan(), GetParam().kernel, x, y);
    std::size_t different = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (word_of(host[i], GetParam().zero) == word_of(device[i], GetParam().zero)) continue;
        if (++different <= 5)
            ADD_FAILURE() << GetParam().name << " for x = " << std::hexfloat << x[i] << ", y = " << y[i] << ": host "
                          << host[i] << ", device " << device[i];
    }
    EXPECT_EQ(different, 0u) << "of " << x.size();
    for (const std::string& message : vulkan().validation_messages()) ADD_FAILURE() << message;
}

/// The error of `got`, in units in the last place of the largest of |exact|, `least` and the smallest normal float;
/// infinite for a NaN.
double error_of(const Near& function, float got, double exact) {
    if (std::isnan(got)) return std::numeric_limits<double>::infinity();
    const double size = std::max(std::abs(exact), std::max(function.least, double(std::numeric_limits<float>::min())));
    return std::abs(got - exact) / std::ldexp(1.0, std::ilogb(size) - 23);
}

/// Both ends of the function's range and random arguments in it: uniformly distributed, or logarithmically where a
/// positive range spans more than four powers of ten.
std::vector<float> arguments(const Near& function, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> place(0, 1);
    const bool powers = function.from > 0 && function.to / function.from > 1e4;
    std::vector<float> values = {float(function.from), float(function.to)};
    while (values.size() < count) {
        const double t = place(engine);
        const double value = powers ? function.from * std::pow(function.to / function.from, t)
                                    : function.from + t * (function.to - function.from);
        values.push_back(std::clamp(float(value), float(function.from), float(function.to)));
    }
    return values;
}

class Function : public testing::TestWithParam<Near> {};

TEST_P(Function, IsWithinItsBound) {
    const Near& function = GetParam();
    const std::vector<float> x = arguments(function, 1), y = arguments(function, 2);
    for (const glift::Device& device : {glift::Device::open("host"), vulkan()}) {
        const std::vector<float> got = results(device, function.kernel, x, y);
        double worst = 0;
        std::size_t at = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double error = error_of(function, got[i], function.exact(x[i], y[i]));
            if (error > worst) worst = error, at = i;
        }
        std::printf("| %s | %s | %.1f |\n", function.name, device.properties().name.c_str(), worst);
        EXPECT_LE(worst, function.bound) << function.name << " of " << x[at] << ", " << y[at] << " on "
                                         << device.properties().name << ": " << got[at] << " and not "
                                         << function.exact(x[at], y[at]);
    }
}

/// Checks that the table "Accuracy" of docs/reference/language.md has the function's row, with its range, its bound and
/// `least`.
TEST_P(Function, HasItsBoundInTheDocs) {
    std::ifstream file(GLIFT_LANGUAGE_MD);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const Near& function = GetParam();
    std::ostringstream row;
    row << "| `" << function.name << "` | " << function.from << " to " << function.to << " | " << function.bound
        << " | ";
    if (function.least > 0) row << function.least;
    else row << "the value";
    EXPECT_NE(text.find(row.str() + " |"), std::string::npos) << row.str() << " | is not in " << GLIFT_LANGUAGE_MD;
}

template <class T> std::string name_of(const testing::TestParamInfo<T>& info) {
    std::string name;
    for (char c : std::string(info.param.name)) {
        if (std::isalnum(static_cast<unsigned char>(c))) name += c;
        if (c == '+') name += "plus";
        if (c == '-') name += "minus";
        if (c == '*') name += "times";
        if (c == '/') name += "over";
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(, Arithmetic,
                         testing::ValuesIn(accuracy::exact_functions().begin(), accuracy::exact_functions().end()),
                         name_of<Exact>);
INSTANTIATE_TEST_SUITE_P(, Function,
                         testing::ValuesIn(accuracy::near_functions().begin(), accuracy::near_functions().end()),
                         name_of<Near>);

}  // namespace
