// Profiles: what they count, how passes nest in the trace, and what GLIFT_PROFILE writes at exit.
#include "test_device.h"

#include <glift/profile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace {

using namespace kernels;
using nlohmann::json;

class Profiles : public OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(Profiles);

constexpr std::uint32_t n = 1 << 16;

glift::PassProfile pass_of(const glift::Profile& profile, const std::string& name) {
    for (const glift::PassProfile& pass : profile.passes())
        if (pass.name == name) return pass;
    ADD_FAILURE() << "the profile has no pass " << name << ":\n" << profile.summary();
    return {};
}

/// The trace's events of one name.
std::vector<json> events_of(const json& trace, const std::string& name) {
    std::vector<json> events;
    for (const json& event : trace.at("traceEvents"))
        if (event.at("ph") == "X" && event.at("name") == name) events.push_back(event);
    return events;
}

/// A time of the trace in nanoseconds.
std::int64_t nanoseconds(const json& event, const char* key) {
    return std::llround(event.at(key).get<double>() * 1000);
}

bool contains(const json& outer, const json& inner) {
    const auto begin = [](const json& event) { return nanoseconds(event, "ts"); };
    const auto end = [](const json& event) { return nanoseconds(event, "ts") + nanoseconds(event, "dur"); };
    return outer.at("tid") == inner.at("tid") && begin(outer) <= begin(inner) && end(inner) <= end(outer);
}

TEST_P(Profiles, CountCallsBytesAndTimes) {
    const auto f = buffer(device, "f.data", 4 * n), g = buffer(device, "g.data", 4 * n);
    run_scale(device, f, g, n, 2);  // before the profile
    const glift::Profile profile(device);
    for (int k = 0; k < 3; ++k) run_scale(device, f, g, n, 2);
    run_add(device, g, n, 1);
    device.commands().copy(f, 0, g, 0, 400);
    device.commands().fill(g, 0, 1000, 7);
    device.commands().upload(f, 0, bytes_of(std::vector<float>(100)));
    read<float>(device, g, 50);

    const glift::PassProfile scaled = pass_of(profile, scale.name);
    EXPECT_EQ(scaled.calls, 3u);
    EXPECT_EQ(scaled.file, scale.file);
    EXPECT_EQ(scaled.line, scale.line);
    EXPECT_GT(scaled.seconds, 0);
    EXPECT_LT(scaled.seconds, 10);
    EXPECT_EQ(pass_of(profile, add_in_place.name).calls, 1u);
    EXPECT_EQ(pass_of(profile, "copy").bytes, 400u);
    EXPECT_EQ(pass_of(profile, "fill").bytes, 1000u);
    EXPECT_EQ(pass_of(profile, "upload").bytes, 400u);
    EXPECT_EQ(pass_of(profile, "download").bytes, 200u);
    EXPECT_EQ(profile.passes().size(), 6u);
}

TEST_P(Profiles, KnowTheBytesOfVisitedElements) {
    const glift::Binding visited[] = {
        {.name = "g.data", .access = glift::Access::read_write, .reach = glift::Reach::element}};
    const glift::Binding anywhere[] = {
        {.name = "g.data", .access = glift::Access::read_write, .reach = glift::Reach::range}};
    glift::Kernel in_place = add_in_place, scattered = add_in_place;
    in_place.name = "in_place", in_place.bindings = visited;
    scattered.name = "scattered", scattered.bindings = anywhere;
    const glift::Memory memories[] = {buffer(device, "g.data", 4 * n)};
    const struct {
        AddParameters own;
        std::uint64_t address = 0;
    } block = {{n, 1}};
    const glift::Profile profile(device);
    for (const glift::Kernel* kernel : {&in_place, &scattered}) {
        const bool direct = device.commands().can_be_direct(*kernel, memories, {n, 1, 1, 1});
        const auto form = direct ? glift::FormName::direct : glift::FormName::general;
        device.commands().dispatch(
            *kernel,
            {form, memories, bytes_of(block).first(glift::form_of(*kernel, form).parameter_bytes), {n, 1, 1, 1}});
    }
    EXPECT_EQ(pass_of(profile, "in_place").bytes, 2u * 4 * n);
    EXPECT_FALSE(pass_of(profile, "in_place").has_uncounted_bytes);
    EXPECT_TRUE(pass_of(profile, "scattered").has_uncounted_bytes);
}

TEST_P(Profiles, CountEachReplay) {
    const auto g = buffer(device, "g.data", 4 * n);
    const glift::Profile profile(device);
    const auto recording = device.record([&](const glift::Commands& commands) {
        const glift::PipelineMark step("step", "steps.glift:3");
        for (std::uint32_t k = 0; k < 600; ++k) run_add(commands, g, 64, k);  // more than one pool of queries
        run_store(commands, g, n, 5);
    });
    EXPECT_TRUE(profile.passes().empty() || device.is_host() || profile.passes()[0].name == "clear");
    for (int replay = 0; replay < 3; ++replay) recording.submit();
    EXPECT_EQ(pass_of(profile, add_in_place.name).calls, 1800u);
    EXPECT_EQ(pass_of(profile, store_value.name).calls, 3u);
    const json trace = json::parse(profile.trace());
    const std::vector<json> steps = events_of(trace, "step"), stores = events_of(trace, store_value.name);
    ASSERT_EQ(steps.size(), 3u);
    ASSERT_EQ(stores.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(contains(steps[k], stores[k]));
}

TEST_P(Profiles, CountARecordingThatWasMadeBeforeThem) {
    const auto g = buffer(device, "g.data", 4 * n);
    const auto recording = device.record([&](const glift::Commands& commands) { run_add(commands, g, n, 1); });
    const glift::Profile profile(device);
    for (int replay = 0; replay < 2; ++replay) recording.submit();
    const glift::PassProfile pass = pass_of(profile, device.is_host() ? add_in_place.name : "recording");
    EXPECT_EQ(pass.calls, 2u);
    EXPECT_GT(pass.seconds, 0);
}

TEST_P(Profiles, NestPassesInPipelines) {
    const auto f = buffer(device, "f.data", 4 * n), g = buffer(device, "g.data", 4 * n);
    device.wait();
    const glift::Profile profile(device);
    const auto inner = [&] {
        const glift::PipelineMark mark("inner", "steps.glift:20");
        run_add(device, g, n, 1);
        run_store(device, g, n, 1);
    };
    {
        const glift::PipelineMark mark("outer \"quoted\"", "steps.glift:10");
        run_scale(device, f, g, n, 1);
        for (int k = 0; k < 2; ++k) inner();
    }
    run_scale(device, f, g, n, 1);
    const json trace = json::parse(profile.trace());
    const std::vector<json> outer = events_of(trace, "outer \"quoted\""), inners = events_of(trace, "inner"),
                            adds = events_of(trace, add_in_place.name), scales = events_of(trace, scale.name);
    ASSERT_EQ(outer.size(), 1u);
    ASSERT_EQ(inners.size(), 2u);
    ASSERT_EQ(adds.size(), 2u);
    ASSERT_EQ(scales.size(), 2u);
    EXPECT_EQ(outer[0].at("args").at("source"), "steps.glift:10");
    EXPECT_EQ(outer[0].at("cat"), "pipeline");
    EXPECT_EQ(adds[0].at("cat"), "pass");
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_TRUE(contains(outer[0], inners[k]));
        EXPECT_TRUE(contains(inners[k], adds[k]));
        EXPECT_FALSE(contains(inners[1 - k], adds[k]));
    }
    EXPECT_TRUE(contains(outer[0], scales[0]));
    EXPECT_FALSE(contains(outer[0], scales[1]));
    EXPECT_FALSE(contains(inners[0], scales[0]));
}

TEST_P(Profiles, SummariseALineForEachPass) {
    const auto f = buffer(device, "f.data", 4 * n), g = buffer(device, "g.data", 4 * n);
    device.wait();
    const glift::Profile profile(device);
    EXPECT_NE(profile.summary().find(", 0 passes and copies in 0.00 ns\n"), std::string::npos) << profile.summary();
    run_scale(device, f, g, n, 1);
    run_add(device, g, n, 1);
    const std::string summary = profile.summary();
    EXPECT_TRUE(summary.starts_with("glift profile: " + device.properties().name + ", 2 passes and copies in "))
        << summary;
    EXPECT_EQ(std::ranges::count(summary, '\n'), 4);
    for (const char* heading : {"pass", "source", "calls", "total", "per call", "bytes", "share"})
        EXPECT_NE(summary.find(heading), std::string::npos) << summary;
    const std::string place = std::string(scale.file) + ":" + std::to_string(scale.line);
    EXPECT_NE(summary.find(place), std::string::npos) << summary;
}

TEST_P(Profiles, EndAndBeginAnew) {
    const auto g = buffer(device, "g.data", 4 * n);
    {
        const glift::Profile first(device);
        run_add(device, g, n, 1);
        const glift::Profile second(device);
        run_add(device, g, n, 1);
        EXPECT_EQ(pass_of(second, add_in_place.name).calls, 1u);
        EXPECT_EQ(pass_of(first, add_in_place.name).calls, 2u);
    }
    run_add(device, g, n, 1);
    const glift::Profile third(device);
    EXPECT_TRUE(third.passes().empty()) << third.summary();
}

TEST_P(Profiles, AreNotReadInARecording) {
    const glift::Profile profile(device);
    device.record([&](const glift::Commands&) {
        EXPECT_EQ(error_of([&] { profile.summary(); }).code(), glift::ErrorCode::wrong_argument);
    });
}

/// Runs two passes on a device that is gone before the process ends, or is not.
void run_profiled(const char* which, const std::string& target, bool leaves_device) {
    setenv("GLIFT_PROFILE", target.c_str(), 1);
    auto* const device = new glift::Device(glift::Device::open(which == std::string("host") ? which : vulkan_name()));
    {
        const auto g = buffer(*device, "g.data", 4 * n);
        run_add(*device, g, n, 1);
        run_add(*device, g, n, 1);
        device->wait();
    }
    if (!leaves_device) delete device;
    std::exit(0);
}

class ProfilesAtExit : public testing::TestWithParam<const char*> {
protected:
    ProfilesAtExit() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};
GLIFT_ON_EVERY_DEVICE(ProfilesAtExit);

TEST_P(ProfilesAtExit, PrintASummary) {
    const std::string line = std::string(add_in_place.name) + " +[a-z_.]+:[0-9]+ +2 ";
    EXPECT_EXIT(run_profiled(GetParam(), "summary", false), testing::ExitedWithCode(0), line);
    EXPECT_EXIT(run_profiled(GetParam(), "summary", true), testing::ExitedWithCode(0), line);
}

TEST_P(ProfilesAtExit, WriteATrace) {
    const auto file = std::filesystem::temp_directory_path() / (std::string("glift_profile_") + GetParam() + ".json");
    std::filesystem::remove(file);
    EXPECT_EXIT(run_profiled(GetParam(), file.string(), false), testing::ExitedWithCode(0), "");
    std::ifstream stream(file);
    ASSERT_TRUE(stream);
    EXPECT_EQ(events_of(json::parse(stream), add_in_place.name).size(), 2u);
    std::filesystem::remove(file);
}

TEST_P(ProfilesAtExit, RefuseAnUnknownTarget) {
    setenv("GLIFT_PROFILE", "yes", 1);
    const glift::Error error = error_of([] { glift::Device::open("host"); });
    unsetenv("GLIFT_PROFILE");
    EXPECT_EQ(error.code(), glift::ErrorCode::wrong_argument);
    EXPECT_NE(std::string(error.what()).find("GLIFT_PROFILE=yes"), std::string::npos) << error.what();
}

}  // namespace
