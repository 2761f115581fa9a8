// argv to Options.
#pragma once

#include "driver/options.h"

#include <variant>

namespace gliftc {

/// What gliftc returns to the shell.
enum class ExitCode : int {
    done = 0,
    source_errors = 1,  ///< or tests that fail
    wrong_usage = 2,
    internal_error = 3,
    environment = 4,  ///< a file that cannot be written, no C++ compiler for `gliftc test`
};

/// The options; or, after --help, --version and wrong usage (all printed), what to exit with.
std::variant<Options, ExitCode> read_command_line(int argc, char** argv);

}  // namespace gliftc
