// ranks_processes RANKS TEST [CASE]: the tests of cases.h in processes of this host. GLIFT_DEVICE chooses the device of
// all ranks; with `gpus`, rank k has the k-th GPU.
#include "cases.h"

#include <glift/ranks/processes.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

glift::Device device_of(unsigned rank) {
    const char* const wanted = std::getenv("GLIFT_DEVICE");
    return wanted && std::string(wanted) == "gpus" ? glift::Device::open("gpu:" + std::to_string(rank))
                                                   : glift::Device::open();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("usage: ranks_processes RANKS bits|bytes|balance|refusals|save|load|hang|die [CASE|FILE]\n", stderr);
        return 2;
    }
    const auto count = static_cast<unsigned>(std::atoi(argv[1]));
    return glift::ranks::run_processes(count, [&](std::shared_ptr<glift::ranks::Transport> transport) {
        glift::Device device = device_of(transport->rank());
        glift::ranks::World world(std::move(transport), std::move(device));
        return ranks_test::run(world, argv[2], argc > 3 ? argv[3] : "");
    });
}
