// The fragment part of a draw: loops over the pixels of a block (64 pixels, glift::host::block_pixels). The statement
// `invocations` is one such loop. A local that a later loop reads (`keep`) is an array with an element for each pixel,
// and so are the colours and depths that the part assigns.
#include "emit/cpp/host/body.h"
#include "emit/cpp/mentions.h"
#include "ir/effects.h"
#include "ir/spelling.h"
#include "ir/walk.h"

#include <map>

namespace gliftc::host {

namespace {

using ir::LocalId;
using ir::Stmt;
using ir::StmtId;
using ir::StmtOp;

/// Which varyings are read: flat ones, which have one value for the triangle, or interpolated ones, which have one for
/// each pixel.
enum class Reads : std::uint8_t { of_triangle, of_pixel };

bool leaves(const Stmt& stmt) { return stmt.op == StmtOp::return_ || stmt.op == StmtOp::discard; }

bool has_leave(const ir::Program& program, const std::vector<StmtId>& list) {
    bool found = false;
    ir::for_each_statement(program, list, [&](const Stmt& stmt) { found |= leaves(stmt); });
    return found;
}

struct Part {
    Body body;
    const ir::Program& program;
    const ir::Raster& raster;
    cpp::Printer& p;
    std::map<LocalId, std::string> arrays;  ///< names of the arrays for locals that are kept, and for the targets
    bool is_inside = false;                 ///< the printed code is in a loop over pixels
    bool has_helpers = false;               ///< pixels beside the triangle take part, for their neighbours' derivatives
    bool is_split = false;                  ///< fragments may end before the last loop over pixels
    const Stmt* last = nullptr;             ///< the last loop, if nothing follows it

    Part(cpp::Globals& globals, const ir::Pass& pass);

    void declare_array(LocalId local);
    void print_varyings(const std::vector<StmtId>& list, Reads reads);
    void print_invocations(const Stmt& loop);
    void print_leave(bool returns_in_loop);
    void print_statement(const Stmt& stmt, const std::function<void(const Stmt&)>& print_other);
    cpp::Text derivative(const ir::Expr& expr);
    bool returns_in_loop = false;  ///< in the printed loop over pixels, a fragment may end within an inner loop
};

Part::Part(cpp::Globals& globals, const ir::Pass& pass)
    : body(globals, pass, cpp::locals_of_draws), program(globals.program), raster(*program.kernels[pass.kernel].raster),
      p(body.p) {
    p.outer_local = [this](LocalId local) {
        const auto found = arrays.find(local);
        if (found == arrays.end()) return std::string();
        return found->second + (is_inside ? "[pixel]" : "[glift::host::first_of(running)]");
    };
    p.outer_statement = [this, print_other = p.outer_statement](const Stmt& stmt) {
        print_statement(stmt, print_other);
    };
    p.outer_expression = [this, print_other = p.outer_expression](const ir::Expr& expr) {
        return expr.op == ir::Op::intrinsic ? derivative(expr) : print_other(expr);
    };
}

void Part::declare_array(LocalId local) {
    const ir::Local& declared = program.locals[local];
    arrays[local] = p.names.declare((*program.names)[declared.name]);
    p.out.line(cpp::type_text(p.globals, declared.type) + " " + arrays[local] + "[glift::host::block_pixels];");
}

cpp::Text Part::derivative(const ir::Expr& expr) {
    const std::string name(ir::name_of(expr.intrinsic));
    return {"glift::host::" + name + "(" + arrays.at(program.exprs[expr.operands[0]].local) + ", " +
            (is_inside ? "pixel" : "glift::host::first_of(running)") + ")"};
}

/// Declares the varyings that the statements use: those that are flat, or those that are interpolated for a pixel.
void Part::print_varyings(const std::vector<StmtId>& list, Reads reads) {
    std::uint32_t first = 0;
    for (const ir::Varying& varying : raster.varyings) {
        const std::uint32_t offset = std::exchange(first, first + floats_of(program, varying));
        const bool is_flat = varying.interpolation == ir::Interpolation::flat;
        if (is_flat != (reads == Reads::of_triangle) || !cpp::mentions(program, list, varying.read)) continue;
        const std::string type = cpp::type_text(p.globals, varying.type);
        const std::string name = p.local_names[varying.read] = p.names.declare((*program.names)[varying.name]);
        p.out.line("const " + type + " " + name +
                   " = glift::host::" + std::string(ir::spelling(varying.interpolation)) + "<" + type +
                   ">(fragments, " + (is_flat ? "" : "pixel, ") + std::to_string(offset) + ");");
    }
}

/// Prints the end of a fragment. `in_loop`: the code for a fragment is a lambda, which returns; else the loop over
/// pixels continues.
void Part::print_leave(bool in_loop) {
    if (is_split) p.out.line("running &= ~(std::uint64_t{1} << pixel);");
    p.out.line(in_loop ? "return;" : "continue;");
}

/// Prints a loop over pixels. Helper pixels take no part in the last one, since no neighbour needs their values
/// afterwards.
void Part::print_invocations(const Stmt& loop) {
    const std::vector<StmtId>& list = loop.body;
    const std::string pixels = has_helpers && &loop == last ? "running & drawn" : "running";
    p.out.open("for (std::uint64_t left = " + pixels + "; left != 0; left &= left - 1)");
    p.out.line("[[maybe_unused]] const std::uint32_t pixel = glift::host::first_of(left);");
    p.names.enter();
    is_inside = true;
    print_varyings(list, Reads::of_pixel);
    returns_in_loop = false;
    ir::for_each_statement(program, list, [&](const Stmt& stmt) {
        if (stmt.op != StmtOp::for_ && stmt.op != StmtOp::while_) return;
        returns_in_loop |= has_leave(program, stmt.body);
    });
    p.print_return = [this](ir::ExprId) { print_leave(returns_in_loop); };
    if (returns_in_loop) p.out.open("[&]");
    cpp::print_statements(p, list);
    if (returns_in_loop) p.out.close("();");
    is_inside = false;
    p.names.leave();
    p.out.close();
    if (is_split && has_leave(program, list)) p.out.line("if (running == 0) return;");
}

void Part::print_statement(const Stmt& stmt, const std::function<void(const Stmt&)>& print_other) {
    if (stmt.op == StmtOp::keep) return declare_array(stmt.local);
    if (stmt.op == StmtOp::invocations) return print_invocations(stmt);
    if (stmt.op == StmtOp::barrier)
        return p.out.line("// All pixels of each quad have computed the value whose derivative follows.");
    if (stmt.op == StmtOp::discard) {
        p.out.line("drawn &= ~(std::uint64_t{1} << pixel);");
        return print_leave(returns_in_loop);
    }
    const bool writes = stmt.op == StmtOp::store || stmt.op == StmtOp::image_store || stmt.op == StmtOp::atomic;
    if (!writes || !has_helpers) return print_other(stmt);
    p.out.open("if (drawn >> pixel & 1)");
    print_other(stmt);
    p.out.close();
}

/// Prints the late depth test, and the blending of the fragments' colours into the targets.
void print_targets(Part& part) {
    const ir::Raster& raster = part.raster;
    cpp::Writer& out = part.p.out;
    if (raster.depth && raster.depth->is_set) {
        out.line("drawn = glift::host::test_depth(fragments, drawn, " + part.arrays.at(raster.depth->value) + ");");
    } else if (raster.depth && ir::depth_order(part.program, part.body.pass) == ir::DepthOrder::after) {
        out.line("drawn = fragments.test(drawn);");
    }
    for (std::size_t i = 0; i < raster.colours.size(); ++i) {
        const ir::ColourTarget& target = raster.colours[i];
        const ir::Structure& structure =
            part.program.structures[part.program.kernels[part.body.pass.kernel].params[target.param].structure];
        const std::string format(cpp::format_name(structure.memories[structure.via_memory].format));
        out.line("glift::host::draw_colour<glift::Format::" + format +
                 ", glift::Blend::" + std::string(ir::spelling(target.blend)) + ">(call.targets->colours[" +
                 std::to_string(i) + "], fragments, drawn, " + part.arrays.at(target.value) + ");");
    }
}

/// Prints the depths that the fragments begin with, which the rasteriser interpolated: where only some paths assign a
/// depth, the others keep it.
void print_depths(Part& part) {
    part.p.out.open("for (std::uint32_t pixel = 0; pixel < glift::host::block_pixels; ++pixel)");
    part.p.out.line(part.arrays.at(part.raster.depth->value) + "[pixel] = fragments.depth[pixel];");
    part.p.out.close();
}

}  // namespace

std::string fragment_part(cpp::Globals& globals, const ir::Pass& pass, const std::string& name) {
    Part part(globals, pass);
    cpp::Printer& p = part.p;
    const std::vector<StmtId>& statements = fragment_for(pass, ir::Devices::host)->body;
    ir::for_each_statement(globals.program, statements,
                           [&](const Stmt& stmt) { part.has_helpers |= stmt.op == StmtOp::barrier; });
    // Fragments that end in the last loop need not be noted: no loop follows.
    std::vector<StmtId> before = statements;
    if (!before.empty() && globals.program.stmts[before.back()].op == StmtOp::invocations) {
        part.last = &globals.program.stmts[before.back()];
        before.pop_back();
    }
    part.is_split = has_leave(globals.program, before);

    p.out.indent();
    print_local_functions(part.body);
    part.print_varyings(statements, Reads::of_triangle);
    for (const ir::ColourTarget& target : part.raster.colours) part.declare_array(target.value);
    if (part.raster.depth && part.raster.depth->is_set) {
        part.declare_array(part.raster.depth->value);
        print_depths(part);
    }
    p.out.line("[[maybe_unused]] std::uint64_t drawn = fragments.covered;");
    p.out.line((statements.empty() ? "[[maybe_unused]] " : "") + std::string(part.is_split ? "" : "const ") +
               "std::uint64_t running = " + (part.has_helpers ? "glift::host::quads_of(drawn);" : "drawn;"));
    if (part.is_split) p.out.open("[&]");
    cpp::print_statements(p, statements);
    if (part.is_split) p.out.close("();");
    print_targets(part);
    const std::string text = p.out.take();

    cpp::Writer out;
    out.line("GLIFT_HOST_KERNEL");
    out.open("static void " + name + "_fragment(const void* pointer, const glift::host::Fragments& fragments)");
    out.line("[[maybe_unused]] const auto& call = *static_cast<const glift::HostCall*>(pointer);");
    declare_used(part.body, out, name);
    out.raw(text);
    out.close();
    return out.take();
}

}  // namespace gliftc::host
