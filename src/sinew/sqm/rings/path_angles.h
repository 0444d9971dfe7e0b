/// @file path_angles.h
/// How the rings of a path are turned. Internal to the stations.
#pragma once

#include "sinew/sqm/rings/path_work.h"

namespace sinew::sqm {

/// Turns the rings' frames along the path, spreads its columns and the twist, and writes its angles, shift
/// and corners.
void find_angles(PathWork& work);

}  // namespace sinew::sqm
