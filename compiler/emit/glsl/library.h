// GLSL functions of one structure, to include in a shader of one's own.
#pragma once

#include "ir/pass.h"
#include "source/source.h"

#include <string>

namespace gliftc::glsl {

/// Declarations of the structure's memories and state, and for a structure Field
///     float Field_read(uvec4 address);               the value there, or what unmapped addresses read as
///     void Field_write(uvec4 address, float value);  not for views; nothing happens at unmapped addresses
///     uint Field_translate(uvec4 address);           the physical address; of a partial mapping where
///     Field_is_mapped(address)
/// FIELD_SET and FIELD_BINDING may be defined before: the state is at FIELD_BINDING, memory k at FIELD_BINDING + 1 + k.
/// FIELD_STATE defined: the members of the state are declared by the user's shader, as push constants for example.
/// FIELD_READONLY defined: memories are readonly and there is no Field_write.
std::string library_of(const ir::Program& program, const Sources& sources, const ir::Library& library);

}  // namespace gliftc::glsl
