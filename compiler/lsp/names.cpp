#include "lsp/names.h"

#include <algorithm>
#include <set>

namespace gliftc::lsp {

namespace {

Span span_of(const Token& token) { return {0, token.begin, token.end}; }

/// The index of the token in the document's list.
std::size_t index_of(const Analysis& analysis, const Token& token) {
    return static_cast<std::size_t>(&token - analysis.tokens.tokens.data());
}

bool follows_dot(const Analysis& analysis, const Token& token) {
    const std::size_t index = index_of(analysis, token);
    return index > 0 && analysis.tokens.tokens[index - 1].kind == TokenKind::dot;
}

/// Whether the token names an argument, as `x` in `Point(x: 1.0)`, or a parameter.
bool is_label(const Analysis& analysis, const Token& token) {
    const std::vector<Token>& tokens = analysis.tokens.tokens;
    const std::size_t index = index_of(analysis, token);
    if (index == 0 || index + 1 >= tokens.size() || tokens[index + 1].kind != TokenKind::colon) return false;
    using enum TokenKind;
    const TokenKind before = tokens[index - 1].kind;
    return before == open_paren || before == comma || before == open_brace;
}

/// The places that the index has for the name: chosen overloads if there are any.
std::vector<Span> recorded(const sema::Index& index, Span name) {
    auto use =
        std::ranges::lower_bound(index.uses, name.begin, {}, [](const sema::NameUse& u) { return u.name.begin; });
    std::vector<Span> visible, chosen;
    for (; use != index.uses.end() && use->name.begin == name.begin; ++use) {
        if (use->name != name) continue;
        std::vector<Span>& list = use->is_chosen ? chosen : visible;
        if (std::ranges::find(list, use->declared) == list.end()) list.push_back(use->declared);
    }
    return chosen.empty() ? visible : chosen;
}

/// The name in the header of the module that a `use` at the token imports; empty if the token is in no `use`.
std::vector<Span> imported_module(const Analysis& analysis, const Token& token) {
    if (analysis.module == nullptr) return {};
    const LoadedModules& loaded = analysis.compilation.loaded;
    for (const sema::LoadedModule& module : loaded.modules) {
        if (module.tree != analysis.module) continue;
        for (std::size_t i = 0; i < module.uses.size(); ++i) {
            const Span path = analysis.module->uses[i].span;
            if (token.begin < path.begin || token.end > path.end || !module.uses[i]) continue;
            const ast::Module& imported = *loaded.modules[module.uses[i]].tree;
            return {imported.name.span ? imported.name.span : Span{imported.file, 0, 0}};
        }
    }
    return {};
}

bool contains(Span scope, std::size_t offset) { return scope && scope.begin <= offset && offset <= scope.end; }

/// Adds the public declarations of a module.
void add_public(const Analysis& analysis, const ast::Module& module, std::vector<const Entity*>& list) {
    for (const Entity& entity : analysis.entities(module.file))
        if (entity.is_pub && entity.parent == Entity::none) list.push_back(&entity);
}

std::string_view name_of(const Analysis& analysis, const Entity& entity) {
    return analysis.compilation.names[entity.name.name];
}

}  // namespace

bool is_name(const Token& token) { return token.kind == TokenKind::identifier; }

const Token* token_at(const Analysis& analysis, std::size_t offset) {
    const std::vector<Token>& tokens = analysis.tokens.tokens;
    const auto after = std::ranges::upper_bound(tokens, offset, {}, &Token::begin);
    if (after == tokens.begin()) return nullptr;
    const Token& found = *(after - 1);
    if (offset < found.end) return &found;
    if (found.end == offset && is_name(found)) return &found;
    if (found.begin == offset && after - 1 != tokens.begin() && (after - 2)->end == offset && is_name(*(after - 2)))
        return &*(after - 2);
    return nullptr;
}

std::vector<Span> declarations_of(const Analysis& analysis, const Token& token) {
    if (auto module = imported_module(analysis, token); !module.empty()) return module;
    if (!is_name(token)) return {};
    if (auto found = recorded(analysis.index(), span_of(token)); !found.empty()) return found;
    if (analysis.entity_at(span_of(token)) != nullptr) return {span_of(token)};
    if (follows_dot(analysis, token) || is_label(analysis, token)) return {};
    std::vector<Span> declared;
    for (const Entity* entity : visible_by_name(analysis, token.begin, analysis.text(token)))
        declared.push_back(entity->name.span);
    return declared;
}

std::vector<const Entity*> visible_at(const Analysis& analysis, std::size_t offset) {
    std::vector<const Entity*> list;
    if (analysis.module == nullptr) return list;
    for (const Entity& entity : analysis.entities(0))
        if (entity.name.name && contains(entity.scope, offset)) list.push_back(&entity);
    std::ranges::stable_sort(list, std::ranges::greater{}, [](const Entity* entity) { return entity->scope.begin; });
    const LoadedModules& loaded = analysis.compilation.loaded;
    for (const sema::LoadedModule& module : loaded.modules) {
        if (module.tree != analysis.module) continue;
        std::set<ir::ModuleId> seen;
        for (const auto* imports : {&module.uses, &module.prelude})
            for (ir::ModuleId import : *imports)
                if (import && seen.insert(import).second) add_public(analysis, *loaded.modules[import].tree, list);
    }
    return list;
}

std::vector<const Entity*> visible_by_name(const Analysis& analysis, std::size_t offset, std::string_view name) {
    std::vector<const Entity*> found;
    for (const Entity* entity : visible_at(analysis, offset)) {
        if (name_of(analysis, *entity) != name) continue;
        const bool is_inner = !found.empty() && found.front()->name.span.file == entity->name.span.file &&
                              found.front()->scope.begin == entity->scope.begin;
        if (found.empty() || (is_callable(entity->kind) && (is_inner || found.front()->name.span.file != 0)))
            found.push_back(entity);
    }
    return found;
}

std::vector<const Entity*> parts_of(const Analysis& analysis, const Entity& whole) {
    const std::vector<Entity>& entities = analysis.entities(whole.name.span.file);
    const auto index = static_cast<std::uint32_t>(&whole - entities.data());
    std::vector<const Entity*> parts;
    for (const Entity& entity : entities)
        if (entity.parent == index) parts.push_back(&entity);
    return parts;
}

ir::TypeId type_of_declared(const Analysis& analysis, Span name) {
    const auto& types = analysis.index().types;
    auto typed =
        std::ranges::lower_bound(types, name.end, {}, [](const sema::TypedSpan& each) { return each.span.end; });
    for (; typed != types.end() && typed->span.end == name.end; ++typed)
        if (typed->span == name) return typed->type;
    return {};
}

std::optional<sema::TypedSpan> type_at(const Analysis& analysis, const Token& token) {
    const auto& types = analysis.index().types;
    auto typed =
        std::ranges::lower_bound(types, token.end, {}, [](const sema::TypedSpan& each) { return each.span.end; });
    std::optional<sema::TypedSpan> best;
    for (; typed != types.end() && typed->span.end == token.end; ++typed) {
        const bool is_near = typed->span.begin <= token.begin && (!best || typed->span.begin > best->span.begin);
        if (is_near) best = *typed;
    }
    return best;
}

}  // namespace gliftc::lsp
