// The images that the window system shows in turn, and the render pass that ImGui draws into them with.
#pragma once

#include <glift/vector.h>
#include <glift/vulkan.h>

#include <optional>
#include <vector>

namespace window {

/// Throws glift::Error, which names the call, where a Vulkan call failed.
void check(VkResult result, const char* call);

class Swapchain {
public:
    struct Image {
        VkImage image = VK_NULL_HANDLE;
        VkImageView view = VK_NULL_HANDLE;
        VkFramebuffer frame = VK_NULL_HANDLE;
        VkSemaphore drawn = VK_NULL_HANDLE;  ///< signalled by the commands that make it
    };

    /// Throws glift::Error (missing_feature) where the device's queue cannot show pictures on the surface.
    Swapchain(const glift::vulkan::Objects& objects, VkSurfaceKHR surface);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    /// Makes the images anew, for a window of another size. The device waits.
    void resize(glift::uint2 size);
    glift::uint2 size() const { return size_; }
    VkRenderPass pass() const { return pass_; }
    const std::vector<Image>& images() const { return images_; }

    /// The number of an image to draw into once `is_free` is signalled; none where the images have to be made anew.
    std::optional<std::uint32_t> acquire(VkSemaphore is_free) const;
    /// Shows it once it is drawn; false where the images have to be made anew.
    bool present(std::uint32_t image) const;

private:
    void choose_format();
    void make_pass();
    void make_image(VkImage image);
    void destroy_images();

    glift::vulkan::Objects objects_;
    VkSurfaceKHR surface_;
    VkSurfaceFormatKHR format_{};
    VkRenderPass pass_ = VK_NULL_HANDLE;
    VkSwapchainKHR chain_ = VK_NULL_HANDLE;
    std::vector<Image> images_;
    glift::uint2 size_{0, 0};
};

}  // namespace window
