#include "driver/declarations.h"

#include "driver/load.h"

#include <algorithm>
#include <filesystem>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

bool is_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

/// The word and the name in a line that begins with `pub WORD NAME`; empty ones in other lines.
struct Declared {
    std::string_view word, name;
};

Declared declared_in(std::string_view line) {
    constexpr std::string_view begin = "pub ";
    if (!line.starts_with(begin)) return {};
    line.remove_prefix(begin.size());
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos) return {};
    const std::string_view rest = line.substr(space + 1);
    return {line.substr(0, space),
            rest.substr(0, static_cast<std::size_t>(std::ranges::find_if_not(rest, is_word) - rest.begin()))};
}

/// Calls visit(declared) for each line that declares a public name. The text is not parsed, so that files with syntax
/// errors count, too.
template <class Visit> void for_each_declaration(const std::string& text, const Visit& visit) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const Declared declared = declared_in(std::string_view(text).substr(begin, end - begin));
        if (!declared.name.empty()) visit(declared);
        begin = end + 1;
    }
}

bool has_declaration(const std::string& text, std::string_view name) {
    bool has = false;
    for_each_declaration(text, [&](const Declared& declared) { has |= declared.name == name; });
    return has;
}

/// A module that could be imported, and its file.
struct Importable {
    std::string module, path;
};

void add_folder(const FileSystem& files, const fs::path& folder, const std::string& prefix,
                std::vector<Importable>& modules) {
    constexpr std::string_view extension = ".glift";
    for (const std::string& file : files.list(folder.empty() ? "." : folder.string()))
        if (file.ends_with(extension))
            modules.push_back({prefix + file.substr(0, file.size() - extension.size()), (folder / file).string()});
}

std::vector<Importable> importables(const Options& options, const FileSystem& files) {
    std::vector<Importable> modules;
    if (!files.list) return modules;
    for (const std::string& folder : library_folders_of(options)) add_folder(files, folder, "std.", modules);
    for (const std::string& file : options.files)
        if (file != "-") add_folder(files, fs::path(file).parent_path(), "", modules);
    for (const std::string& folder : options.import_folders) add_folder(files, folder, "", modules);
    return modules;
}

}  // namespace

std::string module_with_declaration(const Options& options, const FileSystem& files, std::string_view name) {
    for (const Importable& each : importables(options, files))
        if (has_declaration(files.read(each.path).text, name)) return each.module;
    return {};
}

std::vector<PublicName> public_names(const Options& options, const FileSystem& files, std::string_view prefix) {
    std::vector<PublicName> names;
    for (const Importable& each : importables(options, files)) {
        const std::string text = files.read(each.path).text;
        for_each_declaration(text, [&](const Declared& declared) {
            if (declared.name.starts_with(prefix))
                names.push_back({each.module, std::string(declared.word), std::string(declared.name)});
        });
    }
    return names;
}

std::vector<std::string> importable_modules(const Options& options, const FileSystem& files) {
    std::vector<std::string> names;
    for (const Importable& each : importables(options, files)) names.push_back(each.module);
    return names;
}

}  // namespace gliftc
