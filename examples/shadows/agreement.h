// Agreement with rays of all scenes along their paths, as JSON lines.
#pragma once

#include "walk.h"

/// Writes a line for each frame and one for each scene: shares of pixels that decide as the rays do, off a band of one
/// pixel around true edges of shadows, by RMSM, ASM and the standard map. Prints a table. Where `pictures` names a
/// folder, it gets for each scene and method the frame that agrees least: the method's picture, the rays' and red where
/// they differ.
void measure_agreement(const Walk& walk, const std::string& json, const std::string& pictures);
