#include "encoder.h"

#include "../check.h"
#include "../environment.h"
#include "../text.h"
#include "descriptor_limits.h"
#include "vulkan_device.h"

#include <glift/error.h>

#include <algorithm>
#include <cstring>

namespace glift::detail {

namespace {

// The accesses of passes and copies, listed: on an H200 a barrier for all accesses (MEMORY_READ, MEMORY_WRITE) takes
// 2.7 us longer.
constexpr VkPipelineStageFlags2 work_stages =
    VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
constexpr VkAccessFlags2 work_writes = VK_ACCESS_2_SHADER_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT;
constexpr VkAccessFlags2 work_reads = VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_TRANSFER_READ_BIT;

// The further accesses of draws.
constexpr VkPipelineStageFlags2 draw_stages =
    VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT |
    VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkAccessFlags2 draw_writes =
    VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 draw_reads = VK_ACCESS_2_UNIFORM_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT |
                                      VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;

VkMemoryBarrier2 between_work(bool draws) {
    const VkPipelineStageFlags2 stages = work_stages | (draws ? draw_stages : 0);
    const VkAccessFlags2 writes = work_writes | (draws ? draw_writes : 0);
    return {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
            .srcStageMask = stages,
            .srcAccessMask = writes,
            .dstStageMask = stages,
            .dstAccessMask = writes | work_reads | (draws ? draw_reads : 0)};
}

/// After the pass that writes commands, and values into parameters, which may lie in uniform buffers.
VkMemoryBarrier2 before_indirect_work(bool draws) {
    VkMemoryBarrier2 barrier = between_work(draws);
    barrier.dstStageMask |= VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT;
    barrier.dstAccessMask |= VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_UNIFORM_READ_BIT;
    return barrier;
}

constexpr VkMemoryBarrier2 between_everything = {
    .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
    .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_2_HOST_BIT,
    .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
    .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_2_HOST_BIT,
    .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};

[[noreturn]] void throw_too_many_groups(const Kernel& kernel, const Context& context) {
    const auto& limit = context.properties.max_workgroups;
    throw Error(ErrorCode::too_large, "an iteration has more workgroups than the device allows", kernel_text(kernel),
                context.properties.name + " allows " + std::to_string(limit[0]) + " x " + std::to_string(limit[1]) +
                    " x " + std::to_string(limit[2]),
                "run the kernel over parts of the range, or with larger workgroups");
}

}  // namespace

Encoder::Encoder(VulkanDevice& device) : device_(device), context_(device.context()), labels_(device.context()) {}

void Encoder::barrier() { barrier(between_work(draws_)); }

void Encoder::barrier(const VkMemoryBarrier2& what) {
    const VkDependencyInfo info = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &what};
    context_.vk.vkCmdPipelineBarrier2(commands_, &info);
    hazards_.barrier();
    reported_ = false;
    ++device_.counters().barriers;
}

void Encoder::barrier_before_indirect() { barrier(before_indirect_work(draws_)); }

void Encoder::full_barrier() {
    const VkDependencyInfo info = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &between_everything};
    context_.vk.vkCmdPipelineBarrier2(commands_, &info);
    hazards_.barrier();
    reported_ = false;
}

bool Encoder::fit_descriptors(std::span<const Memory> memories) const {
    return std::ranges::all_of(memories, [&](const Memory& memory) {
        return vulkan_memory(memory).range <= context_.properties.max_storage_buffer_range;
    });
}

// Aliased elements need pointers that may be equal: SPIR-V lets a driver assume that two buffer descriptors of a shader
// do not alias. compiler/lower/analysis/aliasing.h says how the general form reads what was written through another
// parameter's image.
bool Encoder::can_be_direct(const Kernel& kernel, std::span<const Memory> memories,
                            const std::array<std::uint32_t, 4>& size, Sharing sharing) const {
    check_memories(&device_, kernel, memories);
    if (kernel.direct.spirv.empty() || forces_general_form() || sharing == Sharing::one_place) return false;
    if (!fit_descriptors(memories) || !buffers_fit(context_, kernel)) return false;
    if (kernel.drawing || kernel.of_blocks) return true;  // draws have no workgroups; kernels over blocks fold theirs
    return kernel.rank == 1 || count_groups(kernel, size).within(context_.properties.max_workgroups);
}

void Encoder::check_form(const Kernel& kernel, const Call& call) const {
    if (call.form == FormName::general) return;
    if (fit_descriptors(call.memories)) {
        if (buffers_fit(context_, kernel)) return;
        check_descriptors(context_, kernel, count_descriptors(kernel, form_of(kernel, call.form)));
    }
    const auto largest =
        std::max_element(call.memories.begin(), call.memories.end(), [](const Memory& a, const Memory& b) {
            return vulkan_memory(a).range < vulkan_memory(b).range;
        });
    throw Error(ErrorCode::too_large,
                std::string("a memory is too large for the ") + form_text(call.form) + " form of a kernel",
                kernel_text(kernel) + ", " + memory_text(largest->description()),
                "a descriptor covers " + size_text(context_.properties.max_storage_buffer_range),
                "ask Commands::can_be_direct before packing the parameters");
}

// Records a barrier before a pass if one of its memories needs it, and notes the pass's accesses.
void Encoder::order(const Kernel& kernel, const Call& call) {
    const std::size_t count = call.memories.size();
    for (std::size_t k = 0; k < count; ++k) {
        if (!hazards_.conflicts(vulkan_memory(call.memories[k]).id, kernel.bindings[k].access)) continue;
        barrier();
        break;
    }
    for (std::size_t k = 0; k < count; ++k) {
        hazards_.note(vulkan_memory(call.memories[k]).id, kernel.bindings[k].access);
    }
}

Slice Encoder::write_parameters(const Pipeline& pipeline, const Call& call) {
    const Form& form = *pipeline.form;
    if (form.push_constants || !form.parameter_bytes) return {};
    const Slice block = batch_->parameters.take(form.parameter_bytes);
    std::memcpy(block.data, call.parameters.data(), call.parameters.size());
    if (pipeline.name == FormName::general) {
        for (std::size_t k = 0; k < call.memories.size(); ++k) {
            const Binding& binding = pipeline.kernel->bindings[k];
            if (binding.kind != MemoryKind::buffer) continue;
            std::memcpy(block.data + binding.address_offset, &vulkan_memory(call.memories[k]).address,
                        sizeof(VkDeviceAddress));
        }
    }
    return block;
}

void Encoder::push_descriptors(const Pipeline& pipeline, const Call& call, const Slice& block) {
    if (!pipeline.update) return;
    const std::uint32_t count = pipeline.descriptor_count();
    DescriptorInfo few[40];
    std::vector<DescriptorInfo> many(count > std::size(few) ? count : 0);
    DescriptorInfo* const infos = many.empty() ? few : many.data();
    DescriptorInfo* next = infos;
    if (block.chunk) (next++)->buffer = {block.buffer(), block.offset, pipeline.form->parameter_bytes};
    for (std::size_t k = 0; k < call.memories.size(); ++k) {
        const Binding& binding = pipeline.kernel->bindings[k];
        VulkanMemory& memory = vulkan_memory(call.memories[k]);
        if (binding.kind == MemoryKind::buffer) {
            if (pipeline.name != FormName::general) (next++)->buffer = {memory.parts.buffer, 0, memory.range};
        } else if (binding.sampled) {
            memory.require(VK_IMAGE_USAGE_SAMPLED_BIT);
            (next++)->image = {device_.pipelines().sampler(binding.sampler), memory.views_as(binding.kind).sampled,
                               VK_IMAGE_LAYOUT_GENERAL};
        } else {
            memory.require(VK_IMAGE_USAGE_STORAGE_BIT);
            const VkImageView view =
                binding.as_bits ? memory.bits_view(binding.kind) : memory.views_as(binding.kind).storage;
            (next++)->image = {VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL};
        }
    }
    if (pipeline.kernel->reports) {
        (next++)->buffer = {device_.status_buffer(), pipeline.status_slot * status_stride, sizeof(StatusRecord)};
    }
    if (!pipeline.kernel->messages.empty()) {
        next->buffer = {device_.message_chunk().buffer, 0, device_.message_chunk().bytes};
    }
    if (pipeline.push) {
        context_.vk.vkCmdPushDescriptorSetWithTemplateKHR(commands_, pipeline.update, pipeline.layout, 0, infos);
        return;
    }
    const VkDescriptorSet set = batch_->sets.take(pipeline);
    context_.vk.vkUpdateDescriptorSetWithTemplate(context_.device, set, pipeline.update, infos);
    context_.vk.vkCmdBindDescriptorSets(commands_, pipeline.bind_point(), pipeline.layout, 0, 1, &set, 0, nullptr);
}

void Encoder::bind(const Pipeline& pipeline, const Call& call, const Slice& block) {
    if (bound_ != pipeline.handle) {
        context_.vk.vkCmdBindPipeline(commands_, pipeline.bind_point(), pipeline.handle);
        bound_ = pipeline.handle;
    }
    if (pipeline.form->push_constants && pipeline.form->parameter_bytes) {
        context_.vk.vkCmdPushConstants(commands_, pipeline.layout, pipeline.stages(), 0,
                                       static_cast<std::uint32_t>(call.parameters.size()), call.parameters.data());
    }
    push_descriptors(pipeline, call, block);
}

void Encoder::dispatch(const Kernel& kernel, const Call& call) {
    check_call(&device_, kernel, call);
    check_form(kernel, call);
    const Pipeline& pipeline = device_.pipelines().get(kernel, call.form, call.fixed, call.part.has_value());
    if (kernel.drawing) return draw(pipeline, call);
    Groups groups = count_groups(kernel, call.size);
    if (groups.none()) return;
    ++batch_->operations;
    if (call.part) return dispatch_part(pipeline, call, groups);
    const auto& limit = context_.properties.max_workgroups;
    if (kernel.rank == 1) fold(groups, limit_along_x(kernel, limit[0]));
    if (kernel.of_blocks) fold_blocks(groups, limit[1]);
    const bool fits = groups.within(limit);
    const bool is_sized = patches_size(pipeline, call);
    if (!fits && (is_sized || pipeline.form->base_offset == UINT32_MAX)) throw_too_many_groups(kernel, context_);

    const Slice block = write_parameters(pipeline, call);
    Slice command;
    if (fits && (!call.patches.empty() || !call.conditions.empty()))
        command = prepare(pipeline, call, block, call.size);
    if (!kernel.messages.empty()) begin_messages(pipeline);
    order(kernel, call);
    if (!fits) return dispatch_split(pipeline, call, groups);
    if (is_sized || !call.conditions.empty()) {
        bind(pipeline, call, block);
        context_.vk.vkCmdDispatchIndirect(commands_, command.buffer(), command.offset);
        return;
    }
    bind(pipeline, call, block);
    context_.vk.vkCmdDispatch(commands_, static_cast<std::uint32_t>(groups.count[0]),
                              static_cast<std::uint32_t>(groups.count[1]), static_cast<std::uint32_t>(groups.count[2]));
}

// Dispatches the workgroups that have elements of the part.
void Encoder::dispatch_part(const Pipeline& pipeline, const Call& call, const Groups& groups) {
    const Kernel& kernel = *pipeline.kernel;
    if (!groups.within(context_.properties.max_workgroups)) throw_too_many_groups(kernel, context_);
    const std::uint32_t axis = std::min(kernel.rank - 1, 2u), covered = covered_by_group(kernel)[axis];
    const std::uint64_t along = kernel.rank == 4 ? call.size[2] : 1;  // axes z and w count as one
    std::array<std::uint32_t, 3> base = {}, count;
    for (int i = 0; i < 3; ++i) count[i] = static_cast<std::uint32_t>(groups.count[i]);
    base[axis] = static_cast<std::uint32_t>(call.part->first * along / covered);
    const std::uint64_t end = std::min(div_ceil(call.part->end * along, covered), groups.count[axis]);
    if (end <= base[axis]) return;
    count[axis] = static_cast<std::uint32_t>(end - base[axis]);
    const Slice block = write_parameters(pipeline, call);
    if (!kernel.messages.empty()) begin_messages(pipeline);
    order(kernel, call);
    bind(pipeline, call, block);
    context_.vk.vkCmdDispatchBase(commands_, base[0], base[1], base[2], count[0], count[1], count[2]);
}

// Names the kernel in the buffer of messages, after those of earlier passes and before its own.
void Encoder::begin_messages(const Pipeline& pipeline) {
    const MessagesArguments arguments = {device_.message_chunk().address,
                                         PrintingKernels::mark_of(device_.printing_kernel(pipeline))};
    barrier();
    device_.messages_pass().bind(commands_, &arguments);
    bound_ = VK_NULL_HANDLE;
    context_.vk.vkCmdDispatch(commands_, 1, 1, 1);
    barrier();
    batch_->prints = true;
}

// Dispatches parts of the iteration that are within the device's limits. Each part has a parameter block of its own,
// with its first invocation at Form::base_offset. The parts belong to one pass, so they need no barriers between them.
void Encoder::dispatch_split(const Pipeline& pipeline, const Call& call, const Groups& groups) {
    const auto& limit = context_.properties.max_workgroups;
    std::array<std::uint64_t, 3> base = {};
    const auto part = [&](int axis) {
        return static_cast<std::uint32_t>(std::min<std::uint64_t>(limit[axis], groups.count[axis] - base[axis]));
    };
    for (base[2] = 0; base[2] < groups.count[2]; base[2] += limit[2]) {
        for (base[1] = 0; base[1] < groups.count[1]; base[1] += limit[1]) {
            for (base[0] = 0; base[0] < groups.count[0]; base[0] += limit[0]) {
                const Slice block = write_parameters(pipeline, call);
                std::uint32_t start[3];
                for (int axis = 0; axis < 3; ++axis)
                    start[axis] = static_cast<std::uint32_t>(base[axis] * pipeline.kernel->group[axis]);
                std::memcpy(block.data + pipeline.form->base_offset, start, sizeof start);
                if (!call.patches.empty() || !call.conditions.empty()) {
                    // `prepare` may record a barrier, after which the pass's accesses must be noted again.
                    const std::array<std::uint32_t, 3> covered = covered_by_group(*pipeline.kernel);
                    const Slice command = prepare(
                        pipeline, call, block, {part(0) * covered[0], part(1) * covered[1], part(2) * covered[2], 1});
                    order(*pipeline.kernel, call);
                    bind(pipeline, call, block);
                    context_.vk.vkCmdDispatchIndirect(commands_, command.buffer(), command.offset);
                    continue;
                }
                bind(pipeline, call, block);
                context_.vk.vkCmdDispatch(commands_, part(0), part(1), part(2));
            }
        }
    }
}

}  // namespace glift::detail
