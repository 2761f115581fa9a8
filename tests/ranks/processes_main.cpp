// ranks_processes RANKS TEST [CASE]: the tests of cases.h in processes of this host. GLIFT_DEVICE chooses the device.
#include "cases.h"

#include <glift/ranks/processes.h>

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("usage: ranks_processes RANKS bits|bytes|balance|refusals|save|load|hang|die [CASE|FILE]\n", stderr);
        return 2;
    }
    const auto count = static_cast<unsigned>(std::atoi(argv[1]));
    return glift::ranks::run_processes(count, [&](std::shared_ptr<glift::ranks::Transport> transport) {
        const glift::Device device = glift::ranks::device_of(*transport);
        glift::ranks::World world(std::move(transport), device);
        return ranks_test::run(world, argv[2], argc > 3 ? argv[3] : "");
    });
}
