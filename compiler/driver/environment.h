// Errors of the environment, rather than of the program or of gliftc.
#pragma once

#include <stdexcept>

namespace gliftc {

/// A file or program that a command needs is missing, a file cannot be written, or a process cannot be started. The
/// text says which, and often what to do about it.
struct EnvironmentError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace gliftc
