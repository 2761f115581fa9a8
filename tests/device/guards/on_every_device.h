// Tests that run on the host device and on Vulkan (lavapipe unless GLIFT_TEST_DEVICE names another device), the latter
// with the validation layer if GLIFT_VALIDATE=1, as ctest sets it: any message fails the test.
#pragma once

#include <glift/glift.h>

#include <gmock/gmock.h>

#include <cstdlib>
#include <optional>
#include <string>

class OnEveryDevice : public testing::TestWithParam<const char*> {
protected:
    OnEveryDevice() : device(glift::Device::open(name())) {}
    ~OnEveryDevice() override {
        for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
    }

    static std::string name() {
        const char* vulkan = std::getenv("GLIFT_TEST_DEVICE");
        return GetParam() == std::string("host") ? "host" : vulkan ? vulkan : "lavapipe";
    }

    glift::Device device;
};

#define GLIFT_ON_EVERY_DEVICE(Fixture)                                                                                 \
    INSTANTIATE_TEST_SUITE_P(, Fixture, testing::Values("host", "vulkan"),                                             \
                             [](const testing::TestParamInfo<const char*>& which) { return which.param; })

/// The Error that the action throws, if any.
template <class Action> std::optional<glift::Error> thrown_by(Action action) {
    try {
        action();
    } catch (const glift::Error& error) {
        return error;
    }
    return std::nullopt;
}
