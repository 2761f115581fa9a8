// Draws: each has its own dynamic rendering scope; targets are in VK_IMAGE_LAYOUT_GENERAL, like all images.
#include "encoder.h"
#include "vulkan_device.h"

#include <vector>

namespace glift::detail {

namespace {

VkRenderingAttachmentInfo attachment_info(const Attachment& attachment) {
    return {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
            .imageView = vulkan_memory(attachment.memory).attachment_view(attachment.mip, attachment.face),
            .imageLayout = VK_IMAGE_LAYOUT_GENERAL,
            .loadOp = VK_ATTACHMENT_LOAD_OP_LOAD,
            .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
}

VkRect2D area_of(const DrawTargets& targets) {
    return {{static_cast<std::int32_t>(targets.origin.x), static_cast<std::int32_t>(targets.origin.y)},
            {targets.extent.x, targets.extent.y}};
}

/// Calls `visit(memory, access)` for each target.
template <class Visit> void for_each_target(const Kernel& kernel, const DrawTargets& targets, Visit&& visit) {
    for (const Attachment& target : targets.colours) visit(vulkan_memory(target.memory), Access::read_write);
    if (kernel.drawing->depth)
        visit(vulkan_memory(targets.depth.memory), kernel.drawing->writes_depth ? Access::read_write : Access::read);
}

}  // namespace

// Records at most one barrier, for the memories of the shaders and for the targets.
void Encoder::order_targets(const Kernel& kernel, const Call& call) {
    bool conflict = kernel.reports && reported_;  // an earlier draw may still write its status record
    for_each_target(kernel, *call.targets, [&](const VulkanMemory& memory, Access access) {
        conflict = conflict || hazards_.conflicts(memory.id, access);
    });
    if (conflict) barrier();
    order(kernel, call);
    reported_ = reported_ || kernel.reports;
    for_each_target(kernel, *call.targets,
                    [&](const VulkanMemory& memory, Access access) { hazards_.note(memory.id, access); });
}

void Encoder::begin_rendering(const Drawing& drawing, const DrawTargets& targets) {
    std::vector<VkRenderingAttachmentInfo> colours;
    for (const Attachment& target : targets.colours) colours.push_back(attachment_info(target));
    VkRenderingAttachmentInfo depth;
    if (drawing.depth) depth = attachment_info(targets.depth);
    const VkRenderingInfo info = {.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                                  .renderArea = area_of(targets),
                                  .layerCount = 1,
                                  .colorAttachmentCount = static_cast<std::uint32_t>(colours.size()),
                                  .pColorAttachments = colours.data(),
                                  .pDepthAttachment = drawing.depth ? &depth : nullptr};
    context_.vk.vkCmdBeginRendering(commands_, &info);
}

void Encoder::set_viewport(const DrawTargets& targets) {
    const VkViewport viewport = {static_cast<float>(targets.origin.x),
                                 static_cast<float>(targets.origin.y),
                                 static_cast<float>(targets.extent.x),
                                 static_cast<float>(targets.extent.y),
                                 0.0f,
                                 1.0f};
    const VkRect2D scissor = area_of(targets);
    context_.vk.vkCmdSetViewport(commands_, 0, 1, &viewport);
    context_.vk.vkCmdSetScissor(commands_, 0, 1, &scissor);
}

void Encoder::draw(const Pipeline& pipeline, const Call& call) {
    const DrawTargets& targets = *call.targets;
    if (!call.size[0] || !call.size[1] || !targets.extent.x || !targets.extent.y) return;
    ++batch_->operations;
    if (!draws_) {
        draws_ = true;
        barrier();  // earlier barriers did not include graphics stages
    }
    const Slice block = write_parameters(pipeline, call);
    const bool is_prepared = !call.patches.empty() || !call.conditions.empty();
    const Slice command = is_prepared ? prepare(pipeline, call, block, call.size) : Slice{};
    order_targets(*pipeline.kernel, call);
    begin_rendering(*pipeline.kernel->drawing, targets);
    bind(pipeline, call, block);
    set_viewport(targets);
    if (!call.conditions.empty() || patches_size(pipeline, call)) {
        context_.vk.vkCmdDrawIndirect(commands_, command.buffer(), command.offset, 1, sizeof(VkDrawIndirectCommand));
    } else {
        context_.vk.vkCmdDraw(commands_, call.size[0], call.size[1], 0, 0);
    }
    context_.vk.vkCmdEndRendering(commands_);
}

}  // namespace glift::detail
