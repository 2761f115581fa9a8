// What is known of a pass once it is lowered: the rounds of its loops, the functions it calls, whether devices agree on it.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// Fills loop_rounds, longest_loop, functions and exact.
void summarize(Context& cx);

}  // namespace gliftc::lower
