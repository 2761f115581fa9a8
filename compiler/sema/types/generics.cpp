#include "sema/types/generics.h"

#include "sema/bodies/body.h"
#include "sema/bodies/closures.h"
#include "sema/types/interfaces.h"
#include "sema/types/typing.h"

#include <algorithm>
#include <bit>

namespace gliftc::sema {

namespace {

/// Whether the constraint is built in or an interface, so that the argument is a type, structure, format or translator
/// rather than a value.
bool takes_type(Context& c, const Env& env, ast::ExprId constraint) {
    const ast::Expr& expr = c[constraint];
    const ast::Expr& name = expr.kind == ast::ExprKind::generic ? c[expr.operands[0]] : expr;
    if (name.kind != ast::ExprKind::name) return false;
    Meta meta = find_meta(c, env, {name.name, name.span});
    if (meta.kind == MetaKind::constraint) return true;
    return meta.kind == MetaKind::declarations && std::holds_alternative<ast::Interface>(c[meta.declarations[0]].body);
}

bool declares_type(const ast::Decl& decl) {
    return std::holds_alternative<ast::Struct>(decl.body) || std::holds_alternative<ast::Enum>(decl.body) ||
           std::holds_alternative<ast::Alias>(decl.body) || std::holds_alternative<ast::Structure>(decl.body);
}

/// Whether the argument means a type: `float`, `Pair`, `Array<1, float>`, `uint?`, `uint[4]`.
bool names_type(Context& c, const Env& user, ast::ExprId argument) {
    const ast::Expr& expr = c[argument];
    switch (expr.kind) {
    case ast::ExprKind::generic:
    case ast::ExprKind::optional: return true;
    case ast::ExprKind::index: return names_type(c, user, expr.operands[0]);
    case ast::ExprKind::name: {
        const Meta meta = as_type(c, find_meta(c, user, {expr.name, expr.span}));
        return meta.kind == MetaKind::type ||
               (meta.kind == MetaKind::declarations && declares_type(c[meta.declarations[0]]));
    }
    default: return false;
    }
}

/// The index of the generic parameter of that name; their number if there is none.
std::size_t place_of(const ast::Decl& decl, Name name) {
    const auto name_of = [](const ast::GenericParam& param) { return param.name.name; };
    return static_cast<std::size_t>(std::ranges::find(decl.generics, name, name_of) - decl.generics.begin());
}

Meta value_meta(ir::Value value) {
    Meta meta;
    meta.kind = MetaKind::value;
    meta.value = std::move(value);
    return meta;
}

/// `border` for `Boundary.border`: where an enum is expected, enumerators need no prefix.
std::optional<Meta> enumerator_of(Context& c, ir::TypeId type, const ast::Expr& expr) {
    const bool is_none = expr.kind == ast::ExprKind::none_literal;
    if (c.types().kind(type) != ir::TypeKind::enum_ || (expr.kind != ast::ExprKind::name && !is_none)) return {};
    const ir::Enum& declared = c.program.enums[c.types()[type].enum_];
    const std::string_view text = is_none ? std::string_view("none") : std::string_view(c.text(expr.name));
    for (std::size_t k = 0; k < declared.enumerators.size(); ++k)
        if (c.text(declared.enumerators[k]) == text) return value_meta({type, {ir::Lane{.bits = declared.values[k]}}});
    return {};
}

bool is_texel(const ir::Types& types, ir::TypeId type) {
    ir::TypeId scalar = types.scalar_of(type);
    bool shaped = types.is_scalar(type) || (types.is_vector(type) && types.components(type) != 3);
    return shaped && (scalar == types.float_ || scalar == types.uint || scalar == types.int_);
}

bool satisfies_structure(Context& c, const Env& env, const ast::Expr& constraint, ir::TypeId type, std::string& why) {
    if (c.types().kind(type) != ir::TypeKind::structure) {
        why = c.text(type) + " is not a structure";
        return false;
    }
    const ir::Structure structure = c.program.structures[c.types()[type].structure];
    if (constraint.kind != ast::ExprKind::generic) return true;
    if (structure.kind == ir::StructureKind::no_elements) {
        why = structure.display + " has no elements";
        return false;
    }
    if (constraint.operands.size() > 1) {
        ir::TypeId domain = type_of(c, env, constraint.operands[1]);
        if (domain != structure.domain_type) {
            why = "its virtual domain is " + c.text(structure.domain_type) + ", not " + c.text(domain);
            return false;
        }
    }
    if (constraint.operands.size() > 2) {
        ir::TypeId element = type_of(c, env, constraint.operands[2]);
        if (element != structure.element) {
            why = "its elements are " + c.text(structure.element) + ", not " + c.text(element);
            return false;
        }
    }
    return true;
}

/// What the name of a constraint stands for.
Meta meaning_of(Context& c, const Env& env, const ast::Expr& constraint) {
    const ast::Expr& name = constraint.kind == ast::ExprKind::generic ? c[constraint.operands[0]] : constraint;
    return name.kind == ast::ExprKind::name ? find_meta(c, env, {name.name, name.span}) : Meta{};
}

bool is_interface(const Context& c, const Meta& meta) {
    return meta.kind == MetaKind::declarations && std::holds_alternative<ast::Interface>(c[meta.declarations[0]].body);
}

/// The constraint of an unnamed parameter, with the types that its generic arguments are: `Structure<uint3, float>`.
std::string constraint_text(Context& c, const Env& env, ast::ExprId constraint) {
    const ast::Expr& expr = c[constraint];
    if (expr.kind == ast::ExprKind::name) return c.text(expr.name);
    std::string text = c.text(c[expr.operands[0]].name);
    for (std::size_t i = 1; i < expr.operands.size(); ++i)
        text += (i == 1 ? "<" : ", ") + c.text(type_of(c, env, expr.operands[i]));
    return text + ">";
}

/// Says what the interface is for, as the first paragraph of its comment does.
void note_interface(Context& c, const Env& env, ast::ExprId constraint, Diagnostic& diagnostic) {
    const Meta wanted = meaning_of(c, env, c[constraint]);
    if (!is_interface(c, wanted)) return;
    const ast::Decl& decl = c[wanted.declarations[0]];
    std::string text = decl.doc.substr(0, decl.doc.find("\n\n"));
    if (text.empty()) return;
    std::ranges::replace(text, '\n', ' ');
    note(diagnostic, decl.name.span, c.text(decl.name.name) + ": " + text);
}

}  // namespace

bool satisfies(Context& c, const Env& env, ast::ExprId constraint, const Meta& meta, std::string& why) {
    const ast::Expr& expr = c[constraint];
    Meta wanted = meaning_of(c, env, expr);
    bool interface = is_interface(c, wanted);
    if (wanted.kind == MetaKind::constraint || interface) {
        if (wanted.kind == MetaKind::constraint && wanted.constraint == Constraint::translator) {
            why = "a translator is wanted";
            return meta.kind == MetaKind::translator;
        }
        if (meta.kind == MetaKind::format && wanted.kind == MetaKind::constraint &&
            wanted.constraint == Constraint::texel)
            return true;
        if (meta.kind != MetaKind::type) {
            why = "a type is wanted here";
            return false;
        }
        if (interface) return satisfies_interface(c, env, wanted.declarations[0], expr, meta.type, why);
        ir::TypeId scalar = c.types().scalar_of(meta.type);
        bool shaped = c.types().is_scalar(meta.type) || c.types().is_vector(meta.type);
        switch (wanted.constraint) {
        case Constraint::type:
            why = "a structure is not a type of values";
            return c.types().kind(meta.type) != ir::TypeKind::structure;
        case Constraint::texel: why = c.text(meta.type) + " has no texel format"; return is_texel(c.types(), meta.type);
        case Constraint::number:
            why = c.text(meta.type) + " is not a number";
            return shaped && c.types().is_number(scalar);
        case Constraint::integer:
            why = c.text(meta.type) + " is not an integer";
            return shaped && c.types().is_integer(scalar);
        case Constraint::floating:
            why = c.text(meta.type) + " is not floating";
            return shaped && c.types().is_floating(scalar);
        case Constraint::structure: return satisfies_structure(c, env, expr, meta.type, why);
        case Constraint::translator: return false;
        }
    }
    ir::TypeId type = type_of(c, env, constraint);
    if (type == c.types().error) return true;  // reported
    if (meta.kind != MetaKind::value) {
        why = "a value of type " + c.text(type) + " is wanted";
        return false;
    }
    why = "a " + c.text(type) + " is wanted, not a " + c.text(meta.value.type);
    return meta.value.type == type;
}

Arguments::Arguments(Context& context, const ast::Decl& declaration, Env& environment, Span at)
    : context(context), decl(declaration), env(environment), use(at), found(declaration.generics.size()),
      spans(declaration.generics.size(), at), named(declaration.generics.size()) {}

/// Evaluates the argument of a parameter. `known`: the earlier parameters, which the constraint may name.
bool Arguments::take(std::size_t i, const Env& user, ast::ExprId argument, const Env& known, bool quiet) {
    Context& c = context;
    const ast::GenericParam& param = decl.generics[i];
    spans[i] = c[argument].span;
    if (takes_type(c, known, param.constraint)) {
        Meta meta = meta_of(c, user, argument);
        if (meta.kind == MetaKind::none) return false;
        found[i] = std::move(meta);
        return true;
    }
    const ir::TypeId type = type_of(c, known, param.constraint);
    if (type == c.types().error) return false;
    found[i] = enumerator_of(c, type, c[argument]);
    if (found[i]) return true;
    if (names_type(c, user, argument)) {
        if (quiet) return false;
        note(c.error(Diag::type_mismatch, c[argument].span, {c.text(type), "a type"}), decl.name.span,
             "'" + c.text(param.name.name) + "' stands at place " + std::to_string(i + 1));
        return false;
    }
    auto value = constant_of(c, user, argument, type);
    if (value) found[i] = value_meta(std::move(*value));
    return value.has_value();
}

/// Notes an argument `name: value` for finish().
bool Arguments::take_named(const Env& user, const ast::Expr& argument, bool quiet) {
    Context& c = context;
    const std::size_t i = place_of(decl, argument.name);
    if (i == decl.generics.size()) {
        if (quiet) return false;
        std::vector<std::string_view> known;
        for (const ast::GenericParam& generic : decl.generics) known.push_back(c.text(generic.name.name));
        Diagnostic& diagnostic =
            c.error(Diag::generic_name, argument.name_span, {c.text(decl.name.name), c.text(argument.name)});
        const std::string_view meant = did_you_mean(c.text(argument.name), known);
        if (!meant.empty()) note(diagnostic, argument.name_span, "did you mean '" + std::string(meant) + "'?");
        return false;
    }
    if (found[i] || named[i].user) {
        if (!quiet) c.error(Diag::generic_twice, argument.name_span, {c.text(argument.name)});
        return false;
    }
    named[i] = {&user, argument.operands[0]};
    return true;
}

/// Always false.
bool Arguments::report_count(std::size_t most, std::size_t given) const {
    note(context.error(Diag::generic_count, use,
                       {context.text(decl.name.name), std::to_string(most), std::to_string(given)}),
         decl.name.span, "declared here");
    return false;
}

bool Arguments::give(const Env& user, const std::vector<ast::ExprId>& written, std::size_t first, bool quiet) {
    const std::size_t most = decl.named_generics().size(), given = written.size() - first;
    return given > most ? report_count(most, given) : take_all(user, written, first, quiet);
}

bool Arguments::give_all(const Env& user, const std::vector<ast::ExprId>& written) {
    const std::size_t most = decl.generics.size();
    return written.size() > most ? report_count(most, written.size()) : take_all(user, written, 0, false);
}

bool Arguments::take_all(const Env& user, const std::vector<ast::ExprId>& written, std::size_t first, bool quiet) {
    Context& c = context;
    Env known = env;
    for (std::size_t i = 0; i + first < written.size(); ++i) {
        const ast::ExprId argument = written[i + first];
        if (c[argument].kind == ast::ExprKind::named) {
            if (!take_named(user, c[argument], quiet)) return false;
            continue;
        }
        if (decl.generics[i].is_unnamed()) {
            found[i] = meta_of(c, user, argument);
            if (found[i]->kind == MetaKind::none) return false;
            continue;
        }
        if (!decl.generics[i].constraint || !take(i, user, argument, known, quiet)) return false;
        known.bindings.emplace_back(decl.generics[i].name.name, *found[i]);
    }
    return true;
}

bool Arguments::give(std::vector<Meta> metas) {
    for (std::size_t i = 0; i < metas.size() && i < found.size(); ++i) found[i] = std::move(metas[i]);
    return true;
}

void Arguments::infer_value(ast::ExprId pattern, const ir::Value& actual) {
    const auto i = index_of(pattern);
    if (!i || found[*i]) return;
    Meta meta;
    meta.kind = MetaKind::value;
    meta.value = actual;
    found[*i] = std::move(meta);
}

void Arguments::infer_structure(ast::ExprId pattern, ir::StructureId structure) {
    if (!pattern) return;
    infer(pattern, context.types().of_structure(structure));
    // The constraint Structure<D, T> of a parameter also determines D and T.
    const auto i = index_of(pattern);
    if (!i || !decl.generics[*i].constraint) return;
    const ast::Expr& constraint = context[decl.generics[*i].constraint];
    if (constraint.kind != ast::ExprKind::generic) return;
    const ir::Structure instance = context.program.structures[structure];
    if (constraint.operands.size() > 1) infer(constraint.operands[1], instance.domain_type);
    if (constraint.operands.size() > 2) infer(constraint.operands[2], instance.element);
}

std::optional<std::size_t> Arguments::index_of(ast::ExprId type) const {
    if (!type || context[type].kind != ast::ExprKind::name) return std::nullopt;
    for (std::size_t i = 0; i < decl.generics.size(); ++i)
        if (decl.generics[i].name.name == context[type].name) return i;
    return std::nullopt;
}

void Arguments::locate(ast::ExprId type, ast::ExprId argument) {
    const bool is_closure = context[argument].kind == ast::ExprKind::closure;
    const auto i = index_of(type);
    if (i && (decl.generics[*i].is_unnamed() || is_closure)) spans[*i] = context[argument].span;
}

void Arguments::infer(ast::ExprId pattern, ir::TypeId actual) {
    Context& c = context;
    if (!pattern) return;
    const ast::Expr& expr = c[pattern];
    if (expr.kind == ast::ExprKind::name) {
        const auto i = index_of(pattern);
        if (!i || found[*i]) return;
        Meta meta;
        meta.kind = MetaKind::type;
        meta.type = actual;
        found[*i] = std::move(meta);
        return;
    }
    const ir::Type type = c.types()[actual];
    if (expr.kind == ast::ExprKind::optional) {
        infer(expr.operands[0], type.kind == ir::TypeKind::optional ? type.element : actual);
        return;
    }
    if (expr.kind == ast::ExprKind::index && type.kind == ir::TypeKind::array) {
        infer(expr.operands[0], type.element);
        if (expr.operands.size() == 2) infer_value(expr.operands[1], {c.types().uint, {ir::Lane{.bits = type.count}}});
        return;
    }
    if (expr.kind != ast::ExprKind::generic || c[expr.operands[0]].kind != ast::ExprKind::name) return;
    const std::string& name = c.text(c[expr.operands[0]].name);
    if (name == "vec" && expr.operands.size() == 3 &&
        (type.kind == ir::TypeKind::vector || c.types().is_scalar(actual))) {
        infer_value(expr.operands[1], {c.types().uint, {ir::Lane{.bits = c.types().components(actual)}}});
        infer(expr.operands[2], c.types().scalar_of(actual));
        return;
    }
    // The pattern Array<N, T> with an instance of the structure Array, or Pair<A, B> with an instance of the struct
    // Pair.
    const std::vector<Meta>* arguments = nullptr;
    ast::DeclId instance_decl;
    if (type.kind == ir::TypeKind::structure) {
        if (auto at = c.arguments_of.find(type.structure); at != c.arguments_of.end())
            arguments = &at->second, instance_decl = c.structure_decl.at(type.structure);
    } else if (type.kind == ir::TypeKind::struct_) {
        if (auto at = c.struct_arguments.find(type.struct_); at != c.struct_arguments.end())
            arguments = &at->second, instance_decl = c.struct_decl.at(type.struct_);
    }
    if (!arguments || c[instance_decl].name.name != c[expr.operands[0]].name) return;
    for (std::size_t i = 0; i + 1 < expr.operands.size() && i < arguments->size(); ++i) {
        const ast::Expr& written = c[expr.operands[i + 1]];
        const bool is_named = written.kind == ast::ExprKind::named;
        const std::size_t place = is_named ? place_of(c[instance_decl], written.name) : i;
        if (place >= arguments->size()) continue;
        const ast::ExprId part = is_named ? written.operands[0] : expr.operands[i + 1];
        const Meta& meta = (*arguments)[place];
        if (meta.kind == MetaKind::type) infer(part, meta.type);
        if (meta.kind == MetaKind::value) infer_value(part, meta.value);
    }
}

bool Arguments::finish_unnamed(std::size_t i, bool quiet) {
    Context& c = context;
    const ast::GenericParam& param = decl.generics[i];
    if (!found[i] && param.default_value) found[i] = meta_of(c, env, param.default_value);
    if (!found[i] || c.types().kind(found[i]->type) != ir::TypeKind::structure) {
        if (!quiet) c.error(Diag::structure_wanted, spans[i], {c.text(param.parameter)});
        return false;
    }
    std::string why;
    if (param.constraint && !satisfies(c, env, param.constraint, *found[i], why)) {
        if (!quiet)
            note(c.error(Diag::constraint, spans[i],
                         {to_text(c, *found[i]), constraint_text(c, env, param.constraint), why}),
                 param.name.span, "the constraint is declared here");
        return false;
    }
    env.bindings.emplace_back(param.name.name, *found[i]);
    return true;
}

bool Arguments::finish(bool quiet) {
    Context& c = context;
    for (std::size_t i = 0; i < decl.generics.size(); ++i)
        if (found[i] && closure_of(c, found[i]->type) && decl.generics[i].constraint)
            infer_from_result(decl.generics[i].constraint, found[i]->type);
    for (std::size_t i = 0; i < decl.generics.size(); ++i) {
        const ast::GenericParam& param = decl.generics[i];
        if (param.is_unnamed()) {
            if (!finish_unnamed(i, quiet)) return false;
            continue;
        }
        if (!param.constraint) return false;
        if (named[i].user) {
            found[i].reset();
            if (!take(i, *named[i].user, named[i].argument, env, quiet)) return false;
        }
        // A default is evaluated in the declaration's scope, and may name earlier parameters.
        if (!found[i] && param.default_value) {
            if (!take(i, env, param.default_value, env, false)) return false;
            spans[i] = use;
        }
        if (!found[i]) {
            if (!quiet) {
                Diagnostic& diagnostic =
                    c.error(Diag::generic_unknown, use, {c.text(param.name.name), c.text(decl.name.name)});
                note(diagnostic, param.name.span, "declared here; write it: " + c.text(decl.name.name) + "<…>");
            }
            return false;
        }
        std::string why;
        if (found[i]->kind == MetaKind::format && !satisfies(c, env, param.constraint, *found[i], why))
            found[i] = as_type(c, *found[i]);
        if (!satisfies(c, env, param.constraint, *found[i], why)) {
            if (!quiet) {
                const std::string what = closure_of(c, found[i]->type) ? "this closure" : to_text(c, *found[i]);
                Diagnostic& diagnostic = c.error(Diag::constraint, spans[i], {what, c.text(param.name.name), why});
                note(diagnostic, param.name.span, "the constraint is declared here");
                note_interface(c, env, param.constraint, diagnostic);
            }
            return false;
        }
        env.bindings.emplace_back(param.name.name, *found[i]);
    }
    env.shown = decl.generics.size();
    while (env.shown > 0 && is_default(env.shown - 1)) --env.shown;
    return true;
}

/// Whether the argument is the parameter's default. Defaults that are longer than a name or a number count as others.
bool Arguments::is_default(std::size_t i) {
    const ast::GenericParam& param = decl.generics[i];
    if (!param.default_value || param.is_unnamed()) return false;
    using enum ast::ExprKind;
    const ast::ExprKind kind = context[param.default_value].kind;
    const bool is_short = kind == name || kind == member || kind == generic || kind == int_literal ||
                          kind == bool_literal || kind == none_literal;
    if (!is_short) return false;
    const Meta given = *found[i];
    const bool is_it = take(i, env, param.default_value, env, true) && same(*found[i], given);
    found[i] = given;
    return is_it;
}

void infer_from_literal(Arguments& arguments, ast::ExprId pattern, ast::ExprId literal) {
    if (is_flexible(arguments.context, literal)) arguments.infer(pattern, own_type(arguments.context, literal));
}

}  // namespace gliftc::sema
