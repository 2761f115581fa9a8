#include "golden.h"

#include "support/process.h"

namespace glift::test {
namespace {

/// fold.glift.hpp → fold.expected.hpp; fold.fold_all.comp.glsl → fold.expected.fold_all.comp.glsl
std::string golden_name(const std::string& name, const std::string& output) {
    std::string rest = output.starts_with(name + ".") ? output.substr(name.size() + 1) : output;
    if (rest.starts_with("glift.")) rest = rest.substr(std::string("glift.").size());
    return name + ".expected." + rest;
}

/// Whether the output is compared: not code of other modules, JSON and the host's code only for cases that name them.
bool is_compared(const std::string& output, const std::string& source) {
    const auto ends = [&](std::string_view ending) { return output.ends_with(ending); };
    if (ends(".d") || ends(".types.hpp") || ends(".internal.hpp") || output.find(".library.") != output.npos)
        return false;
    if (ends(".json")) return source.find("// golden: json") != source.npos;
    if (ends(".kernels.cpp")) return source.find("// golden: host") != source.npos;
    return true;
}

std::vector<std::string> gliftc(const std::filesystem::path& source, std::vector<std::string> options) {
    options.insert(options.begin(), GLIFT_GLIFTC);
    options.insert(options.end(), {"-I", (source.parent_path() / "support").string(), source.string()});
    return options;
}

}  // namespace

std::vector<std::filesystem::path> golden_cases() { return files_under(GLIFT_SOURCE_DIR "/tests/golden", ".glift"); }

GoldenOutputs compile_golden(const std::filesystem::path& source, const std::filesystem::path& folder) {
    GoldenOutputs result;
    const std::string name = source.stem().string();
    const ProcessResult run = run_process(
        // SPIR-V is left out of the C++, since nobody reads it.
        gliftc(source, {"--host-only", "--target=glsl", "--target=cpp", "--target=host", "--target=json", "-o",
                        folder.string()}));
    const ProcessResult ir = run_process(gliftc(source, {"--dump=lower"}));
    if (run.exit_code != 0 || ir.exit_code != 0) {
        result.error = run.exit_code != 0 ? run.err + run.out : ir.err + ir.out;
        return result;
    }
    const std::string text = read_file(source);
    for (const std::filesystem::path& output : files_under(folder, "")) {
        const std::string file = output.filename().string();
        if (is_compared(file, text)) result.files[golden_name(name, file)] = read_file(output);
    }
    result.files[name + ".expected.ir"] = ir.out;
    return result;
}

std::map<std::string, std::string> stored_goldens(const std::filesystem::path& source) {
    std::map<std::string, std::string> found;
    const std::string prefix = source.stem().string() + ".expected.";
    for (const auto& entry : std::filesystem::directory_iterator(source.parent_path())) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(prefix)) found[name] = read_file(entry.path());
    }
    return found;
}

}  // namespace glift::test
