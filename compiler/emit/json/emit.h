// Reflection: what a module holds, and how to dispatch its shaders, as JSON (docs/reference/reflection.schema.json).
#pragma once

#include "ir/pass.h"
#include "source/source.h"

#include <string>

namespace gliftc::json {

/// The value of the entry "schema". It is incremented when a reader of the older form could misread the newer form.
inline constexpr unsigned schema_version = 1;

/// The reflection of one module: its kernels, pipelines (but not those that are its tests) and tests, with the kernels
/// and pipelines that sema made for values on the device, also in tests; and the structures (with their translators),
/// structs and enums that are public in it, or that its kernels and pipelines take or give, and those that these
/// consist of. The same program gives the same bytes.
std::string reflection_of(const ir::Program& program, const ir::Lowered& lowered, const Sources& sources,
                          ir::ModuleId module);

}  // namespace gliftc::json
