// Finds which importable module declares a name, for notes at errors about unknown names: "module std.reduce has it".
#pragma once

#include "driver/file_system.h"
#include "driver/options.h"

#include <string>
#include <string_view>
#include <vector>

namespace gliftc {

/// The first module, as `use` names it, that declares the name as public. Looks in the folders of the standard library,
/// then beside the files on the command line, then in the folders given by -I. The files are not parsed, but searched
/// for lines that begin with `pub WORD name`. Empty if there is no such module.
std::string module_with_declaration(const Options& options, const FileSystem& files, std::string_view name);

/// A public declaration of a module that could be imported.
struct PublicName {
    std::string module;  ///< as `use` names it
    std::string word;    ///< the word before the name: fn, structure, kernel, …
    std::string name;
};

/// The public declarations whose names begin with `prefix`, of the modules in which module_with_declaration() looks.
std::vector<PublicName> public_names(const Options& options, const FileSystem& files, std::string_view prefix);

/// The modules that could be imported, as `use` names them.
std::vector<std::string> importable_modules(const Options& options, const FileSystem& files);

}  // namespace gliftc
