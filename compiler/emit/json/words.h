// Enumerators as the reflection spells them, and expressions as the language would.
#pragma once

#include "ir/pass.h"

#include <string>
#include <vector>

namespace gliftc::json {

const char* word(ir::MemoryShape shape);
const char* word(ir::Format format);
const char* word(ir::Access access);
const char* word(ir::Direction direction);
const char* word(ir::Pattern pattern);
const char* word(ir::Combine combine);
const char* word(ir::StructureKind kind);
const char* word(ir::ParameterSource source);
const char* word(ir::HostPattern pattern);
const char* word(ir::Mapping mapping);

/// What Place::root is an index of: one of a kernel's parameters, with its name, or the structure itself, without a
/// name.
struct Root {
    std::string name;
    ir::StructureId structure;
};

/// An expression over structures' state, much as the language writes it: div_ceil(extent, 8), f.data.extent.x.
std::string expression_text(const ir::Program& program, ir::ExprId expr, const std::vector<Root>& roots);

/// The index of the structure at a place, and the place as the source spells it: f.table.
ir::StructureId structure_at(const ir::Program& program, const std::vector<Root>& roots, const ir::Place& place);
std::string place_text(const ir::Program& program, const std::vector<Root>& roots, const ir::Place& place);

}  // namespace gliftc::json
