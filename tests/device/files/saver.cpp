// Saves a line of elements again and again under one name, until it is killed: damage_test.cpp does. All elements of a
// file have one value, the number of the save.
#include "damage.glift.hpp"

#include <glift/files.h>

#include <cstdlib>

int main(int, char** arguments) {
    const glift::Device device = glift::Device::open("host");
    damage::Line line(device, static_cast<glift::uint>(std::atoi(arguments[2])));
    for (glift::uint number = 1;; ++number) {
        line.fill(number);
        glift::save(arguments[1], "line", line);
    }
}
