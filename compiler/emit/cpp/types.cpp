// Types and literals as C++ spells them.
#include "emit/cpp/printer.h"

#include <charconv>
#include <cmath>

namespace gliftc::cpp {

namespace {

using ir::TypeKind;

/// The prefix of float4 and the like, or empty where vectors of the scalar have no name of their own.
std::string_view vector_prefix(TypeKind kind) {
    switch (kind) {
    case TypeKind::bool_: return "bool";
    case TypeKind::int_: return "int";
    case TypeKind::uint: return "uint";
    case TypeKind::float_: return "float";
    case TypeKind::half: return "half";
    case TypeKind::double_: return "double";
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::int64:
    case TypeKind::uint64:
    case TypeKind::vector:
    case TypeKind::matrix:
    case TypeKind::array:
    case TypeKind::struct_:
    case TypeKind::enum_:
    case TypeKind::optional:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: return "";
    }
    return "";
}

struct Spelling {
    const Globals& globals;
    std::string_view prefix;  ///< before names of the runtime
    bool storage;

    std::string of(ir::TypeId id) const;
};

std::string Spelling::of(ir::TypeId id) const {
    const ir::Program& program = globals.program;
    const ir::Type& type = program.types[id];
    const std::string glift(prefix);
    switch (type.kind) {
    case TypeKind::error:
    case TypeKind::void_: return "void";
    case TypeKind::bool_: return storage ? "glift::Bool" : "bool";
    case TypeKind::int_: return "int";
    case TypeKind::uint: return glift + "uint";
    case TypeKind::float_: return "float";
    case TypeKind::half: return glift + "half";
    case TypeKind::double_: return "double";
    case TypeKind::int64: return "std::int64_t";
    case TypeKind::uint64: return "std::uint64_t";
    case TypeKind::vector: {
        const std::string_view name = vector_prefix(program.types.kind(type.element));
        if (name.empty() || (storage && name == "bool"))
            return "glift::vec<" + of(type.element) + ", " + std::to_string(type.count) + ">";
        return glift + std::string(name) + std::to_string(type.count);
    }
    case TypeKind::matrix:
        if (program.types.kind(type.element) == TypeKind::float_)
            return glift + "float" + std::to_string(type.count) + "x" + std::to_string(type.rows);
        return "glift::mat<" + of(type.element) + ", " + std::to_string(type.count) + ", " + std::to_string(type.rows) +
               ">";
    case TypeKind::array: {
        // Arrays, like structs, hold bools as memory does, so that values and memory have one type.
        const Spelling element{globals, prefix, true};
        return "glift::array<" + element.of(type.element) + ", " + std::to_string(type.count) + ">";
    }
    case TypeKind::struct_: return globals.struct_names[type.struct_];
    case TypeKind::enum_: return glift + "uint";
    case TypeKind::optional: return "std::optional<" + of(type.element) + ">";
    case TypeKind::structure: return globals.structure_names[type.structure];
    case TypeKind::slice: return "glift::Range<" + of(type.element) + ">";
    case TypeKind::device:  // the value lies in memory
        return "glift::DeviceScalar<" + Spelling{globals, prefix, true}.of(type.element) + ">";
    }
    return "void";
}

std::string floating(double number, bool is_single) {
    if (std::isnan(number)) return is_single ? "__builtin_nanf(\"\")" : "__builtin_nan(\"\")";
    if (std::isinf(number)) {
        const std::string text = is_single ? "__builtin_inff()" : "__builtin_inf()";
        return number < 0 ? "-" + text : text;
    }
    char buffer[40];
    const auto end = is_single ? std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(number)).ptr
                               : std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
    std::string text(buffer, end);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return is_single ? text + "f" : text;
}

}  // namespace

std::string type_text(const Globals& globals, ir::TypeId type, bool qualified) {
    return Spelling{globals, qualified ? "glift::" : "", false}.of(type);
}

std::string storage_text(const Globals& globals, ir::TypeId type, bool qualified) {
    return Spelling{globals, qualified ? "glift::" : "", true}.of(type);
}

std::string_view format_name(ir::Format format) {
    switch (format) {
    case ir::Format::none: return "none";
    case ir::Format::r8: return "r8";
    case ir::Format::rg8: return "rg8";
    case ir::Format::rgba8: return "rgba8";
    case ir::Format::r16f: return "r16f";
    case ir::Format::rg16f: return "rg16f";
    case ir::Format::rgba16f: return "rgba16f";
    case ir::Format::r32f: return "r32f";
    case ir::Format::rg32f: return "rg32f";
    case ir::Format::rgba32f: return "rgba32f";
    case ir::Format::r8ui: return "r8ui";
    case ir::Format::r16ui: return "r16ui";
    case ir::Format::r32ui: return "r32ui";
    case ir::Format::rg32ui: return "rg32ui";
    case ir::Format::rgba32ui: return "rgba32ui";
    case ir::Format::r32i: return "r32i";
    case ir::Format::rg32i: return "rg32i";
    case ir::Format::rgba32i: return "rgba32i";
    case ir::Format::rgba8ui: return "rgba8ui";
    case ir::Format::d32: return "d32";
    }
    return "none";
}

std::string literal(const ir::Program& program, ir::TypeId type, std::uint64_t bits, double number) {
    switch (program.types.kind(type)) {
    case TypeKind::bool_: return bits ? "true" : "false";
    case TypeKind::int_:
        if (static_cast<std::int32_t>(bits) == INT32_MIN) return "(-2147483647 - 1)";
        return std::to_string(static_cast<std::int32_t>(bits));
    case TypeKind::uint:
    case TypeKind::enum_: return std::to_string(static_cast<std::uint32_t>(bits)) + "u";
    case TypeKind::int64:
        if (static_cast<std::int64_t>(bits) == INT64_MIN) return "std::int64_t{-9223372036854775807 - 1}";
        return "std::int64_t{" + std::to_string(static_cast<std::int64_t>(bits)) + "}";
    case TypeKind::uint64: return "std::uint64_t{" + std::to_string(bits) + "u}";
    case TypeKind::float_: return floating(number, true);
    case TypeKind::half: return "half(" + floating(number, true) + ")";
    case TypeKind::double_: return floating(number, false);
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::vector:
    case TypeKind::matrix:
    case TypeKind::array:
    case TypeKind::struct_:
    case TypeKind::optional:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: return "{}";
    }
    return "{}";
}

bool is_bool_vector(const ir::Program& program, ir::TypeId type) {
    return program.types.is_vector(type) && program.types.scalar_of(type) == program.types.bool_;
}

}  // namespace gliftc::cpp
