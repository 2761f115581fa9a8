#include "sema/check.h"

#include "ir/aliases.h"
#include "ir/chain.h"
#include "sema/context.h"
#include "sema/kernels/kernel_instances.h"
#include "sema/names/defines.h"
#include "sema/names/modules.h"
#include "sema/structures/components.h"
#include "sema/structures/constructors.h"
#include "sema/structures/replace.h"
#include "sema/types/generics.h"
#include "sema/types/instances.h"
#include "sema/warnings.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

void check_function(Context& c, ast::DeclId id, const Env& env) {
    // A function with structure parameters is checked when it is called, for the structure passed.
    for (const ast::Param& param : std::get<ast::Function>(c[id].body).params)
        if (c.types().kind(type_of(c, env, param.type)) == ir::TypeKind::structure) return;
    instantiate_function(c, id, env, {}, c[id].name.span);
}

void check_constant(Context& c, ast::DeclId id) {
    const ast::Decl& decl = c[id];
    ir::ExprId value = constant_declaration(c, id);
    if (!value) return;
    c.program.constants.push_back(
        {decl.name.name, c.program.exprs[value].type, value, c.module_of.at(id), decl.is_pub, decl.doc});
}

/// The root modules in which the structure has a public name.
std::vector<ir::ModuleId> makers_of(const Context& c, ir::StructureId structure) {
    std::vector<ir::ModuleId> makers;
    for (ir::ModuleId i : c.modules.ids())
        if (c.modules[i].is_root && ir::is_public(c.program.structures[structure], i)) makers.push_back(i);
    return makers;
}

/// Instantiates a pipeline without generic parameters; one with range parameters, for every combination of stored
/// structures that have public names in `modules` and match the ranges.
void check_pipeline(Context& c, ast::DeclId id, const Env& env, ir::StructureId owner,
                    const std::vector<ir::ModuleId>& modules) {
    const ast::Decl& decl = c[id];
    const auto& written = std::get<ast::Pipeline>(decl.body);
    std::vector<std::vector<Passed>> choices = {{}};
    for (const ast::Param& param : written.params) {
        std::vector<ir::StructureId> fitting(1);
        if (param.pattern == ast::Pattern::range && param.extra.size() == 1) {
            fitting.clear();
            auto n = count_of(c, env, param.type);
            ir::TypeId element = type_of(c, env, param.extra[0]);
            if (!n || element == c.types().error) return;
            ir::TypeId domain = c.types().vector(c.types().uint, *n);
            for (ir::StructureId i : c.program.structures.ids()) {
                const ir::Structure& structure = c.program.structures[i];
                const bool is_public =
                    std::ranges::any_of(modules, [&](ir::ModuleId module) { return ir::is_public(structure, module); });
                if (is_public && structure.kind == ir::StructureKind::stored && structure.domain_type == domain &&
                    structure.element == element)
                    fitting.push_back(i);
            }
        }
        std::vector<std::vector<Passed>> more;
        for (const auto& choice : choices)
            for (ir::StructureId structure : fitting) {
                more.push_back(choice);
                more.back().push_back({structure});
            }
        choices = std::move(more);
    }
    for (const auto& choice : choices) instantiate_pipeline(c, id, env, choice, owner, decl.name.span);
}

/// Checks a structure's pipelines; those with generic parameters are instantiated where they are called.
void check_own_pipelines(Context& c, ir::StructureId index) {
    for (const ast::Item* item : items_of(c, index)) {
        if (item->kind == ast::ItemKind::pipeline && c[item->decl].generics.empty())
            check_pipeline(c, item->decl, *c.structure_env.at(index), index, makers_of(c, index));
    }
}

/// Checks the types, translators, constants and aliases of a module that have no generic parameters. Done for all root
/// modules before any pipelines: those over ranges need all public structures.
void check_types(Context& c, ir::ModuleId module, const std::vector<ast::DeclId>& decls) {
    for (ast::DeclId id : decls) {
        const ast::Decl& decl = c[id];
        if (!decl.generics.empty() || !decl.name.name || c.diagnostics.at_limit()) continue;
        Env& env = c.new_env(module);
        bool type = std::holds_alternative<ast::Struct>(decl.body) || std::holds_alternative<ast::Enum>(decl.body) ||
                    std::holds_alternative<ast::Structure>(decl.body);
        if (type) instantiate_type(c, id, env, decl.name.span);
        else if (std::holds_alternative<ast::Translator>(decl.body)) instantiate_translator(c, id, env, decl.name.span);
        else if (std::holds_alternative<ast::Const>(decl.body)) check_constant(c, id);
        else if (std::holds_alternative<ast::Alias>(decl.body)) meta_of_alias(c, id, env, decl.name.span);
    }
}

void check_code(Context& c, ir::ModuleId module, const std::vector<ast::DeclId>& decls) {
    for (ast::DeclId id : decls) {
        const ast::Decl& decl = c[id];
        if (c.diagnostics.at_limit()) return;
        if (std::holds_alternative<ast::Test>(decl.body)) instantiate_test(c, id);
        if (std::holds_alternative<ast::KernelInstances>(decl.body)) check_kernel_instances(c, id);
        if (!decl.generics.empty() || !decl.name.name) continue;
        Env& env = c.new_env(module);
        if (std::holds_alternative<ast::Function>(decl.body)) check_function(c, id, env);
        else if (std::holds_alternative<ast::Kernel>(decl.body)) instantiate_kernel(c, id, env, decl.name.span);
        else if (std::holds_alternative<ast::Pipeline>(decl.body)) check_pipeline(c, id, env, {}, {module});
    }
}

/// Requires transfers (kernels that move elements between host and device) for the structures that public kernels and
/// pipelines of root modules take: C++ programs create and fill them, whichever module declares their types.
void require_transfers_of_arguments(Context& c) {
    std::vector<std::pair<ir::StructureId, Span>> passed;
    const auto is_seen = [&](const auto& declared) { return declared.is_pub && c.modules[declared.module].is_root; };
    for (const ir::Kernel& kernel : c.program.kernels)
        if (is_seen(kernel))
            for (const ir::KernelParam& param : kernel.params)
                if (param.pattern != ir::Pattern::value) passed.emplace_back(param.structure, param.span);
    for (const ir::Pipeline& pipeline : c.program.pipelines)
        if (is_seen(pipeline))
            for (const ir::PipelineParam& param : pipeline.params)
                if (param.pattern != ir::HostPattern::value) passed.emplace_back(param.structure, param.span);
    for (const auto& [structure, span] : passed) require_transfers(c, structure, span);
}

/// Requires transfers for structures that translators read and for memories that are structures: `gliftc test` reads
/// both on the host.
void require_transfers_of_tables(Context& c) {
    for (ir::StructureId i : c.program.structures.ids()) {
        std::vector<ir::StructureId> tables;
        const ir::Structure& structure = c.program.structures[i];
        const auto add = [&](const std::vector<std::uint32_t>& path) {
            const ir::Structure& table = ir::structure_at(c.program, structure, path);
            tables.push_back(c.program.structures.id_of(table));
        };
        for (const ir::Stage& stage : structure.via)
            for (const ir::Place& place : stage.structures) add(place.members);
        if (!structure.base.empty()) add(structure.base);
        for (ir::StructureId table : tables) require_transfers(c, table, c.program.structures[i].span);
    }
}

}  // namespace

Env& Context::new_env(ir::ModuleId module) {
    environments.push_back(std::make_unique<Env>());
    environments.back()->module = module;
    return *environments.back();
}

Diagnostic& Context::error(Diag id, Span span, std::initializer_list<std::string_view> arguments) {
    Diagnostic& diagnostic = diagnostics.report(id, span, arguments);
    // The place of the latest message: a request at the same place gets no note, so that endless recursion there does
    // not fill the report.
    Span last = span;
    for (auto request = requests.rbegin(); request != requests.rend(); ++request) {
        if (!request->span || request->span == last || request->display.find('<') == std::string::npos) continue;
        last = request->span;
        note(diagnostic, last, "in " + request->display + ", asked for here");
    }
    return diagnostic;
}

/// Whether there is a GLSL library for the structure (lower/library.h): it has a public name in a module that is
/// compiled.
static bool has_library(const Context& c, ir::StructureId index) {
    return std::ranges::any_of(c.program.structures[index].aliases,
                               [&](const ir::Alias& alias) { return alias.is_pub && c.modules[alias.module].is_root; });
}

ir::Program check(const ModuleTable& modules, ast::Tree& tree, Names& names, Diagnostics& diagnostics,
                  const Settings& settings) {
    ir::Program program;
    program.names = &names;
    Context c{.modules = modules,
              .tree = tree,
              .names = names,
              .diagnostics = diagnostics,
              .settings = settings,
              .program = program};
    collect_modules(c);
    check_defines(c);
    for (ir::ModuleId i : modules.ids())
        if (modules[i].is_root) check_types(c, i, modules[i].tree->decls);
    for (ir::ModuleId i : modules.ids())
        if (modules[i].is_root) check_code(c, i, modules[i].tree->decls);
    for (ir::StructureId i : program.structures.ids()) {
        if (makers_of(c, i).empty()) continue;
        if (program.structures[i].is_container) check_own_pipelines(c, i);
        if (program.structures[i].is_container || has_library(c, i)) check_functions(c, i);
        if (!diagnostics.has_own_errors()) require_transfers(c, i, program.structures[i].span);
    }
    if (!diagnostics.has_own_errors()) check_given(c);
    if (!diagnostics.has_own_errors()) require_transfers_of_arguments(c);
    // No warnings if there are errors, as in close_scope().
    for (const LoadedModule& module : modules)
        if (module.is_root && !diagnostics.has_own_errors()) warn(c, module.tree->decls);
    if (!diagnostics.has_own_errors() && settings.looks_into_tables) require_transfers_of_tables(c);
    return program;
}

}  // namespace gliftc::sema
