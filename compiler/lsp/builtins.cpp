#include "lsp/builtins.h"

#include <algorithm>

namespace gliftc::lsp {

namespace {

/// The meaning of a letter in a signature of ir/intrinsics.def.
std::string_view kind_of(char letter) {
    switch (letter) {
    case 'F':
    case 'G': return "floating";
    case 'N': return "number";
    case 'I': return "integer";
    case 'J': return "int or uint";
    case 'U': return "uint";
    case 'S': return "int";
    case 'B': return "bool";
    case 'R': return "float";
    case 'D': return "double";
    case 'L': return "uint64";
    case 'V': return "vector";
    case 'f': return "float";
    case 'u': return "uint";
    case 'i': return "int";
    case 'b': return "bool";
    case 'v': return "nothing";
    case 'w': return "uint4";
    case '2': return "float2";
    case '4': return "float4";
    case 'M':
    case 't': return "matrix";
    case '=': return "scalar";
    default: return "any";
    }
}

BuiltinFunction decoded(std::string_view name, std::string_view signature) {
    BuiltinFunction made{name, {}, {}};
    const bool is_memory = signature.starts_with('@');
    if (is_memory) signature.remove_prefix(1);
    const std::size_t colon = signature.find(':');
    for (std::size_t i = 0; i < colon; ++i) {
        if (signature[i] == 'n') made.parameters.back() += " or scalar";
        else made.parameters.emplace_back(kind_of(signature[i]));
    }
    if (is_memory) made.parameters.front() += " in memory";
    made.result = kind_of(signature[colon + 1]);
    return made;
}

}  // namespace

std::string BuiltinFunction::signature() const {
    std::string text = std::string(name) + "(";
    for (std::size_t i = 0; i < parameters.size(); ++i) text += (i ? ", " : "") + parameters[i];
    return text + ") -> " + result;
}

const std::vector<BuiltinFunction>& builtin_functions() {
    static const std::vector<BuiltinFunction> functions = [] {
        std::vector<BuiltinFunction> made;
#define INTRINSIC(name, signature, exactness) made.push_back(decoded(#name, signature));
#include "ir/intrinsics.def"
#undef INTRINSIC
        made.push_back({"select", {"bool", "any", "any"}, "any"});
        made.push_back({"position", {}, "address"});
        for (std::string_view name : {"local_index", "group_index", "group_count", "group_size", "subgroup_size",
                                      "subgroup_lane", "subgroup_count", "subgroup_index"})
            made.push_back({name, {}, "uint"});
        made.push_back({"count", {"structure or slice"}, "uint"});
        made.push_back({"expect", {"bool"}, "nothing"});
        made.push_back({"expect_near", {"value", "expected value", "tolerance"}, "nothing"});
        made.push_back({"expect_same", {"structure", "structure"}, "nothing"});
        return made;
    }();
    return functions;
}

const BuiltinFunction* find_builtin_function(std::string_view name) {
    const auto found = std::ranges::find(builtin_functions(), name, &BuiltinFunction::name);
    return found == builtin_functions().end() ? nullptr : &*found;
}

const std::vector<std::string_view>& builtin_types() {
    static const std::vector<std::string_view> types = {
        "bool",     "int",      "uint",  "float",  "half",     "double",   "int64",     "uint64",    "bool2",
        "bool3",    "bool4",    "int2",  "int3",   "int4",     "uint2",    "uint3",     "uint4",     "float2",
        "float3",   "float4",   "half2", "half3",  "half4",    "double2",  "double3",   "double4",   "float2x2",
        "float3x3", "float4x4", "vec",   "mat",    "buffer",   "image1d",  "image2d",   "image3d",   "imagecube",
        "r8",       "rg8",      "rgba8", "r16f",   "rg16f",    "rgba16f",  "r32f",      "rg32f",     "rgba32f",
        "r8ui",     "r16ui",    "r32ui", "rg32ui", "rgba32ui", "r32i",     "rg32i",     "rgba32i",   "rgba8ui",
        "d32",      "type",     "Texel", "Number", "Integer",  "Floating", "Structure", "Translator"};
    return types;
}

const std::vector<Pattern>& patterns() {
    static const std::vector<Pattern> all = {
        {"each", "The kernel runs once for each element, which the name means."},
        {"near", "The current element and its neighbours up to a radius: near<S, 1>; read by s[offset]."},
        {"any", "Any element is read by its address: s[address]."},
        {"at", "The kernel runs once for each address, which the name means; elements are not read."},
        {"scatter", "Any element is written by its address; an operation combines writes: scatter<S, add>."},
        {"coherent", "Any element is read, written and changed atomically: inout coherent<S>."},
        {"calls", "Functions of a structure are called that write its members."},
        {"target", "Pixels that a draw writes: target<S>, target<S, less>."},
        {"instance", "Elements that a draw visits along the axis of instances."},
        {"range", "Any structure or slice with N-dimensional addresses and elements T: range<N, T>."},
    };
    return all;
}

const std::vector<std::string_view>& keywords() {
    static const std::vector<std::string_view> words = {
#define PUNCTUATION(name, text)
#define KEYWORD(text) #text,
#define WORD(text) #text,
#include "syntax/tokens.def"
#undef PUNCTUATION
#undef KEYWORD
#undef WORD
    };
    return words;
}

const std::vector<std::string_view>& structure_methods() {
    static const std::vector<std::string_view> names = {"domain", "sample",    "gather",   "compare",
                                                        "find",   "translate", "contains", "load",
                                                        "store",  "blocks",    "block",    "block_size"};
    return names;
}

}  // namespace gliftc::lsp
