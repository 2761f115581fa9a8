// Saves the grid of docs/how-to/files.md, with two resident pages, as field.h5 in the folder in which it runs.
#include "field.glift.hpp"

#include <glift/files.h>

int main() {
    const glift::Device device = glift::Device::open("host");
    field::Grid grid(device, glift::uint3(64, 64, 32), 3u);
    grid.request_box(device, glift::uint3(0, 0, 0), glift::uint3(16, 8, 8));
    grid.allocate(device);
    field::Cell cell;
    cell.density = 0.5f;
    grid.fill(cell);
    glift::save("field.h5", "grid", grid);
}
