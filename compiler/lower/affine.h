// Whether a translator's physical address is an affine function of the virtual one, its coefficients uniform.
#pragma once

#include "ir/ir.h"

namespace gliftc::lower {

bool is_affine(const ir::Program& program, const ir::Translator& translator);

/// Sets Properties::affine of every translator.
void mark_affine(ir::Program& program);

}  // namespace gliftc::lower
