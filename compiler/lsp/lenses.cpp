#include "lsp/features.h"
#include "lsp/positions.h"

namespace gliftc::lsp {

namespace {

nlohmann::json lens(const Analysis& analysis, Span place, const char* title, const char* command,
                    nlohmann::json arguments) {
    return {{"range", range_of(analysis.compilation.sources, place)},
            {"command", {{"title", title}, {"command", command}, {"arguments", std::move(arguments)}}}};
}

}  // namespace

nlohmann::json code_lenses(Workspace& workspace, const nlohmann::json& params) {
    const Analysis& analysis = analysis_in(workspace, params);
    const std::string& path = analysis.compilation.sources[0].path;
    nlohmann::json lenses = nlohmann::json::array();
    for (const Entity& entity : analysis.entities(0)) {
        const Span first{0, entity.written.begin, entity.written.begin};
        if (entity.kind == EntityKind::kernel || entity.kind == EntityKind::raster)
            lenses.push_back(lens(analysis, first, "show GLSL", "glift.showGlsl",
                                  {path, analysis.compilation.names[entity.name.name]}));
        if (entity.kind == EntityKind::test)
            lenses.push_back(lens(analysis, first, "run test", "glift.runTest", {path, entity.title}));
    }
    return lenses;
}

}  // namespace gliftc::lsp
