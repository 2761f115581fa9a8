// Values of the device: values that a pipeline computes from elements of structures, so that the host does not know
// them.
//
// While such an expression is being checked it is *open*: a tree of plain types, as if the host knew the values, whose
// leaves on the device are nodes Op::device_value. Where the whole expression is used it is *closed*: one pass of one
// invocation computes it, and a call of that pass replaces the tree, with a device type. An expression that is a single
// leaf needs no pass: it is replaced by the leaf's operand, which has a device type.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// While an object of this class lives, expressions are checked as operands of a larger one: values on the device stay
/// open, so that one pass computes the larger expression as a whole.
class Parts {
public:
    explicit Parts(Body& body) : body_(body), outer_(body.is_open) { body.is_open = true; }
    ~Parts() { body_.is_open = outer_; }
    Parts(const Parts&) = delete;

private:
    Body& body_;
    bool outer_;
};

/// Checks an operand of a larger expression: check() while a Parts lives.
Operand check_part(Body&, ast::ExprId);
/// Whether the expression has a leaf on the device, so that the host cannot evaluate it.
bool is_open(const Body&, ir::ExprId);
/// Makes a value of a device type a leaf (Op::device_value) of an open expression; returns any other operand unchanged.
Operand opened(Body&, Operand);
ir::ExprId opened(Body&, ir::ExprId);
/// Replaces an open expression by a value of a device type, which a pass computes unless the expression is a single
/// leaf; returns any other operand unchanged.
Operand closed(Body&, Operand);
ir::ExprId closed(Body&, ir::ExprId);
/// Computes the expression in a pass, even if the host knows its value; gives a value of a device type. Reports an
/// expression whose type cannot lie on the device.
ir::ExprId on_device(Body&, ir::ExprId);
/// Whether the expression has a device type.
bool is_on_device(const Body&, ir::ExprId);

/// Changes a value parameter of the kernel to pattern `argument`: a value on the device.
void make_argument(Context&, ir::Kernel&, std::size_t param, Span use);
/// Makes a copy of the kernel in which each parameter i with on_device[i] takes a value on the device; the same copy is
/// made only once.
ir::KernelId kernel_with_arguments(Context&, ir::KernelId kernel, const std::vector<bool>& on_device, Span use);

}  // namespace gliftc::sema
