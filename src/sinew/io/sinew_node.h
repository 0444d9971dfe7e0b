/// @file sinew_node.h
/// A node of the native format. For the sources of this folder only.
#pragma once

#include <string>

#include "sinew/io/json_text.h"
#include "sinew/skeleton/document.h"

namespace sinew {

struct SinewNode {
    Node node;                    ///< but for its parent
    std::int64_t parent_id = -1;  ///< -1 for a root
    std::string name;
    std::string unknown;  ///< the keys that this version does not know, as JSON object text; empty where
                          ///< there are none
};

/// Reads entry `index` of the array of nodes. Fails for a missing key and for a value of the wrong type.
Result<SinewNode> read_sinew_node(const Json& object, std::size_t index);

}  // namespace sinew
