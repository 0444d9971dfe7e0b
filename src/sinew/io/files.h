/// @file files.h
/// Files in one piece: a read gives all bytes or an Error, a write leaves the new file whole or the old one
/// as it was.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sinew/base/result.h"

namespace sinew {

/// Most bytes that an input may have, alone or with the files that it names.
inline constexpr std::uint64_t largest_input = std::uint64_t{1} << 31;

/// All bytes of a file; "-" is standard input. Fails where the file is missing, a folder or a device (it must be a
/// regular file, a pipe, a socket, a terminal or /dev/null), unreadable, or larger than largest_input or the
/// memory; the Error names the file and the reason.
Result<std::string> read_file(const std::string& path);

/// What is left to read of an open file; nothing where reading fails (errno says why; EFBIG: it has more than
/// `most` bytes). May throw bad_alloc.
std::optional<std::string> read_descriptor(int descriptor, std::uint64_t most);

/// Replaces a file by `contents`; "-" is standard output.
///
/// The bytes go to a hidden file beside the target (".NAME.part"), are flushed to the disk and renamed over it,
/// so that whatever fails (a full disk, a folder that cannot be written) the old file stays whole and nothing
/// else is left. What a killed program left of its hidden file, the next call for the same target removes.
///
/// A symbolic link stays one: the file that it points to is replaced. Its permissions are kept but for the right
/// to run as somebody else, and its owner where that is allowed. A file of several names (hard links) stays one:
/// it is written over, once its new bytes are whole beside it. What is no regular file (a pipe, /dev/null) and what
/// is open already (/dev/stdout, /dev/fd/3) is written to directly, where it stands.
///
/// Fails with kind `call` for what the caller can mend, the place or the room in it; else with `program`.
Result<void> write_file(const std::string& path, std::string_view contents);

/// Does writing to the path go to a pipe, a terminal or the like, or to an open file? Then it may wait for others,
/// and there is nothing to clean up if it is broken off.
bool writes_directly(const std::string& path);

/// The file name for messages: the path, or "standard input" for "-".
std::string input_name(const std::string& path);

/// The extension in lower case with its dot (".swc"); empty where there is none.
std::string extension_of(std::string_view path);

}  // namespace sinew
