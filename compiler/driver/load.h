// Finds, reads and parses the files of a compilation, all that they import, and sema::transfer_module: the library's
// module of kernels that move elements between host and device.
//
// `use std.a` is <library>/<folder>/a.glift, in the first folder of the library that has it, else <library>/a.glift.
// `use ./a` is a.glift beside the importing file. `use a.b` is a/b.glift beside the importing file, else in the first
// -I folder that has it.
#pragma once

#include "driver/file_system.h"
#include "driver/options.h"
#include "sema/check.h"

#include <deque>
#include <vector>

namespace gliftc {

/// The path of a module's file in the standard library whose folder is `library`; empty if there is none.
std::string find_in_library(const FileSystem& files, const std::string& library, std::string_view module);

/// The folders that hold modules, inside the folder of the standard library.
std::vector<std::string> library_folders_of(const Options& options);

struct LoadedModules {
    std::deque<ast::Module> trees;
    sema::ModuleTable modules;
    std::size_t misnamed = 0;  ///< number of errors about wrong module names; they do not keep sema from
                               ///< running
};

LoadedModules load_modules(const Options& options, const FileSystem& files, Sources& sources, Names& names,
                           ast::Tree& tree, Diagnostics& diagnostics);

}  // namespace gliftc
