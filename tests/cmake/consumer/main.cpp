#include "scale.glift.hpp"
#include "shift.glift.hpp"

#include <cstdio>
#include <glift/device.h>
#include <vector>

int main() {
    auto device = glift::Device::open("host");
    scale::Line f(device, {8}), g(device, {8});
    f.write({0}, {8}, std::vector<float>{0, 1, 2, 3, 4, 5, 6, 7});
    scale::scale(device, f, g);
    for (const float value : g.read({0}, {8})) std::printf("%g ", value);
    std::printf("\n");

    shift::Line h(device, {4});
    shift::shift(device, h);
    for (const float value : h.read({0}, {4})) std::printf("%g ", value);
    shift::there_and_back(device, h, 1.0e8f);
    for (const float value : h.read({0}, {4})) std::printf("%g ", value);
    std::printf("\n");
}
