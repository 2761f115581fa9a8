// A shader of a pipeline: its SPIR-V module, rewritten for this device, and the values of the specialisation constants
// that generated shaders declare.
#pragma once

#include "pipelines.h"

namespace glift::detail {

class ShaderStage {
public:
    ShaderStage(Context& context, const Pipeline& pipeline, const Spirv& spirv, VkShaderStageFlagBits stage);
    ~ShaderStage();
    ShaderStage(const ShaderStage&) = delete;

    /// Valid while this object lives.
    const VkPipelineShaderStageCreateInfo& info() const { return info_; }

private:
    void require_subgroups(std::uint32_t group_width);

    Context& context_;
    std::array<std::uint32_t, 6> constants_;
    std::array<VkSpecializationMapEntry, 6> entries_;
    VkSpecializationInfo special_ = {};
    VkPipelineShaderStageRequiredSubgroupSizeCreateInfo subgroups_ = {};
    VkPipelineShaderStageCreateInfo info_ = {};
};

}  // namespace glift::detail
