/// @file load.h
/// Opening documents that may not be perfect: what can be edited is opened, and the problems panel says what
/// is wrong.
#pragma once

#include <string>

#include "sinew/base/result.h"
#include "sinew/io/skeleton_file.h"

namespace sinew::modeler {

/// Reads a skeleton of any format. A document that validate() refuses is opened all the same if it can be
/// edited: problems() says what is wrong with it, for as long as it is. File names of reference pictures are
/// absolute then.
Result<ReadSkeleton> load(const std::string& path);

/// Fails where a tool could not even walk over it: parents in a circle, figures that are not finite, no
/// radius.
Result<void> can_be_edited(const Document& document);

/// The nodes of `more` beside those of `document`: new ids where they are taken, links and names kept. The
/// symmetry of the added one is dropped unless the document is empty.
Document added(Document document, const Document& more);

}  // namespace sinew::modeler
