#include "machine_memory.h"

#include <glift/device.h>

#include <atomic>
#include <fstream>
#include <string>

#include <unistd.h>

namespace glift::detail {

namespace {

/// Bytes of the machine's memory that this process's host device and Vulkan devices that are CPUs hold.
std::atomic<std::uint64_t> held{0};

/// MemAvailable of /proc/meminfo, in bytes; `unlimited` where it cannot be read. Pages that were allocated but never
/// touched still count as available, so the bytes that Glift holds are checked as well.
std::uint64_t available_bytes() {
    std::ifstream info("/proc/meminfo");
    std::string word;
    std::uint64_t kilobytes = 0;
    while (info >> word)
        if (word == "MemAvailable:" && info >> kilobytes) return kilobytes * 1024;
    return unlimited;
}

}  // namespace

std::uint64_t machine_memory_bytes() {
    return std::uint64_t(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGE_SIZE));
}

bool hold_machine_memory(std::uint64_t bytes) {
    constexpr std::uint64_t small = std::uint64_t(64) << 20;  // for fewer bytes it is not worth reading the file
    const std::uint64_t machine = machine_memory_bytes();
    if (bytes > machine || (bytes > small && bytes > available_bytes())) return false;
    std::uint64_t before = held;
    do {
        if (before > machine - bytes) return false;
    } while (!held.compare_exchange_weak(before, before + bytes));
    return true;
}

void release_machine_memory(std::uint64_t bytes) { held -= bytes; }

}  // namespace glift::detail
