#include "sema/names/unknown_names.h"

#include "sema/names/lookup.h"
#include "syntax/habits.h"

#include <algorithm>

namespace gliftc::sema {

std::string suggestion_for(Context& c, const Env& env, std::string_view name,
                           const std::vector<std::string_view>& more) {
    std::vector<std::string_view> candidates = more;
    for (const auto& [bound, meta] : env.bindings) candidates.push_back(c.text(bound));
    for (const auto& [declared, decls] : c.scopes[env.module].names) candidates.push_back(c.text(declared));
    const ModuleScope& scope = c.scopes[env.module];
    for (const auto* modules : {&scope.imports, &scope.prelude})
        for (ir::ModuleId import : *modules)
            for (const auto& [declared, decls] : c.scopes[import].names)
                if (c[decls[0]].is_pub) candidates.push_back(c.text(declared));
#define INTRINSIC(name, signature, exactness) candidates.push_back(#name);
#include "ir/intrinsics.def"
#undef INTRINSIC
    for (std::string_view type : {"bool", "int", "uint", "float", "float2", "float3", "float4", "uint2", "uint3",
                                  "uint4", "int2", "int3", "int4"})
        candidates.push_back(type);
    std::sort(candidates.begin(), candidates.end());
    return std::string(did_you_mean(name, candidates));
}

/// A module that declares the name as public: a loaded one, else one that could be imported. Empty if there is none.
static std::string module_with(const Context& c, Name name) {
    for (ir::ModuleId i : c.scopes.ids()) {
        auto found = c.scopes[i].names.find(name);
        if (found != c.scopes[i].names.end() && c[found->second[0]].is_pub) return c.text(c.modules[i].tree->name.name);
    }
    return c.settings.module_with ? c.settings.module_with(c.text(name)) : std::string();
}

void report_unknown(Context& c, const Env& env, ast::Identifier name, const std::vector<std::string_view>& more) {
    Diagnostic& diagnostic = c.error(Diag::unknown_name, name.span, {c.text(name.name)});
    if (std::string hint = hint_for_name(c.text(name.name)); !hint.empty()) {
        note(diagnostic, name.span, hint);
        return;
    }
    if (std::string module = module_with(c, name.name); !module.empty()) {
        note(diagnostic, name.span, "module " + module + " has it: 'use " + module + ";'");
        return;
    }
    std::string meant = suggestion_for(c, env, c.text(name.name), more);
    if (!meant.empty()) note(diagnostic, name.span, "did you mean '" + meant + "'?");
}

}  // namespace gliftc::sema
