/// @file plain_document.h
/// A document reduced to what measured formats carry. For the sources of this folder only.
#pragma once

#include <string_view>

#include "sinew/io/skeleton_file.h"

namespace sinew {

struct PlainDocument {
    Document document;  ///< positions, radii, ids, parents, links and extras matter
    Warnings warnings;  ///< what gets lost, one a kind
};

/// Checks a document, expands its symmetry and takes leave of what the format cannot carry: types and shapes,
/// names, its unit.
Result<PlainDocument> plain_document(const Document& document, std::string_view format);

}  // namespace sinew
