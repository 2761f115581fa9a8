// Calls the methods of handles that are empty, that is, default-constructed or moved from, and passes such handles to
// calls. What cannot work must throw an Error that says what to do.
#include "test_device.h"

#include <functional>

#include <glift/vulkan.h>

namespace {

using namespace kernels;

struct Use {
    const char* name;
    std::function<void()> run;
};

void expect_errors(const char* handle, const std::vector<Use>& uses) {
    for (const Use& use : uses) {
        const auto error = error_of(use.run);
        EXPECT_EQ(error.code(), glift::ErrorCode::wrong_argument) << use.name << ": " << error.what();
        EXPECT_NE(error.what(), std::string()) << use.name;
        EXPECT_NE(error.problem().find("empty"), std::string::npos) << use.name << ": " << error.what();
        EXPECT_NE((error.problem() + error.where()).find(handle), std::string::npos)
            << use.name << ": " << error.what();
        EXPECT_FALSE(error.remedy().empty()) << use.name << ": " << error.what();
    }
}

void use_device(const glift::Device& device) {
    EXPECT_FALSE(device);
    const auto nothing = [](const glift::Commands&) {};
    expect_errors("Device", {{"properties", [&] { device.properties(); }},
                             {"is_host", [&] { device.is_host(); }},
                             {"allocate", [&] { device.allocate({.name = "f", .bytes = 4}); }},
                             {"commands", [&] { device.commands(); }},
                             {"Commands", [&] { glift::Commands commands(device); }},
                             {"record", [&] { device.record(nothing); }},
                             {"workspace_bytes", [&] { device.workspace_bytes(nothing); }},
                             {"wait", [&] { device.wait(); }},
                             {"statistics", [&] { device.statistics(); }},
                             {"validation_messages", [&] { device.validation_messages(); }},
                             {"vulkan::objects", [&] { glift::vulkan::objects(device); }},
                             {"vulkan::record_into", [&] { glift::vulkan::record_into(device, VK_NULL_HANDLE); }}});
    EXPECT_EQ(device, glift::Device());
}

void use_commands(const glift::Commands& commands, const glift::Memory& f, const glift::Memory& g) {
    EXPECT_FALSE(commands);
    const glift::CopyRegion region = {0, 0, 4};
    const glift::ImageRegion box;
    const glift::ImageCopyRegion boxes;
    std::byte bytes[4] = {};
    expect_errors("Commands", {{"device", [&] { commands.device(); }},
                               {"is_recording", [&] { commands.is_recording(); }},
                               {"can_be_direct",
                                [&] {
                                    commands.can_be_direct(scale, {}, {1, 1, 1, 1});
                                }},
                               {"dispatch", [&] { run_scale(commands, f, g, 1, 1.0f); }},
                               {"specialised", [&] { run_scale(commands.specialised(), f, g, 1, 1.0f); }},
                               {"uninitialized", [&] { commands.uninitialized().allocate({.name = "h", .bytes = 4}); }},
                               {"allocate", [&] { commands.allocate({.name = "h", .bytes = 4}); }},
                               {"adopt", [&] { commands.adopt(f, {.name = "h", .bytes = 4}); }},
                               {"fill", [&] { commands.fill(f, 0, 4); }},
                               {"copy",
                                [&] {
                                    commands.copy(f, g, {&region, 1});
                                }},
                               {"copy at", [&] { commands.copy(f, 0, g, 0, 4); }},
                               {"copy_to_image",
                                [&] {
                                    commands.copy_to_image(f, g, {&box, 1});
                                }},
                               {"copy_from_image",
                                [&] {
                                    commands.copy_from_image(f, g, {&box, 1});
                                }},
                               {"copy_images",
                                [&] {
                                    commands.copy_images(f, g, {&boxes, 1});
                                }},
                               {"upload",
                                [&] {
                                    commands.upload(f, {&region, 1}, bytes);
                                }},
                               {"upload at", [&] { commands.upload(f, 0, bytes); }},
                               {"upload_image",
                                [&] {
                                    commands.upload_image(f, {&box, 1}, bytes);
                                }},
                               {"download",
                                [&] {
                                    commands.download(f, {&region, 1}, 4);
                                }},
                               {"download at", [&] { commands.download(f, 0, 4); }},
                               {"download_image",
                                [&] {
                                    commands.download_image(f, {&box, 1}, 4);
                                }},
                               {"timestamp", [&] { commands.timestamp(); }},
                               {"flush", [&] { commands.flush(); }},
                               {"wait", [&] { commands.wait(); }},
                               {"vulkan::finish", [&] { glift::vulkan::finish(commands); }}});
}

// long: a line for each call that takes a memory
/// Passes the memory, which is empty, to the calls that take one.
void use_memory(const glift::Memory& memory, const glift::Commands& commands, const glift::Memory& other) {
    EXPECT_FALSE(memory);
    EXPECT_EQ(memory, glift::Memory());
    const glift::CopyRegion region = {0, 0, 4};
    const glift::ImageRegion box;
    const glift::ImageCopyRegion boxes;
    std::byte bytes[4] = {};
    const glift::Patch patch = {{memory, 0}, 0};
    const ScaleParameters block = {1, 1.0f};
    const glift::Memory two[] = {other, other};
    expect_errors("Memory", {{"description", [&] { memory.description(); }}, {"extent", [&] { memory.extent(); }}});
    expect_errors("",
                  {{"dispatch", [&] { run_scale(commands, memory, other, 1, 1.0f); }},
                   {"can_be_direct",
                    [&] {
                        if (!commands.can_be_direct(add_in_place, {&memory, 1}, {1, 1, 1, 1}))
                            run_add(commands, memory, 1, 1);
                    }},
                   {"adopt", [&] { commands.adopt(memory, {.name = "h", .bytes = 4}); }},
                   {"fill", [&] { commands.fill(memory, 0, 4); }},
                   {"fill nothing", [&] { commands.fill(memory, 0, 0); }},
                   {"copy from",
                    [&] {
                        commands.copy(memory, other, {&region, 1});
                    }},
                   {"copy to",
                    [&] {
                        commands.copy(other, memory, {&region, 1});
                    }},
                   {"copy nothing", [&] { commands.copy(memory, memory, std::span<const glift::CopyRegion>()); }},
                   {"copy_to_image",
                    [&] {
                        commands.copy_to_image(memory, memory, {&box, 1});
                    }},
                   {"copy_to_image",
                    [&] {
                        commands.copy_to_image(other, memory, {&box, 1});
                    }},
                   {"copy_from_image",
                    [&] {
                        commands.copy_from_image(memory, other, {&box, 1});
                    }},
                   {"copy_images",
                    [&] {
                        commands.copy_images(memory, memory, {&boxes, 1});
                    }},
                   {"upload",
                    [&] {
                        commands.upload(memory, {&region, 1}, bytes);
                    }},
                   {"upload nothing", [&] { commands.upload(memory, std::span<const glift::CopyRegion>(), {}); }},
                   {"upload_image",
                    [&] {
                        commands.upload_image(memory, {&box, 1}, bytes);
                    }},
                   {"download", [&] { commands.download(memory, 0, 4); }},
                   {"download nothing", [&] { commands.download(memory, std::span<const glift::CopyRegion>(), 4); }},
                   {"download_image",
                    [&] {
                        commands.download_image(memory, {&box, 1}, 4);
                    }},
                   {"vulkan::buffer", [&] { glift::vulkan::buffer(memory); }},
                   {"vulkan::image", [&] { glift::vulkan::image(memory); }}});
    EXPECT_EQ(error_of([&] {
                  commands.dispatch(scale, {.form = glift::FormName::general,
                                            .memories = two,
                                            .parameters = bytes_of(block),
                                            .size = {1, 1, 1, 1},
                                            .patches = {&patch, 1}});
              }).code(),
              glift::ErrorCode::aliased_memory);
}

void use_recording(const glift::Recording& recording) {
    EXPECT_FALSE(recording);
    expect_errors("Recording",
                  {{"submit", [&] { recording.submit(); }}, {"workspace_bytes", [&] { recording.workspace_bytes(); }}});
}

void use_download(const glift::Download& download) {
    EXPECT_FALSE(download);
    expect_errors("Download", {{"ready", [&] { download.ready(); }}, {"get", [&] { download.get(); }}});
}

void use_timestamp(const glift::Timestamp& timestamp) {
    EXPECT_FALSE(timestamp);
    expect_errors("Timestamp",
                  {{"seconds", [&] { timestamp.seconds(); }}, {"minus", [&] { (void)(timestamp - timestamp); }}});
}

class Handles : public OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(Handles);

TEST_P(Handles, ThatAreEmptySayHowToMakeOne) {
    const auto f = buffer(device, "f.data", 256), g = buffer(device, "g.data", 256);
    use_device({});
    use_commands(glift::Commands(std::shared_ptr<glift::detail::Stream>()), f, g);
    use_memory({}, device, g);
    use_recording({});
    use_download({});
    use_timestamp({});
}

TEST_P(Handles, ThatWereMovedFromAreEmpty) {
    const auto f = buffer(device, "f.data", 256), g = buffer(device, "g.data", 256);
    glift::Device a = device;
    const glift::Device b = std::move(a);
    use_device(a);
    glift::Commands c(b);
    const glift::Commands d = std::move(c);
    use_commands(c, f, g);
    glift::Memory m = f;
    const glift::Memory n = std::move(m);
    use_memory(m, d, g);
    glift::Recording r = device.record([](const glift::Commands&) {});
    const glift::Recording s = std::move(r);
    use_recording(r);
    glift::Download x = d.download(n, 0, 4);
    EXPECT_EQ(std::move(x).get().size(), 4u);
    const glift::Download y = std::move(x);
    use_download(x);
    glift::Timestamp t = d.timestamp();
    const glift::Timestamp u = std::move(t);
    use_timestamp(t);
    EXPECT_GE(u.seconds(), 0.0);
    s.submit();
    EXPECT_EQ(y.get().size(), 4u);
}

}  // namespace
