// Glift in a program that has its own Vulkan device: the runtime adopts the program's objects. Also devices that Glift
// opens with extensions that the program asks for, and whether validation reports mistakes.
#include "plain_vulkan.h"

namespace {

using namespace kernels;

void expect_no_messages(const glift::Device& device) {
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
}

TEST(Adopt, TheSameCallsWork) {
    const PlainVulkan mine;
    const auto device = glift::vulkan::adopt(mine.objects());
    const auto f = buffer(device, "f.data", 4000), g = buffer(device, "g.data", 4000);
    device.commands().upload(f, 0, bytes_of(std::vector<float>(1000, 2.0f)));
    run_scale(device, f, g, 1000, 4.0f);
    EXPECT_EQ(read<float>(device, g, 1000)[999], 8.0f);
    EXPECT_EQ(glift::vulkan::objects(device).device, mine.device);
    expect_no_messages(device);
}

TEST(Adopt, ExtensionNamesAreCopied) {
    const PlainVulkan mine;
    auto objects = mine.objects();
    const std::vector<std::string> names(objects.extensions.begin(), objects.extensions.end());
    ASSERT_FALSE(names.empty());
    std::vector<std::string> passed = names;
    std::vector<const char*> pointers;
    for (const std::string& name : passed) pointers.push_back(name.c_str());
    objects.extensions = pointers;
    const auto device = glift::vulkan::adopt(objects);
    for (std::string& name : passed) name.assign(name.size(), '?');
    const auto kept = glift::vulkan::objects(device).extensions;
    EXPECT_EQ(std::vector<std::string>(kept.begin(), kept.end()), names);
}

// The program declares no extensions of its device, so that Glift does not use VK_KHR_push_descriptor: descriptor sets
// come from pools, of which these passes need more than one.
TEST(Adopt, WithoutPushDescriptors) {
    const PlainVulkan mine;
    auto objects = mine.objects();
    objects.extensions = {};
    const auto device = glift::vulkan::adopt(objects);
    EXPECT_FALSE(device.properties().push_descriptors);
    const auto g = buffer(device, "g.data", 256);
    std::uint32_t expected = 0;
    for (std::uint32_t k = 0; k < 2000; ++k) {
        run_add(device, g, 64, k);
        expected = expected * 2 + k;
    }
    EXPECT_EQ(read<std::uint32_t>(device, g, 64)[63], expected);
    expect_no_messages(device);
}

TEST(Adopt, OldAndPoorDevicesAreRefused) {
    const PlainVulkan mine;
    auto objects = mine.objects();
    objects.get_instance_proc_addr = pretending_loader;
    pretence.vulkan_1_2 = true;
    const auto old = error_of([&] { glift::vulkan::adopt(objects); });
    EXPECT_EQ(old.code(), glift::ErrorCode::unsupported_version);
    EXPECT_NE(old.why().find("1.2"), std::string::npos) << old.what();
    EXPECT_FALSE(old.remedy().empty());
    pretence = {.no_features = true};
    const auto poor = error_of([&] { glift::vulkan::adopt(objects); });
    EXPECT_EQ(poor.code(), glift::ErrorCode::missing_feature);
    for (const char* needed : {"scalarBlockLayout", "timelineSemaphore", "bufferDeviceAddress", "hostQueryReset",
                               "synchronization2", "maintenance4", "subgroupSizeControl", "computeFullSubgroups"})
        EXPECT_NE(poor.why().find(needed), std::string::npos) << poor.what();
}

// Functions of Vulkan 1.3 are then missing; without the check, the first call of one would crash.
TEST(Adopt, InstancesForOldVulkanAreRefused) {
    {
        const PlainVulkan mine(VK_API_VERSION_1_2);
        const auto old = error_of([&] { glift::vulkan::adopt(mine.objects()); });
        EXPECT_EQ(old.code(), glift::ErrorCode::unsupported_version) << old.what();
        EXPECT_NE(old.remedy().find("apiVersion"), std::string::npos) << old.what();
    }
    const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                           .apiVersion = VK_API_VERSION_1_0};
    const VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                       .pApplicationInfo = &application};
    VkInstance instance = VK_NULL_HANDLE;
    ASSERT_EQ(vkCreateInstance(&info, nullptr, &instance), VK_SUCCESS);
    std::uint32_t count = 1;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    vkEnumeratePhysicalDevices(instance, &count, &physical);
    const auto older = error_of([&] { glift::vulkan::DeviceFeatures(instance, physical); });
    EXPECT_NE(older.remedy().find("apiVersion"), std::string::npos) << older.what();
    vkDestroyInstance(instance, nullptr);
}

// Without the check, the first call that uses a missing object would crash.
TEST(Adopt, ObjectsThatDoNotFitAreRefused) {
    const PlainVulkan mine;
    const auto refused = [](const glift::vulkan::Objects& objects, const char* why) {
        const auto error = error_of([&] { glift::vulkan::adopt(objects); });
        EXPECT_EQ(error.code(), glift::ErrorCode::wrong_argument) << error.what();
        EXPECT_NE(error.why().find(why), std::string::npos) << error.what();
        EXPECT_FALSE(error.where().empty());
        EXPECT_FALSE(error.remedy().empty());
    };
    auto objects = mine.objects();
    objects.device = VK_NULL_HANDLE;
    refused(objects, "null");
    objects = mine.objects();
    objects.queue_family = 77;
    refused(objects, "queue family 77");
    objects = mine.objects();
    objects.get_instance_proc_addr = pretending_loader;
    pretence = {.no_push_descriptors = true};
    refused(objects, "VK_KHR_push_descriptor");
    objects.extensions = {};
    EXPECT_FALSE(glift::vulkan::adopt(objects).properties().push_descriptors);
}

TEST(Adopt, ALostDeviceIsAnErrorFromThenOn) {
    const PlainVulkan mine;
    auto objects = mine.objects();
    objects.get_instance_proc_addr = pretending_loader;
    {
        const auto device = glift::vulkan::adopt(objects);
        const auto g = buffer(device, "g.data", 256);
        run_store(device, g, 64, 5);
        device.wait();
        run_store(device, g, 64, 6);
        const auto download = device.commands().download(g, 0, 4);
        pretence.lost = true;
        const auto lost = error_of([&] { download.get(); });
        EXPECT_EQ(lost.code(), glift::ErrorCode::device_lost);
        EXPECT_FALSE(lost.remedy().empty());
        pretence.lost = false;
        EXPECT_EQ(error_of([&] { run_store(device, g, 64, 7); }).code(), glift::ErrorCode::device_lost);
        EXPECT_EQ(error_of([&] { device.wait(); }).code(), glift::ErrorCode::device_lost);
        EXPECT_EQ(error_of([&] { buffer(device, "h", 4); }).code(), glift::ErrorCode::device_lost);
        EXPECT_EQ(error_of([&] { download.get(); }).code(), glift::ErrorCode::device_lost);
        vkDeviceWaitIdle(mine.device);
    }
}

TEST(Adopt, NoMemoryNamesTheMemory) {
    const PlainVulkan mine;
    auto objects = mine.objects();
    objects.get_instance_proc_addr = pretending_loader;
    const auto device = glift::vulkan::adopt(objects);
    pretence.no_memory = true;
    const auto error = error_of([&] { buffer(device, "huge.data", 512 << 20); });
    EXPECT_EQ(error.code(), glift::ErrorCode::out_of_memory);
    EXPECT_NE(error.where().find("huge.data"), std::string::npos) << error.what();
    pretence.no_memory = false;
    buffer(device, "huge.data", 512 << 20);
}

TEST(Adopt, TheHostDeviceHasNoVulkanObjects) {
    const auto device = glift::Device::open("host");
    EXPECT_EQ(error_of([&] { glift::vulkan::objects(device); }).code(), glift::ErrorCode::wrong_argument);
    EXPECT_EQ(error_of([&] { glift::vulkan::buffer(buffer(device, "f", 4)); }).code(),
              glift::ErrorCode::wrong_argument);
}

// Opens a device with extensions that windows need: surfaces on the instance, swapchains on the device.
TEST(Open, WithExtensionsOfTheUsers) {
    const char *const surface[] = {VK_KHR_SURFACE_EXTENSION_NAME}, *const swapchain[] = {
                                                                       VK_KHR_SWAPCHAIN_EXTENSION_NAME};
    const auto device = glift::vulkan::open({surface, swapchain}, vulkan_name());
    const auto objects = glift::vulkan::objects(device);
    const std::vector<std::string> names(objects.extensions.begin(), objects.extensions.end());
    EXPECT_EQ(std::count(names.begin(), names.end(), VK_KHR_SWAPCHAIN_EXTENSION_NAME), 1);
    EXPECT_NE(vkGetDeviceProcAddr(objects.device, "vkCreateSwapchainKHR"), nullptr);
    const auto g = buffer(device, "g.data", 256);
    run_store(device, g, 64, 5);
    EXPECT_EQ(read<std::uint32_t>(device, g, 64)[63], 5u);
    expect_no_messages(device);
}

TEST(Open, ExtensionsThatAreNotThereAreNamed) {
    const char* const none[] = {"VK_GLIFT_none"};
    for (const glift::vulkan::Extensions& extensions :
         {glift::vulkan::Extensions{.instance = none}, glift::vulkan::Extensions{.device = none}}) {
        const auto error = error_of([&] { glift::vulkan::open(extensions, vulkan_name()); });
        EXPECT_EQ(error.code(), glift::ErrorCode::missing_feature) << error.what();
        EXPECT_NE(error.why().find("VK_GLIFT_none"), std::string::npos) << error.what();
        EXPECT_FALSE(error.remedy().empty());
    }
    EXPECT_EQ(error_of([] { glift::vulkan::open({}, "host"); }).code(), glift::ErrorCode::wrong_argument);
}

// Checks that the validation layer is on and that its messages arrive, which the other tests rely on.
TEST(Validation, ReportsAMistake) {
    if (!std::getenv("GLIFT_VALIDATE")) GTEST_SKIP() << "GLIFT_VALIDATE is not set";
    const auto device = glift::Device::open(vulkan_name());
    const VkBufferCreateInfo empty = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                      .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT};
    VkBuffer buffer = VK_NULL_HANDLE;
    const VkDevice handle = glift::vulkan::objects(device).device;
    if (vkCreateBuffer(handle, &empty, nullptr, &buffer) == VK_SUCCESS) vkDestroyBuffer(handle, buffer, nullptr);
    EXPECT_FALSE(device.validation_messages().empty());
    EXPECT_TRUE(device.validation_messages().empty());  // cleared
}

/// Submits fills of a buffer to the queue, as a program does that uses the queue beside Glift; without barriers.
class Filling {
public:
    Filling(const glift::vulkan::Objects& objects, VkBuffer buffer) : objects_(objects), buffer_(buffer) {
        const VkCommandPoolCreateInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                              .queueFamilyIndex = objects_.queue_family};
        vkCreateCommandPool(objects_.device, &info, nullptr, &pool_);
    }
    ~Filling() {
        vkQueueWaitIdle(objects_.queue);
        vkDestroyCommandPool(objects_.device, pool_, nullptr);
    }
    void submit(std::uint32_t value) const {
        VkCommandBuffer commands = VK_NULL_HANDLE;
        const VkCommandBufferAllocateInfo info = {
            .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, .commandPool = pool_, .commandBufferCount = 1};
        vkAllocateCommandBuffers(objects_.device, &info, &commands);
        const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
        vkBeginCommandBuffer(commands, &begin);
        vkCmdFillBuffer(commands, buffer_, 0, 256, value);
        vkEndCommandBuffer(commands);
        const VkSubmitInfo submit = {
            .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
        vkQueueSubmit(objects_.queue, 1, &submit, VK_NULL_HANDLE);
    }

private:
    glift::vulkan::Objects objects_;
    VkBuffer buffer_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
};

// Synchronization validation also works between submissions: the program fills a buffer in two of them without a
// barrier.
TEST(Validation, ReportsAMissingBarrierBetweenSubmissions) {
    if (!std::getenv("GLIFT_VALIDATE")) GTEST_SKIP() << "GLIFT_VALIDATE is not set";
    const auto device = glift::Device::open(vulkan_name());
    const auto g = buffer(device, "g.data", 256);
    device.wait();
    {
        const Filling filling(glift::vulkan::objects(device), glift::vulkan::buffer(g).buffer);
        for (const std::uint32_t value : {1u, 1u}) filling.submit(value);
    }
    EXPECT_FALSE(device.validation_messages().empty());
}

// glift::vulkan::objects gives the queue to the program: what the program then submits is ordered with what Glift
// submits, whether glift::Device::open or glift::vulkan::open made the device.
TEST(Open, WhatTheProgramSubmitsIsOrdered) {
    if (!std::getenv("GLIFT_VALIDATE")) GTEST_SKIP() << "GLIFT_VALIDATE is not set";
    for (const bool is_plain : {false, true}) {
        for (const bool is_pending : {false, true}) {
            const auto device = is_plain ? glift::Device::open(vulkan_name()) : glift::vulkan::open({}, vulkan_name());
            const auto g = buffer(device, "g.data", 256), h = buffer(device, "h.data", 256);
            device.wait();
            if (is_pending) run_store(device, h, 64, 5);  // recorded, not submitted, when the queue is asked for
            const Filling filling(glift::vulkan::objects(device), glift::vulkan::buffer(g).buffer);
            filling.submit(7);
            run_add(device, g, 64, 1);
            EXPECT_EQ(read<std::uint32_t>(device, g, 64)[63], 15u);
            filling.submit(8);
            run_add(device, g, 64, 2);
            EXPECT_EQ(read<std::uint32_t>(device, g, 64)[63], 18u);
            expect_no_messages(device);
        }
    }
}

}  // namespace
