// A structure is one C++ class, even if several modules use it.
#include "calls.glift.hpp"
#include "imported.glift.hpp"
#include "misuse.glift.hpp"
#include "sharing.glift.hpp"

#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

namespace {

TEST(Sharing, a_structure_of_one_module_goes_to_another) {
    for (const glift::Device& device : {glift::Device::open("host"), glift::Device::open()}) {
        calls::Plane plane(device, {4, 4});
        sharing::half_slope(device, plane);
        EXPECT_EQ(plane.read({3, 2}, {1, 1}), std::vector<float>{7.0f});
        calls::Tiles tiles(device, {4, 4});
        calls::both(device, plane, 1.0f, tiles);
    }
}

TEST(Sharing, the_class_is_one) {
    static_assert(
        std::is_same_v<decltype(&sharing::halve), void (*)(const glift::Commands&, const glift::Range<calls::Plane>&)>);
}

}  // namespace
