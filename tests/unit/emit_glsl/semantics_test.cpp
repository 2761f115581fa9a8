// Operations that the language defines for all operands and GLSL does not: printed with guards where they are needed,
// and only there. Also loops, parentheses, literals, atomics, subgroups and built-in functions.
#include "builder.h"

#include "emit/glsl/emit.h"
#include "emit/spirv/emit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gliftc::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string proved(Builder& b) {
    std::string text = glsl::glsl_of(b.program, b.sources, b.pass);
    auto spirv = spirv::spirv_of(text);
    EXPECT_EQ(spirv.error, "") << text;
    return text;
}

/// The text of a kernel that stores `make(builder, address)`, of any type.
template <class Make> std::string stored(Make make) {
    Builder b;
    ExprId address = b.one_axis();
    ExprId value = make(b, address);
    auto out = b.buffer("g_data", b.type_of(value), Access::write);
    b.pass.plain().body = {b.store(out, address, value)};
    return proved(b);
}

ExprId as_int(Builder& b, ExprId value) { return b.make(Op::convert, b.types().int_, {value}); }
ExprId as_float(Builder& b, ExprId value) { return b.make(Op::convert, b.types().float_, {value}); }

TEST(Division, ByAConstantOrAnExtentHasNoGuard) {
    EXPECT_THAT(stored([](Builder& b, ExprId a) { return b.binary(BinaryOp::divide, a, b.u(3)); }),
                HasSubstr("= address / 3u;"));
    EXPECT_THAT(stored([](Builder& b, ExprId a) {
                    return b.binary(BinaryOp::remainder, a, b.extent_parameter("width", b.types().uint));
                }),
                HasSubstr("= address % width;"));
}

TEST(Division, ByAnythingElseIsGuarded) {
    EXPECT_THAT(stored([](Builder& b, ExprId a) { return b.binary(BinaryOp::divide, a, a); }),
                HasSubstr("= address / max(address, 1u);"));
    auto by_value = [](Builder& b, ExprId a) {
        ExprId n = b.parameter("n", b.types().uint);
        b.pass.parameters.back().value = b.use(b.local("n", b.types().uint, false));
        return b.binary(BinaryOp::remainder, a, n);
    };
    EXPECT_THAT(stored(by_value), HasSubstr("= address % max(n, 1u);"));
}

TEST(Division, OfIntsGoesThroughAFunction) {
    std::string text =
        stored([](Builder& b, ExprId a) { return b.binary(BinaryOp::remainder, as_int(b, a), b.i(-3)); });
    EXPECT_THAT(text, HasSubstr("int quotient(int a, int b)"));
    EXPECT_THAT(text, HasSubstr("a / (b == 0 || (a == int(0x80000000u) && b == -1) ? 1 : b)"));
    EXPECT_THAT(text, HasSubstr("= remainder(int(address), -3);"));
    EXPECT_THAT(stored([](Builder& b, ExprId a) { return b.binary(BinaryOp::divide, as_int(b, a), b.i(3)); }),
                HasSubstr("= int(address) / 3;"));
    auto vectors = [](Builder& b, ExprId a) {
        TypeId int3 = b.types().vector(b.types().int_, 3);
        return b.binary(BinaryOp::divide, b.make(Op::construct, int3, {as_int(b, a)}), as_int(b, a));
    };
    EXPECT_THAT(stored(vectors), HasSubstr("ivec3(quotient(a.x, b.x), quotient(a.y, b.y), quotient(a.z, b.z))"));
}

/// As `stored`, for a device whose division and square root are inexact and get corrected.
template <class Make> std::string corrected(Make make) {
    Builder b;
    ExprId address = b.one_axis();
    ExprId value = make(b, address);
    auto out = b.buffer("g_data", b.type_of(value), Access::write);
    b.pass.plain().body = {b.store(out, address, value)};
    std::string text = glsl::glsl_of(b.program, b.sources, b.pass,
                                     {.lines = glsl::LineMarks::directives, .rounding = glsl::Rounding::correct});
    auto spirv = spirv::spirv_of(text);
    EXPECT_EQ(spirv.error, "") << text;
    return text;
}

/// The shader of a body that stores the last of `count` quotients, each of which divides by the one before.
std::string shader_of_quotients(int count) {
    Builder b;
    const ExprId address = b.one_axis();
    const auto from = b.buffer("f_data", b.types().float_, Access::read);
    const auto to = b.buffer("g_data", b.types().float_, Access::write);
    const LocalId last = b.local("last", b.types().float_);
    b.pass.plain().body = {b.let(last, b.load(from, address))};
    for (int i = 0; i < count; ++i)
        b.pass.plain().body.push_back(
            b.assign(b.use(last), b.binary(BinaryOp::divide, b.load(from, b.plus(address, b.u(1))), b.use(last))));
    b.pass.plain().body.push_back(b.store(to, address, b.use(last)));
    std::string text = glsl::glsl_of(b.program, b.sources, b.pass,
                                     {.lines = glsl::LineMarks::directives, .rounding = glsl::Rounding::correct});
    EXPECT_EQ(spirv::spirv_of(text).error, "") << text;
    return text;
}

/// A loop with eight quotients, from an int that a quotient gives where `begins_at_quotient`, else from 0.
std::string shader_of_loop(bool begins_at_quotient) {
    Builder b;
    const ExprId address = b.one_axis();
    const auto from = b.buffer("f_data", b.types().float_, Access::read);
    const auto to = b.buffer("g_data", b.types().float_, Access::write);
    const LocalId sum = b.local("sum", b.types().float_), first = b.local("first", b.types().int_);
    const LocalId round = b.local("round", b.types().int_);
    const ExprId quotient = b.binary(BinaryOp::divide, b.load(from, b.u(0)), b.load(from, address));
    b.pass.plain().body = {b.let(sum, quotient), b.let(first, b.make(Op::convert, b.types().int_, {b.use(sum)})),
                           b.loop(round, begins_at_quotient ? b.use(first) : b.i(0), b.i(3),
                                  {b.assign(b.use(sum), b.binary(BinaryOp::divide, quotient, b.use(sum)))}),
                           b.store(to, address, b.use(sum))};
    return glsl::glsl_of(b.program, b.sources, b.pass,
                         {.lines = glsl::LineMarks::directives, .rounding = glsl::Rounding::correct});
}

TEST(Division, LoopsThatMayNotEndWhereQuotientsAreWrongComeOnce) {
    EXPECT_THAT(shader_of_loop(false), HasSubstr("if (!has_usual_quotients) {"));
    EXPECT_THAT(shader_of_loop(true), Not(HasSubstr("has_usual_quotients")));
}

TEST(Division, ManyQuotientsComeTwice) {
    const std::string many = shader_of_quotients(4);
    EXPECT_THAT(many, HasSubstr("last = quick_divide("));
    EXPECT_THAT(many, HasSubstr("if (!has_usual_quotients) {"));
    EXPECT_THAT(many, HasSubstr("        last = f_data[address_1];")) << "declared before: the store uses it";
    EXPECT_THAT(many, HasSubstr("        last = divide(f_data[address_1 + 1u], last);"));
    EXPECT_THAT(many, HasSubstr("    g_data[address] = last;"));
    EXPECT_THAT(shader_of_quotients(3), Not(HasSubstr("has_usual_quotients")));
}

TEST(Division, OfFloatsIsCorrectedWhereTheDeviceIsNotExact) {
    auto division = [](Builder& b, ExprId a) { return b.binary(BinaryOp::divide, as_float(b, a), b.f(3)); };
    EXPECT_THAT(stored(division), HasSubstr("= float(address) / 3.0;"));
    EXPECT_THAT(corrected(division), HasSubstr("= divide_by(float(address), 3.0, 0.33333334);"));
    const auto by_itself = [](Builder& b, ExprId a) { return b.binary(BinaryOp::divide, b.f(3), as_float(b, a)); };
    EXPECT_THAT(corrected(by_itself), HasSubstr("= divide(3.0, float(address));"));
    // A reciprocal alone is not enough where it may be subnormal, or b's mantissa is all ones.
    for (const double by : {1e37, 1e-37, 1.9999998807907104})
        EXPECT_THAT(
            corrected([&](Builder& b, ExprId a) { return b.binary(BinaryOp::divide, as_float(b, a), b.f(by)); }),
            HasSubstr("= divide(float(address), "));
    EXPECT_THAT(corrected([](Builder& b, ExprId a) { return b.binary(BinaryOp::divide, as_float(b, a), b.f(4)); }),
                HasSubstr("= float(address) / 4.0;"));
    auto vectors = [](Builder& b, ExprId a) {
        TypeId float3 = b.types().vector(b.types().float_, 3), float4 = b.types().vector(b.types().float_, 4);
        ExprId v = b.make(Op::construct, float3, {as_float(b, a)});
        ExprId root = b.intrinsic(Intrinsic::sqrt, float3, {b.binary(BinaryOp::divide, v, v)});
        ExprId smooth = b.intrinsic(Intrinsic::smoothstep, float3, {b.f(0), b.f(2), root});
        ExprId bytes = b.lanes(b.intrinsic(Intrinsic::unpackUnorm4x8, float4, {a}), {0, 1, 2});
        return b.binary(BinaryOp::remainder, b.plus(smooth, bytes), v);
    };
    EXPECT_THAT(corrected(vectors), HasSubstr("layout(constant_id = 100) const bool exact_division = true;"));
    auto matrices = [](Builder& b, ExprId a) {
        TypeId square = b.types().matrix(b.types().float_, 2, 2);
        ExprId x = as_float(b, a), m = b.make(Op::construct, square, {x, x, x, x});
        return b.make(Op::index, b.types().vector(b.types().float_, 2), {b.binary(BinaryOp::divide, m, x), b.u(1)});
    };
    EXPECT_THAT(corrected(matrices), HasSubstr("divide(a[0][0], b)"));
}

// Drivers may drop the sign of zero where they negate a choice between 0.0 and 1.0 (emit/glsl/signs.h).
TEST(Negation, OfAChoiceBetweenConstantsIsAFunction) {
    const auto chosen = [](Builder& b, ExprId a, double yes, double no) {
        return b.make(Op::select, b.types().float_, {b.less(a, b.u(3)), b.f(yes), b.f(no)});
    };
    const auto negated = [&](Builder& b, ExprId a) { return b.unary(UnaryOp::minus, chosen(b, a, 0.0, 1.0)); };
    EXPECT_THAT(stored(negated), HasSubstr("= negative(address < 3u ? 0.0 : 1.0);"));
    const auto factor = [&](Builder& b, ExprId a) { return b.times(b.f(-1.0), chosen(b, a, 0.0, 1.0)); };
    EXPECT_THAT(stored(factor), HasSubstr("= negative(address < 3u ? 0.0 : 1.0);"));
    const auto difference = [&](Builder& b, ExprId a) { return b.minus(b.f(-0.0), chosen(b, a, 0.0, 1.0)); };
    EXPECT_THAT(stored(difference), HasSubstr("= negative(address < 3u ? 0.0 : 1.0);"));
    const auto negative_zero = [&](Builder& b, ExprId a) { return chosen(b, a, -0.0, 1.0); };
    EXPECT_THAT(stored(negative_zero), HasSubstr("= negative(address < 3u ? 0.0 : -1.0);"));
    const auto others = [&](Builder& b, ExprId a) { return b.unary(UnaryOp::minus, as_float(b, a)); };
    EXPECT_THAT(stored(others), HasSubstr("= -float(address);"));
}

// Drivers may take such a choice for positive and leave out its abs (emit/glsl/signs.h).
TEST(Magnitude, OfAChoiceThatNegativeZeroIsInIsAFunction) {
    const auto magnitude_of = [](double yes, double no) {
        return [yes, no](Builder& b, ExprId a) {
            const ExprId choice = b.make(Op::select, b.types().float_, {b.less(a, b.u(3)), b.f(yes), b.f(no)});
            return b.intrinsic(Intrinsic::abs, b.types().float_, {choice});
        };
    };
    EXPECT_THAT(stored(magnitude_of(2.0, -0.0)), HasSubstr("= magnitude(address < 3u ? 2.0 : -0.0);"));
    EXPECT_THAT(stored(magnitude_of(2.0, -3.0)), HasSubstr("= abs(address < 3u ? 2.0 : -3.0);"));
}

TEST(Shift, IsMaskedWhereTheAmountIsNotKnown) {
    EXPECT_THAT(stored([](Builder& b, ExprId a) { return b.binary(BinaryOp::shift_left, a, b.u(31)); }),
                HasSubstr("= address << 31u;"));
    EXPECT_THAT(stored([](Builder& b, ExprId a) { return b.binary(BinaryOp::shift_right, a, b.plus(a, b.u(1))); }),
                HasSubstr("= address >> ((address + 1u) & 31u);"));
}

TEST(Conversion, OfFloatsToIntegersSaturates) {
    std::string text =
        stored([](Builder& b, ExprId a) { return b.make(Op::convert, b.types().int_, {as_float(b, a)}); });
    EXPECT_THAT(text, HasSubstr("int to_int(float x)"));
    EXPECT_THAT(stored([](Builder& b, ExprId a) { return b.make(Op::convert, b.types().uint, {as_float(b, a)}); }),
                HasSubstr("uint to_uint(float x)"));
    auto doubles = [](Builder& b, ExprId a) {
        return b.make(Op::convert, b.types().int64, {b.make(Op::convert, b.types().double_, {a})});
    };
    EXPECT_THAT(stored(doubles), HasSubstr("int64_t to_int64(double x)"));
    auto vectors = [](Builder& b, ExprId a) {
        TypeId float2 = b.types().vector(b.types().float_, 2);
        return b.make(Op::convert, b.types().vector(b.types().uint, 2),
                      {b.make(Op::construct, float2, {as_float(b, a)})});
    };
    EXPECT_THAT(stored(vectors), HasSubstr("uvec2 to_uint(vec2 a)"));
}

TEST(Index, IsClampedUnlessKnownToBeInside) {
    Builder b;
    ExprId address = b.one_axis();
    auto out = b.buffer("g_data", b.types().float_, Access::write);
    LocalId table = b.local("table", b.types().array(b.types().float_, 4)), n = b.local("n", b.types().uint, false);
    auto at = [&](ExprId where) { return b.make(Op::index, b.types().float_, {b.use(table), where}); };
    b.pass.plain().body = {b.let(table), b.loop(n, b.u(0), b.u(4), {b.assign(at(b.use(n)), b.f(0.5))}),
                           b.store(out, address, b.plus(at(address), at(b.u(2))))};
    std::string text = proved(b);
    EXPECT_THAT(text, HasSubstr("float table[4] = float[4](0.0, 0.0, 0.0, 0.0);"));
    EXPECT_THAT(text, HasSubstr("for (uint n = 0u; n < 4u; ++n) {\n        table[n] = 0.5;"));
    EXPECT_THAT(text, HasSubstr("table[min(address, 3u)] + table[2u]"));
}

TEST(Loop, EvaluatesItsLimitOnce) {
    Builder b;
    ExprId address = b.one_axis();
    auto out = b.buffer("g_data", b.types().uint, Access::read_write);
    LocalId n = b.local("n", b.types().uint, false);
    b.pass.plain().body = {b.loop(n, b.u(0), b.load(out, address), {b.store(out, b.use(n), b.u(1))})};
    EXPECT_THAT(proved(b), HasSubstr("for (uint n = 0u, n_end = g_data[address]; n < n_end; ++n) {"));
}

TEST(Parentheses, AreAsFewAsAReaderWants) {
    auto text = [](auto make) { return stored(make); };
    EXPECT_THAT(text([](Builder& b, ExprId a) { return b.times(b.plus(a, b.u(1)), b.u(2)); }),
                HasSubstr("= (address + 1u) * 2u;"));
    EXPECT_THAT(text([](Builder& b, ExprId a) { return b.minus(a, b.minus(a, b.u(1))); }),
                HasSubstr("= address - (address - 1u);"));
    EXPECT_THAT(text([](Builder& b, ExprId a) { return b.minus(b.minus(a, a), b.u(1)); }),
                HasSubstr("= address - address - 1u;"));
    EXPECT_THAT(text([](Builder& b, ExprId a) {
                    return b.binary(BinaryOp::bit_or, b.binary(BinaryOp::shift_left, a, b.u(8)), a);
                }),
                HasSubstr("= (address << 8u) | address;"));
    EXPECT_THAT(
        text([](Builder& b, ExprId a) { return b.unary(UnaryOp::minus, b.unary(UnaryOp::minus, as_int(b, a))); }),
        HasSubstr("= -(-int(address));"));
    EXPECT_THAT(text([](Builder& b, ExprId a) {
                    return b.make(Op::select, b.types().uint, {b.less(a, b.u(4)), a, b.u(0)});
                }),
                HasSubstr("= address < 4u ? address : 0u;"));
}

TEST(Clamp, OfFloatsIsNoSaturation) {
    const auto floats = [](Builder& b, ExprId a) {
        return b.intrinsic(Intrinsic::clamp, b.types().float_, {as_float(b, a), b.f(0.0), b.f(1.0)});
    };
    EXPECT_THAT(stored(floats), HasSubstr("= min(max(float(address), 0.0), 1.0);"));
    const auto uints = [](Builder& b, ExprId a) {
        return b.intrinsic(Intrinsic::clamp, b.types().uint, {a, b.u(2), b.u(5)});
    };
    EXPECT_THAT(stored(uints), HasSubstr("= clamp(address, 2u, 5u);"));
}

TEST(Literals, KeepTheirValues) {
    EXPECT_THAT(stored([](Builder& b, ExprId) { return b.f(1e-30); }), HasSubstr("= 1e-30;"));
    EXPECT_THAT(stored([](Builder& b, ExprId) { return b.f(1.0 / 0.0); }),
                HasSubstr("= uintBitsToFloat(0x7f800000u);"));
    EXPECT_THAT(stored([](Builder& b, ExprId) { return b.i(INT32_MIN); }), HasSubstr("= int(0x80000000u);"));
    EXPECT_THAT(stored([](Builder& b, ExprId) { return b.constant(b.types().uint64, ~0ull); }),
                HasSubstr("= 18446744073709551615ul;"));
}

TEST(Atomics, OfFloatsAreThoseOfTheirBitsOrLoopsOfCompareAndSwap) {
    Builder b;
    ExprId address = b.one_axis();
    auto out = b.buffer("g_data", b.types().float_, Access::read_write);
    auto sums = b.buffer("sums", b.types().float_, Access::read_write);
    auto counts = b.buffer("counts", b.types().uint, Access::read_write);
    for (const auto slot : {out, sums, counts}) b.pass.bindings[slot].atomic = true;
    b.pass.bindings[out].ordered = true;  // as lowering sets it for minima and maxima of floats
    Stmt stmt = b.statement(StmtOp::atomic);
    stmt.slot = out;
    stmt.target = address;
    stmt.value = b.f(2);
    stmt.combine = Combine::max;
    StmtId most = b.add(stmt);
    stmt.slot = sums;
    stmt.combine = Combine::add;
    StmtId sum = b.add(stmt);
    stmt.slot = counts;
    stmt.value = b.u(1);
    b.pass.plain().body = {most, sum, b.add(stmt), b.store(out, b.u(0), b.load(sums, b.u(1))),
                           b.store(sums, b.u(0), b.load(out, b.u(1)))};
    std::string text = proved(b);
    EXPECT_THAT(text, HasSubstr("buffer G_data { int g_data[]; };"));
    EXPECT_THAT(text, HasSubstr("buffer Sums { uint sums[]; };"));
    EXPECT_THAT(text, HasSubstr("g_data_max(address, 2.0);"));
    EXPECT_THAT(text, HasSubstr("atomicMax(g_data[index], bits)"));
    EXPECT_THAT(text, HasSubstr("sums_add(address, 2.0);"));
    EXPECT_THAT(text, HasSubstr("atomicCompSwap(sums[index], expected, wanted)"));
    EXPECT_THAT(text, HasSubstr("atomicAdd(counts[address], 1u);"));
    EXPECT_THAT(text, HasSubstr("g_data[0u] = floatBitsToInt(uintBitsToFloat(sums[1u]));"));
    EXPECT_THAT(text, HasSubstr("sums[0u] = floatBitsToUint(intBitsToFloat(g_data[1u]));"));
}

/// Compiles calls of most built-in functions of floats, and of vectors of three.
TEST(Intrinsics, AllCompile) {
    const std::vector<Intrinsic> floats = {
        Intrinsic::abs,   Intrinsic::sign, Intrinsic::floor, Intrinsic::ceil,       Intrinsic::round, Intrinsic::trunc,
        Intrinsic::fract, Intrinsic::sqrt, Intrinsic::exp,   Intrinsic::exp2,       Intrinsic::log,   Intrinsic::log2,
        Intrinsic::sin,   Intrinsic::cos,  Intrinsic::tan,   Intrinsic::asin,       Intrinsic::acos,  Intrinsic::atan,
        Intrinsic::sinh,  Intrinsic::cosh, Intrinsic::tanh,  Intrinsic::inversesqrt};
    const std::vector<std::pair<Intrinsic, std::size_t>> more = {
        {Intrinsic::min, 2},  {Intrinsic::max, 2}, {Intrinsic::clamp, 3},
        {Intrinsic::step, 2}, {Intrinsic::mix, 3}, {Intrinsic::smoothstep, 3},
        {Intrinsic::fma, 3},  {Intrinsic::pow, 2}, {Intrinsic::atan2, 2}};
    for (std::uint32_t count : {1u, 3u}) {
        auto value = [&](Builder& b, ExprId a) {
            TypeId type = b.types().vector(b.types().float_, count);
            ExprId x = b.make(Op::construct, type, {as_float(b, a)});
            ExprId sum = x;
            for (Intrinsic which : floats) sum = b.plus(sum, b.intrinsic(which, type, {x}));
            for (auto [which, count_of_operands] : more) {
                Operands operands;
                operands.assign(count_of_operands, x);
                sum = b.plus(sum, b.intrinsic(which, type, operands));
            }
            if (count == 3) {
                sum = b.plus(sum, b.intrinsic(Intrinsic::cross, type, {x, x}));
                sum = b.plus(sum, b.intrinsic(Intrinsic::reflect, type, {x, x}));
                sum = b.plus(sum, b.intrinsic(Intrinsic::normalize, type, {x}));
                sum = b.plus(sum, b.intrinsic(Intrinsic::dot, b.types().float_, {x, x}));
                sum = b.plus(sum, b.intrinsic(Intrinsic::length, b.types().float_, {x}));
                sum = b.plus(sum, b.intrinsic(Intrinsic::mix, type, {x, x, as_float(b, a)}));
            }
            return sum;
        };
        std::string text = stored(value);
        EXPECT_THAT(text, HasSubstr("roundEven("));
        EXPECT_THAT(text, Not(HasSubstr(" mix(")));
    }
}

TEST(Intrinsics, OfBitsCompile) {
    auto value = [](Builder& b, ExprId a) {
        TypeId uint = b.types().uint, int_ = b.types().int_, float4 = b.types().vector(b.types().float_, 4),
               float2 = b.types().vector(b.types().float_, 2);
        ExprId one = b.i(1), n = as_int(b, a), sum = a;
        auto add = [&](ExprId what) { sum = b.plus(sum, b.make(Op::convert, uint, {what})); };
        for (Intrinsic which : {Intrinsic::bitCount, Intrinsic::findLSB, Intrinsic::findMSB})
            add(b.intrinsic(which, int_, {a}));
        add(b.intrinsic(Intrinsic::bitfieldReverse, uint, {a}));
        add(b.intrinsic(Intrinsic::bitfieldExtract, uint, {a, one, n}));
        add(b.intrinsic(Intrinsic::bitfieldInsert, int_, {n, n, one, n}));
        add(b.intrinsic(Intrinsic::packUnorm4x8, uint, {b.intrinsic(Intrinsic::unpackUnorm4x8, float4, {a})}));
        add(b.intrinsic(Intrinsic::packHalf2x16, uint, {b.intrinsic(Intrinsic::unpackHalf2x16, float2, {a})}));
        add(b.intrinsic(Intrinsic::floatBitsToUint, uint,
                        {b.intrinsic(Intrinsic::uintBitsToFloat, b.types().float_, {a})}));
        add(b.intrinsic(Intrinsic::floatBitsToInt, int_,
                        {b.intrinsic(Intrinsic::intBitsToFloat, b.types().float_, {n})}));
        ExprId less = b.intrinsic(Intrinsic::lessThan, b.types().bool_, {a, b.u(4)});
        add(b.intrinsic(Intrinsic::any, b.types().bool_, {less}));
        return sum;
    };
    EXPECT_THAT(stored(value), HasSubstr("uint(address < 4u)"));
}

TEST(Intrinsics, OfMatricesCompile) {
    auto value = [](Builder& b, ExprId a) {
        TypeId mat = b.types().matrix(b.types().float_, 3, 2), square = b.types().matrix(b.types().float_, 2, 2);
        TypeId float3 = b.types().vector(b.types().float_, 3), float2 = b.types().vector(b.types().float_, 2);
        ExprId x = as_float(b, a), m = b.make(Op::construct, mat, {x, x, x, x, x, x}),
               s = b.make(Op::construct, square, {x, x, x, x});
        auto product = [&](ExprId left, ExprId right, TypeId type) {
            ExprId id = b.times(left, right);
            b.program.exprs[id].type = type;
            return id;
        };
        ExprId column = product(m, b.make(Op::construct, float3, {x}), float2), row = product(column, m, float3);
        ExprId both = product(s, m, mat);
        ExprId quotient = b.binary(BinaryOp::divide, both, x);
        ExprId picked = b.make(Op::index, float2, {quotient, a});
        ExprId det =
            b.intrinsic(Intrinsic::determinant, b.types().float_, {b.intrinsic(Intrinsic::inverse, square, {s})});
        return b.plus(b.plus(b.plus(column, picked), b.lanes(row, {0, 1})), det);
    };
    std::string text = stored(value);
    EXPECT_THAT(text, HasSubstr("vec2 product(mat3x2 m, vec3 v)"));
}

TEST(Subgroups, AskForTheirExtensionsOnly) {
    Builder b;
    b.program.kernels[b.pass.kernel].group = {64, 1, 1};
    ExprId address = b.one_axis();
    auto out = b.buffer("g_data", b.types().uint, Access::read_write);
    LocalId tile = b.local("tile", b.types().array(b.types().uint, 64)), total = b.local("total", b.types().uint);
    b.program.locals[tile].storage = Storage::shared;
    b.pass.shared = {tile};
    b.pass.shared_places = {{tile}};
    ExprId element = b.make(Op::index, b.types().uint, {b.use(tile), address});
    ExprId sum = b.intrinsic(Intrinsic::subgroupExclusiveAdd, b.types().uint, {address});
    ExprId counted = b.intrinsic(Intrinsic::subgroupBallotExclusiveCount, b.types().uint, {b.less(address, b.u(5))});
    ExprId before = b.intrinsic(Intrinsic::atomicAdd, b.types().uint, {element, b.u(1)});
    b.pass.plain().body = {b.let(total, b.plus(sum, counted)), b.assign(b.use(total), b.plus(b.use(total), before)),
                           b.add(b.statement(StmtOp::barrier)),
                           b.branch(b.use(b.pass.in_range), {b.store(out, address, b.use(total))})};
    std::string text = proved(b);
    EXPECT_THAT(text, HasSubstr("shared uint tile[64];"));
    EXPECT_THAT(text, HasSubstr("bool in_range = address < size;"));
    EXPECT_THAT(text, HasSubstr("coherent buffer G_data"));
    EXPECT_THAT(
        text, HasSubstr("    controlBarrier(gl_ScopeWorkgroup, gl_ScopeWorkgroup, gl_StorageSemanticsBuffer\n        | "
                        "gl_StorageSemanticsShared, gl_SemanticsAcquireRelease);\n"));
    EXPECT_THAT(text, Not(HasSubstr("GL_KHR_shader_subgroup_shuffle")));
}

}  // namespace
}  // namespace gliftc::test
