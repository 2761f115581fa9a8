// Instances of structures, views, adaptors and translators.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

ir::TypeId make_structure(Context&, ast::DeclId, const Env&);
ir::TypeId make_view(Context&, ast::DeclId, const Env&);
ir::TypeId make_adaptor(Context&, ast::DeclId, const Env&);

/// The names that a structure's own functions see: constructor arguments, members, memories, host state, at Place root
/// 0.
void bring_members_into_scope(Body&, std::uint32_t structure);

/// Declares scalar constructor parameters as locals of the structure, and structure parameters as members by reference.
void add_constructor(Context&, const Env&, const std::vector<ast::Param>&, ir::Structure&, bool by_reference);

/// Walks items, following `if` by its constant condition.
template <class Visit>
void for_each_item(Context& c, const Env& env, const std::vector<ast::Item>& items, const Visit& visit) {
    for (const ast::Item& item : items) {
        if (item.kind != ast::ItemKind::condition) {
            visit(item);
            continue;
        }
        auto taken = constant_of(c, env, item.value, c.types().bool_);
        if (taken) for_each_item(c, env, taken->bits() ? item.body : item.alternative, visit);
    }
}

/// Copies an expression of a translator's function into a structure: state becomes the stage's arguments.
ir::ExprId substitute_state(Context&, ir::ExprId, const ir::Stage&);

/// The value of a function that is one `return`: absent if it is anything else.
ir::ExprId single_return(const ir::Program&, ir::FunctionId);

bool is_address(const ir::Types&, ir::TypeId);  ///< uint, uint2, uint3, uint4

}  // namespace gliftc::sema
