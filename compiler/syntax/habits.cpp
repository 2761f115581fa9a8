#include "syntax/habits.h"

#include "syntax/parser_state.h"

#include <algorithm>
#include <iterator>

namespace gliftc {

namespace {

struct Habit {
    std::string_view word, hint;
};

constexpr std::string_view conversion = "conversions are written 'float(x)'";
constexpr std::string_view no_pointers = "there are no pointers and no references: an optional has 'none'";
constexpr std::string_view output = "kernels print by the statement 'print(\"speed {}\", v);' or 'print(v);'";
constexpr std::string_view own_address = "the address is an 'at' parameter of the kernel: 'a: at<S>'";
constexpr std::string_view elements = "elements are read by address, 's[a]', and filtered by 's.sample(x)'";

constexpr Habit names[] = {
    {"lerp", "it is called 'mix'"},
    {"frac", "it is called 'fract'"},
    {"rsqrt", "it is called 'inversesqrt'"},
    {"fabs", "it is called 'abs'"},
    {"fabsf", "it is called 'abs'"},
    {"sqrtf", "it is called 'sqrt'"},
    {"powf", "it is called 'pow'"},
    {"popcount", "it is called 'bitCount'"},
    {"countbits", "it is called 'bitCount'"},
    {"saturate", "write 'clamp(x, 0.0, 1.0)'"},
    {"fmod", "it is called 'mod', whose sign is that of 'y'"},
    {"fmodf", "it is called 'mod', whose sign is that of 'y'"},
    {"mul", "matrices and vectors are multiplied by '*'"},
    {"printf", output},
    {"print", output},
    {"cout", output},
    {"debugPrintfEXT", output},
    {"assert", "it is a statement: 'assert(condition);'"},
    {"NULL", no_pointers},
    {"nullptr", no_pointers},
    {"null", no_pointers},
    {"static_cast", conversion},
    {"reinterpret_cast", "bits are reinterpreted by 'floatBitsToUint' and the like"},
    {"texture", elements},
    {"texelFetch", elements},
    {"imageLoad", elements},
    {"imageStore", "elements are written by address, 's[a] = x'"},
    {"tex2D", elements},
    {"gl_GlobalInvocationID", own_address},
    {"threadIdx", own_address},
    {"blockIdx", own_address},
    {"SV_DispatchThreadID", own_address},
    {"__syncthreads", "it is called 'barrier()'"},
    {"sizeof", "there is none; in pipelines, 'count(s)' is the number of elements"},
    {"size_t", "whole numbers are int, uint, int64 and uint64"},
    {"unsigned", "it is called 'uint'"},
    {"char", "whole numbers are int, uint, int64 and uint64"},
    {"short", "whole numbers are int, uint, int64 and uint64"},
    {"long", "it is called 'int64'"},
    {"void", "a function without a result has no '->'"},
    {"auto", "variables are declared by 'let x = …;' or 'var x = …;'"},
    {"i32", "it is called 'int'"},
    {"u32", "it is called 'uint'"},
    {"i64", "it is called 'int64'"},
    {"u64", "it is called 'uint64'"},
    {"f16", "it is called 'half'"},
    {"f32", "it is called 'float'"},
    {"f64", "it is called 'double'"},
    {"int32_t", "it is called 'int'"},
    {"uint32_t", "it is called 'uint'"},
    {"int64_t", "it is called 'int64'"},
    {"uint64_t", "it is called 'uint64'"},
    {"True", "it is written 'true'"},
    {"False", "it is written 'false'"},
    {"None", "it is written 'none'"},
};

constexpr std::string_view import =
    "modules are imported by 'use std.array;', C++ structs by 'extern struct S from \"s.h\";'";
constexpr std::string_view function = "functions are written 'fn f(x: float) -> float { … }', constants 'const n = 3;'";
constexpr std::string_view memory =
    "memory belongs to structures: 'structure S(n: uint) { memory data = buffer<float>[n]; … }'";

constexpr Habit declarations[] = {
    {"using", import},
    {"import", import},
    {"from", import},
    {"include", import},
    {"void", function},
    {"float", function},
    {"double", function},
    {"int", function},
    {"uint", function},
    {"bool", function},
    {"half", function},
    {"auto", function},
    {"static", function},
    {"inline", function},
    {"constexpr", function},
    {"def", function},
    {"func", function},
    {"function", function},
    {"let", "constants are written 'const n = 3;'"},
    {"var", "constants are written 'const n = 3;'; there are no global variables"},
    {"layout", memory},
    {"uniform", memory},
    {"buffer", memory},
    {"cbuffer", memory},
    {"RWStructuredBuffer", memory},
    {"StructuredBuffer", memory},
    {"class", "there are 'struct' and 'structure'"},
    {"typedef", "types are named by 'type real = float;'"},
    {"template", "generic parameters follow the name: 'fn f<T: type>(x: T) -> T { … }'"},
    {"namespace", "a file is one module: 'module name;'"},
};

template <std::size_t n> std::string find(const Habit (&habits)[n], std::string_view word) {
    const auto* found =
        std::find_if(std::begin(habits), std::end(habits), [&](const Habit& habit) { return habit.word == word; });
    return found == std::end(habits) ? std::string() : std::string(found->hint);
}

/// What Glift calls a vector type of GLSL, or a square matrix type of floats: float3 for vec3, float4x4 for mat4; empty
/// for other names.
std::string glsl_type(std::string_view name) {
    constexpr Habit scalars[] = {{"vec", "float"}, {"ivec", "int"},    {"uvec", "uint"},
                                 {"bvec", "bool"}, {"dvec", "double"}, {"mat", "float"}};
    if (name.empty() || name.back() < '2' || name.back() > '4') return {};
    const std::string scalar = find(scalars, name.substr(0, name.size() - 1));
    if (scalar.empty()) return {};
    const std::string size(1, name.back());
    return scalar + (name.starts_with("mat") ? size + "x" + size : size);
}

}  // namespace

std::string hint_for_name(std::string_view name) {
    if (const std::string type = glsl_type(name); !type.empty()) return "it is called '" + type + "'";
    return find(names, name);
}

std::string hint_for_declaration(std::string_view word) {
    return glsl_type(word).empty() ? find(declarations, word) : std::string(function);
}

std::string hint_for_directive(std::string_view word) {
    if (word == "include" || word == "import") return std::string(import);
    if (word == "define") return "constants are written 'const n = 3;', functions 'fn f(x: float) -> float { … }'";
    if (word == "if" || word == "ifdef" || word == "ifndef") return "use an 'if' with a constant condition";
    if (word == "version" || word == "extension" || word == "pragma") return "there is none, and none is needed";
    return {};
}

/// The first token after the nearest `;`, `{` or `}` before the current one: that of the statement or declaration being
/// parsed, unless a braced list stands in it.
const Token& Parser::head() const {
    using enum TokenKind;
    std::uint32_t at = cursor_;
    while (at > 0) {
        const TokenKind before = tokens_[at - 1].kind;
        if (before == semicolon || before == open_brace || before == close_brace) break;
        --at;
    }
    return tokens_[at];
}

/// A hint for syntax of another language: how Glift writes it. The syntax is recognised by the tokens around the error
/// and by `wanted`, what the parser expects at the current token. Empty if none is recognised.
std::string Parser::habit(std::string_view wanted) const {
    using enum TokenKind;
    const auto before = [&](std::uint32_t back) { return cursor_ >= back ? tokens_[cursor_ - back] : Token{}; };
    const std::string_view word = text_of(peek()), first = text_of(head());
    const TokenKind last = before(1).kind;
    const bool is_name = at(identifier);
    if (word == "and" || word == "or" || word == "not") return "it is written '&&', '||' and '!'";
    if (word == "as") return std::string(conversion);
    if (at(arrow) && wanted == "';'") return "members are reached by '.'";
    if (at(colon) && peek(1).kind == colon)
        return "names of modules are written with '.', and seldom needed: 'max(a, b)'";
    if (before(1).kind == dot && before(2).kind == integer) return "write '" + std::string(text_of(before(2))) + ".0'";
    if (wanted == "'{'" &&
        (head().kind == kw_if || head().kind == kw_for || head().kind == kw_while || last == kw_else))
        return "braces are needed: 'if x { … }'";
    if (wanted == "'{'" && (head().kind == kw_fn || head().kind == kw_pub)) return "a result is written '-> float'";
    if (at(open_brace) && first == "do") return "there is no 'do': write 'while true { …; if !x { break; } }'";
    if (before(1).kind == identifier && text_of(before(1)) == "case")
        return "there is no 'case': write '1: { … }', and 'else: { … }' for other values";
    if (at(open_brace) && last == identifier && wanted == "';'")
        return "structs are made by their name, '" + std::string(text_of(before(1))) +
               "(…)', or by braces where the type is known";
    if ((at(star) || at(ampersand)) && before(2).kind == colon) return std::string(no_pointers);
    const bool begins_value = is_name || at(integer) || at(floating) || at(open_paren);
    if (begins_value && last == close_paren && before(2).kind == identifier && before(3).kind == open_paren)
        return "conversions are written '" + std::string(text_of(before(2))) + "(x)'";
    if (!is_name || last != identifier) return {};
    if (before(2).kind == kw_const || before(2).kind == kw_let || before(2).kind == kw_var)
        return "the type follows the name: '" + std::string(text_of(before(2))) + " " + std::string(word) + ": " +
               std::string(text_of(before(1))) + " = …;'";
    if (head().kind == kw_fn || head().kind == kw_pub)
        return "parameters are written '" + std::string(word) + ": " + std::string(text_of(before(1))) + "'";
    if (wanted == "';'" && &head() == &tokens_[cursor_ - 1])
        return "variables are declared by 'let " + std::string(word) + " = …;' or 'var " + std::string(word) + ": " +
               (first == "auto" ? "float" : std::string(first)) + " = …;'";
    return {};
}

}  // namespace gliftc
