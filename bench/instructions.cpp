#include "instructions.h"

#include <spirv-tools/optimizer.hpp>

#include <fstream>
#include <stdexcept>
#include <unordered_map>

namespace bench {

namespace {

constexpr std::uint32_t op_line = 8, op_no_line = 317, op_function = 54, op_function_end = 56;

}  // namespace

std::vector<std::uint32_t> read_spirv(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    std::vector<std::uint32_t> words(static_cast<std::size_t>(file.tellg()) / 4);
    file.seekg(0);
    file.read(reinterpret_cast<char*>(words.data()), static_cast<std::streamsize>(words.size() * 4));
    return words;
}

namespace {

/// The SPIR-V after the passes that are registered already, followed by those of `spirv-opt -O`.
std::vector<std::uint32_t> optimised(spvtools::Optimizer& optimizer, const std::vector<std::uint32_t>& spirv) {
    optimizer.RegisterPerformancePasses();
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);  // the validator would refuse scalar block layout
    std::vector<std::uint32_t> words;
    if (!optimizer.Run(spirv.data(), spirv.size(), &words, options)) throw std::runtime_error("spirv-opt failed");
    return words;
}

std::size_t counted(const std::vector<std::uint32_t>& words) {
    std::size_t count = 0;
    bool inside = false;
    for (std::size_t at = 5; at < words.size(); at += words[at] >> 16) {
        const std::uint32_t op = words[at] & 0xffffu;
        if (op == op_function) inside = true;
        if (inside && op != op_line && op != op_no_line) ++count;
        if (op == op_function_end) inside = false;
    }
    return count;
}

}  // namespace

std::size_t instructions_of(const std::vector<std::uint32_t>& spirv) {
    spvtools::Optimizer optimizer(SPV_ENV_UNIVERSAL_1_6);
    return counted(optimised(optimizer, spirv));
}

std::size_t instructions_of(const Shader& shader) {
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
    for (const auto& [id, value] : shader.constants) values[id] = {value};
    spvtools::Optimizer optimizer(SPV_ENV_UNIVERSAL_1_6);
    optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
        .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
        .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass());
    return counted(optimised(optimizer, shader.words));
}

}  // namespace bench
