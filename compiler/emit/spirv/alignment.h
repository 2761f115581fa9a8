// The alignments that a SPIR-V module states of what it reads and writes by address.
#pragma once

#include <cstdint>
#include <vector>

namespace gliftc::spirv {

/// Corrects the alignment that loads and stores of parts of structs and arrays by address state: to that of the part's
/// scalars, as in the layout `scalar`. Where glslang 12 takes a struct apart to store it, it states the alignment of
/// the part's offset, which need not hold: 16 for a float4 at offset 16 of a struct of 40 bytes, 0 for the first part.
/// A GPU then writes elsewhere.
void correct_alignments(std::vector<std::uint32_t>& words);

}  // namespace gliftc::spirv
