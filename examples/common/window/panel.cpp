#include "panel.h"

#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_vulkan.h>
#include <imgui/imgui.h>

#include <algorithm>

namespace window {

namespace {

void check_result(VkResult result) { check(result, "a Vulkan call of Dear ImGui"); }

/// Uploads ImGui's font texture to the device.
void upload_letters(const glift::vulkan::Objects& objects) {
    VkCommandPool pool = VK_NULL_HANDLE;
    const VkCommandPoolCreateInfo pool_info = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                               .queueFamilyIndex = objects.queue_family};
    check(vkCreateCommandPool(objects.device, &pool_info, nullptr, &pool), "vkCreateCommandPool");
    VkCommandBuffer commands = VK_NULL_HANDLE;
    const VkCommandBufferAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                              .commandPool = pool,
                                              .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                              .commandBufferCount = 1};
    check(vkAllocateCommandBuffers(objects.device, &info, &commands), "vkAllocateCommandBuffers");
    const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                            .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    ImGui_ImplVulkan_CreateFontsTexture(commands);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    const VkSubmitInfo submit = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
    check(vkQueueSubmit(objects.queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(objects.queue), "vkQueueWaitIdle");
    ImGui_ImplVulkan_DestroyFontUploadObjects();
    vkDestroyCommandPool(objects.device, pool, nullptr);
}

}  // namespace

Panel::Panel(const Display& display, const glift::vulkan::Objects& objects, const Swapchain& swapchain)
    : device_(objects.device) {
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 8}};
    const VkDescriptorPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                             .flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT,
                                             .maxSets = 8,
                                             .poolSizeCount = 1,
                                             .pPoolSizes = sizes};
    check(vkCreateDescriptorPool(device_, &pool, nullptr, &pool_), "vkCreateDescriptorPool");
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // writes no settings file to the current folder
    ImGui_ImplGlfw_InitForVulkan(display.handle(), true);
    const auto images = static_cast<std::uint32_t>(swapchain.images().size());
    ImGui_ImplVulkan_InitInfo info = {};
    info.Instance = objects.instance;
    info.PhysicalDevice = objects.physical;
    info.Device = objects.device;
    info.QueueFamily = objects.queue_family;
    info.Queue = objects.queue;
    info.DescriptorPool = pool_;
    info.MinImageCount = 2;
    info.ImageCount = std::max(images, 2u);
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info.CheckVkResultFn = check_result;
    ImGui_ImplVulkan_Init(&info, swapchain.pass());
    upload_letters(objects);
}

Panel::~Panel() {
    ImGui_ImplVulkan_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    vkDestroyDescriptorPool(device_, pool_, nullptr);
}

void Panel::begin() {
    if (is_begun_) ImGui::EndFrame();
    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    is_begun_ = true;
}

void Panel::filter(Events& events) {
    const ImGuiIO& io = ImGui::GetIO();
    std::vector<PointerEvent> kept;
    for (PointerEvent event : events.pointer) {
        const unsigned bit = 1u << static_cast<unsigned>(event.button);
        const bool was_held = (held_ & bit) != 0;
        if (event.kind == PointerEvent::Kind::press) {
            if (io.WantCaptureMouse) continue;
            held_ |= bit;
        } else if (event.kind == PointerEvent::Kind::release) {
            if (!was_held) continue;
            held_ &= ~bit;
        } else if (io.WantCaptureMouse && held_ == 0) {
            continue;
        }
        event.is_down = held_ != 0;
        kept.push_back(event);
    }
    events.pointer = std::move(kept);
    if (io.WantCaptureKeyboard) events.keys.clear();
    if (io.WantCaptureMouse) events.wheel = 0;
}

void Panel::draw(VkCommandBuffer commands) {
    if (!is_begun_) return;
    is_begun_ = false;
    ImGui::Render();
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
}

}  // namespace window
