// Compiled passes: one pipeline for each kernel, form and set of fixed parameters.
#pragma once

#include "context.h"

#include <glift/pass.h>

#include <memory>
#include <vector>

namespace glift::detail {

enum class CompiledForm : std::uint8_t { direct, general, wide };

/// Pipelines as a pass needs them. Descriptor infos stand in one array in this order: the parameter buffer if there is
/// one, each memory that has a descriptor, the status record if the kernel reports.
struct Pipeline {
    const Kernel* kernel = nullptr;
    const Form* form = nullptr;
    CompiledForm name = CompiledForm::direct;
    std::vector<FixedWord> fixed;
    VkPipeline handle = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    VkDescriptorUpdateTemplate update = VK_NULL_HANDLE;
    std::uint32_t storage_buffers = 0, storage_images = 0, sampled_images = 0;
    std::uint32_t status_slot = 0;
    bool push = false;  ///< push descriptors, else sets from a pool

    std::uint32_t descriptor_count() const { return storage_buffers + storage_images + sampled_images; }
};

union DescriptorInfo {
    VkDescriptorBufferInfo buffer;
    VkDescriptorImageInfo image;
};

class DiskCache;

/// Not safe for several threads: the device's lock is held around it.
class Pipelines {
public:
    explicit Pipelines(Context& context);
    ~Pipelines();

    /// Throws missing_form, loop_limit, too_large.
    Pipeline& get(const Kernel& kernel, CompiledForm form, std::span<const FixedWord> fixed) {
        if (fixed.empty()) {
            const Entry& entry = table_[hash(&kernel, form) & (table_.size() - 1)];
            if (entry.kernel == &kernel && entry.form == form && entry.plain) return *entry.pipeline;
        }
        return find(kernel, form, fixed);
    }

    VkSampler sampler(Sampler sampler);

    /// Kernels that report, by status slot.
    const std::vector<const Kernel*>& reporting() const { return reporting_; }
    std::uint64_t created() const { return created_; }

private:
    struct Entry {
        const Kernel* kernel = nullptr;
        Pipeline* pipeline = nullptr;
        CompiledForm form = CompiledForm::direct;
        bool plain = true;  ///< nothing is fixed
    };

    static std::size_t hash(const Kernel* kernel, CompiledForm form) {
        const auto bits = reinterpret_cast<std::uintptr_t>(kernel) + static_cast<std::uintptr_t>(form) * 0x9E3779B9u;
        return (bits * 0x9E3779B97F4A7C15u) >> 20;
    }

    Pipeline& find(const Kernel& kernel, CompiledForm form, std::span<const FixedWord> fixed);
    std::unique_ptr<Pipeline> make(const Kernel& kernel, CompiledForm form, std::span<const FixedWord> fixed);
    void make_layout(Pipeline& pipeline);
    VkPipeline make_handle(const Pipeline& pipeline);
    void destroy(Pipeline& pipeline);
    void insert(Pipeline* pipeline);

    Context& context_;
    std::unique_ptr<DiskCache> disk_;
    std::vector<Entry> table_;
    std::vector<std::unique_ptr<Pipeline>> all_;
    std::vector<const Kernel*> reporting_;
    std::array<VkSampler, 8> samplers_ = {};
    std::uint64_t created_ = 0;
};

/// Most kernels with a status record that one device keeps.
inline constexpr std::uint32_t status_slots = 1024;
inline constexpr VkDeviceSize status_stride = 256;

}  // namespace glift::detail
