#include "sema/types/meta.h"

#include "ir/spelling.h"
#include "sema/bodies/body.h"
#include "sema/names/defines.h"
#include "sema/names/lookup.h"
#include "sema/names/record.h"
#include "sema/names/unknown_names.h"
#include "sema/structures/projection.h"
#include "sema/types/builtin_names.h"
#include "sema/types/generics.h"
#include "sema/types/instances.h"
#include "sema/types/type_size.h"
#include "sema/types/typing.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

Meta of_type(ir::TypeId type) {
    Meta meta;
    meta.kind = MetaKind::type;
    meta.type = type;
    return meta;
}

/// Records that a module gives the structure a name by `structure Name = …`, unless that alias is generic.
void note_alias(Context& c, ast::DeclId id, ir::TypeId structure) {
    const ast::Decl& decl = c[id];
    if (!decl.generics.empty()) return;
    const ir::ModuleId module = c.module_of.at(id);
    std::vector<ir::Alias>& aliases = c.program.structures[c.types()[structure].structure].aliases;
    const bool is_known = std::ranges::any_of(
        aliases, [&](const ir::Alias& alias) { return alias.name == decl.name.name && alias.module == module; });
    if (!is_known) aliases.push_back({decl.name.name, module, decl.is_pub});
}

/// The meaning of a declaration with its generic arguments bound in `env`.
Meta meta_of_declaration(Context& c, ast::DeclId id, const Env& env, Span use) {
    const ast::Decl& decl = c[id];
    Meta meta;
    bool is_translator = std::holds_alternative<ast::Translator>(decl.body);
    if (std::holds_alternative<ast::Alias>(decl.body)) return meta_of_alias(c, id, env, use);
    if (is_translator) {
        const ir::TranslatorId made = instantiate_translator(c, id, env, use);
        if (!made) return {};
        meta.kind = MetaKind::translator;
        meta.translators = {made};
        return meta;
    }
    ir::TypeId type = instantiate_type(c, id, env, use);
    if (type == c.types().error) return {};
    return of_type(type);
}

bool is_type_declaration(const ast::Decl& decl) {
    return std::holds_alternative<ast::Struct>(decl.body) || std::holds_alternative<ast::Enum>(decl.body) ||
           std::holds_alternative<ast::Alias>(decl.body) || std::holds_alternative<ast::Translator>(decl.body) ||
           std::holds_alternative<ast::Structure>(decl.body);
}

/// `mat<C, R, T>`: shaders have matrices of floating types alone.
Meta matrix_type(Context& c, const ast::Expr& expr, std::int64_t columns, std::int64_t rows, ir::TypeId element) {
    if (columns < 2 || columns > 4 || rows < 2 || rows > 4) {
        c.error(Diag::matrix_size, expr.span, {std::to_string(columns), std::to_string(rows)});
        return {};
    }
    if (!c.types().is_floating(element)) {
        const Span span = c[expr.operands.back()].span;
        note(c.error(Diag::matrix_element, span, {c.text(element)}), span,
             "its elements are float, half or double; keep others in an array of vectors: vec<R, T>[C]");
        return {};
    }
    return of_type(c.types().matrix(element, static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows)));
}

/// `vec<N, T>`, `mat<C, R, T>`.
Meta builtin_generic(Context& c, const Env& env, const ast::Expr& expr, std::string_view name) {
    bool vec = name == "vec";
    if (expr.operands.size() != (vec ? 3u : 4u)) {
        c.error(Diag::argument_count, expr.span, {name, vec ? "2" : "3", std::to_string(expr.operands.size() - 1)});
        return {};
    }
    auto n = count_of(c, env, expr.operands[1]);
    auto rows = vec ? n : count_of(c, env, expr.operands[2]);
    ir::TypeId element = type_of(c, env, expr.operands.back());
    if (!n || !rows || element == c.types().error) return {};
    if (!vec) return matrix_type(c, expr, *n, *rows, element);
    if (*n < 1 || *n > 4) {
        c.error(Diag::vector_size, c[expr.operands[1]].span, {std::to_string(*n)});
        return {};
    }
    if (!c.types().is_scalar(element)) {
        c.error(Diag::vector_element, c[expr.operands.back()].span, {c.text(element)});
        return {};
    }
    return of_type(c.types().vector(element, *n));
}

/// What a name means where no generic arguments follow it: the type, if its declarations declare one.
Meta without_arguments(Context& c, Meta meta, Span span) {
    if (meta.kind != MetaKind::declarations) return meta;
    ast::DeclId id = meta.declarations[0];
    const ast::Decl& decl = c[id];
    if (!is_type_declaration(decl)) return meta;
    Env& inner = c.new_env(c.module_of.at(id));
    if (!decl.generics.empty()) {
        Arguments arguments(c, decl, inner, span);
        if (!arguments.finish()) return {};
    }
    return meta_of_declaration(c, id, inner, span);
}

Meta meta_of_name(Context& c, const Env& env, const ast::Expr& expr) {
    Meta meta = find_meta(c, env, {expr.name, expr.span});
    if (meta.kind == MetaKind::none) {
        report_unknown(c, env, {expr.name, expr.span});
        return meta;
    }
    if (meta.kind == MetaKind::running) {
        c.error(Diag::not_constant, expr.span);
        return {};
    }
    return without_arguments(c, std::move(meta), expr.span);
}

/// The module that the expression names, by its whole name or its last part.
ir::ModuleId module_named(Context& c, const Env& env, ast::ExprId id) {
    const ast::Expr& expr = c[id];
    if (expr.kind == ast::ExprKind::member) return module_by_whole_name(c, env, id);
    if (expr.kind != ast::ExprKind::name) return {};
    const Meta meta = find_meta(c, env, {expr.name, expr.span});
    return meta.kind == MetaKind::module ? meta.module : ir::ModuleId{};
}

Meta meta_of_generic(Context& c, const Env& env, const ast::Expr& expr) {
    const ast::Expr& name = c[expr.operands[0]];
    if (name.kind != ast::ExprKind::name && name.kind != ast::ExprKind::member) {
        c.error(Diag::not_a_type, name.span);
        return {};
    }
    if (name.kind == ast::ExprKind::name && (c.text(name.name) == "vec" || c.text(name.name) == "mat"))
        return builtin_generic(c, env, expr, c.text(name.name));
    Meta meta;
    if (name.kind == ast::ExprKind::name) {
        meta = find_meta(c, env, {name.name, name.span});
        if (meta.kind == MetaKind::none) report_unknown(c, env, {name.name, name.span});
    } else if (const ir::ModuleId module = module_named(c, env, name.operands[0])) {
        meta = find_in_module(c, env, module, {name.name, name.name_span});
    } else {
        meta = meta_of(c, env, expr.operands[0]);
    }
    if (meta.kind == MetaKind::none) return meta;
    bool generic = meta.kind == MetaKind::declarations && !c[meta.declarations[0]].generics.empty();
    if (!generic) {
        c.error(Diag::not_generic, expr.span, {"'" + c.text(name.name) + "'"});
        return {};
    }
    ast::DeclId id = meta.declarations[0];
    if (!is_type_declaration(c[id])) {
        c.error(Diag::not_a_type, expr.span);
        return {};
    }
    Env& inner = c.new_env(c.module_of.at(id));
    Arguments arguments(c, c[id], inner, expr.span);
    if (!arguments.give(env, expr.operands, 1) || !arguments.finish()) return {};
    return meta_of_declaration(c, id, inner, expr.span);
}

/// `Grid.density`, where `left` means a structure: the type of its component. A structure that is made already is not
/// made anew.
Meta meta_of_component(Context& c, const Meta& left, const ast::Expr& expr) {
    const ir::StructureId whole = c.types()[left.type].structure;
    const auto is_it = [&](const ir::MemberStructure& member) { return member.name == expr.name; };
    const auto& members = c.program.structures[whole].members;
    const auto found = std::ranges::find_if(members, is_it);
    if (found != members.end()) return of_type(c.types().of_structure(found->structure));
    if (const auto made = component_of(c, whole, {expr.name, expr.name_span}))
        return of_type(c.types().of_structure(c.program.structures[whole].members[*made].structure));
    Diagnostic& diagnostic =
        c.error(Diag::unknown_member, expr.name_span, {c.program.structures[whole].display, c.text(expr.name)});
    const std::string_view meant = did_you_mean(c.text(expr.name), component_names(c, whole));
    if (!meant.empty()) note(diagnostic, expr.name_span, "did you mean '" + std::string(meant) + "'?");
    return {};
}

/// The structure that the expression names; a Meta of kind `none`, without an error, if it names anything else.
Meta owner_named(Context& c, const Env& env, ast::ExprId id) {
    const ast::Expr& expr = c[id];
    const bool may_be =
        expr.kind == ast::ExprKind::generic || expr.kind == ast::ExprKind::member || expr.kind == ast::ExprKind::name;
    if (!may_be) return {};
    if (expr.kind == ast::ExprKind::name) {
        const Meta named = find_meta(c, env, {expr.name, expr.span});
        const bool is_type = named.kind == MetaKind::type ||
                             (named.kind == MetaKind::declarations && is_type_declaration(c[named.declarations[0]]));
        if (!is_type) return {};
    }
    Meta meta = meta_of(c, env, id);
    const bool is_structure = meta.kind == MetaKind::type && c.types().kind(meta.type) == ir::TypeKind::structure;
    return is_structure ? meta : Meta{};
}

Meta meta_of_array(Context& c, const Env& env, const ast::Expr& expr) {
    ir::TypeId element = type_of(c, env, expr.operands[0]);
    if (element == c.types().error) return {};
    if (expr.operands.size() != 2) {
        c.error(Diag::array_size, expr.span);
        return {};
    }
    auto count = count_of(c, env, expr.operands[1]);
    if (!count) return {};
    if (*count == 0 || *count > 65536) {
        c.error(Diag::array_size, c[expr.operands[1]].span);
        return {};
    }
    const ir::TypeId type = c.types().array(element, *count);
    if (levels_of(c.program, type) > most_levels) {
        note(c.error(Diag::type_too_deep, expr.span, {"this array", std::to_string(most_levels)}), {},
             "use fewer dimensions, and compute the index in an array of one");
        return {};
    }
    if (const std::uint64_t scalars = scalars_in(c.program, type); scalars > most_scalars) {
        Diagnostic& error = c.error(Diag::array_size, expr.span);
        note(error, {}, too_many_scalars(c.text(type), scalars) + ": keep it in a structure, as Array<1, …>");
        return {};
    }
    return of_type(type);
}

void report_ambiguous_module(Context& c, ast::Identifier name, ir::ModuleId one, ir::ModuleId other) {
    std::string first = c.text(c.modules[one].tree->name.name), second = c.text(c.modules[other].tree->name.name);
    if (second < first) std::swap(first, second);
    note(c.error(Diag::ambiguous_module, name.span, {c.text(name.name), first, second}), name.span,
         "write the module's whole name: '" + first + ".…'");
}

}  // namespace

std::vector<ast::DeclId> find_declarations(Context& c, ir::ModuleId module, ast::Identifier name) {
    Visible visible = look_up(c, module, name);
    if (!visible.found.empty() || visible.hidden.empty()) return visible.found;
    // Private names of imports do not hide built-in names.
    if (builtin(c, c.text(name.name)).kind != MetaKind::none) return {};
    report_private(c, name, visible.hidden[0]);
    return visible.hidden;
}

Meta meta_of_alias(Context& c, ast::DeclId id, const Env& env, Span use) {
    const ast::Decl& decl = c[id];
    InstantiationScope scope(c, c.text(decl.name.name), use);
    if (scope.too_deep()) return {};
    Meta meta = meta_of(c, env, std::get<ast::Alias>(decl.body).target);
    if (meta.kind == MetaKind::type && c.types().kind(meta.type) == ir::TypeKind::structure)
        note_alias(c, id, meta.type);
    return meta;
}

Meta find_meta(Context& c, const Env& env, ast::Identifier name) {
    if (const Meta* bound = env.find(name.name)) return *bound;
    const std::string& text = c.text(name.name);
    if (env.self && text == "Self") return of_type(env.self);
    Meta meta;
    meta.declarations = find_declarations(c, env.module, name);
    if (!meta.declarations.empty()) {
        meta.kind = MetaKind::declarations;
        return meta;
    }
    meta = builtin(c, text);
    if (meta.kind != MetaKind::none) return meta;
    for (ir::ModuleId import : c.scopes[env.module].imports) {
        const std::string& whole = c.text(c.modules[import].tree->name.name);
        if (whole != text && !whole.ends_with("." + text)) continue;
        if (meta.kind == MetaKind::module && whole != text && meta.module != import) {
            report_ambiguous_module(c, name, meta.module, import);
            return meta;
        }
        meta.kind = MetaKind::module;
        meta.module = import;
        if (whole == text) return meta;
    }
    return meta;
}

static Meta meaning_of(Context& c, const Env& env, ast::ExprId id) {
    const ast::Expr& expr = c[id];
    switch (expr.kind) {
    case ast::ExprKind::error: return {};
    case ast::ExprKind::known_type: return of_type({static_cast<std::uint32_t>(expr.value)});
    case ast::ExprKind::name: return meta_of_name(c, env, expr);
    case ast::ExprKind::generic: return meta_of_generic(c, env, expr);
    case ast::ExprKind::index: return meta_of_array(c, env, expr);
    case ast::ExprKind::optional: {
        ir::TypeId element = type_of(c, env, expr.operands[0]);
        if (is_refused_optional(c, element, "the value of an optional", expr.span)) return {};
        return element == c.types().error ? Meta{} : of_type(c.types().optional(element));
    }
    case ast::ExprKind::member:
        if (const ir::ModuleId module = module_named(c, env, expr.operands[0])) {
            Meta meta = find_in_module(c, env, module, {expr.name, expr.name_span});
            return without_arguments(c, std::move(meta), expr.span);
        }
        if (const Meta left = owner_named(c, env, expr.operands[0]); left.kind == MetaKind::type)
            return meta_of_component(c, left, expr);
        break;
    case ast::ExprKind::binary:
        if (expr.binary == ast::BinaryOp::then) {
            Meta left = meta_of(c, env, expr.operands[0]), right = meta_of(c, env, expr.operands[1]);
            if (left.kind == MetaKind::none || right.kind == MetaKind::none) return {};
            if (left.kind != MetaKind::translator || right.kind != MetaKind::translator) {
                c.error(Diag::not_a_translator, expr.span);
                return {};
            }
            left.translators.insert(left.translators.end(), right.translators.begin(), right.translators.end());
            return left;
        }
        break;
    default: break;
    }
    auto value = constant_of(c, env, id);
    Meta meta;
    if (value) meta.kind = MetaKind::value, meta.value = *value;
    return meta;
}

Meta meta_of(Context& c, const Env& env, ast::ExprId id) {
    Meta meta = meaning_of(c, env, id);
    if (meta.kind == MetaKind::type) record_type(c, c[id].span, meta.type);
    return meta;
}

ir::TypeId value_of_format(ir::Types& types, ir::Format format) {
    switch (format) {
    case ir::Format::none: return types.error;
    case ir::Format::r8:
    case ir::Format::r16f:
    case ir::Format::r32f:
    case ir::Format::d32: return types.float_;
    case ir::Format::rg8:
    case ir::Format::rg16f:
    case ir::Format::rg32f: return types.vector(types.float_, 2);
    case ir::Format::rgba8:
    case ir::Format::rgba16f:
    case ir::Format::rgba32f: return types.vector(types.float_, 4);
    case ir::Format::r8ui:
    case ir::Format::r16ui:
    case ir::Format::r32ui: return types.uint;
    case ir::Format::rg32ui: return types.vector(types.uint, 2);
    case ir::Format::rgba32ui:
    case ir::Format::rgba8ui: return types.vector(types.uint, 4);
    case ir::Format::r32i: return types.int_;
    case ir::Format::rg32i: return types.vector(types.int_, 2);
    case ir::Format::rgba32i: return types.vector(types.int_, 4);
    }
    return types.error;
}

Meta as_type(Context& c, const Meta& meta) {
    return meta.kind == MetaKind::format ? of_type(value_of_format(c.types(), meta.format)) : meta;
}

ir::TypeId type_of(Context& c, const Env& env, ast::ExprId id) {
    if (!id) return c.types().error;
    const Meta meta = as_type(c, meta_of(c, env, id));
    if (meta.kind == MetaKind::type) return meta.type;
    if (meta.kind != MetaKind::none) c.error(Diag::not_a_type, c[id].span);
    return c.types().error;
}

ir::TypeId type_of(Context& c, const Env& env, const ast::Param& param) {
    if (!param.type) c.error(Diag::param_type, param.name.span, {c.text(param.name.name)});
    return type_of(c, env, param.type);
}

std::optional<ir::Value> constant_of(Context& c, const Env& env, ast::ExprId id, ir::TypeId wanted) {
    if (!id) return std::nullopt;
    Body body{.context = c, .env = env, .kind = BodyKind::constant};
    ir::ExprId expr = check_value(body, id, wanted ? wanted : is_flexible(c, id) ? c.types().uint : ir::TypeId{});
    if (is_error(body, expr)) return std::nullopt;
    auto value = ir::evaluate(c.program, expr);
    if (!value) c.error(Diag::not_constant, c[id].span);
    return value;
}

ir::ExprId constant_declaration(Context& c, ast::DeclId id) {
    if (auto found = c.constants.find(id); found != c.constants.end()) return found->second;
    const ast::Decl& decl = c[id];
    if (std::find(c.constants_under_way.begin(), c.constants_under_way.end(), id) != c.constants_under_way.end()) {
        c.error(Diag::recursion, decl.name.span, {c.text(decl.name.name)});
        return c.constants[id] = {};
    }
    c.constants_under_way.push_back(id);
    const auto& constant = std::get<ast::Const>(decl.body);
    Env env;
    env.module = c.module_of.at(id);
    Body body{.context = c, .env = env, .kind = BodyKind::constant};
    ir::TypeId wanted = constant.type ? type_of(c, env, constant.type) : ir::TypeId{};
    ir::ExprId value = check_value(body, constant.value, wanted);
    ir::ExprId result;
    if (!is_error(body, value)) {
        if (auto known = ir::evaluate(c.program, value)) result = ir::materialize(c.program, *known, decl.span);
        else c.error(Diag::not_constant, c[constant.value].span);
        if (result) result = defined_value(c, id, result);
    }
    c.constants_under_way.pop_back();
    return c.constants[id] = result;
}

std::optional<std::uint32_t> count_of(Context& c, const Env& env, ast::ExprId id) {
    auto value = constant_of(c, env, id);
    if (!value) return std::nullopt;
    bool whole = value->lanes.size() == 1 && (value->type == c.types().uint || value->type == c.types().int_);
    if (whole && value->bits() <= 0xffffffffu) return static_cast<std::uint32_t>(value->bits());
    c.error(Diag::count_type, c[id].span, {ir::to_text(c.program, *value)});
    return std::nullopt;
}

std::string to_text(const Context& c, const Meta& meta) {
    switch (meta.kind) {
    case MetaKind::type: return c.text(meta.type);
    case MetaKind::value: return ir::to_text(c.program, meta.value);
    case MetaKind::translator: {
        std::string text;
        for (ir::TranslatorId i : meta.translators)
            text += (text.empty() ? "" : " then ") + c.program.translators[i].display;
        return text;
    }
    case MetaKind::format: return std::string(ir::spelling(meta.format));
    case MetaKind::none:
    case MetaKind::declarations:
    case MetaKind::module:
    case MetaKind::memory_shape:
    case MetaKind::constraint:
    case MetaKind::running: return "?";
    }
    return "?";
}

/// Whether the text of such a value may begin with its type, whose name is not qualified.
static bool has_parts(ir::TypeKind kind) {
    using enum ir::TypeKind;
    return kind == vector || kind == matrix || kind == array || kind == struct_ || kind == optional;
}

std::string to_qualified_text(const Context& c, const Meta& meta) {
    if (meta.kind == MetaKind::type) return ir::to_qualified_text(c.program, meta.type);
    if (meta.kind == MetaKind::value && has_parts(c.program.types.kind(meta.value.type)))
        return ir::to_qualified_text(c.program, meta.value.type) + ir::to_text(c.program, meta.value);
    if (meta.kind != MetaKind::translator) return to_text(c, meta);
    std::string text;
    for (ir::TranslatorId i : meta.translators) text += (text.empty() ? "" : " then ") + c.program.translators[i].key;
    return text;
}

bool same(const Meta& a, const Meta& b) {
    return a.kind == b.kind && a.type == b.type && a.value == b.value && a.translators == b.translators &&
           a.format == b.format;
}

}  // namespace gliftc::sema
