#include "driver/include_folders.h"

#include "driver/compile.h"

#include <algorithm>
#include <filesystem>
#include <variant>

namespace gliftc {

namespace fs = std::filesystem;

std::vector<std::string> include_folders(const Options& options, const Compilation& compilation) {
    std::vector<std::string> folders;
    const auto also = [&](const fs::path& folder) {
        std::string text = fs::absolute(folder).string();
        if (std::ranges::find(folders, text) == folders.end()) folders.push_back(std::move(text));
    };
    for (const std::string& file : options.files) also(fs::absolute(file).parent_path());
    for (const ast::Decl& decl : compilation.tree.decls) {
        const auto* record = std::get_if<ast::Struct>(&decl.body);
        if (record && !record->extern_header.empty())
            also(fs::absolute(compilation.sources[decl.name.span.file].path).parent_path());
    }
    for (const std::string& folder : options.import_folders) also(folder);
    return folders;
}

}  // namespace gliftc
