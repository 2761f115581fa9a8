// long: what a name called means decides between cases that call each other
// Calls: of functions, types (construction), methods and built-ins.
#include "ir/chain.h"
#include "sema/bodies/applied.h"
#include "sema/bodies/order.h"
#include "sema/kernels/raster.h"
#include "sema/kernels/texture.h"
#include "sema/names/lookup.h"
#include "sema/names/record.h"
#include "sema/names/unknown_names.h"
#include "sema/pipelines/values.h"
#include "sema/structures/blocks.h"
#include "sema/structures/constructors.h"
#include "sema/structures/image_parts.h"
#include "sema/types/typing.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

Operand call_type(Body& body, ir::TypeId type, const ast::Expr& call) {
    if (body.types().kind(type) == ir::TypeKind::structure) return construct_structure(body, type, call);
    return construct_value(body, type, call);
}

/// The index, count or size of workgroups, subgroups or their invocations that the built-in function of this name
/// gives; absent if there is none. Only kernels and functions with `group` may call such functions.
std::optional<ir::Invocation> find_invocation(std::string_view name) {
    if (name == "local_index") return ir::Invocation::local_index;
    if (name == "group_index") return ir::Invocation::group_index;
    if (name == "group_count") return ir::Invocation::group_count;
    if (name == "group_size") return ir::Invocation::group_size;
    if (name == "subgroup_size") return ir::Invocation::subgroup_size;
    if (name == "subgroup_lane") return ir::Invocation::subgroup_lane;
    if (name == "subgroup_count") return ir::Invocation::subgroup_count;
    if (name == "subgroup_index") return ir::Invocation::subgroup_index;
    return std::nullopt;
}

std::vector<ast::ExprId> arguments_of(const ast::Expr& call) {
    return {call.operands.begin() + 1, call.operands.end()};
}

/// A call of a function that is built into the language; absent if none of that name is known in this kind of body.
std::optional<Operand> call_builtin(Body& body, const std::string& name, const ast::Expr& call, ir::TypeId wanted) {
    if (name == "select") return call_select(body, call, wanted);
    if (auto called = call_in_raster(body, name, call)) return called;
    if (name == "position" && body.kernel) {
        if (!arguments_of(call).empty())
            body.context.error(Diag::argument_count, call.span, {name, "0", std::to_string(call.operands.size() - 1)});
        if (!body.kernel->domain_type) return error_operand(call.span);  // no valid `each` or `at` parameter: reported
        return value_operand(body, add(body.program(), ir::Op::position, body.kernel->domain_type, call.span),
                             call.span);
    }
    if (auto invocation = find_invocation(name)) {
        if (!body.grouped()) {
            note(body.context.error(Diag::needs_group, call.span, {name}), call.span,
                 "write 'group(size)' after the kernel's parameters");
            return error_operand(call.span);
        }
        ir::ExprId id = add(body.program(), ir::Op::invocation, body.types().uint, call.span);
        body.program().exprs[id].invocation = *invocation;
        return value_operand(body, id, call.span);
    }
    if (auto intrinsic = find_intrinsic(name))
        return call_intrinsic(body, *intrinsic, arguments_of(call), call, wanted);
    if (body.kind == BodyKind::pipeline || body.kind == BodyKind::structure)
        return check_pipeline_builtin(body, name, call);
    return std::nullopt;
}

Operand call_declarations(Body& body, const Meta& meta, const std::vector<ast::ExprId>& generics, const ast::Expr& call,
                          ir::TypeId wanted) {
    Context& c = body.context;
    const auto& first = c[meta.declarations[0]].body;
    if (std::holds_alternative<ast::Function>(first))
        return call_function(body, meta.declarations, nullptr, generics, arguments_of(call), call, wanted);
    if (std::holds_alternative<ast::Kernel>(first) || std::holds_alternative<ast::Pipeline>(first)) {
        if (auto result = check_pipeline_call(body, meta.declarations, generics, call)) return *result;
        return error_operand(call.span);
    }
    const Meta type = constructed_type(body, call);
    if (type.kind == MetaKind::type) return call_type(body, type.type, call);
    if (type.kind != MetaKind::none)
        c.error(Diag::not_callable, c[call.operands[0]].span, {"'" + c.text(c[meta.declarations[0]].name.name) + "'"});
    return error_operand(call.span);
}

}  // namespace

/// For each argument that constructs an array or a struct, the index of its element or field; reports a field that has
/// none.
static std::optional<std::vector<std::size_t>> written_order(Body& body, ir::TypeId id, const ast::Expr& call,
                                                             std::size_t count) {
    const ir::Type& type = body.types()[id];
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t at = i;
        if (!call.labels.empty() && type.kind == ir::TypeKind::struct_) {
            const ir::StructField& field = body.program().structs[type.struct_].fields[i];
            at = static_cast<std::size_t>(std::ranges::find(call.labels, field.name, &ast::Identifier::name) -
                                          call.labels.begin());
            Context& c = body.context;
            if (at == call.labels.size()) {
                c.error(Diag::missing_field, call.span, {c.text(field.name), c.text(id)});
                return std::nullopt;
            }
            record_field(c, call.labels[at].span, type.struct_, i);
        }
        order[at] = i;
    }
    return order;
}

// long: a case for each kind of type
Operand construct_value(Body& body, ir::TypeId id, const ast::Expr& call) {
    Context& c = body.context;
    ir::Types& types = body.types();
    const ir::Type type = types[id];
    bool is_tuple = call.kind == ast::ExprKind::tuple;
    std::vector<ast::ExprId> written = is_tuple ? call.operands : arguments_of(call);
    if (!is_tuple && written.empty() && type.kind != ir::TypeKind::enum_ && id != types.error)
        return value_operand(body, ir::zero(body.program(), id, call.span), call.span);
    const Parts parts(body);
    ir::Operands operands;
    if (type.kind == ir::TypeKind::struct_ || type.kind == ir::TypeKind::array) {
        std::vector<ir::TypeId> parts;
        if (type.kind == ir::TypeKind::array) parts.assign(type.count, type.element);
        else
            for (const auto& field : body.program().structs[type.struct_].fields) parts.push_back(field.type);
        if (parts.size() != written.size()) {
            c.error(Diag::argument_count, call.span,
                    {c.text(id), std::to_string(parts.size()), std::to_string(written.size())});
            return error_operand(call.span);
        }
        const auto fields = written_order(body, id, call, parts.size());
        if (!fields) return error_operand(call.span);
        operands.assign(parts.size(), {});
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::size_t field = (*fields)[i];
            operands[field] = check_value(body, written[i], parts[field]);
            if (is_error(body, operands[field])) return error_operand(call.span);
        }
        if (!std::ranges::is_sorted(*fields)) settle(body);
        return value_operand(body, add(body.program(), ir::Op::construct, id, call.span, std::move(operands)),
                             call.span);
    }
    if (!types.is_scalar(id) && !types.is_vector(id) && !types.is_matrix(id)) {
        if (id != types.error) c.error(Diag::not_callable, call.span, {"the type " + c.text(id)});
        return error_operand(call.span);
    }
    ir::TypeId scalar = types.scalar_of(id);
    std::size_t wanted = ir::lane_count(body.program(), id), have = 0;
    for (ast::ExprId argument : written) {
        bool flexible = is_flexible(c, argument);
        // A literal without a suffix takes the constructed scalar type, except that in the construction of a bool it
        // keeps its default type, and that a float literal in the construction of an integer is a float: both are then
        // converted as any value, so that uint(1.5) is 1.
        ir::TypeId hint = flexible ? scalar : ir::TypeId{};
        ir::ExprId value = check_hinted(body, argument, hint == types.bool_ ? ir::TypeId{} : hint);
        if (is_error(body, value)) return error_operand(call.span);
        ir::TypeId from = body.program().exprs[value].type;
        if (types.kind(from) == ir::TypeKind::enum_ && types.is_integer(scalar)) {
            value = add(body.program(), ir::Op::convert, types.uint, call.span, {value});
            from = types.uint;
        }
        if (!types.is_scalar(types.scalar_of(from))) {
            note_optional(body, c.error(Diag::construct_from, c[argument].span, {c.text(id), c.text(from)}),
                          c[argument].span, from);
            return error_operand(call.span);
        }
        have += ir::lane_count(body.program(), from);
        if (types.scalar_of(from) != scalar)
            value = add(body.program(), ir::Op::convert, types.is_matrix(from) ? id : types.with_scalar(from, scalar),
                        c[argument].span, {value});
        operands.push_back(value);
    }
    bool splat = operands.size() == 1 && have == 1;
    if (operands.size() == 1 && body.program().exprs[operands[0]].type == id) {
        ir::ExprId value = operands[0];
        return value_operand(body, value, call.span);
    }
    if (have != wanted && !(splat && types.is_vector(id))) {
        c.error(Diag::component_count, call.span, {c.text(id), std::to_string(wanted), std::to_string(have)});
        return error_operand(call.span);
    }
    return value_operand(body, add(body.program(), ir::Op::construct, id, call.span, std::move(operands)), call.span);
}

/// `let x: T[4] = s.load(a)` and `s.store(a, x)`: consecutive elements along the first axis; `s.load(a, step)` and
/// `s.store(a, step, x)`: rows of four that begin `step` addresses apart.
static Operand several_elements(Body& body, const Operand& self, ast::Identifier method, const ast::Expr& call,
                                ir::TypeId wanted) {
    Context& c = body.context;
    const ir::Structure structure = body.program().structures[self.structure];
    const bool is_load = c.text(method.name) == "load";
    const std::vector<ast::ExprId> arguments = arguments_of(call);
    const std::size_t least = is_load ? 1 : 2;
    if (arguments.size() < least || arguments.size() > least + 1) {
        c.error(Diag::argument_count, call.span,
                {c.text(method.name), is_load ? "1 or 2" : "2 or 3", std::to_string(arguments.size())});
        return error_operand(call.span);
    }
    const bool has_step = arguments.size() == least + 1;
    ir::ExprId address = check_value(body, arguments[0], structure.domain_type);
    ir::ExprId step = has_step ? check_value(body, arguments[1], body.types().uint) : ir::ExprId{};
    ir::ExprId value = is_load ? ir::ExprId{} : check_value(body, arguments.back());
    for (ir::ExprId part : {address, step, value}) {
        if (part && is_error(body, part)) return error_operand(call.span);
    }
    ir::TypeId type = is_load ? wanted : body.program().exprs[value].type;
    if (!type || body.types().kind(type) != ir::TypeKind::array || body.types()[type].element != structure.element) {
        note(c.error(Diag::several_type, call.span, {c.text(structure.element)}), call.span,
             is_load ? "say how many: let x: " + c.text(structure.element) + "[4] = …"
                     : "the elements are passed as one array");
        return error_operand(call.span);
    }
    if (has_step && body.types()[type].count % ir::row_width != 0) {
        c.error(Diag::several_rows, call.span, {std::to_string(body.types()[type].count)});
        return error_operand(call.span);
    }
    if (is_load) {
        ir::ExprId read = make_read(body, self, address, call.span);
        body.program().exprs[read].type = type;
        if (has_step) body.program().exprs[read].operands.push_back(step);
        return value_operand(body, read, call.span);
    }
    if (!self.writing.is(ir::Pattern::scatter) || self.writing.combine != ir::Combine::replace) {
        const ast::Expr& written = c[c[call.operands[0]].operands[0]];
        const bool is_named = written.kind == ast::ExprKind::name;
        Diagnostic& diagnostic =
            c.error(Diag::several_target, call.span, {is_named ? c.text(written.name) : structure.display});
        if (self.writing.span)
            note(diagnostic, self.writing.span, "store writes through 'out scatter<S>' without an operation");
        return error_operand(call.span);
    }
    ir::StmtId id = add(body.program(), ir::StmtOp::write, call.span);
    body.program().stmts[id].place = self.place;
    body.program().stmts[id].target = address;
    body.program().stmts[id].value = value;
    if (has_step) body.program().stmts[id].arguments = {step};
    emit(body, id);
    return value_operand(body, add(body.program(), ir::Op::constant, body.types().void_, call.span), call.span);
}

/// A bool expression: whether the address is in the view's domain. A view has an element at each address of its domain.
static ir::ExprId is_in_view(Body& body, const Operand& view, ir::ExprId address, Span span) {
    ir::Program& p = body.program();
    const ir::TypeId type = p.exprs[address].type;
    const ir::ExprId domain = structure_operation(body, ir::Op::domain, type, view, span);
    const ir::ExprId less =
        add(p, ir::Op::intrinsic, p.types.with_scalar(type, p.types.bool_), span, {address, domain});
    p.exprs[less].intrinsic = ir::Intrinsic::lessThan;
    const ir::ExprId all = add(p, ir::Op::intrinsic, p.types.bool_, span, {less});
    p.exprs[all].intrinsic = ir::Intrinsic::all;
    return all;
}

/// The value of `find`, an optional: the element at the address if the condition `is` holds, else none.
static Operand found_where(Body& body, const Operand& structure, ir::ExprId is, ir::ExprId address, Span span) {
    const ir::TypeId optional = body.types().optional(body.program().structures[structure.structure].element);
    const ir::ExprId some =
        add(body.program(), ir::Op::some, optional, span, {make_read(body, structure, address, span)});
    const ir::ExprId none = add(body.program(), ir::Op::none, optional, span);
    return value_operand(body, add(body.program(), ir::Op::select, optional, span, {is, some, none}), span);
}

/// A function or pipeline of that name that the declaration has inside an `if`, whatever the condition; absent if it
/// has none. `is_inside`: the items are inside an `if` already.
static ast::DeclId conditional_method(const Context& c, const std::vector<ast::Item>& items, Name name,
                                      bool is_inside) {
    for (const ast::Item& item : items) {
        if (is_inside && item.decl && c[item.decl].name.name == name) return item.decl;
        if (ast::DeclId found = conditional_method(c, item.body, name, true)) return found;
        if (ast::DeclId found = conditional_method(c, item.alternative, name, true)) return found;
    }
    return {};
}

/// Whether the structure's memory, if that is a structure, declares a function or pipeline of that name, or the memory
/// of that one, and so on. The structure itself is left out.
static bool has_method_of_base(Context& c, const ir::Structure& structure, Name name) {
    for (const ir::Structure* link = &structure; !link->base.empty();) {
        link = &ir::structure_at(c.program, *link, link->base);
        const auto index = c.program.structures.id_of(*link);
        const auto is_it = [&](const ast::Item* item) { return item->decl && c[item->decl].name.name == name; };
        if (std::ranges::any_of(items_of(c, index), is_it)) return true;
    }
    return false;
}

static ast::Identifier base_name(Body& body, const Operand& self, Span span) {
    return {body.program().structures[self.structure].base_name, span};
}

// long: a case for each method of structures
Operand call_method(Body& body, const Operand& self, ast::Identifier method, const std::vector<ast::ExprId>& generics,
                    const ast::Expr& call, ir::TypeId wanted) {
    Context& c = body.context;
    std::vector<ast::ExprId> arguments = arguments_of(call);
    const std::string& name = c.text(method.name);
    ir::TypeId domain = body.program().structures[self.structure].domain_type;
    auto address = [&](ir::TypeId type) -> ir::ExprId {
        if (arguments.size() == 1) return check_value(body, arguments[0], type);
        c.error(Diag::argument_count, call.span, {name, "1", std::to_string(arguments.size())});
        return error_value(body, call.span);
    };
    // A function that a structure declares comes before the built-in one of its name, such as `find`. But a declared
    // `domain` is evaluated by Op::domain, the `at` of a view by reads of elements, and call_of_blocks() handles
    // `blocks`, `block` and `block_size`: these are not called as functions here. Containers have no such exceptions.
    const std::vector<const ast::Item*> items = items_of(c, self.structure);
    std::vector<ast::DeclId> overloads, pipelines;
    for (const ast::Item* item : items) {
        if (!item->decl || c[item->decl].name.name != method.name) continue;
        (item->kind == ast::ItemKind::pipeline ? pipelines : overloads).push_back(item->decl);
    }
    if (!pipelines.empty()) {
        if (auto result = check_pipeline_call(body, pipelines, generics, call, &self)) return *result;
        return error_operand(call.span);
    }
    const bool addressed = body.program().structures[self.structure].kind != ir::StructureKind::no_elements;
    if (addressed)
        if (auto result = call_of_blocks(body, self, method, call)) return *result;
    const bool is_view = body.program().structures[self.structure].kind == ir::StructureKind::computed;
    const bool is_override = (addressed && name == "domain") || (is_view && name == "at");
    if (!overloads.empty() && !is_override)
        return call_function(body, overloads, c.structure_env.at(self.structure), generics, arguments, call, wanted,
                             &self);
    if (name == "domain" && addressed && arguments.empty())
        return value_operand(body, structure_operation(body, ir::Op::domain, domain, self, call.span), call.span);
    if (addressed)
        if (auto filtered = call_of_texture(body, name, self, arguments, call)) return *filtered;
    if ((name == "load" || name == "store") && addressed) return several_elements(body, self, method, call, wanted);
    const bool translates =
        ir::physical_type(body.program(), body.program().structures[self.structure]) != ir::TypeId{};
    if ((name == "find" || name == "contains") && addressed && !translates) {
        const ir::ExprId at = address(domain);
        if (is_error(body, at)) return error_operand(call.span);
        settle(body);
        const ir::ExprId has = is_in_view(body, self, at, call.span);
        return name == "find" ? found_where(body, self, has, at, call.span) : value_operand(body, has, call.span);
    }
    if ((name == "find" || name == "translate" || name == "contains") && translates) {
        if (body.kind == BodyKind::pipeline) {
            note(c.error(Diag::translation_in_pipeline, method.span, {name}), method.span,
                 "ask in a kernel that takes the structure as any<S>, and write what it finds");
            return error_operand(call.span);
        }
        ir::ExprId at = address(domain);
        if (is_error(body, at)) return error_operand(call.span);
        if (name == "find") settle(body);
        const ir::TypeId physical = ir::physical_type(body.program(), body.program().structures[self.structure]);
        ir::ExprId translated =
            structure_operation(body, ir::Op::translate, body.types().optional(physical), self, call.span, {at});
        if (name == "translate") return value_operand(body, translated, call.span);
        ir::ExprId has = add(body.program(), ir::Op::has_value, body.types().bool_, call.span, {translated});
        if (name == "contains") return value_operand(body, has, call.span);
        return found_where(body, self, has, at, call.span);
    }
    // A function or pipeline that the structure does not declare is looked for in the structure that is its memory.
    if (has_method_of_base(c, body.program().structures[self.structure], method.name))
        return call_method(body, structure_member(body, self, base_name(body, self, method.span)), method, generics,
                           call, wanted);
    std::vector<std::string_view> known = {"domain",    "sample",   "gather", "compare", "find",
                                           "translate", "contains", "load",   "store"};
    for (const ast::Item* item : items)
        if (item->decl) known.push_back(c.text(c[item->decl].name.name));
    Diagnostic& diagnostic =
        c.error(Diag::unknown_member, method.span, {body.program().structures[self.structure].display, name});
    const ast::Decl& declaration = c[c.structure_decl.at(self.structure)];
    if (const ast::DeclId left_out = conditional_method(c, items_of(declaration), method.name, false)) {
        note(diagnostic, c[left_out].name.span,
             "declared here, inside an 'if' that selects it for other arguments of " + c.text(declaration.name.name));
        return error_operand(call.span);
    }
    std::string_view meant = did_you_mean(name, known);
    if (!meant.empty()) note(diagnostic, method.span, "did you mean '" + std::string(meant) + "'?");
    return error_operand(call.span);
}

/// Where a module was called like a function: adds a note with the first six, by name, of its public functions, kernels
/// and pipelines.
static void note_functions(const Context& c, Diagnostic& diagnostic, const Meta& meta, Span span) {
    if (meta.kind != MetaKind::module) return;
    std::vector<std::string> names;
    for (const auto& [name, declarations] : c.scopes[meta.module].names) {
        const ast::Decl& decl = c[declarations[0]];
        const bool is_called = std::holds_alternative<ast::Function>(decl.body) ||
                               std::holds_alternative<ast::Pipeline>(decl.body) ||
                               std::holds_alternative<ast::Kernel>(decl.body);
        if (decl.is_pub && is_called) names.push_back("'" + c.text(name) + "'");
    }
    if (names.empty()) return;
    std::sort(names.begin(), names.end());
    constexpr std::size_t most = 6;
    std::string all;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i) all += (i ? ", " : "") + names[i];
    note(diagnostic, span, "this is a module; it has " + all + (names.size() > most ? ", …" : ""));
}

/// Whether the container itself declares a function or pipeline of that name with this number of parameters.
static bool has_method(Context& c, ir::StructureId container, Name name, std::size_t arguments) {
    return std::ranges::any_of(items_of(c, container), [&](const ast::Item* item) {
        if (!item->decl || c[item->decl].name.name != name) return false;
        const auto* function = std::get_if<ast::Function>(&c[item->decl].body);
        const auto* pipeline = std::get_if<ast::Pipeline>(&c[item->decl].body);
        return (function && function->params.size() == arguments) || (pipeline && pipeline->params.size() == arguments);
    });
}

/// Whether the name means a module, or kernels and pipelines of another module that the body cannot run.
static bool is_uncallable(const Body& body, const Meta& meta) {
    if (meta.kind == MetaKind::module) return true;
    if (meta.kind != MetaKind::declarations || body.kind == BodyKind::pipeline) return false;
    return std::ranges::all_of(meta.declarations, [&](ast::DeclId id) {
        const auto& declared = body.context[id].body;
        return body.context.module_of.at(id) != body.env.module &&
               (std::holds_alternative<ast::Kernel>(declared) || std::holds_alternative<ast::Pipeline>(declared));
    });
}

/// A call by plain name.
static Operand call_named(Body& body, ast::Identifier name, const std::vector<ast::ExprId>& generics,
                          const ast::Expr& call, ir::TypeId wanted) {
    Context& c = body.context;
    if (body.container && has_method(c, body.container, name.name, call.operands.size() - 1)) {
        Operand self;
        self.kind = OperandKind::structure;
        self.structure = body.container;
        self.span = name.span;
        return call_method(body, self, name, generics, call, wanted);
    }
    Visible visible;
    if (!body.env.find(name.name)) visible = look_up(c, body.env.module, name);
    if (is_function(c, visible.found)) return *call_by_name(body, name, visible.found, generics, call, wanted);
    bool is_hidden = visible.found.empty() && !visible.hidden.empty();
    Meta meta;
    if (!visible.found.empty()) meta.kind = MetaKind::declarations, meta.declarations = visible.found;
    else if (!is_hidden) meta = find_meta(c, body.env, name);
    // A module cannot be called, nor can a pass outside of pipelines: they do not hide a built-in function.
    if (meta.kind == MetaKind::none || (is_uncallable(body, meta) && find_intrinsic(c.text(name.name)))) {
        if (auto result = call_builtin(body, c.text(name.name), call, wanted)) return *result;
        if (auto result = call_by_name(body, name, {}, generics, call, wanted)) return *result;
        if (is_hidden) meta = find_meta(c, body.env, name);
    }
    if (meta.kind == MetaKind::declarations) return call_declarations(body, meta, generics, call, wanted);
    bool shape = c.text(name.name) == "vec" || c.text(name.name) == "mat";
    if (!generics.empty() && (shape || meta.kind != MetaKind::none))
        meta = meta_of(c, env_for(body, call.operands[0]), call.operands[0]);
    meta = as_type(c, meta);
    if (meta.kind == MetaKind::type) return call_type(body, meta.type, call);
    if (meta.kind == MetaKind::none) report_unknown(c, body.env, name);
    else note_functions(c, c.error(Diag::not_callable, name.span, {"'" + c.text(name.name) + "'"}), meta, name.span);
    return error_operand(call.span);
}

static Operand check_unnamed_call(Body& body, ast::ExprId id, ir::TypeId wanted);

/// A call of what is named by a local variable, a parameter or a field.
static Operand call_value(Body& body, ast::ExprId id, ir::TypeId wanted) {
    Context& c = body.context;
    const ast::Expr call = c[id];
    const ast::Expr callee = c[call.operands[0]];
    ir::TypeId applied;
    if (is_path(c, call.operands[0])) {
        const Operand value = check(body, call.operands[0]);
        if (value.kind == OperandKind::error) return error_operand(call.span);
        applied = applied_type(body, value);
    }
    if (applied) {
        const Diagnostics::Mark before = c.diagnostics.mark();
        Operand result = check_unnamed_call(body, applied_call(c, id), wanted);
        const std::vector<Diagnostic>& all = c.diagnostics.all();
        if (all.size() == before.count || all[before.count].span != callee.span) return result;
        c.diagnostics.back_to(before);
    }
    const Symbol* symbol = callee.kind == ast::ExprKind::name ? find_symbol(body, callee.name) : nullptr;
    Diagnostic& diagnostic =
        c.error(Diag::not_callable, callee.span, {symbol ? "'" + c.text(callee.name) + "'" : std::string("this")});
    if (symbol) note(diagnostic, symbol->span, "declared here");
    if (applied) note(diagnostic, callee.span, "there is no function 'apply' for " + c.text(applied));
    if (!is_path(c, call.operands[0])) note(diagnostic, callee.span, "name it first: let f = …;");
    return error_operand(call.span);
}

static Operand check_unnamed_call(Body& body, ast::ExprId id, ir::TypeId wanted) {
    Context& c = body.context;
    const ast::Expr& call = c[id];
    const ast::Expr& callee = c[call.operands[0]];
    const bool generic = callee.kind == ast::ExprKind::generic;
    const ast::Expr& name = generic ? c[callee.operands[0]] : callee;
    std::vector<ast::ExprId> generics;
    if (generic) generics.assign(callee.operands.begin() + 1, callee.operands.end());
    if (name.kind == ast::ExprKind::member) {
        Operand left = check(body, name.operands[0]);
        if (left.kind == OperandKind::error) return error_operand(call.span);
        if (left.kind == OperandKind::iterator) {
            left.kind = OperandKind::structure;
            left.place.root = left.slot;
        }
        if (left.kind == OperandKind::structure)
            return call_method(body, left, {name.name, name.name_span}, generics, call, wanted);
        if (left.kind != OperandKind::meta || left.meta.kind != MetaKind::module) return call_value(body, id, wanted);
        const Meta meta = find_in_module(c, body.env, left.meta.module, {name.name, name.name_span});
        if (meta.kind == MetaKind::none) return error_operand(call.span);
        return call_declarations(body, meta, generics, call, wanted);
    }
    if (name.kind != ast::ExprKind::name) {
        Operand operand = check(body, call.operands[0]);
        if (operand.kind == OperandKind::meta && operand.meta.kind == MetaKind::type)
            return call_type(body, operand.meta.type, call);
        if (operand.kind != OperandKind::error) c.error(Diag::not_callable, callee.span, {"this"});
        return error_operand(call.span);
    }
    if (find_symbol(body, name.name)) return call_value(body, id, wanted);
    return call_named(body, {name.name, name.span}, generics, call, wanted);
}

Operand check_call(Body& body, ast::ExprId id, ir::TypeId wanted) {
    Operand result = check_unnamed_call(body, id, wanted);
    const ast::Expr& call = body.context[id];
    if (call.labels.empty() || result.kind != OperandKind::value) return result;
    const ir::Expr& node = body.program().exprs[result.expr];
    if (node.op == ir::Op::construct && body.types().kind(node.type) == ir::TypeKind::struct_) return result;
    for (const ast::Identifier& label : call.labels) {
        if (!label.name) continue;
        note(body.context.error(Diag::named_argument, label.span, {body.context.text(label.name)}), call.span,
             "only the fields of a struct are named where it is made");
        break;
    }
    return error_operand(call.span);
}

}  // namespace gliftc::sema
