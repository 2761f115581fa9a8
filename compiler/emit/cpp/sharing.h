// What a call tells the runtime where one memory may be given for several parameters.
#pragma once

#include "emit/cpp/unit.h"

namespace gliftc::cpp {

/// Whether two bindings of the pass may be one memory that is written.
bool may_share(const ir::Pass& pass);

/// The fields of glift::Binding that say how a parameter touches the memory.
std::string sharing_fields(const ir::Program& program, const ir::Kernel& kernel, const ir::PassBinding& binding);

}  // namespace gliftc::cpp
