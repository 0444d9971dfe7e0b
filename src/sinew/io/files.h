/// @file files.h
/// Files in one piece: a read gives all bytes or an Error, a write leaves the new file whole or the old one
/// as it was.
#pragma once

#include <string>
#include <string_view>

#include "sinew/base/result.h"

namespace sinew {

/// All bytes of a file; "-" is standard input. Fails where the file is missing, a folder, unreadable or too
/// large for the memory; the Error names the file and the reason.
Result<std::string> read_file(const std::string& path);

/// Replaces a file by `contents`; "-" is standard output.
///
/// The bytes go to a hidden file beside the target, are flushed to the disk and renamed over it, so that
/// whatever fails (a full disk, a folder that cannot be written) the old file stays whole and nothing else is
/// left. A symbolic link stays one: the file that it points to is replaced, and the permissions of that file
/// are kept. What is no regular file (a pipe, /dev/null) is written to directly.
Result<void> write_file(const std::string& path, std::string_view contents);

/// The file name for messages: the path, or "standard input" for "-".
std::string input_name(const std::string& path);

/// The extension in lower case with its dot (".swc"); empty where there is none.
std::string extension_of(std::string_view path);

}  // namespace sinew
