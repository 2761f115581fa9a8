// Values of the device: what pipelines compute from elements that the host does not know.
//
// An expression with such a value in it is *open* while it is checked: a tree of the types that the language has, whose
// leaves are Op::device_value. Where it is used it is *closed*: a pass of one invocation computes it, and what is left
// is a value of a device type.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// While it lives, operands are checked as parts of an expression that a pass may compute.
class Parts {
public:
    explicit Parts(Body& body) : body_(body), outer_(body.is_open) { body.is_open = true; }
    ~Parts() { body_.is_open = outer_; }
    Parts(const Parts&) = delete;

private:
    Body& body_;
    bool outer_;
};

/// An operand of such an expression.
Operand check_part(Body&, ast::ExprId);
/// Whether a pass must compute the expression.
bool is_open(const Body&, ir::ExprId);
/// A value of a device type as a leaf of an expression; other operands are what they are.
Operand opened(Body&, Operand);
ir::ExprId opened(Body&, ir::ExprId);
/// An open expression as a value of a device type; other operands are what they are.
Operand closed(Body&, Operand);
ir::ExprId closed(Body&, ir::ExprId);
/// A value of the host on the device.
ir::ExprId on_device(Body&, ir::ExprId);
bool is_on_device(const Body&, ir::ExprId);

/// Lets a kernel's value lie on the device.
void make_argument(Context&, ir::Kernel&, std::size_t param, Span use);
/// A kernel some of whose values are on the device.
std::uint32_t kernel_with_arguments(Context&, std::uint32_t kernel, const std::vector<bool>& on_device, Span use);

}  // namespace gliftc::sema
