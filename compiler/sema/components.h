// Instances of structures, views, adaptors and translators.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

ir::TypeId make_structure(Context&, ast::DeclId, const Env&);
ir::TypeId make_view(Context&, ast::DeclId, const Env&);
ir::TypeId make_adaptor(Context&, ast::DeclId, const Env&);

/// Declares the names in scope in a structure's own functions: constructor arguments, members, memories, host state,
/// with Place root 0.
void bring_members_into_scope(Body&, std::uint32_t structure);

/// Declares scalar constructor parameters as locals of the structure, and structure parameters as members by reference.
void add_constructor(Context&, const Env&, const std::vector<ast::Param>&, ir::Structure&);

/// Adds `structure name = Type(arguments)`, and declares its name. False after an error.
bool add_member(Body&, std::uint32_t structure, const ast::Item&);

/// Visits items; of an `if` those that its constant condition selects.
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

/// Copies an expression of a translator's function into a structure: the stage's arguments replace the state.
ir::ExprId substitute_state(Context&, ir::ExprId, const ir::Stage&);

/// The value returned by a function that is a single `return`; else absent.
ir::ExprId single_return(const ir::Program&, ir::FunctionId);

/// The linear buffer of std.transfer with that many dimensions.
std::optional<std::uint32_t> box_of(Context&, std::uint32_t dimensions, ir::TypeId element, Span use);

/// Whether statements of a function read elements of a structure, themselves or by what they call.
bool reads_memory(const ir::Program&, const std::vector<ir::StmtId>&);

/// The pipeline that gives the function's result on the device. Its parameters are the function's structures, then its
/// values, of which some may be on the device.
std::optional<std::uint32_t> pipeline_of_function(Context&, ir::FunctionId, Span use,
                                                  const std::vector<bool>& on_device = {});

/// The pipeline that runs a kernel of one invocation over an element that nobody has yet, its last argument, and gives
/// that. `pipeline` has its parameters, `arguments` are the other arguments of the kernel.
std::uint32_t pipeline_of_kernel(Context&, ir::Kernel kernel, ir::Pipeline pipeline, ir::Operands arguments,
                                 std::uint32_t box);

/// Finds what the adaptor's public functions are in C++: methods.
void check_methods(Context&, std::uint32_t structure);

bool is_address(const ir::Types&, ir::TypeId);  ///< uint, uint2, uint3, uint4

}  // namespace gliftc::sema
