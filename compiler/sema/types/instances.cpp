// Instances of types (structs and enums are made here) and functions, and the depth limit of instantiation.
#include "sema/types/instances.h"

#include "sema/bodies/body.h"
#include "sema/bodies/closures.h"
#include "sema/kernels/writing.h"
#include "sema/structures/components.h"
#include "sema/types/generics.h"
#include "sema/types/type_size.h"

#include <limits>

namespace gliftc::sema {

namespace {

constexpr std::size_t instantiation_limit = 64;

/// The name that `@was("…")` gives to the field of a struct; reports any other attribute.
Name former_name(Context& c, const ast::Field& field) {
    Name former;
    for (const ast::Attribute& attribute : field.attributes) {
        const std::string& name = c.text(attribute.name.name);
        if (name != "was") c.error(Diag::unknown_attribute, attribute.span, {name});
        else if (attribute.arguments.size() != 1 || c[attribute.arguments[0]].kind != ast::ExprKind::string_literal)
            c.error(Diag::attribute_argument, attribute.span, {name});
        else former = c[attribute.arguments[0]].name;
    }
    return former;
}

ir::TypeId make_struct(Context& c, ast::DeclId id, const Env& env, const std::string& key) {
    const ast::Decl& decl = c[id];
    const auto& written = std::get<ast::Struct>(decl.body);
    ir::Struct record;
    record.name = decl.name.name;
    record.display = display_of(c, decl, env);
    record.key = qualified_display_of(c, id, env);
    record.module = c.module_of.at(id);
    record.is_pub = decl.is_pub;
    record.doc = decl.doc;
    record.span = decl.name.span;
    record.extern_header = written.extern_header;
    record.extern_name = written.extern_name;
    record.offsets = written.offsets;
    record.size = written.size;
    const ir::StructId index = c.program.structs.add(std::move(record));
    c.instances[key].index = index.index;
    c.struct_decl[index] = id;
    for (const auto& [name, meta] : env.bindings) c.struct_arguments[index].push_back(meta);
    if (written.fields.size() > most_fields) {
        note(c.error(Diag::too_many_fields, decl.name.span,
                     {c.text(decl.name.name), std::to_string(written.fields.size()), std::to_string(most_fields)}),
             {}, "make fields of one type an array, or group fields into structs");
        return c.types().error;
    }
    std::vector<ir::StructField> fields;
    std::uint64_t scalars = 0;
    for (const ast::Field& field : written.fields) {
        ir::TypeId type = type_of(c, env, field.type);
        bool storable = c.types().kind(type) != ir::TypeKind::structure && c.types().kind(type) != ir::TypeKind::void_;
        if (!storable) {
            c.error(Diag::field_type, c[field.type].span, {c.text(type)});
            type = c.types().error;
        }
        scalars += scalars_in(c.program, type);
        if (scalars > most_scalars) {
            const Name name = decl.name.name;
            c.error(Diag::field_type, c[field.type].span,
                    {c.text(type) + ": with it " + too_many_scalars(c.text(name), scalars)});
            scalars -= scalars_in(c.program, type);
            type = c.types().error;
        }
        if (levels_of(c.program, type) >= most_levels) {
            note(c.error(Diag::type_too_deep, c[field.type].span,
                         {"'" + c.text(decl.name.name) + "'", std::to_string(most_levels)}),
                 {}, "declare the inner values as fields of the outer struct");
            type = c.types().error;
        }
        for (const ir::StructField& other : fields)
            if (other.name == field.name.name)
                c.error(Diag::duplicate_name, field.name.span, {c.text(field.name.name)});
        fields.push_back({field.name.name, type, field.doc, former_name(c, field)});
    }
    c.program.structs[index].fields = std::move(fields);
    return c.types().of_struct(index);
}

ir::TypeId make_enum(Context& c, ast::DeclId id) {
    const ast::Decl& decl = c[id];
    ir::Enum made;
    made.name = decl.name.name;
    made.module = c.module_of.at(id);
    made.is_pub = decl.is_pub;
    made.doc = decl.doc;
    made.span = decl.name.span;
    Env env;
    env.module = made.module;
    std::uint64_t next = 0;
    for (const ast::Enumerator& enumerator : std::get<ast::Enum>(decl.body).enumerators) {
        if (enumerator.value)
            if (auto value = constant_of(c, env, enumerator.value, c.types().uint))
                next = static_cast<std::uint32_t>(value->bits());
        if (next > std::numeric_limits<std::uint32_t>::max())
            c.error(Diag::number_too_large, enumerator.name.span, {std::to_string(next), "uint"});
        for (Name other : made.enumerators)
            if (other == enumerator.name.name) c.error(Diag::duplicate_name, enumerator.name.span, {c.text(other)});
        made.enumerators.push_back(enumerator.name.name);
        made.values.push_back(static_cast<std::uint32_t>(next++));
    }
    return c.types().of_enum(c.program.enums.add(std::move(made)));
}

}  // namespace

InstantiationScope::InstantiationScope(Context& context, std::string display, Span use) : context_(context) {
    if (context.requests.size() >= instantiation_limit) {
        too_deep_ = true;
        context.error(Diag::infinite_instantiation, use, {display});
    }
    context_.requests.push_back({std::move(display), use});
}

InstantiationScope::~InstantiationScope() { context_.requests.pop_back(); }

ir::TypeId instantiate_type(Context& c, ast::DeclId id, const Env& env, Span use) {
    const ast::Decl& decl = c[id];
    std::string key = key_of(c, id, env);
    if (auto found = c.instances.find(key); found != c.instances.end()) {
        if (found->second.state == Instance::State::in_progress) {
            note(c.error(Diag::recursive_type, use, {display_of(c, decl, env)}), decl.name.span,
                 "what it is made of, memory included, is there before it: break the cycle where it begins");
            return c.types().error;
        }
        return found->second.state == Instance::State::failed ? c.types().error : found->second.type;
    }
    InstantiationScope scope(c, display_of(c, decl, env), use);
    if (scope.too_deep()) return c.types().error;
    c.instances[key] = {};
    ir::TypeId type = c.types().error;
    if (std::holds_alternative<ast::Struct>(decl.body)) type = make_struct(c, id, env, key);
    else if (std::holds_alternative<ast::Enum>(decl.body)) type = make_enum(c, id);
    else if (std::holds_alternative<ast::Structure>(decl.body)) type = make_structure(c, id, env);
    else c.error(Diag::not_a_type, use);
    Instance& instance = c.instances[key];
    instance.type = type;
    instance.state = type == c.types().error ? Instance::State::failed : Instance::State::done;
    return type;
}

static void declare_params(Body& body, const std::vector<ast::Param>& params, ir::Function& function,
                           std::size_t first_structure, const std::vector<ir::StructureId>& structures) {
    body.structures = structures;
    Context& c = body.context;
    for (const ast::Param& param : params) {
        ir::TypeId type = type_of(c, body.env, param);
        const bool writes = param.pattern == ast::Pattern::scatter || param.pattern == ast::Pattern::coherent ||
                            param.pattern == ast::Pattern::calls;
        const bool seen = writes || param.pattern == ast::Pattern::none || param.pattern == ast::Pattern::near ||
                          param.pattern == ast::Pattern::any;
        const bool is_out =
            !writes && (param.direction == ast::Direction::out || param.direction == ast::Direction::inout);
        if (!seen)
            note(c.error(Diag::function_pattern, param.pattern_span), param.pattern_span,
                 "a function gives its value by 'return'; the current element is written by the kernel");
        else if (is_out && type != c.types().error) c.error(Diag::function_out, param.direction_span);
        if (!seen || is_out) {  // declared with the error type, so that uses report no further errors
            const ir::LocalId local = declare_local(body, param.name, c.types().error, true, false);
            if (c.types().kind(type) == ir::TypeKind::structure) ++first_structure;
            else function.params.push_back(local);
            continue;
        }
        check_extra_count(c, param);
        if (writes && c.types().kind(type) != ir::TypeKind::structure) {
            if (type != c.types().error) c.error(Diag::pattern_needs_structure, c[param.type].span, {c.text(type)});
            function.params.push_back(declare_local(body, param.name, c.types().error, true, false));
            continue;
        }
        if (c.types().kind(type) != ir::TypeKind::structure) {
            function.params.push_back(declare_local(body, param.name, type, false, false));
            continue;
        }
        if (writes) {
            ir::KernelParam made{
                .name = param.name.name, .span = param.name.span, .pattern = written_pattern(param.pattern)};
            made.structure = structures[first_structure];
            declare_writing(body, param, made, {static_cast<std::uint32_t>(first_structure++), {}}, function);
            continue;
        }
        Symbol symbol;
        symbol.kind = SymbolKind::structure;
        if (param.pattern == ast::Pattern::near) {
            const ir::TypeId domain = c.program.structures[structures[first_structure]].domain_type;
            symbol.window = window_radius(c, body.env, param, domain);
        }
        symbol.place.root = static_cast<std::uint32_t>(first_structure);
        symbol.structure = structures[first_structure++];
        declare(body, param.name, symbol);
    }
}

/// Removes unreachable statements after a return that a constant `if` selected.
static void cut_after_return(const ir::Program& program, std::vector<ir::StmtId>& body) {
    auto is_return = [&](ir::StmtId id) { return program.stmts[id].op == ir::StmtOp::return_; };
    auto found = std::ranges::find_if(body, is_return);
    if (found != body.end()) body.erase(found + 1, body.end());
}

// long: all checks of one declaration
std::optional<ir::FunctionId> instantiate_function(Context& c, ast::DeclId id, const Env& given,
                                                   const std::vector<ir::StructureId>& structures, Span use) {
    const ast::Decl& decl = c[id];
    const auto closure = c.closure_called.find(id);
    const bool calls_closure = closure != c.closure_called.end();
    const Env& env = calls_closure ? *c.closures.at(closure->second).env : given;
    const auto& written = std::get<ast::Function>(decl.body);
    std::string key = key_of(c, id, given);
    for (ir::StructureId structure : structures) key += "@" + std::to_string(structure.index);
    if (auto found = c.instances.find(key); found != c.instances.end()) {
        if (found->second.state == Instance::State::failed) return std::nullopt;
        if (found->second.state == Instance::State::in_progress) {
            note(c.error(Diag::recursion, use, {c.text(decl.name.name)}), decl.name.span,
                 "shaders have no call stack: use a loop");
            return std::nullopt;
        }
        return ir::FunctionId{found->second.index};
    }
    InstantiationScope scope(c, display_of(c, decl, env), use);
    if (scope.too_deep()) return std::nullopt;
    c.instances[key] = {};
    if (written.params.size() > most_parameters) {
        note(c.error(Diag::too_many_parameters, decl.name.span,
                     {c.text(decl.name.name), std::to_string(written.params.size()), std::to_string(most_parameters)}),
             {}, "pass a struct or an array");
        c.instances[key].state = Instance::State::failed;
        return std::nullopt;
    }
    std::size_t errors = c.diagnostics.own_error_count();
    ir::Function function;
    function.name = decl.name.name;
    function.display = display_of(c, decl, env);
    function.key = calls_closure ? key_of_call(c, id) : qualified_display_of(c, id, env);
    function.span = decl.name.span;
    function.module = c.module_of.at(id);
    function.is_pub = decl.is_pub;
    function.doc = decl.doc;
    function.is_silent = !c.settings.messages;
    function.structures = structures;
    function.result = written.result ? type_of(c, env, written.result) : c.types().void_;
    function.group = group_of(c, env, written.group);
    Body body{.context = c,
              .env = env,
              .kind = BodyKind::function,
              .block = &function.body,
              .result = function.result,
              .group = function.group,
              .shared = &function.shared,
              .last = written.body.empty() ? Span{} : c[written.body.back()].span,
              .effects = &function.effects,
              .prints = &function.prints};
    std::size_t parameters = 0;
    for (const ast::Param& param : written.params)
        parameters += c.types().kind(type_of(c, env, param.type)) == ir::TypeKind::structure;
    if (structures.size() > parameters) bring_members_into_scope(body, structures[0]);
    open_scope(body);
    declare_params(body, written.params, function, structures.size() - parameters, structures);
    if (calls_closure) declare_captured(body, closure->second, function.params[0]);
    declare_with(body, written, function);
    check_block(body, written.body);
    close_scope(body);
    if (function.grouped()) cut_after_return(c.program, function.body);
    bool returns = function.result == c.types().void_ || function.result == c.types().error ||
                   always_returns(c.program, function.body);
    if (!returns && c.diagnostics.own_error_count() == errors)
        c.error(Diag::missing_return, decl.name.span, {c.text(decl.name.name), c.text(function.result)});
    Instance& instance = c.instances[key];
    instance.state = c.diagnostics.own_error_count() == errors ? Instance::State::done : Instance::State::failed;
    if (instance.state == Instance::State::failed) return std::nullopt;
    function.reads_memory = reads_memory(c.program, function.body);
    ir::FunctionId made = c.program.functions.add(std::move(function));
    c.instances[key].index = made.index;
    return made;
}

}  // namespace gliftc::sema
