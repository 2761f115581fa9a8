#include "lsp/features.h"
#include "lsp/names.h"

namespace gliftc::lsp {

nlohmann::json definition(Workspace& workspace, const nlohmann::json& params) {
    const Place place = place_in(workspace, params);
    nlohmann::json locations = nlohmann::json::array();
    if (place.token != nullptr)
        for (Span declared : declarations_of(place.analysis, *place.token))
            locations.push_back(location(workspace, place.analysis, declared));
    return locations;
}

}  // namespace gliftc::lsp
