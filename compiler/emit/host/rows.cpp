// Kernels without a group: a loop along x for each row of elements.
#include "base/concat.h"
#include "emit/host/affine.h"
#include "emit/host/body.h"
#include "emit/host/guards.h"
#include "ir/walk.h"

#include <map>

namespace gliftc::host {

namespace {

using ir::ExprId;
using ir::Op;
using ir::Stmt;
using ir::StmtId;
using ir::StmtOp;

bool is_unconditional(ir::BinaryOp op) { return op != ir::BinaryOp::logical_and && op != ir::BinaryOp::logical_or; }

struct RowAccess {
    std::uint32_t binding;
    ExprId index;
};

/// Loads that every element of the row executes.
void collect_loads(const ir::Program& program, const ir::Pass& pass, ExprId id, Affine& affine,
                   std::vector<RowAccess>& found) {
    if (!id) return;
    const ir::Expr& expr = program.exprs[id];
    if (expr.op == Op::load && !is_row(program.types, pass.bindings[expr.slot], expr.type) &&
        affine.is_row(expr.operands[0])) {
        found.push_back({expr.slot, expr.operands[0]});
        return;
    }
    const bool whole = expr.op != Op::select && (expr.op != Op::binary || is_unconditional(expr.binary));
    for (std::size_t i = 0; i < expr.operands.size() && (whole || i == 0); ++i)
        collect_loads(program, pass, expr.operands[i], affine, found);
}

/// All accesses of a straight-line body that go through their memory in order. Ends at the first early return: what
/// follows is not executed by every element.
std::vector<RowAccess> row_accesses(const ir::Program& program, const ir::Pass& pass, const std::vector<StmtId>& body,
                                    const std::set<ExprId>& unclamped) {
    Affine affine(program, pass.address, unclamped);
    std::vector<RowAccess> found;
    const auto scan = [&](const auto& self, const std::vector<StmtId>& statements) -> bool {
        for (StmtId id : statements) {
            const Stmt& stmt = program.stmts[id];
            if (stmt.op == StmtOp::return_) return false;
            if (stmt.op == StmtOp::block) {
                if (!self(self, stmt.body)) return false;
                continue;
            }
            collect_loads(program, pass, stmt.value, affine, found);
            if (stmt.op == StmtOp::store && affine.is_row(stmt.target) &&
                !is_row(program.types, pass.bindings[stmt.slot], program.exprs[stmt.value].type))
                found.push_back({stmt.slot, stmt.target});
            if ((stmt.op == StmtOp::if_ || stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_) &&
                (returns_early(program, stmt.body) || returns_early(program, stmt.otherwise)))
                return false;
            affine.learn(stmt);
        }
        return true;
    };
    scan(scan, body);
    return found;
}

/// Calls of clamp, min and max on a signed integer that advances by one along the row: in the middle of the row they
/// change nothing, whatever translator they come from.
std::set<ExprId> row_clamps(const ir::Program& program, const ir::Pass& pass, const std::vector<StmtId>& body) {
    std::set<ExprId> clamps;
    ir::for_each_expression_of_trees(program, body, [&](ExprId id) {
        const ir::Expr& expr = program.exprs[id];
        if (expr.op == Op::intrinsic && expr.type == program.types.int_ &&
            (expr.intrinsic == ir::Intrinsic::clamp || expr.intrinsic == ir::Intrinsic::min ||
             expr.intrinsic == ir::Intrinsic::max))
            clamps.insert(id);
    });
    if (clamps.empty()) return clamps;
    Affine affine(program, pass.address);
    for (StmtId id : body) affine.learn(program.stmts[id]);
    std::erase_if(clamps, [&](ExprId id) {
        const ir::Operands& operands = program.exprs[id].operands;
        bool steady = affine.is_row(operands[0]);
        for (std::size_t i = 1; i < operands.size(); ++i) steady = steady && affine.is_steady(operands[i]);
        return !steady;
    });
    return clamps;
}

/// True of a `let` whose value nobody misses if nobody reads it.
bool is_let(const Stmt& stmt) { return stmt.op == StmtOp::let && stmt.value; }

struct Rows {
    Body body;
    const ir::Program& program;
    const ir::Pass& pass;
    cpp::Printer& p;

    Rows(cpp::Globals& globals, const ir::Pass& pass)
        : body(globals, pass), program(globals.program), pass(pass), p(body.p) {}

    void print_address(const std::string& x);
    void print_row_pointers(const std::vector<StmtId>& statements, const std::vector<RowAccess>& accesses,
                            const std::string& begin);
    std::vector<StmtId> without_unused(const std::vector<StmtId>& statements, IdSet<ir::Local>& read) const;
    void print_element(const std::vector<StmtId>& statements);
    void print_values_at(const std::vector<StmtId>& statements, const std::vector<ExprId>& wanted,
                         const std::string& begin);
    void print_inside(const std::vector<StmtId>& statements, const std::set<ExprId>& clamps, const std::string& begin,
                      const std::string& end);
    void print_strides(const std::vector<StmtId>& statements, const std::string& begin, const std::string& end);
    void print_plain_loop(const std::vector<StmtId>& statements, const std::string& begin, const std::string& end);
    void print_blocks(const std::vector<StmtId>& statements, const std::string& begin, const std::string& end);
    void print_middle(const std::vector<StmtId>& statements, const std::string& begin, const std::string& end);
    void open_sections(const std::string& name, const std::string& begin, const std::string& middle,
                       const std::string& end);
    void close_sections();
    void print_loop(const std::vector<StmtId>& statements, const std::string& begin, const std::string& end);
    bool is_independent(const std::vector<StmtId>& statements) const;
    bool fills_blocks(const std::vector<StmtId>& statements) const;
};

void Rows::print_address(const std::string& x) {
    static constexpr const char* others[] = {"", ", row.y", ", row.y, row.z", ", row.y, row.z, row.w"};
    if (pass.rank == 1) p.out.line("const uint address = " + x + ";");
    else p.out.line("const uint" + std::to_string(pass.rank) + " address{" + x + others[pass.rank - 1] + "};");
}

/// The values that some expressions have at the first element from `begin` on.
void Rows::print_values_at(const std::vector<StmtId>& statements, const std::vector<ExprId>& wanted,
                           const std::string& begin) {
    std::vector<StmtId> lets;
    const auto find_lets = [&](const auto& self, const std::vector<StmtId>& list) -> void {
        for (StmtId id : list) {
            const Stmt& stmt = program.stmts[id];
            if (is_let(stmt)) lets.push_back(id);
            if (stmt.op == StmtOp::block) self(self, stmt.body);
        }
    };
    find_lets(find_lets, statements);
    IdSet<ir::Expr> seen;
    IdSet<ir::Local> read;
    const auto note = [&](ExprId id) {
        if (program.exprs[id].op == Op::local) read.insert(program.exprs[id].local);
    };
    for (ExprId expr : wanted) ir::for_each_node(program, expr, seen, note);
    std::vector<StmtId> needed;
    for (std::size_t i = lets.size(); i-- > 0;) {  // what a let reads stands before it
        const Stmt& let = program.stmts[lets[i]];
        if (!read.contains(let.local)) continue;
        needed.push_back(lets[i]);
        ir::for_each_node(program, let.value, seen, note);
    }
    print_address(begin);
    for (std::size_t i = needed.size(); i-- > 0;) cpp::print_statement(p, needed[i]);
}

/// Pointers to the first element in the row of all memory that is run through in order, with the values they need.
void Rows::print_row_pointers(const std::vector<StmtId>& statements, const std::vector<RowAccess>& accesses,
                              const std::string& begin) {
    std::vector<ExprId> wanted;
    wanted.reserve(accesses.size());
    for (const RowAccess& access : accesses) wanted.push_back(access.index);
    print_values_at(statements, wanted, begin);
    std::map<std::pair<std::uint32_t, std::string>, std::string> pointers;
    for (const RowAccess& access : accesses) {
        const std::string index = cpp::print(p, access.index, cpp::Level::postfix);
        std::string& name = pointers[{access.binding, index}];
        if (name.empty()) {
            const ir::PassBinding& binding = pass.bindings[access.binding];
            name = p.names.declare(body.binding_names[access.binding] + "_row");
            body.used_bindings.insert(access.binding);
            p.out.line(concat(binding.access == ir::Access::read ? "const " : "",
                              cpp::storage_text(p.globals, binding.element), "* ", name, " = glift::host::row_pointer(",
                              body.binding_names[access.binding], " + ", index, ");"));
        }
        body.row_pointers[{access.binding, access.index}] = name;
    }
}

/// Without the `let`s that nothing reads, now that row pointers stand for what was computed with them.
std::vector<StmtId> Rows::without_unused(const std::vector<StmtId>& statements, IdSet<ir::Local>& read) const {
    const auto note = [&](const auto& self, ExprId id) -> void {
        if (!id) return;
        const ir::Expr& expr = program.exprs[id];
        if (expr.op == Op::local) read.insert(expr.local);
        if (expr.op == Op::load && body.row_pointers.contains({expr.slot, expr.operands[0]})) return;
        for (ExprId operand : expr.operands) self(self, operand);
    };
    std::vector<StmtId> kept;
    kept.reserve(statements.size());
    for (std::size_t i = statements.size(); i-- > 0;) {  // what reads a value stands behind it
        const Stmt& last = program.stmts[statements[i]];
        if (is_let(last) && !read.contains(last.local)) continue;
        kept.push_back(statements[i]);
        const auto note_statement = [&](const Stmt& stmt) {
            if (stmt.op != StmtOp::store || !body.row_pointers.contains({stmt.slot, stmt.target}))
                note(note, stmt.target);
            note(note, stmt.value);
            note(note, stmt.limit);
        };
        note_statement(last);
        ir::for_each_statement(program, last.body, note_statement);
        ir::for_each_statement(program, last.otherwise, note_statement);
    }
    return {kept.rbegin(), kept.rend()};
}

bool Rows::is_independent(const std::vector<StmtId>& statements) const {
    bool independent = true;
    ir::for_each_statement(program, statements,
                           [&](const Stmt& stmt) { independent = independent && stmt.op != StmtOp::atomic; });
    for (const ir::PassBinding& binding : pass.bindings)
        independent = independent && !binding.atomic && !binding.coherent;
    return independent;
}

/// What one element does; `return` goes on with the next.
void Rows::print_element(const std::vector<StmtId>& statements) {
    bool in_loop = false;
    ir::for_each_statement(program, statements, [&](const Stmt& stmt) {
        if (stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_)
            in_loop = in_loop || returns_early(program, stmt.body);
    });
    p.names.enter();
    if (in_loop) {
        p.print_return = nullptr;
        p.out.open("[&]");
        cpp::print_statements(p, statements);
        p.out.close("();");
    } else {
        p.print_return = [this](ExprId) { p.out.line("continue;"); };
        cpp::print_statements(p, statements);
    }
    p.names.leave();
}

/// One loop over the elements with x in [begin, end).
void Rows::print_plain_loop(const std::vector<StmtId>& statements, const std::string& begin, const std::string& end) {
    const std::vector<RowAccess> accesses = row_accesses(program, pass, statements, p.identities);
    body.row_pointers.clear();
    p.marked_line = 0;
    p.names.enter();
    if (!accesses.empty()) {
        p.out.open("if (" + begin + " < " + end + ")");
        print_row_pointers(statements, accesses, begin);
    }
    IdSet<ir::Local> read;
    const std::vector<StmtId> kept = without_unused(statements, read);
    if (is_independent(kept)) p.out.line("GLIFT_INDEPENDENT");
    if (accesses.empty()) {
        p.out.open("for (uint x = " + begin + "; x < " + end + "; ++x)");
        if (read.contains(pass.address)) print_address("x");
    } else {
        p.out.open("for (std::size_t i = 0, count = " + end + " - " + begin + "; i < count; ++i)");
        if (read.contains(pass.address)) print_address(begin + " + static_cast<uint>(i)");
    }
    p.marked_line = 0;
    print_element(kept);
    p.out.close();
    if (!accesses.empty()) p.out.close();
    p.names.leave();
}

/// True if some elements may be worked on twice: no memory is read that is written, and nothing but memory is changed.
/// And if all elements do the same, so that it pays.
bool Rows::fills_blocks(const std::vector<StmtId>& statements) const {
    if (!is_independent(statements)) return false;
    for (std::uint32_t i = 0; i < pass.bindings.size(); ++i) {
        if (pass.bindings[i].access == ir::Access::read_write || pass.bindings[i].one_place != i) return false;
    }
    bool straight = true;
    ir::for_each_statement(program, statements, [&](const Stmt& stmt) {
        straight = straight && (stmt.op == StmtOp::let || stmt.op == StmtOp::assign || stmt.op == StmtOp::store ||
                                stmt.op == StmtOp::block);
    });
    return straight;
}

/// A loop over the elements with x in [begin, end), which are none or fill a block, in blocks that may overlap.
void Rows::print_blocks(const std::vector<StmtId>& statements, const std::string& begin, const std::string& end) {
    const std::vector<RowAccess> accesses = row_accesses(program, pass, statements, p.identities);
    body.row_pointers.clear();
    p.marked_line = 0;
    p.names.enter();
    p.out.open("if (" + begin + " < " + end + ")");
    print_row_pointers(statements, accesses, begin);
    IdSet<ir::Local> read;
    const std::vector<StmtId> kept = without_unused(statements, read);
    p.out.line("const std::size_t count = " + end + " - " + begin + ";");
    p.out.open("for (std::size_t block = 0; block < count; block += glift::host::block_elements)");
    p.out.line("const std::size_t first = std::min(block, count - glift::host::block_elements);");
    p.out.line("GLIFT_BLOCK");
    p.out.open("for (std::size_t lane = 0; lane < glift::host::block_elements; ++lane)");
    p.out.line("const std::size_t i = first + lane;");
    if (read.contains(pass.address)) print_address(begin + " + static_cast<uint>(i)");
    p.marked_line = 0;
    print_element(kept);
    p.out.close();
    p.out.close();
    p.out.close();
    p.names.leave();
}

/// The loop over the middle of a row; the elements are none or fill a block where that can be.
void Rows::print_middle(const std::vector<StmtId>& statements, const std::string& begin, const std::string& end) {
    if (fills_blocks(statements)) print_blocks(statements, begin, end);
    else print_plain_loop(statements, begin, end);
}

/// Declares `inside`: where none of the clamps changes anything.
void Rows::print_inside(const std::vector<StmtId>& statements, const std::set<ExprId>& clamps, const std::string& begin,
                        const std::string& end) {
    p.out.line("glift::host::Unclamped unclamped;");
    p.out.open("");
    p.names.enter();
    std::vector<ExprId> wanted;
    for (ExprId clamp : clamps) {
        for (ExprId operand : program.exprs[clamp].operands) wanted.push_back(operand);
    }
    print_values_at(statements, wanted, begin);
    std::set<std::string> printed;
    for (ExprId clamp : clamps) {
        const ir::Expr& expr = program.exprs[clamp];
        const auto operand = [&](std::size_t i) { return cpp::print_any(p, expr.operands[i]); };
        std::string low = "INT32_MIN", high = "INT32_MAX";
        if (expr.intrinsic == ir::Intrinsic::clamp) low = operand(1), high = operand(2);
        else (expr.intrinsic == ir::Intrinsic::min ? high : low) = operand(1);
        const std::string line = "unclamped.keep(" + operand(0) + ", " + low + ", " + high + ");";
        if (printed.insert(line).second) p.out.line(line);
    }
    p.names.leave();
    p.out.close();
    const std::string inside = "unclamped.of(" + begin + ", " + end + ")";
    p.out.line("const glift::host::Part inside = " +
               (fills_blocks(statements) ? "glift::host::in_blocks(" + inside + ", " + end + ")" : inside) + ";");
}

/// A loop over what lies before the middle, the middle, and what lies behind it; the middle comes first in the text.
/// One function holds them all: a lambda of its own would be compiled for the narrowest vectors.
void Rows::open_sections(const std::string& name, const std::string& begin, const std::string& middle,
                         const std::string& end) {
    p.out.open("for (const glift::host::Section& " + name + " : glift::host::sections(" + begin + ", " + middle + ", " +
               end + "))");
    p.out.open("if (" + name + ".is_middle)");
}

void Rows::close_sections() {
    p.out.close();
    p.out.close();
}

/// A loop over every `items`-th element: what lies between is the kernel's own affair.
void Rows::print_strides(const std::vector<StmtId>& statements, const std::string& begin, const std::string& end) {
    p.marked_line = 0;
    p.names.enter();
    IdSet<ir::Local> read;
    const std::vector<StmtId> kept = without_unused(statements, read);
    p.out.open("for (uint x = " + begin + "; x < " + end + "; ++x)");
    if (read.contains(pass.address)) p.out.line("const uint address = x * " + std::to_string(pass.items) + ";");
    Guards guards = find_guards(p, pass, kept);
    if (guards.tests.empty()) {
        print_element(kept);
    } else {
        std::string all = guards.tests[0];
        for (std::size_t i = 1; i < guards.tests.size(); ++i) all += " && " + guards.tests[i];
        p.out.open("if (" + all + ")");
        p.truths = std::move(guards.conditions);
        p.unread = std::move(guards.unread);
        print_element(kept);
        p.truths.clear();
        p.unread.clear();
        p.out.dedent();
        p.out.open("} else");
        p.marked_line = 0;
        print_element(kept);
        p.out.close();
    }
    p.out.close();
    p.names.leave();
}

/// Loops over the elements with x in [begin, end): one, or the ends apart from the middle where clamps change nothing.
void Rows::print_loop(const std::vector<StmtId>& statements, const std::string& begin, const std::string& end) {
    p.local_names[pass.address] = "address";
    if (pass.items != 1) return print_strides(statements, begin, end);
    const std::set<ExprId> clamps = row_clamps(program, pass, statements);
    if (clamps.empty() || row_accesses(program, pass, statements, clamps).empty())
        return print_plain_loop(statements, begin, end);
    print_inside(statements, clamps, begin, end);
    open_sections("stretch", begin, "inside", end);
    p.identities = clamps;
    print_middle(statements, "stretch.begin", "stretch.end");
    p.identities.clear();
    p.out.dedent();
    p.out.open("} else");
    print_plain_loop(statements, "stretch.begin", "stretch.end");
    close_sections();
}

void print_parts(Rows& rows) {
    const ir::Pass& pass = rows.pass;
    cpp::Writer& out = rows.p.out;
    if (pass.interior_body.empty() || pass.interior_domain >= pass.parameters.size()) {
        rows.print_loop(pass.body, "row.begin", "row.end");
        return;
    }
    const auto parameter = [&](std::uint32_t index) {
        rows.body.used_parameters.insert(index);
        return rows.body.parameter_names[index];
    };
    const std::string domain = parameter(pass.interior_domain);
    const std::string origin = pass.interior_origin < pass.parameters.size() ? parameter(pass.interior_origin)
                               : pass.rank == 1                              ? "0u"
                                                : "uint" + std::to_string(pass.rank) + "()";
    const std::string interior =
        "glift::host::interior_of(row, " + origin + ", " + domain + ", " + std::to_string(pass.interior_radius) + ")";
    rows.p.local_names[pass.address] = "address";
    const bool in_blocks = rows.fills_blocks(pass.interior_body) &&
                           row_clamps(rows.program, pass, pass.interior_body).empty() &&
                           !row_accesses(rows.program, pass, pass.interior_body, {}).empty();
    out.line("const glift::host::Part interior = " +
             (in_blocks ? "glift::host::in_blocks(" + interior + ", row.end)" : interior) + ";");
    rows.open_sections("part", "row.begin", "interior", "row.end");
    out.line("// All neighbours exist.");
    if (in_blocks) rows.print_blocks(pass.interior_body, "part.begin", "part.end");
    else rows.print_loop(pass.interior_body, "part.begin", "part.end");
    out.dedent();
    out.open("} else");
    out.line("// Near the sides of the domain.");
    rows.print_loop(pass.body, "part.begin", "part.end");
    rows.close_sections();
}

}  // namespace

std::string row_kernel(cpp::Globals& globals, const ir::Pass& pass, const std::string& name) {
    Rows rows(globals, pass);
    rows.p.out.indent();
    print_local_functions(rows.body);
    rows.p.out.open("for (const glift::host::Row row : rows)");
    print_parts(rows);
    rows.p.out.close();
    const std::string text = rows.p.out.take();

    const ir::Kernel& kernel = globals.program.kernels[pass.kernel];
    cpp::Writer out;
    out.reserve(text.size() + text.size() / 4);
    out.line("// " + cpp::place_text(globals.sources, kernel.span) + ": " + kernel.display + ", some rows.");
    out.line("GLIFT_HOST_KERNEL");
    out.open("static void " + name + "_rows(const glift::HostCall& call, const glift::host::Rows& rows)");
    declare_used(rows.body, out, name);
    out.raw(text);
    out.close();
    out.gap();
    out.open("static void " + name + "(const glift::HostCall& call)");
    if (pass.items == 1) {
        out.line("glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { " + name +
                 "_rows(call, rows); });");
    } else {
        out.line("glift::host::for_strides(call.size[0], " + std::to_string(pass.items) +
                 ", [&](const glift::host::Rows& rows) { " + name + "_rows(call, rows); });");
    }
    out.close();
    return out.take();
}

}  // namespace gliftc::host
