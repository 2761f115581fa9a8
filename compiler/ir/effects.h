// What a kernel reads and writes: the table of patterns (patterns.def), and what follows from it.
#pragma once

#include "ir/pass.h"

namespace gliftc::ir {

enum class Reach : std::uint8_t { nothing, element, window, anywhere };
enum class Course : std::uint8_t { stays, follows, visits };
enum class Directions : std::uint8_t { none, in, out, inout, all };

/// A line of patterns.def.
struct PatternTraits {
    const char* name;
    Reach reach;
    Course course;
    Directions directions;
};
const PatternTraits& traits_of(Pattern pattern);

inline bool visits(Pattern pattern) { return traits_of(pattern).course == Course::visits; }
/// The range is that of the visited ones, or goes along with it.
inline bool follows_iteration(Pattern pattern) { return traits_of(pattern).course != Course::stays; }
/// Has a range of its own size.
inline bool has_own_range(Pattern pattern) {
    return traits_of(pattern).course == Course::stays && traits_of(pattern).reach != Reach::nothing;
}

/// Whether the parameter's addresses are addresses of the binding's memory, which the parameter's reach then speaks of.
bool is_addressed(const Program& program, const Kernel& kernel, const PassBinding& binding);

/// Whether a call may pass one place for both bindings, under two names (docs/language.md, "One memory given twice"):
/// both are the elements that invocations stand at, of structures of one type.
bool may_be_one_place(const Program& program, const Kernel& kernel, const PassBinding& one, const PassBinding& other);

/// Whether two bindings of a lowered pass may be one place.
bool has_one_place(const Pass& pass);

/// Whether one invocation may write what another touches, where two parameters are all of one structure.
bool may_meet(const KernelParam& one, const KernelParam& other);

/// The translator by which several elements of the structure may have one place, if it declares so; or null.
const Translator* many_to_one_stage(const Program& program, std::uint32_t structure);

}  // namespace gliftc::ir
