// Runs kernels on two devices, and reloads them, as reload_test.py tells it on standard input:
//   poll       prints "loaded" or "same", after the messages of the runtime
//   kernel, pipeline, replay    runs it over a line of zeros, and prints the first element on both devices
//   structure  prints elements of two structures, which were made and written when the program began
#include "drift.glift.hpp"

#include <glift/reload.h>

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

namespace {

constexpr unsigned count = 5;

struct OnDevice {
    explicit OnDevice(const char* name)
        : device(glift::Device::open(name)), from(device, count), to(device, count), line(device, count),
          wide(device, count) {
        line.fill(7.0f);
        drift::fill(device, wide, 8.0f);
        recording = device.record([&](const glift::Commands& commands) { drift::add(commands, from, to, 10.0f); });
    }

    float run(const std::string& command) {
        from.fill(0.0f);
        if (command == "replay") recording.submit();
        else if (command == "kernel") drift::add(device, from, to, 10.0f);
        else {
            drift::add_twice(device, from, 10.0f);
            return from.read()[0];
        }
        return to.read()[0];
    }

    glift::Device device;
    drift::Line from, to, line;
    drift::Wide wide;
    glift::Recording recording;
};

}  // namespace

int main(int, char** arguments) {
    try {
        std::vector<OnDevice> devices;
        for (const char* name : {"host", "lavapipe"}) devices.emplace_back(name);
        glift::Reload reload(arguments[1]);
        glift::set_log([](std::string_view message) { std::cout << message << "\n"; });
        for (std::string command; std::getline(std::cin, command);) {
            if (command == "poll") {
                std::cout << (reload.poll() ? "loaded" : "same") << std::endl;
                continue;
            }
            for (OnDevice& on : devices) {
                if (command == "structure") std::cout << on.line.read()[3] << " " << on.wide.read()[3] << " ";
                else std::cout << on.run(command) << " ";
            }
            std::cout << std::endl;
        }
    } catch (const std::exception& error) {
        std::cout << error.what() << std::endl;
        return 1;
    }
}
