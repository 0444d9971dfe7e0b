/// @file bounds.h
/// An axis-parallel box round what is drawn.
#pragma once

#include <Eigen/Geometry>

#include "sinew/base/vec.h"

namespace sinew {

/// Starts empty (isEmpty()); grows with extend().
using Bounds = Eigen::AlignedBox3f;

}  // namespace sinew
