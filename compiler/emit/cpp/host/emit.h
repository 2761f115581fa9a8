// Lowered kernels as C++ for the host device.
//
// A kernel without a group becomes a function for rows of elements along x, which the host device calls on several
// threads, each for some of the rows or for parts of rows. Memory whose index advances by one along a row is reached by
// a pointer to the row's first element. Where a kernel reads neighbours, the part of a row that is far enough from the
// sides of the domain may have a loop of its own, which does not check whether they are inside (ir::Interior).
//
// A kernel with a group becomes a function for one workgroup: the code between two barriers is a loop over the
// invocations, values that live on across a barrier are arrays with an element for each invocation.
//
// A kernel that draws becomes a function for vertices, one for the fragments of a block of 64 pixels if it has a
// fragment part, and one that calls the runtime's rasteriser with them.
#pragma once

#include "emit/cpp/printer.h"
#include "ir/pass.h"

#include <string>

namespace gliftc::host {

/// The function `static void <name>(const glift::HostCall& call)` and what it calls; needs the struct
/// `<name>_parameters` and globals.functions before it.
std::string kernel_of(cpp::Globals& globals, const ir::Pass& pass, const std::string& name);

}  // namespace gliftc::host
