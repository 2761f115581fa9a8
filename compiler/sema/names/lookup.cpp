#include "sema/names/lookup.h"

#include "sema/bodies/closures.h"
#include "sema/names/record.h"
#include "sema/types/meta.h"

#include <algorithm>
#include <utility>

namespace gliftc::sema {

namespace {

bool contains(const std::vector<ast::DeclId>& list, ast::DeclId decl) {
    return std::find(list.begin(), list.end(), decl) != list.end();
}

/// The module that declares the struct or enum that the type is, or is an array or optional of.
ir::ModuleId home_of(const Context& c, ir::TypeId id) {
    const ir::Type& type = c.program.types[id];
    switch (type.kind) {
    case ir::TypeKind::struct_: return c.program.structs[type.struct_].module;
    case ir::TypeKind::enum_: return c.program.enums[type.enum_].module;
    case ir::TypeKind::array:
    case ir::TypeKind::optional: return home_of(c, type.element);
    case ir::TypeKind::error:
    case ir::TypeKind::void_:
    case ir::TypeKind::bool_:
    case ir::TypeKind::int_:
    case ir::TypeKind::uint:
    case ir::TypeKind::float_:
    case ir::TypeKind::half:
    case ir::TypeKind::double_:
    case ir::TypeKind::int64:
    case ir::TypeKind::uint64:
    case ir::TypeKind::vector:
    case ir::TypeKind::matrix:
    case ir::TypeKind::structure:
    case ir::TypeKind::slice:
    case ir::TypeKind::device: break;
    }
    return {};
}

/// Reports that two imports declare the name; the message does not depend on the order of the imports. Returns the
/// declaration with which checking goes on.
ast::DeclId report_ambiguous(Context& c, ast::Identifier name, ast::DeclId one, ast::DeclId other) {
    const auto module_of = [&](ast::DeclId decl) -> const std::string& {
        return c.text(c.modules[c.module_of.at(decl)].tree->name.name);
    };
    if (module_of(other) < module_of(one)) std::swap(one, other);
    const std::string &first = module_of(one), &second = module_of(other), &text = c.text(name.name);
    Diagnostic& diagnostic = c.error(Diag::ambiguous_name, name.span, {text, first, second});
    note(diagnostic, c[one].name.span, "one is declared here");
    note(diagnostic, c[other].name.span, "another here");
    const auto last = [](const std::string& module) { return module.substr(module.rfind('.') + 1); };
    const bool are_apart = last(first) != last(second);
    note(diagnostic, name.span,
         "write '" + (are_apart ? last(first) : first) + "." + text + "' or '" + (are_apart ? last(second) : second) +
             "." + text + "'");
    return one;
}

}  // namespace

void report_private(Context& c, ast::Identifier name, ast::DeclId declared) {
    std::string_view owner = c.text(c.modules[c.module_of.at(declared)].tree->name.name);
    note(c.error(Diag::not_public, name.span, {c.text(name.name), owner}), c[declared].name.span,
         "write 'pub' before it to export it");
}

bool is_function(const Context& c, const std::vector<ast::DeclId>& declarations) {
    return !declarations.empty() && std::holds_alternative<ast::Function>(c[declarations[0]].body);
}

bool is_pass(const Context& c, const std::vector<ast::DeclId>& declarations) {
    return !declarations.empty() && (std::holds_alternative<ast::Kernel>(c[declarations[0]].body) ||
                                     std::holds_alternative<ast::Pipeline>(c[declarations[0]].body));
}

bool some_module_has_function(const Context& c, Name name) {
    for (const ModuleScope& scope : c.scopes)
        if (auto found = scope.names.find(name); found != scope.names.end() && is_function(c, found->second))
            return true;
    const auto has_call = [&](const auto& closure) {
        return std::ranges::find(closure.second.calls, name, &ClosureType::Call::name) != closure.second.calls.end();
    };
    return std::ranges::any_of(c.closures, has_call);
}

/// What the modules declare under the name.
static Visible look_in(Context& c, const std::vector<ir::ModuleId>& modules, ast::Identifier name) {
    Visible visible;
    ir::ModuleId from;
    for (ir::ModuleId import : modules) {
        auto names = c.scopes[import].names.find(name.name);
        if (names == c.scopes[import].names.end()) continue;
        for (ast::DeclId decl : names->second) {
            if (!c[decl].is_pub) {
                visible.hidden.push_back(decl);
                continue;
            }
            if (contains(visible.found, decl)) continue;  // imported twice
            const bool are_overloads = (is_function(c, {decl}) && is_function(c, visible.found)) ||
                                       (is_pass(c, {decl}) && is_pass(c, visible.found));
            if (!visible.found.empty() && from != import && !are_overloads) {
                const ast::DeclId kept = report_ambiguous(c, name, visible.found[0], decl);
                visible.found.push_back(decl);
                std::erase_if(visible.found,
                              [&](ast::DeclId other) { return c.module_of.at(other) != c.module_of.at(kept); });
                return visible;
            }
            visible.found.push_back(decl);
            from = import;
        }
    }
    return visible;
}

static Visible visible_in(Context& c, ir::ModuleId module, ast::Identifier name) {
    const ModuleScope& scope = c.scopes[module];
    if (auto own = scope.names.find(name.name); own != scope.names.end()) return {own->second, {}};
    Visible visible = look_in(c, scope.imports, name);
    if (visible.found.empty())
        if (Visible prelude = look_in(c, scope.prelude, name); !prelude.found.empty()) return prelude;
    return visible;
}

Visible look_up(Context& c, ir::ModuleId module, ast::Identifier name) {
    Visible visible = visible_in(c, module, name);
    record_uses(c, name.span, visible.found);
    return visible;
}

void add_functions_of_types(Context& c, Name name, const std::vector<ir::TypeId>& types,
                            std::vector<ast::DeclId>& functions) {
    for (ir::TypeId type : types) {
        if (const ClosureType* closure = closure_of(c, type))
            for (const ClosureType::Call& call : closure->calls)
                if (call.name == name && !contains(functions, call.decl)) functions.push_back(call.decl);
        const ir::ModuleId home = home_of(c, type);
        if (!home) continue;
        auto found = c.scopes[home].names.find(name);
        if (found == c.scopes[home].names.end() || !is_function(c, found->second)) continue;
        for (ast::DeclId decl : found->second)
            if (!contains(functions, decl)) functions.push_back(decl);
    }
}

}  // namespace gliftc::sema
