// Properties of access patterns (patterns.def: how a kernel's parameter is accessed), and questions about which
// accesses of a kernel may conflict, when a draw tests depth, and what C++ may write.
#pragma once

#include "ir/pass.h"

namespace gliftc::ir {

/// Whether the operation reads the memory of a binding. Not asked of Op::row_load, which the last pass of lowering
/// makes of loads, for the host device only.
inline bool is_load(Op op) {
    return op == Op::load || op == Op::guarded_load || op == Op::image_load || op == Op::image_sample ||
           op == Op::image_gather || op == Op::image_compare;
}

/// Whether the parameter takes a structure or a range of one, and not a value.
inline bool is_structure(const KernelParam& param) {
    return param.pattern != Pattern::value && param.pattern != Pattern::argument;
}

// The columns of patterns.def, which explains them.
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
/// Whether the parameter's range is visited, or has the size of those that are.
inline bool follows_iteration(Pattern pattern) { return traits_of(pattern).course != Course::stays; }
/// Whether the parameter's elements are accessed, in a range whose size is independent of the visited ones.
inline bool has_own_range(Pattern pattern) {
    return traits_of(pattern).course == Course::stays && traits_of(pattern).reach != Reach::nothing;
}

/// Whether the binding is the memory with the elements of the kernel's parameter, to which the parameter's pattern
/// applies, and not a table that translators read.
bool is_addressed(const Program& program, const Kernel& kernel, const PassBinding& binding);

/// Whether the two bindings may be aliases of one element (docs/reference/language.md, "Aliasing", where
/// all are `each`): both hold the elements of their parameters, which are of one structure type and access only the
/// invocation's own element. The other ways of giving one memory twice do not count here.
bool may_be_one_place(const Program& program, const Kernel& kernel, const PassBinding& one, const PassBinding& other);

/// Whether two bindings of the pass may be aliases of one element (PassBinding::one_place).
bool has_one_place(const Pass& pass);

/// Whether invocations may race if both parameters are given the same whole structure.
bool may_meet(const KernelParam& one, const KernelParam& other);

/// Whether the kernel declares these two parameters @disjoint.
bool is_promised_apart(const Kernel& kernel, std::uint32_t one, std::uint32_t other);

/// When the depth of a fragment is tested: before the fragment part runs, or after. `declared`: before, although the
/// fragment part writes memory; Vulkan would then test afterwards unless the shader declares early_fragment_tests.
/// depth_order() is only for passes that draw with a depth target.
enum class DepthOrder : std::uint8_t { before, declared, after };
DepthOrder depth_order(const Program& program, const Pass& pass);

/// The first translator that is declared @many_to_one, among those of the structure, then of the structures that are
/// its memory (ir/chain.h); null if there is none.
const Translator* many_to_one_stage(const Program& program, StructureId structure);

/// Whether the memory that has the structure's elements has the format d32.
bool has_depth_format(const Program& program, const Structure& structure);

/// Whether C++ may write and fill boxes of the structure. False for views; for structures with a translator that is
/// declared @many_to_one, which only kernels write, by scatter or coherent access; and for depths, which only draws
/// write.
bool is_written_in_boxes(const Program& program, StructureId structure);

}  // namespace gliftc::ir
