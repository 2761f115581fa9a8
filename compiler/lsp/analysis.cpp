#include "lsp/analysis.h"

#include "driver/commands.h"
#include "driver/declarations.h"
#include "driver/import_structs.h"
#include "syntax/lexer.h"

#include <algorithm>

namespace gliftc::lsp {

namespace {

/// Runs the stage. If stages before it reported errors, its own diagnostics are dropped: they may only follow from
/// those.
template <class Stage> void run_stage(Compilation& c, const Stage& stage) {
    if (c.diagnostics.error_count() <= c.loaded.misnamed) return stage();
    Diagnostics shown = c.diagnostics;
    c.diagnostics = shown.emptied();
    stage();
    c.diagnostics = std::move(shown);
}

void run_front_end(const Options& options, const FileSystem& files, Analysis& analysis) {
    Compilation& c = analysis.compilation;
    c.loaded = load_modules(options, files, c.sources, c.names, c.tree, c.diagnostics);
    run_stage(c, [&] { import_structs(options, files, c); });
    const bool is_shown = c.diagnostics.error_count() <= c.loaded.misnamed;
    run_stage(c, [&] {
        const auto module_with = [&](std::string_view name) {
            return is_shown ? module_with_declaration(options, files, name) : std::string();
        };
        c.program = sema::check(c.loaded.modules, c.tree, c.names, c.diagnostics,
                                {.defines = options.defines, .module_with = module_with, .index = &analysis.recorded});
    });
}

void lex_document(Analysis& analysis) {
    Diagnostics unused;  // the parser's run has reported the same
    Compilation& c = analysis.compilation;
    if (c.sources.size() > 0) analysis.tokens = lex(0, c.sources, c.names, unused);
}

}  // namespace

std::unique_ptr<Analysis> analyse(const Options& options, const FileSystem& files, const std::string& path) {
    auto analysis = std::make_unique<Analysis>();
    Options own = options;
    own.files = {path};
    configure(analysis->compilation.diagnostics, own);
    try {
        run_front_end(own, files, *analysis);
    } catch (const std::exception& error) {
        analysis->failure = error.what();
        analysis->recorded = {};  // its types are of a program that was not finished
    }
    for (const sema::LoadedModule& module : analysis->compilation.loaded.modules)
        if (module.is_root) analysis->module = module.tree;
    lex_document(*analysis);
    return analysis;
}

const sema::Index& Analysis::index() const {
    if (is_sorted_) return sorted_;
    is_sorted_ = true;
    sorted_ = recorded;
    std::ranges::stable_sort(sorted_.uses, {}, [](const sema::NameUse& use) { return use.name.begin; });
    std::ranges::stable_sort(sorted_.types, {}, [](const sema::TypedSpan& typed) { return typed.span.end; });
    return sorted_;
}

const std::vector<Entity>& Analysis::entities(std::uint32_t file) const {
    auto [found, is_new] = entities_.try_emplace(file);
    if (!is_new) return found->second;
    for (const ast::Module& tree : compilation.loaded.trees)
        if (tree.file == file)
            found->second = entities_of(tree, compilation.tree, compilation.sources[file].text.size());
    return found->second;
}

const Entity* Analysis::entity_at(Span declared) const {
    if (!declared) return nullptr;
    for (const Entity& entity : entities(declared.file))
        if (entity.name.span == declared) return &entity;
    return nullptr;
}

}  // namespace gliftc::lsp
