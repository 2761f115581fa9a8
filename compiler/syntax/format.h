// Canonical formatting: `gliftc fmt`.
#pragma once

#include "base/name.h"
#include "diag/diagnostics.h"
#include "source/source.h"

#include <optional>
#include <string>

namespace gliftc {

/// The file in the one format: 4 spaces a level, 120 columns, one statement a line, comments kept, at most one empty
/// line together. A block that stands on one line stays there while it fits. Formatting what is formatted changes
/// nothing. Nothing, with errors reported, where the file does not parse.
std::optional<std::string> format(std::uint32_t file, const Sources& sources, Names& names, Diagnostics& diagnostics);

}  // namespace gliftc
