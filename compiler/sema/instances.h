// Instantiation: from a declaration and generic arguments to an instance in the Program, each made once.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// A struct, enum, structure, view, adaptor, or an alias of one, as a type. Arguments are already checked, in `env`.
ir::TypeId instantiate_type(Context&, ast::DeclId, const Env&, Span use);

/// The translator instances that a translator declaration or alias denotes.
std::optional<std::vector<std::uint32_t>> instantiate_translator(Context&, ast::DeclId, const Env&, Span use);

/// `structures`: the structure instances passed for the function's structure parameters.
std::optional<ir::FunctionId> instantiate_function(Context&, ast::DeclId, const Env&,
                                                   const std::vector<std::uint32_t>& structures, Span use);

std::optional<std::uint32_t> instantiate_kernel(Context&, ast::DeclId, const Env&, Span use);

/// The radius of a parameter `near<S, r>`; reports one that is missing or out of range.
std::uint32_t window_radius(Context&, const Env&, const ast::Param&);
/// The extents after `group`; all 0 if there are none.
std::array<std::uint32_t, 3> group_of(Context&, const Env&, const std::vector<ast::ExprId>& written);

/// `passed`: for each parameter of pattern range, the structure instance; for a value `lies_on_device` where it does,
/// else 0. `owner`: an adaptor's instance.
std::optional<std::uint32_t> instantiate_pipeline(Context&, ast::DeclId, const Env&,
                                                  const std::vector<std::uint32_t>& passed,
                                                  std::optional<std::uint32_t> owner, Span use);
inline constexpr std::uint32_t lies_on_device = 0xffffffffu;

/// Instantiates the kernels that move boxes of the structure between host and device: Program::transfers.
void require_transfers(Context&, std::uint32_t structure, Span use);

void instantiate_test(Context&, ast::DeclId);

/// The scope of one instantiation: adds a Request, reports infinite recursion.
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
