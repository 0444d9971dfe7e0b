/// @file skeleton_formats.h
/// Skeletons from files and into files, whatever their format.
#pragma once

#include <string>

#include "sinew/io/skeleton_file.h"

namespace sinew {

/// Reads a skeleton; "-" is standard input, for which options.format must be set. Fails as read_file,
/// choose_format and the readers of the formats do; the Error names the file.
Result<ReadSkeleton> read_skeleton(const std::string& path, const ReadOptions& options = {});

/// The same for text at hand; `name` is the file's for errors, and its extension the format's unless that is
/// given.
Result<ReadSkeleton> parse_skeleton(std::string_view text, const std::string& name,
                                    const ReadOptions& options = {});

/// Writes a skeleton; "-" is standard output, for which `format` must be set (otherwise the file's extension
/// says it). Returns what the format could not carry. A failure leaves an old file whole.
Result<Warnings> write_skeleton(const Document& document, const std::string& path,
                                const std::string& format = {});

/// The text that would be written.
Result<WrittenSkeleton> print_skeleton(const Document& document, const std::string& path,
                                       const std::string& format = {});

}  // namespace sinew
