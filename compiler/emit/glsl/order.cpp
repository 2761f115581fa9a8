// Operations that order the reads and writes around them without a barrier of the workgroup: atomic operations on
// coherent memory, which workgroups share, and barriers of a subgroup.
//
// On lavapipe (Mesa 22.3) the memory fence of such an operation is a barrier of the workgroup: where only some
// subgroups reach it, the others are ended silently. But lavapipe needs no fences: its read-modify-write operations are
// sequentially consistent and so order everything by themselves, and the lanes of a subgroup run in lockstep. The
// runtime sets specialisation constant 102 on such devices.
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
    look(p.body());
    for (ir::FunctionId function : p.pass.functions) look(p.program.functions[function].body);
    return found;
}

/// imageAtomicAdd for atomicAdd.
std::string of_image(const std::string& name) { return "imageA" + name.substr(1); }

}  // namespace

void name_order(Printer& p) {
    bool are_buffers = false, are_images = false;
    for (const ir::PassBinding& binding : p.pass.bindings) {
        if (!binding.coherent || !binding.atomic) continue;
        (binding.shape == ir::MemoryShape::buffer ? are_buffers : are_images) = true;
    }
    if (are_buffers || are_images || has_subgroup_barrier(p)) p.fences = p.names.declare("fences_are_barriers");
    const auto declare = [&](OrderNames& names, const std::string& prefix) {
        names.load = p.names.declare(prefix + "load_acquire");
        names.store = p.names.declare(prefix + "store_release");
        names.both = p.names.declare(prefix + "ordered");
        if (has_compare_exchange(p)) names.exchange = p.names.declare(prefix + "compare_exchange");
    };
    if (are_buffers) declare(p.order, "");
    if (are_images) declare(p.image_order, "texel_");
}

std::string ordered_atomic(Printer& p, const char* name, const ir::Expr& expr) {
    const ir::Expr& place = p.program.exprs[expr.operands[0]];
    const bool is_texel = place.op == ir::Op::image_load;
    std::string arguments = is_texel ? p.binding_names[place.slot] + ", " + texel_text(p, place.operands[0])
                                     : print_place(p, expr.operands[0]);
    for (std::size_t i = 1; i < expr.operands.size(); ++i) arguments += ", " + print_any(p, expr.operands[i]);
    p.extensions.insert("GL_KHR_memory_scope_semantics");
    const OrderNames& names = is_texel ? p.image_order : p.order;
    if (expr.intrinsic == Intrinsic::atomicLoad) return names.load + "(" + arguments + ")";
    if (expr.intrinsic == Intrinsic::atomicStore) return names.store + "(" + arguments + ")";
    if (expr.intrinsic == Intrinsic::atomicCompareExchange) return names.exchange + "(" + arguments + ")";
    return names.both + "(" + (is_texel ? of_image(name) : name) + ", " + arguments + ")";
}

std::string subgroup_barrier(Printer& p, const std::string& memory) {
    p.extensions.insert("GL_KHR_memory_scope_semantics");
    return "if (!" + p.fences + ") controlBarrier(gl_ScopeSubgroup, gl_ScopeSubgroup, " + memory +
           ", gl_SemanticsAcquireRelease);";
}

namespace {

/// The macros of the ordered operations on `place` (an element of a buffer, or `image, at`). They order accesses to the
/// kinds of memory that `storage` names.
std::string operations(const Printer& p, const OrderNames& names, const std::string& place,
                       const std::string& storage) {
    if (names.load.empty()) return "";
    const auto operation = [&](const char* name) { return place == "place" ? name : of_image(name); };
    const std::string where = "gl_ScopeDevice, " + storage + ", gl_Semantics";
    const auto define = [&](const std::string& name, const std::string& parameters) {
        return "#define " + name + "(" + parameters + ") ";
    };
    const std::string swap = operation("atomicCompSwap") + "(" + place + ", expected, value";
    const std::string exchange = names.exchange.empty()
                                     ? ""
                                     : define(names.exchange, place + ", expected, value") + "(" + p.fences + " ? " +
                                           swap + ") : " + swap + ", " + where + "AcquireRelease, " + storage +
                                           ", gl_SemanticsAcquire))\n";
    return define(names.load, place) + "(" + p.fences + " ? " + operation("atomicOr") + "(" + place +
           ", 0) : " + operation("atomicLoad") + "(" + place + ", " + where + "Acquire))\n" +
           define(names.store, place + ", value") + "if (" + p.fences + ") " + operation("atomicExchange") + "(" +
           place + ", value); else " + operation("atomicStore") + "(" + place + ", value, " + where + "Release)\n" +
           define(names.both, "operation, " + place + ", value") + "(" + p.fences + " ? operation(" + place +
           ", value) : operation(" + place + ", value, " + where + "AcquireRelease))\n" + exchange;
}

}  // namespace

std::string order_definitions(const Printer& p) {
    if (p.fences.empty()) return "";
    const bool are_images = !p.image_order.load.empty();
    const std::string storage =
        are_images ? "gl_StorageSemanticsBuffer | gl_StorageSemanticsImage" : "gl_StorageSemanticsBuffer";
    return "// True on lavapipe, where a fence would end the subgroups that do not reach it: then no fence is used.\n"
           "layout(constant_id = 102) const bool " +
           p.fences + " = false;\n" + operations(p, p.order, "place", storage) +
           operations(p, p.image_order, "image, at", storage) + "\n";
}

}  // namespace gliftc::glsl
