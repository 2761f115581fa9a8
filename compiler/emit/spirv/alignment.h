// The alignments that a SPIR-V module states of what it reads and writes by address.
#pragma once

#include <cstdint>
#include <vector>

namespace gliftc::spirv {

/// States the true alignment of parts of structs and arrays at addresses: that of their scalars, as in the layout
/// `scalar`. glslang 12 states that of the part's offset, 16 for a float4 at offset 16 of a struct of 40 bytes, 0 for
/// the first, where it takes a struct apart to store it; a GPU then writes elsewhere.
void correct_alignments(std::vector<std::uint32_t>& words);

}  // namespace gliftc::spirv
