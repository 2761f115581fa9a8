// Components: of a structure `s` whose elements are structs, `s.density` is the structure whose elements are that field
// of the elements of `s`. A component is an instance of std.transfer's structure Component, whose memory is the whole
// (ir::Structure::field), and a member of the whole that is made where it is asked for (MemberStructure::is_component).
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// The index of the component among the members of `whole`, made by the first call. Absent if the elements have no such
/// field, or are not known yet.
std::optional<std::uint32_t> component_of(Context&, ir::StructureId whole, ast::Identifier field);

/// The names of the fields of the structure's elements; empty if these are no structs.
std::vector<std::string_view> component_names(const Context&, ir::StructureId whole);

}  // namespace gliftc::sema
