#include "graphics_pipeline.h"

#include "../text.h"
#include "shader_stage.h"
#include "vulkan/memory/vulkan_memory.h"

#include <optional>

namespace glift::detail {

namespace {

VkPrimitiveTopology vulkan_topology(Topology topology) {
    switch (topology) {
    case Topology::triangles: return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    case Topology::lines: return VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
    case Topology::points: return VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
    }
    return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
}

VkCullModeFlags vulkan_cull(Cull cull) {
    switch (cull) {
    case Cull::none: return VK_CULL_MODE_NONE;
    case Cull::back: return VK_CULL_MODE_BACK_BIT;
    case Cull::front: return VK_CULL_MODE_FRONT_BIT;
    }
    return VK_CULL_MODE_NONE;
}

VkCompareOp vulkan_test(DepthTest test) {
    switch (test) {
    case DepthTest::less: return VK_COMPARE_OP_LESS;
    case DepthTest::less_equal: return VK_COMPARE_OP_LESS_OR_EQUAL;
    case DepthTest::greater: return VK_COMPARE_OP_GREATER;
    case DepthTest::equal: return VK_COMPARE_OP_EQUAL;
    case DepthTest::always: return VK_COMPARE_OP_ALWAYS;
    }
    return VK_COMPARE_OP_ALWAYS;
}

VkPipelineColorBlendAttachmentState vulkan_blend(Blend blend) {
    const auto state = [](VkBlendOp operation, VkBlendFactor source, VkBlendFactor target) {
        constexpr VkColorComponentFlags all =
            VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
        return VkPipelineColorBlendAttachmentState{VK_TRUE, source, target, operation, source, target, operation, all};
    };
    switch (blend) {
    case Blend::replace: break;
    case Blend::over: return state(VK_BLEND_OP_ADD, VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA);
    case Blend::add: return state(VK_BLEND_OP_ADD, VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE);
    case Blend::min: return state(VK_BLEND_OP_MIN, VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE);
    case Blend::max: return state(VK_BLEND_OP_MAX, VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE);
    case Blend::multiply: return state(VK_BLEND_OP_ADD, VK_BLEND_FACTOR_DST_COLOR, VK_BLEND_FACTOR_ZERO);
    }
    VkPipelineColorBlendAttachmentState replace = state(VK_BLEND_OP_ADD, VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ZERO);
    replace.blendEnable = VK_FALSE;
    return replace;
}

VkPipelineDepthStencilStateCreateInfo depth_state(const Drawing& drawing) {
    const bool has_depth = drawing.depth != nullptr;
    return {.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
            .depthTestEnable = has_depth,
            .depthWriteEnable = has_depth && drawing.writes_depth,
            .depthCompareOp = vulkan_test(drawing.depth_test)};
}

}  // namespace

// long: the function fills all the structures that Vulkan wants; the last one points to the others
VkPipeline make_graphics_pipeline(Context& context, const Pipeline& pipeline, VkPipelineCache cache) {
    const Drawing& drawing = *pipeline.kernel->drawing;
    const ShaderStage vertex(context, pipeline, pipeline.form->spirv, VK_SHADER_STAGE_VERTEX_BIT);
    std::optional<ShaderStage> fragment;
    if (!pipeline.form->fragment.empty())
        fragment.emplace(context, pipeline, pipeline.form->fragment, VK_SHADER_STAGE_FRAGMENT_BIT);
    const VkPipelineShaderStageCreateInfo stages[] = {vertex.info(), fragment ? fragment->info() : vertex.info()};

    std::vector<VkFormat> formats;
    std::vector<VkPipelineColorBlendAttachmentState> blends;
    for (const ColourTarget& target : drawing.colours) {
        formats.push_back(vulkan_format(target.format));
        blends.push_back(vulkan_blend(target.blend));
    }
    const VkPipelineRenderingCreateInfo rendering = {.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
                                                     .colorAttachmentCount = static_cast<std::uint32_t>(formats.size()),
                                                     .pColorAttachmentFormats = formats.data(),
                                                     .depthAttachmentFormat =
                                                         drawing.depth ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_UNDEFINED};
    const VkPipelineVertexInputStateCreateInfo no_input = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    const VkPipelineInputAssemblyStateCreateInfo assembly = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = vulkan_topology(drawing.topology)};
    const VkPipelineViewportStateCreateInfo viewport = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
    const VkPipelineRasterizationStateCreateInfo raster = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
        .polygonMode = VK_POLYGON_MODE_FILL,
        .cullMode = vulkan_cull(drawing.cull),
        .frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE,
        .lineWidth = 1.0f};
    const VkPipelineMultisampleStateCreateInfo samples = {.sType =
                                                              VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
                                                          .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
    const VkPipelineDepthStencilStateCreateInfo depth = depth_state(drawing);
    const VkPipelineColorBlendStateCreateInfo blend = {.sType =
                                                           VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                                                       .attachmentCount = static_cast<std::uint32_t>(blends.size()),
                                                       .pAttachments = blends.data()};
    constexpr VkDynamicState changing[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic = {.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                      .dynamicStateCount = 2,
                                                      .pDynamicStates = changing};
    const VkGraphicsPipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                               .pNext = &rendering,
                                               .stageCount = fragment ? 2u : 1u,
                                               .pStages = stages,
                                               .pVertexInputState = &no_input,
                                               .pInputAssemblyState = &assembly,
                                               .pViewportState = &viewport,
                                               .pRasterizationState = &raster,
                                               .pMultisampleState = &samples,
                                               .pDepthStencilState = &depth,
                                               .pColorBlendState = &blend,
                                               .pDynamicState = &dynamic,
                                               .layout = pipeline.layout};
    VkPipeline handle = VK_NULL_HANDLE;
    context.check(context.vk.vkCreateGraphicsPipelines(context.device, cache, 1, &info, nullptr, &handle),
                  ("vkCreateGraphicsPipelines for " + kernel_text(*pipeline.kernel)).c_str());
    return handle;
}

}  // namespace glift::detail
