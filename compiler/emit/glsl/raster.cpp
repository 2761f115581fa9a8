// The shaders of a draw: inputs and outputs. Locals that a part assigns for the rasteriser are the shader's outputs.
#include "emit/glsl/printer.h"
#include "ir/effects.h"
#include "ir/walk.h"

#include <set>

namespace gliftc::glsl {

namespace {

using ir::Op;
using ir::Part;

const char* word_of(ir::Interpolation interpolation) {
    switch (interpolation) {
    case ir::Interpolation::smooth: return "smooth";
    case ir::Interpolation::linear: return "noperspective";
    case ir::Interpolation::flat: return "flat";
    }
    return "";
}

std::string location(std::size_t index) { return "layout(location = " + std::to_string(index) + ") "; }

void find_used(const Printer& p, const std::vector<ir::StmtId>& body, std::set<std::uint32_t>& used) {
    ir::for_each_statement(p.program, body, [&](const ir::Stmt& stmt) {
        if (stmt.op == ir::StmtOp::store || stmt.op == ir::StmtOp::image_store || stmt.op == ir::StmtOp::atomic)
            used.insert(stmt.slot);
    });
    ir::for_each_expression(p.program, body, [&](ir::ExprId id) {
        const ir::Expr& expr = p.program.exprs[id];
        if (is_load(expr.op)) used.insert(expr.slot);
    });
}

std::string vertex_interface(Printer& p, const ir::Raster& raster) {
    std::string text;
    for (std::size_t i = 0; i < raster.varyings.size(); ++i) {
        const ir::Varying& varying = raster.varyings[i];
        text += location(i) + word_of(varying.interpolation) + " out " +
                declaration(p, varying.type, p.local_names.at(varying.written)) + ";\n";
    }
    if (!raster.clip_distances.empty())
        text += "out float gl_ClipDistance[" + std::to_string(raster.clip_distances.size()) + "];\n";
    return text;
}

std::string fragment_interface(Printer& p, const ir::Raster& raster) {
    std::string text;
    if (raster.depth && ir::depth_order(p.program, p.pass) == ir::DepthOrder::declared)
        text += "layout(early_fragment_tests) in;   // what is hidden writes nothing\n";
    for (std::size_t i = 0; i < raster.varyings.size(); ++i) {
        const ir::Varying& varying = raster.varyings[i];
        text += location(i) + word_of(varying.interpolation) + " in " +
                declaration(p, varying.type, p.local_names.at(varying.read)) + ";\n";
    }
    for (std::size_t i = 0; i < raster.colours.size(); ++i)
        text +=
            location(i) + "out " +
            declaration(p, p.program.locals[raster.colours[i].value].type, p.local_names.at(raster.colours[i].value)) +
            ";\n";
    return text;
}

}  // namespace

void name_interface(Printer& p) {
    const ir::Raster& raster = *p.raster();
    for (const ir::Varying& varying : raster.varyings)
        p.local_names[varying.written] = p.local_names[varying.read] =
            p.names.declare((*p.program.names)[varying.name]);
    for (const ir::ColourTarget& target : raster.colours)
        p.local_names[target.value] = p.names.declare((*p.program.names)[p.program.locals[target.value].name]);
    p.local_names[raster.place] = "gl_Position";
    for (std::size_t i = 0; i < raster.clip_distances.size(); ++i)
        p.local_names[raster.clip_distances[i]] = "gl_ClipDistance[" + std::to_string(i) + "]";
    if (raster.depth) p.local_names[raster.depth->value] = "gl_FragDepth";
}

std::string interface_text(Printer& p) {
    const std::string text =
        p.options.part == Part::vertex ? vertex_interface(p, *p.raster()) : fragment_interface(p, *p.raster());
    return text.empty() ? "" : text + "\n";
}

/// Prints the initial values of outputs: the size of points, and the depth if the fragment part assigns one. Where only
/// some paths assign a depth, the others keep the depth that the rasteriser interpolated.
void print_part_start(Printer& p) {
    if (p.options.part == Part::vertex && p.raster()->topology == ir::Topology::points) line(p, "gl_PointSize = 1.0;");
    if (p.options.part == Part::fragment && p.raster()->depth && p.raster()->depth->is_set)
        line(p, "gl_FragDepth = gl_FragCoord.z;");
}

bool is_used(const Printer& p, std::size_t binding) {
    if (!p.raster()) return true;
    std::set<std::uint32_t> used;
    find_used(p, p.body(), used);
    for (ir::FunctionId id : p.pass.functions) find_used(p, p.program.functions[id].body, used);
    return used.contains(static_cast<std::uint32_t>(binding));
}

}  // namespace gliftc::glsl
