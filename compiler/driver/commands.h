// What each command of gliftc does. All return the exit code.
#pragma once

#include "driver/options.h"

namespace gliftc {

struct Compilation;

int run_compile(const Options& options);

/// `gliftc test FILE`: builds the tests with the system's C++ compiler and runs them.
int run_tests(const Options& options);

/// `gliftc explain FILE`: prints the properties inferred of translators and structures.
int run_explain(const Options& options);

/// `gliftc fmt FILE`: rewrites files in the canonical format.
int run_format(const Options& options);

/// Settings of the diagnostics that the options ask for.
void configure(Diagnostics& diagnostics, const Options& options);

/// Prints all diagnostics to standard error as the options ask; returns the exit code that they give.
int report(const Compilation& compilation, const Options& options);

}  // namespace gliftc
