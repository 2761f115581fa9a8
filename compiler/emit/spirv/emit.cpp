#include "emit/spirv/emit.h"

#include "emit/spirv/alignment.h"
#include "emit/spirv/exact.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <glslang/SPIRV/spirv.hpp>
#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

#include <algorithm>

namespace gliftc::spirv {

namespace {

/// Initialises glslang at the first use.
void initialise_glslang() {
    static const bool done = glslang::InitializeProcess();
    (void)done;
}

/// The lines that say what is wrong, without glslang's closing summary of a compilation.
std::string errors_of(const std::string& log) {
    std::string text;
    for (std::size_t from = 0; from < log.size();) {
        std::size_t end = log.find('\n', from);
        if (end == std::string::npos) end = log.size();
        std::string line = log.substr(from, end - from);
        from = end + 1;
        if (line.find("compilation errors") != std::string::npos) continue;
        if (line.rfind("ERROR: ", 0) == 0) line.erase(0, 7);
        if (!line.empty()) text += (text.empty() ? "" : "\n") + line;
    }
    return text.empty() ? "glslang failed" : text;
}

EShLanguage language_of(Stage stage) {
    switch (stage) {
    case Stage::compute: return EShLangCompute;
    case Stage::vertex: return EShLangVertex;
    case Stage::fragment: return EShLangFragment;
    }
    return EShLangCompute;
}

Spirv compile(const std::string& glsl, EShLanguage language) {
    initialise_glslang();
    glslang::TShader shader(language);
    const char* text = glsl.c_str();
    shader.setStrings(&text, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgDebugInfo);
    if (!shader.parse(GetDefaultResources(), 460, false, messages)) return {{}, errors_of(shader.getInfoLog())};
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages)) return {{}, errors_of(program.getInfoLog())};
    glslang::SpvOptions options;
    options.generateDebugInfo = glsl.find("\n#line ") != std::string::npos;
    options.disableOptimizer = true;
    Spirv result;
    spv::SpvBuildLogger logger;
    glslang::GlslangToSpv(*program.getIntermediate(language), result.words, &logger, &options);
    if (result.words.empty()) result.error = "glslang made no SPIR-V: " + logger.getAllMessages();
    return result;
}

/// The module without its GLSL text, which glslang adds together with the line numbers and which is most of the module.
/// Nothing needs it: the line numbers are those of .glift files.
std::vector<std::uint32_t> without_source(const std::vector<std::uint32_t>& words) {
    constexpr std::size_t header_words = 5, source_words = 4;  // of OpSource: its first word, language, version, file
    std::vector<std::uint32_t> result(words.begin(), words.begin() + header_words);
    result.reserve(words.size());
    for (std::size_t at = header_words, count = 0; at < words.size(); at += count) {
        const auto op = static_cast<spv::Op>(words[at] & 0xffffu);
        count = words[at] >> 16;
        if (op == spv::OpSourceContinued) continue;
        const std::size_t kept = op == spv::OpSource ? std::min(count, source_words) : count;
        result.push_back(static_cast<std::uint32_t>(kept) << 16 | static_cast<std::uint32_t>(op));
        result.insert(result.end(), words.begin() + static_cast<std::ptrdiff_t>(at + 1),
                      words.begin() + static_cast<std::ptrdiff_t>(at + kept));
    }
    return result;
}

std::string validated(const std::vector<std::uint32_t>& words) {
    std::string error;
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t& position,
                                 const char* message) {
        error +=
            (error.empty() ? "" : "\n") + std::string("SPIR-V word ") + std::to_string(position.index) + ": " + message;
    });
    spvtools::ValidatorOptions options;
    options.SetScalarBlockLayout(true);
    if (tools.Validate(words.data(), words.size(), options)) return "";
    return error.empty() ? "the SPIR-V is not valid" : error;
}

std::vector<std::uint32_t> optimised(const std::vector<std::uint32_t>& words) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    // Those passes of spirv-opt that make modules smaller and take less time than glslang. Drivers do the rest.
    optimizer.RegisterPass(spvtools::CreateSSARewritePass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass())
        .RegisterPass(spvtools::CreateCompactIdsPass());
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    std::vector<std::uint32_t> result;
    return optimizer.Run(words.data(), words.size(), &result, options) ? result : words;
}

}  // namespace

Spirv spirv_of(const std::string& glsl, Optimise optimise, Stage stage, Contraction contraction) {
    Spirv result = compile(glsl, language_of(stage));
    if (!result.error.empty()) return result;
    result.words = made_exact(without_source(result.words), contraction);
    correct_alignments(result.words);
    if (optimise == Optimise::size) result.words = optimised(result.words);
    result.error = validated(result.words);
    if (!result.error.empty()) result.words.clear();
    return result;
}

}  // namespace gliftc::spirv
