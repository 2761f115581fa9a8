#include "sema/one_memory.h"

#include "ir/effects.h"

namespace gliftc::sema {

namespace {

bool are_one_structure(const ir::Expr& one, const ir::Expr& other) {
    return one.op == ir::Op::structure_value && other.op == ir::Op::structure_value && one.local == other.local &&
           one.place == other.place;
}

void report(Context& c, const ir::Kernel& kernel, const ir::KernelParam& one, const ir::KernelParam& other, Span span) {
    Diagnostic& diagnostic =
        c.error(Diag::one_memory, span, {c.text(one.name), c.text(other.name), c.text(kernel.name)});
    note(diagnostic, one.span, "'" + c.text(one.name) + "' is declared here");
    note(diagnostic, other.span, "'" + c.text(other.name) + "' is declared here");
    note(diagnostic, span, "write into another structure, then copy or swap");
}

}  // namespace

void check_one_memory(Context& c, const ir::Kernel& kernel, const ir::Operands& arguments) {
    for (std::size_t k = 1; k < arguments.size(); ++k) {
        const ir::Expr& second = c.program.exprs[arguments[k]];
        for (std::size_t i = 0; i < k; ++i) {
            if (!are_one_structure(c.program.exprs[arguments[i]], second)) continue;
            if (!ir::may_meet(kernel.params[i], kernel.params[k])) continue;
            return report(c, kernel, kernel.params[i], kernel.params[k], second.span);
        }
    }
}

}  // namespace gliftc::sema
