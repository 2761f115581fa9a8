// Fault injection: of the Vulkan calls that the work below makes, those of the functions listed in plain_vulkan.cpp are
// made to fail one by one, with each of three errors. The result must be an Error or the right data, never a crash or
// wrong data.
#include "plain_vulkan.h"

namespace {

using namespace kernels;

/// Uses buffers, images, passes, timestamps and a recording, but no draws.
void use_everything(const glift::vulkan::Objects& objects) {
    const auto device = glift::vulkan::adopt(objects);
    constexpr std::uint32_t n = 256;
    const auto f = buffer(device, "f.data", 4 * n), g = buffer(device, "g.data", 4 * n);
    const auto image = device.allocate(
        {.name = "i", .kind = glift::MemoryKind::image2d, .format = glift::Format::r32f, .extent = {4, 4, 1}});
    device.commands().upload(f, 0, bytes_of(std::vector<float>(n, 2.0f)));
    const auto begin = device.commands().timestamp();
    run_scale(device, f, g, n, 4.0f);
    EXPECT_GE(device.commands().timestamp() - begin, 0.0);
    EXPECT_EQ(read<float>(device, g, n)[n - 1], 8.0f);
    const glift::ImageRegion region = {.extent = {4, 4, 1}};
    device.commands().upload_image(image, {&region, 1}, bytes_of(std::vector<float>(16, 3.0f)));
    EXPECT_EQ(values_of<float>(device.commands().download_image(image, {&region, 1}, 64).get())[15], 3.0f);
    const auto recording = device.record([&](const glift::Commands& commands) {
        const auto temporary = commands.allocate({.name = "t", .bytes = 4 * n});
        run_store(commands, temporary, n, 5);
        commands.copy(temporary, 0, g, 0, 4 * n);
    });
    recording.submit();
    recording.submit();
    EXPECT_EQ(read<std::uint32_t>(device, g, n)[n - 1], 5u);
    device.wait();
}

/// Fails the test for each object that was not destroyed before the device, as the validation layer reports it: the
/// layer is on where GLIFT_VALIDATE is set.
VKAPI_ATTR VkBool32 VKAPI_CALL on_leak(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
    if (std::string(data->pMessage).find("has not been destroyed") != std::string::npos)
        ADD_FAILURE() << data->pMessage;
    return VK_FALSE;
}

class LeakWatch {
public:
    explicit LeakWatch(VkInstance instance) : instance_(instance) {
        const VkDebugUtilsMessengerCreateInfoEXT info = {
            .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
            .messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
            .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
            .pfnUserCallback = on_leak};
        const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance, "vkCreateDebugUtilsMessengerEXT"));
        EXPECT_EQ(create(instance, &info, nullptr, &messenger_), VK_SUCCESS);
    }
    ~LeakWatch() {
        reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"))(instance_, messenger_, nullptr);
    }

private:
    VkInstance instance_;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

/// Runs the work again and again: the first call of a listed function fails in the first run, the second in the
/// second, and so on, until a run makes fewer calls or the test has failed. Returns the number of runs before the last.
std::uint64_t fail_each(const PlainVulkan& mine, const glift::vulkan::Objects& objects, VkResult failure) {
    for (std::uint64_t call = 1;; ++call) {
        pretence.calls = 0;
        pretence.failing_call = call;
        pretence.failure = failure;
        pretence.failed = "";
        try {
            use_everything(objects);
        } catch (const glift::Error& error) {
            EXPECT_FALSE(error.remedy().empty()) << pretence.failed << ": " << error.what();
        }
        vkDeviceWaitIdle(mine.device);
        if (testing::Test::HasFailure()) ADD_FAILURE() << "call " << call << ", " << pretence.failed;
        if (testing::Test::HasFailure() || !*pretence.failed) return call - 1;
    }
}

void fail_everywhere(VkResult failure) {
    PlainVulkan mine;
    const LeakWatch watch(mine.instance);
    auto objects = mine.objects();
    objects.get_instance_proc_addr = pretending_loader;
    EXPECT_GT(fail_each(mine, objects, failure), 50u);
    objects.extensions = {};  // without push descriptors, descriptor sets come from pools
    EXPECT_GT(fail_each(mine, objects, failure), 50u);
    mine.destroy_device();
}

TEST(Failures, OfMemoryOfTheHost) { fail_everywhere(VK_ERROR_OUT_OF_HOST_MEMORY); }
TEST(Failures, OfMemoryOfTheDevice) { fail_everywhere(VK_ERROR_OUT_OF_DEVICE_MEMORY); }
TEST(Failures, ThatLoseTheDevice) { fail_everywhere(VK_ERROR_DEVICE_LOST); }

}  // namespace
