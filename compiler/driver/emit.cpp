#include "driver/emit.h"

#include "driver/digest.h"

#include "base/parallel.h"
#include "driver/shaders.h"
#include "emit/cpp/emit.h"
#include "emit/cpp/host/emit.h"
#include "emit/cpp/source_lines.h"
#include "emit/glsl/emit.h"
#include "emit/glsl/library.h"
#include "emit/json/emit.h"
#include "emit/spirv/strip.h"
#include "interop/interop.h"

#include <algorithm>
#include <filesystem>
#include <future>
#include <iterator>
#include <set>
#include <stdexcept>

namespace gliftc {

namespace {

/// The name itself or, if it is longer than 100 characters, its beginning and a hash of all of it: file systems allow
/// names of 255 bytes, which have the module's name and an ending, too.
std::string shortened(const std::string& name) {
    constexpr std::size_t longest = 100;
    if (name.size() <= longest) return name;
    Digest digest;
    digest.add(name);
    const std::string ending = "_" + digest.digits();
    return name.substr(0, longest - ending.size()) + ending;
}

/// The name of a kernel's shader: `scale` or, for a generic kernel, `scale_2_float`, shortened; not one of `taken`, to
/// which it is added.
std::string shader_name(const std::string& display, std::set<std::string>& taken) {
    std::string name;
    for (char c : display) {
        bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        if (plain) name += c;
        if (!plain && !name.empty() && name.back() != '_') name += '_';
    }
    while (!name.empty() && name.back() == '_') name.pop_back();
    name = shortened(name);
    std::string unique = name;
    for (int n = 2; !taken.insert(unique).second; ++n) unique = name + "_" + std::to_string(n);
    return unique;
}

std::string bytes_of(const std::vector<std::uint32_t>& words) {
    std::string bytes;
    bytes.reserve(words.size() * 4);
    for (std::uint32_t word : words)
        for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xff);
    return bytes;
}

/// C++ formatted in the style of --style, if given.
std::string styled(const Options& options, std::string text) {
    if (options.style.empty()) return text;
    FormatResult formatted = format_code(text, options.style);
    if (!formatted.error.empty()) throw std::runtime_error("clang-format: " + formatted.error);
    return std::move(formatted.text);
}

/// The path of the source file that has this name without its folder, as generated code names it; of several such files
/// the first that was read. The name itself if there is no such file.
std::string path_of(const Compilation& c, std::string_view name) {
    for (std::uint32_t file = 0; file < c.sources.size(); ++file)
        if (const std::string& path = c.sources[file].path; std::filesystem::path(path).filename() == name) return path;
    return std::string(name);
}

/// The GLSL of a kernel, for people to read. `shader`: the compute shader or, of a draw, the vertex shader; `fragment`:
/// of a draw, the fragment shader.
struct Readable {
    std::string shader, fragment;
};

/// The GLSL of each kernel, in the direct form, which is easier to read.
std::vector<Readable> readable_shaders(const Compilation& c, const std::vector<ir::KernelId>& kernels) {
    constexpr std::size_t share = 64;  // starting a thread for fewer kernels does not pay off
    std::vector<Readable> texts(kernels.size());
    for_each_parallel(kernels.size(), share, [&](std::size_t i) {
        const auto& forms = c.lowered.passes[kernels[i]];
        const ir::Pass& readable = forms.direct;
        texts[i].shader = glsl::glsl_of(c.program, c.sources, readable);
        if (fragment_for(readable, ir::Devices::shaders))
            texts[i].fragment = glsl::glsl_of(c.program, c.sources, readable, {.part = ir::Part::fragment});
    });
    return texts;
}

void emit_shaders(const Options& options, const Compilation& c, ir::ModuleId module, const std::string& base,
                  const cpp::KernelCodes& shaders, std::vector<Output>& outputs) {
    std::vector<ir::KernelId> kernels;
    for (ir::KernelId k : c.program.kernels.ids())
        if (c.program.kernels[k].module == module) kernels.push_back(k);
    std::vector<Readable> readable(kernels.size());
    if (options.wants(Target::glsl)) readable = readable_shaders(c, kernels);
    std::set<std::string> taken;
    for (std::size_t i = 0; i < kernels.size(); ++i) {
        std::string name = base + "." + shader_name(c.program.kernels[kernels[i]].display, taken);
        const std::string stage = c.program.kernels[kernels[i]].raster ? ".vert" : ".comp";
        if (!readable[i].shader.empty()) outputs.push_back({name + stage + ".glsl", std::move(readable[i].shader)});
        if (!readable[i].fragment.empty()) outputs.push_back({name + ".frag.glsl", std::move(readable[i].fragment)});
        if (!options.wants(Target::spirv)) continue;
        const auto add = [&](const std::string& ending, const std::vector<std::uint32_t>& words) {
            if (!words.empty()) outputs.push_back({name + ending + ".spv", bytes_of(words)});
        };
        const cpp::KernelCode& code = shaders[kernels[i]];
        add(stage, code.direct.shader);
        add(".frag", code.direct.fragment);
        add(".general" + stage, code.general.shader);
        add(".general.frag", code.general.fragment);
    }
}

/// The shaders as programs embed them: names and line numbers would be a quarter of their bytes.
cpp::KernelCodes stripped(cpp::KernelCodes shaders) {
    for (cpp::KernelCode& code : shaders)
        for (cpp::FormCode* form : {&code.direct, &code.general})
            for (std::vector<std::uint32_t>* words : {&form->shader, &form->fragment})
                if (!words->empty()) *words = spirv::without_debug_info(*words);
    return shaders;
}

void emit_cpp(const Options& options, const Compilation& c, ir::ModuleId module, const std::string& base,
              const cpp::KernelCodes& shaders, const cpp::Options& cpp, cpp::Defined& defined,
              std::vector<Output>& outputs) {
    cpp::KernelCodes code;
    if (!options.host_only && options.wants(Target::cpp)) code = options.source_lines ? shaders : stripped(shaders);
    cpp::Module written = cpp::module_of(c.program, c.lowered, c.sources, module, code, cpp, defined);
    for (cpp::File& file : written.files) {
        std::string text = file.is_code ? styled(options, std::move(file.text)) : std::move(file.text);
        if (options.source_lines && file.name.ends_with(".cpp"))
            text =
                cpp::with_source_lines(text, base + file.name, [&](std::string_view name) { return path_of(c, name); });
        outputs.push_back({base + file.name, std::move(text)});
        if (file.name == ".glift.cpp") outputs.back().tests = std::move(written.tests);
    }
}

/// Adds the GLSL libraries of public structures and views, which users include in their own shaders:
/// `laplacian.Field.glsl`.
void emit_libraries(const Compilation& c, ir::ModuleId module, const std::string& base, std::vector<Output>& outputs) {
    for (const ir::Library& library : c.lowered.libraries)
        if (library.module == module)
            outputs.push_back({base + "." + library.name + ".glsl", glsl::library_of(c.program, c.sources, library)});
}

/// The kernels whose SPIR-V some output of the module holds.
std::set<ir::KernelId> kernels_with_code(const Options& options, const Compilation& c, ir::ModuleId module,
                                         const cpp::Options& cpp, const cpp::Defined& defined) {
    std::set<ir::KernelId> kernels;
    if (options.wants(Target::spirv))
        for (ir::KernelId k : c.program.kernels.ids())
            if (c.program.kernels[k].module == module) kernels.insert(k);
    if (options.wants(Target::cpp) && !options.host_only)
        for (ir::KernelId k : cpp::vulkan_kernels_of(c.program, module, cpp, defined)) kernels.insert(k);
    return kernels;
}

}  // namespace

void check_style(const Options& options, Diagnostics& diagnostics) {
    if (options.style.empty()) return;
    FormatResult formatted = format_code("", options.style);
    if (!formatted.error.empty()) diagnostics.report(Diag::cannot_style, {}, {options.style, formatted.error});
}

std::vector<Output> emit(const Options& options, const Compilation& c) {
    std::vector<Output> outputs;
    cpp::Options cpp{.shards = options.shards,
                     .spirv_files = options.spirv_files,
                     .reload = options.reload && options.command != Command::test,
                     .tests = options.command == Command::test,
                     .host_kernel = options.wants(Target::host) ? &host::kernel_of : nullptr};
    cpp::Defined defined;
    std::set<std::string> bases;
    for (ir::ModuleId m : c.program.modules.ids()) {
        const ir::Module& module = c.program.modules[m];
        if (!module.is_root) continue;
        std::string base = cpp::file_stem(c.program, c.sources, m);
        if (!bases.insert(base).second)
            throw std::runtime_error("two files on the command line are called '" + base + "'");
        cpp::KernelCodes shaders = compile_shaders(c, kernels_with_code(options, c, m, cpp, defined), options.optimize);
        // The other targets are printed on another thread while this one prints C++.
        auto others = std::async(std::launch::async, [&] {
            std::vector<Output> made;
            emit_shaders(options, c, m, base, shaders, made);
            emit_libraries(c, m, base, made);
            if (options.wants(Target::json))
                made.push_back({base + ".glift.json", json::reflection_of(c.program, c.lowered, c.sources, m)});
            return made;
        });
        if (options.wants(Target::cpp) || options.wants(Target::host))
            emit_cpp(options, c, m, base, shaders, cpp, defined, outputs);
        std::ranges::move(others.get(), std::back_inserter(outputs));
    }
    return outputs;
}

}  // namespace gliftc
