// Kernels without a group: a loop along x for each row of elements. Accesses whose index advances by one along the row
// go through a pointer to the row's first element.
#include "emit/cpp/host/rows.h"

#include "base/concat.h"
#include "emit/cpp/host/update_objects.h"
#include "emit/cpp/mentions.h"
#include "ir/walk.h"

namespace gliftc::host {

using ir::ExprId;
using ir::Op;
using ir::Stmt;
using ir::StmtId;
using ir::StmtOp;

std::vector<RowAccess> row_accesses(const ir::Program& program, const std::vector<StmtId>& body) {
    std::vector<RowAccess> found;
    const auto add_load = [&](ExprId id) {
        const ir::Expr& expr = program.exprs[id];
        if (expr.op == Op::row_load) found.push_back({expr.slot, expr.operands[0], {}});
        if (expr.op == Op::row_item)
            found.push_back({ir::no_binding, expr.operands[1], program.exprs[expr.operands[0]].local});
    };
    ir::for_each_statement(program, body, [&](const Stmt& stmt) {
        ir::for_each_root(stmt, [&](ExprId root) { ir::for_each_node(program, root, add_load); });
        if (stmt.op == StmtOp::row_store) found.push_back({stmt.slot, stmt.target, {}});
    });
    return found;
}

namespace {

/// Whether the statement is a `let` with a value, which can be left out if nothing reads its local.
bool is_let(const Stmt& stmt) { return stmt.op == StmtOp::let && stmt.value; }

/// The C++ expression of the part of a row that the variant runs over: `part`. But a variant that runs in blocks of
/// glift::host::block_elements needs at least one block: if `part` is shorter, an empty part at `end`.
std::string in_blocks_text(const ir::Variant& variant, const std::string& part, const std::string& end) {
    return variant.order == ir::RowOrder::in_blocks ? "glift::host::in_blocks(" + part + ", " + end + ")" : part;
}

}  // namespace

void Rows::print_address(const std::string& x) {
    static constexpr const char* others[] = {"", ", row.y", ", row.y, row.z", ", row.y, row.z, row.w"};
    if (pass.rank == 1) p.out.line("const uint address = " + x + ";");
    else p.out.line("const uint" + std::to_string(pass.rank) + " address{" + x + others[pass.rank - 1] + "};");
}

/// Prints the address of the element at x = `begin`, and the `let`s that the expressions in `wanted` need there.
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

/// The element type of a row pointer.
std::string Rows::type_of(const RowAccess& access) {
    if (access.array) return cpp::type_text(p.globals, program.types[program.locals[access.array].type].element);
    const ir::PassBinding& binding = pass.bindings[access.binding];
    body.used_bindings.insert(access.binding);
    return (binding.access == ir::Access::read ? "const " : "") + cpp::storage_text(p.globals, binding.element);
}

/// Each access goes to a buffer or a local array, at an index that advances along the row. For each distinct pair of
/// memory and index, prints a pointer to the first element accessed; before these pointers, prints the values that the
/// indices need.
void Rows::print_row_pointers(const std::vector<StmtId>& statements, const std::vector<RowAccess>& accesses,
                              const std::string& begin) {
    std::vector<ExprId> wanted;
    wanted.reserve(accesses.size());
    for (const RowAccess& access : accesses) wanted.push_back(access.index);
    print_values_at(statements, wanted, begin);
    std::map<std::pair<std::string, std::string>, std::string> pointers;
    for (const RowAccess& access : accesses) {
        const std::string index = cpp::print(p, access.index, cpp::Level::postfix);
        const std::string of = access.array ? p.local_names.at(access.array) : body.binding_names[access.binding];
        std::string& name = pointers[{of, index}];
        if (name.empty()) {
            name = p.names.declare(of + "_row");
            const std::string begin = access.array ? of + ".values" : of;
            const std::string pointer =
                program.exprs[access.index].op == Op::select ? chosen_row(access) : begin + " + " + index;
            p.out.line(concat(type_of(access), "* ", name, " = glift::host::row_pointer(", pointer, ");"));
        }
        if (access.array) body.item_pointers[{access.array, access.index}] = name;
        else body.row_pointers[{access.binding, access.index}] = name;
    }
}

/// The statements without the `let`s that nothing reads, since row pointers replace the indices computed with them.
std::vector<StmtId> Rows::without_unused(const std::vector<StmtId>& statements, IdSet<ir::Local>& read) const {
    const auto note = [&](const auto& self, ExprId id) -> void {
        if (!id) return;
        const ir::Expr& expr = program.exprs[id];
        if (expr.op == Op::local) read.insert(expr.local);
        if (expr.op == Op::row_load || expr.op == Op::row_item) return;
        for (ExprId operand : expr.operands) self(self, operand);
    };
    std::vector<StmtId> kept;
    kept.reserve(statements.size());
    for (std::size_t i = statements.size(); i-- > 0;) {  // what reads a value stands behind it
        const Stmt& last = program.stmts[statements[i]];
        if (is_let(last) && !read.contains(last.local)) continue;
        kept.push_back(statements[i]);
        const auto note_statement = [&](const Stmt& stmt) {
            if (stmt.op != StmtOp::row_store) note(note, stmt.target);
            note(note, stmt.value);
            note(note, stmt.limit);
        };
        note_statement(last);
        ir::for_each_statement(program, last.body, note_statement);
        ir::for_each_statement(program, last.otherwise, note_statement);
    }
    return {kept.rbegin(), kept.rend()};
}

/// Prints the code for one element; `return` goes on with the next element.
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

/// A loop over the elements with x in [begin, end), in groups of glift::host::row_lanes. Each lane combines the updates
/// of its elements; the row ends with one update.
void Rows::print_updating_loop(const ir::Variant& variant, const std::vector<Stmt>& updates, const std::string& begin,
                               const std::string& end) {
    const std::vector<RowAccess> accesses = row_accesses(program, variant.body);
    p.out.open("if (" + begin + " < " + end + ")");
    if (!accesses.empty()) print_row_pointers(variant.body, accesses, begin);
    p.out.line("const std::size_t count = " + end + " - " + begin + ";");
    for (const Stmt& update : updates) {
        body.updated_bindings.insert(update.slot);
        std::string& name = body.row_updates[{update.slot, update.target}];
        name = p.names.declare(pass.bindings[update.slot].name + "_row");
        if (pass.ordered_sum(update.slot) != nullptr) p.out.line(body.update_names.at(update.slot) + ".begin(row);");
        p.out.line(concat("glift::host::RowUpdate<", cpp::storage_text(p.globals, pass.bindings[update.slot].element),
                          ", glift::host::", operation_name(update.combine), pass.is_wide ? ", std::uint64_t> " : "> ",
                          name, "(count);"));
    }
    IdSet<ir::Local> read;
    const std::vector<StmtId> kept = without_unused(variant.body, read);
    p.out.open("for (std::size_t first = 0; first < count; first += glift::host::row_lanes)");
    p.out.line("const std::size_t lanes = glift::host::lanes_from(first, count);");
    if (variant.order != ir::RowOrder::ascending) p.out.line("GLIFT_INDEPENDENT");
    p.out.open("for (std::size_t lane = 0; lane < lanes; ++lane)");
    p.out.line("const std::size_t i = first + lane;");
    if (read.contains(pass.address)) print_address(begin + " + static_cast<uint>(i)");
    p.marked_line = 0;
    print_element(kept);
    p.out.close();
    p.out.close();
    for (const Stmt& update : updates)
        p.out.line(body.row_updates.at({update.slot, update.target}) + ".finish(" + body.update_names.at(update.slot) +
                   ");");
    p.out.close();
}

/// One loop over the elements with x in [begin, end).
void Rows::print_plain_loop(const ir::Variant& variant, const std::string& begin, const std::string& end) {
    const std::vector<StmtId>& statements = variant.body;
    const std::vector<RowAccess> accesses = row_accesses(program, statements);
    body.row_pointers.clear();
    body.item_pointers.clear();
    p.marked_line = 0;
    p.names.enter();
    if (const std::vector<Stmt> updates = row_updates(program, statements); !updates.empty()) {
        print_updating_loop(variant, updates, begin, end);
        return p.names.leave();
    }
    if (!accesses.empty()) {
        p.out.open("if (" + begin + " < " + end + ")");
        print_row_pointers(statements, accesses, begin);
    }
    IdSet<ir::Local> read;
    const std::vector<StmtId> kept = without_unused(statements, read);
    // The rows of a block are short: GLIFT_BLOCK also keeps GCC from unrolling the loop, since it could not vectorise
    // the unrolled code.
    if (variant.order != ir::RowOrder::ascending)
        p.out.line(variant.assumes.row != 0 ? "GLIFT_BLOCK" : "GLIFT_INDEPENDENT");
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

/// A loop over the elements with x in [begin, end), in blocks of glift::host::block_elements, which may overlap. There
/// are no elements, or at least a block of them.
void Rows::print_blocks(const ir::Variant& variant, const std::string& begin, const std::string& end) {
    const std::vector<StmtId>& statements = variant.body;
    const std::vector<RowAccess> accesses = row_accesses(program, statements);
    body.row_pointers.clear();
    body.item_pointers.clear();
    p.marked_line = 0;
    p.names.enter();
    p.out.open("if (" + begin + " < " + end + ")");
    print_row_pointers(statements, accesses, begin);
    IdSet<ir::Local> read;
    const std::vector<StmtId> kept = without_unused(statements, read);
    p.out.line("const std::size_t count = " + end + " - " + begin + ";");
    p.out.open("for (std::size_t block = 0; block < count; block += glift::host::block_elements)");
    p.out.line("const std::size_t first = glift::host::begin_of_block(block, count);");
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

void Rows::print_part(const ir::Variant& variant, const std::string& begin, const std::string& end) {
    if (ir::is_in_lockstep(program, variant.body)) print_runs(variant, begin, end);
    else if (variant.order == ir::RowOrder::in_blocks) print_blocks(variant, begin, end);
    else print_plain_loop(variant, begin, end);
}

/// Prints the declaration of `inside`: the part of the row where the bounds of `bounded` hold, so that the clamps that
/// `bounded` leaves out would have no effect.
void Rows::print_inside(const ir::Variant& variant, const ir::Variant& bounded, const std::string& begin,
                        const std::string& end) {
    p.out.line("glift::host::Unclamped unclamped;");
    p.out.open("");
    p.names.enter();
    std::vector<ExprId> wanted;
    for (const ir::Bounds& bounds : bounded.assumes.bounds)
        for (ExprId part : {bounds.value, bounds.low, bounds.high})
            if (part) wanted.push_back(part);
    print_values_at(variant.body, wanted, begin);
    std::set<std::string> printed;
    for (const ir::Bounds& bounds : bounded.assumes.bounds) {
        const auto limit = [&](ExprId id, const char* none) { return id ? cpp::print_any(p, id) : std::string(none); };
        const std::string line = "unclamped.keep(" + cpp::print_any(p, bounds.value) + ", " +
                                 limit(bounds.low, "INT32_MIN") + ", " + limit(bounds.high, "INT32_MAX") + ");";
        if (printed.insert(line).second) p.out.line(line);
    }
    p.names.leave();
    p.out.close();
    const std::string inside = "unclamped.of(" + begin + ", " + end + ")";
    p.out.line("const glift::host::Part inside = " + in_blocks_text(bounded, inside, end) + ";");
}

/// Opens a loop over three sections of a row: before the middle, the middle, and behind it. The code for the middle
/// comes first in the text. The sections are not lambdas, since GLIFT_HOST_KERNEL, by which a function is also compiled
/// for wide vectors, does not apply to lambdas in it.
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

/// A loop over every `items`-th element (at<S, items>), since each run of the kernel's body processes `items` elements.
/// `begin` and `end` count iterations, not elements.
void Rows::print_strides(const std::vector<StmtId>& statements, const std::string& begin, const std::string& end) {
    p.marked_line = 0;
    p.names.enter();
    p.out.open("for (uint x = " + begin + "; x < " + end + "; ++x)");
    if (cpp::mentions(program, statements, pass.address))
        p.out.line("const uint address = x * " + std::to_string(pass.items) + ";");
    print_element(statements);
    p.out.close();
    p.names.leave();
}

/// Loops over the elements with x in [begin, end): one loop, or separate ones for the middle, where bounds hold, and
/// the ends. With at<S, items>, over the iterations in [begin, end): print_strides().
void Rows::print_loop(const ir::Variant& variant, const std::string& begin, const std::string& end) {
    p.local_names[pass.address] = "address";
    if (pass.items != 1) return print_strides(variant.body, begin, end);
    const ir::Variant* bounded = bounded_variant_of(pass, variant);
    if (bounded == nullptr) return print_part(variant, begin, end);
    print_inside(variant, *bounded, begin, end);
    open_sections("stretch", begin, "inside", end);
    print_part(*bounded, "stretch.begin", "stretch.end");
    p.out.dedent();
    p.out.open("} else");
    print_part(variant, "stretch.begin", "stretch.end");
    close_sections();
}

namespace {

/// Prints the declaration of an uninitialised array, which is filled once per block.
void print_array(Rows& rows, const Stmt& let) {
    cpp::Printer& p = rows.p;
    const ir::Type& type = rows.program.types[rows.program.locals[let.local].type];
    p.out.line(concat("glift::host::Scratch<", cpp::type_text(p.globals, type.element), ", ",
                      std::to_string(type.count), "> ", cpp::declare_local(p, let.local), ";"));
}

/// In kernels over blocks: prints the code for a block all of whose elements are visited, which is one loop over all of
/// them, or a loop for each row of the block.
void print_rows_of_block(Rows& rows, const ir::Variant& whole) {
    if (whole.assumes.row == 0) return rows.print_loop(whole, "row.begin", "row.end");
    const std::string width = std::to_string(whole.assumes.row) + "u";
    rows.p.names.enter();
    const std::string first = rows.p.names.declare("first");
    rows.p.out.open(concat("for (uint ", first, " = row.begin; ", first, " < row.end; ", first, " += ", width, ")"));
    rows.print_loop(whole, first, first + " + " + width);
    rows.p.out.close();
    rows.p.names.leave();
}

/// For kernels over blocks: prints the code that computes the values that depend on the block alone; then the loop for
/// blocks all of whose elements are visited (`whole`), and the loop for other blocks (`any`).
void print_block(Rows& rows, const ir::Variant& whole, const ir::Variant& any) {
    cpp::Printer& p = rows.p;
    p.out.line("bool is_whole = false;");
    p.out.open("");
    p.names.enter();
    const std::string name = p.names.declare("block");
    rows.p.local_names[rows.pass.address] = name;
    const std::vector<StmtId>& values = *whole.block;
    const auto holds =
        std::ranges::find(values, StmtOp::evaluate, [&](StmtId id) { return rows.program.stmts[id].op; });
    if (cpp::mentions(rows.program, values, rows.pass.address))
        p.out.line("const uint2 " + name + "{row.begin, row.y};");
    cpp::print_statements(p, {values.begin(), holds});
    p.out.line("is_whole = " + cpp::print_any(p, rows.program.stmts[*holds].value) + ";");
    p.out.open("if (is_whole)");
    p.names.enter();
    for (auto id = holds + 1; id != values.end(); ++id) {
        const Stmt& stmt = rows.program.stmts[*id];
        if (stmt.op == StmtOp::let && stmt.uninitialized) print_array(rows, stmt);
        else cpp::print_statement(p, *id);
    }
    print_rows_of_block(rows, whole);
    p.names.leave();
    p.out.close();
    p.names.leave();
    p.out.close();
    p.out.open("if (!is_whole)");
    rows.print_loop(any, "row.begin", "row.end");
    p.out.close();
}

void print_parts(Rows& rows) {
    const ir::Pass& pass = rows.pass;
    cpp::Writer& out = rows.p.out;
    const ir::Variant& variant = variant_for(pass, ir::Devices::host);
    if (const ir::Variant* whole = block_variant_for(pass, ir::Devices::host))
        return print_block(rows, *whole, variant);
    const ir::Variant* inside = interior_variant_for(pass, ir::Devices::host);
    if (inside == nullptr) return rows.print_loop(variant, "row.begin", "row.end");
    const ir::Interior& assumed = *inside->assumes.interior;
    const auto parameter = [&](std::uint32_t index) {
        rows.body.used_parameters.insert(index);
        return rows.body.parameter_names[index];
    };
    const std::string domain = parameter(assumed.domain);
    const std::string origin = assumed.origin != ir::no_parameter ? parameter(assumed.origin)
                               : pass.rank == 1                   ? "0u"
                                                                  : "uint" + std::to_string(pass.rank) + "()";
    const std::string interior =
        "glift::host::interior_of(row, " + origin + ", " + domain + ", " + std::to_string(assumed.radius) + ")";
    out.line("const glift::host::Part interior = " + in_blocks_text(*inside, interior, "row.end") + ";");
    rows.open_sections("part", "row.begin", "interior", "row.end");
    out.line("// Interior: all neighbours of these elements are in the domain.");
    rows.print_loop(*inside, "part.begin", "part.end");
    out.dedent();
    out.open("} else");
    out.line("// Elsewhere: neighbours may be outside the domain.");
    rows.print_loop(variant, "part.begin", "part.end");
    rows.close_sections();
}

}  // namespace

/// The begin of the call that runs a kernel's tasks.
static std::string loop_of(const Rows& rows) {
    const ir::Pass& pass = rows.pass;
    if (pass.items != 1) return "for_strides(call.size[0], " + std::to_string(pass.items) + ", ";
    if (rows.has_runs) return "for_runs(call.size, ";
    if (!pass.tiles.empty()) return concat("for_tiles<", std::to_string(pass.tiles[0].axis), ">(call.size, ");
    return "for_rows(call.size, ";
}

std::string row_kernel(cpp::Globals& globals, const ir::Pass& pass, const std::string& name) {
    Rows rows(globals, pass);
    rows.p.out.indent();
    print_local_functions(rows.body);
    rows.p.out.open("for (const glift::host::Row row : rows)");
    print_parts(rows);
    rows.p.out.close();
    const std::string text = rows.p.out.take();
    const UpdateTexts updates = update_texts(rows);

    cpp::Writer out;
    out.reserve(text.size() + text.size() / 4);
    out.line("GLIFT_HOST_KERNEL");
    const bool uses_call = !rows.body.used_parameters.empty() || !rows.body.used_bindings.empty() ||
                           text.find("call.") != std::string::npos || updates.objects.find("call") != std::string::npos;
    out.open("static void " + name + "_rows(" + (uses_call ? "" : "[[maybe_unused]] ") +
             "const glift::HostCall& call, const glift::host::Rows& rows" + updates.parameters + ")");
    declare_used(rows.body, out, name);
    out.raw(updates.objects);
    out.raw(text);
    out.close();
    out.gap();
    out.open("static void " + name + "(const glift::HostCall& call)");
    for (const std::string& line : updates.before) out.line(line);
    out.line(concat("glift::host::", updates.loop.empty() ? loop_of(rows) : updates.loop,
                    "[&](const glift::host::Rows& rows) { ", name, "_rows(call, rows", updates.arguments, "); });"));
    for (const std::string& line : updates.after) out.line(line);
    out.close();
    return out.take();
}

}  // namespace gliftc::host
