// Draws: their fixed state as constants (glift::Drawing), and the statements that fill in glift::DrawIteration at a
// call.
#include "emit/cpp/unit.h"
#include "ir/effects.h"
#include "ir/spelling.h"

namespace gliftc::cpp {

namespace {

using ir::Kernel;
using ir::KernelParam;
using ir::Pattern;

const ir::Memory& memory_of(const Unit& unit, const KernelParam& param) {
    const ir::Structure& structure = unit.program.structures[param.structure];
    return structure.memories[structure.via_memory];
}

/// The parameter's memory in generated C++: `colour->data()`.
std::string memory_text(const Unit& unit, const KernelParam& param) {
    const std::uint32_t memory = unit.program.structures[param.structure].via_memory;
    return unit.globals.param_names.at(&param) + "->" + unit.globals.class_names[param.structure].memories[memory] +
           "()";
}

}  // namespace

void print_drawing(const Unit& unit, Writer& out, const Kernel& kernel, const std::string& name, bool derives_loads) {
    const ir::Raster& raster = *kernel.raster;
    std::string fields = ".topology = glift::Topology::" + std::string(ir::spelling(raster.topology)) +
                         ", .cull = glift::Cull::" + std::string(ir::spelling(raster.cull));
    if (!raster.colours.empty()) {
        out.line("const glift::ColourTarget " + name + "_colours[] = {");
        out.indent();
        for (const ir::ColourTarget& target : raster.colours) {
            const KernelParam& param = kernel.params[target.param];
            std::string text = ".name = \"" + unit.name(param.name) + "\", .format = glift::Format::" +
                               std::string(format_name(memory_of(unit, param).format));
            if (target.blend != ir::Blend::replace)
                text += ", .blend = glift::Blend::" + std::string(ir::spelling(target.blend));
            out.line("{" + text + "},");
        }
        out.dedent();
        out.line("};");
        fields += ", .colours = " + name + "_colours";
    }
    if (raster.depth) {
        fields += ", .depth = \"" + unit.name(kernel.params[raster.depth->param].name) +
                  "\", .depth_test = glift::DepthTest::" + std::string(ir::spelling(raster.depth->test));
        if (!raster.depth->is_written) fields += ", .writes_depth = false";
    }
    if (derives_loads) fields += ", .derives_loads = true";
    out.line("const glift::Drawing " + name + "_drawing = {" + fields + "};");
}

void print_draw_arguments(const Unit& unit, Writer& out, const Kernel& kernel) {
    const auto argument = [&](const KernelParam& param) {
        return "(\"" + unit.name(param.name) + "\", " + unit.globals.param_names.at(&param);
    };
    for (std::uint32_t i = 0; i < kernel.params.size(); ++i) {
        const KernelParam& param = kernel.params[i];
        const bool is_depth = kernel.raster->depth && kernel.raster->depth->param == i;
        const bool is_whole = param.pattern != Pattern::value &&
                              unit.program.structures[param.structure].kind == ir::StructureKind::no_elements;
        if (param.pattern == Pattern::each) out.line("iteration.corners" + argument(param) + ");");
        if (param.pattern == Pattern::instance) out.line("iteration.instances" + argument(param) + ");");
        if (param.pattern == Pattern::at) out.line("iteration.pixels" + argument(param) + ");");
        if (param.pattern == Pattern::target)
            out.line((is_depth ? "iteration.depth" : "iteration.colour") + argument(param) + ", " +
                     memory_text(unit, param) + ");");
        if (!is_whole && param.pattern != Pattern::target && ir::has_own_range(param.pattern))
            out.line("iteration.any" + argument(param) + ");");
    }
}

}  // namespace gliftc::cpp
