// long: the checks of all items of structures
// Structures: constructor, memories, nested structures, `via`, domain.
#include "ir/chain.h"
#include "ir/empty.h"
#include "ir/spelling.h"
#include "sema/structures/blocks.h"
#include "sema/structures/components.h"
#include "sema/structures/constructors.h"
#include "sema/structures/image_parts.h"
#include "sema/structures/memory_structure.h"
#include "sema/types/generics.h"
#include "sema/types/instances.h"
#include "sema/types/typing.h"

namespace gliftc::sema {

namespace {

ir::Format format_of(const ir::Types& types, ir::TypeId type) {
    ir::TypeId scalar = types.scalar_of(type);
    std::uint32_t n = types.components(type);
    if (scalar == types.float_)
        return n == 1 ? ir::Format::r32f : n == 2 ? ir::Format::rg32f : n == 4 ? ir::Format::rgba32f : ir::Format::none;
    if (scalar == types.uint)
        return n == 1   ? ir::Format::r32ui
               : n == 2 ? ir::Format::rg32ui
               : n == 4 ? ir::Format::rgba32ui
                        : ir::Format::none;
    if (scalar == types.int_)
        return n == 1 ? ir::Format::r32i : n == 2 ? ir::Format::rg32i : n == 4 ? ir::Format::rgba32i : ir::Format::none;
    return ir::Format::none;
}

ir::TypeId address_type(ir::Types& types, ir::MemoryShape shape) {
    switch (shape) {
    case ir::MemoryShape::buffer:
    case ir::MemoryShape::image1d: return types.uint;
    case ir::MemoryShape::image2d: return types.vector(types.uint, 2);
    case ir::MemoryShape::image3d:
    case ir::MemoryShape::image2darray:
    case ir::MemoryShape::imagecube: return types.vector(types.uint, 3);
    }
    return types.uint;
}

constexpr const char* memory_remedy = "write buffer<T>[n], image1d<F>(n), image2d<F>(extent), image2d<F>(extent, "
                                      "layers), image3d<F>(extent), imagecube<F>(side), a structure "
                                      "with its arguments, or the name of one";

/// The parts of `buffer<T>[n]` or `image2d<F>(extent, layers)` as written; `layers` may be absent.
struct MemoryText {
    Name shape;
    Span shape_span;
    ast::ExprId element, extent, layers;
};

std::optional<MemoryText> read_memory(Context& c, ast::ExprId id) {
    const ast::Expr& expr = c[id];
    const bool is_call = expr.kind == ast::ExprKind::call;
    const std::size_t count = expr.operands.size();
    const bool form = (expr.kind == ast::ExprKind::index && count == 2) || (is_call && (count == 2 || count == 3));
    if (form && c[expr.operands[0]].kind == ast::ExprKind::generic) {
        const ast::Expr& generic = c[expr.operands[0]];
        if (generic.operands.size() == 2 && c[generic.operands[0]].kind == ast::ExprKind::name)
            return MemoryText{c[generic.operands[0]].name, c[generic.operands[0]].span, generic.operands[1],
                              expr.operands[1], count == 3 ? expr.operands[2] : ast::ExprId{}};
    }
    if (expr.kind != ast::ExprKind::error) note(c.error(Diag::memory_form, expr.span), expr.span, memory_remedy);
    return std::nullopt;
}

/// Whether the type is the name of a generic parameter. An error in the argument for it is reported where the argument
/// is given.
bool is_generic_name(const Body& body, ast::ExprId type) {
    const ast::Expr& expr = body.context[type];
    return expr.kind == ast::ExprKind::name && body.env.find(expr.name) != nullptr;
}

ir::Compare comparison(Context& c, const ast::Item& item) {
    const auto found = ir::spelled(c.text(item.compare), ir::Compare::greater_equal);
    if (!found)
        note(c.error(Diag::memory_compare, item.compare_span, {c.text(item.compare)}), item.compare_span,
             "a reference is 'less', 'less_equal', 'greater' or 'greater_equal' than a texel");
    return found.value_or(ir::Compare::less_equal);
}

/// Whether the memory is declared with `apart(true)`, and its elements are structs: of others it keeps one buffer.
bool is_kept_apart(Body& body, const ast::Item& item, ir::TypeId element) {
    Context& c = body.context;
    const auto condition = constant_of(c, body.env, item.apart, c.types().bool_);
    return condition && condition->bits() && c.types().kind(element) == ir::TypeKind::struct_;
}

/// Adds a buffer for each field that is no struct, at any depth. `declared`, the name in the source, is the first
/// one's.
void add_apart(Body& body, ir::StructureId index, const ir::Memory& like, const std::vector<std::uint32_t>& path,
               ir::TypeId type, const std::string& name, Name& declared) {
    Context& c = body.context;
    if (c.types().kind(type) == ir::TypeKind::struct_) {
        const std::vector<ir::StructField> fields = c.program.structs[c.types()[type].struct_].fields;
        for (std::uint32_t i = 0; i < fields.size(); ++i) {
            std::vector<std::uint32_t> longer = path;
            longer.push_back(i);
            add_apart(body, index, like, longer, fields[i].type, name + "_" + c.text(fields[i].name), declared);
        }
        return;
    }
    ir::Memory memory = like;
    memory.name = c.names.intern(name);
    memory.fields = path;
    memory.declared = std::exchange(declared, {});
    memory.element = type;
    declare_memory(body, index, memory);
}

// long: all checks of one declaration
void add_memory(Body& body, ir::StructureId index, const ast::Item& item) {
    Context& c = body.context;
    if (has_memory(body, index, item)) return;
    if (is_image_part(body, item.value)) return add_image_part(body, index, item);
    if (is_structure_memory(body, item.value)) return add_base(body, index, item);
    auto text = read_memory(c, item.value);
    if (!text) return;
    Meta shape = find_meta(c, body.env, {text->shape, text->shape_span});
    if (shape.kind != MetaKind::memory_shape) {
        note(c.error(Diag::memory_form, text->shape_span), text->shape_span, memory_remedy);
        return;
    }
    if (text->layers && shape.shape != ir::MemoryShape::image2d) {
        note(c.error(Diag::memory_form, c[text->layers].span), c[text->layers].span,
             "layers are those of a 2-D image: image2d<F>(extent, layers)");
        return;
    }
    bool is_apart = false;
    ir::Memory memory;
    memory.name = item.name.name;
    memory.shape = shape.shape;
    memory.span = item.name.span;
    if (memory.shape == ir::MemoryShape::buffer && (item.filter || item.compare || item.mips)) {
        const char* what = item.mips ? "mip levels" : item.filter ? "filter" : "comparison";
        note(c.error(Diag::image_option, item.name.span, {what}), item.name.span, "images have: image2d<F>(extent)");
        return;
    }
    memory.linear = item.filter && c.text(item.filter) == "linear";
    if (item.filter && !memory.linear && c.text(item.filter) != "nearest")
        c.error(Diag::memory_option, item.filter_span, {c.text(item.filter)});
    if (item.compare) memory.compare = comparison(c, item);
    Meta element = meta_of(c, body.env, text->element);
    if (element.kind == MetaKind::none) return;
    if (memory.shape == ir::MemoryShape::buffer) {
        bool storable = element.kind == MetaKind::type && c.types().kind(element.type) != ir::TypeKind::structure;
        if (!storable) {
            c.error(Diag::memory_element, c[text->element].span);
            return;
        }
        if (ir::holds_empty(c.program, element.type)) {
            note(c.error(Diag::memory_element, c[text->element].span), c[text->element].span,
                 "memory cannot hold a struct without fields");
            return;
        }
        if (holds_optional(c.program, element.type)) {
            const Span span = is_generic_name(body, text->element) && !c.requests.empty() ? c.requests.back().span
                                                                                          : c[text->element].span;
            note(c.error(Diag::memory_optional, span, {c.text(element.type)}), span,
                 "use a struct of 'present: bool;' and the value");
            return;
        }
        memory.element = element.type;
        is_apart = item.apart && is_kept_apart(body, item, element.type);
    } else {
        if (item.apart)
            note(c.error(Diag::memory_form, item.name.span), c[item.apart].span,
                 "'apart' is for the fields of structs in a buffer: images hold no structs");
        memory.format = element.kind == MetaKind::format ? element.format
                        : element.kind == MetaKind::type ? format_of(c.types(), element.type)
                                                         : ir::Format::none;
        if (memory.format == ir::Format::none) {
            note(c.error(Diag::memory_element, c[text->element].span), c[text->element].span,
                 "images hold a texel format (r8, rgba8, r16f, r32f …) or one, two or four floats, ints or uints");
            return;
        }
        memory.element = value_of_format(c.types(), memory.format);
    }
    const bool is_cube = memory.shape == ir::MemoryShape::imagecube;
    memory.extent = check_value(body, text->extent, is_cube ? c.types().uint : address_type(c.types(), memory.shape));
    if (is_cube)
        memory.extent = add(c.program, ir::Op::construct, c.types().vector(c.types().uint, 3), memory.span,
                            {memory.extent, memory.extent, make_uint(c.program, 6, memory.span)});
    if (text->layers) {
        memory.shape = ir::MemoryShape::image2darray;
        const ir::ExprId layers = check_value(body, text->layers, c.types().uint);
        memory.extent = add(c.program, ir::Op::construct, c.types().vector(c.types().uint, 3), memory.span,
                            {memory.extent, layers});
    }
    if (item.mips) memory.mips = check_value(body, item.mips, c.types().uint);
    if (!is_apart) return declare_memory(body, index, memory);
    body.program().structures[index].apart = memory.element;
    Name declared = memory.name;
    add_apart(body, index, memory, {}, memory.element, c.text(memory.name), declared);
}

void declare_member(Body& body, ir::StructureId index, std::uint32_t member, ast::Identifier name) {
    Symbol symbol;
    symbol.kind = SymbolKind::structure;
    symbol.structure = body.context.program.structures[index].members[member].structure;
    symbol.place.members = {member};
    declare(body, name, symbol);
}

/// Checks the arguments of the member's constructor, and sorts them into values and structures.
void give_arguments(Body& body, const ast::Expr& call, ir::MemberStructure& member) {
    Context& c = body.context;
    const std::vector<ast::Param>& params = *constructor_of(c[c.structure_decl.at(member.structure)]);
    const Env& env = *c.structure_env.at(member.structure);
    for (std::size_t i = 0; i + 1 < call.operands.size(); ++i) {
        const ir::TypeId wanted = type_of(c, env, params[i].type);
        const ir::ExprId value = check_value(body, call.operands[i + 1], wanted);
        if (c.types().kind(wanted) != ir::TypeKind::structure) member.arguments.push_back(value);
        else member.structures.push_back(c.program.exprs[value].place);
    }
    for (ir::ExprId omitted :
         omitted_arguments(body, member.structure, {member.arguments.begin(), member.arguments.end()}))
        member.arguments.push_back(omitted);
}

}  // namespace

bool add_member(Body& body, ir::StructureId index, const ast::Item& item) {
    Context& c = body.context;
    const ast::Expr& call = c[item.value];
    if (call.kind != ast::ExprKind::call) {
        if (call.kind != ast::ExprKind::error) c.error(Diag::member_form, call.span);
        return false;
    }
    const Meta made = constructed_type(body, call);
    ir::TypeId type = made.kind == MetaKind::type ? made.type : c.types().error;
    if (made.kind != MetaKind::type && made.kind != MetaKind::none) c.error(Diag::not_a_type, c[call.operands[0]].span);
    if (type != c.types().error && c.types().kind(type) != ir::TypeKind::structure) {
        c.error(Diag::member_form, call.span);
        type = c.types().error;
    }
    if (type == c.types().error) {  // declared in spite of the error, so that its uses report none
        declare_local(body, item.name, type, false, false);
        return false;
    }
    ir::MemberStructure member;
    member.name = item.name.name;
    member.span = item.name.span;
    member.structure = c.types()[type].structure;
    if (has_argument_count(c, member.structure, call)) give_arguments(body, call, member);
    c.program.structures[index].members.push_back(std::move(member));
    declare_member(body, index, static_cast<std::uint32_t>(c.program.structures[index].members.size() - 1), item.name);
    return true;
}

namespace {

// ------------------------------------------------------------------------------------------------------------- via

/// The translators of `Name<…>(arguments)`; generic arguments are inferred from the arguments and the type of the
/// incoming address. Empty after an error.
std::vector<ir::TranslatorId> stage_translators(Body& body, const ast::Expr& call,
                                                const std::vector<Operand>& arguments, ir::TypeId incoming) {
    Context& c = body.context;
    const ast::Expr& callee = c[call.operands[0]];
    const ast::Expr& name = callee.kind == ast::ExprKind::generic ? c[callee.operands[0]] : callee;
    Meta meta = name.kind == ast::ExprKind::name ? find_meta(c, body.env, {name.name, name.span}) : Meta{};
    bool declared =
        meta.kind == MetaKind::declarations && std::holds_alternative<ast::Translator>(c[meta.declarations[0]].body);
    if (!declared) {
        Meta whole = meta_of(c, body.env, call.operands[0]);
        if (whole.kind == MetaKind::translator) return whole.translators;
        if (whole.kind != MetaKind::none) c.error(Diag::not_a_translator, callee.span);
        return {};
    }
    ast::DeclId id = meta.declarations[0];
    const auto& written = std::get<ast::Translator>(c[id].body);
    Env& env = c.new_env(c.module_of.at(id));
    Arguments generics(c, c[id], env, callee.span);
    std::vector<ast::ExprId> explicit_generics;
    if (callee.kind == ast::ExprKind::generic)
        explicit_generics.assign(callee.operands.begin() + 1, callee.operands.end());
    if (!generics.give(body.env, explicit_generics)) return {};
    for (std::size_t i = 0; i < arguments.size() && i < written.fields.size(); ++i) {
        if (arguments[i].kind == OperandKind::structure)
            generics.infer_structure(written.fields[i].type, arguments[i].structure);
        if (arguments[i].kind == OperandKind::value) generics.infer(written.fields[i].type, arguments[i].type);
    }
    if (incoming) generics.infer(written.virtual_type, incoming);
    if (!generics.finish()) return {};
    if (const ir::TranslatorId made = instantiate_translator(c, id, env, callee.span)) return {made};
    return {};
}

/// Assigns the arguments to the fields of the translators, in the order in which the fields are declared. False after
/// an error.
bool fill_stages(Body& body, const ast::Expr& call, const std::vector<Operand>& arguments,
                 const std::vector<ir::TranslatorId>& translators, std::vector<ir::Stage>& stages) {
    Context& c = body.context;
    std::size_t next = 0, wanted = 0;
    for (ir::TranslatorId t : translators)
        wanted += c.program.translators[t].scalars.size() + c.program.translators[t].structures.size();
    if (wanted != arguments.size()) {
        c.error(
            Diag::argument_count, call.span,
            {c.program.translators[translators[0]].display, std::to_string(wanted), std::to_string(arguments.size())});
        return false;
    }
    for (ir::TranslatorId t : translators) {
        ir::Stage stage;
        stage.translator = t;
        const auto& fields = std::get<ast::Translator>(c[c.translator_decl.at(t)].body).fields;
        const Env& env = *c.translator_env.at(t);
        for (const ast::Field& field : fields) {
            if (next == arguments.size()) break;  // a field is declared twice, which collect_modules has reported
            const Operand& argument = arguments[next];
            ast::ExprId written = call.operands[1 + next++];
            ir::TypeId type = type_of(c, env, field.type);
            if (c.types().kind(type) == ir::TypeKind::structure) {
                if (argument.kind != OperandKind::structure || argument.structure != c.types()[type].structure) {
                    c.error(Diag::type_mismatch, c[written].span, {c.text(type), "something else"});
                    return false;
                }
                stage.structures.push_back(argument.place);
                continue;
            }
            ir::ExprId value = argument.kind == OperandKind::error
                                   ? check_value(body, written, type)
                                   : coerce(body, to_value(body, argument), type, c[written].span);
            if (is_error(body, value)) return false;
            stage.scalars.push_back(value);
        }
        stages.push_back(std::move(stage));
    }
    return true;
}

void flatten_then(Context& c, ast::ExprId id, std::vector<ast::ExprId>& stages) {
    const ast::Expr& expr = c[id];
    if (expr.kind == ast::ExprKind::binary && expr.binary == ast::BinaryOp::then) {
        flatten_then(c, expr.operands[0], stages);
        flatten_then(c, expr.operands[1], stages);
    } else {
        stages.push_back(id);
    }
}

void add_via(Body& body, ir::StructureId index, const ast::Item& item) {
    Context& c = body.context;
    if (!c.program.structures[index].via.empty()) {
        c.error(Diag::duplicate_via, item.span);
        return;
    }
    std::vector<ast::ExprId> written;
    flatten_then(c, item.value, written);
    std::vector<ir::Stage> stages;
    ir::TypeId incoming;
    for (ast::ExprId id : written) {
        const ast::Expr& call = c[id];
        if (call.kind != ast::ExprKind::call) {
            if (call.kind != ast::ExprKind::error) c.error(Diag::via_form, call.span);
            return;
        }
        std::vector<Operand> arguments;
        for (std::size_t i = 1; i < call.operands.size(); ++i)
            arguments.push_back(is_flexible(c, call.operands[i]) ? error_operand(c[call.operands[i]].span)
                                                                 : check(body, call.operands[i]));
        for (std::size_t i = 0; i < arguments.size(); ++i)
            if (arguments[i].kind == OperandKind::error && !is_flexible(c, call.operands[i + 1])) return;
        auto translators = stage_translators(body, call, arguments, incoming);
        if (translators.empty() || !fill_stages(body, call, arguments, translators, stages)) return;
        ir::TypeId takes = c.program.translators[translators.front()].virtual_type;
        if (incoming && incoming != takes) {
            c.error(Diag::via_mismatch, call.span, {c.text(incoming), c.text(takes)});
            return;
        }
        for (std::size_t i = 1; i < translators.size(); ++i) {
            ir::TypeId gives = c.program.translators[translators[i - 1]].physical_type,
                       next = c.program.translators[translators[i]].virtual_type;
            if (gives != next) {
                c.error(Diag::via_mismatch, call.span, {c.text(gives), c.text(next)});
                return;
            }
        }
        incoming = c.program.translators[translators.back()].physical_type;
    }
    c.program.structures[index].via = std::move(stages);
}

// ---------------------------------------------------------------------------------------------------------- finish

ir::ExprId domain_from_item(Body& body, const ast::Item& item, ir::TypeId wanted) {
    Context& c = body.context;
    const auto& function = std::get<ast::Function>(c[item.decl].body);
    bool single =
        function.body.size() == 1 && c[function.body[0]].kind == ast::StmtKind::return_ && c[function.body[0]].value;
    if (!single) {
        c.error(Diag::domain_form, c[item.decl].name.span);
        return {};
    }
    check_fixed_type(c, body.env, function.result, wanted);
    return check_value(body, c[function.body[0]].value, wanted);
}

/// What domain() of the first translator returns, with the arguments that `via` gives the translator in place of its
/// state. Absent if it has no domain(), and after an error.
ir::ExprId domain_from_translator(Context& c, const ir::Structure& structure) {
    const ir::Translator& translator = c.program.translators[structure.via[0].translator];
    if (!translator.domain) return {};
    ir::ExprId value = single_return(c.program, translator.domain);
    if (!value) {
        c.error(Diag::domain_form, c.program.functions[translator.domain].span);
        return {};
    }
    return substitute_state(c, value, structure.via[0]);
}

/// The extent of the structure's domain: from its own domain(); else, if it has `via`, from its first translator,
/// absent if that has none; else from the structure that is its memory.
ir::ExprId domain_of(Body& body, ir::StructureId index, const ast::Item* declared) {
    Context& c = body.context;
    const ir::Structure structure = c.program.structures[index];
    if (declared) return domain_from_item(body, *declared, structure.domain_type);
    if (!structure.via.empty()) return domain_from_translator(c, structure);
    return domain_of_base(body, index);
}

/// Whether `via`, if there is one, ends with the address type of the memory; reports if not. Sets the address type of
/// the structure: that of its first translator, or of its memory.
bool check_addresses(Context& c, ir::StructureId index) {
    ir::Structure& structure = c.program.structures[index];
    const bool has_base = !structure.base.empty();
    const ir::TypeId takes =
        has_base ? ir::physical_type(c.program, structure) : address_type(c.types(), structure.memories[0].shape);
    structure.domain_type = takes;
    if (structure.via.empty()) return true;
    const ir::TypeId gives = c.program.translators[structure.via.back().translator].physical_type;
    structure.domain_type = c.program.translators[structure.via.front().translator].virtual_type;
    if (gives == takes) return true;
    const Span memory = has_base ? structure.base_span : structure.memories[0].span;
    note(c.error(Diag::via_mismatch, structure.span, {c.text(gives), c.text(takes)}), memory,
         "this memory is addressed by " + c.text(takes));
    return false;
}

/// The type of the elements in a structure's own memory; of buffers for single fields, the struct that has the fields.
ir::TypeId element_of(const ir::Structure& structure) {
    return structure.apart ? structure.apart : structure.memories[0].element;
}

void finish_structure(Body& body, ir::StructureId index, const ast::Item* domain, const ast::Item* otherwise) {
    Context& c = body.context;
    Span at = c.program.structures[index].span;
    const std::string display = c.program.structures[index].display;
    const bool has_base = !c.program.structures[index].base.empty();
    if (!has_base && c.program.structures[index].memories.empty()) {
        c.error(Diag::no_memory, at, {display});
        return;
    }
    if (!has_base && c.program.structures[index].via.empty()) {
        note(c.error(Diag::no_via, at, {display}), at, "write 'via Translator(…);'");
        return;
    }
    if (!check_addresses(c, index) || !check_own_memory(c, index)) return;
    ir::Structure& structure = c.program.structures[index];
    const ir::TypeId element =
        has_base ? ir::structure_at(c.program, structure, structure.base).element : element_of(structure);
    structure.element = element;
    if (ir::is_computed(c.program, structure)) structure.kind = ir::StructureKind::computed, structure.copyable = false;
    ir::ExprId extent = domain_of(body, index, domain);
    if (!extent && !c.diagnostics.has_own_errors())
        note(c.error(Diag::no_domain, at, {display}), at,
             "write 'domain() { return …; }' in its first translator or in the structure");
    c.program.structures[index].domain = extent;
    if (otherwise) {
        ir::ExprId value = check_value(body, otherwise->value, element);
        c.program.structures[index].otherwise = value;
    }
}

ir::StructureId begin_structure(Context& c, ast::DeclId id, const Env& env, ir::StructureKind kind) {
    const ast::Decl& decl = c[id];
    ir::Structure structure;
    structure.kind = kind;
    structure.name = decl.name.name;
    structure.display = display_of(c, decl, env);
    structure.key = qualified_display_of(c, id, env);
    structure.span = decl.name.span;
    structure.module = c.module_of.at(id);
    structure.doc = decl.doc;
    structure.domain_type = structure.element = c.types().void_;
    if (decl.is_pub && decl.generics.empty() && c.modules[structure.module].is_root)
        structure.aliases.push_back({decl.name.name, structure.module, true});
    const ir::StructureId index = c.program.structures.add(std::move(structure));
    c.structure_env[index] = &env;
    c.structure_decl[index] = id;
    for (const auto& [name, meta] : env.bindings) c.arguments_of[index].push_back(meta);
    return index;
}

ir::FunctionId make_at(Context& c, ast::DeclId id, const Env& env, ir::StructureId index) {
    const ast::Decl& decl = c[id];
    const auto& written = std::get<ast::Function>(decl.body);
    const ir::Structure view = c.program.structures[index];
    if (written.params.size() != 1) {
        c.error(Diag::method_params, decl.name.span, {"at", "1"});
        return {};
    }
    std::size_t errors = c.diagnostics.own_error_count();
    ir::Function function;
    function.name = decl.name.name;
    function.display = view.display + ".at";
    function.span = decl.name.span;
    function.module = c.module_of.at(id);
    function.structures = {index};
    function.result = view.element;
    Body body{.context = c, .env = env, .kind = BodyKind::function, .block = &function.body, .result = view.element};
    bring_members_into_scope(body, index);
    open_scope(body);
    check_fixed_type(c, env, written.params[0].type, view.domain_type);
    check_fixed_type(c, env, written.result, view.element);
    function.params.push_back(declare_local(body, written.params[0].name, view.domain_type, false, false));
    check_block(body, written.body);
    close_scope(body);
    if (c.diagnostics.own_error_count() == errors && !always_returns(c.program, function.body))
        c.error(Diag::missing_return, decl.name.span, {"at", c.text(view.element)});
    return c.program.functions.add(std::move(function));
}

}  // namespace

static void declare_argument(Body& body, ast::Identifier name, std::uint32_t slot, ir::TypeId type) {
    Symbol symbol;
    symbol.kind = SymbolKind::member;
    symbol.slot = slot;
    symbol.type = type;
    declare(body, name, symbol);
}

void add_constructor(Context& c, const Env& env, const std::vector<ast::Param>& params, ir::Structure& structure) {
    Body earlier{.context = c, .env = env, .kind = BodyKind::structure};
    for (const ast::Param& param : params) {
        ir::TypeId type = type_of(c, env, param);
        const ir::ExprId default_value = default_of(earlier, param, type);
        const Span span = param.type ? c[param.type].span : param.name.span;
        if (is_refused_optional(c, type, "a constructor's argument", span)) type = c.types().error;
        if (c.types().kind(type) == ir::TypeKind::structure) {
            ir::MemberStructure member;
            member.name = param.name.name;
            member.structure = c.types()[type].structure;
            member.by_reference = true;
            member.span = param.name.span;
            structure.members.push_back(std::move(member));
        } else {
            declare_argument(earlier, param.name, static_cast<std::uint32_t>(structure.constructor.size()), type);
            structure.constructor.push_back(add_local(c.program, param.name.name, type, param.name.span));
            structure.defaults.push_back(default_value);
        }
    }
}

void bring_members_into_scope(Body& body, ir::StructureId index) {
    Context& c = body.context;
    body.container = index;
    const ir::Structure structure = c.program.structures[index];
    for (std::uint32_t i = 0; i < structure.constructor.size(); ++i) {
        const ir::Local& local = c.program.locals[structure.constructor[i]];
        declare_argument(body, {local.name, local.span}, i, local.type);
    }
    for (std::uint32_t i = 0; i < structure.members.size(); ++i)
        declare_member(body, index, i, {structure.members[i].name, structure.members[i].span});
    declare_base(body, index);
    for (std::uint32_t i = 0; i < structure.memories.size(); ++i) {
        if (!structure.memories[i].declared) continue;
        Symbol symbol;
        symbol.kind = SymbolKind::memory;
        symbol.structure = index;
        symbol.slot = i;
        declare(body, {structure.memories[i].declared, structure.memories[i].span}, symbol);
    }
    for (std::uint32_t i = 0; i < structure.host.size(); ++i) {
        Symbol symbol;
        symbol.kind = SymbolKind::host_state;
        symbol.slot = i;
        symbol.type = structure.host[i].type;
        declare(body, {structure.host[i].name, structure.host[i].span}, symbol);
    }
}

namespace {

/// What the items of a structure's declaration say together, besides what each adds by itself.
struct Declared {
    const ast::Item *domain = nullptr, *otherwise = nullptr;
    ast::DeclId at;
    BlockItems blocks;
    bool has_via = false;
};

/// Kinds of structures: with a memory, with elements that `at` computes (their types are written after the
/// constructor), and without elements of its own.
ir::StructureKind kind_of(Context& c, const Env& env, const ast::Structure& written) {
    if (written.virtual_type) return ir::StructureKind::computed;
    bool is_stored = false;
    for_each_item(c, env, written.items, [&](const ast::Item& item) {
        is_stored = is_stored || item.kind == ast::ItemKind::memory || item.kind == ast::ItemKind::via ||
                    item.kind == ast::ItemKind::otherwise;
    });
    return is_stored ? ir::StructureKind::stored : ir::StructureKind::no_elements;
}

/// Whether copies of the structure share more than memory: it has host state, or pipelines, which may replace members.
bool is_container(Context& c, const Env& env, const ast::Structure& written, ir::StructureKind kind) {
    bool holds = kind == ir::StructureKind::no_elements;
    for_each_item(c, env, written.items, [&](const ast::Item& item) {
        holds = holds || item.kind == ast::ItemKind::host || item.kind == ast::ItemKind::pipeline;
    });
    return holds;
}

void add_host_state(Body& body, ir::StructureId index, const ast::Item& item) {
    Context& c = body.context;
    ir::TypeId type = type_of(c, body.env, item.type);
    if (is_refused_optional(c, type, "host state", c[item.type].span)) type = c.types().error;
    const ir::ExprId initial = item.value ? check_value(body, item.value, type) : ir::ExprId{};
    c.program.structures[index].host.push_back({item.name.name, item.name.span, type, initial});
}

/// Notes a function that the language knows by its name; others are checked where they are called.
void note_function(Body& body, ir::StructureId index, const ast::Item& item, Declared& declared) {
    Context& c = body.context;
    const ir::StructureKind kind = c.program.structures[index].kind;
    const std::string name = c.text(c[item.decl].name.name);
    if (kind == ir::StructureKind::no_elements) return;
    if (name == "domain") {
        if (declared.domain) c.error(Diag::duplicate_name, c[item.decl].name.span, {name});
        declared.domain = &item;
    }
    if (name == "at" && kind == ir::StructureKind::computed) {
        if (declared.at) c.error(Diag::duplicate_name, c[item.decl].name.span, {name});
        declared.at = item.decl;
    }
    declared.blocks.note(c, item.decl);
}

void add_item(Body& body, ir::StructureId index, const ast::Item& item, Declared& declared) {
    Context& c = body.context;
    const bool is_computed = c.program.structures[index].kind == ir::StructureKind::computed;
    switch (item.kind) {
    case ast::ItemKind::memory:
    case ast::ItemKind::via:
    case ast::ItemKind::otherwise:
        if (is_computed) {
            c.error(Diag::item_not_here, item.span, {"a structure that computes its elements"});
            break;
        }
        if (item.kind == ast::ItemKind::memory) add_memory(body, index, item);
        if (item.kind == ast::ItemKind::via) add_via(body, index, item);
        declared.has_via = declared.has_via || item.kind == ast::ItemKind::via;
        if (item.kind != ast::ItemKind::otherwise) break;
        if (declared.otherwise) c.error(Diag::duplicate_name, item.span, {"otherwise"});
        declared.otherwise = &item;
        break;
    case ast::ItemKind::member: add_member(body, index, item); break;
    case ast::ItemKind::host: add_host_state(body, index, item); break;
    case ast::ItemKind::function: note_function(body, index, item, declared); break;
    case ast::ItemKind::pipeline:
    case ast::ItemKind::condition: break;
    }
}

/// Sets the types of addresses and elements that are written after the constructor.
void set_types(Context& c, const Env& env, const ast::Structure& written, ir::StructureId index) {
    ir::TypeId domain = type_of(c, env, written.virtual_type), element = type_of(c, env, written.element_type);
    if (is_refused_optional(c, element, "a computed element", c[written.element_type].span)) element = c.types().error;
    const bool is_known = domain == c.types().error || is_address(c.types(), domain);
    if (!is_known) c.error(Diag::address_type, c[written.virtual_type].span, {c.text(domain)});
    c.program.structures[index].domain_type = domain;
    c.program.structures[index].element = element;
}

/// Checks `at` and `domain` of a structure that computes its elements.
void finish_computed(Body& body, ir::StructureId index, const Declared& declared) {
    Context& c = body.context;
    const Span name = c.program.structures[index].span;
    if (!declared.at) {
        c.error(Diag::view_without_at, name, {c.text(c.program.structures[index].name)});
        return;
    }
    if (declared.domain) {
        const ir::ExprId extent = domain_from_item(body, *declared.domain, c.program.structures[index].domain_type);
        c.program.structures[index].domain = extent;
    }
    const ir::FunctionId function = make_at(c, declared.at, body.env, index);
    c.program.structures[index].at = function;
}

}  // namespace

ir::TypeId make_structure(Context& c, ast::DeclId id, const Env& env) {
    const auto& written = std::get<ast::Structure>(c[id].body);
    std::size_t errors = c.diagnostics.own_error_count();
    const ir::StructureKind kind = kind_of(c, env, written);
    ir::StructureId index = begin_structure(c, id, env, kind);
    {
        ir::Structure started = c.program.structures[index];
        started.copyable = kind == ir::StructureKind::stored;
        started.is_container = is_container(c, env, written, kind);
        add_constructor(c, env, written.constructor, started);
        c.program.structures[index] = std::move(started);
    }
    if (kind == ir::StructureKind::computed) set_types(c, env, written, index);
    Body body{.context = c, .env = env, .kind = BodyKind::structure};
    bring_members_into_scope(body, index);
    Declared declared;
    for_each_item(c, env, written.items, [&](const ast::Item& item) { add_item(body, index, item, declared); });
    // `via` has an error. If it lies in a translator, it may have been reported for an earlier structure: then
    // own_error_count() still equals `errors`.
    if (declared.has_via && c.program.structures[index].via.empty()) return c.types().error;
    const auto is_right = [&] { return c.diagnostics.own_error_count() == errors; };
    if (is_right() && kind == ir::StructureKind::computed) finish_computed(body, index, declared);
    if (is_right() && kind == ir::StructureKind::stored)
        finish_structure(body, index, declared.domain, declared.otherwise);
    if (is_right() && kind != ir::StructureKind::no_elements) add_blocks(c, env, index, declared.blocks);
    return is_right() ? c.types().of_structure(index) : c.types().error;
}

}  // namespace gliftc::sema
