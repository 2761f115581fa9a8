// Instances of structures: the items in their declarations, and the passes by which pipelines call
// their functions.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

ir::TypeId make_structure(Context&, ast::DeclId, const Env&);

/// Declares the names in scope in a structure's own functions, with Place root 0: constructor arguments, members,
/// memories, the structure that is the memory if there is one (the base, sema/structures/memory_structure.h), host
/// state. Sets Body::container.
void bring_members_into_scope(Body&, ir::StructureId structure);

/// Adds value parameters of the constructor as locals of the structure, and structure parameters as members by
/// reference.
void add_constructor(Context&, const Env&, const std::vector<ast::Param>&, ir::Structure&);

/// Adds `structure name = Type(arguments)`, and declares its name. False, after an error, if that makes no structure.
bool add_member(Body&, ir::StructureId structure, const ast::Item&);

/// Calls visit(item) for each item; for an `if`, for the items that its constant condition selects (none after an error
/// in the condition).
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

/// Copies an expression from a translator's function into the structure that uses it: the arguments given in `via`
/// (Stage) replace the translator's state.
ir::ExprId substitute_state(Context&, ir::ExprId, const ir::Stage&);

/// The value returned by a function that is a single `return`; else absent.
ir::ExprId single_return(const ir::Program&, ir::FunctionId);

/// The declaration of that name in std.transfer; absent if the module is not loaded.
std::optional<ast::DeclId> find_transfer(Context&, std::string_view name);

/// The instance of std.transfer's structure Box that holds a box of elements of that type, with that many dimensions,
/// in a buffer. Empty after an error, or if std.transfer is not loaded.
ir::StructureId box_of(Context&, std::uint32_t dimensions, ir::TypeId element, Span use);

/// Whether the statements contain operations of ir::Level::structure, such as reads of elements and translations of
/// addresses, directly or in functions that they call.
bool reads_memory(const ir::Program&, const std::vector<ir::StmtId>&);

/// The first of the types of the function's result and value parameters that memory cannot hold. A function with such a
/// type cannot be called in a pass of its own (pipeline_of_function). Absent if it has none.
std::optional<ir::TypeId> type_not_for_passes(const ir::Program&, const ir::Function&);

/// A pipeline that calls the function in a pass of one invocation and returns the result, which stays on the device.
/// Its parameters are the function's structures, then its values; `on_device` says which of the values lie on the
/// device (empty: none). Gives an empty id after an error.
ir::PipelineId pipeline_of_function(Context&, ir::FunctionId, Span use, const std::vector<bool>& on_device = {});

/// The parameter `self` of a generated pipeline: a range of the structure, or the whole container if the structure is
/// one.
ir::PipelineParam structure_param(Context&, ir::StructureId structure, Span);

/// The local as an argument of a pass or pipeline: Op::structure_value if it is a structure, Op::local if it is a slice
/// or a value.
ir::ExprId structure_argument(Context&, ir::LocalId, Span);

/// Adds the kernel, and a pipeline that makes a temporary of one element, of structure `box`, runs the kernel over it
/// and returns the element. The temporary is the kernel's last argument, `arguments` are the others. `pipeline` comes
/// with its name and parameters.
ir::PipelineId pipeline_of_kernel(Context&, ir::Kernel kernel, ir::Pipeline pipeline, ir::Operands arguments,
                                  ir::StructureId box);

/// Fills Structure::functions, and Structure::methods of containers.
void check_functions(Context&, ir::StructureId structure);

bool is_address(const ir::Types&, ir::TypeId);  ///< uint, uint2, uint3, uint4

}  // namespace gliftc::sema
