// What orders reads and writes around it without a barrier of the workgroup: atomic operations between workgroups, and
// barriers of a subgroup.
//
// On lavapipe (Mesa 22.3) the fence that these bring is a barrier: where only some subgroups of a workgroup reach it,
// the others are ended silently. There operations that read and write at once order everything by themselves,
// since they are sequentially consistent, and a subgroup does its statements one after the other. The runtime says so
// by constant 102.
#include "emit/glsl/printer.h"
#include "ir/walk.h"

namespace gliftc::glsl {

using ir::Intrinsic;

namespace {

bool has_subgroup_barrier(const Printer& p) {
    bool found = false;
    ir::for_each_statement(p.program, p.body(),
                           [&](const ir::Stmt& stmt) { found = found || stmt.op == ir::StmtOp::subgroup_barrier; });
    return found;
}

bool has_compare_exchange(const Printer& p) {
    bool found = false;
    const auto look = [&](const std::vector<ir::StmtId>& body) {
        ir::for_each_expression(p.program, body, [&](ir::ExprId id) {
            const ir::Expr& expr = p.program.exprs[id];
            found = found || (expr.op == ir::Op::intrinsic && expr.intrinsic == Intrinsic::atomicCompareExchange);
        });
    };
    look(variant_for(p.pass, ir::Devices::shaders).body);
    for (ir::FunctionId function : p.pass.functions) look(p.program.functions[function].body);
    return found;
}

}  // namespace

void name_order(Printer& p) {
    bool is_ordered = false;
    for (const ir::PassBinding& binding : p.pass.bindings)
        is_ordered = is_ordered || (binding.coherent && binding.atomic);
    if (is_ordered || has_subgroup_barrier(p)) p.order.fences = p.names.declare("fences_are_barriers");
    if (!is_ordered) return;
    p.order.load = p.names.declare("load_acquire");
    p.order.store = p.names.declare("store_release");
    p.order.both = p.names.declare("ordered");
    if (has_compare_exchange(p)) p.order.exchange = p.names.declare("compare_exchange");
}

std::string ordered_atomic(Printer& p, const char* name, const ir::Expr& expr) {
    const std::string arguments = join_arguments(p, expr.operands);
    p.extensions.insert("GL_KHR_memory_scope_semantics");
    if (expr.intrinsic == Intrinsic::atomicLoad) return p.order.load + "(" + arguments + ")";
    if (expr.intrinsic == Intrinsic::atomicStore) return p.order.store + "(" + arguments + ")";
    if (expr.intrinsic == Intrinsic::atomicCompareExchange) return p.order.exchange + "(" + arguments + ")";
    return p.order.both + "(" + name + ", " + arguments + ")";
}

std::string subgroup_barrier(Printer& p, const std::string& memory) {
    p.extensions.insert("GL_KHR_memory_scope_semantics");
    return "if (!" + p.order.fences + ") controlBarrier(gl_ScopeSubgroup, gl_ScopeSubgroup, " + memory +
           ", gl_SemanticsAcquireRelease);";
}

std::string order_definitions(const Printer& p) {
    const OrderNames& names = p.order;
    if (names.fences.empty()) return "";
    const std::string fences = "layout(constant_id = 102) const bool " + names.fences +
                               " = false;   // a fence where not all subgroups come by cuts some off\n";
    if (names.load.empty()) return fences + "\n";
    const std::string where = "gl_ScopeDevice, gl_StorageSemanticsBuffer, gl_Semantics";
    const std::string exchange =
        names.exchange.empty()
            ? ""
            : "#define " + names.exchange + "(place, expected, value) (" + names.fences +
                  " ? atomicCompSwap(place, expected, value) : atomicCompSwap(place, expected, value, " + where +
                  "AcquireRelease, gl_StorageSemanticsBuffer, gl_SemanticsAcquire))\n";
    return fences + "#define " + names.load + "(place) (" + names.fences +
           " ? atomicOr(place, 0) : atomicLoad(place, " + where +
           "Acquire))\n"
           "#define " +
           names.store + "(place, value) if (" + names.fences +
           ") atomicExchange(place, value); else atomicStore(place, value, " + where +
           "Release)\n"
           "#define " +
           names.both + "(operation, place, value) (" + names.fences +
           " ? operation(place, value) : operation(place, value, " + where + "AcquireRelease))\n" + exchange + "\n";
}

}  // namespace gliftc::glsl
