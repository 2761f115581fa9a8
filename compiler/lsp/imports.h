// Adding an import to a document.
#pragma once

#include "lsp/analysis.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace gliftc::lsp {

/// The edit that adds `use module;` among the document's imports, in alphabetical order, or below its header. Absent if
/// the module is imported already or is the document's own.
std::optional<nlohmann::json> import_edit(const Analysis& analysis, const std::string& module);

}  // namespace gliftc::lsp
