#include "ir/walk.h"
#include "lowered.h"

#include <set>

namespace gliftc {
namespace {

/// The number of nodes with an operation that can be reached from the passes and their functions.
std::size_t reachable(const Lowering& lowering, ir::Op op) {
    std::set<ir::ExprId> found;
    const auto note = [&](ir::ExprId id) {
        if (lowering.program.exprs[id].op == op) found.insert(id);
    };
    for (const ir::Lowered::Forms& forms : lowering.lowered.passes)
        for (const ir::Pass* pass : forms.all()) {
            for (const auto* body : bodies_of(*pass)) ir::for_each_expression(lowering.program, *body, note);
            for (ir::FunctionId function : pass->functions)
                ir::for_each_expression(lowering.program, lowering.program.functions[function].body, note);
        }
    return found.size();
}

TEST(Compact, KeepsOnlyWhatBelongsToAPass) {
    Lowering lowering(
        "fn rest(s: Edged, a: uint3) -> float { var x = 0.0; while x < s[a] { x += s[a] * 2.0; } return x; }"
        "kernel blur(f: in near<Field, 1>, g: out each<Field>) {"
        "    var sum = f[0];"
        "    for i in 0..2 { sum += f[int3(i, 0, 0)] + f[int3(0, 0, -i)]; }"
        "    g = sum; }"
        "kernel look(s: in any<Edged>, g: out each<Field>) { g = rest(s, position()); }");
    for (ir::Op op : {ir::Op::load, ir::Op::parameter, ir::Op::builtin}) {
        std::size_t made = 0;
        for (const ir::Expr& expr : lowering.program.exprs) made += expr.op == op;
        EXPECT_EQ(made, reachable(lowering, op));
        EXPECT_GT(made, 0u);
    }
}

}  // namespace
}  // namespace gliftc
