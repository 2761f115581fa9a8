// layout: sizes, alignments and offsets, decided once and read by every target. Scalar layout: everything is aligned to
// its largest scalar, as GL_EXT_scalar_block_layout has it and as C++ lays structs out.
#pragma once

#include "ir/pass.h"

#include <cstdint>
#include <vector>

namespace gliftc::layout {

/// Of a value in memory. bool takes 4 bytes.
struct Size {
    std::uint32_t size = 0;
    std::uint32_t align = 1;
};

Size size_of(const ir::Program& program, ir::TypeId type);

/// The byte offset of each field; imported structs keep the offsets that C++ gave them.
std::vector<std::uint32_t> offsets_of(const ir::Program& program, const ir::Struct& type);

/// Push constants that every device has, in bytes.
inline constexpr std::uint32_t push_constant_limit = 128;

/// Gives every pass's parameters their offsets and decides where they are passed.
void lay_out(ir::Program& program, ir::Lowered& lowered);

}  // namespace gliftc::layout
