// The vertex part of a draw: a loop over vertices, whose outputs are floats in one array, vertex after vertex.
#include "emit/cpp/host/body.h"

namespace gliftc::host {

namespace {

/// Declares a local that the part assigns for the rasteriser.
void declare_output(cpp::Printer& p, ir::LocalId local) {
    p.out.line(cpp::type_text(p.globals, p.program.locals[local].type) + " " + cpp::declare_local(p, local) + "{};");
}

}  // namespace

std::uint32_t floats_of(const ir::Program& program, const ir::Varying& varying) {
    return program.types.components(varying.type);
}

std::string vertex_part(cpp::Globals& globals, const ir::Pass& pass, const std::string& name) {
    const ir::Raster& raster = *globals.program.kernels[pass.kernel].raster;
    Body body(globals, pass, cpp::locals_of_draws);
    cpp::Printer& p = body.p;
    const std::vector<ir::StmtId>& statements = variant_for(pass, ir::Devices::host).body;
    std::vector<ir::LocalId> outputs{raster.place};
    outputs.insert(outputs.end(), raster.clip_distances.begin(), raster.clip_distances.end());
    for (const ir::Varying& varying : raster.varyings) outputs.push_back(varying.written);

    p.out.indent();
    print_local_functions(body);
    p.out.open("for (std::uint32_t i = 0; i < count; ++i)");
    p.out.line("[[maybe_unused]] const uint corner = static_cast<uint>(first) + i;");
    for (ir::LocalId local : outputs) declare_output(p, local);
    const bool is_left = returns_early(globals.program, statements);
    if (is_left) p.out.open("[&]");
    cpp::print_statements(p, statements);
    if (is_left) p.out.close("();");
    for (ir::LocalId local : outputs)
        p.out.line("corners = glift::host::put(corners, " + p.local_names.at(local) + ");");
    p.out.close();
    const std::string text = p.out.take();

    cpp::Writer out;
    out.line("GLIFT_HOST_KERNEL");
    out.open("static void " + name + "_vertex(const void* pointer, std::uint64_t first, std::uint32_t count, " +
             "[[maybe_unused]] std::uint32_t instance, float* corners)");
    out.line("[[maybe_unused]] const auto& call = *static_cast<const glift::HostCall*>(pointer);");
    declare_used(body, out, name);
    out.raw(text);
    out.close();
    return out.take();
}

}  // namespace gliftc::host
