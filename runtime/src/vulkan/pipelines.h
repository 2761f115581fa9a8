// Compiled passes: one pipeline for each kernel, form and set of fixed parameters.
#pragma once

#include "../report.h"
#include "context.h"
#include "vulkan/spirv/kernel_digest.h"

#include <glift/pass.h>

#include <memory>
#include <vector>

namespace glift::detail {

/// A pipeline with its layouts. Descriptor infos are in one array in this order: the parameter buffer if there is one,
/// each memory that has a descriptor, the status record if the kernel reports.
struct Pipeline {
    std::uint64_t digest = 0;
    /// Kernel and form are those of the call in progress: the library that the kernel was in may be unloaded later.
    const Kernel* kernel = nullptr;
    const Form* form = nullptr;
    FormName name = FormName::direct;
    std::vector<FixedWord> fixed;
    bool starts_anywhere = false;  ///< for vkCmdDispatchBase
    VkPipeline handle = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    VkDescriptorUpdateTemplate update = VK_NULL_HANDLE;
    std::uint32_t uniform_buffers = 0, storage_buffers = 0, storage_images = 0, sampled_images = 0;
    std::uint32_t status_slot = 0;
    bool push = false;  ///< push descriptors, else sets from a pool

    VkShaderStageFlags stages() const {
        return kernel->drawing ? VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT
                               : VkShaderStageFlags(VK_SHADER_STAGE_COMPUTE_BIT);
    }
    VkPipelineBindPoint bind_point() const {
        return kernel->drawing ? VK_PIPELINE_BIND_POINT_GRAPHICS : VK_PIPELINE_BIND_POINT_COMPUTE;
    }
    std::uint32_t descriptor_count() const {
        return uniform_buffers + storage_buffers + storage_images + sampled_images;
    }
};

union DescriptorInfo {
    VkDescriptorBufferInfo buffer;
    VkDescriptorImageInfo image;
};

class DiskCache;

/// Not thread-safe: the device's lock is held around it.
class Pipelines {
public:
    explicit Pipelines(Context& context);
    ~Pipelines();

    /// Throws missing_form, missing_feature, loop_limit, too_large.
    Pipeline& get(const Kernel& kernel, FormName form, std::span<const FixedWord> fixed, bool starts_anywhere = false) {
        const std::uint64_t digest = digest_of(kernel);
        const Entry& entry = table_[hash(digest, form) & (table_.size() - 1)];
        const bool known = fixed.empty() && !starts_anywhere && entry.pipeline && entry.digest == digest &&
                           entry.form == form && entry.plain;
        Pipeline& pipeline = known ? *entry.pipeline : find(digest, kernel, form, fixed, starts_anywhere);
        pipeline.kernel = &kernel;
        pipeline.form = &form_of(kernel, form);
        return pipeline;
    }

    VkSampler sampler(Sampler sampler);

    /// Kernels that report, by status slot.
    const std::vector<Reporter>& reporting() const { return reporting_; }
    std::uint64_t created() const { return created_; }

private:
    struct Entry {
        std::uint64_t digest = 0;
        Pipeline* pipeline = nullptr;  ///< null: there is none
        FormName form = FormName::direct;
        bool plain = true;  ///< no parameter is fixed, and it does not start anywhere
    };

    static std::size_t hash(std::uint64_t digest, FormName form) {
        return ((digest + static_cast<std::uint64_t>(form)) * 0x9E3779B97F4A7C15u) >> 20;
    }

    Pipeline& find(std::uint64_t digest, const Kernel& kernel, FormName form, std::span<const FixedWord> fixed,
                   bool starts_anywhere);
    std::unique_ptr<Pipeline> make(std::uint64_t digest, const Kernel& kernel, FormName form,
                                   std::span<const FixedWord> fixed, bool starts_anywhere);
    void make_layout(Pipeline& pipeline);
    VkPipeline make_handle(const Pipeline& pipeline);
    VkPipeline make_compute_pipeline(const Pipeline& pipeline);
    void destroy(Pipeline& pipeline);
    void insert(Pipeline* pipeline);
    std::uint32_t status_slot(std::uint64_t digest, const Kernel& kernel);

    Context& context_;
    std::unique_ptr<DiskCache> disk_;
    std::vector<Entry> table_;
    std::vector<std::unique_ptr<Pipeline>> all_;
    std::vector<Reporter> reporting_;
    std::vector<std::uint64_t> reporting_digests_;
    std::array<VkSampler, 40> samplers_ = {};
    std::uint64_t created_ = 0;
};

/// The most kernels with a status record that one device keeps, and the bytes from one record to the next.
inline constexpr std::uint32_t status_slots = 1024;
inline constexpr VkDeviceSize status_stride = 256;

}  // namespace glift::detail
