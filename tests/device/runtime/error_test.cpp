// Errors of the runtime: each says what failed, where, and what to do.
#include "test_device.h"

#include <filesystem>
#include <fstream>

namespace {

using namespace kernels;
using glift::ErrorCode;

/// Sets an environment variable until the object is destroyed.
class Environment {
public:
    Environment(const char* name, const char* value) : name_(name) {
        const char* old = std::getenv(name);
        had_ = old != nullptr;
        if (old) old_ = old;
        setenv(name, value, 1);
    }
    ~Environment() { had_ ? setenv(name_, old_.c_str(), 1) : unsetenv(name_); }

private:
    const char* name_;
    bool had_;
    std::string old_;
};

void expect_complete(const glift::Error& error, ErrorCode code) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_FALSE(error.problem().empty());
    EXPECT_FALSE(error.where().empty()) << error.what();
    EXPECT_FALSE(error.remedy().empty()) << error.what();
    EXPECT_NE(std::string(error.what()).find(error.remedy()), std::string::npos);
}

TEST(OpenErrors, NoLoader) {
    const Environment loader("GLIFT_VULKAN_LOADER", "libno_such_vulkan.so.1");
    expect_complete(error_of([] { glift::Device::open("lavapipe"); }), ErrorCode::no_loader);
    EXPECT_TRUE(glift::Device::open("host").is_host());
}

TEST(OpenErrors, ALoaderThatIsNone) {
    const Environment loader("GLIFT_VULKAN_LOADER", "libm.so.6");
    const auto error = error_of([] { glift::Device::open("lavapipe"); });
    expect_complete(error, ErrorCode::no_loader);
    EXPECT_NE(error.remedy().find("GLIFT_VULKAN_LOADER"), std::string::npos) << error.what();
}

TEST(OpenErrors, NoDriver) {
    const Environment files("VK_DRIVER_FILES", "/nowhere/none.json");
    const Environment old_name("VK_ICD_FILENAMES", "/nowhere/none.json");
    const auto error = error_of([] { glift::Device::open(vulkan_name()); });
    expect_complete(error, ErrorCode::no_device);
    EXPECT_NE(error.remedy().find("mesa-vulkan-drivers"), std::string::npos);
}

TEST(OpenErrors, NoSuchDevice) {
    const auto error = error_of([] { glift::Device::open("Voodoo 2"); });
    expect_complete(error, ErrorCode::no_device);
    EXPECT_NE(error.problem().find("Voodoo 2"), std::string::npos);
    const Environment wanted("GLIFT_DEVICE", "Banshee");
    EXPECT_EQ(error_of([] { glift::Device::open(); }).code(), ErrorCode::no_device);
}

TEST(OpenErrors, NoDeviceWithThisIndex) {
    EXPECT_TRUE(glift::Device::open(vulkan_name() + ":0"));
    const auto error = error_of([] { glift::Device::open(vulkan_name() + ":9"); });
    expect_complete(error, ErrorCode::no_device);
    EXPECT_NE(error.problem().find(":9"), std::string::npos) << error.what();
    EXPECT_EQ(error_of([] { glift::Device::open(vulkan_name() + ":"); }).code(), ErrorCode::no_device);
    EXPECT_EQ(error_of([] { glift::Device::open(vulkan_name() + ":1x"); }).code(), ErrorCode::no_device);
}

TEST(OpenErrors, NoGpu) {
    const char* lavapipe = "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json";
    if (!std::filesystem::exists(lavapipe)) GTEST_SKIP() << "needs lavapipe as the only driver";
    const Environment files("VK_DRIVER_FILES", lavapipe), old_name("VK_ICD_FILENAMES", lavapipe);
    const Environment wanted("GLIFT_DEVICE", "gpu");
    const auto error = error_of([] { glift::Device::open(); });
    expect_complete(error, ErrorCode::no_device);
    EXPECT_NE(error.where().find("GLIFT_DEVICE"), std::string::npos) << error.what();
    EXPECT_NE(error.problem().find("gpu"), std::string::npos) << error.what();
    EXPECT_NE(error.why().find("llvmpipe"), std::string::npos) << error.what();
    EXPECT_NE(error.remedy().find("GLIFT_DEVICE=host"), std::string::npos) << error.what();
}

TEST(OpenErrors, NoValidationLayer) {
    const Environment path("VK_LAYER_PATH", "/nowhere");
    const Environment wanted("GLIFT_VALIDATE", "1");
    const auto error = error_of([] { glift::Device::open(vulkan_name()); });
    expect_complete(error, ErrorCode::missing_layer);
    EXPECT_NE(error.remedy().find("vulkan-validationlayers"), std::string::npos);
}

TEST(Open, TheEnvironmentChooses) {
    const Environment wanted("GLIFT_DEVICE", "host");
    EXPECT_TRUE(glift::Device::open().is_host());
    EXPECT_FALSE(glift::Device::open(vulkan_name()).is_host());
}

TEST(Open, ACpuThatNobodyAskedForIsToldOnce) {
    const char* lavapipe = "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json";
    if (!std::filesystem::exists(lavapipe)) GTEST_SKIP() << "needs lavapipe as the only driver";
    const Environment files("VK_DRIVER_FILES", lavapipe), old_name("VK_ICD_FILENAMES", lavapipe);
    std::vector<std::string> told;
    glift::Log before = glift::set_log([&](std::string_view message) { told.emplace_back(message); });
    {
        const Environment named("GLIFT_DEVICE", "lavapipe");
        glift::Device::open();
    }
    glift::Device::open("lavapipe");
    EXPECT_TRUE(told.empty()) << told[0];
    const Environment none("GLIFT_DEVICE", "");
    glift::Device::open();
    glift::Device::open();
    glift::set_log(std::move(before));
    ASSERT_EQ(told.size(), 1u);
    EXPECT_NE(told[0].find("llvmpipe"), std::string::npos) << told[0];
    EXPECT_NE(told[0].find("GLIFT_DEVICE=host"), std::string::npos) << told[0];
}

TEST(Open, VariablesOfTheEnvironmentAreReadWhole) {
    const auto used_up = [](const char* limit, std::uint64_t bytes) {
        const Environment set("GLIFT_MEMORY_LIMIT", limit);
        const auto device = glift::Device::open("host");
        const auto fits = buffer(device, "fits", bytes);
        return error_of([&] { buffer(device, "more", 1); }).code() == glift::ErrorCode::out_of_memory;
    };
    EXPECT_TRUE(used_up("1000", 1000));
    EXPECT_TRUE(used_up("64K", 64 << 10));
    EXPECT_TRUE(used_up("2M", 2 << 20));
    EXPECT_TRUE(used_up("2MiB", 2 << 20));
    for (const char* wrong : {"2X", "-1", "two", "1.5G", "2 G", "99999999999T", "18446744073709551616", "G"}) {
        const Environment set("GLIFT_MEMORY_LIMIT", wrong);
        const auto error = error_of([] { buffer(glift::Device::open("host"), "f", 4); });
        expect_complete(error, ErrorCode::wrong_argument);
        EXPECT_NE(error.where().find(wrong), std::string::npos) << error.what();
        EXPECT_EQ(error_of([] { glift::Device::open(vulkan_name()); }).code(), ErrorCode::wrong_argument) << wrong;
    }
    const Environment validate("GLIFT_VALIDATE", "yes");
    expect_complete(error_of([] { glift::Device::open(vulkan_name()); }), ErrorCode::wrong_argument);
}

TEST(Open, PropertiesAreThoseOfTheDevice) {
    const auto host = glift::Device::open("host");
    EXPECT_EQ(host.properties().loop_round_limit, glift::unlimited);
    const auto device = glift::Device::open(vulkan_name());
    EXPECT_FALSE(device.properties().name.empty());
    EXPECT_GT(device.properties().memory_bytes, 0u);
    if (vulkan_name() != "lavapipe") return;
    EXPECT_EQ(device.properties().loop_round_limit, 65535u);
    EXPECT_EQ(device.properties().max_storage_buffer_range, 128u << 20);
    EXPECT_EQ(device.properties().kind, glift::DeviceKind::cpu);
}

// A damaged pipeline cache is ignored and replaced.
TEST(PipelineCache, SurvivesDamage) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("glift-cache-" + std::to_string(getpid()));
    const Environment where("GLIFT_CACHE_DIR", folder.c_str());
    const auto run = [] {
        const auto device = glift::Device::open(vulkan_name());
        const auto g = buffer(device, "g.data", 256);
        run_store(device, g, 64, 5);
        EXPECT_EQ(read<std::uint32_t>(device, g, 64)[63], 5u);
    };
    run();
    ASSERT_FALSE(fs::is_empty(folder));
    const fs::path file = fs::directory_iterator(folder)->path();
    const auto size = fs::file_size(file);
    for (const std::uintmax_t kept : {std::uintmax_t(0), std::uintmax_t(10), size - 1}) {
        fs::resize_file(file, kept);
        run();
        EXPECT_EQ(fs::file_size(file), size);
    }
    std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(30).put('!');
    run();
    // A damaged header: a length that exceeds the file's.
    std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(11).put('\x3f');
    run();
    EXPECT_EQ(fs::file_size(file), size);
    fs::remove_all(folder);
    fs::create_directories(folder.parent_path());
    std::ofstream(folder).put('x');  // a file in place of the folder: nothing is cached, nothing fails
    run();
    fs::remove(folder);
}

class CallErrors : public OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(CallErrors);

TEST_P(CallErrors, OneMemoryReadAndWritten) {
    const auto f = buffer(device, "f.data", 256);
    const auto error = error_of([&] { run_scale(device, f, f, 64, 1.0f); });
    expect_complete(error, ErrorCode::aliased_memory);
    EXPECT_NE(error.where().find("scale.glift:3"), std::string::npos) << error.what();
    EXPECT_NE(error.why().find("g.data"), std::string::npos) << error.what();
    EXPECT_EQ(error_of([&] { device.commands().copy(f, 0, f, 4, 8); }).code(), ErrorCode::aliased_memory);
    const glift::CopyRegion apart[] = {{0, 100, 48},
                                       {120, 200, 0}};  // the second begins in the first, but has no bytes
    EXPECT_NO_THROW(device.commands().copy(f, f, apart));
}

TEST_P(CallErrors, ConditionsThatCannotBeRead) {
    const auto f = buffer(device, "f.data", 256), other = buffer(glift::Device::open("host"), "g.data", 256);
    const glift::Commands commands(device);
    expect_complete(error_of([&] { commands.where({glift::Memory(), 0}); }), ErrorCode::wrong_argument);
    EXPECT_EQ(error_of([&] { commands.where({other, 0}); }).code(), ErrorCode::wrong_argument);
    EXPECT_EQ(error_of([&] { commands.where({f, 2}); }).code(), ErrorCode::wrong_argument);
    EXPECT_EQ(error_of([&] { commands.where_not({f, 256}); }).code(), ErrorCode::wrong_argument);
}

TEST_P(CallErrors, MemoryOfAnotherDevice) {
    const auto other = glift::Device::open("host");
    const auto f = buffer(other, "f.data", 256), g = buffer(device, "g.data", 256);
    expect_complete(error_of([&] { run_scale(device, f, g, 64, 1.0f); }), ErrorCode::wrong_argument);
    EXPECT_EQ(error_of([&] { device.commands().download(f, 0, 4); }).code(), ErrorCode::wrong_argument);
    EXPECT_EQ(error_of([&] { run_scale(device, {}, g, 64, 1.0f); }).code(), ErrorCode::wrong_argument);
}

TEST_P(CallErrors, CallsThatDoNotFitTheirKernel) {
    const auto f = buffer(device, "f.data", 256);
    const auto image = device.allocate(
        {.name = "i", .kind = glift::MemoryKind::image2d, .format = glift::Format::r32f, .extent = {4, 4, 1}});
    const AddParameters block = {64, 1};
    const auto call = [&](std::span<const glift::Memory> memories, std::span<const std::byte> parameters) {
        return error_of([&] {
                   device.commands().dispatch(add_in_place, {.form = glift::FormName::direct,
                                                             .memories = memories,
                                                             .parameters = parameters,
                                                             .size = {64, 1, 1, 1}});
               })
            .code();
    };
    EXPECT_EQ(call({}, bytes_of(block)), ErrorCode::wrong_argument);
    EXPECT_EQ(call({&f, 1}, bytes_of(block).first(4)), ErrorCode::wrong_argument);
    EXPECT_EQ(call({&image, 1}, bytes_of(block)), ErrorCode::wrong_argument);
    EXPECT_EQ(error_of([&] { device.commands().upload(f, 200, std::vector<std::byte>(100)); }).code(),
              ErrorCode::wrong_argument);
    EXPECT_EQ(error_of([&] { device.commands().fill(f, 2, 4); }).code(), ErrorCode::wrong_argument);
    // No multiple of 4; at the end of the parameters; offset + 4 overflows.
    for (const std::uint32_t offset : {2u, 24u, UINT32_MAX - 3}) {
        const ScaleParameters scaling = {64, 1.0f};
        const glift::Memory memories[] = {f, buffer(device, "g.data", 256)};
        const glift::Patch patch = {{buffer(device, "count", 4), 0}, offset};
        expect_complete(error_of([&] {
                            device.commands().dispatch(scale, {.form = glift::FormName::general,
                                                               .memories = memories,
                                                               .parameters = bytes_of(scaling),
                                                               .size = {64, 1, 1, 1},
                                                               .patches = {&patch, 1}});
                        }),
                        ErrorCode::wrong_argument);
    }
    const glift::ImageRegion outside = {.origin = {2, 0, 0}, .extent = {3, 1, 1}};
    EXPECT_EQ(error_of([&] {
                  device.commands().download_image(image, {&outside, 1}, 100);
              }).code(),
              ErrorCode::wrong_argument);
    EXPECT_EQ(error_of([&] { device.allocate({.name = "x", .format = glift::Format::r8, .bytes = 4}); }).code(),
              ErrorCode::wrong_argument);
}

// Only the host device is sure to have a buffer of so many elements: its pages are taken when they are touched.
TEST(ElementCounts, OfMoreThan32BitsAreErrors) {
    const glift::Device device = glift::Device::open("host");
    const glift::Memory bytes = buffer(device, "g.data", std::uint64_t{1} << 32);
    const glift::Binding binding[] = {
        {.name = "g.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .element_bytes = 1}};
    glift::Kernel kernel = store_value;
    kernel.bindings = binding;
    const AddParameters block = {1, 2};
    const auto call = [&] {
        device.commands().dispatch(kernel, {.form = glift::FormName::direct,
                                            .memories = {&bytes, 1},
                                            .parameters = bytes_of(block),
                                            .size = {1, 1, 1, 1}});
    };
    const auto error = error_of(call);
    expect_complete(error, ErrorCode::too_large);
    EXPECT_NE(error.remedy().find("--address-bits=64"), std::string::npos) << error.what();
    kernel.address_bits = 64;
    EXPECT_NO_THROW(call());
}

TEST_P(CallErrors, MissingForm) {
    const auto g = buffer(device, "g.data", 256);
    static const glift::Binding binding[] = {{"g.data", glift::MemoryKind::buffer, glift::Access::write}};
    static const glift::Kernel empty = {
        .name = "empty", .file = "e.glift", .line = 1, .rank = 1, .group = {64, 1, 1}, .bindings = binding};
    expect_complete(error_of([&] {
                        device.commands().dispatch(
                            empty, {.form = glift::FormName::direct, .memories = {&g, 1}, .size = {64, 1, 1, 1}});
                    }),
                    ErrorCode::missing_form);
}

TEST_P(CallErrors, LoopsBeyondTheDevice) {
    if (device.properties().loop_round_limit == glift::unlimited) GTEST_SKIP() << "no limit here";
    const auto g = buffer(device, "g.data", 256);
    static const glift::Kernel loops = [] {
        glift::Kernel kernel = store_value;
        kernel.name = "loops";
        kernel.loop_rounds = 65536;
        return kernel;
    }();
    const AddParameters block = {64, 1};
    const auto error = error_of([&] {
        device.commands().dispatch(loops, {.form = glift::FormName::direct,
                                           .memories = {&g, 1},
                                           .parameters = bytes_of(block),
                                           .size = {64, 1, 1, 1}});
    });
    expect_complete(error, ErrorCode::loop_limit);
    EXPECT_NE(error.where().find("loops"), std::string::npos);
}

TEST_P(CallErrors, WorkgroupMemoryBeyondTheDevice) {
    EXPECT_GE(device.properties().shared_memory_bytes, 16384u);  // the least that Vulkan requires
    const auto g = buffer(device, "g.data", 256);
    const glift::Kernel crowded = [&] {
        glift::Kernel kernel = store_value;
        kernel.name = "crowded";
        kernel.shared_bytes = device.properties().shared_memory_bytes + 4;
        return kernel;
    }();
    const AddParameters block = {64, 1};
    const auto error = error_of([&] {
        device.commands().dispatch(crowded, {.form = glift::FormName::direct,
                                             .memories = {&g, 1},
                                             .parameters = bytes_of(block),
                                             .size = {64, 1, 1, 1}});
    });
    expect_complete(error, ErrorCode::too_large);
    EXPECT_NE(error.where().find("crowded"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find(std::to_string(crowded.shared_bytes)), std::string::npos);
}

TEST_P(CallErrors, WhatAKernelReportsIsThrown) {
    const auto g = buffer(device, "g.data", 256);
    const auto run = [&](std::uint32_t size) {
        device.commands().dispatch(report, {.form = glift::FormName::direct,
                                            .memories = {&g, 1},
                                            .parameters = bytes_of(size),
                                            .size = {size, 1, 1, 1}});
        device.wait();
    };
    run(10);
    const auto error = error_of([&] { run(64); });
    EXPECT_EQ(error.code(), ErrorCode::out_of_range);
    EXPECT_NE(error.where().find("report.glift:21"), std::string::npos) << error.what();
    EXPECT_NE(error.why().find("g.data"), std::string::npos) << error.what();
    EXPECT_NE(error.why().find("(10)"), std::string::npos) << error.what();
    run(10);  // reported once
    EXPECT_EQ(read<std::uint32_t>(device, g, 64)[9], 9u);
}

TEST_P(CallErrors, NoMemoryLeft) {
    const Environment limit("GLIFT_MEMORY_LIMIT", "100000000");
    const auto small = glift::Device::open(device.is_host() ? "host" : vulkan_name());
    std::vector<glift::Memory> memories;
    const auto error = error_of([&] {
        for (int k = 0; k < 100; ++k) memories.push_back(buffer(small, "page.data", 10 << 20));
    });
    expect_complete(error, ErrorCode::out_of_memory);
    EXPECT_NE(error.where().find("page.data"), std::string::npos) << error.what();
    EXPECT_GE(memories.size(), 5u);
    memories.clear();
    buffer(small, "page.data", 50 << 20);  // freed memory is available again
}

TEST_P(CallErrors, MemoryBeyondTheDevice) {
    if (device.properties().max_allocation_bytes == glift::unlimited) GTEST_SKIP() << "no limit here";
    const auto error = error_of([&] { buffer(device, "whale.data", device.properties().max_allocation_bytes + 4096); });
    expect_complete(error, ErrorCode::too_large);
    EXPECT_NE(error.where().find("whale.data"), std::string::npos) << error.what();
    // The limit itself is allowed: here only the memory is too small.
    const Environment limit("GLIFT_MEMORY_LIMIT", "100000000");
    const auto small = glift::Device::open(vulkan_name());
    const std::uint64_t most = small.properties().max_allocation_bytes;
    expect_complete(error_of([&] { buffer(small, "whale.data", most / 16 * 16); }), ErrorCode::out_of_memory);
}

}  // namespace
