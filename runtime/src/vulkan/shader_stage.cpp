#include "shader_stage.h"

#include "branches.h"
#include "vulkan/spirv/exact_sums.h"
#include "vulkan/spirv/fixed_parameters.h"
#include "vulkan/spirv/float_atomics.h"
#include "vulkan/spirv/float_controls.h"
#include "vulkan/spirv/hidden_limits.h"
#include "vulkan/spirv/hidden_zeros.h"
#include "vulkan/spirv/requirements.h"
#include "vulkan/spirv/separate_texels.h"
#include "vulkan/spirv/spirv_module.h"
#include "vulkan/spirv/spirv_words.h"

namespace glift::detail {

namespace {

/// The specialisation constants of generated shaders, by number.
enum Constant : std::uint32_t {
    exact_division = 100,  ///< true where the device rounds / and sqrt of floats correctly: on CPUs
    loop_rounds = 101,     ///< the device's loop_round_limit; 0: it has none
    fences_are_barriers = 102,
    is_cpu = 103,
    branches_are_skipped = 104,  ///< a branch that no lane takes costs nothing
    adds_floats = 105,           ///< the device adds floats by one atomic operation
};

VkShaderModule make_module(Context& context, const Pipeline& pipeline, const Spirv& spirv) {
    std::vector<std::uint32_t> code =
        with_fixed_parameters(with_float_modes(words_of(spirv), context.float_controls.modes), pipeline.fixed);
    if (!context.properties.float32_atomic_add) code = without_float_atomics(code);
    if (context.float_controls.hides_zeros) code = with_hidden_zeros(code);
    if (context.float_controls.keeps_sums) code = with_kept_sums(code);
    if (context.hides_loop_ends) code = with_hidden_limits(code);
    if (context.separates_texels) code = with_separate_texels(code);
    // NVIDIA's driver (580.159) takes the code of an equal module that it compiled for a pipeline without
    // VK_PIPELINE_CREATE_DISPATCH_BASE_BIT, and then begins at group 0. The word says which tool made the module.
    if (pipeline.starts_anywhere) ++code[spirv_generator_word];
    const VkShaderModuleCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                           .codeSize = code.size() * sizeof(std::uint32_t),
                                           .pCode = code.data()};
    VkShaderModule module = VK_NULL_HANDLE;
    context.check(context.vk.vkCreateShaderModule(context.device, &info, nullptr, &module), "vkCreateShaderModule");
    return module;
}

}  // namespace

ShaderStage::ShaderStage(Context& context, const Pipeline& pipeline, const Spirv& spirv, VkShaderStageFlagBits stage)
    : context_(context) {
    const std::uint64_t rounds = context.properties.loop_round_limit;
    const VkBool32 cpu = context.properties.kind == DeviceKind::cpu;
    constants_ = {cpu,
                  rounds == unlimited ? 0 : static_cast<std::uint32_t>(rounds),
                  context.properties.fences_are_barriers,
                  cpu,
                  skips_branches(context.properties.kind),
                  context.properties.float32_atomic_add};
    constexpr std::uint32_t ids[] = {exact_division, loop_rounds,          fences_are_barriers,
                                     is_cpu,         branches_are_skipped, adds_floats};
    for (std::uint32_t i = 0; i < entries_.size(); ++i)
        entries_[i] = {ids[i], i * static_cast<std::uint32_t>(sizeof constants_[0]), sizeof constants_[0]};
    special_ = {static_cast<std::uint32_t>(entries_.size()), entries_.data(), sizeof constants_, constants_.data()};
    info_ = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
             .stage = stage,
             .module = make_module(context, pipeline, spirv),
             .pName = "main",
             .pSpecializationInfo = &special_};
    if (stage == VK_SHADER_STAGE_COMPUTE_BIT && context.subgroups.vary() && uses_subgroups(words_of(spirv)))
        require_subgroups(pipeline.kernel->group[0]);
}

void ShaderStage::require_subgroups(std::uint32_t group_width) {
    subgroups_ = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_REQUIRED_SUBGROUP_SIZE_CREATE_INFO,
                  .requiredSubgroupSize = context_.properties.subgroup_size};
    info_.pNext = &subgroups_;
    // Vulkan allows this only where a row of the workgroup can be full subgroups.
    if (group_width % subgroups_.requiredSubgroupSize == 0)
        info_.flags = VK_PIPELINE_SHADER_STAGE_CREATE_REQUIRE_FULL_SUBGROUPS_BIT;
}

ShaderStage::~ShaderStage() { context_.vk.vkDestroyShaderModule(context_.device, info_.module, nullptr); }

}  // namespace glift::detail
