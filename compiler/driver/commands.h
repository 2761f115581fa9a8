// The commands of gliftc, a function each, which returns the exit code, and what they share.
#pragma once

#include "driver/options.h"

namespace gliftc {

struct Compilation;

/// `gliftc FILE`: compiles, and writes the outputs.
int run_compile(const Options& options);

/// `gliftc test FILE`: builds the tests with the system's C++ compiler and runs them.
int run_tests(const Options& options);

/// `gliftc explain FILE`: prints what is known of translators, structures and draws. `gliftc explain ID`: prints what a
/// diagnostic means.
int run_explain(const Options& options);

/// `gliftc fmt FILE`: rewrites files in the canonical format, `-` to standard output; with --check, lists those that
/// are not in it. A file that cannot be read or does not parse is an error, and the others are done.
int run_format(const Options& options);

/// Sets which warnings are reported, which are errors, and the error limit.
void configure(Diagnostics& diagnostics, const Options& options);

/// Prints all diagnostics to standard error in the format of the options. Returns the exit code: whether there are
/// errors.
int report(const Compilation& compilation, const Options& options);

}  // namespace gliftc
