/// @file usda_place.h
/// Where a USD prim stands: its transform operations and their order.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sinew/base/vec.h"

namespace sinew {

struct UsdaPlace {
    std::map<std::string, std::vector<double>, std::less<>>
        operations;                  ///< the numbers of each xformOp, by its whole name
    std::vector<std::string> order;  ///< xformOpOrder
};

/// The matrix from the prim to its parent (to the world, where the order resets the stack: `resets`). Nothing
/// where an operation is unknown, or does not have the numbers it needs.
std::optional<Eigen::Matrix4d> matrix_of(const UsdaPlace& place, bool& resets);

}  // namespace sinew
