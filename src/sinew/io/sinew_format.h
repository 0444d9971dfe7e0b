/// @file sinew_format.h
/// The native document: JSON, version 1. docs/format.md describes it, docs/sinew.schema.json states it for
/// programs.
#pragma once

#include <string_view>

#include "sinew/io/skeleton_file.h"

namespace sinew {

/// Reads a document. Errors name line, JSON pointer, node id, what is wrong and the cure: for what is no
/// JSON, no sinew document or one of a newer version; for missing keys and values of the wrong type; and,
/// unless options.validate is false, for what validate() refuses. Unknown keys are kept, in Document::extra
/// and extras.
Result<ReadSkeleton> parse_sinew(std::string_view text, const ReadOptions& options = {});

/// Writes a document, a node a line. Reading it gives the same document again, each number to the last bit,
/// and what was read and is written equals the file it came from as JSON. Fails for what JSON cannot say: a
/// number that is not finite, a parent or a link that does not exist.
Result<WrittenSkeleton> print_sinew(const Document& document);

}  // namespace sinew
