// The Laplacian of a 4-D array in a .npy file, or of a picture: laplacian.glift from C++.
#include "../common/npy.h"
#include "../common/png.h"
#include "laplacian.glift.hpp"

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr const char* usage =
    "usage: laplacian INPUT OUTPUT [--device NAME]\n"
    "\n"
    "  laplacian in.npy out.npy   of an array with 4 axes\n"
    "  laplacian in.png out.png   of a picture, in grey: 0 becomes middle grey\n"
    "\n"
    "  --device NAME   gpu, lavapipe, host or part of a device's name (default: GLIFT_DEVICE, else any)\n";

struct WrongUsage : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Arguments {
    std::vector<std::string> files;
    std::string device;
};

Arguments read_arguments(int argc, char** argv) {
    Arguments arguments;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--device") {
            if (++i == argc) throw WrongUsage("--device is followed by nothing");
            arguments.device = argv[i];
        } else if (word.starts_with("-")) {
            throw WrongUsage("there is no option " + word);
        } else {
            arguments.files.push_back(word);
        }
    }
    if (arguments.files.size() != 2) {
        throw WrongUsage("an input and an output are wanted, " + std::to_string(arguments.files.size()) + " given");
    }
    return arguments;
}

void transform_array(const glift::Device& device, const std::string& input, const std::string& output) {
    npy::Array array = npy::read(input);
    if (array.extent.size() != 4) {
        throw std::runtime_error(input + ": the array has " + std::to_string(array.extent.size()) +
                                 " axes; 4 are wanted (numpy.reshape can add axes of length 1)");
    }
    const glift::uint4 extent = {array.extent[0], array.extent[1], array.extent[2], array.extent[3]};
    laplacian::Field f(device, extent), g(device, extent);
    f.write(array.values);
    laplacian::laplacian(device, f, g);
    array.values = g.read();
    npy::write(output, array);
    std::printf("%s: the Laplacian of %s, made on %s\n", output.c_str(), npy::text_of(array.extent).c_str(),
                device.properties().name.c_str());
}

void transform_picture(const glift::Device& device, const std::string& input, const std::string& output) {
    png::Picture picture = png::read(input);
    const glift::uint2 extent = {picture.width, picture.height};
    laplacian::Picture f(device, extent), g(device, extent);
    f.write(picture.values);
    laplacian::laplacian_of_picture(device, f, g);
    picture.values = g.read();
    for (float& value : picture.values) value = 0.5f + 0.5f * value;
    png::write(output, picture);
    std::printf("%s: the Laplacian of %u x %u pixels, made on %s\n", output.c_str(), picture.width, picture.height,
                device.properties().name.c_str());
}

int run(const Arguments& arguments) {
    const std::string &input = arguments.files[0], &output = arguments.files[1];
    const std::string kind = std::filesystem::path(input).extension().string();
    if (kind != ".npy" && kind != ".png") throw WrongUsage("'" + input + "' is neither a .npy nor a .png file");
    if (std::filesystem::path(output).extension() != kind) {
        throw WrongUsage("'" + output + "' must be a " + kind + " file, as the input is");
    }
    const glift::Device device = glift::Device::open(arguments.device);
    if (kind == ".npy") transform_array(device, input, output);
    else transform_picture(device, input, output);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc == 2 && std::string(argv[1]) == "--help") {
            std::fputs(usage, stdout);
            return 0;
        }
        return run(read_arguments(argc, argv));
    } catch (const WrongUsage& error) {
        std::fprintf(stderr, "laplacian: %s\n\n%s", error.what(), usage);
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "laplacian: %s\n", error.what());
        return 1;
    }
}
