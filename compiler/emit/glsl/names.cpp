#include "emit/glsl/names.h"

#include <cctype>

namespace gliftc::glsl {

namespace {

// long: a list
const std::unordered_set<std::string_view>& reserved_words() {
    static const std::unordered_set<std::string_view> words = {
#include "emit/glsl/words.inc"
        // names that this printer uses itself
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
        "to_half",
        "nearest_half",
        "ordered_dot",
        "shuffled",
        "shuffled_xor",
        "shuffled_up",
        "shuffled_down",
        "broadcast",
        "broadcast_first",
        "skips_branches",
        "adds_floats",
        "cross_product",
        "blend",
        "angle",
        "smooth_step",
        "fraction",
        "sign_of",
        "negative",
        "magnitude",
        "reflection",
        "product",
        "pack_unorm",
        "unpack_unorm",
        "extract_bits",
        "insert_bits",
        "exact_division",
        "divide_by",
        "is_ordinary_dividend",
        "divide",
        "quick_divide",
        "quick_divide_by",
        "has_usual_quotients",
        "is_ordinary",
        "far_index",
        "whole_vector",
        "square_root",
        "split",
        "scaled_quotient",
        "subnormal_quotient",
        "rounded_reciprocal",
        // what the printer writes in layout(…): no type may have these names
        "binding",
        "buffer_reference",
        "buffer_reference_align",
        "constant_id",
        "early_fragment_tests",
        "local_size_x",
        "local_size_x_id",
        "local_size_y",
        "local_size_y_id",
        "local_size_z",
        "local_size_z_id",
        "location",
        "push_constant",
        "r16f",
        "r16ui",
        "r32f",
        "r32i",
        "r32ui",
        "r8",
        "r8ui",
        "rg16f",
        "rg32f",
        "rg32i",
        "rg32ui",
        "rg8",
        "rgba16f",
        "rgba32f",
        "rgba32i",
        "rgba32ui",
        "rgba8",
        "rgba8ui",
        "scalar",
        "set",
    };
    return words;
}

bool begins(std::string_view name, std::string_view prefix) { return name.substr(0, prefix.size()) == prefix; }

/// Whether the name begins with a prefix that makes every name reserved, so that appending something does not help.
bool has_reserved_beginning(std::string_view name) {
    for (std::string_view prefix : {"gl_", "GL_", "optional_", "atomic", "subgroup", "imageAtomic", "debugPrintf"})
        if (begins(name, prefix)) return true;
    return false;
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

std::string Scopes::declare(std::string_view wanted) { return declare_in(scopes_.back(), wanted); }

std::string Scopes::declare_outermost(std::string_view wanted) { return declare_in(scopes_.front(), wanted); }

std::string Scopes::declare_in(std::vector<std::string>& scope, std::string_view wanted) {
    std::string base = identifier(wanted), name = base;
    if (has_reserved_beginning(base + "_")) base = name = "the_" + base;  // `gl`, too: `gl_1` is reserved
    while (base.size() > 1 && base.back() == '_') base.pop_back();
    for (int n = 1; !is_free(name); ++n) name = base + "_" + std::to_string(n);
    used_.insert(name);
    scope.push_back(name);
    return name;
}

}  // namespace gliftc::glsl
