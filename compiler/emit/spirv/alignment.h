// The alignments that a SPIR-V module states of what it reads and writes by address.
#pragma once

#include <cstdint>
#include <vector>

namespace gliftc::spirv {

/// Corrects the alignment operands of loads and stores by device address that access a struct or an array in a buffer,
/// or a part of one: to the alignment of the largest scalar in what is accessed, which the layout `scalar` guarantees.
/// Where glslang 12 stores a struct part by part, it derives the alignment from the part's offset in the struct: 16 for
/// a float4 at offset 16 of a struct of 40 bytes, though the next struct of an array begins at byte 40; and 0 for the
/// first part. A GPU may then write to a wrong address.
void correct_alignments(std::vector<std::uint32_t>& words);

}  // namespace gliftc::spirv
