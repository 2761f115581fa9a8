#include "layout/layout.h"

#include "layout/workgroup.h"

#include <algorithm>

namespace gliftc::layout {

using namespace ir;

namespace {

std::uint32_t rounded_up(std::uint32_t value, std::uint32_t align) { return (value + align - 1) / align * align; }

}  // namespace

namespace {

/// The offset of each field, and the size of the struct. Each field's size is computed once: a struct's size is the sum
/// of its fields', so that two computations per level of nesting would take exponential time.
struct Places {
    std::vector<std::uint32_t> offsets;
    Size size{0, 1};
};

Places places_in(const Program& program, const Struct& type) {
    Places places{type.offsets};
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < type.fields.size(); ++i) {
        const Size part = size_of(program, type.fields[i].type);
        if (type.offsets.empty()) places.offsets.push_back(rounded_up(end, part.align));
        places.size.align = std::max(places.size.align, part.align);
        end = std::max(end, places.offsets[i] + part.size);
    }
    places.size.size = type.size ? type.size : rounded_up(end, places.size.align);
    return places;
}

}  // namespace

std::vector<std::uint32_t> offsets_of(const Program& program, const Struct& type) {
    return type.offsets.empty() ? places_in(program, type).offsets : type.offsets;
}

Size size_of(const Program& program, TypeId id) {
    const Type& type = program.types[id];
    switch (type.kind) {
    case TypeKind::half: return {2, 2};
    case TypeKind::bool_:
    case TypeKind::int_:
    case TypeKind::uint:
    case TypeKind::float_:
    case TypeKind::enum_: return {4, 4};
    case TypeKind::double_:
    case TypeKind::int64:
    case TypeKind::uint64: return {8, 8};
    case TypeKind::vector: {
        Size part = size_of(program, type.element);
        return {part.size * type.count, part.align};
    }
    case TypeKind::matrix: {
        Size part = size_of(program, type.element);
        return {part.size * type.count * type.rows, part.align};
    }
    case TypeKind::array: {
        Size part = size_of(program, type.element);
        return {part.size * type.count, part.align};
    }
    case TypeKind::struct_: return places_in(program, program.structs[type.struct_]).size;
    case TypeKind::optional: {
        Size part = size_of(program, type.element);
        std::uint32_t align = std::max(part.align, 4u);
        return {rounded_up(rounded_up(4, part.align) + part.size, align), align};
    }
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: return {0, 1};
    }
    return {0, 1};
}

namespace {

bool holds_half(const Program& program, TypeId id) {
    const Type& type = program.types[id];
    if (type.kind == TypeKind::array || type.kind == TypeKind::optional) return holds_half(program, type.element);
    if (type.kind != TypeKind::struct_) return program.types.kind(program.types.scalar_of(id)) == TypeKind::half;
    return std::ranges::any_of(program.structs[type.struct_].fields,
                               [&](const StructField& field) { return holds_half(program, field.type); });
}

/// Whether parameters that are no push constants are in a uniform buffer: those that fit and hold no halves, which need
/// another device feature in uniform buffers. The others are in a storage buffer, from which each use is a load: a
/// 7-point stencil takes 1.3 times as long on an H200. Kernels with images stay there, since NVIDIA's driver (580.159)
/// fetches wrong texels for some of those with parameters in uniform buffers (examples/taxonomy/flat_3d_texture.glift).
/// Draws do not: helper invocations of fragment shaders read zeros from storage buffers on some devices
/// (ir/derivatives.h).
bool suits_uniform_buffer(const Program& program, const Pass& pass) {
    const bool draws = pass.kernel && program.kernels[pass.kernel].raster;
    const bool has_images = std::ranges::any_of(
        pass.bindings, [](const ir::PassBinding& binding) { return binding.shape != ir::MemoryShape::buffer; });
    return (draws || !has_images) && pass.parameter_bytes <= uniform_buffer_limit &&
           std::ranges::none_of(pass.parameters,
                                [&](const PassParameter& parameter) { return holds_half(program, parameter.type); });
}

void lay_out(const Program& program, Pass& pass) {
    std::uint32_t end = 0, align = 4;
    for (PassParameter& parameter : pass.parameters) {
        Size part = size_of(program, parameter.type);
        parameter.offset = rounded_up(end, part.align);
        end = parameter.offset + part.size;
        align = std::max(align, part.align);
    }
    pass.parameter_bytes = rounded_up(end, align);
    pass.push_constants = pass.form == Form::direct && !pass.of_blocks && pass.parameter_bytes <= push_constant_limit;
    pass.uniform_buffer = !pass.push_constants && suits_uniform_buffer(program, pass);
}

}  // namespace

void lay_out(Program& program, Lowered& lowered) {
    for (Lowered::Forms& forms : lowered.passes)
        for (Pass* pass : forms.all()) {
            lay_out(program, *pass);
            place_shared(program, *pass);
        }
}

}  // namespace gliftc::layout
