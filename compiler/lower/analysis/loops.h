// Summary of a lowered pass: a bound on the iterations of its loops, the functions that it calls, whether it has
// reports, whether results are the same on all devices.
#pragma once

#include "lower/context.h"

#include <span>

namespace gliftc::lower {

/// Fills loop_rounds, longest_loop, has_reports, functions and exact.
void summarize(Context& cx);

/// Makes equal in all forms of a kernel: the bound of its loops and the loop with that bound (longest_loop), whether it
/// has reports (of checked builds), the files that messages of the shaders name (Pass::files), which images are
/// sampled, and whether devices agree bit for bit.
void agree(const ir::Program& program, std::span<ir::Pass* const> forms);

}  // namespace gliftc::lower
