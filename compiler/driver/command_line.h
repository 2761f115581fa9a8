// Parses the command line.
#pragma once

#include "driver/options.h"

#include <variant>

namespace gliftc {

/// What gliftc returns to the shell.
enum class ExitCode : int {
    done = 0,
    source_errors = 1,  ///< or a failed test, or a file that cannot be read; fmt --check: a file is not formatted
    wrong_usage = 2,
    internal_error = 3,
    environment = 4,  ///< EnvironmentError, such as: an output cannot be written, `gliftc test` finds no C++ compiler
};

/// The options; or the exit code after --help, --version and wrong usage, whose text has been printed.
std::variant<Options, ExitCode> read_command_line(int argc, char** argv);

}  // namespace gliftc
