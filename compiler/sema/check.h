// Semantic analysis: from syntax trees to the resolved, instantiated program.
#pragma once

#include "base/name.h"
#include "diag/diagnostics.h"
#include "ir/ir.h"
#include "source/source.h"
#include "syntax/ast.h"

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gliftc::sema {

struct Index;

struct Settings {
    /// `-D name=value`: names of constants of the root modules, and the values that replace the written ones.
    std::vector<std::pair<std::string, std::string>> defines;
    /// Set for `gliftc test`, which checks translators on the host: the kernels that copy between host and device are
    /// then instantiated also for the structures that translators read, and for those that are the memory of another;
    /// the kernels that list which elements are there are not.
    bool looks_into_tables = false;
    /// Whether `print` and `assert` are compiled in. If not, they are checked, and make no code.
    bool messages = true;
    /// The text of the source at a span, for messages that name expressions as they are written.
    std::function<std::string_view(Span)> source_text;
    /// Gives the name of a module that could be imported and declares this public name, or "". For messages; called
    /// only if no loaded module declares the name as public.
    std::function<std::string(std::string_view name)> module_with;
    /// Receives the meanings of names and expressions (sema/index.h); null: they are not recorded.
    Index* index = nullptr;
};

/// A parsed module, and what the loader knows of it.
struct LoadedModule {
    const ast::Module* tree = nullptr;
    bool is_root = false;  ///< named on the command line
    /// For each tree->uses[i], the module that it names in the table of all modules that check() is given; empty: an
    /// import with an error, which has been reported.
    std::vector<ir::ModuleId> uses;
    std::vector<ir::ModuleId> prelude;  ///< prelude_modules, for modules that are not of the library
};

/// All modules of a run, imported ones before those that import them. Their ids are also those of Program::modules.
using ModuleTable = Table<LoadedModule, ir::Module>;

/// The module with the structure Box and the kernels by which the host moves, fills and lists elements. The loader
/// loads it even if no module imports it.
inline constexpr std::string_view transfer_module = "std.transfer";

/// The modules whose public names are known without an import, where no other declaration has the name.
inline constexpr std::array<std::string_view, 3> prelude_modules = {"std.address", "std.array", "std.copy"};

/// Checks what the root modules declare without generic parameters: first types, translators, constants and aliases of
/// all of them, then functions, kernels, pipelines and tests, each time in the order of the list and of the source;
/// then pipelines and public functions of the structures that have a public name in a root module. Generic
/// declarations, functions with structure parameters, other functions of structures, and what other modules declare are
/// checked where they are used. `modules` has imported modules before those that import them. `tree` receives the
/// functions that call closures. Errors go to `diagnostics`; the program is complete only if there are none.
ir::Program check(const ModuleTable& modules, ast::Tree& tree, Names& names, Diagnostics& diagnostics,
                  const Settings& settings = {});

}  // namespace gliftc::sema
