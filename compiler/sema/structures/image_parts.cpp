#include "sema/structures/image_parts.h"

#include "sema/bodies/builder.h"
#include "sema/structures/components.h"
#include "sema/types/generics.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

ir::ExprId first_two(ir::Program& p, ir::ExprId vector, Span span) {
    const ir::TypeId type = p.types.vector(p.types.scalar_of(p.exprs[vector].type), 2);
    const ir::ExprId both = add(p, ir::Op::swizzle, type, span, {vector});
    p.exprs[both].lanes = {0, 1};
    return both;
}

/// The extent of a mip level: halved once per level, one texel at least along each axis. The number of layers stays the
/// same.
ir::ExprId extent_of_level(Body& body, ir::ExprId extent, ir::MemoryShape shape, ir::ExprId level, Span span) {
    ir::Program& p = body.program();
    const ir::TypeId type = p.exprs[extent].type;
    const auto halved = [&](ir::ExprId all) {
        const ir::TypeId own = p.exprs[all].type;
        const auto splat = [&](ir::ExprId number) {
            return p.types.is_vector(own) ? add(p, ir::Op::construct, own, span, {number}) : number;
        };
        const ir::ExprId shifted = make_binary(p, ir::BinaryOp::shift_right, own, all, splat(level), span);
        const ir::ExprId least = add(p, ir::Op::intrinsic, own, span, {shifted, splat(make_uint(p, 1, span))});
        p.exprs[least].intrinsic = ir::Intrinsic::max;
        return least;
    };
    if (!has_layers(shape)) return halved(extent);
    return add(p, ir::Op::construct, type, span,
               {halved(first_two(p, extent, span)), make_swizzle(p, extent, 2, span)});
}

}  // namespace

bool is_image_part(Body& body, ast::ExprId id) {
    const Context& c = body.context;
    const ast::Expr& expr = c[id];
    if (expr.kind != ast::ExprKind::call || expr.operands.size() != 2) return false;
    const ast::Expr& callee = c[expr.operands[0]];
    if (callee.kind != ast::ExprKind::member) return false;
    const std::string& name = c.text(callee.name);
    // A callee of the form `name.layer` does not denote a layer: `module.layer(…)` constructs a structure that a module
    // declares.
    return (name == "mip" || name == "layer") && c[callee.operands[0]].kind == ast::ExprKind::member;
}

void add_image_part(Body& body, ir::StructureId index, const ast::Item& item) {
    Context& c = body.context;
    const ast::Expr& call = c[item.value];
    const ast::Expr& callee = c[call.operands[0]];
    const bool is_mip = c.text(callee.name) == "mip";
    const Operand image = check(body, callee.operands[0]);
    if (image.kind == OperandKind::error) return;
    const auto refuse = [&](const char* remedy) { note(c.error(Diag::memory_form, callee.span), callee.span, remedy); };
    if (image.kind != OperandKind::memory || image.place.members.empty())
        return refuse("levels and layers are those of an image of another structure: of.data.mip(1)");
    const ir::Memory whole = c.program.structures[image.structure].memories[image.slot];
    if (whole.shape == ir::MemoryShape::buffer) return refuse("a buffer has no levels and no layers");
    if (!is_mip && !has_layers(whole.shape))
        return refuse("only image2d<F>(extent, layers) and imagecube<F>(side) have layers");
    if (is_mip && !whole.mips) return refuse("write 'mips(n)' where the image is declared");
    if (item.mips || item.filter || item.compare)
        note(c.error(Diag::memory_of_structure, item.span), callee.span,
             "they stand where the whole image is declared");
    ir::Memory memory = whole;
    memory.name = item.name.name;
    memory.span = item.name.span;
    memory.mips = {};
    const ir::ExprId number = check_value(body, call.operands[1], c.types().uint);
    memory.part = {is_mip ? ir::ImagePart::Kind::mip : ir::ImagePart::Kind::layer, image.place, image.slot, number};
    const ir::ExprId extent =
        structure_operation(body, ir::Op::memory_extent, c.program.exprs[whole.extent].type, image, callee.span);
    c.program.exprs[extent].slot = image.slot;
    memory.extent = is_mip ? extent_of_level(body, extent, whole.shape, number, callee.span)
                           : first_two(c.program, extent, callee.span);
    if (!is_mip) memory.shape = ir::MemoryShape::image2d;
    declare_memory(body, index, memory);
}

bool keeps_texels(const Context& c, const ir::Structure& structure) {
    if (structure.kind != ir::StructureKind::stored || structure.memories.empty()) return false;
    if (structure.memories[structure.via_memory].shape == ir::MemoryShape::buffer) return false;
    return std::ranges::all_of(structure.via, [&](const ir::Stage& stage) {
        const ir::FunctionId translate = c.program.translators[stage.translator].translate;
        const ir::ExprId value = single_return(c.program, translate);
        return value && c.program.exprs[value].op == ir::Op::local &&
               c.program.exprs[value].local == c.program.functions[translate].params[0];
    });
}

bool has_filtered_levels(const Context& c, const ir::Structure& structure) {
    if (!keeps_texels(c, structure)) return false;
    const ir::Memory& memory = structure.memories[structure.via_memory];
    return memory.mips && memory.format != ir::Format::d32;
}

void declare_memory(Body& body, ir::StructureId index, const ir::Memory& memory) {
    ir::Structure& structure = body.program().structures[index];
    structure.memories.push_back(memory);
    if (memory.fields.empty()) structure.memories.back().declared = memory.name;
    const Name declared = structure.memories.back().declared;
    if (!declared) return;
    Symbol symbol;
    symbol.kind = SymbolKind::memory;
    symbol.structure = index;
    symbol.slot = static_cast<std::uint32_t>(structure.memories.size() - 1);
    declare(body, {declared, memory.span}, symbol);
}

}  // namespace gliftc::sema
