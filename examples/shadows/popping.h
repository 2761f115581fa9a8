// Popping: how much the light of pixels changes from frame to frame where nothing truly changes.
#pragma once

#include "walk.h"

/// Along slow paths of the camera over scenes that stand still: of each pair of frames that follow one another, the
/// share of pixels whose light changes by more than a half, and the change that 99.9 % of the pixels stay within, by
/// RMSM, ASM and the standard map. Only pixels count that rays find lit in both frames, or shadowed in both, outside a
/// band of one pixel around true edges of shadows. Writes a line for each pair and one for each scene, and prints a
/// table. If `pictures` names a folder, it gets for each scene and method the pair with the most changes.
void measure_popping(const Walk& walk, const std::string& json, const std::string& pictures);
