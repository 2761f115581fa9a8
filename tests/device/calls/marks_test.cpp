// Two runs of gliftc generate code for one kernel, each for different devices; a program links both.
#include "marks_elsewhere.glift.hpp"
#include "marks_on_host.glift.hpp"

#include <gtest/gtest.h>

namespace {

std::vector<glift::uint> marks_on(const glift::Device& device) {
    marks::Line line(device, 3);
    marks_on_host::put_on_host(device, line);
    marks_elsewhere::put_elsewhere(device, line);
    return line.read();
}

TEST(Marks, HaveCodeForTheDevicesOfEitherRun) {
    EXPECT_EQ(marks_on(glift::Device::open("host")), (std::vector<glift::uint>{1, 1, 1}));
    EXPECT_EQ(marks_on(glift::Device::open("lavapipe")), (std::vector<glift::uint>{2, 2, 2}));
}

}  // namespace
