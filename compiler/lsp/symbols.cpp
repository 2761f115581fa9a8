#include "lsp/features.h"
#include "lsp/positions.h"

namespace gliftc::lsp {

namespace {

/// The protocol's number of a symbol's kind.
int symbol_kind(EntityKind kind) {
    switch (kind) {
    case EntityKind::function: return 12;
    case EntityKind::kernel:
    case EntityKind::raster: return 12;
    case EntityKind::pipeline: return 6;
    case EntityKind::test: return 24;
    case EntityKind::structure: return 5;
    case EntityKind::translator: return 25;
    case EntityKind::struct_: return 23;
    case EntityKind::enum_: return 10;
    case EntityKind::interface: return 11;
    case EntityKind::alias: return 5;
    case EntityKind::constant: return 14;
    case EntityKind::field:
    case EntityKind::memory:
    case EntityKind::member:
    case EntityKind::host_state: return 8;
    case EntityKind::enumerator: return 22;
    case EntityKind::generic: return 26;
    case EntityKind::parameter:
    case EntityKind::variable: return 13;
    }
    return 13;
}

bool is_shown(EntityKind kind) {
    return kind != EntityKind::generic && kind != EntityKind::parameter && kind != EntityKind::variable;
}

/// The symbols whose parent is `parent`, with their own parts.
nlohmann::json symbols_of(const Analysis& analysis, std::uint32_t parent) {
    const std::vector<Entity>& entities = analysis.entities(0);
    const Sources& sources = analysis.compilation.sources;
    nlohmann::json list = nlohmann::json::array();
    for (std::uint32_t i = 0; i < entities.size(); ++i) {
        const Entity& entity = entities[i];
        if (entity.parent != parent || !is_shown(entity.kind)) continue;
        const std::string& own = analysis.compilation.names[entity.name.name];
        const std::string name = entity.kind == EntityKind::test ? "test \"" + entity.title + "\"" : own;
        if (name.empty()) continue;  // a syntax error where the name should stand
        const Span selected = entity.name.name ? entity.name.span : Span{0, entity.written.begin, entity.written.begin};
        nlohmann::json symbol = {{"name", name},
                                 {"kind", symbol_kind(entity.kind)},
                                 {"range", range_of(sources, join(entity.written, selected))},
                                 {"selectionRange", range_of(sources, selected)}};
        if (entity.kind != EntityKind::test) symbol["detail"] = header_of(entity, analysis.text());
        if (nlohmann::json parts = symbols_of(analysis, i); !parts.empty()) symbol["children"] = std::move(parts);
        list.push_back(std::move(symbol));
    }
    return list;
}

}  // namespace

nlohmann::json document_symbols(Workspace& workspace, const nlohmann::json& params) {
    return symbols_of(analysis_in(workspace, params), Entity::none);
}

}  // namespace gliftc::lsp
