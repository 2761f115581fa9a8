#include "driver/explain_structures.h"
#include "ir/evaluate.h"
#include "layout/layout.h"
#include "lsp/builtins.h"
#include "lsp/features.h"
#include "lsp/names.h"
#include "lsp/positions.h"

namespace gliftc::lsp {

namespace {

std::string code_block(const std::string& code) { return "```glift\n" + code + "\n```\n"; }

/// `what: value`, a line of a list in Markdown.
std::string item(const std::string& what, const std::string& value) { return "- " + what + ": " + value + "\n"; }

std::string about_translator(const ExplainedTranslator& translator) {
    return item("translator", "`" + translator.name + " : " + translator.from + " -> " + translator.to + "`, " +
                                  translator.totality + ", " + translator.mapping) +
           "  - memory " + translator.memory + "; access " + translator.access + ", " + translator.consistency +
           "; invertible: " + translator.invertible + "; on " + translator.location + "\n";
}

std::string about_structure(const Compilation& c, const ir::Structure& structure) {
    const ExplainedStructure known = explained(c, structure);
    std::string text = "\n" + known.kind + " `" + known.type + "`\n\n";
    if (!known.elements.empty()) {
        const std::string size = std::to_string(layout::size_of(c.program, structure.element).size);
        text +=
            item("addresses", "`" + known.addresses + "`") +
            item("elements", "`" + known.elements + "`, " + (known.kind == "view" ? "computed" : size + " bytes each"));
    }
    for (const auto& [what, how] : known.parts) text += item(what, how);
    for (const auto& [name, shape] : known.memories) text += item("memory " + name, shape);
    if (!known.blocks.empty()) text += item("blocks", known.blocks);
    for (const ExplainedTranslator& translator : known.via) text += about_translator(translator);
    return text;
}

/// What is known of the type beyond its name: of a structure its properties, of a struct its size.
std::string about_type(const Compilation& c, ir::TypeId id) {
    const ir::Type& type = c.program.types[id];
    // After errors the program is not complete: nothing may be evaluated.
    if (c.diagnostics.has_errors()) return {};
    if (type.kind == ir::TypeKind::structure) return about_structure(c, c.program.structures[type.structure]);
    if (type.kind == ir::TypeKind::struct_)
        return "\n" + std::to_string(layout::size_of(c.program, id).size) + " bytes in memory\n";
    return {};
}

bool has_own_type(EntityKind kind) {
    return kind == EntityKind::variable || kind == EntityKind::parameter || kind == EntityKind::member ||
           kind == EntityKind::memory;
}

std::string declaration_text(const Analysis& analysis, const Entity& entity,
                             const std::optional<sema::TypedSpan>& typed) {
    const Compilation& c = analysis.compilation;
    if (entity.kind == EntityKind::variable) {
        const std::string type = typed && typed->type ? ": " + ir::to_text(c.program, typed->type) : std::string();
        return c.names[entity.name.name] + type;
    }
    return header_of(entity, c.sources[entity.name.span.file].text);
}

std::string about_entity(const Analysis& analysis, const Entity& entity, const std::optional<sema::TypedSpan>& typed) {
    const Compilation& c = analysis.compilation;
    std::string text = code_block(declaration_text(analysis, entity, typed));
    const bool names_type = entity.kind == EntityKind::alias || entity.kind == EntityKind::structure ||
                            entity.kind == EntityKind::struct_ || has_own_type(entity.kind);
    if (typed && typed->type) {
        const std::string type = ir::to_text(c.program, typed->type);
        if (has_own_type(entity.kind) && entity.kind != EntityKind::variable) text += "\n`" + type + "`\n";
        if (names_type) text += about_type(c, typed->type);
    }
    if (!entity.doc.empty()) text += "\n" + entity.doc + "\n";
    return text;
}

std::string about_module(const Analysis& analysis, std::uint32_t file) {
    for (const ast::Module& module : analysis.compilation.loaded.trees)
        if (module.file == file)
            return code_block("module " + analysis.compilation.names[module.name.name]) + "\n" + module.doc + "\n";
    return {};
}

/// What the language itself says of the word; empty if it is none of its own.
std::string about_builtin(std::string_view word) {
    if (const BuiltinFunction* function = find_builtin_function(word)) return code_block(function->signature());
    for (const Pattern& pattern : patterns())
        if (pattern.name == word) return "`" + std::string(word) + "`: " + std::string(pattern.text) + "\n";
    return {};
}

std::string about(const Analysis& analysis, const Token& token) {
    std::optional<sema::TypedSpan> typed;
    if (is_name(token)) typed = type_at(analysis, token);
    std::string text;
    for (Span declared : declarations_of(analysis, token)) {
        const Entity* entity = analysis.entity_at(declared);
        if (!text.empty()) text += "\n---\n";
        text += entity != nullptr ? about_entity(analysis, *entity, typed) : about_module(analysis, declared.file);
    }
    if (!text.empty()) return text;
    if (typed && typed->module)
        return about_module(analysis, analysis.compilation.loaded.modules[typed->module].tree->file);
    if (std::string builtin = about_builtin(analysis.text(token)); !builtin.empty()) return builtin;
    if (typed && typed->type) return code_block(ir::to_text(analysis.compilation.program, typed->type));
    return {};
}

}  // namespace

nlohmann::json hover(Workspace& workspace, const nlohmann::json& params) {
    const Place place = place_in(workspace, params);
    if (place.token == nullptr) return nullptr;
    const std::string text = about(place.analysis, *place.token);
    if (text.empty()) return nullptr;
    return {{"contents", {{"kind", "markdown"}, {"value", text}}},
            {"range", range_of(place.analysis.text(), place.token->begin, place.token->end)}};
}

}  // namespace gliftc::lsp
