#include "driver/declarations.h"

#include "driver/load.h"

#include <filesystem>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

bool is_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

/// Whether a line begins with `pub WORD name`.
bool declares(std::string_view line, std::string_view name) {
    if (!line.starts_with("pub ")) return false;
    const std::size_t space = line.find(' ', 4);
    if (space == std::string_view::npos) return false;
    const std::string_view rest = line.substr(space + 1);
    return rest.starts_with(name) && (rest.size() == name.size() || !is_word(rest[name.size()]));
}

/// Whether some line of the text begins with `pub WORD name`. The text is not parsed, so that files with syntax errors
/// count, too.
bool has_declaration(const std::string& text, std::string_view name) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (declares(std::string_view(text).substr(begin, end - begin), name)) return true;
        begin = end + 1;
    }
    return false;
}

std::string in_folder(const FileSystem& files, const fs::path& folder, const std::string& prefix,
                      std::string_view name) {
    constexpr std::string_view extension = ".glift";
    for (const std::string& file : files.list(folder.empty() ? "." : folder.string())) {
        if (!file.ends_with(extension)) continue;
        if (has_declaration(files.read((folder / file).string()).text, name))
            return prefix + file.substr(0, file.size() - extension.size());
    }
    return {};
}

}  // namespace

std::string module_with_declaration(const Options& options, const FileSystem& files, std::string_view name) {
    if (!files.list) return {};
    for (const std::string& folder : library_folders_of(options))
        if (std::string found = in_folder(files, folder, "std.", name); !found.empty()) return found;
    for (const std::string& file : options.files) {
        if (file == "-") continue;
        if (std::string found = in_folder(files, fs::path(file).parent_path(), "", name); !found.empty()) return found;
    }
    for (const std::string& folder : options.import_folders)
        if (std::string found = in_folder(files, folder, "", name); !found.empty()) return found;
    return {};
}

}  // namespace gliftc
