// What a kernel reads and writes: the table of patterns (patterns.def), and what follows from it.
#pragma once

#include "ir/pass.h"

namespace gliftc::ir {

/// Whether the operation reads the memory of a binding.
inline bool is_load(Op op) {
    return op == Op::load || op == Op::guarded_load || op == Op::image_load || op == Op::image_sample ||
           op == Op::image_gather || op == Op::image_compare;
}

/// Whether what is passed is a structure, or a range of one.
inline bool is_structure(const KernelParam& param) {
    return param.pattern != Pattern::value && param.pattern != Pattern::argument;
}

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
/// The parameter's range is the iteration, or moves along with it.
inline bool follows_iteration(Pattern pattern) { return traits_of(pattern).course != Course::stays; }
/// Has a range of its own size.
inline bool has_own_range(Pattern pattern) {
    return traits_of(pattern).course == Course::stays && traits_of(pattern).reach != Reach::nothing;
}

/// Whether the parameter's addresses map directly to the binding's memory, so that the parameter's reach applies to it.
bool is_addressed(const Program& program, const Kernel& kernel, const PassBinding& binding);

/// Whether the bindings may alias in a call (docs/language.md, "One memory given twice"): both are the invocation's own
/// elements, of structures of one type.
bool may_be_one_place(const Program& program, const Kernel& kernel, const PassBinding& one, const PassBinding& other);

/// Whether two bindings of a lowered pass may alias.
bool has_one_place(const Pass& pass);

/// Whether invocations may race if both parameters are given the same whole structure.
bool may_meet(const KernelParam& one, const KernelParam& other);

/// Whether the kernel promises that what it accesses by these parameters is apart.
bool is_promised_apart(const Kernel& kernel, std::uint32_t one, std::uint32_t other);

/// When the depth of a fragment is tested: before its part runs, or after. `declared`: before, although the part has
/// effects that Vulkan orders before the test unless it is told otherwise.
enum class DepthOrder : std::uint8_t { before, declared, after };
DepthOrder depth_order(const Program& program, const Pass& pass);

/// The translator of the structure or of its memory that is declared many-to-one; or null.
const Translator* many_to_one_stage(const Program& program, std::uint32_t structure);

}  // namespace gliftc::ir
