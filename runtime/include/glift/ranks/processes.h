// Ranks that are processes of one host, without MPI: they share memory for their messages.
#pragma once

#include <glift/device.h>
#include <glift/ranks/transport.h>

#include <functional>
#include <memory>

namespace glift::ranks {

/// Runs `body` in `count` processes, which are forked from this one, and returns when all of them have ended. Call it
/// before anything opens a Vulkan device or starts threads. What `body` returns is the exit status of its process; an
/// exception that leaves it is printed, with status 1. Returns the largest exit status. If a rank is killed, or ends
/// with another status than 0, the others are killed after two seconds, and the rank is named on stderr.
GLIFT_API int run_processes(unsigned count, const std::function<int(std::shared_ptr<Transport>)>& body);

/// The device of a rank of run_processes: what GLIFT_DEVICE says if that is neither empty nor `gpu`; else rank k has
/// the k-th GPU. Without a GPU, what Device::open returns.
GLIFT_API Device device_of(const Transport& transport);

}  // namespace glift::ranks
