// long: the texts of all helpers stand together
// Helpers: operations that GLSL lacks or does not define for all operands, or that drivers get wrong, as functions
// printed before those of the source, if they are used. Arithmetic helpers give the same bits as the host device and
// the constant evaluator if division is correctly rounded (Rounding::correct), except `angle` (atan2) away from (0, 0).
#include "emit/glsl/printer.h"

#include <algorithm>
#include <stdexcept>

namespace gliftc::glsl {

using ir::TypeId;

namespace {

const char* name_of(Helper helper) {
    switch (helper) {
    case Helper::quotient: return "quotient";
    case Helper::remainder: return "remainder";
    case Helper::modulo: return "modulo";
    case Helper::to_int: return "to_int";
    case Helper::to_uint: return "to_uint";
    case Helper::to_int64: return "to_int64";
    case Helper::to_uint64: return "to_uint64";
    case Helper::to_half: return "to_half";
    case Helper::nearest_half: return "nearest_half";
    case Helper::ordered_dot: return "ordered_dot";
    case Helper::cross_product: return "cross_product";
    case Helper::blend: return "blend";
    case Helper::angle: return "angle";
    case Helper::smooth_step: return "smooth_step";
    case Helper::fraction: return "fraction";
    case Helper::sign_of: return "sign_of";
    case Helper::negative: return "negative";
    case Helper::magnitude: return "magnitude";
    case Helper::reflection: return "reflection";
    case Helper::matrix_vector:
    case Helper::vector_matrix:
    case Helper::matrix_matrix: return "product";
    case Helper::matrix_scalar_quotient: return "quotient";
    case Helper::pack_unorm: return "pack_unorm";
    case Helper::unpack_unorm: return "unpack_unorm";
    case Helper::extract_bits: return "extract_bits";
    case Helper::insert_bits: return "insert_bits";
    case Helper::far_index: return "far_index";
    case Helper::whole_vector: return "whole_vector";
    case Helper::split_float: return "split";
    case Helper::divide: return "divide";
    case Helper::divide_by: return "divide_by";
    case Helper::quick_divide: return "quick_divide";
    case Helper::quick_divide_by: return "quick_divide_by";
    case Helper::square_root: return "square_root";
    case Helper::shuffled: return "shuffled";
    case Helper::shuffled_xor: return "shuffled_xor";
    case Helper::shuffled_up: return "shuffled_up";
    case Helper::shuffled_down: return "shuffled_down";
    case Helper::broadcast: return "broadcast";
    case Helper::broadcast_first: return "broadcast_first";
    case Helper::skips_branches: return "skips_branches";
    case Helper::adds_floats: return "adds_floats";
    }
    throw std::logic_error("emit/glsl: unknown helper");
}

/// A vector type by its scalar and size, for vectors of which the program may have no TypeId: the columns of a matrix.
std::string vector_text(Printer& p, TypeId scalar, std::uint32_t count) {
    std::string text = type_text(p, scalar);
    if (count == 1) return text;
    const char* prefix = text == "float"       ? ""
                         : text == "int"       ? "i"
                         : text == "uint"      ? "u"
                         : text == "double"    ? "d"
                         : text == "float16_t" ? "f16"
                         : text == "int64_t"   ? "i64"
                         : text == "uint64_t"  ? "u64"
                                               : "b";
    return prefix + std::string("vec") + std::to_string(count);
}

/// The function for vectors that applies the one for scalars to each component, with two parameters if `two`:
/// `T f(T a, T b) { return T(f(a.x, b.x), f(a.y, b.y)); }`
std::string by_component(const std::string& result, const std::string& name, const std::string& type,
                         std::uint32_t count, bool two) {
    std::string text =
        result + " " + name + "(" + type + " a" + (two ? ", " + type + " b" : "") + ") {\n    return " + result + "(";
    for (std::uint32_t i = 0; i < count; ++i) {
        std::string lane(1, "xyzw"[i]);
        text += (i ? ", " : "") + name + "(a." + lane + (two ? ", b." + lane : "") + ")";
    }
    return text + ");\n}\n";
}

std::string one_line(const std::string& head, const std::string& value) {
    return head + " {\n    return " + value + ";\n}\n";
}

/// Quotient or remainder of unsigned 64-bit integers.
std::string long_division(Helper helper) {
    const std::string op = helper == Helper::quotient ? "/" : "%";
    std::string text =
        "// In 32 bits where both are small: GPUs divide 64 bits slowly, and NVIDIA's driver (580) merges\n"
        "// two different addresses if both contain a 64-bit remainder.\n";
    text += std::string("uint64_t ") + name_of(helper) + "(uint64_t a, uint64_t b) {\n    b = max(b, 1ul);\n";
    text += "    if (uint((a | b) >> 32) == 0u) return uint64_t(uint(a) " + op + " uint(b));\n";
    return text + "    return a " + op + " b;\n}\n";
}

std::string integer_division(Printer& p, const HelperUse& use) {
    std::string type = type_text(p, use.a);
    std::uint32_t count = p.program.types.components(use.a);
    if (count > 1) return by_component(type, name_of(use.helper), type, count, true);
    if (use.a == p.program.types.uint64) return long_division(use.helper);
    bool wide = type == "int64_t";
    std::string lowest = wide ? "int64_t(0x8000000000000000ul)" : "int(0x80000000u)", l = wide ? "l" : "";
    std::string safe = "b == 0" + l + " || (a == " + lowest + " && b == -1" + l + ") ? 1" + l + " : b";
    if (use.helper == Helper::quotient)
        return "// Division by zero, and the one that overflows, divide by one.\n" +
               one_line(type + " quotient(" + type + " a, " + type + " b)", "a / (" + safe + ")");
    return "// Has the sign of the dividend.\n" +
           one_line(type + " remainder(" + type + " a, " + type + " b)", "a - quotient(a, b) * (" + safe + ")");
}

struct Conversion {
    const char* result;
    const char* prefix;
    const char* low;
    const char* high;
    const char* least;
    const char* most;
};

Conversion conversion_of(Helper helper) {
    switch (helper) {
    case Helper::to_int: return {"int", "i", "-2147483648.0", "2147483648.0", "int(0x80000000u)", "2147483647"};
    case Helper::to_uint: return {"uint", "u", "0.0", "4294967296.0", "0u", "4294967295u"};
    case Helper::to_int64:
        return {"int64_t",
                "i64",
                "-9223372036854775808.0",
                "9223372036854775808.0",
                "int64_t(0x8000000000000000ul)",
                "9223372036854775807l"};
    default: return {"uint64_t", "u64", "0.0", "18446744073709551616.0", "0ul", "18446744073709551615ul"};
    }
}

/// The beginning of a function that converts x, of a floating-point type, to an integer. `safe` is x, or 0 where the
/// result cannot represent it: that is converted, and the result chosen afterwards. The conversion of a number that
/// does not fit is undefined, also where its result is not used: lavapipe's compiler (LLVM 15) made undefined addresses
/// of it.
std::string conversion_begin(const HelperUse& use, const std::string& type, const std::string& x) {
    const Conversion c = conversion_of(use.helper);
    const std::string suffix = type == "double" ? "lf" : "", number = type == "double" ? "double" : "float";
    return std::string("// Saturates; not-a-number gives 0.\n") + c.result + " " + name_of(use.helper) + "(" + type +
           " x) {\n    " + number + " safe = " + x + " >= " + c.low + suffix + " && " + x + " < " + c.high + suffix +
           " ? " + x + " : 0.0" + suffix + ";\n";
}

/// The end of the function: `fitting`, the conversion of `safe`, is the result unless x is above the integer's range
/// or, if the integer is signed, below it.
std::string conversion_end(const HelperUse& use, const std::string& type, const std::string& x,
                           const std::string& fitting) {
    const Conversion c = conversion_of(use.helper);
    const bool is_signed = use.helper == Helper::to_int || use.helper == Helper::to_int64;
    const std::string suffix = type == "double" ? "lf" : "";
    const std::string below = is_signed ? x + " < " + c.low + suffix + " ? " + c.least + " : " : "";
    return "    return " + x + " >= " + c.high + suffix + " ? " + c.most + " : " + below + fitting + ";\n}\n";
}

/// Converts a floating-point number to an integer of 64 bits in two steps, the upper 32 bits and the lower ones. If a
/// program uses only the lower half of a conversion to 64 bits, NVIDIA's driver (580) replaces it by a conversion to 32
/// bits, which saturates. Both steps are exact.
std::string saturating_conversion_64(const HelperUse& use, const std::string& type) {
    const bool is_signed = use.helper == Helper::to_int64;
    const std::string suffix = type == "double" ? "lf" : "";
    const std::string size = is_signed ? "abs(safe)" : "safe";
    const std::string bits = "packUint2x32(uvec2(low, high))";
    const std::string fitting =
        is_signed ? "int64_t(safe < 0.0" + suffix + " ? 0ul - " + bits + " : " + bits + ")" : bits;
    return conversion_begin(use, type, "x") + "    uint high = uint(" + size + " * 2.3283064365386962890625e-10" +
           suffix + ");\n    uint low = uint(" + size + " - " + type + "(high) * 4294967296.0" + suffix + ");\n" +
           conversion_end(use, type, "x", fitting);
}

std::string saturating_conversion(Printer& p, const HelperUse& use) {
    Conversion c = conversion_of(use.helper);
    const bool is_wide = use.helper == Helper::to_int64 || use.helper == Helper::to_uint64;
    if (is_wide) p.extensions.insert("GL_EXT_shader_explicit_arithmetic_types_int64");
    std::string type = type_text(p, use.a), name = name_of(use.helper);
    std::uint32_t count = p.program.types.components(use.a);
    if (count > 1) return by_component(c.prefix + std::string("vec") + std::to_string(count), name, type, count, false);
    if (is_wide && type != "float16_t") return saturating_conversion_64(use, type);
    // The bounds are 0 and powers of two up to 2^64, or the negatives of these: exact as floats and doubles. A half is
    // compared as a float, since most bounds are beyond the largest half.
    const std::string x = type == "float16_t" ? "float(x)" : "x";
    return conversion_begin(use, type, x) + conversion_end(use, type, x, std::string(c.result) + "(safe)");
}

/// The conversion of a double to a half, which rounds once on all drivers. Mesa's drivers do a plain conversion in two
/// steps, by way of a float, and so round twice; NVIDIA's driver rounds once.
std::string half_of_double() {
    return "// Rounds once: x is rounded to odd as a float, which then rounds to the half nearest to x.\n"
           "float16_t to_half(double x) {\n    float f = float(x);\n    double rest = x - double(f);\n"
           "    int bits = floatBitsToInt(f);\n"
           "    if (abs(f) > 1e-9 && abs(rest) > 0.0lf && (bits & 1) == 0) bits += (rest > 0.0lf) == (f > 0.0) ? 1 : "
           "-1;\n"
           "    return float16_t(intBitsToFloat(bits)) + float16_t(-0.0);\n}\n";
}

constexpr const char* nearest_half_text =
    R"(// Rounds to halves, ties to even: drivers may round towards zero where they store texels of 16-bit floats.
vec4 nearest_half(vec4 x) {
    uvec4 bits = floatBitsToUint(x) & 0x7fffffffu, sign = floatBitsToUint(x) & 0x80000000u;
    uvec4 rounded = (bits + 0xfffu + (bits >> 13 & 1u)) & 0xffffe000u;
    rounded = mix(rounded, uvec4(0x7f800000u), greaterThanEqual(rounded, uvec4(0x47800000u)));
    uvec4 subnormal = floatBitsToUint(roundEven(abs(x) * 16777216.0) * 5.9604644775390625e-8);
    rounded = mix(rounded, subnormal, lessThan(bits, uvec4(0x38800000u)));
    return mix(uintBitsToFloat(rounded | sign), x, isnan(x));
}
)";

std::string half_conversion(Printer& p, const HelperUse& use) {
    const ir::Types& types = p.program.types;
    const std::uint32_t count = types.components(use.a);
    const std::string half = vector_text(p, types.half, count);
    if (types.scalar_of(use.a) == types.double_)
        return count > 1 ? by_component(half, "to_half", type_text(p, use.a), count, false) : half_of_double();
    return "// Adding -0 keeps drivers from leaving out a conversion to half and back, which rounds.\n" +
           one_line(half + " to_half(" + type_text(p, use.a) + " x)", half + "(x) + float16_t(-0.0)");
}

std::string dot_definition(Printer& p, const HelperUse& use) {
    const ir::Types& types = p.program.types;
    std::string scalar = type_text(p, types.scalar_of(use.a)), type = type_text(p, use.a), sum = "a.x * b.x";
    for (std::uint32_t i = 1; i < types.components(use.a); ++i) {
        std::string lane(1, "xyzw"[i]);
        sum += " + a." + lane + " * b." + lane;
    }
    return one_line(scalar + " ordered_dot(" + type + " a, " + type + " b)", sum);
}

std::string matrix_definition(Printer& p, const HelperUse& use) {
    const ir::Types& types = p.program.types;
    std::string a = type_text(p, use.a), b = use.b ? type_text(p, use.b) : "";
    TypeId scalar = types.scalar_of(use.a);
    const ir::Type& matrix = types[use.helper == Helper::vector_matrix ? use.b : use.a];
    std::string value;
    if (use.helper == Helper::matrix_vector) {
        for (std::uint32_t i = 0; i < matrix.count; ++i)
            value += (i ? " + m[" : "m[") + std::to_string(i) + "] * v." + "xyzw"[i];
        return one_line(vector_text(p, scalar, matrix.rows) + " product(" + a + " m, " +
                            vector_text(p, scalar, matrix.count) + " v)",
                        value);
    }
    if (use.helper == Helper::vector_matrix) {
        std::string result = vector_text(p, scalar, matrix.count);
        for (std::uint32_t i = 0; i < matrix.count; ++i)
            value += (i ? ", " : "") + std::string("ordered_dot(v, m[") + std::to_string(i) + "])";
        return one_line(result + " product(" + a + " v, " + b + " m)", result + "(" + value + ")");
    }
    const ir::Type& right = types[use.b ? use.b : use.a];
    std::string prefix = type_text(p, scalar) == "double"      ? "dmat"
                         : type_text(p, scalar) == "float16_t" ? "f16mat"
                                                               : "mat";
    std::string result = prefix + std::to_string(right.count) + "x" + std::to_string(matrix.rows);
    for (std::uint32_t i = 0; i < right.count; ++i) {
        std::string column = "[" + std::to_string(i) + "]";
        value += i ? ", " : "";
        if (use.helper == Helper::matrix_matrix) value += "product(a, b" + column + ")";
        else if (!corrects_division(p, scalar)) value += "a" + column + " / b";
        else
            for (std::uint32_t j = 0; j < matrix.rows; ++j)
                value += (j ? ", divide(a" : "divide(a") + column + "[" + std::to_string(j) + "], b)";
    }
    std::string second = use.helper == Helper::matrix_matrix ? b + " b" : type_text(p, scalar) + " b";
    return one_line(result + (use.helper == Helper::matrix_matrix ? " product(" : " quotient(") + a + " a, " + second +
                        ")",
                    result + "(" + value + ")");
}

std::string arithmetic(Printer& p, const HelperUse& use) {
    const ir::Types& types = p.program.types;
    std::string t = type_text(p, use.a), zero_text = t + "(0.0)", one = t + "(1.0)", two = t + "(2.0)",
                three = t + "(3.0)";
    switch (use.helper) {
    case Helper::modulo:
        return one_line(t + " modulo(" + t + " a, " + t + " b)",
                        "a - b * floor(" + quotient_of(p, use.a, "a", "b") + ")");
    case Helper::cross_product:
        return one_line(t + " cross_product(" + t + " a, " + t + " b)", "a.yzx * b.zxy - a.zxy * b.yzx");
    case Helper::blend:
        return one_line(t + " blend(" + t + " x, " + t + " y, " + t + " a)", "x * (" + one + " - a) + y * a");
    case Helper::angle: {
        const std::uint32_t count = types.components(use.a);
        if (count > 1) return by_component(t, "angle", t, count, true);
        const std::string pi = t + "(3.14159265)";
        // Floats so small that their reciprocals may be infinite are scaled by 2^64, which is exact. Halves are
        // converted to floats: as floats, the reciprocals of all halves but zero are finite.
        const std::string scaled = use.a == types.half
                                       ? "to_half(atan(float(y), float(x)))"
                                       : "max(abs(x), abs(y)) < 1e-30 ? atan(y * 18446744073709551616.0, "
                                         "x * 18446744073709551616.0) : atan(y, x)";
        return "// The angle of (0, 0), which GLSL leaves undefined, follows from the signs of the zeros. Numbers so "
               "small\n"
               "// that their reciprocals are infinite are scaled up.\n" +
               t + " angle(" + t + " y, " + t + " x) {\n    if (x != " + zero_text + " || y != " + zero_text +
               ") return " + scaled + ";\n    if (floatBitsToInt(float(x)) >= 0) return y;\n" +
               "    return floatBitsToInt(float(y)) < 0 ? -" + pi + " : " + pi + ";\n}\n";
    }
    case Helper::smooth_step:
        return t + " smooth_step(" + t + " low, " + t + " high, " + t + " x) {\n    " + t + " s = min(max(" +
               (corrects_division(p, use.a) ? quotient_of(p, use.a, "x - low", "high - low")
                                            : "(x - low) / (high - low)") +
               ", " + zero_text + "), " + one + ");\n    return s * s * (" + three + " - " + two + " * s);\n}\n";
    case Helper::fraction: return one_line(t + " fraction(" + t + " x)", "x - floor(x)");
    case Helper::sign_of: {
        std::uint32_t count = types.components(use.a);
        if (count > 1) return by_component(t, "sign_of", t, count, false);
        if (types.is_floating(use.a))
            return one_line(t + " sign_of(" + t + " x)", "x > " + zero_text + " ? " + one + " : x < " + zero_text +
                                                             " ? -" + one + " : " + zero_text);
        // The sign is found from the upper and the lower 32 bits, not by `x > 0`: where lavapipe unrolls a loop over k
        // from 0u on, it evaluates int64_t(k) > 0 to true even for k = 0u.
        return "int64_t sign_of(int64_t x) {\n    int high = int(x >> 32l);\n"
               "    return high < 0 ? -1l : (high | int(x)) != 0 ? 1l : 0l;\n}\n";
    }
    case Helper::negative:
        return "// By the sign bit: drivers may drop the sign of zero of -x if x is a choice between 0.0 and 1.0.\n" +
               one_line(t + " negative(" + t + " x)", "uintBitsToFloat(floatBitsToUint(x) ^ 0x80000000u)");
    case Helper::magnitude:
        return "// By the sign bit: drivers may take x for positive if it is a choice that -0.0 is in.\n" +
               one_line(t + " magnitude(" + t + " x)", "uintBitsToFloat(floatBitsToUint(x) & 0x7fffffffu)");
    case Helper::reflection:
        return one_line(t + " reflection(" + t + " i, " + t + " n)",
                        "i - (" + type_text(p, p.program.types.scalar_of(use.a)) + "(2.0) * ordered_dot(n, i)) * n");
    default: break;
    }
    throw std::logic_error("emit/glsl: unknown arithmetic helper");
}

std::string bits_definition(Printer& p, const HelperUse& use) {
    if (use.helper == Helper::pack_unorm)
        return "uint pack_unorm(vec4 v) {\n    uvec4 bytes = uvec4(roundEven(min(max(v, 0.0), 1.0) * 255.0));\n"
               "    return bytes.x | (bytes.y << 8) | (bytes.z << 16) | (bytes.w << 24);\n}\n";
    if (use.helper == Helper::unpack_unorm)
        return "vec4 unpack_unorm(uint v) {\n    return " +
               quotient_of(p, use.a, "vec4(uvec4(v, v >> 8, v >> 16, v >> 24) & 255u)", "vec4(255.0)") + ";\n}\n";
    std::string t = type_text(p, use.a);
    std::string clamp =
        "    int first = int(min(uint(offset), 32u));\n    int count = int(min(uint(bits), uint(32 - first)));\n";
    if (use.helper == Helper::extract_bits)
        return t + " extract_bits(" + t + " value, int offset, int bits) {\n" + clamp + "    return count == 0 ? " + t +
               "(0) : bitfieldExtract(value, first, count);\n}\n";
    return t + " insert_bits(" + t + " base, " + t + " value, int offset, int bits) {\n" + clamp +
           "    return count == 0 ? base : bitfieldInsert(base, value, first, count);\n}\n";
}

// long: a case for each helper
std::string definition(Printer& p, const HelperUse& use) {
    switch (use.helper) {
    case Helper::quotient:
    case Helper::remainder: return integer_division(p, use);
    case Helper::to_int:
    case Helper::to_uint:
    case Helper::to_int64:
    case Helper::to_uint64: return saturating_conversion(p, use);
    case Helper::to_half: return half_conversion(p, use);
    case Helper::nearest_half: return nearest_half_text;
    case Helper::ordered_dot: return dot_definition(p, use);
    case Helper::matrix_vector:
    case Helper::vector_matrix:
    case Helper::matrix_matrix:
    case Helper::matrix_scalar_quotient: return matrix_definition(p, use);
    case Helper::modulo:
    case Helper::cross_product:
    case Helper::blend:
    case Helper::angle:
    case Helper::smooth_step:
    case Helper::fraction:
    case Helper::sign_of:
    case Helper::negative:
    case Helper::magnitude:
    case Helper::reflection: return arithmetic(p, use);
    case Helper::pack_unorm:
    case Helper::unpack_unorm:
    case Helper::extract_bits:
    case Helper::insert_bits: return bits_definition(p, use);
    case Helper::far_index:
        return "// A function, since GLSL refuses constant indices from 2^31 on.\nuint far_index(uint i) { return i; "
               "}\n";
    case Helper::whole_vector:
        return "// Keeps Mesa from combining this load with one of a single component by address, which would give "
               "component 0.\n" +
               one_line(type_text(p, use.a) + " whole_vector(" + type_text(p, use.a) + " v)", "v");
    case Helper::split_float:
    case Helper::divide_by:
    case Helper::quick_divide_by: return division_definition(p, use);
    case Helper::divide:
    case Helper::quick_divide:
    case Helper::square_root: {
        std::uint32_t count = p.program.types.components(use.a);
        if (count == 1) return division_definition(p, use);
        return by_component(type_text(p, use.a), name_of(use.helper), type_text(p, use.a), count,
                            use.helper != Helper::square_root);
    }
    case Helper::shuffled:
    case Helper::shuffled_xor:
    case Helper::shuffled_up:
    case Helper::shuffled_down:
    case Helper::broadcast:
    case Helper::broadcast_first: return subgroup_definition(p, use);
    case Helper::skips_branches:
        return "layout(constant_id = 104) const bool skips_branches = true;   // the device skips branches that no "
               "lane takes\n";
    case Helper::adds_floats:
        return "layout(constant_id = 105) const bool adds_floats = true;   // the device adds floats by one atomic "
               "operation\n";
    }
    throw std::logic_error("emit/glsl: unknown helper");
}

/// Notes as needed the helpers that the definition of `use` calls.
// long: a case for each helper
void need_inner(Printer& p, const HelperUse& use) {
    const ir::Types& types = p.program.types;
    TypeId scalar = use.a ? types.scalar_of(use.a) : TypeId{};
    switch (use.helper) {
    case Helper::quotient:
    case Helper::to_int:
    case Helper::to_uint:
    case Helper::to_int64:
    case Helper::to_uint64:
    case Helper::sign_of:
        if (types.components(use.a) > 1) need(p, use.helper, scalar);
        break;
    case Helper::angle:
        if (types.components(use.a) > 1) need(p, use.helper, scalar);
        else if (use.a == types.half) need(p, Helper::to_half, types.float_);
        break;
    case Helper::remainder:
        if (types.components(use.a) > 1) need(p, use.helper, scalar);
        else if (types.is_signed(use.a)) need(p, Helper::quotient, use.a);
        break;
    case Helper::vector_matrix:
    case Helper::reflection: need(p, Helper::ordered_dot, use.a); break;
    case Helper::divide:
    case Helper::divide_by:
    case Helper::quick_divide:
    case Helper::quick_divide_by:
    case Helper::square_root:
        if (types.components(use.a) > 1) {
            need(p, use.helper, scalar);
        } else if (use.helper == Helper::quick_divide_by) {
            need(p, Helper::divide_by, types.float_);
            need(p, Helper::quick_divide, types.float_);
        } else if (use.helper == Helper::divide_by || use.helper == Helper::quick_divide) {
            need(p, Helper::divide, types.float_);
        } else if (use.a == types.half) {
            need(p, use.helper, types.float_);
            need(p, Helper::to_half, types.float_);
        } else {
            need(p, Helper::split_float, {});
        }
        break;
    case Helper::modulo:
    case Helper::smooth_step:
    case Helper::unpack_unorm:
        if (corrects_division(p, use.a)) need(p, Helper::divide, use.a);
        break;
    case Helper::matrix_scalar_quotient:
        if (corrects_division(p, use.a)) need(p, Helper::divide, scalar);
        break;
    case Helper::matrix_matrix: need(p, Helper::matrix_vector, use.a); break;
    case Helper::shuffled:
    case Helper::shuffled_xor:
    case Helper::shuffled_up:
    case Helper::shuffled_down:
    case Helper::broadcast:
    case Helper::broadcast_first: need_inner_of_subgroup(p, use); break;
    case Helper::to_half:
        if (types.components(use.a) > 1 && scalar == types.double_) need(p, use.helper, scalar);
        break;
    case Helper::nearest_half:
    case Helper::split_float:
    case Helper::ordered_dot:
    case Helper::matrix_vector:
    case Helper::cross_product:
    case Helper::blend:
    case Helper::fraction:
    case Helper::negative:
    case Helper::magnitude:
    case Helper::pack_unorm:
    case Helper::extract_bits:
    case Helper::insert_bits:
    case Helper::far_index:
    case Helper::whole_vector:
    case Helper::skips_branches:
    case Helper::adds_floats: break;
    }
}

}  // namespace

std::string need(Printer& p, Helper helper, TypeId a, TypeId b) {
    HelperUse use{helper, a, b};
    if (std::find(p.helpers.begin(), p.helpers.end(), use) == p.helpers.end()) {
        need_inner(p, use);
        p.helpers.push_back(use);
    }
    return name_of(helper);
}

std::vector<std::string> helper_list(Printer& p) {
    std::vector<std::string> texts;
    for (const HelperUse& use : p.helpers) {
        std::string made = definition(p, use);
        // Two uses may have the same text, since enums print as uint.
        if (std::ranges::find(texts, made) == texts.end()) texts.push_back(std::move(made));
    }
    return texts;
}

std::string helper_definitions(Printer& p) {
    std::string text;
    for (const std::string& made : helper_list(p)) text += made + "\n";
    return text;
}

}  // namespace gliftc::glsl
