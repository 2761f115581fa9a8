// Calls that fix parameters as constants of the Vulkan pipeline: the same results, and one pipeline for each set of
// values.
#include "calls.glift.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace {

class Specialised : public testing::TestWithParam<const char*> {
protected:
    Specialised()
        : device(glift::Device::open(GetParam() == std::string("host") ? "host" : "")), f(device, {13, 11}),
          g(device, {12, 10}) {
        calls::slope(device, 1.0f, 16.0f, f);
    }
    ~Specialised() override {
        device.wait();
        for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
    }

    std::vector<float> shifted(const glift::Commands& commands, float factor, bool negate) {
        g.fill(-1.0f);
        calls::shift(commands, f, {1, 1}, factor, calls::Sign::minus, negate, g);
        return g.read({0, 0}, {12, 10});
    }

    glift::Device device;
    calls::Plane f;
    calls::Tiles g;
};

INSTANTIATE_TEST_SUITE_P(, Specialised, testing::Values("host", "vulkan"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(Specialised, GivesTheSame) {
    const glift::Commands commands = device;
    const auto pipelines = [&] { return device.statistics().pipelines; };
    for (const bool negate : {false, true}) {
        const std::vector<float> plain = shifted(commands, 0.5f, negate);
        EXPECT_EQ(plain[0], negate ? 8.5f : -8.5f);
        const auto before = pipelines();
        EXPECT_EQ(shifted(commands.specialised(), 0.5f, negate), plain);
        EXPECT_EQ(pipelines(), before + (device.is_host() ? 0 : 1));
        EXPECT_EQ(shifted(commands.specialised({"f_extent", "negate"}), 0.5f, negate), plain);
        EXPECT_EQ(pipelines(), before + (device.is_host() ? 0 : 2));
    }
    const auto before = pipelines();
    const std::vector<float> other = shifted(commands.specialised({"f_extent", "negate"}), 0.25f, true);
    EXPECT_EQ(other[0], 4.25f) << "what is not fixed varies from call to call";
    EXPECT_EQ(pipelines(), before);
}

TEST_P(Specialised, Pipelines) {
    const glift::Commands commands = device;
    calls::both(commands, f, 0.5f, g);
    const auto plain = g.read({0, 0}, {12, 10});
    g.fill(0.0f);
    calls::both(commands.specialised(), f, 0.5f, g);
    EXPECT_EQ(g.read({0, 0}, {12, 10}), plain);
}

}  // namespace
