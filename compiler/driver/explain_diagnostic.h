// `gliftc explain ID`: prints the text of the diagnostic with this id (`unknown-name`, for instance) and an example.
#pragma once

#include "driver/options.h"

namespace gliftc {

/// Whether `gliftc explain` has one argument that is meant as the id of a diagnostic, not as a file: it is not '-', has
/// no '.' and no '/', and no file of that name exists.
bool names_diagnostic(const Options& options);

/// Prints the diagnostic's text and its example, which is its test in tests/errors. Returns the exit code.
int explain_diagnostic(const Options& options);

}  // namespace gliftc
