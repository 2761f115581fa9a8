// The machine's memory, which the host device and Vulkan devices that are CPUs share: its size, and how much of it this
// process's devices hold.
#pragma once

#include <cstdint>

namespace glift::detail {

std::uint64_t machine_memory_bytes();  ///< all of it, used or not

/// Counts these bytes as held by this process. False, with nothing counted, if all that is held would exceed the
/// machine's memory, or if these bytes are more than 64 MiB and more than what is available: the operating system might
/// grant them, and kill the process when it touches them.
bool hold_machine_memory(std::uint64_t bytes);
void release_machine_memory(std::uint64_t bytes);

}  // namespace glift::detail
