// A draw as one call of the rasteriser.
#include "emit/cpp/host/body.h"
#include "ir/effects.h"
#include "ir/spelling.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::host {

namespace {

/// Whether the fragment part may need perspective-correct weights, or 1 / w.
bool has_smooth(const ir::Program& program, const ir::Pass& pass) {
    const ir::Raster& raster = *program.kernels[pass.kernel].raster;
    const ir::Variant* fragment = fragment_for(pass, ir::Devices::host);
    bool found = std::ranges::any_of(
        raster.varyings, [](const ir::Varying& varying) { return varying.interpolation == ir::Interpolation::smooth; });
    if (fragment)
        ir::for_each_expression(program, fragment->body, [&](ir::ExprId id) {
            const ir::Expr& expr = program.exprs[id];
            found |= expr.op == ir::Op::builtin && expr.builtin == ir::Builtin::fragment_place;
        });
    return found;
}

const char* truth(bool value) { return value ? "true" : "false"; }

}  // namespace

std::string draw_kernel(cpp::Globals& globals, const ir::Pass& pass, const std::string& name) {
    const ir::Program& program = globals.program;
    const ir::Raster& raster = *program.kernels[pass.kernel].raster;
    const bool has_fragment = fragment_for(pass, ir::Devices::host) != nullptr;
    cpp::Writer out;
    out.raw(vertex_part(globals, pass, name));
    out.gap();
    if (has_fragment) out.raw(fragment_part(globals, pass, name));
    out.gap();
    out.open("static void " + name + "(const glift::HostCall& call)");
    out.line("const glift::HostTargets& targets = *call.targets;");
    out.line("glift::host::Draw draw;");
    out.line("draw.body = &call;");
    out.line("draw.vertex = " + name + "_vertex;");
    if (has_fragment) out.line("draw.fragment = " + name + "_fragment;");
    if (raster.topology != ir::Topology::triangles)
        out.line("draw.topology = glift::Topology::" + std::string(ir::spelling(raster.topology)) + ";");
    out.line("draw.corners = call.size[0];");
    out.line("draw.instances = call.size[1];");
    std::uint32_t floats = 0;
    for (const ir::Varying& varying : raster.varyings) floats += floats_of(program, varying);
    if (!raster.clip_distances.empty())
        out.line("draw.clip_distances = " + std::to_string(raster.clip_distances.size()) + ";");
    if (floats != 0) out.line("draw.varyings = " + std::to_string(floats) + ";");
    out.line("draw.viewport = targets.extent;");
    out.line("draw.framebuffer = targets.origin;");
    if (raster.cull != ir::Cull::none)
        out.line("draw.cull = glift::Cull::" + std::string(ir::spelling(raster.cull)) + ";");
    if (has_smooth(program, pass)) out.line("draw.has_smooth = true;");
    if (raster.depth) {
        const bool is_early = ir::depth_order(program, pass) != ir::DepthOrder::after;
        out.line("draw.depth = {reinterpret_cast<float*>(targets.depth.first), targets.depth.row / sizeof(float), "
                 "glift::DepthTest::" +
                 std::string(ir::spelling(raster.depth->test)) + ", " + truth(raster.depth->is_written) + ", " +
                 truth(is_early) + "};");
    }
    out.line("glift::host::draw(draw);");
    out.close();
    return out.take();
}

}  // namespace gliftc::host
