#include "pass_times.h"

#include <glift/vulkan.h>

#include <map>
#include <stdexcept>
#include <type_traits>

namespace bench {

namespace {

constexpr std::uint32_t most_queries = 8192;  // timestamps of a command buffer

/// The functions that are intercepted.
#define BENCH_INTERCEPTED(X)                                                                                           \
    X(vkBeginCommandBuffer)                                                                                            \
    X(vkQueueSubmit2)                                                                                                  \
    X(vkCmdBindPipeline)                                                                                               \
    X(vkCmdDispatch)                                                                                                   \
    X(vkCmdDispatchIndirect)                                                                                           \
    X(vkCmdEndRendering)                                                                                               \
    X(vkCmdFillBuffer)                                                                                                 \
    X(vkCmdCopyBuffer)                                                                                                 \
    X(vkCmdCopyImage)                                                                                                  \
    X(vkCmdCopyBufferToImage)                                                                                          \
    X(vkCmdCopyImageToBuffer)                                                                                          \
    X(vkCmdClearColorImage)                                                                                            \
    X(vkCmdClearDepthStencilImage)

/// The driver's own functions: those that are intercepted, and others that are called here.
struct Driver {
#define BENCH_DECLARE(name) PFN_##name name = nullptr;
    BENCH_INTERCEPTED(BENCH_DECLARE)
#undef BENCH_DECLARE
    PFN_vkCreateQueryPool vkCreateQueryPool = nullptr;
    PFN_vkDestroyQueryPool vkDestroyQueryPool = nullptr;
    PFN_vkCmdResetQueryPool vkCmdResetQueryPool = nullptr;
    PFN_vkCmdWriteTimestamp2 vkCmdWriteTimestamp2 = nullptr;
    PFN_vkGetQueryPoolResults vkGetQueryPoolResults = nullptr;
};

/// A command buffer's timestamps: query 0 at its begin, query k + 1 after pass k.
struct Timed {
    VkQueryPool pool = VK_NULL_HANDLE;
    std::vector<std::string> passes;
};

PFN_vkGetInstanceProcAddr system_get = nullptr;
PFN_vkGetDeviceProcAddr device_get = nullptr;
VkDevice the_device = VK_NULL_HANDLE;
Driver driver;
std::map<VkPipeline, std::string> names;
std::map<VkCommandBuffer, std::string> bound;  ///< the name of the pipeline that is bound
std::map<VkCommandBuffer, Timed> timed;
std::vector<VkCommandBuffer> submitted;

void note_pass(VkCommandBuffer commands, const std::string& name) {
    Timed& own = timed[commands];
    own.passes.push_back(name);
    if (own.passes.size() < most_queries)
        driver.vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, own.pool,
                                    static_cast<std::uint32_t>(own.passes.size()));
}

VKAPI_ATTR VkResult VKAPI_CALL begin(VkCommandBuffer commands, const VkCommandBufferBeginInfo* info) {
    const VkResult result = driver.vkBeginCommandBuffer(commands, info);
    Timed& own = timed[commands];
    own.passes.clear();
    if (result < 0) return result;
    if (!own.pool) {
        const VkQueryPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                            .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                            .queryCount = most_queries};
        const VkResult made = driver.vkCreateQueryPool(the_device, &pool, nullptr, &own.pool);
        if (made < 0) return made;
    }
    driver.vkCmdResetQueryPool(commands, own.pool, 0, most_queries);
    driver.vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, own.pool, 0);
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL submit(VkQueue queue, std::uint32_t count, const VkSubmitInfo2* infos, VkFence fence) {
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t k = 0; k < infos[i].commandBufferInfoCount; ++k)
            submitted.push_back(infos[i].pCommandBufferInfos[k].commandBuffer);
    return driver.vkQueueSubmit2(queue, count, infos, fence);
}

VKAPI_ATTR void VKAPI_CALL bind(VkCommandBuffer commands, VkPipelineBindPoint point, VkPipeline pipeline) {
    bound[commands] = names[pipeline];
    driver.vkCmdBindPipeline(commands, point, pipeline);
}

/// What is called in place of a command that ends a pass: calls the driver's command, and writes the timestamp.
template <auto Member, class Function = std::remove_reference_t<decltype(driver.*Member)>> struct Ending;
template <auto Member, class... Parameters> struct Ending<Member, void(VKAPI_PTR*)(VkCommandBuffer, Parameters...)> {
    static inline const char* name = nullptr;  ///< of the pass; null: that of the bound pipeline
    static VKAPI_ATTR void VKAPI_CALL call(VkCommandBuffer commands, Parameters... parameters) {
        (driver.*Member)(commands, parameters...);
        note_pass(commands, name ? name : bound[commands]);
    }
};

template <class Function> PFN_vkVoidFunction plain(Function function) {
    return reinterpret_cast<PFN_vkVoidFunction>(function);
}

template <auto Member> PFN_vkVoidFunction ending(const char* name) {
    Ending<Member>::name = name;
    return plain(Ending<Member>::call);
}

/// What is called in place of a function; null if the function is not intercepted.
PFN_vkVoidFunction in_place_of(const std::string& name) {
    if (name == "vkBeginCommandBuffer") return plain(begin);
    if (name == "vkQueueSubmit2") return plain(submit);
    if (name == "vkCmdBindPipeline") return plain(bind);
    if (name == "vkCmdDispatch") return ending<&Driver::vkCmdDispatch>(nullptr);
    if (name == "vkCmdDispatchIndirect") return ending<&Driver::vkCmdDispatchIndirect>(nullptr);
    if (name == "vkCmdEndRendering") return ending<&Driver::vkCmdEndRendering>(nullptr);
    if (name == "vkCmdFillBuffer") return ending<&Driver::vkCmdFillBuffer>("(fill)");
    if (name == "vkCmdCopyBuffer") return ending<&Driver::vkCmdCopyBuffer>("(copy)");
    if (name == "vkCmdCopyImage") return ending<&Driver::vkCmdCopyImage>("(copy)");
    if (name == "vkCmdCopyBufferToImage") return ending<&Driver::vkCmdCopyBufferToImage>("(copy)");
    if (name == "vkCmdCopyImageToBuffer") return ending<&Driver::vkCmdCopyImageToBuffer>("(copy)");
    if (name == "vkCmdClearColorImage") return ending<&Driver::vkCmdClearColorImage>("(clear)");
    if (name == "vkCmdClearDepthStencilImage") return ending<&Driver::vkCmdClearDepthStencilImage>("(clear)");
    return nullptr;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_of_device(VkDevice device, const char* name) {
    const PFN_vkVoidFunction own = in_place_of(name);
    return own ? own : device_get(device, name);
}

/// Glift names each pipeline: after its kernel, or after the pass of the runtime's own that it is for.
VKAPI_ATTR VkResult VKAPI_CALL keep_name(VkDevice, const VkDebugUtilsObjectNameInfoEXT* info) {
    if (info->objectType == VK_OBJECT_TYPE_PIPELINE)
        names[reinterpret_cast<VkPipeline>(info->objectHandle)] = info->pObjectName;
    return VK_SUCCESS;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_of_instance(VkInstance instance, const char* name) {
    if (name == std::string("vkSetDebugUtilsObjectNameEXT")) return plain(keep_name);
    const PFN_vkVoidFunction found = system_get(instance, name);
    if (name != std::string("vkGetDeviceProcAddr")) return found;
    device_get = reinterpret_cast<PFN_vkGetDeviceProcAddr>(found);
    return plain(get_of_device);
}

void load(VkDevice device) {
#define BENCH_LOAD(name) driver.name = reinterpret_cast<PFN_##name>(device_get(device, #name));
    BENCH_INTERCEPTED(BENCH_LOAD)
    BENCH_LOAD(vkCreateQueryPool)
    BENCH_LOAD(vkDestroyQueryPool)
    BENCH_LOAD(vkCmdResetQueryPool)
    BENCH_LOAD(vkCmdWriteTimestamp2)
    BENCH_LOAD(vkGetQueryPoolResults)
#undef BENCH_LOAD
}

void add_passes(const Timed& own, double tick, std::vector<PassTime>& passes) {
    if (own.passes.size() + 1 > most_queries)
        throw std::runtime_error("a command buffer has " + std::to_string(own.passes.size()) + " passes; up to " +
                                 std::to_string(most_queries - 1) + " are timed");
    std::vector<std::uint64_t> ticks(own.passes.size() + 1);
    const VkResult result = driver.vkGetQueryPoolResults(
        the_device, own.pool, 0, static_cast<std::uint32_t>(ticks.size()), ticks.size() * sizeof ticks[0], ticks.data(),
        sizeof ticks[0], VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
    if (result < 0) throw std::runtime_error("timestamps of passes cannot be read");
    for (std::size_t i = 0; i < own.passes.size(); ++i)
        passes.push_back({own.passes[i], static_cast<double>(ticks[i + 1] - ticks[i]) * tick});
}

}  // namespace

PassTimer::PassTimer(const glift::Device& device) {
    glift::vulkan::Objects objects = glift::vulkan::objects(device);
    system_get = objects.get_instance_proc_addr;
    the_device = objects.device;
    device_get = reinterpret_cast<PFN_vkGetDeviceProcAddr>(system_get(objects.instance, "vkGetDeviceProcAddr"));
    load(objects.device);
    objects.get_instance_proc_addr = get_of_instance;
    device_ = glift::vulkan::adopt(objects);
}

PassTimer::~PassTimer() {
    device_.wait();
    device_ = {};
    for (const auto& [commands, own] : timed) driver.vkDestroyQueryPool(the_device, own.pool, nullptr);
    timed.clear();
    submitted.clear();
    bound.clear();
    names.clear();
}

std::vector<PassTime> PassTimer::passes() {
    device_.wait();
    std::vector<PassTime> passes;
    for (const VkCommandBuffer commands : submitted)
        add_passes(timed[commands], device_.properties().timestamp_seconds, passes);
    submitted.clear();
    return passes;
}

}  // namespace bench
