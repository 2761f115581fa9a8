// Tests that run on the host device and on Vulkan (lavapipe unless GLIFT_TEST_DEVICE names another device), the latter
// with the validation layer if GLIFT_VALIDATE=1, as ctest sets it: any message fails the test.
#pragma once

#include "kernels.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

inline std::string vulkan_name() {
    const char* name = std::getenv("GLIFT_TEST_DEVICE");
    return name ? name : "lavapipe";
}

class OnEveryDevice : public testing::TestWithParam<const char*> {
protected:
    OnEveryDevice() : device(glift::Device::open(GetParam() == std::string("host") ? "host" : vulkan_name())) {}
    ~OnEveryDevice() override {
        device.wait();
        for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
    }

    glift::Device device;
};

#define GLIFT_ON_EVERY_DEVICE(Fixture)                                                                                 \
    INSTANTIATE_TEST_SUITE_P(, Fixture, testing::Values("host", "vulkan"),                                             \
                             [](const testing::TestParamInfo<const char*>& which) { return which.param; })

/// The Error that the action throws; fails the test if it throws none.
template <class Action> glift::Error error_of(Action action) {
    try {
        action();
    } catch (const glift::Error& error) {
        return error;
    }
    ADD_FAILURE() << "no glift::Error was thrown";
    return {glift::ErrorCode::vulkan, "none"};
}
