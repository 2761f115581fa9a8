// Names that nothing declares: the error, and what may have been meant.
#pragma once

#include "sema/context.h"

#include <string>
#include <string_view>
#include <vector>

namespace gliftc::sema {

/// The visible name, intrinsic, common built-in type or one of `more` that is most similar to `name`, for "did you
/// mean"; empty if none is similar enough.
std::string suggestion_for(Context&, const Env&, std::string_view name, const std::vector<std::string_view>& more = {});
/// Reports the name, with a hint if there is one: what Glift has in place of a name from another language, the module
/// that declares the name, or the name that is most similar.
void report_unknown(Context&, const Env&, ast::Identifier name, const std::vector<std::string_view>& more = {});

}  // namespace gliftc::sema
