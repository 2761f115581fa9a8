// Ends while passes are under way on a device in a static variable: exit() must neither crash nor hang. The driver is
// still compiling the kernel when main returns.
#include "kernels.h"

#include <cstdio>
#include <optional>

namespace {

glift::Device device;
std::optional<glift::Memory> memory;

}  // namespace

int main() {
    device = glift::Device::open();
    memory = kernels::buffer(device, "g.data", 256);
    for (std::uint32_t pass = 0; pass < 1000; ++pass) kernels::run_add(device, *memory, 64, pass);
    std::puts("main returns");
}
