// Which arithmetic of a Vulkan device agrees with the CPU bit for bit.
//
//     glift_probe_exact [DEVICE-NAME-PART] [probe_exact.comp]
//
// Prints, for each operation, how many of the inputs give other bits than the CPU, by how many units in the last place at most,
// and the first such input. Built with -ffp-contract=off: the CPU side is IEEE.
#include "probe_device.h"

#include "emit/spirv/emit.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

namespace {

using Word = std::uint32_t;

float real(Word bits) { return std::bit_cast<float>(bits); }
Word bits(float value) { return std::bit_cast<Word>(value); }

Word to_int(float x) {
    if (std::isnan(x)) return 0;
    if (x >= 2147483648.0f) return 0x7fffffffu;
    return x < -2147483648.0f ? 0x80000000u : static_cast<Word>(static_cast<std::int32_t>(x));
}
Word to_uint(float x) { return !(x > 0) ? 0 : x >= 4294967296.0f ? 0xffffffffu : static_cast<Word>(x); }

float least(float a, float b) { return std::isnan(a) ? b : std::isnan(b) ? a : b < a ? b : a; }
float most(float a, float b) { return std::isnan(a) ? b : std::isnan(b) ? a : a < b ? b : a; }

Word half_of(float x) {
    _Float16 half = static_cast<_Float16>(x);
    return std::bit_cast<std::uint16_t>(half);
}

Word compared(float a, float b) {
    return (a < b ? 1u : 0u) | (a == b ? 2u : 0u) | (a != b ? 4u : 0u) | (std::isnan(a) ? 8u : 0u) | (std::isinf(a) ? 16u : 0u);
}

enum class Kind { real, word };

struct Operation {
    Word number;
    const char* name;
    Kind kind;
    Word (*expected)(Word, Word, Word);
};

#define AB float a = real(x), b = real(y); (void)a, (void)b, (void)z
const Operation operations[] = {
    {0, "a + b", Kind::real, [](Word x, Word y, Word z) { AB; return bits(a + b); }},
    {1, "a - b", Kind::real, [](Word x, Word y, Word z) { AB; return bits(a - b); }},
    {2, "a * b", Kind::real, [](Word x, Word y, Word z) { AB; return bits(a * b); }},
    {3, "a * b + c, not contracted", Kind::real, [](Word x, Word y, Word z) { AB; return bits(a * b + real(z)); }},
    {4, "fma(a, b, c), fused", Kind::real, [](Word x, Word y, Word z) { AB; return bits(std::fma(a, b, real(z))); }},
    {5, "a / b", Kind::real, [](Word x, Word y, Word z) { AB; return bits(a / b); }},
    {6, "sqrt(a)", Kind::real, [](Word x, Word y, Word z) { AB; return bits(std::sqrt(a)); }},
    {7, "a / b, corrected, scaled", Kind::real, [](Word x, Word y, Word z) { AB; return bits(a / b); }},
    {8, "a / b, corrected, quick", Kind::real, [](Word x, Word y, Word z) { AB; return bits(a / b); }},
    {9, "sqrt(a), corrected", Kind::real, [](Word x, Word y, Word z) { AB; return bits(std::sqrt(a)); }},
    {10, "a / b through double", Kind::real, [](Word x, Word y, Word z) { AB; return bits(a / b); }},
    {11, "sqrt(a) through double", Kind::real, [](Word x, Word y, Word z) { AB; return bits(std::sqrt(a)); }},
    {12, "min(a, b)", Kind::real, [](Word x, Word y, Word z) { AB; return bits(least(a, b)); }},
    {13, "max(a, b)", Kind::real, [](Word x, Word y, Word z) { AB; return bits(most(a, b)); }},
    {14, "min(max(a, b), c)", Kind::real, [](Word x, Word y, Word z) { AB; return bits(least(most(a, b), real(z))); }},
    {15, "int(a), the device's own", Kind::word, [](Word x, Word y, Word z) { AB; return to_int(a); }},
    {16, "uint(a), the device's own", Kind::word, [](Word x, Word y, Word z) { AB; return to_uint(a); }},
    {17, "int(a), saturated", Kind::word, [](Word x, Word y, Word z) { AB; return to_int(a); }},
    {18, "uint(a), saturated", Kind::word, [](Word x, Word y, Word z) { AB; return to_uint(a); }},
    {19, "float(int)", Kind::real, [](Word x, Word y, Word z) { AB; return bits(static_cast<float>(static_cast<std::int32_t>(x))); }},
    {20, "float(uint)", Kind::real, [](Word x, Word y, Word z) { AB; return bits(static_cast<float>(x)); }},
    {21, "uint / uint, by 0: a", Kind::word, [](Word x, Word y, Word z) { AB; return y ? x / y : x; }},
    {22, "uint % uint, by 0: 0", Kind::word, [](Word x, Word y, Word z) { AB; return y ? x % y : 0; }},
    {23, "int / int, by 0: a", Kind::word, [](Word x, Word y, Word z) { AB; return y == 0 || (y == ~0u && x == 1u << 31) ? x : static_cast<Word>(static_cast<std::int32_t>(x) / static_cast<std::int32_t>(y)); }},
    {24, "uint / max(uint, 1)", Kind::word, [](Word x, Word y, Word z) { AB; return y ? x / y : x; }},
    {25, "<<, masked?", Kind::word, [](Word x, Word y, Word z) { AB; return x << (y & 31); }},
    {26, ">> of uint, masked?", Kind::word, [](Word x, Word y, Word z) { AB; return x >> (y & 31); }},
    {27, ">> of int, masked?", Kind::word, [](Word x, Word y, Word z) { AB; return static_cast<Word>(static_cast<std::int32_t>(x) >> (y & 31)); }},
    {28, "<< of masked amount", Kind::word, [](Word x, Word y, Word z) { AB; return x << (y & 31); }},
    {29, "roundEven", Kind::real, [](Word x, Word y, Word z) { AB; return bits(std::nearbyint(a)); }},
    {30, "floor", Kind::real, [](Word x, Word y, Word z) { AB; return bits(std::floor(a)); }},
    {31, "trunc", Kind::real, [](Word x, Word y, Word z) { AB; return bits(std::trunc(a)); }},
    {32, "a - floor(a)", Kind::real, [](Word x, Word y, Word z) { AB; return bits(a - std::floor(a)); }},
    {33, "packHalf2x16", Kind::word, [](Word x, Word y, Word z) { AB; return std::isnan(a) || std::isnan(b) ? 0 : half_of(a) | half_of(b) << 16; }},
    {34, "comparisons, isnan, isinf", Kind::word, [](Word x, Word y, Word z) { AB; return compared(a, b); }},
    {35, "a / 255", Kind::real, [](Word x, Word y, Word z) { AB; return bits(a / 255.0f); }},
    {36, "b / b + (-a)", Kind::real, [](Word x, Word y, Word z) { AB; return bits(b / b + (-a)); }},
};
#undef AB

using Inputs = std::vector<std::vector<Word>>;

/// Every pair of the values that arithmetic goes wrong at, with every one of a few third operands.
Inputs edges() {
    std::vector<Word> values = {0x00000000, 0x00000001, 0x00000002, 0x003fffff, 0x00400000, 0x007fffff, 0x00800000, 0x00800001, 0x00ffffff, 0x01000000,
                                0x20000000, 0x33800000, 0x34000000, 0x3e800000, 0x3effffff, 0x3f000000, 0x3f000001, 0x3f7fffff, 0x3f800000, 0x3f800001,
                                0x3fc00000, 0x3fffffff, 0x40000000, 0x40200000, 0x40400000, 0x437f0000, 0x4b000000, 0x4b000001, 0x4b7fffff, 0x4effffff,
                                0x4f000000, 0x4f7fffff, 0x4f800000, 0x5f000000, 0x7e800000, 0x7effffff, 0x7f000000, 0x7f7fffff, 0x7f800000, 0x7fc00000,
                                3, 7, 31, 32, 33, 63, 64, 100, 255, 65535};
    for (std::size_t i = 0, n = values.size(); i < n; ++i) values.push_back(values[i] | 0x80000000u);
    for (Word ones : {0xffffffffu, 0xfffffff9u}) values.push_back(ones);
    Inputs made(3);
    for (Word a : values)
        for (Word b : values)
            for (Word c : {0x3f800000u, 0x80000000u, 0x7fc00000u, b}) {
                made[0].push_back(a);
                made[1].push_back(b);
                made[2].push_back(c);
            }
    return made;
}

/// Random bits: `moderate` floats have exponents near that of 1.
Inputs random_inputs(std::size_t count, bool moderate) {
    std::mt19937 engine(12345);
    Inputs made(3);
    for (auto& values : made)
        for (std::size_t i = 0; i < count; ++i) {
            Word word = static_cast<Word>(engine());
            if (moderate) word = (word & 0x807fffffu) | (112u + engine() % 32u) << 23;
            values.push_back(word);
        }
    return made;
}

/// Distance in units in the last place; floats only.
std::uint64_t apart(Word a, Word b) {
    auto order = [](Word w) { return w & 0x80000000u ? -static_cast<std::int64_t>(w & 0x7fffffffu) : static_cast<std::int64_t>(w); };
    std::int64_t d = order(a) - order(b);
    return static_cast<std::uint64_t>(d < 0 ? -d : d);
}

bool is_subnormal(Word w) { return (w & 0x7f800000u) == 0 && (w & 0x7fffffffu) != 0; }
bool is_nan(Word w) { return (w & 0x7fffffffu) > 0x7f800000u; }

struct Report {
    std::size_t wrong = 0, with_subnormals = 0, zero_signs = 0, not_numbers = 0, infinities = 0, first = 0;
    std::uint64_t furthest = 0;
};

Report compare(const Operation& operation, const Inputs& in, const std::vector<Word>& got) {
    Report report;
    for (std::size_t i = 0; i < got.size(); ++i) {
        Word want = operation.expected(in[0][i], in[1][i], in[2][i]);
        if (operation.number == 33 && (is_nan(in[0][i]) || is_nan(in[1][i]))) continue;
        if (got[i] == want || (operation.kind == Kind::real && is_nan(got[i]) && is_nan(want))) continue;
        if (operation.kind == Kind::real && ((got[i] | want) & 0x7fffffffu) == 0) {
            ++report.zero_signs;
            continue;
        }
        if (report.wrong++ == 0) report.first = i;
        if (operation.kind == Kind::word) continue;
        if (is_nan(got[i]) || is_nan(want)) ++report.not_numbers;
        else if (std::isinf(real(got[i])) || std::isinf(real(want))) ++report.infinities;
        else if (is_subnormal(want) || is_subnormal(in[0][i]) || is_subnormal(in[1][i]) || is_subnormal(in[2][i])) ++report.with_subnormals;
        else report.furthest = std::max(report.furthest, apart(got[i], want));
    }
    return report;
}

void print(const char* inputs, const Operation& operation, const Inputs& in, const std::vector<Word>& got) {
    Report r = compare(operation, in, got);
    std::printf("%-28s %-9s %8zu of %8zu differ", operation.name, inputs, r.wrong, got.size());
    if (r.wrong > 0) {
        if (operation.kind == Kind::real)
            std::printf(" (max %llu ulp; %zu with subnormals, %zu with nan, %zu with inf)", static_cast<unsigned long long>(r.furthest), r.with_subnormals,
                        r.not_numbers, r.infinities);
        std::size_t i = r.first;
        std::printf("  first: a %08x b %08x c %08x device %08x cpu %08x", in[0][i], in[1][i], in[2][i], got[i], operation.expected(in[0][i], in[1][i], in[2][i]));
    }
    if (r.zero_signs > 0) std::printf("  [zeros of the other sign: %zu]", r.zero_signs);
    std::printf("\n");
}

}  // namespace

int main(int count, char** arguments) {
    std::string path = count > 2 ? arguments[2] : GLIFT_PROBE_SHADER;
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    if (!file) {
        std::fprintf(stderr, "%s: cannot be read\n", path.c_str());
        return 1;
    }
    auto spirv = gliftc::spirv::spirv_of(text.str());
    if (!spirv.error.empty()) {
        std::fprintf(stderr, "%s\n", spirv.error.c_str());
        return 1;
    }
    probe::Machine machine(count > 1 ? arguments[1] : "");
    const Inputs edge = edges(), any = random_inputs(1 << 20, false), moderate = random_inputs(1 << 22, true);
    for (const Operation& operation : operations) {
        print("edges", operation, edge, machine.run(spirv.words, operation.number, edge));
        print("random", operation, any, machine.run(spirv.words, operation.number, any));
        if (operation.kind == Kind::real) print("moderate", operation, moderate, machine.run(spirv.words, operation.number, moderate));
    }
}
