// Buffers, images and parameters: how they are declared, read and written.
#include "emit/glsl/printer.h"
#include "ir/walk.h"
#include "layout/layout.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace gliftc::glsl {

using ir::Combine;
using ir::Format;
using ir::MemoryShape;
using ir::PassBinding;
using ir::TypeId;
using ir::TypeKind;

namespace {

constexpr std::uint32_t row_bytes = 16;

const char* format_text(Format format) {
    switch (format) {
    case Format::none: return "";
    case Format::r8: return "r8";
    case Format::rg8: return "rg8";
    case Format::rgba8: return "rgba8";
    case Format::r16f: return "r16f";
    case Format::rg16f: return "rg16f";
    case Format::rgba16f: return "rgba16f";
    case Format::r32f: return "r32f";
    case Format::rg32f: return "rg32f";
    case Format::rgba32f: return "rgba32f";
    case Format::r8ui: return "r8ui";
    case Format::r16ui: return "r16ui";
    case Format::r32ui: return "r32ui";
    case Format::rg32ui: return "rg32ui";
    case Format::rgba32ui: return "rgba32ui";
    case Format::r32i: return "r32i";
    case Format::rg32i: return "rg32i";
    case Format::rgba32i: return "rgba32i";
    case Format::rgba8ui: return "rgba8ui";
    case Format::d32: return "";
    }
    return "";
}

const char* shape_text(MemoryShape shape) {
    switch (shape) {
    case MemoryShape::buffer: break;
    case MemoryShape::image1d: return "1D";
    case MemoryShape::image2d: return "2D";
    case MemoryShape::image3d: return "3D";
    case MemoryShape::imagecube: return "Cube";
    case MemoryShape::image2darray: return "2DArray";
    }
    throw std::logic_error("emit/glsl: an image that is a buffer");
}

/// "i", "u" or "": what the names of image types with this element begin with.
std::string image_prefix(const Printer& p, TypeId element) {
    TypeId scalar = p.program.types.scalar_of(element);
    if (p.program.types.kind(scalar) == TypeKind::int_) return "i";
    return p.program.types.kind(scalar) == TypeKind::uint ? "u" : "";
}

/// Whether the binding is `coherent` in GLSL: the kernel accesses it by the pattern coherent<S>, or reads and writes it
/// and has a group and barriers. What one invocation writes and another reads after a barrier must not stay in a cache.
bool is_coherent(const Printer& p, const PassBinding& binding) {
    if (binding.coherent) return true;
    const bool is_grouped = p.pass.kernel && p.program.kernels[p.pass.kernel].grouped();
    return is_grouped && binding.access == ir::Access::read_write && ir::has_any_barrier(p.program, p.body());
}

const char* access_text(ir::Access access) {
    switch (access) {
    case ir::Access::read: return "readonly ";
    case ir::Access::write: return "writeonly ";
    case ir::Access::read_write: return "";
    }
    return "";
}

/// Whether a call may give the memory for another binding as well (PassBinding::one_place). The buffer then is neither
/// `readonly` nor `writeonly`: GPUs read `readonly` buffers through a cache that writes do not update.
bool may_alias(const Printer& p, const PassBinding& binding) {
    return std::ranges::any_of(p.pass.bindings, [&](const PassBinding& other) {
        return &other != &binding && other.one_place == binding.one_place;
    });
}

void note_storage(Printer& p, TypeId type) {
    if (p.program.types.kind(p.program.types.scalar_of(type)) == TypeKind::half)
        p.extensions.insert("GL_EXT_shader_16bit_storage");
}

std::string buffer_text(Printer& p, std::size_t index) {
    const PassBinding& binding = p.pass.bindings[index];
    const char* access = may_alias(p, binding) ? "" : access_text(binding.access);
    std::string qualifiers = (is_coherent(p, binding) ? "coherent " : "") + std::string(access);
    note_storage(p, binding.element);
    std::string element = !stored_as_bits(p, binding) ? "" : binding.ordered ? "int" : "uint";
    const bool is_by_address = p.pass.form == ir::Form::general;
    const std::string name = is_by_address ? "at" : p.binding_names[index] + "[]";
    const ir::Type& type = p.program.types[binding.element];
    std::string member = !element.empty() ? element + " " + name
                         : type.kind == TypeKind::array
                             ? type_text(p, type.element) + " " + name + "[" + std::to_string(type.count) + "]"
                             : type_text(p, binding.element) + " " + name;
    const auto by_address = [](std::uint32_t align) {
        return "layout(buffer_reference, scalar, buffer_reference_align = " + std::to_string(align) + ") ";
    };
    std::string layout = is_by_address ? by_address(layout::size_of(p.program, binding.element).align)
                                       : "layout(scalar, set = 0, binding = " + std::to_string(index + 1) + ") ";
    std::string text = layout + qualifiers + "buffer " + p.block_names[index] + " { " + member + "; };\n";
    if (!binding.in_rows) return text;
    const std::string row =
        image_prefix(p, binding.element) + "vec4 " + (is_by_address ? "at" : p.row_names[index] + "[]");
    return text + (is_by_address ? by_address(row_bytes) : layout) + qualifiers + "buffer " + p.row_block_names[index] +
           " { " + row + "; };   // the same memory, as vectors of four\n";
}

/// An element by its device address, which is computed in 64 bits: an array's index would have 32 bits, and SPIR-V
/// takes it as signed.
std::string at_address(const std::string& block, const std::string& address, const std::string& index,
                       std::uint32_t bytes) {
    return block + "(" + address + " + " + index + " * " + std::to_string(bytes) + "ul).at";
}

std::string as_float(const PassBinding& binding, const std::string& bits) {
    return (binding.ordered ? "intBitsToFloat(" : "uintBitsToFloat(") + bits + ")";
}

std::string as_bits(const PassBinding& binding, const std::string& value) {
    return (binding.ordered ? "floatBitsToInt(" : "floatBitsToUint(") + value + ")";
}

}  // namespace

std::string element_text(const Printer& p, std::uint32_t slot, const std::string& index) {
    if (p.pass.form == ir::Form::direct) return p.binding_names[slot] + "[" + index + "]";
    const std::uint32_t bytes = layout::size_of(p.program, p.pass.bindings[slot].element).size;
    return at_address(p.block_names[slot], p.binding_names[slot], index, bytes);
}

namespace {

/// The index of an element, or of a vector of four consecutive scalars (is_row).
std::string index_text(Printer& p, ir::ExprId id) {
    const ir::Expr& index = p.program.exprs[id];
    const bool is_far = index.op == ir::Op::constant && index.bits > 0x7fffffffu;
    return is_far ? need(p, Helper::far_index, {}) + "(" + print_any(p, id) + ")" : print_any(p, id);
}

/// The index of an element that is reached by address, in 64 bits, as the left operand of `*`.
std::string far_index(Printer& p, ir::ExprId index) {
    return p.pass.is_wide ? print(p, index, Level::term) : "uint64_t(" + print_any(p, index) + ")";
}

}  // namespace

std::string element_text(Printer& p, std::uint32_t slot, ir::ExprId index) {
    return element_text(p, slot, p.pass.form == ir::Form::general ? far_index(p, index) : index_text(p, index));
}

namespace {

std::string row_text(Printer& p, std::uint32_t slot, ir::ExprId index) {
    if (p.pass.form == ir::Form::direct) return p.row_names[slot] + "[" + index_text(p, index) + "]";
    return at_address(p.row_block_names[slot], p.binding_names[slot], far_index(p, index), row_bytes);
}

std::string image_text(Printer& p, std::size_t index) {
    const PassBinding& binding = p.pass.bindings[index];
    std::string at = "layout(set = 0, binding = " + std::to_string(index + 1), kind = image_prefix(p, binding.element);
    if (stored_as_bits(p, binding))
        return at + ", r32i) uniform iimage" + shape_text(binding.shape) + " " + p.binding_names[index] + ";\n";
    if (binding.sampled)
        return at + ") uniform " + kind + "sampler" + shape_text(binding.shape) + (binding.compare ? "Shadow " : " ") +
               p.binding_names[index] + ";\n";
    std::string format = format_text(binding.format);
    return at + (format.empty() ? "" : ", " + format) + ") " + (is_coherent(p, binding) ? "coherent " : "") +
           "uniform " + access_text(binding.access) + kind + "image" + shape_text(binding.shape) + " " +
           p.binding_names[index] + ";\n";
}

}  // namespace

std::string texel_text(Printer& p, ir::ExprId id) {
    const ir::Types& types = p.program.types;
    TypeId type = p.program.exprs[id].type;
    if (types.scalar_of(type) == types.int_) return print_any(p, id);
    std::uint32_t count = types.components(type);
    return (count == 1 ? "int" : "ivec" + std::to_string(count)) + "(" + print_any(p, id) + ")";
}

namespace {

/// A swizzle: image reads give four components, of which the element takes the first ones.
std::string first_components(Printer& p, TypeId element) {
    std::uint32_t count = p.program.types.components(element);
    return count == 4 ? "" : count == 1 ? ".x" : count == 2 ? ".xy" : ".xyz";
}

std::string four_components(Printer& p, ir::ExprId value) {
    const ir::Types& types = p.program.types;
    TypeId type = p.program.exprs[value].type;
    std::string vec4 = image_prefix(p, type) + "vec4";
    switch (types.components(type)) {
    case 1: return vec4 + "(" + print_any(p, value) + ")";
    case 2: return vec4 + "(" + print_any(p, value) + ", 0, 0)";
    case 3: return vec4 + "(" + print_any(p, value) + ", 0)";
    default: return print_any(p, value);
    }
}

}  // namespace

bool stored_as_bits(const Printer& p, const PassBinding& binding) {
    return binding.atomic && p.program.types.kind(binding.element) == TypeKind::float_ &&
           (binding.shape == MemoryShape::buffer || binding.ordered);
}

std::string bindings_text(Printer& p) {
    std::string text;
    for (std::size_t i = 0; i < p.pass.bindings.size(); ++i)
        if (is_used(p, i))
            text += p.pass.bindings[i].shape == MemoryShape::buffer ? buffer_text(p, i) : image_text(p, i);
    return text;
}

namespace {

std::string parameter_declaration(Printer& p, std::size_t i) {
    const ir::PassParameter& param = p.pass.parameters[i];
    const std::string& name = p.member_names.empty() ? p.parameter_names[i] : p.member_names[i];
    return declaration(p, param.type, name);
}

/// Whether a parameter that lies in a buffer may be copied to a variable: scalars and vectors may, matrices are read in
/// place. Structs, arrays and optionals have other types in a block than in a variable, and glslang's `?:` does not
/// convert between the two.
bool is_copied(const Printer& p, const ir::PassParameter& parameter) {
    const ir::TypeKind kind = p.program.types.kind(parameter.type);
    return parameter.source != ir::ParameterSource::address && kind != ir::TypeKind::struct_ &&
           kind != ir::TypeKind::array && kind != ir::TypeKind::matrix && kind != ir::TypeKind::optional;
}

}  // namespace

std::string parameter_members(Printer& p) {
    std::string text;
    for (std::size_t i = 0; i < p.pass.parameters.size(); ++i) {
        note_storage(p, p.pass.parameters[i].type);
        text += "    " + parameter_declaration(p, i) + ";\n";
    }
    return text;
}

std::string parameters_text(Printer& p) {
    if (p.pass.parameters.empty()) return "";
    if (p.pass.push_constants)
        return "layout(push_constant, scalar) uniform Parameters {\n" + parameter_members(p) + "};\n";
    const std::string memory = p.pass.uniform_buffer ? "uniform" : "readonly buffer";
    std::string text = "layout(scalar, set = 0, binding = 0) " + memory + " Parameters {\n" + parameter_members(p) +
                       "} parameters;\n\n"
                       "layout(constant_id = 103) const bool copies_parameters = false;\n"
                       "#define parameter(name) (copies_parameters ? name : parameters.name)\n";
    for (std::size_t i = 0; i < p.pass.parameters.size(); ++i)
        if (is_copied(p, p.pass.parameters[i])) text += parameter_declaration(p, i) + ";\n";
    return text;
}

void name_parameter_reads(Printer& p) {
    for (std::size_t i = 0; i < p.pass.parameters.size(); ++i)
        if (p.pass.parameters[i].source != ir::ParameterSource::address)
            p.parameter_names[i] = is_copied(p, p.pass.parameters[i]) ? "parameter(" + p.member_names[i] + ")"
                                                                      : "parameters." + p.member_names[i];
}

void print_parameter_copies(Printer& p) {
    const auto copied = [&](const ir::PassParameter& parameter) { return is_copied(p, parameter); };
    if (p.pass.push_constants || std::ranges::none_of(p.pass.parameters, copied)) return;
    line(p, "if (copies_parameters) {");
    ++p.indent;
    for (std::size_t i = 0; i < p.pass.parameters.size(); ++i)
        if (copied(p.pass.parameters[i])) line(p, p.member_names[i] + " = parameters." + p.member_names[i] + ";");
    --p.indent;
    line(p, "}");
}

namespace {

/// A depth comparison: GLSL takes the coordinates and the reference as one vector.
std::string compare_text(Printer& p, const ir::Expr& expr) {
    const std::string& name = p.binding_names.at(expr.slot);
    const std::uint32_t count = p.program.types.components(p.program.exprs[expr.operands[0]].type) + 1;
    const std::string at = "vec" + std::to_string(count) + "(" + print_any(p, expr.operands[0]) + ", " +
                           print_any(p, expr.operands[1]) + ")";
    if (p.pass.bindings[expr.slot].shape == MemoryShape::image2d) return "textureLod(" + name + ", " + at + ", 0.0)";
    const std::string flat = p.pass.bindings[expr.slot].shape == MemoryShape::imagecube ? "vec3(0.0)" : "vec2(0.0)";
    return "textureGrad(" + name + ", " + at + ", " + flat + ", " + flat + ")";  // textureLod lacks these samplers
}

}  // namespace

Text print_load(Printer& p, const ir::Expr& expr) {
    const PassBinding& binding = p.pass.bindings.at(expr.slot);
    const std::string& name = p.binding_names[expr.slot];
    if (expr.op == ir::Op::load) {
        if (is_row(p.program.types, binding, expr.type)) return {row_text(p, expr.slot, expr.operands[0])};
        std::string text = element_text(p, expr.slot, expr.operands[0]);
        return {stored_as_bits(p, binding) ? as_float(binding, text) : text};
    }
    std::string level = expr.operands.size() > 1          ? print_any(p, expr.operands[1])
                        : expr.op == ir::Op::image_sample ? "0.0"
                                                          : "0";
    std::string components = first_components(p, binding.element);
    if (expr.op == ir::Op::image_compare) return {compare_text(p, expr)};
    // textureGather gives the texels in the order (x, y + 1), (x + 1, y + 1), (x + 1, y), (x, y); the language's order
    // is (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1).
    if (expr.op == ir::Op::image_gather)
        return {"textureGather(" + name + ", " + print_any(p, expr.operands[0]) + ").wzxy"};
    if (expr.op == ir::Op::image_sample)
        return {"textureLod(" + name + ", " + print_any(p, expr.operands[0]) + ", " + level + ")" + components};
    std::string texel = texel_text(p, expr.operands[0]);
    if (binding.sampled) return {"texelFetch(" + name + ", " + texel + ", " + level + ")" + components};
    const std::string loaded = "imageLoad(" + name + ", " + texel + ")" + components;
    return {stored_as_bits(p, binding) ? as_float(binding, loaded) : loaded};
}

namespace {

bool has_half_channels(ir::Format format) {
    return format == ir::Format::r16f || format == ir::Format::rg16f || format == ir::Format::rgba16f;
}

}  // namespace

void print_store(Printer& p, const ir::Stmt& stmt) {
    const PassBinding& binding = p.pass.bindings.at(stmt.slot);
    const std::string& name = p.binding_names[stmt.slot];
    if (stmt.op == ir::StmtOp::image_store) {
        std::string texel = four_components(p, stmt.value);
        if (has_half_channels(binding.format)) texel = need(p, Helper::nearest_half, {}) + "(" + texel + ")";
        return line(p, "imageStore(" + name + ", " + texel_text(p, stmt.target) + ", " + texel + ");");
    }
    std::string value = print_any(p, stmt.value);
    if (is_row(p.program.types, binding, p.program.exprs[stmt.value].type))
        return line(p, row_text(p, stmt.slot, stmt.target) + " = " + value + ";");
    if (stored_as_bits(p, binding)) value = as_bits(binding, value);
    std::string place = element_text(p, stmt.slot, stmt.target);
    const ir::TypeId type = ir::for_each_step(
        p.program, p.pass, stmt, [&](std::uint32_t slot, ir::StructId of) { place += "." + p.field_names[of][slot]; });
    print_store(p, place, value, type);
}

}  // namespace gliftc::glsl
