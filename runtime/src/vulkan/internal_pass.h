// A compute shader of the runtime itself. It has no descriptors: push constants hold its values, and the addresses of
// what else it reads and writes.
#pragma once

#include "context.h"

#include <cstdint>
#include <span>

namespace glift::detail {

/// The push constants of fill_words.comp.
struct FillArguments {
    VkDeviceAddress to;
    std::uint32_t words, value;
};

/// The push constants of begin_messages.comp.
struct MessagesArguments {
    VkDeviceAddress messages;
    std::uint32_t mark;
};

class InternalPass {
public:
    /// `spirv` must outlive it. The pipeline is made when it is first bound.
    InternalPass(Context& context, const char* name, std::span<const std::uint32_t> spirv, std::uint32_t push_bytes);
    ~InternalPass();
    InternalPass(const InternalPass&) = delete;

    void bind(VkCommandBuffer commands, const void* push);

private:
    void create();

    Context& context_;
    const char* name_;
    std::span<const std::uint32_t> spirv_;
    std::uint32_t push_bytes_;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

}  // namespace glift::detail
