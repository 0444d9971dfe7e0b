/// @file grow.h
/// Skeletons that grow: an L-system is derived step by step and a turtle walks along the result.
#pragma once

#include "sinew/base/progress.h"
#include "sinew/base/result.h"
#include "sinew/grow/grammar.h"
#include "sinew/grow/options.h"
#include "sinew/skeleton/document.h"

namespace sinew {

/// Grows a grammar. The heading at the start is +z, left is -x; lengths are in the grammar's unit, angles in
/// degrees.
///
/// The document has a node where segments meet and one at each end, never two at one place of a path; ids
/// count from 0 in the order of growth. The same grammar, options and version give the same bytes on every
/// machine. Fails when the skeleton would pass the limit, with the count that it would have reached: exact,
/// and known before anything grows, where neither chance nor context decides; otherwise estimated when the
/// limit is passed. Moves of length 0 make no node and are counted as if they did. Fails too for a radius
/// that is not positive, a result that is not finite, nothing drawn, and a constant that the grammar has not
/// (kind call).
Result<Document> grow(const Grammar& grammar, const GrowOptions& options = {}, const Progress& progress = {});

}  // namespace sinew
