#include "sema/types/builtin_names.h"

#include <array>

namespace gliftc::sema {

namespace {

struct FormatName {
    std::string_view name;
    ir::Format format;
};
constexpr std::array formats = {
    FormatName{"r8", ir::Format::r8},           FormatName{"rg8", ir::Format::rg8},
    FormatName{"rgba8", ir::Format::rgba8},     FormatName{"r16f", ir::Format::r16f},
    FormatName{"rg16f", ir::Format::rg16f},     FormatName{"rgba16f", ir::Format::rgba16f},
    FormatName{"r32f", ir::Format::r32f},       FormatName{"rg32f", ir::Format::rg32f},
    FormatName{"rgba32f", ir::Format::rgba32f}, FormatName{"r8ui", ir::Format::r8ui},
    FormatName{"r16ui", ir::Format::r16ui},     FormatName{"r32ui", ir::Format::r32ui},
    FormatName{"rg32ui", ir::Format::rg32ui},   FormatName{"rgba32ui", ir::Format::rgba32ui},
    FormatName{"r32i", ir::Format::r32i},       FormatName{"rg32i", ir::Format::rg32i},
    FormatName{"rgba32i", ir::Format::rgba32i}, FormatName{"rgba8ui", ir::Format::rgba8ui},
    FormatName{"d32", ir::Format::d32},
};

struct ShapeName {
    std::string_view name;
    ir::MemoryShape shape;
};
constexpr std::array shapes = {
    ShapeName{"buffer", ir::MemoryShape::buffer},       ShapeName{"image1d", ir::MemoryShape::image1d},
    ShapeName{"image2d", ir::MemoryShape::image2d},     ShapeName{"image3d", ir::MemoryShape::image3d},
    ShapeName{"imagecube", ir::MemoryShape::imagecube},
};

struct ConstraintName {
    std::string_view name;
    Constraint constraint;
};
constexpr std::array constraints = {
    ConstraintName{"type", Constraint::type},
    ConstraintName{"Texel", Constraint::texel},
    ConstraintName{"Number", Constraint::number},
    ConstraintName{"Integer", Constraint::integer},
    ConstraintName{"Floating", Constraint::floating},
    ConstraintName{"Structure", Constraint::structure},
    ConstraintName{"Translator", Constraint::translator},
};

/// The built-in type of that name (`uint`, `float3`, `float4x4`); an absent id if there is none.
ir::TypeId builtin_type(ir::Types& types, std::string_view text) {
    struct ScalarName {
        std::string_view name;
        ir::TypeId type;
    };
    const std::array scalars = {ScalarName{"bool", types.bool_},    ScalarName{"int64", types.int64},
                                ScalarName{"uint64", types.uint64}, ScalarName{"int", types.int_},
                                ScalarName{"uint", types.uint},     ScalarName{"float", types.float_},
                                ScalarName{"half", types.half},     ScalarName{"double", types.double_}};
    for (const ScalarName& scalar : scalars) {
        if (!text.starts_with(scalar.name)) continue;
        std::string_view rest = text.substr(scalar.name.size());
        if (rest.empty()) return scalar.type;
        auto digit = [](char c) { return c >= '2' && c <= '4' ? static_cast<std::uint32_t>(c - '0') : 0u; };
        if (rest.size() == 1 && digit(rest[0])) return types.vector(scalar.type, digit(rest[0]));
        bool matrix =
            rest.size() == 3 && rest[1] == 'x' && digit(rest[0]) && digit(rest[2]) && types.is_floating(scalar.type);
        if (matrix) return types.matrix(scalar.type, digit(rest[0]), digit(rest[2]));
    }
    return {};
}

}  // namespace

Meta builtin(Context& c, std::string_view text) {
    Meta meta;
    meta.type = builtin_type(c.types(), text);
    if (meta.type) meta.kind = MetaKind::type;
    for (const auto& [name, format] : formats)
        if (name == text) meta.kind = MetaKind::format, meta.format = format;
    for (const auto& [name, shape] : shapes)
        if (name == text) meta.kind = MetaKind::memory_shape, meta.shape = shape;
    for (const auto& [name, constraint] : constraints)
        if (name == text) meta.kind = MetaKind::constraint, meta.constraint = constraint;
    return meta;
}

}  // namespace gliftc::sema
