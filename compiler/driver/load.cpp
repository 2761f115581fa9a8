#include "driver/load.h"

#include "emit/cpp/names.h"
#include "syntax/parser.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <unordered_map>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 4> library_folders{"math", "translators", "structures", "algorithms"};
constexpr std::string_view library_prefix = "std.", extension = ".glift";

std::string as_path(std::string_view dotted) {
    std::string path(dotted);
    std::replace(path.begin(), path.end(), '.', '/');
    return path + std::string(extension);
}

std::string if_there(const FileSystem& files, const fs::path& path) {
    std::string name = path.lexically_normal().generic_string();
    return files.exists(name) ? name : std::string();
}

/// The module name that fits a file: my_file for my-file.glift. `stem` is the file's name without .glift. Dots stay.
std::string module_of_stem(std::string stem) {
    for (char& c : stem) {
        const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
        if (!fits) c = '_';
    }
    return stem;
}

std::string module_of_file(const std::string& name) {
    return module_of_stem(name.substr(0, name.size() - extension.size()));
}

class Loader {
public:
    Loader(const Options& options, const FileSystem& files, Sources& sources, Names& names, ast::Tree& tree,
           Diagnostics& diagnostics)
        : options_(options), files_(files), sources_(sources), names_(names), tree_(tree), diagnostics_(diagnostics) {
        library_ = options.library_folder.empty() ? library_beside_executable() : options.library_folder;
    }

    LoadedModules run() {
        for (const std::string& file : options_.files) {
            if (const ir::ModuleId module = load(file, {}, {})) loaded_.modules[module].is_root = true;
        }
        if (std::string path = find_in_library(sema::transfer_module); !path.empty())
            load(path, {}, std::string(sema::transfer_module));
        return std::move(loaded_);
    }

private:
    struct File {
        bool under_way = true;
        ir::ModuleId module;
    };

    /// The module in the file; loads it if it is new. `use` is the import that names it; `name` the name
    /// that the module must have, or empty. Empty after an error: the file cannot be read, or the module is still
    /// being loaded, since it imports itself, directly or by way of others.
    ir::ModuleId load(const std::string& path, Span use, const std::string& name) {
        std::string shown = path == "-" ? path : fs::path(path).lexically_normal().generic_string();
        auto [entry, is_new] = known_.try_emplace(files_.identity(shown));
        if (!is_new) {
            if (entry->second.under_way) report_cycle(use, name.empty() ? shown : name);
            return entry->second.module;
        }
        ReadResult read = files_.read(path);
        if (!read.error.empty()) {
            diagnostics_.report(Diag::cannot_read, use, {path, read.error});
            entry->second.under_way = false;
            return {};
        }
        std::uint32_t file = sources_.add(path == "-" ? "<stdin>" : shown, std::move(read.text));
        loaded_.trees.push_back(parse(file, sources_, names_, tree_, diagnostics_));
        const ast::Module& module = loaded_.trees.back();
        if (path != "-") check_name(module, shown, name);
        check_unique(module);
        sema::LoadedModule loaded;
        loaded.tree = &module;
        under_way_.push_back(use);
        for (const ast::Use& each : module.uses) loaded.uses.push_back(follow(each, shown));
        under_way_.pop_back();
        if (!names_[module.name.name].starts_with(library_prefix)) loaded.prelude = prelude();
        const ir::ModuleId made = loaded_.modules.add(std::move(loaded));
        known_[files_.identity(shown)] = {false, made};
        return made;
    }

    std::vector<ir::ModuleId> prelude() {
        std::vector<ir::ModuleId> modules;
        for (std::string_view name : sema::prelude_modules)
            if (const std::string path = find_in_library(name); !path.empty())
                if (const ir::ModuleId module = load(path, {}, std::string(name))) modules.push_back(module);
        return modules;
    }

    ir::ModuleId follow(const ast::Use& use, const std::string& from) {
        bool relative = use.path.starts_with("./") || use.path.starts_with("../");
        std::string path = relative ? find_beside(use.path, from) : find_by_name(use.path, from);
        if (!path.empty()) return load(path, use.span, relative ? std::string() : use.path);
        report_missing(use, from);
        return {};
    }

    static fs::path folder_of(const std::string& file) {
        return file == "-" ? fs::path() : fs::path(file).parent_path();
    }

    /// The file at `path`, or else a file of its folder whose module has that name: my-file.glift for my_file.glift.
    std::string if_there(const fs::path& path) const {
        if (std::string found = gliftc::if_there(files_, path); !found.empty()) return found;
        const fs::path folder = path.parent_path();
        for (const std::string& name : files_.list(folder.empty() ? "." : folder.lexically_normal().string()))
            if (name.ends_with(extension) && module_of_file(name) == path.stem().string())
                return gliftc::if_there(files_, folder / name);
        return {};
    }
    std::string find_in_library(std::string_view name) const { return gliftc::find_in_library(files_, library_, name); }

    std::string find_beside(const std::string& path, const std::string& from) const {
        return if_there(folder_of(from) / (path + std::string(extension)));
    }

    std::string find_by_name(const std::string& name, const std::string& from) const {
        if (name.starts_with(library_prefix)) return find_in_library(name);
        std::string path = as_path(name);
        if (std::string found = if_there(folder_of(from) / path); !found.empty()) return found;
        for (const std::string& folder : options_.import_folders)
            if (std::string found = if_there(fs::path(folder) / path); !found.empty()) return found;
        return {};
    }

    /// Reports a module that has another name than the one by which it is imported (`asked`). If it is imported by
    /// path, or is on the command line, `asked` is empty; then the module's name, or its part after the last dot, must
    /// be the name of its file (module_of_stem()); of a file name with dots the part before the first dot is enough.
    void check_name(const ast::Module& module, const std::string& path, const std::string& asked) {
        const std::string& name = names_[module.name.name];
        if (name.empty()) return;
        std::string stem = fs::path(path).filename().string();
        if (stem.ends_with(extension)) stem.resize(stem.size() - extension.size());
        std::string_view last = std::string_view(name).substr(name.rfind('.') + 1);
        const std::string own = module_of_stem(stem);
        bool fits = asked.empty() ? last == own || last == own.substr(0, own.find('.')) || name == own : name == asked;
        if (fits) return;
        const std::size_t before = diagnostics_.error_count();
        auto& error = diagnostics_.report(Diag::module_name, module.name.span, {name, asked.empty() ? stem : asked});
        error.notes.push_back({{},
                               "write 'module " + (asked.empty() ? own.substr(0, own.find('.')) : asked) +
                                   ";', or call the file '" + std::string(last) + std::string(extension) + "'"});
        loaded_.misnamed += diagnostics_.error_count() - before;
    }

    void check_unique(const ast::Module& module) {
        if (!module.name.name) return;
        const std::string& name = names_[module.name.name];
        auto [earlier, is_new] = by_namespace_.try_emplace(cpp::space_of(name), module.name);
        if (is_new) return;
        const ast::Identifier& other = earlier->second;
        if (other.name == module.name.name) {
            auto& error = diagnostics_.report(Diag::duplicate_name, module.name.span, {name});
            error.notes.push_back({other.span, "another file holds this module: give one of them another name"});
        } else {
            auto& error = diagnostics_.report(Diag::module_namespace, module.name.span,
                                              {name, names_[other.name], earlier->first});
            error.notes.push_back({other.span, "this is the other one: give one of them another name"});
        }
    }

    void report_cycle(Span use, const std::string& name) {
        auto& error = diagnostics_.report(Diag::import_cycle, use, {name});
        for (auto step = under_way_.rbegin(); step != under_way_.rend() && *step; ++step)
            error.notes.push_back({*step, "by way of this"});
    }

    void report_missing(const ast::Use& use, const std::string& from) {
        std::vector<std::string> candidates = modules_near(use, from);
        auto& error = diagnostics_.report(Diag::unknown_module, use.span, {use.path});
        std::vector<std::string_view> views(candidates.begin(), candidates.end());
        if (auto meant = did_you_mean(use.path, views); !meant.empty()) {
            error.notes.push_back({{}, "did you mean '" + std::string(meant) + "'?"});
        } else if (use.path.starts_with(library_prefix)) {
            error.notes.push_back({{}, "the standard library is looked for in '" + library_ + "'"});
        } else if (!use.path.starts_with(".")) {
            error.notes.push_back(
                {{}, "it would be '" + as_path(use.path) + "' beside this file or in a folder given by -I"});
        }
    }

    /// Candidates for "did you mean": modules in the library and in the folders that were searched, as `use` names
    /// them.
    std::vector<std::string> modules_near(const ast::Use& use, const std::string& from) const {
        std::vector<std::string> names;
        auto add_folder = [&](const fs::path& folder, const std::string& prefix) {
            for (const std::string& name : files_.list(folder.empty() ? "." : folder.string()))
                if (name.ends_with(extension)) names.push_back(prefix + module_of_file(name));
        };
        for (std::string_view folder : library_folders)
            add_folder(fs::path(library_) / folder, std::string(library_prefix));
        if (use.path.starts_with("./") || use.path.starts_with("../")) {
            std::string prefix = use.path.substr(0, use.path.rfind('/') + 1);
            add_folder((folder_of(from) / prefix).lexically_normal(), prefix);
            return names;
        }
        std::size_t dot = use.path.rfind('.');
        std::string prefix = dot == std::string::npos ? "" : use.path.substr(0, dot + 1);
        std::string below = prefix;
        std::replace(below.begin(), below.end(), '.', '/');
        add_folder(folder_of(from) / below, prefix);
        for (const std::string& folder : options_.import_folders) add_folder(fs::path(folder) / below, prefix);
        return names;
    }

    const Options& options_;
    const FileSystem& files_;
    Sources& sources_;
    Names& names_;
    ast::Tree& tree_;
    Diagnostics& diagnostics_;
    std::string library_;
    LoadedModules loaded_;
    std::unordered_map<std::string, File> known_;
    std::unordered_map<std::string, ast::Identifier> by_namespace_;  ///< the module in each C++ namespace
    std::vector<Span> under_way_;
};

}  // namespace

std::string find_in_library(const FileSystem& files, const std::string& library, std::string_view module) {
    if (library.empty()) return {};
    std::string path = as_path(module.substr(library_prefix.size()));
    for (std::string_view folder : library_folders)
        if (std::string found = if_there(files, fs::path(library) / folder / path); !found.empty()) return found;
    return if_there(files, fs::path(library) / path);
}

std::vector<std::string> library_folders_of(const Options& options) {
    const fs::path library = options.library_folder.empty() ? library_beside_executable() : options.library_folder;
    std::vector<std::string> folders;
    for (std::string_view folder : library_folders) folders.push_back((library / folder).string());
    return folders;
}

LoadedModules load_modules(const Options& options, const FileSystem& files, Sources& sources, Names& names,
                           ast::Tree& tree, Diagnostics& diagnostics) {
    return Loader(options, files, sources, names, tree, diagnostics).run();
}

}  // namespace gliftc
