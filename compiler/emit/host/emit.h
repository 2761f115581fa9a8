// Lowered kernels as C++ for the host device.
//
// A kernel without a group becomes a function for one row of elements, x innermost, which the host device calls for all
// rows in parallel. Memory that a row runs through in order is reached by a pointer to the row's first element. Where a
// kernel looks at neighbours, the part of a row away from the sides of the domain runs without checks.
//
// A kernel with a group becomes a function for one workgroup: what lies between two barriers is a loop over the
// invocations, values that live on across a barrier are arrays with an element for each invocation.
#pragma once

#include "emit/cpp/printer.h"
#include "ir/pass.h"

#include <string>

namespace gliftc::host {

/// `static void <name>(const glift::HostCall& call)`, which needs the struct and globals.functions.
std::string kernel_of(cpp::Globals& globals, const ir::Pass& pass, const std::string& name);

}  // namespace gliftc::host
