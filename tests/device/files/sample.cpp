// Saves a volume and a sparse grid to the file of the first argument. Element (x, y, z) of the volume of 4 x 3 x 2 has
// the density x + 10 y + 100 z + the second argument.
#include "damage.glift.hpp"

#include <glift/files.h>

#include <cstdlib>

int main(int, char** arguments) {
    const glift::Device device = glift::Device::open("host");
    damage::Volume volume(device, glift::uint3(4, 3, 2));
    std::vector<damage::Cell> cells;
    for (int i = 0; i < 24; ++i) {
        damage::Cell cell;
        const int x = i % 4, y = i / 4 % 3, z = i / 12;
        cell.density = static_cast<float>(x + 10 * y + 100 * z + std::atoi(arguments[2]));
        cell.velocity = {1.0f, 2.0f, static_cast<float>(i)};
        cell.on = i % 2 == 1;
        cell.heat = 0.5f * static_cast<float>(i);
        cells.push_back(cell);
    }
    volume.write(cells);
    const damage::Grid grid(device, glift::uint2(20, 20), 3u, 1.5f);
    glift::NewFile file(arguments[1]);
    file.save("volume", volume);
    file.save("grid", grid);
    file.commit();
}
