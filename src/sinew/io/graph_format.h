/// @file graph_format.h
/// Plain graphs: `n x y z r` is a node, numbered from 0 in their order, `c i j` a bone, # starts a comment.
#pragma once

#include <string_view>

#include "sinew/io/skeleton_file.h"

namespace sinew {

/// Reads a graph; a node's id is its number. Trees that span it (breadth first from the lowest node of each
/// component) become parents, the other bones links. More fields than those named are passed over; bones may
/// stand before their nodes. Bones from a node to itself and those given twice are dropped, radii that are
/// not positive repaired, each with a warning. Fails, with the line, for what is no such line, too few
/// fields, numbers that are not finite, bones between nodes that do not exist, and a file without nodes.
Result<ReadSkeleton> parse_graph(std::string_view text, const ReadOptions& options = {});

/// Writes a graph, its symmetry expanded, numbers to the last bit. Warns of what the format cannot carry.
Result<WrittenSkeleton> print_graph(const Document& document);

}  // namespace sinew
