// GLSL functions of one structure, to include in a shader of one's own.
#pragma once

#include "ir/pass.h"
#include "source/source.h"

#include <string>

namespace gliftc::glsl {

/// Declarations of the structure's memories and state, and functions. For a structure Field of floats:
///
///     float Field_read(uvec4 address);               the element there; at unmapped addresses `otherwise`, or zero
///     void Field_write(uvec4 address, float value);  absent for views and for depth images (d32); does nothing at
///                                                    unmapped addresses
///     uint Field_translate(uvec4 address);           the physical address of a mapped address; absent if the structure
///                                                    has neither a translator nor a structure as its memory
///     bool Field_is_mapped(uvec4 address);           absent without Field_translate, and where all addresses of the
///                                                    domain are known to lie in the structure's own buffer or image
///
/// The state is what the functions need to know of the structure, such as its arguments. The including shader defines
/// macros before it includes the text: FIELD_BINDING is the binding of the state; memory k, in the order in which the
/// text declares them, is at FIELD_BINDING + 1 + k. FIELD_SET, if defined, is the descriptor set, else 0. If
/// FIELD_STATE is defined, the shader declares the members of the state itself, as push constants for example. If
/// FIELD_READONLY is defined, memories are readonly and there is no Field_write.
std::string library_of(const ir::Program& program, const Sources& sources, const ir::Library& library);

}  // namespace gliftc::glsl
