// The commands of gliftc, one function for each, which returns the exit code; and functions that they share.
#pragma once

#include "driver/options.h"

namespace gliftc {

struct Compilation;

/// `gliftc FILE`: compiles, and writes the outputs.
int run_compile(const Options& options);

/// `gliftc test FILE`: builds the tests with the system's C++ compiler and runs them.
int run_tests(const Options& options);

/// `gliftc watch FILE`: whenever a file is saved, builds its kernels and pipelines as a library for running programs
/// (glift/reload.h). Returns only after errors of the surroundings, such as a missing C++ compiler, which it throws.
int run_watch(const Options& options);

/// `gliftc explain FILE`: prints what is known of translators, structures and draws. `gliftc explain ID`: prints what a
/// diagnostic means.
int run_explain(const Options& options);

/// `gliftc fmt FILE`: rewrites files in the canonical format; `-` is standard input, formatted to standard output. With
/// --check, lists the files that are not formatted. A file that cannot be read or does not parse is an error; the other
/// files are formatted all the same.
int run_format(const Options& options);

/// `gliftc new NAME`: makes a folder with a project. Wrong usage if there is such a folder or file already, or the name
/// cannot be that of a module and a target of CMake.
int make_project(const Options& options);

/// Sets which warnings are reported, which are errors, and the error limit.
void configure(Diagnostics& diagnostics, const Options& options);

/// Prints all diagnostics to standard error in the format of the options. Returns the exit code: source_errors if there
/// are errors, else done.
int report(const Compilation& compilation, const Options& options);

}  // namespace gliftc
