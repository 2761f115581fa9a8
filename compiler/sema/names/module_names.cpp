// Names behind a module's name: `std.array.Array`, `array.Array`.
#include "sema/names/lookup.h"
#include "sema/names/record.h"
#include "sema/names/unknown_names.h"
#include "sema/types/meta.h"

namespace gliftc::sema {

ir::ModuleId module_by_whole_name(Context& c, const Env& env, ast::ExprId id) {
    std::string text;
    for (; c[id].kind == ast::ExprKind::member; id = c[id].operands[0]) text = "." + c.text(c[id].name) + text;
    if (c[id].kind != ast::ExprKind::name) return {};
    text = c.text(c[id].name) + text;
    for (ir::ModuleId import : c.scopes[env.module].imports) {
        if (c.text(c.modules[import].tree->name.name) != text) continue;
        const MetaKind first = find_meta(c, env, {c[id].name, c[id].span}).kind;
        if (first == MetaKind::none || first == MetaKind::module) return import;
    }
    return {};
}

Meta find_in_module(Context& c, const Env& env, ir::ModuleId module, ast::Identifier name) {
    Meta meta;
    const auto& names = c.scopes[module].names;
    const auto found = names.find(name.name);
    if (found == names.end()) {
        Env inside;
        inside.module = module;
        report_unknown(c, inside, name);
        return meta;
    }
    meta.kind = MetaKind::declarations;
    for (ast::DeclId decl : found->second)
        if (c[decl].is_pub || module == env.module) meta.declarations.push_back(decl);
    if (meta.declarations.empty()) {
        report_private(c, name, found->second[0]);
        meta.declarations = found->second;
    }
    record_uses(c, name.span, meta.declarations);
    return meta;
}

}  // namespace gliftc::sema
