// GLSL functions of one structure, to include in a shader of one's own.
#pragma once

#include "ir/pass.h"
#include "source/source.h"

#include <string>

namespace gliftc::glsl {

/// Declarations of the structure's memories and state, and functions. For a structure Field of floats:
///
///     float Field_read(uvec4 address);               the value there, or that of reads at unmapped addresses
///     void Field_write(uvec4 address, float value);  not for views; nothing happens at unmapped addresses
///     bool Field_is_mapped(uvec4 address);           absent if all addresses of the domain are known to be mapped
///     uint Field_translate(uvec4 address);           the physical address of a mapped address; absent if nothing
///                                                    translates (views without memory)
///
/// The including shader defines FIELD_BINDING before: the state is at that binding, memory k at FIELD_BINDING + 1 + k.
/// It may define FIELD_SET (0), the descriptor set. FIELD_STATE defined: it declares the members of the state itself,
/// as push constants for example. FIELD_READONLY defined: memories are readonly and there is no Field_write.
std::string library_of(const ir::Program& program, const Sources& sources, const ir::Library& library);

}  // namespace gliftc::glsl
