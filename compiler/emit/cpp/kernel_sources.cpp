// The sources of kernels' code. An edit of a kernel's body changes only one of them, or those of the instances of a
// generic kernel, if it keeps the number of lines: the code of kernels names the lines of the .glift file. The sources
// include neither the classes nor the functions that call kernels, and so compile fast.
#include "emit/cpp/spirv_file.h"
#include "emit/cpp/unit.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::cpp {

namespace {

/// The number of sources that are used is the number of kernels divided by this, rounded up, but at most the number of
/// shards: for fewer kernels it does not pay to compile the headers once more.
constexpr std::size_t kernels_of_a_source = 8;

/// A hash of the kernel's name alone, so that a kernel stays in its source when others come and go, as long as the
/// number of sources that are used stays the same.
std::uint32_t hash_of_name(const ir::Program& program, ir::KernelId kernel) {
    std::uint32_t hash = 2166136261u;
    for (char c : program.kernels[kernel].display) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash ^ hash >> 16;
}

/// The kernels of each source. A source may have none; where there are few kernels, the last sources have none.
std::vector<std::vector<ir::KernelId>> spread(const ModuleParts& parts, const std::vector<ir::KernelId>& kernels) {
    std::vector<std::vector<ir::KernelId>> sources(parts.options.shards);
    const std::size_t used =
        std::clamp<std::size_t>((kernels.size() + kernels_of_a_source - 1) / kernels_of_a_source, 1, sources.size());
    for (ir::KernelId kernel : kernels) sources[hash_of_name(parts.program, kernel) % used].push_back(kernel);
    return sources;
}

void print_includes(const ModuleParts& parts, Writer& out, const std::string& stem,
                    const std::vector<ir::KernelId>& kernels) {
    bool has_images = false, has_cubes = false, has_atomics = false, has_updates = false, has_reports = false,
         has_draws = false, has_messages = false, has_runs = false, has_sums = false;
    for (ir::KernelId kernel : kernels) {
        has_draws |= parts.program.kernels[kernel].raster.has_value();
        const ir::Pass& pass = parts.lowered.passes[kernel].general;
        for (const ir::PassBinding& binding : pass.bindings) {
            has_images |= binding.shape != ir::MemoryShape::buffer;
            has_cubes |= binding.shape == ir::MemoryShape::imagecube;
            if (binding.is_workspace) continue;
            (binding.coherent ? has_atomics : has_updates) |= binding.atomic || binding.coherent;
        }
        has_reports |= pass.has_reports;
        has_messages |= !pass.messages.empty();
        has_sums |= !pass.sum_orders().empty();
        if (parts.program.kernels[kernel].grouped() || parts.program.kernels[kernel].raster) continue;
        for (const ir::Variant& variant : pass.variants) has_runs |= ir::is_in_lockstep(parts.program, variant.body);
    }
    out.line("#include \"" + stem + ".glift.types.hpp\"");
    out.gap();
    if (has_draws) out.line("#include <glift/drawing.h>");
    if (has_atomics) out.line("#include <glift/host/atomics.h>");
    if (has_cubes) out.line("#include <glift/host/cube.h>");
    if (has_draws) out.line("#include <glift/host/fragments.h>");
    if (has_images) out.line("#include <glift/host/image.h>");
    out.line("#include <glift/host/math.h>");
    if (has_messages) out.line("#include <glift/host/messages.h>");
    out.line("#include <glift/host/parallel.h>");
    if (has_reports) out.line("#include <glift/host/report.h>");
    if (has_runs) out.line("#include <glift/host/runs.h>");
    if (has_sums) out.line("#include <glift/host/sums.h>");
    if (has_updates) out.line("#include <glift/host/updates.h>");
    out.line("#include <glift/kernel.h>");
    out.gap();
}

/// The code of those kernels that are in the namespace of the module `home`.
void print_namespace(const ModuleParts& parts, Writer& out, ir::ModuleId home, const std::vector<ir::KernelId>& kernels,
                     const SpirvFile* spirv) {
    Unit unit = make_unit(parts, home);
    unit.spirv_file = spirv;
    std::vector<ir::KernelId> own;
    std::ranges::copy_if(kernels, std::back_inserter(own),
                         [&](ir::KernelId kernel) { return parts.program.kernels[kernel].module == home; });
    const std::vector<std::string> codes = printed_kernels(unit, own, code_adds_functions, kernel_code);
    out.line("namespace " + unit.globals.space + " {");
    out.raw("\n");
    out.line("using namespace glift::types;");
    out.gap();
    if (!unit.globals.functions.empty()) {
        out.line("namespace {");
        out.raw("\n");
        out.parts({unit.globals.functions});
        out.line("}  // namespace");
        out.gap();
    }
    out.parts({codes.begin(), codes.end()});
    out.line("}  // namespace " + unit.globals.space);
    out.gap();
}

std::vector<ir::KernelId> on_vulkan(const ModuleParts& parts, const std::vector<ir::KernelId>& kernels) {
    std::vector<ir::KernelId> found;
    std::ranges::copy_if(kernels, std::back_inserter(found),
                         [&](ir::KernelId kernel) { return parts.reach.vulkan_kernels.contains(kernel); });
    return found;
}

std::string source_of(const ModuleParts& parts, const std::string& stem, const std::vector<ir::KernelId>& kernels,
                      const SpirvFile* spirv) {
    Writer out;
    out.line(begin_of_file(stem));
    if (kernels.empty()) return out.take();
    print_includes(parts, out, stem, kernels);
    if (spirv && !spirv->empty()) {
        out.line(spirv->statement());
        out.gap();
    }
    std::set<ir::ModuleId> homes;
    for (ir::KernelId kernel : kernels) homes.insert(parts.program.kernels[kernel].module);
    for (ir::ModuleId home : homes) print_namespace(parts, out, home, kernels, spirv);
    return out.take();
}

}  // namespace

std::vector<File> kernel_sources(const ModuleParts& parts, const std::string& stem,
                                 const std::vector<ir::KernelId>& kernels, const std::string& part) {
    std::vector<File> files;
    const std::vector<std::vector<ir::KernelId>> sources = spread(parts, kernels);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const std::string name = ".glift." + part + (i == 0 ? "" : "." + std::to_string(i + 1));
        if (!parts.options.spirv_files) {
            files.push_back({name + ".cpp", source_of(parts, stem, sources[i], nullptr)});
            continue;
        }
        const SpirvFile spirv(stem + name + ".spirv", parts.code, on_vulkan(parts, sources[i]));
        files.push_back({name + ".cpp", source_of(parts, stem, sources[i], &spirv)});
        files.push_back({name + ".spirv", spirv.bytes(), false});
    }
    return files;
}

}  // namespace gliftc::cpp
