#include "ir/raster.h"

namespace gliftc::ir {

std::vector<Id<Local>> given_locals(const Raster& raster) {
    std::vector<Id<Local>> all{raster.place};
    all.insert(all.end(), raster.clip_distances.begin(), raster.clip_distances.end());
    for (const Varying& varying : raster.varyings) all.insert(all.end(), {varying.written, varying.read});
    for (const ColourTarget& target : raster.colours) all.push_back(target.value);
    if (raster.depth) all.push_back(raster.depth->value);
    return all;
}

}  // namespace gliftc::ir
