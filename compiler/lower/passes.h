// The passes over a lowered kernel: each a name, what it needs, what it guarantees, and the function that runs it.
// pipeline.cpp runs them in the order of the table; --dump-after=NAME prints what each leaves; tests run them one by
// one on the text of the IR.
#pragma once

#include "lower/context.h"

#include <span>
#include <string_view>

namespace gliftc::lower {

/// One transformation of statements of memory. What it guarantees holds besides: the same values in the same order.
struct BodyPass {
    std::string_view name;
    std::string_view needs;
    std::string_view guarantees;
    /// `facts` are conditions that hold on the whole body.
    std::vector<StmtId> (*run)(Context& cx, const std::vector<StmtId>& body, const std::vector<ExprId>& facts);
    /// Whether the kernel is one that the pass is for; null: all are.
    bool (*applies)(const Context& cx) = nullptr;
};

/// In the order in which they run over every body: that of one element, of two, of the interior, and functions'.
std::span<const BodyPass> body_passes();

/// In the order in which they run over what the host device runs, after all of the above: they make a variant of it.
std::span<const BodyPass> host_passes();

/// A step that makes a body, or that sees all bodies of a pass.
struct KernelPass {
    std::string_view name;
    std::string_view needs;
    std::string_view guarantees;
};

/// In order. Those up to "coarsen" make the bodies that the body passes then take; the others take what these leave,
/// "find_rows" what the passes for the host device leave.
std::span<const KernelPass> kernel_passes();

/// Whether --dump-after and --stop-after know the name.
bool is_pass(std::string_view name);

}  // namespace gliftc::lower
