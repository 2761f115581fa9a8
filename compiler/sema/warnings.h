// Warnings about code that is valid but probably not meant: unused parameters, `out` parameters that are never written,
// unreachable statements, `x = x`.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Looks at the functions, kernels, pipelines and tests among the declarations, but not at functions and pipelines
/// inside structures and translators. Looks at syntax trees, not at instances, so that each generic
/// declaration is warned about once. Parameters of generic functions, and struct parameters of other functions, may
/// stay unused. In tests it warns only of unreachable statements; in draws it does not warn of `x = x`.
void warn(Context&, const std::vector<ast::DeclId>& declarations);

}  // namespace gliftc::sema
