// Functions of containers as methods of their C++ classes, and containers as arguments of kernels.
#include "containers.glift.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

const char* const devices[] = {"host", "lavapipe"};

TEST(Containers, functions_are_methods) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        containers::Line data(device, 4);
        data.write(std::vector<float>{1, 2, 3, 4});
        containers::Reversed reversed(device, data, 4);
        reversed.set_up(device, 2.0f);
        EXPECT_EQ(reversed.last(), 3u);
        EXPECT_EQ(reversed.get(device, 0), 8.0f);
        EXPECT_EQ(reversed.get(device, reversed.last()), 2.0f);
    }
}

TEST(Containers, kernels_take_them) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        containers::Line data(device, 4);
        data.write(std::vector<float>{1, 2, 3, 4});
        containers::Reversed reversed(device, data, 4);
        reversed.set_up(device, 10.0f);
        const containers::Line result(device, 4);
        containers::reverse(device, reversed, result, result);
        EXPECT_EQ(result.read(), (std::vector<float>{40, 30, 20, 10}));
    }
}

TEST(Containers, what_they_hold_is_not_written_beside_them) {
    for (const char* name : devices) {
        const auto device = glift::Device::open(name);
        const containers::Line data(device, 4);
        containers::Reversed reversed(device, data, 4);
        try {
            containers::reverse(device, reversed, data, data);
            ADD_FAILURE() << "on " << name;
        } catch (const glift::Error& error) {
            EXPECT_EQ(error.code(), glift::ErrorCode::aliased_memory);
            EXPECT_NE(std::string(error.what()).find("'from'"), std::string::npos) << error.what();
        }
    }
}

}  // namespace
