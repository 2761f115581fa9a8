// Kernels with a group: one workgroup after the other on each thread. Barriers cut the body into regions. A region is a
// loop over the invocations of the workgroup; a statement that contains a barrier runs once for all of them, with the
// condition that the first invocation has: it is uniform, or the kernel is wrong on every device.
#include "emit/cpp/mentions.h"
#include "emit/host/body.h"

#include <map>

namespace gliftc::host {

namespace {

using ir::ExprId;
using ir::LocalId;
using ir::Op;
using ir::Stmt;
using ir::StmtId;
using ir::StmtOp;

bool has_barrier(const ir::Program& program, StmtId id) {
    bool found = false;
    ir::for_each_statement(program, {id}, [&](const Stmt& stmt) { found = found || stmt.op == StmtOp::barrier; });
    return found;
}

/// True of a statement with a break or continue that leaves it.
bool escapes(const ir::Program& program, StmtId id) {
    const Stmt& stmt = program.stmts[id];
    if (stmt.op == StmtOp::break_ || stmt.op == StmtOp::continue_) return true;
    if (stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_) return false;
    for (const auto* list : {&stmt.body, &stmt.otherwise}) {
        for (StmtId inner : *list) {
            if (escapes(program, inner)) return true;
        }
    }
    return false;
}

struct Groups {
    Body body;
    const ir::Program& program;
    const ir::Pass& pass;
    cpp::Printer& p;
    bool printing = false;  ///< else only finding out which locals cross regions
    std::uint32_t region = 0;
    std::map<LocalId, std::set<std::uint32_t>> uses;  ///< the regions that mention each local
    std::set<LocalId> uniform;                        ///< variables of loops that run once for all
    std::string invocation;                           ///< index of the current one: `local_index` or `0`
    bool may_return = false;

    Groups(cpp::Globals& globals, const ir::Pass& pass)
        : body(globals, pass), program(globals.program), pass(pass), p(body.p) {}

    bool is_uniform_statement(StmtId id, bool in_loop) const {
        return has_barrier(program, id) || (in_loop && escapes(program, id));
    }
    void mention(ExprId id);
    void mention_all(const std::vector<StmtId>& list);
    void run(const std::vector<StmtId>& list, bool in_loop);
    void run_region(const std::vector<StmtId>& list);
    void run_uniform(const Stmt& stmt, bool in_loop);
    void open(const std::string& text);
    void close();
    void print_region(const std::vector<StmtId>& list);
};

void Groups::mention(ExprId id) {
    ir::for_each_node(program, id, [&](ir::ExprId node) {
        const ir::Expr& expr = program.exprs[node];
        if (expr.op == Op::local) uses[expr.local].insert(region);
    });
}

void Groups::mention_all(const std::vector<StmtId>& list) {
    ir::for_each_statement(program, list, [&](const Stmt& stmt) {
        if (stmt.op == StmtOp::let || stmt.op == StmtOp::for_) uses[stmt.local].insert(region);
        for (ExprId expr : {stmt.target, stmt.value, stmt.limit}) mention(expr);
    });
}

void Groups::open(const std::string& text) {
    if (printing) p.out.open(text);
}
void Groups::close() {
    if (printing) p.out.close();
}

void Groups::run(const std::vector<StmtId>& list, bool in_loop) {
    std::vector<StmtId> pending;
    for (StmtId id : list) {
        if (!is_uniform_statement(id, in_loop)) {
            pending.push_back(id);
            continue;
        }
        run_region(pending);
        pending.clear();
        run_uniform(program.stmts[id], in_loop);
    }
    run_region(pending);
}

void Groups::run_region(const std::vector<StmtId>& list) {
    if (list.empty()) return;
    ++region;
    if (printing) print_region(list);
    else mention_all(list);
}

void Groups::print_region(const std::vector<StmtId>& list) {
    invocation = "local_index";
    body.first_only = false;
    const std::array<std::uint32_t, 3>& g = pass.group;
    const std::string x = std::to_string(g[0]), y = std::to_string(g[1]);
    bool local_id = false, global_id = false;
    ir::for_each_expression(program, list, [&](ir::ExprId node) {
        const ir::Expr& expr = program.exprs[node];
        if (expr.op != Op::builtin) return;
        local_id = local_id || expr.builtin == ir::Builtin::local_id;
        global_id = global_id || expr.builtin == ir::Builtin::global_id;
    });
    p.out.open("for (uint local_index = 0; local_index < " + std::to_string(g[0] * g[1] * g[2]) + "; ++local_index)");
    if (may_return) p.out.line("if (returned[local_index]) continue;");
    if (local_id || global_id)
        p.out.line("const uint3 local_id{local_index % " + x + ", local_index / " + x + " % " + y + ", local_index / " +
                   std::to_string(g[0] * g[1]) + "};");
    if (global_id)
        p.out.line("const uint3 global_id = group_id * uint3(" + x + ", " + y + ", " + std::to_string(g[2]) +
                   ") + local_id;");
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

void Groups::run_uniform(const Stmt& stmt, bool in_loop) {
    ++region;
    if (printing) cpp::mark_line(p, stmt.span);
    for (ExprId expr : {stmt.value, stmt.limit}) {
        if (!printing) mention(expr);
    }
    const auto text = [&](ExprId id) { return printing ? cpp::print_any(p, id) : std::string(); };
    switch (stmt.op) {
    case StmtOp::barrier:
        if (printing) p.out.line("// barrier");
        return;
    case StmtOp::break_:
        if (printing) p.out.line("break;");
        return;
    case StmtOp::continue_:
        if (printing) p.out.line("continue;");
        return;
    case StmtOp::block: return run(stmt.body, in_loop);
    case StmtOp::if_:
        open("if (" + text(stmt.value) + ")");
        run(stmt.body, in_loop);
        if (!stmt.otherwise.empty()) {
            if (printing) p.out.dedent();
            open("} else");
            run(stmt.otherwise, in_loop);
        }
        return close();
    case StmtOp::while_:
        open("while (" + text(stmt.value) + ")");
        run(stmt.body, true);
        return close();
    case StmtOp::for_: {
        uniform.insert(stmt.local);
        std::string head;
        if (printing) {
            const std::string type = cpp::type_text(p.globals, program.locals[stmt.local].type);
            const std::string first = text(stmt.value), limit = text(stmt.limit);
            const std::string name = cpp::declare_local(p, stmt.local), end = p.names.declare(name + "_end");
            head = "for (" + type + " " + name + " = " + first + ", " + end + " = " + limit + "; " + name + " < " +
                   end + "; ++" + name + ")";
        }
        open(head);
        run(stmt.body, true);
        return close();
    }
    case StmtOp::let:
    case StmtOp::assign:
    case StmtOp::return_:
    case StmtOp::evaluate:
    case StmtOp::subgroup_barrier:
#define STRUCTURE_STATEMENT(name) case StmtOp::name:
#define HOST_STATEMENT(name) case StmtOp::name:
#define MEMORY_STATEMENT(name) case StmtOp::name:
#include "ir/statements.def"
        return;
    }
}

/// The body after what of the prologue it needs: a kernel that goes by its group alone has no address.
std::vector<StmtId> needed(const ir::Program& program, const ir::Pass& pass) {
    std::vector<StmtId> all = pass.body;
    for (auto id = pass.prologue.rbegin(); id != pass.prologue.rend(); ++id) {
        const ir::Stmt& stmt = program.stmts[*id];
        if (stmt.op != StmtOp::let || cpp::mentions(program, all, stmt.local)) all.insert(all.begin(), *id);
    }
    return all;
}

}  // namespace

std::string group_kernel(cpp::Globals& globals, const ir::Pass& pass, const std::string& name) {
    Groups groups(globals, pass);
    cpp::Printer& p = groups.p;
    for (const char* taken : cpp::locals_of_groups) p.names.declare(taken);
    const std::vector<StmtId> all = needed(globals.program, pass);
    groups.may_return = returns_early(globals.program, all);
    groups.run(all, false);

    p.out.indent();
    print_local_functions(groups.body);
    const std::string size = std::to_string(pass.group[0] * pass.group[1] * pass.group[2]);
    for (LocalId local : pass.shared) {
        const std::string type = cpp::type_text(globals, globals.program.locals[local].type);
        p.out.line(type + " " + cpp::declare_local(p, local) + ";");
    }
    if (groups.may_return) p.out.line("bool returned[" + size + "] = {};");
    std::map<LocalId, std::string> arrays;
    for (const auto& [local, regions] : groups.uses) {
        const ir::Local& declared = globals.program.locals[local];
        if (regions.size() < 2 || groups.uniform.contains(local) || declared.storage == ir::Storage::shared) continue;
        arrays[local] = p.names.declare((*globals.program.names)[declared.name]);
        p.out.line(cpp::type_text(globals, declared.type) + " " + arrays[local] + "[" + size + "];");
    }
    p.outer_local = [&](LocalId local) {
        const auto found = arrays.find(local);
        return found == arrays.end() ? std::string() : found->second + "[" + groups.invocation + "]";
    };
    groups.printing = true;
    groups.body.first_only = true;
    groups.body.group_text = "uint3(" + std::to_string(pass.group[0]) + ", " + std::to_string(pass.group[1]) + ", " +
                             std::to_string(pass.group[2]) + ")";
    groups.invocation = "0";
    groups.run(all, false);
    const std::string text = p.out.take();

    const ir::Kernel& kernel = globals.program.kernels[pass.kernel];
    const std::string extent =
        std::to_string(pass.group[0]) + ", " + std::to_string(pass.group[1]) + ", " + std::to_string(pass.group[2]);
    cpp::Writer out;
    out.line("// " + cpp::place_text(globals.sources, kernel.span) + ": " + kernel.display + ", one workgroup.");
    out.line("GLIFT_HOST_KERNEL");
    out.open(
        "static void " + name +
        "_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id, [[maybe_unused]] uint3 group_count)");
    out.line("[[maybe_unused]] constexpr uint group_size = " + size + ";");
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
