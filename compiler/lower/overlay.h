// For lowering kernels on several threads (pipeline.cpp). The program is the base, of which each thread has an overlay:
// a program that sees the base's nodes, which no thread changes meanwhile, and adds its own. Afterwards the overlays'
// nodes are moved to the base in the order of the kernels ("merged"), so that the result does not depend on which
// thread did what. Expressions and statements are not copied: the arenas hand over whole blocks of memory.
#pragma once

#include "ir/pass.h"
#include "lower/transform/compact.h"

#include <vector>

namespace gliftc::lower {

struct Overlay {
    /// The base must outlive the overlay, and must not change until the overlay has added its last node.
    explicit Overlay(const ir::Program& base);
    Overlay(const Overlay&) = delete;

    Names names;
    ir::Program program;
    // Names and types with ids below first_name and first_type are the base's own. For those that the overlay added,
    // base_names and base_types have the base's ids, as far as they have been merged.
    const std::uint32_t first_name, first_type;
    std::vector<Name> base_names;
    std::vector<ir::TypeId> base_types;
};

/// The nodes that an overlay made for one kernel: those from `begin` to `end`. They refer only to each other and to
/// nodes of the base. After merge() they are in the base from `to` on.
struct Growth {
    Overlay* overlay = nullptr;
    Mark begin, end;
    std::uint32_t names = 0, types = 0;  ///< how many names and types the overlay had at `end`
    Mark to;
};

/// Prepares the program for overlays: fills up the last blocks of its arenas of expressions and statements, so that
/// those that overlays add begin new blocks. Called once before the overlays are made.
void prepare_for_overlays(ir::Program& base);

/// Calls `lower`, which lowers one kernel in the overlay, and returns the range of nodes that this added. Fills up the
/// last blocks of expressions and statements, since merge() moves whole blocks.
template <class Lower> Growth record_growth(Overlay& overlay, Lower&& lower) {
    const Mark begin(overlay.program);
    lower();
    overlay.program.exprs.fill_block();
    overlay.program.stmts.fill_block();
    const Mark end(overlay.program);
    return {&overlay, begin, end, overlay.names.size(), overlay.program.types.size(), end};
}

/// Moves the growth's nodes to the base and sets growth.to. Called for one growth at a time, in the order of the
/// kernels, which is also the order in which each overlay made its growths.
void merge(ir::Program& base, Growth& growth);

/// Replaces the overlay's ids in the merged nodes, and in the forms that refer to them, by the base's. Different
/// growths may be renumbered on different threads.
void renumber(ir::Program& base, const Growth& growth, ir::Lowered::Forms& forms);

}  // namespace gliftc::lower
