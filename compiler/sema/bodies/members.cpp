// `a.b` and `a[b]`: swizzles, fields, members of structures, elements.
#include "sema/bodies/order.h"

#include "sema/names/record.h"
#include "sema/names/unknown_names.h"
#include "sema/pipelines/values.h"
#include "sema/structures/projection.h"
#include "sema/types/instances.h"
#include "sema/types/typing.h"

namespace gliftc::sema {

Operand unknown_member(Body& body, std::string_view what, ast::Identifier member,
                       const std::vector<std::string_view>& known) {
    Context& c = body.context;
    Diagnostic& diagnostic = c.error(Diag::unknown_member, member.span, {what, c.text(member.name)});
    std::string_view meant = did_you_mean(c.text(member.name), known);
    if (!meant.empty()) note(diagnostic, member.span, "did you mean '" + std::string(meant) + "'?");
    return error_operand(member.span);
}

namespace {

int lane_of(char letter) {
    switch (letter) {
    case 'x':
    case 'r':
    case 's': return 0;
    case 'y':
    case 'g':
    case 't': return 1;
    case 'z':
    case 'b':
    case 'p': return 2;
    case 'w':
    case 'a':
    case 'q': return 3;
    default: return -1;
    }
}

Operand struct_field(Body& body, ir::ExprId value, ast::Identifier member) {
    Context& c = body.context;
    ir::TypeId type = body.program().exprs[value].type;
    const ir::Struct& record = body.program().structs[body.types()[type].struct_];
    std::vector<std::string_view> known;
    for (std::uint32_t i = 0; i < record.fields.size(); ++i) {
        if (record.fields[i].name == member.name) {
            ir::ExprId field = add(body.program(), ir::Op::field, record.fields[i].type, member.span, {value});
            body.program().exprs[field].slot = i;
            record_field(c, member.span, body.types()[type].struct_, i);
            add_part(body, value, field);
            return value_operand(body, field, member.span);
        }
        known.push_back(c.text(record.fields[i].name));
    }
    return unknown_member(body, record.display, member, known);
}

Operand enumerator(Body& body, const ir::Type& type, ir::TypeId id, ast::Identifier member) {
    const ir::Enum& declared = body.program().enums[type.enum_];
    std::vector<std::string_view> known;
    for (std::size_t i = 0; i < declared.enumerators.size(); ++i) {
        if (declared.enumerators[i] == member.name) {
            ir::ExprId value = add(body.program(), ir::Op::constant, id, member.span);
            body.program().exprs[value].bits = declared.values[i];
            record_enumerator(body.context, member.span, declared, i);
            return value_operand(body, value, member.span);
        }
        known.push_back(body.context.text(declared.enumerators[i]));
    }
    return unknown_member(body, "the enum " + body.context.text(id), member, known);
}

/// The imported module that `a.b.c` names, unless `a` is declared in the body.
ir::ModuleId module_of_chain(Body& body, ast::ExprId id) {
    const ir::ModuleId module = module_by_whole_name(body.context, body.env, id);
    if (!module) return {};
    while (body.context[id].kind == ast::ExprKind::member) id = body.context[id].operands[0];
    return find_symbol(body, body.context[id].name) ? ir::ModuleId{} : module;
}

Operand meta_member(Body& body, const Operand& left, const ast::Expr& expr) {
    Context& c = body.context;
    ast::Identifier member{expr.name, expr.name_span};
    if (left.meta.kind == MetaKind::type && body.types().kind(left.meta.type) == ir::TypeKind::enum_)
        return enumerator(body, body.types()[left.meta.type], left.meta.type, member);
    if (left.meta.kind == MetaKind::module) {
        Operand operand;
        operand.span = expr.span;
        operand.meta = find_in_module(c, body.env, left.meta.module, member);
        if (operand.meta.kind == MetaKind::none) return operand;
        if (is_constant(c, operand.meta)) return constant_operand(body, operand.meta, expr.span);
        operand.kind = OperandKind::meta;
        return operand;
    }
    if (left.meta.kind == MetaKind::declarations && left.meta.declarations.size() == 1) {
        Meta type = meta_of(c, env_for(body, expr.operands[0]), expr.operands[0]);
        if (type.kind == MetaKind::type && body.types().kind(type.type) == ir::TypeKind::enum_)
            return enumerator(body, body.types()[type.type], type.type, member);
        if (type.kind == MetaKind::none) return error_operand(expr.span);
    }
    return unknown_member(body, "this", member, {});
}

/// The type of a memory's extent: uint, uint2 or uint3.
ir::TypeId extent_type(ir::Types& types, ir::MemoryShape shape) {
    switch (shape) {
    case ir::MemoryShape::buffer:
    case ir::MemoryShape::image1d: return types.uint;
    case ir::MemoryShape::image2d: return types.vector(types.uint, 2);
    case ir::MemoryShape::image3d:
    case ir::MemoryShape::imagecube:
    case ir::MemoryShape::image2darray: return types.vector(types.uint, 3);
    }
    return types.uint;
}

Operand memory_member(Body& body, const Operand& left, ast::Identifier member) {
    Context& c = body.context;
    if (c.text(member.name) == "extent") {
        ir::MemoryShape shape = body.program().structures[left.structure].memories[left.slot].shape;
        ir::ExprId extent =
            structure_operation(body, ir::Op::memory_extent, extent_type(body.types(), shape), left, member.span);
        body.program().exprs[extent].slot = left.slot;
        return value_operand(body, extent, member.span);
    }
    return unknown_member(body, "memory", member, {"extent"});
}

ir::ExprId index_value(Body& body, ast::ExprId id) {
    ir::TypeId hint = is_flexible(body.context, id) ? body.types().uint : ir::TypeId{};
    ir::ExprId index = check_value(body, id, hint);
    if (is_error(body, index)) return index;
    ir::TypeId type = body.program().exprs[index].type;
    if (type != body.types().int_ && type != body.types().uint) {
        body.context.error(Diag::index_type, body.context[id].span, {body.context.text(type)});
        return error_value(body, body.context[id].span);
    }
    return index;
}

Operand index_part(Body& body, ir::ExprId value, const ast::Expr& expr) {
    Context& c = body.context;
    if (is_error(body, value)) return error_operand(expr.span);
    const ir::Type type = body.types()[body.program().exprs[value].type];
    ir::TypeId part = type.kind == ir::TypeKind::matrix ? body.types().vector(type.element, type.rows) : type.element;
    std::uint32_t count = type.count;
    if (body.types().is_scalar(body.program().exprs[value].type)) {
        part = body.program().exprs[value].type;  // a scalar counts as a vector of one component
        count = 1;
    } else if (type.kind != ir::TypeKind::vector && type.kind != ir::TypeKind::matrix &&
               type.kind != ir::TypeKind::array) {
        c.error(Diag::not_indexable, expr.span, {c.text(body.program().exprs[value].type)});
        return error_operand(expr.span);
    }
    if (is_changeable(body, value)) is_target(body, value);  // the element is read after the index
    ir::ExprId index = index_value(body, expr.operands[1]);
    if (is_error(body, index)) return error_operand(expr.span);
    if (auto known = ir::evaluate(body.program(), index)) {
        if (known->bits() >= count) {
            Diagnostic& diagnostic = c.error(
                Diag::index_range, c[expr.operands[1]].span,
                {ir::to_text(body.program(), *known), c.text(body.program().exprs[value].type), std::to_string(count)});
            if (body.types().is_scalar(body.program().exprs[value].type))
                note(diagnostic, expr.span,
                     "this is one element; others are reached through a parameter that is 'near<S, r>' or 'any<S>'");
            return error_operand(expr.span);
        }
        if (count == 1 && type.kind != ir::TypeKind::array) return value_operand(body, value, expr.span);
        if (type.kind == ir::TypeKind::vector) {
            const ir::ExprId component =
                make_swizzle(body.program(), value, static_cast<std::uint8_t>(known->bits()), expr.span);
            add_part(body, value, component);
            return value_operand(body, component, expr.span);
        }
    }
    if (count == 1 && type.kind != ir::TypeKind::array) {
        settle(body, {&value, 1});  // the index does not matter, its effects do
        return value_operand(body, value, expr.span);
    }
    const ir::ExprId indexed = add(body.program(), ir::Op::index, part, expr.span, {value, index});
    add_part(body, value, indexed);
    return value_operand(body, indexed, expr.span);
}

/// `window[offset]`: the element at the current address plus a constant offset.
Operand index_window(Body& body, const Operand& window, ir::StructureId structure, const ast::Expr& expr) {
    Context& c = body.context;
    ir::TypeId element = body.program().structures[structure].element;
    ir::TypeId offset_type = signed_address(body.types(), body.program().structures[structure].domain_type);
    ir::ExprId offset;
    if (is_flexible(c, expr.operands[1])) {
        offset = check_value(body, expr.operands[1], body.types().int_);
        if (body.types().is_vector(offset_type) && !is_error(body, offset))
            offset = add(body.program(), ir::Op::construct, offset_type, expr.span, {offset});
    } else {
        offset = check_value(body, expr.operands[1], offset_type);
    }
    if (is_error(body, offset)) return error_operand(expr.span);
    ir::ExprId near = add(body.program(), ir::Op::near, element, expr.span, {offset});
    body.program().exprs[near].place = window.place;
    return value_operand(body, near, expr.span);
}

/// Reports a read by address of a parameter or member with the pattern scatter, which is only written.
Operand scatter_read(Body& body, const Operand& structure, const ast::Expr& expr) {
    Context& c = body.context;
    const ast::Expr& named = c[expr.operands[0]];
    const std::string& name =
        named.kind == ast::ExprKind::name ? c.text(named.name) : c.program.structures[structure.structure].display;
    note(c.error(Diag::scatter_read, expr.span, {name}), structure.writing.span,
         "a scatter parameter is only written: name[address] = value");
    return error_operand(expr.span);
}

Operand index_iterator(Body& body, const Operand& left, const ast::Expr& expr) {
    const ir::KernelParam& param = body.kernel->params[left.slot];
    if (param.pattern != ir::Pattern::near) return index_part(body, to_value(body, left), expr);
    Operand window = left;
    window.place.root = left.slot;
    const bool is_component = !left.place.members.empty();
    return index_window(body, window, is_component ? left.structure : param.structure, expr);
}

}  // namespace

ir::TypeId signed_address(ir::Types& types, ir::TypeId domain) { return types.with_scalar(domain, types.int_); }

ir::ExprId structure_operation(Body& body, ir::Op op, ir::TypeId type, const Operand& structure, Span span,
                               ir::Operands operands) {
    ir::ExprId id = add(body.program(), op, type, span, std::move(operands));
    body.program().exprs[id].place = structure.place;
    body.program().exprs[id].local = structure.local;
    const bool is_range = op == ir::Op::slice || op == ir::Op::structure_value;
    if (body.kind == BodyKind::pipeline ? !is_range : !structure.writing.is(ir::Pattern::any)) add_read(body, id);
    return id;
}

ir::ExprId make_read(Body& body, const Operand& structure, ir::ExprId address, Span span) {
    return structure_operation(body, ir::Op::read, body.program().structures[structure.structure].element, structure,
                               span, {address});
}

Operand make_swizzle_of(Body& body, ir::ExprId value, ast::Identifier member) {
    Context& c = body.context;
    const std::string& letters = c.text(member.name);
    ir::TypeId type = body.program().exprs[value].type;
    std::uint32_t components = body.types().components(type);
    std::array<std::uint8_t, 4> lanes{};
    bool valid = !letters.empty() && letters.size() <= 4;
    for (std::size_t i = 0; valid && i < letters.size(); ++i) {
        int lane = lane_of(letters[i]);
        valid = lane >= 0 && static_cast<std::uint32_t>(lane) < components;
        if (valid) lanes[i] = static_cast<std::uint8_t>(lane);
    }
    if (!valid) return unknown_member(body, c.text(type), member, {});
    auto count = static_cast<std::uint32_t>(letters.size());
    if (components == 1) {
        if (count == 1) return value_operand(body, value, member.span);
        return value_operand(
            body, add(body.program(), ir::Op::construct, body.types().vector(type, count), member.span, {value}),
            member.span);
    }
    ir::ExprId swizzle = add(body.program(), ir::Op::swizzle, body.types().vector(body.types().scalar_of(type), count),
                             member.span, {value});
    body.program().exprs[swizzle].lanes = lanes;
    add_part(body, value, swizzle);
    return value_operand(body, swizzle, member.span);
}

/// The structure to which a path of members leads.
static Operand member_at(const Body& body, const Operand& left, const std::vector<std::uint32_t>& path, Span span) {
    Operand nested = left;
    nested.span = span;
    nested.is_slice = false;
    if (!left.writing.is(ir::Pattern::calls)) nested.writing = {};
    for (std::uint32_t member : path) {
        nested.place.members.push_back(member);
        nested.structure = body.context.program.structures[nested.structure].members[member].structure;
    }
    return nested;
}

Operand structure_member(Body& body, const Operand& left, ast::Identifier member) {
    Context& c = body.context;
    const ir::Structure& structure = body.program().structures[left.structure];
    std::vector<std::string_view> known;
    for (std::uint32_t i = 0; i < structure.constructor.size(); ++i) {
        const ir::Local& local = body.program().locals[structure.constructor[i]];
        known.push_back(c.text(local.name));
        if (local.name != member.name) continue;
        record_use(c, member.span, local.span);
        ir::ExprId value = structure_operation(body, ir::Op::member, local.type, left, member.span);
        body.program().exprs[value].slot = i;
        return value_operand(body, value, member.span);
    }
    for (std::uint32_t i = 0; i < structure.members.size(); ++i) {
        known.push_back(c.text(structure.members[i].name));
        if (structure.members[i].name != member.name) continue;
        if (structure.members[i].is_component) record_component(c, left.structure, member);
        else record_use(c, member.span, structure.members[i].span);
        return member_at(body, left, {i}, member.span);
    }
    if (!structure.base.empty()) {
        known.push_back(c.text(structure.base_name));
        if (structure.base_name == member.name) {
            record_use(c, member.span, structure.base_span);
            return member_at(body, left, structure.base, member.span);
        }
    }
    for (std::uint32_t i = 0; i < structure.memories.size(); ++i) {
        const Name name = structure.memories[i].declared;
        if (!name) continue;
        known.push_back(c.text(name));
        if (name != member.name) continue;
        record_use(c, member.span, structure.memories[i].span);
        Operand memory = left;
        memory.kind = OperandKind::memory;
        memory.span = member.span;
        memory.slot = i;
        return memory;
    }
    for (std::uint32_t i = 0; i < structure.host.size(); ++i) {
        known.push_back(c.text(structure.host[i].name));
        if (structure.host[i].name != member.name) continue;
        record_use(c, member.span, structure.host[i].span);
        ir::ExprId value = structure_operation(body, ir::Op::host_state, structure.host[i].type, left, member.span);
        body.program().exprs[value].slot = i;
        return value_operand(body, value, member.span);
    }
    for (std::string_view field : component_names(c, left.structure)) known.push_back(field);
    if (const auto component = component_of(c, left.structure, member)) {
        record_component(c, left.structure, member);
        return member_at(body, left, {*component}, member.span);
    }
    return unknown_member(body, body.program().structures[left.structure].display, member, known);
}

Operand check_member(Body& body, ast::ExprId id) {
    const ast::Expr& expr = body.context[id];
    ast::Identifier member{expr.name, expr.name_span};
    if (auto property = check_device_member(body, expr)) return *property;
    if (const ir::ModuleId module = module_of_chain(body, id)) {
        Operand operand;
        operand.kind = OperandKind::meta;
        operand.span = expr.span;
        operand.meta.kind = MetaKind::module;
        operand.meta.module = module;
        return operand;
    }
    const Parts parts(body);
    Operand left = check(body, expr.operands[0]);
    switch (left.kind) {
    case OperandKind::error: return error_operand(expr.span);
    case OperandKind::meta: return meta_member(body, left, expr);
    case OperandKind::structure: return structure_member(body, left, member);
    case OperandKind::memory: return memory_member(body, left, member);
    case OperandKind::iterator: {
        const ir::KernelParam& param = body.kernel->params[left.slot];
        if (param.pattern == ir::Pattern::near) return structure_member(body, left, member);
        break;
    }
    case OperandKind::value: break;
    }
    ir::ExprId value = to_value(body, left);
    if (is_error(body, value)) return error_operand(expr.span);
    ir::TypeId type = body.program().exprs[value].type;
    Operand result;
    if (body.types().kind(type) == ir::TypeKind::struct_) result = struct_field(body, value, member);
    else if (body.types().is_vector(type) || body.types().is_scalar(type))
        result = make_swizzle_of(body, value, member);
    else result = unknown_member(body, body.context.text(type), member, {});
    result.span = expr.span;
    if (result.expr) body.program().exprs[result.expr].span = expr.span;
    return result;
}

Operand check_index(Body& body, ast::ExprId id, ir::TypeId) {
    Context& c = body.context;
    const ast::Expr& expr = c[id];
    Operand left = check_part(body, expr.operands[0]);
    if (left.kind == OperandKind::error) return error_operand(expr.span);
    if (left.kind == OperandKind::meta) {
        Operand operand;
        operand.meta = meta_of(c, env_for(body, id), id);  // T[n] as a type
        operand.kind = operand.meta.kind == MetaKind::none ? OperandKind::error : OperandKind::meta;
        operand.span = expr.span;
        return operand;
    }
    if (expr.operands.size() != 2) {
        c.error(Diag::index_count, expr.span, {std::to_string(expr.operands.size() - 1)});
        return error_operand(expr.span);
    }
    if (left.kind == OperandKind::iterator) return index_iterator(body, left, expr);
    if (body.kind == BodyKind::pipeline)
        if (auto structure = as_structure(body, left)) return check_pipeline_index(body, *structure, expr);
    if (left.kind == OperandKind::structure) {
        const ir::Structure& structure = body.program().structures[left.structure];
        if (structure.kind == ir::StructureKind::no_elements) {
            c.error(Diag::not_indexable, expr.span, {structure.display});
            return error_operand(expr.span);
        }
        if (left.window.largest() > 0) return index_window(body, left, left.structure, expr);
        if (left.writing.is(ir::Pattern::scatter)) return scatter_read(body, left, expr);
        ir::ExprId address = check_value(body, expr.operands[1], structure.domain_type);
        if (is_error(body, address)) return error_operand(expr.span);
        return value_operand(body, make_read(body, left, address, expr.span), expr.span);
    }
    ir::ExprId value = to_value(body, left);
    if (is_error(body, value)) return error_operand(expr.span);
    const Parts parts(body);
    return index_part(body, value, expr);
}

}  // namespace gliftc::sema
