// argv to Options.
#pragma once

#include "driver/options.h"

#include <variant>

namespace gliftc {

/// What gliftc returns to the shell.
enum class ExitCode : int { done = 0, source_errors = 1, wrong_usage = 2, internal_error = 3 };

/// The options; or, after --help, --version and wrong usage (all printed), what to exit with.
std::variant<Options, ExitCode> read_command_line(int argc, char** argv);

}  // namespace gliftc
