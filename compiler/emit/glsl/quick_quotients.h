// Bodies with many exact quotients of floats. The code of a quotient for operands far from 1 (division.cpp) is long,
// and it stands in a shader once for each quotient, so that such a body does not fit the instruction cache. So
// statements without effects come twice: first with the short code alone, which notes whether its operands are
// ordinary; then, for invocations where some were not, with the whole code.
#pragma once

#include "emit/glsl/printer.h"

namespace gliftc::glsl {

/// Prints the statements of main.
void print_main_body(Printer& p, const std::vector<ir::StmtId>& body);

}  // namespace gliftc::glsl
