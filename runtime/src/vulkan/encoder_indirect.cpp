// Passes whose sizes, parameters or conditions lie on the device: one small pass prepares several of them.
#include "encoder.h"
#include "vulkan_device.h"

#include <algorithm>
#include <cstring>

namespace glift::detail {

namespace {

// The layouts that prepare_indirect.comp reads.
struct PatchSource {
    VkDeviceAddress value;
    std::uint32_t word, limit, before, joins;
};
struct ConditionSource {
    VkDeviceAddress value;
    std::uint32_t wanted, unused;
};
static_assert(sizeof(PatchSource) == 24 && sizeof(ConditionSource) == 16);

/// The most passes that one dispatch of the shader prepares: one per invocation of its only workgroup.
constexpr std::uint32_t most_prepared = 32;

VkDeviceAddress address_of(const DeviceValue& value) { return vulkan_memory(value.memory).address + value.offset; }

}  // namespace

struct Encoder::PrepareArguments {
    VkDeviceAddress block, command, patches, conditions;
    std::array<std::uint32_t, 4> size;
    std::array<std::uint32_t, 3> per_group;
    std::uint32_t limit_x, rank, size_word, patch_count, condition_count, draws;
    std::uint32_t limit_y = UINT32_MAX;
};

bool Encoder::patches_size(const Pipeline& pipeline, const Call& call) const {
    const std::uint32_t first = pipeline.form->size_offset;
    return std::any_of(call.patches.begin(), call.patches.end(), [&](const Patch& patch) {
        return patch.offset >= first && patch.offset < first + 4 * pipeline.kernel->rank;
    });
}

/// Whether no command has written these values since the last barrier before the last preparing pass: that pass can
/// then read them for one more pass.
bool Encoder::is_prepared_with(std::span<const Patch> patches, std::span<const Condition> conditions) const {
    const auto was_written = [&](const DeviceValue& value) {
        return hazards_.was_written_since(vulkan_memory(value.memory).id, prepared_at_);
    };
    return std::none_of(patches.begin(), patches.end(), [&](const Patch& patch) { return was_written(patch.value); }) &&
           std::none_of(conditions.begin(), conditions.end(),
                        [&](const Condition& condition) { return was_written(condition.value); });
}

/// Records a pass that prepares other passes. The list of the passes that it prepares is empty at first; `prepare` adds
/// them as they are recorded.
void Encoder::open_preparation(std::span<const Patch> patches, std::span<const Condition> conditions) {
    const auto conflicts = [&](const DeviceValue& value) {
        return hazards_.conflicts(vulkan_memory(value.memory).id, Access::read);
    };
    if (std::any_of(patches.begin(), patches.end(), [&](const Patch& patch) { return conflicts(patch.value); }) ||
        std::any_of(conditions.begin(), conditions.end(),
                    [&](const Condition& condition) { return conflicts(condition.value); }))
        barrier();
    prepared_ = batch_->parameters.take((most_prepared + 1) * sizeof(VkDeviceAddress));
    prepared_count_ = 0;
    const VkDeviceAddress address = prepared_.address();
    device_.prepare_pass().bind(commands_, &address);
    bound_ = VK_NULL_HANDLE;
    prepared_at_ = hazards_.ordered_writes();  // later writes may still be going on in the preparing pass
    context_.vk.vkCmdDispatch(commands_, 1, 1, 1);
    barrier_before_indirect();
}

/// Adds a pass to the list of the last preparing pass; a new preparing pass is recorded first where there is none yet,
/// its list is full, or what it would read has been written since. Returns where the preparing pass will write the
/// added pass's indirect command.
Slice Encoder::prepare(PrepareArguments arguments, std::span<const Patch> patches,
                       std::span<const Condition> conditions) {
    if (!prepared_.chunk || prepared_count_ == most_prepared || !is_prepared_with(patches, conditions))
        open_preparation(patches, conditions);
    const Slice command = batch_->parameters.take(sizeof(VkDrawIndirectCommand));  // larger than a dispatch's
    const std::size_t sources = patches.size() * sizeof(PatchSource);
    const Slice list =
        batch_->parameters.take(sizeof arguments + sources + conditions.size() * sizeof(ConditionSource));
    arguments.command = command.address();
    arguments.patches = list.address() + sizeof arguments;
    arguments.conditions = arguments.patches + sources;
    arguments.patch_count = static_cast<std::uint32_t>(patches.size());
    arguments.condition_count = static_cast<std::uint32_t>(conditions.size());
    std::memcpy(list.data, &arguments, sizeof arguments);
    std::byte* next = list.data + sizeof arguments;
    for (const Patch& patch : patches) {
        const PatchSource source = {address_of(patch.value), patch.offset / 4, patch.limit, patch.before, patch.joins};
        std::memcpy(next, &source, sizeof source);
        next += sizeof source;
        hazards_.note(vulkan_memory(patch.value.memory).id, Access::read);
    }
    for (const Condition& condition : conditions) {
        const ConditionSource source = {address_of(condition.value), condition.wanted, 0};
        std::memcpy(next, &source, sizeof source);
        next += sizeof source;
        hazards_.note(vulkan_memory(condition.value.memory).id, Access::read);
    }
    const VkDeviceAddress address = list.address();
    ++prepared_count_;
    std::memcpy(prepared_.data, &prepared_count_, sizeof prepared_count_);
    std::memcpy(prepared_.data + prepared_count_ * sizeof address, &address, sizeof address);
    return command;
}

/// Adds the pass of this call, or a part of that pass, to the list; `size` is the size of the pass or part.
Slice Encoder::prepare(const Pipeline& pipeline, const Call& call, const Slice& block,
                       const std::array<std::uint32_t, 4>& size) {
    const Kernel& kernel = *pipeline.kernel;
    return prepare({.block = block.chunk ? block.address() : 0,
                    .size = size,
                    .per_group = covered_by_group(kernel),
                    .limit_x = limit_along_x(kernel, context_.properties.max_workgroups[0]),
                    .rank = kernel.rank,
                    .size_word = pipeline.form->size_offset / 4,
                    .draws = kernel.drawing != nullptr,
                    .limit_y = kernel.of_blocks ? context_.properties.max_workgroups[1] : UINT32_MAX},
                   call.patches, call.conditions);
}

void Encoder::fill_where(const VulkanMemory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value,
                         std::span<const Condition> conditions) {
    constexpr std::uint64_t words_of_group = 256, most_words = 65535 * words_of_group;
    for (std::uint64_t at = 0; at < bytes / 4; at += most_words) {
        const auto words = static_cast<std::uint32_t>(std::min(most_words, bytes / 4 - at));
        const FillArguments arguments = {memory.address + offset + 4 * at, words, value};
        const Slice command =
            prepare({.size = {words, 1, 1, 1}, .per_group = {words_of_group, 1, 1}, .limit_x = UINT32_MAX, .rank = 1},
                    {}, conditions);
        touch(memory, Access::write);
        device_.fill_pass().bind(commands_, &arguments);
        bound_ = VK_NULL_HANDLE;
        context_.vk.vkCmdDispatchIndirect(commands_, command.buffer(), command.offset);
    }
}

}  // namespace glift::detail
