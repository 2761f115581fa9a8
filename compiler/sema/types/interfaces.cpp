#include "sema/types/interfaces.h"

#include "sema/bodies/closures.h"
#include "sema/names/lookup.h"
#include "sema/types/generics.h"
#include "sema/types/instances.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

/// A function that an interface requires, with concrete types.
struct Wanted {
    ast::Identifier name;
    std::vector<ast::Identifier> params;
    std::vector<ir::TypeId> types;
    ir::TypeId result;
};

Wanted wanted_of(Context& c, const Env& inside, ast::DeclId member) {
    const auto& function = std::get<ast::Function>(c[member].body);
    Wanted wanted{c[member].name, {}, {}, c.types().void_};
    for (const ast::Param& param : function.params) {
        wanted.params.push_back(param.name);
        wanted.types.push_back(type_of(c, inside, param));
    }
    if (function.result) wanted.result = type_of(c, inside, function.result);
    return wanted;
}

/// Whether the function, with some generic arguments, has exactly the required parameter and result types.
bool fits(Context& c, ast::DeclId candidate, const Wanted& wanted) {
    const ast::Decl& decl = c[candidate];
    const auto& function = std::get<ast::Function>(decl.body);
    if (function.params.size() != wanted.types.size()) return false;
    Env env;
    env.module = c.module_of.at(candidate);
    if (!decl.generics.empty()) {
        Arguments arguments(c, decl, env, decl.name.span);
        for (std::size_t i = 0; i < wanted.types.size(); ++i) arguments.infer(function.params[i].type, wanted.types[i]);
        if (function.result) arguments.infer(function.result, wanted.result);
        if (!arguments.finish(true)) return false;
    }
    ir::TypeId result = function.result ? type_of(c, env, function.result) : c.types().void_;
    if (result != wanted.result) return false;
    for (std::size_t i = 0; i < wanted.types.size(); ++i)
        if (type_of(c, env, function.params[i].type) != wanted.types[i]) return false;
    return true;
}

bool is_there(Context& c, ir::ModuleId module, const Wanted& wanted) {
    std::vector<ast::DeclId> candidates = look_up(c, module, wanted.name).found;
    if (!is_function(c, candidates)) candidates.clear();
    add_functions_of_types(c, wanted.name.name, wanted.types, candidates);
    return std::any_of(candidates.begin(), candidates.end(),
                       [&](ast::DeclId candidate) { return fits(c, candidate, wanted); });
}

std::size_t number_of_functions(const Context& c, ast::DeclId interface) {
    const auto is_function = [&](ast::DeclId member) { return std::holds_alternative<ast::Function>(c[member].body); };
    const auto& members = std::get<ast::Interface>(c[interface].body).members;
    return static_cast<std::size_t>(std::ranges::count_if(members, is_function));
}

/// The function as the language writes it: "fn combine(op: Max, a: uint, b: uint) -> uint".
std::string text_of(const Context& c, const Wanted& wanted) {
    std::string text = "fn " + c.text(wanted.name.name) + "(";
    for (std::size_t i = 0; i < wanted.params.size(); ++i)
        text += (i ? ", " : "") + c.text(wanted.params[i].name) + ": " + c.text(wanted.types[i]);
    text += ")";
    return wanted.result == c.program.types.void_ ? text : text + " -> " + c.text(wanted.result);
}

}  // namespace

bool satisfies_interface(Context& c, const Env& env, ast::DeclId id, const ast::Expr& constraint, ir::TypeId type,
                         std::string& why) {
    Env inside;
    inside.module = c.module_of.at(id);
    inside.self = type;
    Arguments arguments(c, c[id], inside, constraint.span);
    bool given = constraint.kind != ast::ExprKind::generic || arguments.give(env, constraint.operands, 1);
    if (!given || !arguments.finish()) return true;  // reported

    // A cycle: the interface requires a function whose own constraints, directly or by way of other functions, ask
    // again whether the same type satisfies this interface.
    std::string key = key_of(c, id, inside) + "@" + std::to_string(type.index) + "@" + std::to_string(env.module.index);
    if (std::find(c.interfaces_under_way.begin(), c.interfaces_under_way.end(), key) != c.interfaces_under_way.end()) {
        why = "this depends on itself";
        return false;
    }
    // The interface's arguments may grow with each step of such a cycle, so that no key repeats; then the limit on the
    // depth of instantiations ends it.
    const InstantiationScope scope(c, display_of(c, c[id], inside), constraint.span);
    if (scope.too_deep()) return true;  // reported
    c.interfaces_under_way.push_back(key);
    bool all = true;
    const ClosureType* closure = closure_of(c, type);
    const std::size_t functions = number_of_functions(c, id);
    if (closure && functions != 1) {
        why = "it is one function, and the interface requires " + std::to_string(functions) +
              ": declare a struct with these functions";
        all = false;
    }
    for (ast::DeclId member : std::get<ast::Interface>(c[id].body).members) {
        if (!std::holds_alternative<ast::Function>(c[member].body)) continue;
        Wanted wanted = wanted_of(c, inside, member);
        if (closure) {
            wanted.types.push_back(wanted.result);
            all = all && give_call(c, type, wanted.name.name, wanted.types, why);
            continue;
        }
        all = is_there(c, env.module, wanted);
        if (all) continue;
        why = "there is no " + text_of(c, wanted);
        break;
    }
    c.interfaces_under_way.pop_back();
    return all;
}

}  // namespace gliftc::sema
