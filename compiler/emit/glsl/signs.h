// Negations of floats that may be a choice between constants.
//
// NVIDIA's compiler (driver 580, seen on an H100) makes of `c ? 0.0 : 1.0`, as of step(), one instruction that turns a
// condition into a float, and drops the sign of zero where it negates the result: -(c ? 0.0 : 1.0) is never -0.0. It
// does so across variables and calls, and for -1.0 * x and -0.0 - x. It does not where the sign bit is changed as an
// integer. So negations of such values are calls of Helper::negative, which does that, and abs is Helper::magnitude.
// Doubles and halves keep the sign.
#pragma once

#include "emit/glsl/printer.h"

namespace gliftc::glsl {

/// Notes in Printer::choices the locals of a body that may hold a choice. `params` are parameters of a function: what
/// its callers pass is not known.
void find_choices(Printer& p, const std::vector<ir::LocalId>& params, const std::vector<ir::StmtId>& body);

/// The value whose negative the expression is, where only Helper::negative keeps the sign of zero; else absent.
ir::ExprId negated_choice(const Printer& p, const ir::Expr& expr);

/// Whether the value may be -0.0 where NVIDIA's compiler takes it for positive, and leaves out its abs: a choice
/// between constants, one of them -0.0.
bool may_be_chosen_negative_zero(const Printer& p, ir::ExprId id);

/// The components of a constant of floats; empty for any other expression.
std::vector<double> numbers_of(const Printer& p, ir::ExprId id);

/// Whether the expression is a choice between constants, in a component between two of 0.0, -0.0, 1.0 and -1.0, at
/// least one of them -0.0.
bool is_choice_of_negative_zero(const Printer& p, const ir::Expr& expr);

}  // namespace gliftc::glsl
