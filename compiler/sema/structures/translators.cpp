#include "sema/structures/components.h"
#include "sema/structures/properties.h"
#include "sema/types/generics.h"
#include "sema/types/instances.h"
#include "sema/types/typing.h"

#include <set>

namespace gliftc::sema {

namespace {

struct Method {
    std::string_view name;
    ast::DeclId decl;
};

/// Declares the scalars and structures of a translator's state in the scope of its functions.
void bring_state_into_scope(Body& body, const ir::Translator& translator) {
    for (std::uint32_t i = 0; i < translator.scalars.size(); ++i) {
        Symbol symbol;
        symbol.kind = SymbolKind::state;
        symbol.slot = i;
        symbol.type = translator.scalars[i].type;
        declare(body, {translator.scalars[i].name, translator.span}, symbol);
    }
    for (std::uint32_t i = 0; i < translator.structures.size(); ++i) {
        Symbol symbol;
        symbol.kind = SymbolKind::structure;
        symbol.place.root = i;
        symbol.structure = translator.structures[i];
        declare(body, {translator.structure_names[i], translator.span}, symbol);
    }
}

ir::FunctionId make_method(Context& c, ast::DeclId id, const Env& env, const ir::Translator& translator,
                           const std::vector<ir::TypeId>& params, ir::TypeId result) {
    const ast::Decl& decl = c[id];
    const auto& written = std::get<ast::Function>(decl.body);
    std::size_t errors = c.diagnostics.own_error_count();
    if (written.params.size() != params.size()) {
        c.error(Diag::method_params, decl.name.span, {c.text(decl.name.name), std::to_string(params.size())});
        return {};
    }
    ir::Function function;
    function.name = decl.name.name;
    function.display = translator.display + "." + c.text(decl.name.name);
    function.span = decl.name.span;
    function.module = c.module_of.at(id);
    function.structures = translator.structures;
    function.result = result;
    function.doc = decl.doc;
    Body body{.context = c, .env = env, .kind = BodyKind::function, .block = &function.body, .result = result};
    bring_state_into_scope(body, translator);
    check_fixed_type(c, env, written.result, result);
    open_scope(body);
    for (std::size_t i = 0; i < params.size(); ++i) {
        const ast::Param& param = written.params[i];
        check_fixed_type(c, env, param.type, params[i]);
        function.params.push_back(declare_local(body, param.name, params[i], false, false));
    }
    check_block(body, written.body);
    close_scope(body);
    if (c.diagnostics.own_error_count() == errors && !always_returns(c.program, function.body))
        c.error(Diag::missing_return, decl.name.span, {c.text(decl.name.name), c.text(result)});
    if (c.diagnostics.own_error_count() != errors) return {};
    return c.program.functions.add(std::move(function));
}

void add_fields(Context& c, const Env& env, const ast::Translator& written, ir::Translator& translator) {
    std::set<Name> seen;
    for (const ast::Field& field : written.fields) {
        if (!seen.insert(field.name.name).second) continue;  // a duplicate, reported by collect_modules
        ir::TypeId type = type_of(c, env, field.type);
        if (c.types().kind(type) == ir::TypeKind::structure) {
            translator.structures.push_back(c.types()[type].structure);
            translator.structure_names.push_back(field.name.name);
        } else {
            translator.scalars.push_back({field.name.name, type, field.doc});
        }
    }
}

ir::TranslatorId make_translator(Context& c, ast::DeclId id, const Env& env) {
    const ast::Decl& decl = c[id];
    const auto& written = std::get<ast::Translator>(decl.body);
    std::size_t errors = c.diagnostics.own_error_count();
    ir::Translator translator;
    translator.name = decl.name.name;
    translator.display = display_of(c, decl, env);
    translator.key = qualified_display_of(c, id, env);
    translator.span = decl.name.span;
    translator.module = c.module_of.at(id);
    translator.doc = decl.doc;
    translator.virtual_type = type_of(c, env, written.virtual_type);
    ir::TypeId physical = type_of(c, env, written.physical_type);
    translator.properties.partial = c.types().kind(physical) == ir::TypeKind::optional;
    translator.physical_type = translator.properties.partial ? c.types()[physical].element : physical;
    auto check_address = [&](ir::TypeId type, ast::ExprId at) {
        if (type != c.types().error && !is_address(c.types(), type))
            c.error(Diag::address_type, c[at].span, {c.text(type)});
    };
    check_address(translator.virtual_type, written.virtual_type);
    check_address(translator.physical_type, written.physical_type);
    add_fields(c, env, written, translator);
    if (c.diagnostics.own_error_count() != errors) return {};
    for (ast::DeclId method : written.methods) {
        const std::string& name = c.text(c[method].name.name);
        ir::TypeId va = translator.virtual_type;
        if (name == "translate") translator.translate = make_method(c, method, env, translator, {va}, physical);
        else if (name == "invert")
            translator.invert = make_method(c, method, env, translator, {translator.physical_type}, va);
        else if (name == "domain") translator.domain = make_method(c, method, env, translator, {}, va);
        else if (name == "ranges")
            note(c.error(Diag::derived_ranges, c[method].name.span), c[method].name.span,
                 "boxes of an affine translator are copied by rows; of any other, a pass translates each address");
        else c.error(Diag::unknown_member, c[method].name.span, {"a translator", name});
    }
    bool has_translate = false;
    for (ast::DeclId method : written.methods) has_translate |= c.text(c[method].name.name) == "translate";
    if (!has_translate) c.error(Diag::no_translate, decl.name.span, {c.text(decl.name.name)});
    if (c.diagnostics.own_error_count() != errors) return {};
    translator.properties.invertible = static_cast<bool>(translator.invert);
    const ir::TranslatorId index = c.program.translators.add(std::move(translator));
    c.translator_decl[index] = id;
    c.translator_env[index] = &env;
    for (const auto& [name, meta] : env.bindings) c.translator_arguments[index].push_back(meta);
    infer_properties(c, index, decl);
    return index;
}

}  // namespace

ir::TranslatorId instantiate_translator(Context& c, ast::DeclId id, const Env& env, Span use) {
    std::string key = key_of(c, id, env);
    if (auto found = c.instances.find(key); found != c.instances.end()) {
        if (found->second.state == Instance::State::in_progress)
            c.error(Diag::recursive_type, use, {c.text(c[id].name.name)});
        return {found->second.index};
    }
    InstantiationScope scope(c, display_of(c, c[id], env), use);
    if (scope.too_deep()) return {};
    c.instances[key] = {};
    const ir::TranslatorId made = make_translator(c, id, env);
    Instance& instance = c.instances[key];
    instance.state = made ? Instance::State::done : Instance::State::failed;
    instance.index = made.index;
    return made;
}

ir::ExprId single_return(const ir::Program& program, ir::FunctionId id) {
    if (!id) return {};
    const ir::Function& function = program.functions[id];
    if (function.body.size() != 1 || program.stmts[function.body[0]].op != ir::StmtOp::return_) return {};
    return program.stmts[function.body[0]].value;
}

ir::ExprId substitute_state(Context& c, ir::ExprId id, const ir::Stage& stage) {
    ir::Expr expr = c.program.exprs[id];
    if (expr.op == ir::Op::state) return stage.scalars[expr.slot];
    for (ir::ExprId& operand : expr.operands) operand = substitute_state(c, operand, stage);
    bool placed = expr.op == ir::Op::member || expr.op == ir::Op::memory_extent || expr.op == ir::Op::domain;
    if (placed && expr.place.root < stage.structures.size()) {
        ir::Place place = stage.structures[expr.place.root];
        place.members.append(expr.place.members);
        expr.place = std::move(place);
    }
    return c.program.exprs.add(std::move(expr));
}

bool is_address(const ir::Types& types, ir::TypeId type) {
    return types.kind(type) == ir::TypeKind::uint ||
           (types.is_vector(type) && types.kind(types.scalar_of(type)) == ir::TypeKind::uint);
}

}  // namespace gliftc::sema
