// Infers whether a translator's physical address is an affine function of the virtual address: each of its components
// is a constant plus the components of the virtual address times coefficients. The constant and the coefficients are
// the same for all addresses.
#pragma once

#include "ir/ir.h"

namespace gliftc::lower {

bool is_affine(const ir::Program& program, const ir::Translator& translator);

/// Sets Properties::affine of every translator.
void mark_affine(ir::Program& program);

}  // namespace gliftc::lower
