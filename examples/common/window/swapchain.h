// The swapchain: the images that the window system shows in turn, and the render pass in which ImGui draws into them.
#pragma once

#include <glift/vector.h>
#include <glift/vulkan.h>

#include <optional>
#include <vector>

namespace window {

/// Throws glift::Error, which names the call, if `result` says that it failed.
void check(VkResult result, const char* call);

class Swapchain {
public:
    struct Image {
        VkImage image = VK_NULL_HANDLE;
        VkImageView view = VK_NULL_HANDLE;
        VkFramebuffer frame = VK_NULL_HANDLE;
        VkSemaphore drawn = VK_NULL_HANDLE;  ///< signalled when the commands that draw the image are done
    };

    /// Makes no images yet: `resize` does. Throws glift::Error (missing_feature) if the device's queue cannot present
    /// to the surface, or the surface has no UNORM format of eight bits a channel.
    Swapchain(const glift::vulkan::Objects& objects, VkSurfaceKHR surface);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    /// Makes the images, or makes them again for a window of another size. Waits until the device is idle.
    void resize(glift::uint2 size);
    glift::uint2 size() const { return size_; }
    VkRenderPass pass() const { return pass_; }
    const std::vector<Image>& images() const { return images_; }

    /// The index of the next image, which may be drawn into once `is_free` is signalled; none if there are no images
    /// because nothing of the window is visible, or if they must be recreated by `resize`.
    std::optional<std::uint32_t> acquire(VkSemaphore is_free) const;
    /// Presents an image once it is drawn; false if the images must be recreated.
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
