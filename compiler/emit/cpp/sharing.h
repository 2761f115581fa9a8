// What generated code tells the runtime about a kernel's bindings if a call may give one memory for several parameters
// (docs/reference/language.md, "Aliasing").
#pragma once

#include "emit/cpp/unit.h"

namespace gliftc::cpp {

/// Whether a call may give one memory for two bindings of the pass, at least one of which is written: they have the
/// same shape and format. A layer or face has another shape than its image: a call that gives both is always refused.
bool may_share(const ir::Pass& pass);

/// The fields of glift::Binding that say which parameter the memory belongs to and how the parameter accesses it.
std::string sharing_fields(const ir::Program& program, const ir::Kernel& kernel, const ir::PassBinding& binding);

/// The initialisers of glift::Binding::update and number: empty if the pass also loads from the binding, or changes it
/// in several ways.
std::string update_fields(const ir::Program& program, const ir::Kernel& kernel, const ir::Pass& pass,
                          std::size_t binding);

}  // namespace gliftc::cpp
