#include "sema/kernels/texture.h"

#include "ir/chain.h"
#include "ir/effects.h"
#include "sema/structures/components.h"
#include "sema/structures/image_parts.h"
#include "sema/types/typing.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

Operand wrong_count(Body& body, std::string_view name, const char* wanted, std::size_t found, Span span) {
    body.context.error(Diag::argument_count, span, {std::string(name), wanted, std::to_string(found)});
    return error_operand(span);
}

/// A point among the elements: one float for each axis of their addresses.
ir::ExprId point(Body& body, const Operand& self, ast::ExprId argument) {
    const ir::TypeId domain = body.program().structures[self.structure].domain_type;
    return check_value(body, argument, body.types().with_scalar(domain, body.types().float_));
}

Operand operation(Body& body, ir::Op op, ir::TypeId type, const Operand& self, const ir::Operands& operands,
                  Span span) {
    for (ir::ExprId operand : operands)
        if (is_error(body, operand)) return error_operand(span);
    return value_operand(body, structure_operation(body, op, type, self, span, operands), span);
}

/// Whether the structure keeps element a in texel a of an image of this shape. A structure without `via` whose memory
/// is a structure keeps its elements as that memory does.
bool keeps_texels_of(Body& body, const ir::Structure& structure, ir::MemoryShape shape) {
    const ir::Structure* link = &structure;
    while (!link->base.empty() && link->via.empty()) link = &ir::structure_at(body.program(), *link, link->base);
    return keeps_texels(body.context, *link) && link->memories[link->via_memory].shape == shape;
}

/// Whether the elements are the texels of a cube, so that points are directions.
bool is_cube(Body& body, const ir::Structure& structure) {
    return keeps_texels_of(body, structure, ir::MemoryShape::imagecube);
}

/// Whether the structure, if its elements are the texels of a cube, has the method of this name; reports one that it
/// does not have.
bool fits_cube(Body& body, std::string_view name, const ir::Structure& structure, Span span) {
    if (!is_cube(body, structure)) return true;
    const bool is_depth = ir::root_memory(body.program(), structure).format == ir::Format::d32;
    if (name == (is_depth ? "compare" : "sample")) return true;
    note(body.context.error(is_depth ? Diag::sample_element : Diag::compare_element, span,
                            {structure.display, body.context.text(structure.element)}),
         span, "cubes of d32 have 'compare', others 'sample'; faces are images that have both: 'of.data.layer(face)'");
    return false;
}

/// Whether the type is of floats: a number, a vector, or a struct of them.
bool is_interpolated(Body& body, ir::TypeId type) {
    const ir::Types& types = body.types();
    if (types.is_scalar(type) || types.is_vector(type)) return types.is_floating(types.scalar_of(type));
    if (types.kind(type) != ir::TypeKind::struct_) return false;
    return std::ranges::all_of(body.program().structs[types[type].struct_].fields,
                               [&](const ir::StructField& field) { return is_interpolated(body, field.type); });
}

/// The number of a level: a uint, or a float, which may lie between two levels.
ir::ExprId level(Body& body, ast::ExprId argument) {
    const bool is_literal =
        is_flexible(body.context, argument) && body.context[argument].kind != ast::ExprKind::float_literal;
    const ir::ExprId value = check_value(body, argument, is_literal ? body.types().uint : ir::TypeId{});
    if (is_error(body, value) || body.program().exprs[value].type == body.types().float_) return value;
    return coerce(body, value, body.types().uint, body.context[argument].span);
}

/// `s.sample(x)`, or `s.sample(x, level)` of an image with levels.
Operand sample(Body& body, const Operand& self, const std::vector<ast::ExprId>& arguments, const ast::Expr& call) {
    Context& c = body.context;
    const ir::Structure& structure = body.program().structures[self.structure];
    const ir::TypeId element = structure.element;
    if (arguments.size() != 1 && arguments.size() != 2)
        return wrong_count(body, "sample", "1 or 2", arguments.size(), call.span);
    if (!is_interpolated(body, element)) {
        c.error(Diag::sample_element, call.span, {structure.display, c.text(element)});
        return error_operand(call.span);
    }
    if (arguments.size() == 2 && !has_filtered_levels(c, structure)) {
        note(c.error(Diag::sample_level, call.span, {structure.display}), c[arguments[1]].span,
             "levels are those of an image declared with 'mips(n)', of another format than d32, whose texels the "
             "structure keeps at their own addresses");
        return error_operand(call.span);
    }
    if (!fits_cube(body, "sample", structure, call.span)) return error_operand(call.span);
    ir::Operands operands;
    operands.push_back(point(body, self, arguments[0]));
    if (arguments.size() == 2) operands.push_back(level(body, arguments[1]));
    return operation(body, ir::Op::sample, element, self, operands, call.span);
}

/// Whether addresses have two axes, or three of which the last counts the layers of an image.
bool is_flat(Body& body, const ir::Structure& structure) {
    const std::uint32_t axes = body.types().components(structure.domain_type);
    if (axes == 2) return true;
    return axes == 3 && keeps_texels_of(body, structure, ir::MemoryShape::image2darray);
}

/// `s.gather(x)`: the four elements around x.
Operand gather(Body& body, const Operand& self, const std::vector<ast::ExprId>& arguments, const ast::Expr& call) {
    Context& c = body.context;
    const ir::Structure& structure = body.program().structures[self.structure];
    const ir::TypeId element = structure.element;
    if (arguments.size() != 1) return wrong_count(body, "gather", "1", arguments.size(), call.span);
    const bool is_number =
        element == body.types().float_ || element == body.types().int_ || element == body.types().uint;
    if (!is_number || !is_flat(body, structure)) {
        note(c.error(Diag::gather_form, call.span, {structure.display}), call.span,
             "gather takes structures of two axes, or of layers of an image, whose elements are one float, int or "
             "uint; read what others have by address");
        return error_operand(call.span);
    }
    return operation(body, ir::Op::gather, body.types().vector(element, 4), self, {point(body, self, arguments[0])},
                     call.span);
}

/// `s.compare(x, reference)`: compares the reference with each element around x as the memory declares (`compare
/// less`), and filters the results, 1 where the comparison holds and 0 where not.
Operand compare(Body& body, const Operand& self, const std::vector<ast::ExprId>& arguments, const ast::Expr& call) {
    Context& c = body.context;
    const ir::Structure& structure = body.program().structures[self.structure];
    if (arguments.size() != 2) return wrong_count(body, "compare", "2", arguments.size(), call.span);
    if (structure.element != body.types().float_) {
        note(c.error(Diag::compare_element, call.span, {structure.display, c.text(structure.element)}), call.span,
             "elements are one float, as those of images of d32, r32f, r16f and r8");
        return error_operand(call.span);
    }
    if (!fits_cube(body, "compare", structure, call.span)) return error_operand(call.span);
    ir::Operands operands;
    operands.push_back(point(body, self, arguments[0]));
    operands.push_back(check_value(body, arguments[1], body.types().float_));
    return operation(body, ir::Op::compare, body.types().float_, self, operands, call.span);
}

/// Whether the structure is not written by scatter, nor through a parameter that is `out` or `inout`; `coherent` and
/// `calls` are allowed. Reports a structure that is so written: other invocations may write the elements around a
/// point.
bool is_read(Body& body, const Operand& self, std::string_view name, Span span) {
    const bool is_param = body.kernel != nullptr && self.place.root < body.kernel->params.size();
    const ir::KernelParam* const param = is_param ? &body.kernel->params[self.place.root] : nullptr;
    const bool is_shared =
        param != nullptr && (param->pattern == ir::Pattern::coherent || param->pattern == ir::Pattern::calls);
    const bool is_written =
        self.writing.is(ir::Pattern::scatter) ||
        (param != nullptr && !is_shared && ir::is_structure(*param) && param->direction != ir::Direction::in);
    if (!is_written) return true;
    Context& c = body.context;
    note(c.error(Diag::scatter_read, span,
                 {param != nullptr ? c.text(param->name) : c.program.structures[self.structure].display}),
         span,
         "other invocations write what '" + std::string(name) +
             "' would read: give the kernel a second structure, as 'in any<…>'");
    return false;
}

}  // namespace

std::optional<Operand> call_of_texture(Body& body, std::string_view name, const Operand& self,
                                       const std::vector<ast::ExprId>& arguments, const ast::Expr& call) {
    if (name != "sample" && name != "gather" && name != "compare") return std::nullopt;
    if (!is_read(body, self, name, call.span)) return error_operand(call.span);
    if (name == "sample") return sample(body, self, arguments, call);
    if (name == "gather") return gather(body, self, arguments, call);
    return compare(body, self, arguments, call);
}

}  // namespace gliftc::sema
