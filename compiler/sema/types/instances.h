// Instantiation: from a declaration and generic arguments to an instance in the Program, each made once.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// The type of a struct, enum or structure with the generic arguments in `env`, which have been checked.
ir::TypeId instantiate_type(Context&, ast::DeclId, const Env&, Span use);

/// The instance of a translator; empty after an error.
ir::TranslatorId instantiate_translator(Context&, ast::DeclId, const Env&, Span use);

/// A function that calls a closure has the generic arguments of the closure, whatever the environment has.
/// `structures`: the instances passed for the function's structure parameters; of a function that a structure declares,
/// that structure first.
std::optional<ir::FunctionId> instantiate_function(Context&, ast::DeclId, const Env&,
                                                   const std::vector<ir::StructureId>& structures, Span use);

ir::KernelId instantiate_kernel(Context&, ast::DeclId, const Env&, Span use);

/// The radius of a parameter `near<S, r>` whose structure has addresses of type `domain`; reports one that is missing
/// (then 1), out of range, or for another number of axes.
ir::Radius window_radius(Context&, const Env&, const ast::Param&, ir::TypeId domain);

/// Reports an argument too many of a parameter's pattern: besides the structure, near, scatter, at and target take at
/// most one, the other patterns none.
void check_extra_count(Context&, const ast::Param&);

/// The three extents after `group`: 1 for each that is not written, all 1 after an error; all 0 if there is no `group`.
std::array<std::uint32_t, 3> group_of(Context&, const Env&, const std::vector<ast::ExprId>& written);

/// What a call passes for a parameter of a pipeline: of a range, the structure; of a value, whether it lies on the
/// device.
struct Passed {
    ir::StructureId structure;
    bool on_device = false;
};

/// `passed` has an entry for each parameter. `owner`: the structure that declares the pipeline, if one does. Empty
/// after an error.
ir::PipelineId instantiate_pipeline(Context&, ast::DeclId, const Env&, const std::vector<Passed>& passed,
                                    ir::StructureId owner, Span use);

/// Instantiates kernels of std.transfer for the structure, which move boxes of elements between host and device, fill
/// boxes, and list the elements that are there, as far as the structure allows it; adds them to Program::transfers (see
/// ir::Program::Transfer). Does the same for the structure's members; of a container, for the members alone. Does
/// nothing if Program::transfers has the structure already, or for a view without a domain.
void require_transfers(Context&, ir::StructureId structure, Span use);

void instantiate_test(Context&, ast::DeclId);

/// RAII for one instantiation: adds a Request to the stack, and reports a depth of more than 64, taken for infinite
/// recursion.
class InstantiationScope {
public:
    InstantiationScope(Context& context, std::string display, Span use);
    ~InstantiationScope();
    bool too_deep() const { return too_deep_; }

private:
    Context& context_;
    bool too_deep_ = false;
};

}  // namespace gliftc::sema
