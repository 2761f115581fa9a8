// Definite assignment: reports variables (the corner's place, varyings, clip distances, colour targets) that some path
// through the vertex or fragment part of a draw does not assign, and a corner that is placed twice on a path, or in a
// loop.
#include "ir/walk.h"
#include "sema/kernels/raster.h"

#include <set>

namespace gliftc::sema {

namespace {

using Locals = std::set<ir::LocalId>;

Locals intersection(const Locals& one, const Locals& other) {
    Locals result;
    for (ir::LocalId local : one)
        if (other.contains(local)) result.insert(local);
    return result;
}

Locals united(Locals one, const Locals& other) {
    one.insert(other.begin(), other.end());
    return one;
}

/// At a statement: `always` are the locals assigned on every path to it, `sometimes` those assigned on some path.
/// `ends`: control flow does not reach the statement that follows.
struct State {
    Locals always, sometimes;
    bool ends = false;
};

class Assigned {
public:
    Assigned(Context& context, ir::LocalId once) : c(context), once_(once) {}

    /// The locals that are assigned on every path through the part, except paths that end in `discard`; absent: all
    /// paths end in `discard`.
    std::optional<Locals> of(const std::vector<ir::StmtId>& part) {
        State state;
        walk(part, state);
        leave(state);
        return result_;
    }

private:
    void walk(const std::vector<ir::StmtId>& body, State& state) {
        for (ir::StmtId id : body) {
            if (state.ends) return;
            visit(c.program.stmts[id], state);
        }
    }

    void visit(const ir::Stmt& stmt, State& state) {
        switch (stmt.op) {
        case ir::StmtOp::assign: return assign(stmt, state);
        case ir::StmtOp::block: return walk(stmt.body, state);
        case ir::StmtOp::return_: leave(state); break;
        case ir::StmtOp::discard:
        case ir::StmtOp::break_:
        case ir::StmtOp::continue_: state.ends = true; return;
        case ir::StmtOp::if_: return branch(stmt, state);
        case ir::StmtOp::for_:
        case ir::StmtOp::while_: {
            State round = state;
            ++loops_;
            walk(stmt.body, round);
            --loops_;
            state.sometimes = united(state.sometimes, round.sometimes);
            return;
        }
        default: return;
        }
    }

    void assign(const ir::Stmt& stmt, State& state) {
        const ir::Expr& target = c.program.exprs[stmt.target];
        if (target.op != ir::Op::local) return;
        const bool is_second = state.sometimes.contains(target.local) || loops_ > 0;
        if (target.local == once_ && is_second)
            note(c.error(Diag::place_twice, stmt.span), stmt.span,
                 "a corner has one place: choose it with '?:' or in a local, then place it once");
        state.always.insert(target.local);
        state.sometimes.insert(target.local);
    }

    void branch(const ir::Stmt& stmt, State& state) {
        State yes = state, no = state;
        walk(stmt.body, yes);
        walk(stmt.otherwise, no);
        if (yes.ends || no.ends) {
            state = yes.ends ? no : yes;
        } else {
            state.always = intersection(yes.always, no.always);
            state.sometimes = united(yes.sometimes, no.sometimes);
        }
    }

    void leave(State& state) {
        if (state.ends) return;
        result_ = result_ ? intersection(*result_, state.always) : state.always;
        state.ends = true;
    }

    Context& c;
    ir::LocalId once_;
    std::optional<Locals> result_;
    unsigned loops_ = 0;
};

void check_vertex(Context& c, const ir::Kernel& kernel) {
    const ir::Raster& raster = *kernel.raster;
    const std::optional<Locals> assigned = Assigned(c, raster.place).of(kernel.body);
    const Locals none;
    const Locals& always = assigned ? *assigned : none;
    if (!always.contains(raster.place))
        note(c.error(Diag::place_missing, kernel.span, {kernel.display}), kernel.span,
             "place(p) says where the corner is, in clip coordinates");
    for (const ir::Varying& varying : raster.varyings)
        if (!always.contains(varying.written))
            note(c.error(Diag::varying_unassigned, varying.span, {c.text(varying.name), "vertex"}), varying.span,
                 "the fragment part reads what each corner gives it");
    for (ir::LocalId distance : raster.clip_distances)
        if (!always.contains(distance))
            note(c.error(Diag::varying_unassigned, c.program.locals[distance].span, {"clip_distance", "vertex"}),
                 c.program.locals[distance].span, "give every corner a distance: 1.0 where nothing is to be clipped");
}

void check_fragment(Context& c, const ir::Kernel& kernel) {
    const ir::Raster& raster = *kernel.raster;
    if (!raster.has_fragment) {
        for (const ir::ColourTarget& target : raster.colours)
            note(c.error(Diag::varying_unassigned, kernel.params[target.param].span,
                         {c.text(kernel.params[target.param].name), "fragment"}),
                 kernel.span, "there is no fragment part: 'fragment { … }'");
        return;
    }
    const std::optional<Locals> assigned = Assigned(c, {}).of(raster.fragment);
    if (!assigned) return;  // every path discards
    for (const ir::ColourTarget& target : raster.colours)
        if (!assigned->contains(target.value))
            note(c.error(Diag::varying_unassigned, kernel.params[target.param].span,
                         {c.text(kernel.params[target.param].name), "fragment"}),
                 kernel.params[target.param].span, "a fragment that draws nothing says so: 'discard;'");
}

}  // namespace

void check_assigned(Context& c, const ir::Kernel& kernel) {
    check_vertex(c, kernel);
    check_fragment(c, kernel);
}

}  // namespace gliftc::sema
