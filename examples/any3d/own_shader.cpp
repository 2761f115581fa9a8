#include "own_shader.h"

#include "../common/plain_vulkan.h"
#include "any3d.glift.hpp"
#include "octree_shader.h"
#include "whole_picture_shader.h"

#include <glift/vulkan.h>

#include <array>
#include <cstring>

namespace own_shader {

namespace {

/// What Parameters of octree.frag has: the octree's state, then the depth of the plane.
struct Parameters {
    std::uint32_t levels, best_extent, capacity;
    glift::uint3 texels_extent, image_extent;
    float z;
};

Parameters parameters_of(const any3d::Octree& octree) {
    const glift::uint3 extent = octree.frames().texels().extent();
    return {octree.levels(), octree.best().extent(), octree.pages().capacity(), extent, extent, 7.5f};
}

/// A pipeline that draws one triangle with octree.frag, and the descriptors of an octree.
class Drawing {
public:
    Drawing(const PlainVulkan& vulkan, VkFormat format, VkExtent2D extent);
    ~Drawing();
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    void bind(const any3d::Octree& octree) const;
    void draw(VkCommandBuffer commands, VkImage target, const Parameters& parameters);

private:
    void make_layouts();
    void make_pipeline(VkFormat format);

    VkDevice device_;
    VkFormat format_;
    VkExtent2D extent_;
    VkSampler sampler_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
};

Drawing::Drawing(const PlainVulkan& vulkan, VkFormat format, VkExtent2D extent)
    : device_(vulkan.device), format_(format), extent_(extent) {
    const VkSamplerCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                      .magFilter = VK_FILTER_LINEAR,
                                      .minFilter = VK_FILTER_LINEAR,
                                      .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                      .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                      .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE};
    check(vkCreateSampler(device_, &info, nullptr, &sampler_), "vkCreateSampler");
    make_layouts();
    make_pipeline(format);
}

void Drawing::make_layouts() {
    const VkDescriptorSetLayoutBinding bindings[] = {
        {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr},
        {2, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr}};
    const VkDescriptorSetLayoutCreateInfo set_info = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .bindingCount = 2, .pBindings = bindings};
    check(vkCreateDescriptorSetLayout(device_, &set_info, nullptr, &set_layout_), "vkCreateDescriptorSetLayout");
    const VkPushConstantRange constants = {VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(Parameters)};
    const VkPipelineLayoutCreateInfo layout_info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                                    .setLayoutCount = 1,
                                                    .pSetLayouts = &set_layout_,
                                                    .pushConstantRangeCount = 1,
                                                    .pPushConstantRanges = &constants};
    check(vkCreatePipelineLayout(device_, &layout_info, nullptr, &layout_), "vkCreatePipelineLayout");
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1}};
    const VkDescriptorPoolCreateInfo pool_info = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = 1, .poolSizeCount = 2, .pPoolSizes = sizes};
    check(vkCreateDescriptorPool(device_, &pool_info, nullptr, &pool_), "vkCreateDescriptorPool");
    const VkDescriptorSetAllocateInfo set = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                             .descriptorPool = pool_,
                                             .descriptorSetCount = 1,
                                             .pSetLayouts = &set_layout_};
    check(vkAllocateDescriptorSets(device_, &set, &set_), "vkAllocateDescriptorSets");
}

template <std::size_t n> VkShaderModule module_of(VkDevice device, const std::uint32_t (&code)[n]) {
    const VkShaderModuleCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = sizeof code, .pCode = code};
    VkShaderModule module = VK_NULL_HANDLE;
    check(vkCreateShaderModule(device, &info, nullptr, &module), "vkCreateShaderModule");
    return module;
}

// long: a Vulkan pipeline has this many parts
void Drawing::make_pipeline(VkFormat format) {
    const VkShaderModule vertex = module_of(device_, whole_picture_shader),
                         fragment = module_of(device_, octree_shader);
    const auto stage = [](VkShaderStageFlagBits which, VkShaderModule module) {
        return VkPipelineShaderStageCreateInfo{.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                               .stage = which,
                                               .module = module,
                                               .pName = "main"};
    };
    const std::array stages = {stage(VK_SHADER_STAGE_VERTEX_BIT, vertex),
                               stage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment)};
    const VkPipelineRenderingCreateInfo rendering = {.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
                                                     .colorAttachmentCount = 1,
                                                     .pColorAttachmentFormats = &format};
    const VkPipelineVertexInputStateCreateInfo input = {.sType =
                                                            VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    const VkPipelineInputAssemblyStateCreateInfo assembly = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    const VkViewport viewport = {0, 0, float(extent_.width), float(extent_.height), 0, 1};
    const VkRect2D all = {{0, 0}, extent_};
    const VkPipelineViewportStateCreateInfo view = {.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
                                                    .viewportCount = 1,
                                                    .pViewports = &viewport,
                                                    .scissorCount = 1,
                                                    .pScissors = &all};
    const VkPipelineRasterizationStateCreateInfo raster = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1};
    const VkPipelineMultisampleStateCreateInfo samples = {.sType =
                                                              VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
                                                          .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
    const VkPipelineColorBlendAttachmentState written = {.colorWriteMask = 0xf};
    const VkPipelineColorBlendStateCreateInfo blend = {.sType =
                                                           VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                                                       .attachmentCount = 1,
                                                       .pAttachments = &written};
    const VkGraphicsPipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                               .pNext = &rendering,
                                               .stageCount = stages.size(),
                                               .pStages = stages.data(),
                                               .pVertexInputState = &input,
                                               .pInputAssemblyState = &assembly,
                                               .pViewportState = &view,
                                               .pRasterizationState = &raster,
                                               .pMultisampleState = &samples,
                                               .pColorBlendState = &blend,
                                               .layout = layout_};
    check(vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_),
          "vkCreateGraphicsPipelines");
    vkDestroyShaderModule(device_, vertex, nullptr);
    vkDestroyShaderModule(device_, fragment, nullptr);
}

Drawing::~Drawing() {
    vkDestroyImageView(device_, view_, nullptr);
    vkDestroyDescriptorPool(device_, pool_, nullptr);
    vkDestroyPipeline(device_, pipeline_, nullptr);
    vkDestroyPipelineLayout(device_, layout_, nullptr);
    vkDestroyDescriptorSetLayout(device_, set_layout_, nullptr);
    vkDestroySampler(device_, sampler_, nullptr);
}

void Drawing::bind(const any3d::Octree& octree) const {
    const glift::vulkan::BufferHandle table = glift::vulkan::buffer(octree.best().data());
    const glift::vulkan::ImageHandle frames = glift::vulkan::image(octree.frames().texels().data());
    const VkDescriptorBufferInfo buffer = {table.buffer, table.offset, table.bytes};
    const VkDescriptorImageInfo image = {sampler_, frames.view, frames.layout};
    const VkWriteDescriptorSet writes[] = {{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                            .dstSet = set_,
                                            .dstBinding = 1,
                                            .descriptorCount = 1,
                                            .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                            .pBufferInfo = &buffer},
                                           {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                            .dstSet = set_,
                                            .dstBinding = 2,
                                            .descriptorCount = 1,
                                            .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                            .pImageInfo = &image}};
    vkUpdateDescriptorSets(device_, 2, writes, 0, nullptr);
}

void Drawing::draw(VkCommandBuffer commands, VkImage target, const Parameters& parameters) {
    const VkImageViewCreateInfo info = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                        .image = target,
                                        .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                        .format = format_,
                                        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    check(vkCreateImageView(device_, &info, nullptr, &view_), "vkCreateImageView");
    const VkMemoryBarrier cleared = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                     .srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT,
                                     .dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, 0, 1,
                         &cleared, 0, nullptr, 0, nullptr);
    const VkRenderingAttachmentInfo attachment = {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                                  .imageView = view_,
                                                  .imageLayout = VK_IMAGE_LAYOUT_GENERAL,
                                                  .loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                                                  .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
    const VkRenderingInfo rendering = {.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                                       .renderArea = {{0, 0}, extent_},
                                       .layerCount = 1,
                                       .colorAttachmentCount = 1,
                                       .pColorAttachments = &attachment};
    vkCmdBeginRendering(commands, &rendering);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &set_, 0, nullptr);
    vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof parameters, &parameters);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
}

}  // namespace

std::vector<glift::float4> draw_octree(std::uint32_t side) {
    const PlainVulkan vulkan;
    const glift::Device device = glift::vulkan::adopt({.instance = vulkan.instance,
                                                       .physical = vulkan.physical,
                                                       .device = vulkan.device,
                                                       .queue = vulkan.queue,
                                                       .queue_family = vulkan.queue_family,
                                                       .extensions = vulkan.extensions});
    const any3d::Places places(device, glift::uint2(side, side));
    any3d::Octree octree(device, 4, 512);
    any3d::centres(device, places, places);
    any3d::paint_octree(device, places, octree);
    device.wait();

    constexpr VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
    const ColourImage picture(vulkan, format, {side, side});
    const ReadbackBuffer result(vulkan, sizeof(glift::float4) * side * side);
    Drawing drawing(vulkan, format, {side, side});
    drawing.bind(octree);
    const VkCommandBuffer commands = vulkan.begin();
    picture.clear(commands, 0);
    drawing.draw(commands, picture.image, parameters_of(octree));
    const VkMemoryBarrier drawn = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                   .srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                                   .dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 1,
                         &drawn, 0, nullptr, 0, nullptr);
    picture.copy_to(commands, result.buffer);
    vulkan.run(commands);

    std::vector<glift::float4> pixels(std::size_t{side} * side);
    std::memcpy(pixels.data(), result.data, sizeof(glift::float4) * pixels.size());
    return pixels;
}

}  // namespace own_shader
