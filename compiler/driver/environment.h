// Errors of the environment, rather than of the program or of gliftc.
#pragma once

#include <stdexcept>

namespace gliftc {

/// A file or program that a command needs is missing, or a file cannot be written. The text says which, and usually
/// what to do about it.
struct EnvironmentError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace gliftc
