// The machine's memory, which the host device and Vulkan devices that are CPUs share: how much of it is left.
#pragma once

#include <cstdint>

namespace glift::detail {

std::uint64_t machine_memory_bytes();  ///< all of it, used or not

/// Counts these bytes as held by this process. False, with nothing counted, if the machine does not have so many left:
/// the operating system would grant them, and kill the process when it touches them.
bool hold_machine_memory(std::uint64_t bytes);
void release_machine_memory(std::uint64_t bytes);

}  // namespace glift::detail
