// What is known of a pass once it is lowered: the rounds of its loops, the functions it calls, whether devices agree on
// it.
#pragma once

#include "lower/context.h"

#include <span>

namespace gliftc::lower {

/// Fills loop_rounds, longest_loop, has_reports, functions and exact.
void summarize(Context& cx);

/// What the forms of a kernel have in common: the bound of its loops, whether it has reports, the files that reports
/// name.
void agree(const ir::Program& program, std::span<ir::Pass* const> forms);

}  // namespace gliftc::lower
