// Whether derivatives (dFdx, dFdy, fwidth) in the fragment part of a draw depend on loads from memory.
#pragma once

#include "ir/pass.h"

namespace gliftc::ir {

/// Whether an operand of a derivative, or a condition under which a derivative is reached, depends on a load from a
/// buffer or storage image; reading a pass parameter that lies in a storage buffer is such a load. Derivatives also use
/// helper invocations, the fragments of a quad that lie outside the triangle; on some devices their loads give zeros
/// (DeviceProperties::helpers_load). Loads from sampled images do not count. False for kernels that do not draw.
bool derives_loads(const Program& program, const Pass& pass);

}  // namespace gliftc::ir
