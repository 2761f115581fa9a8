// Semantic analysis: from syntax trees to the resolved, instantiated program.
#pragma once

#include "base/name.h"
#include "diag/diagnostics.h"
#include "ir/ir.h"
#include "source/source.h"
#include "syntax/ast.h"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gliftc::sema {

struct Settings {
    /// `-D name=value`: constants of the root modules whose value is replaced.
    std::vector<std::pair<std::string, std::string>> defines;
    /// Makes kernels that copy the structures which translators read to the host: `gliftc test` checks translators with
    /// them.
    bool looks_into_tables = false;
    /// The name of a module that is not loaded and declares this public name, or "". For messages.
    std::function<std::string(std::string_view name)> module_with;
};

/// A parsed module and how it was found.
struct LoadedModule {
    const ast::Module* tree = nullptr;
    bool is_root = false;             ///< named on the command line
    std::vector<std::uint32_t> uses;  ///< for each tree->uses[i]: its index in the list, or ~0u where it was not found
};

/// The module whose structure and kernels move boxes of elements between host and device; the loader always loads it.
inline constexpr std::string_view transfer_module = "std.transfer";

/// Checks all modules (imports before importers). Kernels, pipelines, tests and public structures of root modules are
/// instantiated, everything else as they need it. Errors go to `diagnostics`; the program is complete only if there are
/// none.
ir::Program check(const std::vector<LoadedModule>& modules, const ast::Tree& tree, Names& names,
                  Diagnostics& diagnostics, const Settings& settings = {});

}  // namespace gliftc::sema
