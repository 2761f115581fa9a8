// Canonical formatting: `gliftc fmt`.
#pragma once

#include "base/name.h"
#include "diag/diagnostics.h"
#include "source/source.h"

#include <optional>
#include <string>

namespace gliftc {

/// The file in canonical format: indented by 4 spaces, lines of at most 120 columns where they can be broken, one
/// statement per line, comments kept, no two empty lines in a row. A statement or declaration stays on one line if each
/// of its blocks was written on one line, no comment is inside and it fits. Formatting is idempotent. Absent, with
/// errors reported, if the file does not parse; also absent if `diagnostics` had reached its limit of errors before the
/// call.
std::optional<std::string> format(std::uint32_t file, const Sources& sources, Names& names, Diagnostics& diagnostics);

}  // namespace gliftc
