// The order of evaluation: operands from left to right, each of them once, and only where its value counts.
//
// An expression becomes a tree, and temporaries that it needs become statements before it. A statement must not
// overtake the operands on its left, and targets evaluate a tree in an order of their own. So the nodes whose place in
// the order matters are *pending* (Body::pending) until their statement ends: those that have an effect, and those
// whose value a later effect may change. Before the next effect they are put into locals.
#pragma once

#include "sema/bodies/body.h"

#include <span>

namespace gliftc::sema {

/// Makes the node pending: its value depends on when it is evaluated.
void add_read(Body&, ir::ExprId);
/// Makes the node pending: it has an effect. Pending nodes that are no part of it are settled.
void add_effect(Body&, ir::ExprId);
/// Whether the place, a variable or a part of one, is workgroup memory or host state, which calls in an expression
/// change.
bool is_changeable(const Body&, ir::ExprId place);
/// Where `whole` is such a place, and pending: the part of it is pending instead.
void add_part(Body&, ir::ExprId whole, ir::ExprId part);
/// Takes a node off the pending ones: it is the target of an assignment or of an atomic operation, and is not read.
void is_target(Body&, ir::ExprId);
/// Puts the pending nodes into locals, so that effects may follow, and the tree may be repeated. Leaves out nodes that
/// are parts of `roots`: the statement that comes next evaluates them.
void settle(Body&, std::span<const ir::ExprId> roots = {});

/// While an object of this class lives, what is checked adds statements and pending nodes to `steps`, not to the body.
class Recording {
public:
    Recording(Body&, Steps& steps);
    ~Recording();
    Recording(const Recording&) = delete;

private:
    Body& body_;
    Steps& steps_;
    std::vector<ir::StmtId>* block_;
    std::vector<Pending> pending_;
};

/// Evaluates the steps here: for operands that are checked in another order than they are written in.
void append(Body&, Steps&&);

/// A value that is evaluated only under a condition.
struct Alternative {
    ir::ExprId value;
    Steps steps;
};
template <class Check> Alternative recorded(Body& body, Check&& check) {
    Alternative made;
    {
        const Recording recording(body, made.steps);
        made.value = check();
    }
    return made;
}
/// `condition ? yes : no`. If an alternative has statements, the choice is an `if` that assigns a variable; but if the
/// condition lies on the device, its statements precede the choice.
ir::ExprId choose_value(Body&, ir::ExprId condition, Alternative yes, Alternative no, Span);
/// `left && right` or `left || right`, where the value of `right` may not count.
ir::ExprId choose_logical(Body&, ir::BinaryOp, ir::ExprId left, Alternative right, Span);

}  // namespace gliftc::sema
