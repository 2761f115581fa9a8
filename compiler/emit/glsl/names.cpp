#include "emit/glsl/names.h"

#include <cctype>

namespace gliftc::glsl {

namespace {

const std::unordered_set<std::string_view>& reserved_words() {
    static const std::unordered_set<std::string_view> words = {
        // keywords
        "attribute",
        "atomic_uint",
        "bool",
        "break",
        "buffer",
        "bvec2",
        "bvec3",
        "bvec4",
        "case",
        "centroid",
        "coherent",
        "const",
        "continue",
        "default",
        "discard",
        "demote",
        "dmat2",
        "dmat3",
        "dmat4",
        "do",
        "double",
        "dvec2",
        "dvec3",
        "dvec4",
        "else",
        "flat",
        "false",
        "float",
        "for",
        "highp",
        "if",
        "in",
        "inout",
        "int",
        "invariant",
        "ivec2",
        "ivec3",
        "ivec4",
        "layout",
        "lowp",
        "mat2",
        "mat3",
        "mat4",
        "mediump",
        "noperspective",
        "nonuniformEXT",
        "out",
        "patch",
        "precise",
        "precision",
        "readonly",
        "restrict",
        "return",
        "sample",
        "sampler",
        "samplerShadow",
        "shared",
        "smooth",
        "struct",
        "subroutine",
        "subpassInput",
        "switch",
        "texture",
        "true",
        "uint",
        "uniform",
        "uvec2",
        "uvec3",
        "uvec4",
        "varying",
        "vec2",
        "vec3",
        "vec4",
        "void",
        "volatile",
        "while",
        "writeonly",
        "half",
        "fixed",
        "unsigned",
        "superp",
        "int8_t",
        "uint8_t",
        "int16_t",
        "uint16_t",
        "int32_t",
        "uint32_t",
        "int64_t",
        "uint64_t",
        "float16_t",
        "float32_t",
        "float64_t",
        "workgroupcoherent",
        "subgroupcoherent",
        "nonprivate",
        // reserved for later
        "common",
        "partition",
        "active",
        "asm",
        "class",
        "union",
        "enum",
        "typedef",
        "template",
        "this",
        "resource",
        "goto",
        "inline",
        "noinline",
        "public",
        "static",
        "extern",
        "external",
        "interface",
        "long",
        "short",
        "input",
        "output",
        "hvec2",
        "hvec3",
        "hvec4",
        "fvec2",
        "fvec3",
        "fvec4",
        "filter",
        "sizeof",
        "cast",
        "namespace",
        "using",
        // built-in functions
        "radians",
        "degrees",
        "sin",
        "cos",
        "tan",
        "asin",
        "acos",
        "atan",
        "sinh",
        "cosh",
        "tanh",
        "asinh",
        "acosh",
        "atanh",
        "pow",
        "exp",
        "log",
        "exp2",
        "log2",
        "sqrt",
        "inversesqrt",
        "abs",
        "sign",
        "floor",
        "trunc",
        "round",
        "roundEven",
        "ceil",
        "fract",
        "mod",
        "modf",
        "min",
        "max",
        "clamp",
        "mix",
        "step",
        "smoothstep",
        "isnan",
        "isinf",
        "fma",
        "frexp",
        "ldexp",
        "length",
        "distance",
        "dot",
        "cross",
        "normalize",
        "faceforward",
        "reflect",
        "refract",
        "outerProduct",
        "transpose",
        "determinant",
        "inverse",
        "lessThan",
        "lessThanEqual",
        "greaterThan",
        "greaterThanEqual",
        "equal",
        "notEqual",
        "any",
        "all",
        "not",
        "uaddCarry",
        "usubBorrow",
        "umulExtended",
        "imulExtended",
        "bitfieldExtract",
        "bitfieldInsert",
        "bitfieldReverse",
        "bitCount",
        "findLSB",
        "findMSB",
        "texelFetch",
        "textureSize",
        "textureLod",
        "textureGrad",
        "textureGather",
        "imageLoad",
        "imageStore",
        "imageSize",
        "barrier",
        "controlBarrier",
        "subgroupBarrier",
        "memoryBarrier",
        "memoryBarrierBuffer",
        "memoryBarrierShared",
        "memoryBarrierImage",
        "groupMemoryBarrier",
        "noise1",
        "noise2",
        "noise3",
        "noise4",
        "floatBitsToInt",
        "floatBitsToUint",
        "doubleBitsToInt64",
        "doubleBitsToUint64",
        "int64BitsToDouble",
        "uint64BitsToDouble",
        "intBitsToFloat",
        "uintBitsToFloat",
        "packHalf2x16",
        "unpackHalf2x16",
        "packUnorm4x8",
        "unpackUnorm4x8",
        "fwidth",
        "dFdx",
        "dFdy",
        // this printer's own
        "main",
        "Parameters",
        "copies_parameters",
        "parameter",
        "parameters",
        "quotient",
        "remainder",
        "modulo",
        "to_int",
        "to_uint",
        "to_int64",
        "to_uint64",
        "ordered_dot",
        "shuffled",
        "shuffled_xor",
        "shuffled_up",
        "shuffled_down",
        "broadcast",
        "broadcast_first",
        "cross_product",
        "blend",
        "smooth_step",
        "fraction",
        "sign_of",
        "reflection",
        "product",
        "pack_unorm",
        "unpack_unorm",
        "extract_bits",
        "far_index",
        "insert_bits",
        "exact_division",
        "divide",
        "square_root",
        "split",
        "scaled_quotient",
        "subnormal_quotient",
    };
    return words;
}

bool begins(std::string_view name, std::string_view prefix) { return name.substr(0, prefix.size()) == prefix; }

bool is_image_or_matrix_type(std::string_view name) {
    std::size_t skip = !name.empty() && (name[0] == 'i' || name[0] == 'u') ? 1 : 0;
    std::string_view rest = name.substr(skip);
    for (std::string_view stem : {"sampler", "image", "texture", "subpassInput"})
        if (begins(rest, stem) && rest.size() > stem.size() &&
            (std::isdigit(rest[stem.size()]) || rest[stem.size()] == 'C' || rest[stem.size()] == 'B'))
            return true;
    std::size_t d = !name.empty() && name[0] == 'd' ? 1 : 0;
    return begins(name.substr(d), "mat") && name.size() == d + 6 && name[d + 4] == 'x';
}

/// Taken together with all that begins so: another ending does not help.
bool has_reserved_beginning(std::string_view name) {
    for (std::string_view prefix : {"gl_", "optional_", "atomic", "subgroup", "imageAtomic", "debugPrintf"})
        if (begins(name, prefix)) return true;
    return is_image_or_matrix_type(name);
}

}  // namespace

bool is_reserved(std::string_view name) {
    return name.empty() || reserved_words().contains(name) || has_reserved_beginning(name) ||
           name.find("__") != std::string_view::npos;
}

std::string identifier(std::string_view text) {
    std::string result;
    for (char c : text) {
        bool good = std::isalnum(static_cast<unsigned char>(c)) && static_cast<unsigned char>(c) < 128;
        if (good) result += c;
        else if (!result.empty() && result.back() != '_') result += '_';
    }
    while (!result.empty() && result.back() == '_' && text.back() != '_') result.pop_back();
    if (result.empty()) result = "value";
    if (std::isdigit(static_cast<unsigned char>(result[0]))) result.insert(0, "n");
    return result;
}

void Scopes::leave() {
    for (const std::string& name : scopes_.back()) used_.erase(name);
    scopes_.pop_back();
}

std::string Scopes::declare(std::string_view wanted) {
    std::string base = identifier(wanted), name = base;
    if (has_reserved_beginning(base)) base = name = "the_" + base;
    while (base.size() > 1 && base.back() == '_') base.pop_back();
    for (int n = 1; !is_free(name); ++n) name = base + "_" + std::to_string(n);
    used_.insert(name);
    scopes_.back().push_back(name);
    return name;
}

}  // namespace gliftc::glsl
