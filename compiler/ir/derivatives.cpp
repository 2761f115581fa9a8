#include "ir/derivatives.h"

#include "ir/intrinsics.h"
#include "ir/variants.h"
#include "ir/walk.h"

#include <algorithm>
#include <set>

namespace gliftc::ir {

namespace {

/// Data-flow analysis that finds the locals that depend on loads, iterated to a fixed point.
class Loads {
public:
    Loads(const Program& program, const Pass& pass) : program_(program), pass_(pass) {}

    bool reach_derivatives(const std::vector<StmtId>& body) {
        std::size_t known = 0;
        do {
            known = loaded_.size();
            is_left_ = is_out_ = false;
            run(body, false);
        } while (known != loaded_.size() && !is_derived_);
        return is_derived_;
    }

private:
    bool is_load(const Expr& expr) const {
        if (expr.op == Op::load || expr.op == Op::guarded_load) return true;
        if (expr.op == Op::image_load) return !pass_.bindings[expr.slot].sampled;
        if (expr.op == Op::parameter) return !pass_.push_constants && !pass_.uniform_buffer;
        if (expr.op == Op::call) return loads_in(program_.functions[expr.function].body);
        return expr.op == Op::local && loaded_.contains(expr.local);
    }

    bool loads_in(const std::vector<StmtId>& body) const {
        bool found = false;
        for_each_expression(program_, body, [&](ExprId id) { found = found || is_load(program_.exprs[id]); });
        return found;
    }

    /// Whether the expression depends on a load; also notes derivatives in it whose operand, or evaluation, depends on
    /// one (is_derived_). `in_doubt`: whether the expression is evaluated depends on a load.
    bool value(ExprId id, bool in_doubt) {
        const Expr& expr = program_.exprs[id];
        const bool may_skip =
            expr.op == Op::select ||
            (expr.op == Op::binary && (expr.binary == BinaryOp::logical_and || expr.binary == BinaryOp::logical_or));
        bool depends = is_load(expr);
        for (ExprId operand : expr.operands) {
            depends = value(operand, in_doubt) || depends;
            if (may_skip) in_doubt |= depends;  // the first operand decides about the others
        }
        if (expr.op == Op::intrinsic && is_derivative(expr.intrinsic)) is_derived_ |= depends || in_doubt;
        return depends;
    }

    void run(const std::vector<StmtId>& body, bool in_doubt) {
        for (StmtId id : body) {
            const Stmt& stmt = program_.stmts[id];
            const bool here = in_doubt || is_left_ || is_out_;
            bool depends = false;
            for_each_root(stmt, [&](ExprId root) { depends = value(root, here) || depends; });
            const bool assigns = stmt.op == StmtOp::let || stmt.op == StmtOp::assign || stmt.op == StmtOp::for_;
            if (assigns && (depends || here)) {
                const LocalId local = stmt.op == StmtOp::assign ? place_of(program_, stmt.target).local : stmt.local;
                loaded_.insert(local);
            }
            is_left_ |= here && (stmt.op == StmtOp::return_ || stmt.op == StmtOp::discard);
            is_out_ |= here && (stmt.op == StmtOp::break_ || stmt.op == StmtOp::continue_);
            if (stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_) {
                run_loop(stmt.body, here || depends);
                continue;
            }
            run(stmt.body, here || depends);
            run(stmt.otherwise, here || depends);
        }
    }

    /// If a load decides whether the loop or the fragment part is left, it also decides whether the statements of later
    /// iterations are executed: the body is then analysed a second time, with `in_doubt` true.
    void run_loop(const std::vector<StmtId>& body, bool in_doubt) {
        const bool was_out = is_out_;
        run(body, in_doubt);
        if (is_out_ || is_left_) run(body, true);
        is_out_ = was_out;
    }

    const Program& program_;
    const Pass& pass_;
    std::set<LocalId> loaded_;
    // Whether a return or discard (is_left_), or a break or continue of the current loop (is_out_), that depends on a
    // load has been seen.
    bool is_left_ = false, is_out_ = false;
    bool is_derived_ = false;  ///< a derivative depends on a load
};

}  // namespace

bool derives_loads(const Program& program, const Pass& pass) {
    if (!program.kernels[pass.kernel].raster) return false;
    const Variant* fragment = fragment_for(pass, Devices::shaders);
    return fragment != nullptr && Loads(program, pass).reach_derivatives(fragment->body);
}

}  // namespace gliftc::ir
