/// @file named_files.h
/// The one rule for files that a file names, such as the buffers of a glTF: a model is not trusted, and has no
/// business with the rest of the disk.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sinew/base/result.h"

namespace sinew {

/// The bytes of the file that `naming_file` refers to by `reference`, a relative URI (RFC 3986) whose escapes
/// such as %20 are decoded first.
///
/// It must lie in the folder of `naming_file` or below it once all links are resolved, be a regular file, and
/// hold at most `most` bytes. What comes from standard input ("-", "standard input", or no name) may name
/// nothing. The Error says which rule is broken, on the account of `naming_file`; it tells neither what else is
/// on the disk nor how large.
Result<std::string> read_named_file(const std::string& naming_file, std::string_view reference,
                                    std::uint64_t most);

}  // namespace sinew
