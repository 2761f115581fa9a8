// The machine's memory, which the host device and Vulkan devices that are CPUs share: how much of it is left.
#pragma once

#include <cstdint>

namespace glift::detail {

std::uint64_t machine_memory_bytes();

/// Counts these bytes as held; false, and nothing is counted, where the machine has not so many beside what this
/// process holds. The kernel would promise them, and kill the process when it touches them.
bool hold_machine_memory(std::uint64_t bytes);
void release_machine_memory(std::uint64_t bytes);

}  // namespace glift::detail
