// The tables of the passes (transformations) over a lowered kernel: each has a name, what it needs and what it
// guarantees; those over one body also have the function that runs them. pipeline.cpp runs the passes of each table in
// its order; --dump-after=NAME prints the code after pass NAME; tests run single passes on the text of the IR.
#pragma once

#include "lower/context.h"

#include <span>
#include <string_view>

namespace gliftc::lower {

/// A transformation of a body of memory operations. Each also guarantees that an invocation stores the same values in
/// the same order as before.
struct BodyPass {
    std::string_view name;
    std::string_view needs;
    std::string_view guarantees;
    /// `facts` are conditions that are known to hold throughout the body.
    std::vector<StmtId> (*run)(Context& cx, const std::vector<StmtId>& body, const std::vector<ExprId>& facts);
    /// Whether the pass is run for this kernel and, in a draw, this part (Context::part); null: always.
    bool (*applies)(const Context& cx) = nullptr;
};

/// The passes that run over every body, in order: bodies for one element and for several, for the interior of a domain
/// and for whole blocks, the parts of a draw, and functions.
std::span<const BodyPass> body_passes();

/// The passes that run over the bodies for the host device, in order, after move_uniforms. What they make of a body is
/// a variant for the host device alone.
std::span<const BodyPass> host_passes();

/// A step that works on functions that all kernels share, makes a body, works on all bodies of a kernel, or on a
/// variant for the host device.
struct KernelPass {
    std::string_view name;
    std::string_view needs;
    std::string_view guarantees;
};

/// These steps in order. Those up to "coarsen" come before the body passes, "move_uniforms" after them, the others
/// after the passes for the host device.
std::span<const KernelPass> kernel_passes();

/// Whether --dump-after and --stop-after know the name.
bool is_pass(std::string_view name);

}  // namespace gliftc::lower
