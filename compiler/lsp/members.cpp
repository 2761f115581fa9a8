#include "lsp/members.h"

#include "ir/evaluate.h"
#include "lsp/builtins.h"
#include "lsp/names.h"

#include <algorithm>

namespace gliftc::lsp {

namespace {

int completion_kind(EntityKind kind) {
    switch (kind) {
    case EntityKind::function:
    case EntityKind::kernel:
    case EntityKind::raster:
    case EntityKind::pipeline:
    case EntityKind::test: return 3;
    case EntityKind::structure:
    case EntityKind::translator:
    case EntityKind::alias: return 7;
    case EntityKind::struct_: return 22;
    case EntityKind::enum_: return 13;
    case EntityKind::interface: return 8;
    case EntityKind::constant: return 21;
    case EntityKind::field:
    case EntityKind::memory:
    case EntityKind::member:
    case EntityKind::host_state: return 5;
    case EntityKind::enumerator: return 20;
    case EntityKind::generic: return 25;
    case EntityKind::parameter:
    case EntityKind::variable: return 6;
    }
    return 6;
}

constexpr int field_kind = 5, method_kind = 2;

class Members {
public:
    explicit Members(const Analysis& analysis) : analysis_(analysis), program_(analysis.compilation.program) {}

    std::vector<Suggestion> found;

    void add_module(ir::ModuleId module) {
        const LoadedModules& loaded = analysis_.compilation.loaded;
        for (const Entity& entity : analysis_.entities(loaded.modules[module].tree->file))
            if (entity.is_pub && entity.parent == Entity::none) found.push_back(suggestion_of(analysis_, entity));
    }

    void add_type(ir::TypeId id) {
        const ir::Type& type = program_.types[id];
        switch (type.kind) {
        case ir::TypeKind::struct_: add_fields(program_.structs[type.struct_]); break;
        case ir::TypeKind::enum_: add_parts(program_.enums[type.enum_].span); break;
        case ir::TypeKind::structure: add_structure(program_.structures[type.structure]); break;
        case ir::TypeKind::slice: add_methods(); break;
        case ir::TypeKind::vector: add_lanes(type); break;
        default: break;
        }
    }

    void add_parts(Span declared) {
        const Entity* whole = analysis_.entity_at(declared);
        if (whole == nullptr) return;
        for (const Entity* part : parts_of(analysis_, *whole)) {
            const bool is_member = part->kind != EntityKind::generic && part->name.name;
            if (is_member) found.push_back(suggestion_of(analysis_, *part));
        }
    }

private:
    void add(const std::string& name, const std::string& detail, const std::string& doc, int kind) {
        found.push_back({name, detail, doc, kind, nullptr});
    }

    void add_fields(const ir::Struct& record) {
        for (const ir::StructField& field : record.fields)
            add(analysis_.compilation.names[field.name], to_text(program_, field.type), field.doc, field_kind);
    }

    void add_lanes(const ir::Type& vector) {
        const std::string element = to_text(program_, vector.element);
        for (std::size_t i = 0; i < vector.count; ++i) add(std::string(1, "xyzw"[i]), element, {}, field_kind);
    }

    void add_methods() {
        for (std::string_view name : structure_methods()) add(std::string(name), "of every structure", {}, method_kind);
    }

    void add_structure(const ir::Structure& structure) {
        add_parts(structure.span);
        if (structure.kind == ir::StructureKind::no_elements) return;
        const ir::Type& element = program_.types[structure.element];
        if (element.kind == ir::TypeKind::struct_) add_fields(program_.structs[element.struct_]);
        add_methods();
    }

    const Analysis& analysis_;
    const ir::Program& program_;
};

/// The longest of the typed expressions that end at the byte.
const sema::TypedSpan* typed_before(const Analysis& analysis, std::size_t end) {
    const sema::TypedSpan* best = nullptr;
    const auto& types = analysis.index().types;
    auto typed = std::ranges::lower_bound(types, end, {}, [](const sema::TypedSpan& each) { return each.span.end; });
    for (; typed != types.end() && typed->span.end == end; ++typed)
        if (best == nullptr || typed->span.begin < best->span.begin) best = &*typed;
    return best;
}

}  // namespace

Suggestion suggestion_of(const Analysis& analysis, const Entity& entity) {
    const Compilation& c = analysis.compilation;
    std::string detail = header_of(entity, c.sources[entity.name.span.file].text);
    if (entity.kind == EntityKind::variable) {
        const ir::TypeId type = type_of_declared(analysis, entity.name.span);
        detail = type ? to_text(c.program, type) : std::string();
    }
    return {c.names[entity.name.name], std::move(detail), entity.doc, completion_kind(entity.kind), &entity};
}

std::vector<Suggestion> members_before(const Analysis& analysis, std::size_t end) {
    Members members(analysis);
    if (const sema::TypedSpan* typed = typed_before(analysis, end)) {
        if (typed->module) members.add_module(typed->module);
        else if (typed->type) members.add_type(typed->type);
        return std::move(members.found);
    }
    if (const Token* token = token_at(analysis, end))
        for (Span declared : declarations_of(analysis, *token))
            if (const Entity* entity = analysis.entity_at(declared); entity && entity->kind == EntityKind::enum_)
                members.add_parts(declared);
    return std::move(members.found);
}

}  // namespace gliftc::lsp
