#include "sema/kernels/kernel_instances.h"

#include "sema/types/generics.h"
#include "sema/types/instances.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

/// The generic kernel of the module that the name means; empty, after an error, if there is not exactly one.
ast::DeclId generic_kernel(Context& c, ir::ModuleId module, ast::Identifier name) {
    ast::DeclId found;
    std::size_t count = 0;
    const auto declared = c.scopes[module].names.find(name.name);
    if (declared != c.scopes[module].names.end())
        for (ast::DeclId id : declared->second) {
            if (!std::holds_alternative<ast::Kernel>(c[id].body) || c[id].generics.empty()) continue;
            found = id;
            ++count;
        }
    if (count == 1) return found;
    note(c.error(Diag::kernel_instance, name.span, {c.text(name.name)}), name.span,
         count == 0 ? "list generic kernels of this module with their arguments: name<…>"
                    : "there are several of this name: call them in a pipeline");
    return {};
}

ir::KernelId instance_of(Context& c, ir::ModuleId module, ast::ExprId target) {
    const ast::Expr& written = c[target];
    const bool has_arguments = written.kind == ast::ExprKind::generic;
    const ast::Expr& name = has_arguments ? c[written.operands[0]] : written;
    const ast::DeclId id = generic_kernel(c, module, {name.name, name.span});
    if (!id) return {};
    Env& env = c.new_env(module);
    Arguments generics(c, c[id], env, written.span);
    if (!generics.give_all(c.new_env(module), {written.operands.begin() + has_arguments, written.operands.end()}))
        return {};
    if (!generics.finish()) return {};
    return instantiate_kernel(c, id, env, written.span);
}

/// Whether C++ tells calls of the two apart by the types of their arguments.
bool differ(const Context& c, const ir::Kernel& a, const ir::Kernel& b) {
    if (a.params.size() != b.params.size()) return true;
    return !std::ranges::equal(a.params, b.params, [&](const ir::KernelParam& one, const ir::KernelParam& other) {
        if (one.pattern == ir::Pattern::value || other.pattern == ir::Pattern::value)
            return one.pattern == other.pattern &&
                   c.program.locals[one.local].type == c.program.locals[other.local].type;
        return one.structure == other.structure;
    });
}

}  // namespace

void check_kernel_instances(Context& c, ast::DeclId id) {
    const ast::Decl& decl = c[id];
    const auto& targets = std::get<ast::KernelInstances>(decl.body).targets;
    std::vector<ir::KernelId> made;
    for (ast::ExprId target : targets) {
        const ir::KernelId kernel = instance_of(c, c.module_of.at(id), target);
        if (!kernel) continue;
        const auto is_same = [&](ir::KernelId other) {
            return !differ(c, c.program.kernels[kernel], c.program.kernels[other]);
        };
        if (std::ranges::any_of(made, is_same)) {
            c.error(Diag::same_instances, c[target].span, {c.text(decl.name.name)});
            continue;
        }
        made.push_back(kernel);
        c.program.kernels[kernel].name = decl.name.name;
        c.program.kernels[kernel].is_pub = decl.is_pub;
        c.program.kernels[kernel].is_instance = true;
        if (!decl.doc.empty()) c.program.kernels[kernel].doc = decl.doc;
    }
}

}  // namespace gliftc::sema
