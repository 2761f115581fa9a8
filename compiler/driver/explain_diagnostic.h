// `gliftc explain unknown-name`: prints the text of a diagnostic with an example.
#pragma once

#include "driver/options.h"

namespace gliftc {

/// Whether there is one argument, which can be the id of a diagnostic: it is not '-', has no '.' and no '/', and there
/// is no such file.
bool names_diagnostic(const Options& options);

/// Prints the diagnostic's text and its example, which is its test in tests/errors. Returns the exit code.
int explain_diagnostic(const Options& options);

}  // namespace gliftc
