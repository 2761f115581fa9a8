// Names and keys of instances.
#include "sema/types/generics.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

std::string key_part(const Meta& meta) {
    std::string key;
    switch (meta.kind) {
    case MetaKind::type: return "t" + std::to_string(meta.type.index);
    case MetaKind::value:
        key = "v" + std::to_string(meta.value.type.index);
        for (const ir::Lane& lane : meta.value.lanes)
            key += "," + std::to_string(lane.bits) + "f" + std::to_string(std::bit_cast<std::uint64_t>(lane.number));
        return key;
    case MetaKind::translator:
        key = "r";
        for (ir::TranslatorId i : meta.translators) key += std::to_string(i.index) + ",";
        return key;
    case MetaKind::format: return "x" + std::to_string(static_cast<int>(meta.format));
    case MetaKind::none:
    case MetaKind::declarations:
    case MetaKind::module:
    case MetaKind::memory_shape:
    case MetaKind::constraint:
    case MetaKind::running: return "?";
    }
    return key;
}

}  // namespace

std::string display_of(const Context& c, const ast::Decl& decl, const Env& env) {
    std::string text = c.text(decl.name.name);
    const std::size_t shown = std::min(decl.generics.size(), env.shown);
    if (shown == 0) return text;
    text += "<";
    for (std::size_t i = 0; i < shown; ++i) {
        const Meta* meta = env.find(decl.generics[i].name.name);
        text += (i ? ", " : "") + (meta ? to_text(c, *meta) : c.text(decl.generics[i].name.name));
    }
    return text + ">";
}

std::string qualified_display_of(const Context& c, ast::DeclId id, const Env& env) {
    const ast::Decl& decl = c[id];
    std::string text = ir::module_text(c.program, c.module_of.at(id)) + c.text(decl.name.name);
    const std::size_t shown = std::min(decl.generics.size(), env.shown);
    if (shown == 0) return text;
    text += "<";
    for (std::size_t i = 0; i < shown; ++i) {
        const Meta* meta = env.find(decl.generics[i].name.name);
        text += (i ? ", " : "") + (meta ? to_qualified_text(c, *meta) : c.text(decl.generics[i].name.name));
    }
    return text + ">";
}

std::string key_of(const Context&, ast::DeclId id, const Env& env) {
    std::string key = std::to_string(id.index);
    for (const auto& [name, meta] : env.bindings) key += ":" + key_part(meta);
    return key;
}

}  // namespace gliftc::sema
