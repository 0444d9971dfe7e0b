/// @file extend.h
/// From a document's node types to the plain skeleton that the mesher takes.
#pragma once

#include "sinew/base/result.h"
#include "sinew/extend/plain.h"
#include "sinew/skeleton/condition.h"
#include "sinew/skeleton/document.h"

namespace sinew {

/// A pure function of the document and of its conditioned graph. Fails for node types that cannot be skinned
/// yet, naming the node.
Result<Plain> extend(const Document& document, CleanGraph&& graph);

/// The mirror image of the skeleton in the plane x = 0, y = 0 or z = 0, whichever is the first that maps it
/// onto itself exactly, bones and radii included; order 1 if there is none.
Automorphism find_mirror(const Plain& skeleton);

}  // namespace sinew
