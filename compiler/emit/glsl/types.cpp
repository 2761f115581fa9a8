// Types and literals.
#include "emit/glsl/printer.h"
#include "ir/evaluate.h"
#include "layout/layout.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace gliftc::glsl {

using ir::TypeId;
using ir::TypeKind;

namespace {

std::string scalar_text(Printer& p, TypeKind kind) {
    switch (kind) {
    case TypeKind::void_: return "void";
    case TypeKind::bool_: return "bool";
    case TypeKind::int_: return "int";
    case TypeKind::uint:
    case TypeKind::enum_: return "uint";
    case TypeKind::float_: return "float";
    case TypeKind::half: p.extensions.insert("GL_EXT_shader_explicit_arithmetic_types_float16"); return "float16_t";
    case TypeKind::double_: return "double";
    case TypeKind::int64: p.extensions.insert("GL_EXT_shader_explicit_arithmetic_types_int64"); return "int64_t";
    case TypeKind::uint64: p.extensions.insert("GL_EXT_shader_explicit_arithmetic_types_int64"); return "uint64_t";
    case TypeKind::error:
    case TypeKind::vector:
    case TypeKind::matrix:
    case TypeKind::array:
    case TypeKind::struct_:
    case TypeKind::optional:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: break;
    }
    throw std::logic_error("emit/glsl: a type that shaders do not have");
}

std::string vector_prefix(Printer& p, TypeKind kind) {
    switch (kind) {
    case TypeKind::bool_: return "b";
    case TypeKind::int_: return "i";
    case TypeKind::uint:
    case TypeKind::enum_: return "u";
    case TypeKind::float_: return "";
    case TypeKind::half: scalar_text(p, kind); return "f16";
    case TypeKind::double_: return "d";
    case TypeKind::int64: scalar_text(p, kind); return "i64";
    case TypeKind::uint64: scalar_text(p, kind); return "u64";
    default: break;
    }
    throw std::logic_error("emit/glsl: a vector that shaders do not have");
}

/// Notes that the shader uses a struct or optional, after the structs inside it.
void use_struct(Printer& p, TypeId type) {
    if (std::find(p.struct_types.begin(), p.struct_types.end(), type) != p.struct_types.end()) return;
    const ir::Type& t = p.program.types[type];
    std::vector<TypeId> parts;
    if (t.kind == TypeKind::optional) parts.push_back(t.element);
    else
        for (const ir::StructField& field : p.program.structs[t.struct_].fields) parts.push_back(field.type);
    for (TypeId part : parts)
        if (!is_empty(p.program, part)) type_text(p, part);
    p.struct_types.push_back(type);
}

/// The element type of (nested) arrays; adds the text of their extents, [2][3].
TypeId without_arrays(const Printer& p, TypeId type, std::string& extents) {
    while (p.program.types.kind(type) == TypeKind::array) {
        extents += "[" + std::to_string(p.program.types[type].count) + "]";
        type = p.program.types[type].element;
    }
    return type;
}

std::string float_text(double number, bool is_double) {
    char buffer[40];
    auto end = is_double ? std::to_chars(buffer, buffer + sizeof buffer, number).ptr
                         : std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(number)).ptr;
    std::string text(buffer, end);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string not_finite(Printer& p, TypeId type, double number) {
    const char* bits = std::isnan(number) ? "0x7fc00000u" : number < 0 ? "0xff800000u" : "0x7f800000u";
    std::string text = std::string("uintBitsToFloat(") + bits + ")";
    return p.program.types.kind(type) == TypeKind::float_ ? text : type_text(p, type) + "(" + text + ")";
}

std::string enumerator(Printer& p, ir::EnumId id, std::uint64_t value) {
    const ir::Enum& e = p.program.enums[id];
    for (std::uint32_t i = 0; i < e.values.size(); ++i) {
        if (e.values[i] != value) continue;
        auto [place, fresh] = p.enumerators.try_emplace({id, i});
        if (fresh) {
            const std::string name = (*p.program.names)[e.name] + "_" + (*p.program.names)[e.enumerators[i]];
            place->second = p.names.declare_outermost(name);
        }
        return place->second;
    }
    return std::to_string(value) + "u";
}

/// Bytes that a struct has behind its last field.
std::uint32_t padding_of(const Printer& p, TypeId type) {
    const ir::Struct& declared = p.program.structs[p.program.types[type].struct_];
    const std::vector<std::uint32_t> offsets = layout::offsets_of(p.program, declared);
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < offsets.size(); ++i)
        end = std::max(end, offsets[i] + layout::size_of(p.program, declared.fields[i].type).size);
    return layout::size_of(p.program, type).size - end;
}

/// Members for the padding behind a struct's fields: without them glslang would put the next element or member there,
/// which C++ does not.
std::string padding_members(Printer& p, TypeId type) {
    const std::uint32_t bytes = padding_of(p, type);
    const std::vector<std::string>& fields = p.field_names[p.program.types[type].struct_];
    std::string name = "padding", text;
    while (std::ranges::find(fields, name) != fields.end() || std::ranges::find(fields, "half_" + name) != fields.end())
        name += "_0";
    if (bytes % 4 == 2) text += "    float16_t half_" + name + ";\n";
    if (bytes >= 4) text += "    uint " + name + (bytes >= 8 ? "[" + std::to_string(bytes / 4) + "]" : "") + ";\n";
    return text;
}

}  // namespace

std::string padding_values(const Printer& p, TypeId type) {
    if (p.program.types.kind(type) != TypeKind::struct_) return "";
    const std::uint32_t bytes = padding_of(p, type);
    std::string text = bytes % 4 == 2 ? ", float16_t(0.0)" : "";
    if (bytes >= 8) {
        text += ", uint[" + std::to_string(bytes / 4) + "](";
        for (std::uint32_t i = 0; i < bytes / 4; ++i) text += i ? ", 0u" : "0u";
        return text + ")";
    }
    return bytes >= 4 ? text + ", 0u" : text;
}

std::string optional_name(Printer& p, TypeId type) {
    const ir::TypeId element = p.program.types[type].element;
    const std::string inside = is_empty(p.program, element) ? ir::to_text(p.program, element) : type_text(p, element);
    return "optional_" + identifier(inside);
}

std::string type_text(Printer& p, TypeId type) {
    const ir::Type& t = p.program.types[type];
    switch (t.kind) {
    case TypeKind::vector: return vector_prefix(p, p.program.types.kind(t.element)) + "vec" + std::to_string(t.count);
    case TypeKind::matrix: {
        std::string size = std::to_string(t.count) + (t.count == t.rows ? "" : "x" + std::to_string(t.rows));
        return vector_prefix(p, p.program.types.kind(t.element)) + "mat" + size;
    }
    case TypeKind::array: {
        std::string extents;
        TypeId element = without_arrays(p, type, extents);
        return type_text(p, element) + extents;
    }
    case TypeKind::struct_: use_struct(p, type); return p.struct_names[t.struct_];
    case TypeKind::optional: use_struct(p, type); return optional_name(p, type);
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::bool_:
    case TypeKind::int_:
    case TypeKind::uint:
    case TypeKind::float_:
    case TypeKind::half:
    case TypeKind::double_:
    case TypeKind::int64:
    case TypeKind::uint64:
    case TypeKind::enum_:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: break;
    }
    return scalar_text(p, t.kind);
}

std::string declaration(Printer& p, TypeId type, const std::string& name) {
    std::string extents;
    TypeId element = without_arrays(p, type, extents);
    return type_text(p, element) + " " + name + extents;
}

std::string zero(Printer& p, TypeId type) {
    switch (p.program.types.kind(type)) {
    case TypeKind::bool_: return "false";
    case TypeKind::int_:
    case TypeKind::uint:
    case TypeKind::float_:
    case TypeKind::half:
    case TypeKind::double_:
    case TypeKind::int64:
    case TypeKind::uint64: return literal(p, type, 0, 0);
    case TypeKind::enum_: return "0u";
    case TypeKind::vector:
    case TypeKind::matrix: return type_text(p, type) + "(" + zero(p, p.program.types[type].element) + ")";
    case TypeKind::array: {
        std::string text = type_text(p, type) + "(";
        const ir::Type& t = p.program.types[type];
        std::string element = zero(p, t.element);
        for (std::uint32_t i = 0; i < t.count; ++i) text += (i ? ", " : "") + element;
        return text + ")";
    }
    case TypeKind::struct_: {
        std::string text = type_text(p, type) + "(";
        bool first = true;
        for (const ir::StructField& field : p.program.structs[p.program.types[type].struct_].fields) {
            if (is_empty(p.program, field.type)) continue;
            text += (first ? "" : ", ") + zero(p, field.type);
            first = false;
        }
        return text + padding_values(p, type) + ")";
    }
    case TypeKind::optional: {
        TypeId element = p.program.types[type].element;
        return type_text(p, type) + "(false" + (is_empty(p.program, element) ? "" : ", " + zero(p, element)) + ")";
    }
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: break;
    }
    throw std::logic_error("emit/glsl: a type without zero");
}

std::string literal(Printer& p, TypeId type, std::uint64_t bits, double number) {
    const ir::Type& t = p.program.types[type];
    switch (t.kind) {
    case TypeKind::bool_: return bits ? "true" : "false";
    case TypeKind::int_: {
        auto value = static_cast<std::int32_t>(bits);
        return value == INT32_MIN ? "int(0x80000000u)" : std::to_string(value);
    }
    case TypeKind::uint: return std::to_string(static_cast<std::uint32_t>(bits)) + "u";
    case TypeKind::int64: {
        auto value = static_cast<std::int64_t>(bits);
        type_text(p, type);
        return value == INT64_MIN ? "int64_t(0x8000000000000000ul)" : std::to_string(value) + "l";
    }
    case TypeKind::uint64: type_text(p, type); return std::to_string(bits) + "ul";
    case TypeKind::float_: return std::isfinite(number) ? float_text(number, false) : not_finite(p, type, number);
    case TypeKind::half:
        type_text(p, type);
        return std::isfinite(number) ? float_text(number, false) + "hf" : not_finite(p, type, number);
    case TypeKind::double_:
        return std::isfinite(number) ? float_text(number, true) + "lf" : not_finite(p, type, number);
    case TypeKind::enum_: return enumerator(p, t.enum_, bits);
    default: break;
    }
    throw std::logic_error("emit/glsl: a constant that is not a scalar");
}

std::string struct_definition(Printer& p, ir::TypeId type) {
    const ir::Type& t = p.program.types[type];
    if (t.kind == TypeKind::optional) {
        std::string text = "struct " + optional_name(p, type) + " {\n    bool has;\n";
        if (!is_empty(p.program, t.element)) text += "    " + declaration(p, t.element, "value") + ";\n";
        return text + "};\n";
    }
    const ir::Struct& s = p.program.structs[t.struct_];
    std::string text = "struct " + p.struct_names[t.struct_] + " {\n";
    for (std::size_t i = 0; i < s.fields.size(); ++i)
        if (!is_empty(p.program, s.fields[i].type))
            text += "    " + declaration(p, s.fields[i].type, p.field_names[t.struct_][i]) + ";\n";
    return text + padding_members(p, type) + "};\n";
}

std::string struct_definitions(Printer& p) {
    std::string text;
    for (TypeId type : p.struct_types) text += struct_definition(p, type) + "\n";
    return text;
}

}  // namespace gliftc::glsl
