/// @file gltf_joints.h
/// The skeleton inside a glTF 2.0 file, text or binary.
#pragma once

#include <string_view>

#include "sinew/io/skeleton_file.h"

namespace sinew {

/// Reads the joints of all skins, each joint once and as a child of its nearest ancestor that is a joint too;
/// where there is no skin, the tree of the file's scene. Positions are those of the nodes' global transforms
/// (the pose of the file) in metres, glTF's y being our z; ids are the numbers of glTF's nodes. glTF knows no
/// radii: they are guessed (guess_radii), with a warning. Buffers, images and extensions are not looked at.
///
/// Fails, with the JSON pointer, for what is no glTF 2, nodes that do not exist or are their own ancestors,
/// transforms that are no numbers, and a file without a bone.
Result<ReadSkeleton> parse_gltf(std::string_view bytes, const ReadOptions& options = {});

}  // namespace sinew
