// What the derivatives of a fragment part depend on.
#pragma once

#include "ir/pass.h"

namespace gliftc::ir {

/// Whether derivatives need what fragments beside the triangle load from buffers: a derived value, or what decides
/// whether a derivative is reached, depends on a load. On some devices such fragments load zeros
/// (DeviceProperties::helpers_load). False for what is no draw, and for loads from sampled images.
bool derives_loads(const Program& program, const Pass& pass);

}  // namespace gliftc::ir
