// What lowering shows of its passes, for --dump-after and --stop-after.
#pragma once

#include "ir/pass.h"

#include <string>
#include <string_view>
#include <vector>

namespace gliftc::lower {

struct Trace {
    std::string dump_after;  ///< a pass of passes.h; empty: none
    std::string stop_after;
    std::string text;  ///< what each body of the root modules' kernels was after dump_after; read.h reads it

    bool is_on() const { return !dump_after.empty() || !stop_after.empty(); }
    /// Writes variants down if they are asked for. `what` names them: "body", "two elements", "interior", a function.
    void note(std::string_view pass_name, const ir::Program& program, const ir::Pass& pass,
              const std::vector<ir::Variant>& variants, const std::vector<ir::ExprId>& facts, std::string_view what);
    /// Writes functions of the root modules down that all passes share, as those of their module's first kernel.
    void note(std::string_view pass_name, const ir::Program& program, const std::vector<ir::FunctionId>& functions);
};

}  // namespace gliftc::lower
