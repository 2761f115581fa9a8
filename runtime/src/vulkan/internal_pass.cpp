#include "internal_pass.h"

namespace glift::detail {

InternalPass::InternalPass(Context& context, const char* name, std::span<const std::uint32_t> spirv,
                           std::uint32_t push_bytes)
    : context_(context), name_(name), spirv_(spirv), push_bytes_(push_bytes) {}

InternalPass::~InternalPass() {
    context_.vk.vkDestroyPipeline(context_.device, pipeline_, nullptr);
    context_.vk.vkDestroyPipelineLayout(context_.device, layout_, nullptr);
}

void InternalPass::create() {
    const DeviceTable& vk = context_.vk;
    const VkPushConstantRange range = {VK_SHADER_STAGE_COMPUTE_BIT, 0, push_bytes_};
    const VkPipelineLayoutCreateInfo layout_info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                                    .pushConstantRangeCount = 1,
                                                    .pPushConstantRanges = &range};
    const VkShaderModuleCreateInfo module_info = {
        .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = spirv_.size_bytes(), .pCode = spirv_.data()};
    VkShaderModule module = VK_NULL_HANDLE;
    if (!layout_)
        context_.check(vk.vkCreatePipelineLayout(context_.device, &layout_info, nullptr, &layout_),
                       "vkCreatePipelineLayout");
    context_.check(vk.vkCreateShaderModule(context_.device, &module_info, nullptr, &module), "vkCreateShaderModule");
    const VkComputePipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                              .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                        .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                                                        .module = module,
                                                        .pName = "main"},
                                              .layout = layout_};
    const VkResult result = vk.vkCreateComputePipelines(context_.device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_);
    vk.vkDestroyShaderModule(context_.device, module, nullptr);
    context_.check(result, "vkCreateComputePipelines");
    context_.set_name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(pipeline_), name_);
}

void InternalPass::bind(VkCommandBuffer commands, const void* push) {
    if (!pipeline_) create();
    context_.vk.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
    context_.vk.vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_COMPUTE_BIT, 0, push_bytes_, push);
}

}  // namespace glift::detail
