// Whether a pipeline changes its container: the host state, or which memory a member has. What it writes into memory is
// no change: containers refer to their memory, as C++ objects do.
#pragma once

#include "ir/ir.h"

namespace gliftc::ir {

/// Whether the pipeline may change what it is given for the parameter: a container that is not declared `in`.
bool may_be_changed(const Program& program, const PipelineParam& param);

/// Whether the pipeline's body changes the pipeline's container. Pipeline::changes_owner of the pipelines that it calls
/// must be known.
bool changes_owner(const Program& program, const Pipeline& pipeline);

}  // namespace gliftc::ir
