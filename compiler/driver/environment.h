// What is wrong with the machine rather than with the program or with gliftc.
#pragma once

#include <stdexcept>

namespace gliftc {

/// A file or a program that a command needs is not there, or cannot be written. The text says what to do.
struct EnvironmentError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace gliftc
