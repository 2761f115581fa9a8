#include "ir/spelling.h"

#include <array>

namespace gliftc::ir {

namespace {

/// The text of an enumerator; `texts` has those of all enumerators in their order.
template <class Enum, std::size_t count>
std::string_view text_of(const std::array<std::string_view, count>& texts, Enum value) {
    const auto index = static_cast<std::size_t>(value);
    return index < count ? texts[index] : "?";
}

}  // namespace

std::string_view spelling(BinaryOp op) {
    return text_of(std::to_array<std::string_view>({"*", "/", "%", "+", "-", "<<", ">>", "<", "<=", ">",
                                                    ">=", "==", "!=", "&", "^", "|", "&&", "||"}),
                   op);
}

std::string_view spelling(UnaryOp op) { return text_of(std::to_array<std::string_view>({"-", "!", "~"}), op); }

std::string_view spelling(Invocation id) {
    return text_of(
        std::to_array<std::string_view>({"local_index", "group_index", "group_count", "group_size", "subgroup_size",
                                         "subgroup_lane", "subgroup_index", "subgroup_count"}),
        id);
}

std::string_view spelling(Builtin id) {
    return text_of(
        std::to_array<std::string_view>({"global_id", "local_id", "group_id", "group_count", "local_index",
                                         "subgroup_size", "subgroup_lane", "subgroup_index", "subgroup_count", "corner",
                                         "instance", "fragment_place", "is_front", "skips_branches", "adds_floats"}),
        id);
}

std::string_view spelling(Combine combine) {
    return text_of(std::to_array<std::string_view>({"replace", "min", "max", "add", "and", "or", "xor"}), combine);
}

std::string_view spelling(Form form) { return text_of(std::to_array<std::string_view>({"direct", "general"}), form); }

std::string_view spelling(Access access) {
    return text_of(std::to_array<std::string_view>({"read", "write", "read_write"}), access);
}

std::string_view spelling(MemoryShape shape) {
    return text_of(
        std::to_array<std::string_view>({"buffer", "image1d", "image2d", "image3d", "imagecube", "image2darray"}),
        shape);
}

std::string_view spelling(Format format) {
    return text_of(
        std::to_array<std::string_view>({"none",     "r8",    "rg8",     "rgba8",   "r16f",    "rg16f", "rgba16f",
                                         "r32f",     "rg32f", "rgba32f", "r8ui",    "r16ui",   "r32ui", "rg32ui",
                                         "rgba32ui", "r32i",  "rg32i",   "rgba32i", "rgba8ui", "d32"}),
        format);
}

std::string_view spelling(Topology topology) {
    return text_of(std::to_array<std::string_view>({"triangles", "lines", "points"}), topology);
}

std::string_view spelling(Cull cull) {
    return text_of(std::to_array<std::string_view>({"none", "back", "front"}), cull);
}

std::string_view spelling(Compare compare) {
    return text_of(std::to_array<std::string_view>({"less", "less_equal", "greater", "greater_equal"}), compare);
}

std::string_view spelling(DepthTest test) {
    return text_of(std::to_array<std::string_view>({"less", "less_equal", "greater", "equal", "always"}), test);
}

std::string_view spelling(Blend blend) {
    return text_of(std::to_array<std::string_view>({"replace", "over", "add", "min", "max", "multiply"}), blend);
}

std::string_view spelling(Interpolation interpolation) {
    return text_of(std::to_array<std::string_view>({"smooth", "linear", "flat"}), interpolation);
}

}  // namespace gliftc::ir
