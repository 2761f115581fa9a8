// any3d [--device NAME | --own-shader]: shades 64 x 64 places by six kinds of structures, with one kernel. Prints for
// each structure the element at {51, 20, 7}, and the largest difference between the filtered value at an element's
// centre and the element. With --own-shader a fragment shader of the program's own reads the octree, on a device of its
// own.
#include "any3d.glift.hpp"
#include "own_shader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using glift::uint2;
using glift::uint3;

constexpr std::uint32_t side = 64;
constexpr uint2 size{side, side};

class Shader {
public:
    explicit Shader(const glift::Device& device) : device_(device), places_(device, size), picture_(device, size) {
        any3d::centres(device_, places_, places_);
    }

    const any3d::Places& places() const { return places_; }

    template <class Colour> void show(const char* name, const Colour& colour) {
        any3d::shade(device_, places_, colour, picture_);
        float most = 0;
        for (const glift::float4& difference : picture_.read())
            most = std::max({most, std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)});
        any3d::look(device_, places_, colour, picture_);
        const glift::float4 element = picture_.read(uint2(51, 20), uint2(1, 1))[0];
        std::printf("%-14s %.4f %.4f %.4f   %.6f\n", name, element.x, element.y, element.z, most);
    }

private:
    glift::Device device_;
    any3d::Places places_;
    any3d::Picture picture_;
};

void run(const glift::Device& device) {
    const uint3 extent(128, 128, 128);
    Shader shader(device);
    any3d::Texture texture(device, extent);
    any3d::Dense dense(device, extent);
    any3d::Layers layers(device, uint3(64, 64, 16));
    any3d::Volume volume(device, extent, 512, glift::float4(0));
    any3d::Octree octree(device, 4, 512);
    any3d::paint(device, texture);
    any3d::paint(device, dense);
    any3d::paint(device, layers);
    any3d::paint_volume(device, shader.places(), volume);
    any3d::paint_octree(device, shader.places(), octree);
    shader.show("image", texture);
    shader.show("dense array", dense);
    shader.show("sparse volume", volume);
    shader.show("octree", octree);
    shader.show("formula", any3d::Formula(1 / 255.0f));
    shader.show("layers", layers);
}

void run_own_shader() {
    const std::vector<glift::float4> pixels = own_shader::draw_octree(side);
    const glift::float4 element = pixels[51 + 20 * side];
    std::printf("octree, by octree.frag  %.4f %.4f %.4f\n", element.x, element.y, element.z);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc == 2 && std::string(argv[1]) == "--own-shader") return run_own_shader(), 0;
        const bool names_device = argc == 3 && std::string(argv[1]) == "--device";
        if (argc != 1 && !names_device) {
            std::fprintf(stderr, "usage: any3d [--device NAME | --own-shader]\n");
            return 2;
        }
        run(glift::Device::open(names_device ? argv[2] : ""));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "any3d: %s\n", error.what());
        return 1;
    }
}
