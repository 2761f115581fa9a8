#include "lsp/features.h"
#include "lsp/uses.h"

#include <algorithm>

namespace gliftc::lsp {

nlohmann::json references(Workspace& workspace, const nlohmann::json& params) {
    const Place place = place_in(workspace, params);
    nlohmann::json locations = nlohmann::json::array();
    if (place.token == nullptr || !is_name(*place.token)) return locations;
    const std::vector<Declared> declared = declared_by(place.analysis, *place.token);
    if (declared.empty()) return locations;
    const bool with_declaration = params.contains("context") && params["context"].is_object() &&
                                  params["context"].value("includeDeclaration", true);
    const std::string name(place.analysis.text(*place.token));
    for (const FileUses& uses : uses_of(workspace, declared, name)) {
        for (Span span : uses.names) {
            const bool is_declaration =
                std::ranges::find(declared, Declared{uses.path, span.begin, span.end}) != declared.end();
            if (with_declaration || !is_declaration) locations.push_back(location(workspace, *uses.analysis, span));
        }
    }
    return locations;
}

}  // namespace gliftc::lsp
