#include "window.h"

#include "panel.h"

#include <glift/error.h>

#include <algorithm>
#include <array>
#include <optional>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace window {

namespace {

/// The objects that a frame uses until the device is done with it.
struct Frame {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkSemaphore image_is_free = VK_NULL_HANDLE;
    VkFence is_done = VK_NULL_HANDLE;
    glift::Memory picture;
};

/// Two frames in flight: one is recorded while the device draws the other.
class Frames {
public:
    explicit Frames(const glift::vulkan::Objects& objects) : device_(objects.device) {
        const VkCommandPoolCreateInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                              .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                              .queueFamilyIndex = objects.queue_family};
        check(vkCreateCommandPool(device_, &info, nullptr, &pool_), "vkCreateCommandPool");
        for (Frame& frame : frames_) make(frame);
    }
    ~Frames() {
        vkDeviceWaitIdle(device_);
        for (const Frame& frame : frames_) {
            vkDestroySemaphore(device_, frame.image_is_free, nullptr);
            vkDestroyFence(device_, frame.is_done, nullptr);
        }
        vkDestroyCommandPool(device_, pool_, nullptr);
    }
    Frames(const Frames&) = delete;

    /// The next frame, after waiting until the device is done with its last use.
    Frame& free_one() {
        Frame& frame = frames_[next_];
        check(vkWaitForFences(device_, 1, &frame.is_done, VK_TRUE, UINT64_MAX), "vkWaitForFences");
        return frame;
    }
    void advance() { next_ = (next_ + 1) % frames_.size(); }

private:
    void make(Frame& frame) const {
        const VkCommandBufferAllocateInfo commands = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                      .commandPool = pool_,
                                                      .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                      .commandBufferCount = 1};
        check(vkAllocateCommandBuffers(device_, &commands, &frame.commands), "vkAllocateCommandBuffers");
        const VkSemaphoreCreateInfo semaphore = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
        check(vkCreateSemaphore(device_, &semaphore, nullptr, &frame.image_is_free), "vkCreateSemaphore");
        const VkFenceCreateInfo fence = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO,
                                         .flags = VK_FENCE_CREATE_SIGNALED_BIT};
        check(vkCreateFence(device_, &fence, nullptr, &frame.is_done), "vkCreateFence");
    }

    VkDevice device_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    std::array<Frame, 2> frames_;
    std::size_t next_ = 0;
};

/// A rectangle of the window in pixels; `right` and `bottom` are exclusive.
struct Box {
    std::int32_t left, top, right, bottom;
};

/// Where a picture is shown in the window: as large as it fits, in the middle.
Box place_of(glift::uint2 picture, glift::uint2 window) {
    if (picture == window) return {0, 0, static_cast<std::int32_t>(window.x), static_cast<std::int32_t>(window.y)};
    const double scale = std::min(static_cast<double>(window.x) / picture.x, static_cast<double>(window.y) / picture.y);
    const auto width = std::max(1, static_cast<std::int32_t>(picture.x * scale)),
               height = std::max(1, static_cast<std::int32_t>(picture.y * scale));
    const std::int32_t left = (static_cast<std::int32_t>(window.x) - width) / 2,
                       top = (static_cast<std::int32_t>(window.y) - height) / 2;
    return {left, top, left + width, top + height};
}

void order(VkCommandBuffer commands, const VkImageMemoryBarrier2& barrier) {
    const VkDependencyInfo info = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier};
    vkCmdPipelineBarrier2(commands, &info);
}

VkImageMemoryBarrier2 between(VkImage image, VkPipelineStageFlags2 from, VkAccessFlags2 written,
                              VkPipelineStageFlags2 to, VkAccessFlags2 used, VkImageLayout before,
                              VkImageLayout after) {
    return {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
            .srcStageMask = from,
            .srcAccessMask = written,
            .dstStageMask = to,
            .dstAccessMask = used,
            .oldLayout = before,
            .newLayout = after,
            .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
            .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
            .image = image,
            .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
}

glift::Device opened(const Display& display) {
    const std::vector<const char*> instance = display.extensions();
    const char* const device[] = {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
    return glift::vulkan::open({instance, device});
}

/// A Vulkan surface, which the destructor destroys.
struct Surface {
    VkInstance instance;
    VkSurfaceKHR handle = VK_NULL_HANDLE;

    Surface(VkInstance instance, GLFWwindow* window) : instance(instance) {
        check(glfwCreateWindowSurface(instance, window, nullptr, &handle), "glfwCreateWindowSurface");
    }
    ~Surface() { vkDestroySurfaceKHR(instance, handle, nullptr); }
    Surface(const Surface&) = delete;
};

}  // namespace

struct Window::Parts {
    Display display;
    glift::Device device;
    glift::vulkan::Objects objects;
    Surface surface;
    Swapchain swapchain;
    std::optional<Panel> panel;
    Frames frames;  ///< the last of the members that use the device: its destructor, which runs first, waits for it
    Events events;
    glift::uint2 picture_size{1, 1};
    bool is_current = false;  ///< the swapchain need not be recreated
    unsigned unsettled = 3;   ///< frames still to draw without new events: ImGui reacts a frame or two later

    Parts(const std::string& title, glift::uint2 size)
        : display(title, size), device(opened(display)), objects(glift::vulkan::objects(device)),
          surface(objects.instance, display.handle()), swapchain(objects, surface.handle), frames(objects) {
        swapchain.resize(display.size());
        panel.emplace(display, objects, swapchain);
    }
    bool begin();
    void to_picture(Events& happened) const;
    void show(const glift::Memory& picture);
    void record(const Frame& frame, const Swapchain::Image& image);
    void copy(VkCommandBuffer commands, const glift::Memory& picture, VkImage to) const;
};

/// Converts pointer positions from pixels of the window to pixels of the picture.
void Window::Parts::to_picture(Events& happened) const {
    const Box place = place_of(picture_size, display.size());
    const glift::float2 size(static_cast<float>(place.right - place.left),
                             static_cast<float>(place.bottom - place.top));
    for (PointerEvent& event : happened.pointer) {
        event.place.x = (event.place.x - static_cast<float>(place.left)) * static_cast<float>(picture_size.x) / size.x;
        event.place.y = (event.place.y - static_cast<float>(place.top)) * static_cast<float>(picture_size.y) / size.y;
    }
}

bool Window::Parts::begin() {
    const std::vector<std::string> said = device.validation_messages();
    if (!said.empty())
        throw glift::Error(glift::ErrorCode::vulkan, "the validation layer found a mistake", "window::Window",
                           said.front(), "this is a defect of the program or of Glift");
    panel->begin();
    events = display.take_events();
    const bool is_quiet = events.pointer.empty() && events.keys.empty() && events.wheel == 0;
    unsettled = !is_quiet ? 3 : unsettled - (unsettled > 0);
    panel->filter(events);
    to_picture(events);
    return !display.is_to_close();
}

void Window::Parts::show(const glift::Memory& picture) {
    if (!picture || picture.description().kind != glift::MemoryKind::image2d ||
        picture.description().format != glift::Format::rgba8)
        throw glift::Error(glift::ErrorCode::wrong_argument, "a window shows images of format rgba8",
                           "window::Window::show", {}, "make one of the picture with shown.glift");
    device.commands().flush();  // submits Glift's commands before those that copy the picture
    picture_size = {picture.extent()[0], picture.extent()[1]};
    if (display.is_minimised()) return;
    if (!is_current || !(swapchain.size() == display.size())) swapchain.resize(display.size());
    is_current = true;
    Frame& frame = frames.free_one();
    const auto number = swapchain.acquire(frame.image_is_free);
    is_current = number.has_value();
    if (!number) return;  // the next frame recreates the swapchain
    const Swapchain::Image& image = swapchain.images()[*number];
    check(vkResetFences(objects.device, 1, &frame.is_done), "vkResetFences");
    frame.picture = picture;
    record(frame, image);
    const VkPipelineStageFlags writes = VK_PIPELINE_STAGE_TRANSFER_BIT;
    const VkSubmitInfo info = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO,
                               .waitSemaphoreCount = 1,
                               .pWaitSemaphores = &frame.image_is_free,
                               .pWaitDstStageMask = &writes,
                               .commandBufferCount = 1,
                               .pCommandBuffers = &frame.commands,
                               .signalSemaphoreCount = 1,
                               .pSignalSemaphores = &image.drawn};
    check(vkQueueSubmit(objects.queue, 1, &info, frame.is_done), "vkQueueSubmit");
    is_current = swapchain.present(*number);
    frames.advance();
}

void Window::Parts::record(const Frame& frame, const Swapchain::Image& image) {
    const VkCommandBufferBeginInfo begin_info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                                 .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    check(vkBeginCommandBuffer(frame.commands, &begin_info), "vkBeginCommandBuffer");
    copy(frame.commands, frame.picture, image.image);
    const VkRenderPassBeginInfo pass = {.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                        .renderPass = swapchain.pass(),
                                        .framebuffer = image.frame,
                                        .renderArea = {{0, 0}, {swapchain.size().x, swapchain.size().y}}};
    vkCmdBeginRenderPass(frame.commands, &pass, VK_SUBPASS_CONTENTS_INLINE);
    panel->draw(frame.commands);
    vkCmdEndRenderPass(frame.commands);
    check(vkEndCommandBuffer(frame.commands), "vkEndCommandBuffer");
}

/// Copies the picture to a swapchain image. Glift itself orders its later commands after this.
void Window::Parts::copy(VkCommandBuffer commands, const glift::Memory& picture, VkImage to) const {
    constexpr VkPipelineStageFlags2 transfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    const glift::vulkan::ImageHandle from = glift::vulkan::image(picture);
    order(commands, between(from.image, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT, transfer,
                            VK_ACCESS_2_TRANSFER_READ_BIT, from.layout, from.layout));
    // The transfer stage waits for the semaphore that says that the image is free.
    order(commands, between(to, transfer, VK_ACCESS_2_NONE, transfer, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                            VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL));
    const Box place = place_of(picture_size, swapchain.size());
    if (!(picture_size == swapchain.size())) {
        const VkClearColorValue black = {{0, 0, 0, 1}};
        const VkImageSubresourceRange all = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdClearColorImage(commands, to, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &black, 1, &all);
        order(commands, between(to, transfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, transfer, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL));
    }
    const VkImageSubresourceLayers layer = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    const VkImageBlit box = {
        layer,
        {{0, 0, 0}, {static_cast<std::int32_t>(picture_size.x), static_cast<std::int32_t>(picture_size.y), 1}},
        layer,
        {{place.left, place.top, 0}, {place.right, place.bottom, 1}}};
    const bool is_as_large = picture_size == swapchain.size();
    vkCmdBlitImage(commands, from.image, from.layout, to, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &box,
                   is_as_large ? VK_FILTER_NEAREST : VK_FILTER_LINEAR);
    order(commands,
          between(to, transfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                  VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                  VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL));
}

Window::Window(const std::string& title, glift::uint2 size) : parts_(std::make_unique<Parts>(title, size)) {}
Window::~Window() = default;

const glift::Device& Window::device() const { return parts_->device; }

bool Window::next() {
    parts_->display.poll();
    return parts_->begin();
}

bool Window::next_event() {
    if (parts_->unsettled > 0) parts_->display.poll();
    else parts_->display.wait(0.1);
    return parts_->begin();
}

void Window::close() { parts_->display.close(); }
const Events& Window::events() const { return parts_->events; }
glift::uint2 Window::size() const { return parts_->display.size(); }
bool Window::is_minimised() const { return parts_->display.is_minimised(); }
void Window::show(const glift::Memory& picture) { parts_->show(picture); }

}  // namespace window
