// Sizes, alignments and offsets of types and pass parameters, the same for all targets. Scalar layout: a type is
// aligned as its largest scalar, as in GL_EXT_scalar_block_layout and in C++.
#pragma once

#include "ir/pass.h"

#include <cstdint>
#include <vector>

namespace gliftc::layout {

/// Size and alignment, in bytes, of a value in memory. bool takes 4 bytes.
struct Size {
    std::uint32_t size = 0;
    std::uint32_t align = 1;
};

Size size_of(const ir::Program& program, ir::TypeId type);

/// The byte offset of each field; imported structs keep the offsets that C++ gave them.
std::vector<std::uint32_t> offsets_of(const ir::Program& program, const ir::Struct& type);

/// Bytes of push constants that every device supports.
inline constexpr std::uint32_t push_constant_limit = 128;

/// Bytes of a uniform buffer that every device supports.
inline constexpr std::uint32_t uniform_buffer_limit = 16384;

/// For each form of each kernel: gives the parameters their offsets, decides whether they are push constants or in a
/// uniform or storage buffer, and allocates workgroup memory. Passes of library functions (Lowered::libraries) are left
/// as they are.
void lay_out(ir::Program& program, ir::Lowered& lowered);

}  // namespace gliftc::layout
