#include "layout/nesting.h"

#include "ir/variants.h"
#include "ir/walk.h"

#include <algorithm>
#include <unordered_map>

namespace gliftc::layout {

using namespace ir;

namespace {

/// A number of levels, and the innermost statement there.
struct Depth {
    unsigned levels = 0;
    Span span;

    void include(const Depth& other) {
        if (other.levels > levels) *this = other;
    }
};

class Nesting {
public:
    explicit Nesting(const Program& program) : p(program) {}

    Depth of(const std::vector<StmtId>& body) {
        Depth deepest;
        for (StmtId id : body) deepest.include(of(p.stmts[id]));
        return deepest;
    }

private:
    Depth of(const Stmt& stmt) {
        Depth inner;
        for_each_root(stmt, [&](ExprId root) {
            inner.include({selects_in(root), stmt.span});
            for_each_node(p, root, [&](ExprId id) {
                if (p.exprs[id].op == Op::call) inner.include(of(p.exprs[id].function));
            });
        });
        inner.include(of(stmt.body));
        inner.include(of(stmt.otherwise));
        const bool is_level = stmt.op == StmtOp::if_ || stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_;
        if (!is_level) return inner;
        return {inner.levels + 1, inner.levels == 0 ? stmt.span : inner.span};
    }

    /// How deep `?:` are nested in one another: shaders make branches of them.
    unsigned selects_in(ExprId id) {
        if (const auto found = selects_.find(id); found != selects_.end()) return found->second;
        const Expr& node = p.exprs[id];
        unsigned levels = 0;
        for (ExprId operand : node.operands) levels = std::max(levels, selects_in(operand));
        return selects_[id] = levels + (node.op == Op::select ? 1 : 0);
    }

    const Depth& of(FunctionId function) {
        const auto found = functions_.find(function);
        if (found != functions_.end()) return found->second;
        const Depth depth = of(p.functions[function].body);
        return functions_.emplace(function, depth).first->second;
    }

    const Program& p;
    std::unordered_map<FunctionId, Depth> functions_;
    std::unordered_map<ExprId, unsigned> selects_;
};

}  // namespace

void check_nesting(const Program& program, const Lowered& lowered, Diagnostics& diagnostics) {
    Nesting nesting(program);
    for (KernelId i : lowered.passes.ids()) {
        Depth deepest;
        for (const Pass* pass : lowered.passes[i].all())
            for (const Variant& variant : pass->variants)
                if (variant.devices != Devices::host) deepest.include(nesting.of(variant.body));
        if (deepest.levels <= nesting_limit) continue;
        const Kernel& kernel = program.kernels[i];
        Diagnostic& report =
            diagnostics.report(Diag::branches_too_deep, kernel.span,
                               {kernel.display, std::to_string(deepest.levels), std::to_string(nesting_limit)});
        report.notes.push_back(
            {deepest.span, "the innermost is here: join conditions by '&&', write a chain of '?:' as a chain of 'else "
                           "if', leave the function with 'return' or the loop with 'continue', or move the inner part "
                           "into a kernel of its own"});
    }
}

}  // namespace gliftc::layout
