// The trace of lowering's passes, for --dump-after and --stop-after.
#pragma once

#include "ir/pass.h"

#include <string>
#include <string_view>
#include <vector>

namespace gliftc::lower {

struct Trace {
    std::string dump_after;  ///< the name of a pass of passes.h; empty: none
    std::string stop_after;  ///< the name of the pass after which lowering stops; empty: it does not stop
    /// The bodies after pass `dump_after`, of kernels of root modules (those named on the command line); syntax:
    /// ir/read.h.
    std::string text;

    bool is_on() const { return !dump_after.empty() || !stop_after.empty(); }
    /// Called after a pass: adds the variants to the text if the pass is dump_after. `what` says which body it is:
    /// "body", "two elements", "interior", the name of a function, ….
    void note(std::string_view pass_name, const ir::Program& program, const ir::Pass& pass,
              const std::vector<ir::Variant>& variants, const std::vector<ir::ExprId>& facts, std::string_view what);
    /// The same for functions of the root modules that all kernels share. They are printed as functions of the first
    /// kernel of their module, and left out if the module has no kernel.
    void note(std::string_view pass_name, const ir::Program& program, const std::vector<ir::FunctionId>& functions);
};

}  // namespace gliftc::lower
