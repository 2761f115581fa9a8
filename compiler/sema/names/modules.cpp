// The declarations and imports of each module.
#include "sema/names/modules.h"

#include "sema/names/lookup.h"

#include <set>

namespace gliftc::sema {

namespace {

void own_members(Context& c, ast::DeclId id, ir::ModuleId module);

void own_items(Context& c, const std::vector<ast::Item>& items, ir::ModuleId module) {
    for (const ast::Item& item : items) {
        if (item.decl) own_members(c, item.decl, module);
        own_items(c, item.body, module);
        own_items(c, item.alternative, module);
    }
}

/// Reports duplicate names in a list.
template <class Things> void report_duplicates(Context& c, const Things& things) {
    for (std::size_t i = 0; i < things.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (things[i].name.name == things[k].name.name && things[i].name.name) {
                note(c.error(Diag::duplicate_name, things[i].name.span, {c.text(things[i].name.name)}),
                     things[k].name.span, "first declared here");
                break;
            }
}

/// Reports attributes of a declaration that takes none: only translators and kernels do, which check theirs themselves.
void report_attributes(Context& c, const ast::Decl& decl) {
    if (std::holds_alternative<ast::Translator>(decl.body) || std::holds_alternative<ast::Kernel>(decl.body)) return;
    for (const ast::Attribute& attribute : decl.attributes)
        note(c.error(Diag::unknown_attribute, attribute.span, {c.text(attribute.name.name)}), attribute.span,
             "only translators and kernels have attributes");
}

void own_members(Context& c, ast::DeclId id, ir::ModuleId module) {
    c.module_of[id] = module;
    report_attributes(c, c[id]);
    report_duplicates(c, c[id].named_generics());
    const auto& body = c[id].body;
    if (auto* translator = std::get_if<ast::Translator>(&body)) {
        report_duplicates(c, translator->fields);
        std::vector<ast::Decl> methods;
        for (ast::DeclId method : translator->methods) {
            own_members(c, method, module);
            methods.push_back(c[method]);
        }
        report_duplicates(c, methods);
    }
    if (auto* interface = std::get_if<ast::Interface>(&body))
        for (ast::DeclId member : interface->members) own_members(c, member, module);
    if (auto* structure = std::get_if<ast::Structure>(&body)) own_items(c, structure->items, module);
}

void declare(Context& c, ModuleScope& scope, ast::DeclId id) {
    const ast::Decl& decl = c[id];
    if (!decl.name.name || std::holds_alternative<ast::KernelInstances>(decl.body)) return;  // not called by name
    auto& same = scope.names[decl.name.name];
    const bool are_functions = is_function(c, {id}) && is_function(c, same);
    if (!same.empty() && !are_functions && !(is_pass(c, {id}) && is_pass(c, same))) {
        note(c.error(Diag::duplicate_name, decl.name.span, {c.text(decl.name.name)}), c[same[0]].name.span,
             "first declared here");
        return;
    }
    same.push_back(id);
}

/// The modules that a module uses, transitively; sorted.
std::vector<ir::ModuleId> reached_from(const ModuleTable& modules, ir::ModuleId from) {
    std::set<ir::ModuleId> reached;
    std::vector<ir::ModuleId> next = {from};
    while (!next.empty()) {
        const ir::ModuleId module = next.back();
        next.pop_back();
        for (const auto* list : {&modules[module].uses, &modules[module].prelude})
            for (ir::ModuleId use : *list)
                if (use && reached.insert(use).second) next.push_back(use);
    }
    return {reached.begin(), reached.end()};
}

}  // namespace

void collect_modules(Context& c) {
    c.scopes.resize(c.modules.size());
    for (ir::ModuleId i : c.modules.ids()) {
        const LoadedModule& loaded = c.modules[i];
        ir::Module module;
        module.name = loaded.tree->name.name;
        module.file = loaded.tree->file;
        module.is_root = loaded.is_root;
        module.doc = loaded.tree->doc;
        module.imports = reached_from(c.modules, i);
        c.program.modules.push_back(std::move(module));
        for (ir::ModuleId use : loaded.uses)
            if (use) c.scopes[i].imports.push_back(use);
        c.scopes[i].prelude = loaded.prelude;
        for (ast::DeclId decl : loaded.tree->decls) {
            own_members(c, decl, i);
            declare(c, c.scopes[i], decl);
        }
    }
}

}  // namespace gliftc::sema
