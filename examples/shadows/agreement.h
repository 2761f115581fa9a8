// How far shadows agree with rays, for scenes along their recorded paths, as JSON lines.
#pragma once

#include "walk.h"

/// Writes a line for each frame and one for each scene: by each method (RMSM, ASM, standard: see Method), the share of
/// pixels that are lit or shadowed as rays say, outside a band of one pixel around true edges of shadows. Prints a
/// table. If `pictures` names a folder, it gets for each scene and method the frame that agrees least: the method's
/// picture, the rays' picture, and one that shows where they differ (Compared::differences).
void measure_agreement(const Walk& walk, const std::string& json, const std::string& pictures);
