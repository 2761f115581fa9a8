#include "swapchain.h"

#include <glift/error.h>

#include <algorithm>
#include <string>

namespace window {

namespace {

constexpr VkImageUsageFlags usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;

[[noreturn]] void throw_cannot_show(const std::string& why) {
    throw glift::Error(glift::ErrorCode::missing_feature, "the device cannot show pictures in this window",
                       "window::Window", why, "choose another device, with GLIFT_DEVICE=lavapipe for example");
}

template <class Value, class Query> std::vector<Value> listed(const char* call, Query query) {
    std::uint32_t count = 0;
    check(query(&count, nullptr), call);
    std::vector<Value> values(count);
    check(query(&count, values.data()), call);
    values.resize(count);
    return values;
}

/// Whether the surface takes a format's stored values, eight bits a channel, as sRGB without conversion: the picture
/// that is copied there is sRGB already.
bool is_fit(const VkSurfaceFormatKHR& format) {
    return (format.format == VK_FORMAT_B8G8R8A8_UNORM || format.format == VK_FORMAT_R8G8B8A8_UNORM) &&
           format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
}

}  // namespace

void check(VkResult result, const char* call) {
    if (result >= 0) return;
    const bool is_lost = result == VK_ERROR_SURFACE_LOST_KHR || result == VK_ERROR_DEVICE_LOST;
    throw glift::Error(is_lost ? glift::ErrorCode::device_lost : glift::ErrorCode::vulkan,
                       is_lost ? "the display or the device is gone" : "a Vulkan call of the window failed", call,
                       "VkResult " + std::to_string(result),
                       is_lost ? "start the program again, on a display that stays"
                               : "run with GLIFT_VALIDATE=1 to see what was wrong with it");
}

Swapchain::Swapchain(const glift::vulkan::Objects& objects, VkSurfaceKHR surface)
    : objects_(objects), surface_(surface) {
    VkBool32 can_show = VK_FALSE;
    check(vkGetPhysicalDeviceSurfaceSupportKHR(objects.physical, objects.queue_family, surface, &can_show),
          "vkGetPhysicalDeviceSurfaceSupportKHR");
    if (!can_show) throw_cannot_show("its queue has no way to the display");
    choose_format();
    make_pass();
}

Swapchain::~Swapchain() {
    destroy_images();
    vkDestroySwapchainKHR(objects_.device, chain_, nullptr);
    vkDestroyRenderPass(objects_.device, pass_, nullptr);
}

void Swapchain::choose_format() {
    const auto formats = listed<VkSurfaceFormatKHR>(
        "vkGetPhysicalDeviceSurfaceFormatsKHR", [&](std::uint32_t* count, VkSurfaceFormatKHR* values) {
            return vkGetPhysicalDeviceSurfaceFormatsKHR(objects_.physical, surface_, count, values);
        });
    const auto found = std::find_if(formats.begin(), formats.end(), is_fit);
    if (found == formats.end()) throw_cannot_show("it has no format of eight bits a channel there");
    format_ = *found;
}

/// Makes the render pass of the panel. It keeps the image's contents, the picture that was copied there before.
void Swapchain::make_pass() {
    const VkAttachmentDescription colour = {.format = format_.format,
                                            .samples = VK_SAMPLE_COUNT_1_BIT,
                                            .loadOp = VK_ATTACHMENT_LOAD_OP_LOAD,
                                            .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                                            .stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                                            .stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE,
                                            .initialLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                            .finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR};
    const VkAttachmentReference target = {0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    const VkSubpassDescription subpass = {
        .pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS, .colorAttachmentCount = 1, .pColorAttachments = &target};
    const VkRenderPassCreateInfo info = {.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
                                         .attachmentCount = 1,
                                         .pAttachments = &colour,
                                         .subpassCount = 1,
                                         .pSubpasses = &subpass};
    check(vkCreateRenderPass(objects_.device, &info, nullptr, &pass_), "vkCreateRenderPass");
}

void Swapchain::resize(glift::uint2 size) {
    check(vkDeviceWaitIdle(objects_.device), "vkDeviceWaitIdle");
    VkSurfaceCapabilitiesKHR limits;
    check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(objects_.physical, surface_, &limits),
          "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
    if ((limits.supportedUsageFlags & usage) != usage) throw_cannot_show("nothing can be copied to its images");
    VkExtent2D extent = limits.currentExtent;
    if (extent.width == UINT32_MAX) {  // by Vulkan's rules: the window adapts to the size of the images
        extent.width = std::clamp(size.x, limits.minImageExtent.width, limits.maxImageExtent.width);
        extent.height = std::clamp(size.y, limits.minImageExtent.height, limits.maxImageExtent.height);
    }
    destroy_images();
    size_ = {extent.width, extent.height};
    const VkSwapchainKHR before = std::exchange(chain_, VK_NULL_HANDLE);
    const std::uint32_t most = limits.maxImageCount ? limits.maxImageCount : UINT32_MAX;
    const VkSwapchainCreateInfoKHR info = {.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR,
                                           .surface = surface_,
                                           .minImageCount = std::min(limits.minImageCount + 1, most),
                                           .imageFormat = format_.format,
                                           .imageColorSpace = format_.colorSpace,
                                           .imageExtent = extent,
                                           .imageArrayLayers = 1,
                                           .imageUsage = usage,
                                           .imageSharingMode = VK_SHARING_MODE_EXCLUSIVE,
                                           .preTransform = limits.currentTransform,
                                           .compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR,
                                           .presentMode = VK_PRESENT_MODE_FIFO_KHR,
                                           .clipped = VK_TRUE,
                                           .oldSwapchain = before};
    const VkResult made =
        extent.width && extent.height ? vkCreateSwapchainKHR(objects_.device, &info, nullptr, &chain_) : VK_SUCCESS;
    vkDestroySwapchainKHR(objects_.device, before, nullptr);
    check(made, "vkCreateSwapchainKHR");
    if (!chain_) return;  // no images: nothing of the window is visible
    for (const VkImage image : listed<VkImage>("vkGetSwapchainImagesKHR", [&](std::uint32_t*count, VkImage*values) {
             return vkGetSwapchainImagesKHR(objects_.device, chain_, count, values);
         }))
        make_image(image);
}

void Swapchain::make_image(VkImage image) {
    Image& made = images_.emplace_back();
    made.image = image;
    const VkImageViewCreateInfo view = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                        .image = image,
                                        .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                        .format = format_.format,
                                        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    check(vkCreateImageView(objects_.device, &view, nullptr, &made.view), "vkCreateImageView");
    const VkFramebufferCreateInfo frame = {.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                           .renderPass = pass_,
                                           .attachmentCount = 1,
                                           .pAttachments = &made.view,
                                           .width = size_.x,
                                           .height = size_.y,
                                           .layers = 1};
    check(vkCreateFramebuffer(objects_.device, &frame, nullptr, &made.frame), "vkCreateFramebuffer");
    const VkSemaphoreCreateInfo semaphore = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    check(vkCreateSemaphore(objects_.device, &semaphore, nullptr, &made.drawn), "vkCreateSemaphore");
}

void Swapchain::destroy_images() {
    for (const Image& image : images_) {
        vkDestroyFramebuffer(objects_.device, image.frame, nullptr);
        vkDestroyImageView(objects_.device, image.view, nullptr);
        vkDestroySemaphore(objects_.device, image.drawn, nullptr);
    }
    images_.clear();
}

std::optional<std::uint32_t> Swapchain::acquire(VkSemaphore is_free) const {
    if (!chain_) return std::nullopt;
    std::uint32_t image = 0;
    const VkResult result = vkAcquireNextImageKHR(objects_.device, chain_, UINT64_MAX, is_free, VK_NULL_HANDLE, &image);
    if (result == VK_ERROR_OUT_OF_DATE_KHR) return std::nullopt;
    check(result, "vkAcquireNextImageKHR");
    return image;
}

bool Swapchain::present(std::uint32_t image) const {
    const VkPresentInfoKHR info = {.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR,
                                   .waitSemaphoreCount = 1,
                                   .pWaitSemaphores = &images_[image].drawn,
                                   .swapchainCount = 1,
                                   .pSwapchains = &chain_,
                                   .pImageIndices = &image};
    const VkResult result = vkQueuePresentKHR(objects_.queue, &info);
    if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) return false;
    check(result, "vkQueuePresentKHR");
    return true;
}

}  // namespace window
