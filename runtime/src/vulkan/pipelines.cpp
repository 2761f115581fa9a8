#include "pipelines.h"

#include "../report.h"
#include "../text.h"
#include "descriptor_limits.h"
#include "disk_cache.h"
#include "graphics_pipeline.h"
#include "shader_stage.h"
#include "vulkan/spirv/requirements.h"
#include "vulkan/spirv/spirv_words.h"

#include <glift/error.h>

#include <algorithm>

namespace glift::detail {

namespace {

void check_limits(const Context& context, const Kernel& kernel, const Form& form) {
    const DeviceProperties& p = context.properties;
    const auto refuse = [&](const std::string& what, const std::string& why, const std::string& remedy) {
        throw Error(ErrorCode::too_large, what, kernel_text(kernel), p.name + " " + why, remedy);
    };
    if (kernel.loop_rounds != UINT64_MAX && kernel.loop_rounds > p.loop_round_limit) {
        const SourceLine& loop = kernel.longest_loop;
        const std::string where = loop.line ? std::string(loop.file) + ":" + std::to_string(loop.line) + ", " : "";
        throw Error(ErrorCode::loop_limit, "the kernel's loops run longer than this device allows",
                    where + kernel_text(kernel),
                    "up to " + std::to_string(kernel.loop_rounds) + " iterations an invocation, over all its loops; " +
                        p.name + " leaves its loops after " + std::to_string(p.loop_round_limit),
                    loop_remedy);
    }
    const auto& g = kernel.group;
    if (std::uint64_t(g[0]) * g[1] * g[2] > p.max_workgroup_invocations || g[0] > p.max_workgroup_size[0] ||
        g[1] > p.max_workgroup_size[1] || g[2] > p.max_workgroup_size[2]) {
        refuse("the kernel's workgroup is larger than the device allows",
               "allows " + std::to_string(p.max_workgroup_invocations) + " invocations",
               "give the kernel a smaller group");
    }
    if (form.push_constants && form.parameter_bytes > p.max_push_constant_bytes) {
        refuse("the kernel's parameters do not fit in push constants",
               "has " + std::to_string(p.max_push_constant_bytes) + " bytes",
               "compile the kernel with this version of gliftc: it takes no more than every device has");
    }
}

/// A size of subgroups that is required bounds the workgroup, too.
void check_subgroups(const Context& context, const Kernel& kernel, const Form& form) {
    const SubgroupSizes& sizes = context.subgroups;
    if (kernel.drawing || !sizes.vary() || !uses_subgroups(words_of(form.spirv))) return;
    const auto refuse = [&](ErrorCode code, const char* what, const std::string& why, const char* remedy) {
        throw Error(code, what, kernel_text(kernel), context.properties.name + " " + why, remedy);
    };
    if (!sizes.can_require) {
        refuse(ErrorCode::missing_feature, "the device lacks what the kernel uses",
               "has subgroups of " + std::to_string(sizes.least) + " to " + std::to_string(sizes.greatest) +
                   " lanes, of which a kernel can require none",
               "run it on another device (GLIFT_DEVICE=host has subgroups), or ask DeviceProperties before the call");
    }
    const std::uint64_t invocations = std::uint64_t(kernel.group[0]) * kernel.group[1] * kernel.group[2];
    if (invocations > std::uint64_t(sizes.size) * sizes.most_in_workgroup) {
        refuse(ErrorCode::too_large, "the kernel's workgroup is larger than the device allows",
               "allows " + std::to_string(sizes.most_in_workgroup) + " subgroups of " + std::to_string(sizes.size) +
                   " lanes",
               "give the kernel a smaller group");
    }
}

void check_requirements(const Context& context, const Kernel& kernel, const Form& form) {
    if (kernel.drawing && !context.can_draw) {
        throw Error(ErrorCode::missing_feature, "the device's queue cannot draw", kernel_text(kernel),
                    context.properties.name + " runs kernels on a queue of a family without graphics",
                    "adopt a queue of a family with VK_QUEUE_GRAPHICS_BIT, or run it on another device "
                    "(GLIFT_DEVICE=host)");
    }
    std::string missing = lacking(words_of(form.spirv), context.properties);
    if (missing.empty() && !form.fragment.empty()) missing = lacking(words_of(form.fragment), context.properties);
    if (missing.empty() && kernel.drawing && kernel.drawing->derives_loads && !context.properties.helpers_load) {
        throw Error(ErrorCode::missing_feature, "the device cannot derive what is loaded from buffers",
                    kernel_text(kernel),
                    context.properties.name + " loads zeros from buffers in the pixels beside a triangle, whose values "
                                              "dFdx, dFdy and fwidth compare with",
                    "derive what the vertex part hands on, or keep the elements in an image; or run it on another "
                    "device (GLIFT_DEVICE=host)");
    }
    if (missing.empty()) return;
    throw Error(ErrorCode::missing_feature, "the device lacks what the kernel uses", kernel_text(kernel),
                context.properties.name + " does not have: " + missing,
                "run it on another device (GLIFT_DEVICE=host has all of it), or ask DeviceProperties before the call");
}

VkFilter vulkan_filter(Filter filter) { return filter == Filter::linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST; }

VkCompareOp vulkan_compare(Compare compare) {
    switch (compare) {
    case Compare::none: return VK_COMPARE_OP_NEVER;
    case Compare::less: return VK_COMPARE_OP_LESS;
    case Compare::less_equal: return VK_COMPARE_OP_LESS_OR_EQUAL;
    case Compare::greater: return VK_COMPARE_OP_GREATER;
    case Compare::greater_equal: return VK_COMPARE_OP_GREATER_OR_EQUAL;
    }
    return VK_COMPARE_OP_NEVER;
}

VkSamplerAddressMode vulkan_address_mode(AddressMode mode) {
    switch (mode) {
    case AddressMode::clamp_to_edge: return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    case AddressMode::repeat: return VK_SAMPLER_ADDRESS_MODE_REPEAT;
    case AddressMode::mirrored_repeat: return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    case AddressMode::clamp_to_border: return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER;
    }
    return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
}

}  // namespace

Pipelines::Pipelines(Context& context) : context_(context), disk_(std::make_unique<DiskCache>(context)), table_(256) {}

Pipelines::~Pipelines() {
    if (created_ && !context_.lost) disk_->save();
    for (auto& pipeline : all_) destroy(*pipeline);
    for (VkSampler sampler : samplers_) context_.vk.vkDestroySampler(context_.device, sampler, nullptr);
}

void Pipelines::destroy(Pipeline& pipeline) {
    context_.vk.vkDestroyPipeline(context_.device, pipeline.handle, nullptr);
    if (pipeline.update) context_.vk.vkDestroyDescriptorUpdateTemplate(context_.device, pipeline.update, nullptr);
    context_.vk.vkDestroyPipelineLayout(context_.device, pipeline.layout, nullptr);
    context_.vk.vkDestroyDescriptorSetLayout(context_.device, pipeline.set_layout, nullptr);
}

Pipeline& Pipelines::find(std::uint64_t digest, const Kernel& kernel, FormName form, std::span<const FixedWord> fixed,
                          bool starts_anywhere) {
    const bool plain = fixed.empty() && !starts_anywhere;
    for (std::size_t at = hash(digest, form);; ++at) {
        const Entry& entry = table_[at & (table_.size() - 1)];
        if (!entry.pipeline) break;
        if (entry.digest == digest && entry.form == form && entry.plain == plain &&
            entry.pipeline->starts_anywhere == starts_anywhere && std::ranges::equal(fixed, entry.pipeline->fixed)) {
            return *entry.pipeline;
        }
    }
    std::unique_ptr<Pipeline> made = make(digest, kernel, form, fixed, starts_anywhere);
    all_.push_back(std::move(made));
    if (all_.size() * 2 > table_.size()) {
        table_.assign(table_.size() * 2, {});
        for (auto& pipeline : all_) insert(pipeline.get());
    } else {
        insert(all_.back().get());
    }
    return *all_.back();
}

void Pipelines::insert(Pipeline* pipeline) {
    std::size_t at = hash(pipeline->digest, pipeline->name);
    while (table_[at & (table_.size() - 1)].pipeline) ++at;
    table_[at & (table_.size() - 1)] = {pipeline->digest, pipeline, pipeline->name,
                                        pipeline->fixed.empty() && !pipeline->starts_anywhere};
}

std::uint32_t Pipelines::status_slot(std::uint64_t digest, const Kernel& kernel) {
    const auto known = std::find(reporting_digests_.begin(), reporting_digests_.end(), digest);
    const auto slot = static_cast<std::uint32_t>(known - reporting_digests_.begin());
    if (known != reporting_digests_.end()) return slot;
    if (reporting_.size() == status_slots) {
        throw Error(ErrorCode::too_large, "too many kernels report to one device", kernel_text(kernel),
                    "it keeps " + std::to_string(status_slots) + " reports", "open the device anew");
    }
    reporting_.emplace_back(kernel);
    reporting_digests_.push_back(digest);
    return slot;
}

std::unique_ptr<Pipeline> Pipelines::make(std::uint64_t digest, const Kernel& kernel, FormName form,
                                          std::span<const FixedWord> fixed, bool starts_anywhere) {
    const Form& compiled = form_of(kernel, form);
    if (compiled.spirv.empty()) throw_missing_form(kernel, form_text(form), context_.properties.name.c_str());
    check_limits(context_, kernel, compiled);
    check_subgroups(context_, kernel, compiled);
    check_requirements(context_, kernel, compiled);
    DescriptorCounts counts = count_descriptors(kernel, compiled);
    if (form == FormName::general) counts.buffers = 0;
    check_descriptors(context_, kernel, counts);
    auto pipeline = std::make_unique<Pipeline>();
    pipeline->digest = digest;
    pipeline->kernel = &kernel;
    pipeline->form = &compiled;
    pipeline->name = form;
    pipeline->fixed.assign(fixed.begin(), fixed.end());
    pipeline->starts_anywhere = starts_anywhere;
    if (kernel.reports) pipeline->status_slot = status_slot(digest, kernel);
    try {
        make_layout(*pipeline);
        pipeline->handle = make_handle(*pipeline);
    } catch (...) {
        destroy(*pipeline);
        throw;
    }
    return pipeline;
}

// long: the function fills all the structures that Vulkan wants, which point to each other
void Pipelines::make_layout(Pipeline& pipeline) {
    const Kernel& kernel = *pipeline.kernel;
    const Form& form = *pipeline.form;
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    std::vector<VkDescriptorUpdateTemplateEntry> entries;
    const auto add = [&](std::size_t binding, VkDescriptorType type, std::uint32_t& count) {
        const auto number = static_cast<std::uint32_t>(binding);
        bindings.push_back({number, type, 1, pipeline.stages(), nullptr});
        entries.push_back({number, 0, 1, type, entries.size() * sizeof(DescriptorInfo), sizeof(DescriptorInfo)});
        ++count;
    };
    if (!form.push_constants && form.parameter_bytes) {
        if (form.uniform_buffer) add(0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, pipeline.uniform_buffers);
        else add(0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, pipeline.storage_buffers);
    }
    for (std::size_t k = 0; k < kernel.bindings.size(); ++k) {
        const Binding& binding = kernel.bindings[k];
        if (binding.kind == MemoryKind::buffer) {
            if (pipeline.name != FormName::general) {
                add(k + 1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, pipeline.storage_buffers);
            }
        } else if (binding.sampled) {
            add(k + 1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, pipeline.sampled_images);
        } else {
            add(k + 1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, pipeline.storage_images);
        }
    }
    if (kernel.reports) {
        add(kernel.bindings.size() + 1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, pipeline.storage_buffers);
    }
    if (!kernel.messages.empty()) {
        add(kernel.bindings.size() + 2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, pipeline.storage_buffers);
    }
    pipeline.push = context_.properties.push_descriptors && bindings.size() <= context_.max_push_descriptors;

    const VkDescriptorSetLayoutCreateInfo set_info = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .flags = pipeline.push
                     ? VkDescriptorSetLayoutCreateFlags(VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR)
                     : 0,
        .bindingCount = static_cast<std::uint32_t>(bindings.size()),
        .pBindings = bindings.data()};
    context_.check(context_.vk.vkCreateDescriptorSetLayout(context_.device, &set_info, nullptr, &pipeline.set_layout),
                   "vkCreateDescriptorSetLayout");
    const VkPushConstantRange range = {pipeline.stages(), 0, (form.parameter_bytes + 3) / 4 * 4};
    const VkPipelineLayoutCreateInfo layout_info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                                    .setLayoutCount = 1,
                                                    .pSetLayouts = &pipeline.set_layout,
                                                    .pushConstantRangeCount =
                                                        form.push_constants && form.parameter_bytes ? 1u : 0u,
                                                    .pPushConstantRanges = &range};
    context_.check(context_.vk.vkCreatePipelineLayout(context_.device, &layout_info, nullptr, &pipeline.layout),
                   "vkCreatePipelineLayout");
    if (entries.empty()) return;
    const VkDescriptorUpdateTemplateCreateInfo update_info = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_UPDATE_TEMPLATE_CREATE_INFO,
        .descriptorUpdateEntryCount = static_cast<std::uint32_t>(entries.size()),
        .pDescriptorUpdateEntries = entries.data(),
        .templateType = pipeline.push ? VK_DESCRIPTOR_UPDATE_TEMPLATE_TYPE_PUSH_DESCRIPTORS_KHR
                                      : VK_DESCRIPTOR_UPDATE_TEMPLATE_TYPE_DESCRIPTOR_SET,
        .descriptorSetLayout = pipeline.set_layout,
        .pipelineBindPoint = pipeline.bind_point(),
        .pipelineLayout = pipeline.layout,
        .set = 0};
    context_.check(
        context_.vk.vkCreateDescriptorUpdateTemplate(context_.device, &update_info, nullptr, &pipeline.update),
        "vkCreateDescriptorUpdateTemplate");
}

VkPipeline Pipelines::make_handle(const Pipeline& pipeline) {
    const VkPipeline handle = pipeline.kernel->drawing ? make_graphics_pipeline(context_, pipeline, disk_->handle())
                                                       : make_compute_pipeline(pipeline);
    context_.set_name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(handle), pipeline.kernel->name);
    ++created_;
    return handle;
}

VkPipeline Pipelines::make_compute_pipeline(const Pipeline& pipeline) {
    const ShaderStage stage(context_, pipeline, pipeline.form->spirv, VK_SHADER_STAGE_COMPUTE_BIT);
    const VkComputePipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .flags = pipeline.starts_anywhere ? VkPipelineCreateFlags(VK_PIPELINE_CREATE_DISPATCH_BASE_BIT) : 0,
        .stage = stage.info(),
        .layout = pipeline.layout};
    VkPipeline handle = VK_NULL_HANDLE;
    context_.check(context_.vk.vkCreateComputePipelines(context_.device, disk_->handle(), 1, &info, nullptr, &handle),
                   ("vkCreateComputePipelines for " + kernel_text(*pipeline.kernel)).c_str());
    return handle;
}

VkSampler Pipelines::sampler(Sampler sampler) {
    const bool compares = sampler.compare != Compare::none;
    VkSampler& handle =
        samplers_[(static_cast<std::size_t>(sampler.compare) * 2 + static_cast<std::size_t>(sampler.filter)) * 4 +
                  static_cast<std::size_t>(sampler.address)];
    if (handle) return handle;
    const VkSamplerAddressMode mode = vulkan_address_mode(sampler.address);
    const VkSamplerCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                      .magFilter = vulkan_filter(sampler.filter),
                                      .minFilter = vulkan_filter(sampler.filter),
                                      .mipmapMode = sampler.filter == Filter::linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR
                                                                                     : VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                      .addressModeU = mode,
                                      .addressModeV = mode,
                                      .addressModeW = mode,
                                      .compareEnable = compares,
                                      .compareOp = vulkan_compare(sampler.compare),
                                      .maxLod = compares ? 0.0f : VK_LOD_CLAMP_NONE,
                                      .borderColor = VK_BORDER_COLOR_FLOAT_TRANSPARENT_BLACK};
    context_.check(context_.vk.vkCreateSampler(context_.device, &info, nullptr, &handle), "vkCreateSampler");
    return handle;
}

}  // namespace glift::detail
