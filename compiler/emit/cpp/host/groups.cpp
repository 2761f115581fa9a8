// Prints kernels with a workgroup size (`group`) as C++ for the host device. They are split at their barriers
// (lower/host/split_at_barriers.h). Each CPU thread runs whole workgroups, one after another. The statement
// `invocations` is a loop over the invocations of a workgroup. A local that must live beyond one such loop (`keep`) is
// an array with an element for each invocation.
#include "emit/cpp/host/body.h"
#include "ir/walk.h"

#include <map>

namespace gliftc::host {

namespace {

using ir::ExprId;
using ir::LocalId;
using ir::Stmt;
using ir::StmtId;
using ir::StmtOp;

struct Groups {
    Body body;
    const ir::Program& program;
    const ir::Pass& pass;
    cpp::Printer& p;
    std::map<LocalId, std::string> arrays;  ///< names of the arrays for locals that are kept
    std::string invocation = "0";           ///< the index into them: `local_index` within `invocations`, else `0`
    bool may_return = false;

    Groups(cpp::Globals& globals, const ir::Pass& pass);

    std::string size() const { return std::to_string(pass.group[0] * pass.group[1] * pass.group[2]); }
    void print_keep(LocalId local);
    void print_ids(const std::vector<StmtId>& list);
    void print_invocations(const std::vector<StmtId>& list);
    void print_statement(const Stmt& stmt, const std::function<void(const Stmt&)>& print_other);
};

Groups::Groups(cpp::Globals& globals, const ir::Pass& pass)
    : body(globals, pass, cpp::locals_of_groups), program(globals.program), pass(pass), p(body.p) {
    body.first_only = true;
    body.group_text = "uint3(" + std::to_string(pass.group[0]) + ", " + std::to_string(pass.group[1]) + ", " +
                      std::to_string(pass.group[2]) + ")";
    p.outer_local = [this](LocalId local) {
        const auto found = arrays.find(local);
        return found == arrays.end() ? std::string() : found->second + "[" + invocation + "]";
    };
    p.outer_statement = [this, print_other = p.outer_statement](const Stmt& stmt) {
        print_statement(stmt, print_other);
    };
}

void Groups::print_keep(LocalId local) {
    const ir::Local& declared = program.locals[local];
    arrays[local] = p.names.declare((*program.names)[declared.name]);
    p.out.line(cpp::type_text(p.globals, declared.type) + " " + arrays[local] + "[" + size() + "];");
}

/// Declares those ids of an invocation that the statements use.
void Groups::print_ids(const std::vector<StmtId>& list) {
    const std::array<std::uint32_t, 3>& g = pass.group;
    const std::string x = std::to_string(g[0]), y = std::to_string(g[1]);
    bool local_id = false, global_id = false;
    ir::for_each_expression(program, list, [&](ir::ExprId node) {
        const ir::Expr& expr = program.exprs[node];
        if (expr.op != ir::Op::builtin) return;
        local_id = local_id || expr.builtin == ir::Builtin::local_id;
        global_id = global_id || expr.builtin == ir::Builtin::global_id;
    });
    if (local_id || global_id)
        p.out.line("const uint3 local_id{local_index % " + x + ", local_index / " + x + " % " + y + ", local_index / " +
                   std::to_string(g[0] * g[1]) + "};");
    if (global_id)
        p.out.line("const uint3 global_id = group_id * uint3(" + x + ", " + y + ", " + std::to_string(g[2]) +
                   ") + local_id;");
}

void Groups::print_invocations(const std::vector<StmtId>& list) {
    invocation = "local_index";
    body.first_only = false;
    p.out.open("for (uint local_index = 0; local_index < " + size() + "; ++local_index)");
    if (may_return) p.out.line("if (returned[local_index]) continue;");
    print_ids(list);
    p.names.enter();
    bool returns_in_loop = false;
    ir::for_each_statement(program, list, [&](const Stmt& stmt) {
        if (stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_)
            returns_in_loop = returns_in_loop || returns_early(program, stmt.body);
    });
    p.print_return = [this, returns_in_loop](ExprId) {
        p.out.line("returned[local_index] = true;");
        p.out.line(returns_in_loop ? "return;" : "continue;");
    };
    if (returns_in_loop) p.out.open("[&]");
    cpp::print_statements(p, list);
    if (returns_in_loop) p.out.close("();");
    p.names.leave();
    p.out.close();
    invocation = "0";
    body.first_only = true;
}

void Groups::print_statement(const Stmt& stmt, const std::function<void(const Stmt&)>& print_other) {
    if (stmt.op == StmtOp::keep) return print_keep(stmt.local);
    if (stmt.op == StmtOp::invocations) return print_invocations(stmt.body);
    if (stmt.op == StmtOp::barrier) return p.out.line("// barrier: ends a loop over the invocations");
    print_other(stmt);
}

}  // namespace

std::string group_kernel(cpp::Globals& globals, const ir::Pass& pass, const std::string& name) {
    Groups groups(globals, pass);
    cpp::Printer& p = groups.p;
    const std::vector<StmtId>& all = variant_for(pass, ir::Devices::host).body;
    groups.may_return = returns_early(globals.program, all);

    p.out.indent();
    print_local_functions(groups.body);
    for (LocalId local : pass.shared) {
        const std::string type = cpp::type_text(globals, globals.program.locals[local].type);
        p.out.line(type + " " + cpp::declare_local(p, local) + ";");
    }
    if (groups.may_return) p.out.line("bool returned[" + groups.size() + "] = {};");
    cpp::print_statements(p, all);
    const std::string text = p.out.take();

    const ir::Kernel& kernel = globals.program.kernels[pass.kernel];
    const std::string extent =
        std::to_string(pass.group[0]) + ", " + std::to_string(pass.group[1]) + ", " + std::to_string(pass.group[2]);
    cpp::Writer out;
    out.line("// " + cpp::place_text(globals.sources, kernel.span) + ": runs one workgroup of " + kernel.display + ".");
    out.line("GLIFT_HOST_KERNEL");
    out.open(
        "static void " + name +
        "_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id, [[maybe_unused]] uint3 group_count)");
    out.line("[[maybe_unused]] constexpr uint group_size = " + groups.size() + ";");
    out.line("[[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + "
             "group_id.x;");
    out.line("[[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;");
    declare_used(groups.body, out, name);
    out.raw(text);
    out.close();
    out.gap();
    out.open("static void " + name + "(const glift::HostCall& call)");
    const std::string covered = std::to_string(pass.group[0] * pass.items) + ", " + std::to_string(pass.group[1]) +
                                ", " + std::to_string(pass.group[2]);
    out.line("glift::host::for_each_group(call.size, uint3(" + covered + "), [&](uint3 group_id, uint3 group_count) {");
    out.line("    " + name + "_group(call, group_id, group_count);");
    out.line("});");
    out.close();
    return out.take();
}

}  // namespace gliftc::host
