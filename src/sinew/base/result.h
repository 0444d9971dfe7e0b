/// @file result.h
/// Errors are values. Every function that can fail returns a Result; no exception crosses the library's
/// surface.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace sinew {

/// Whose fault it is; the command line turns this into its exit status (1, 2, 3, and 3 again).
enum class ErrorKind : std::uint8_t {
    input,      ///< a file or document is bad: status 1
    call,       ///< the call is wrong (an option, a file name, a place that is full): status 2
    program,    ///< the program or the machine is at fault (no memory, no EGL): status 3
    cancelled,  ///< the caller asked to stop through Progress
};

/// What is wrong, where, and what to do about it. Unknown places stay empty.
struct Error {
    ErrorKind kind = ErrorKind::input;
    std::string message;               ///< what is wrong, a sentence without a full stop
    std::string cure;                  ///< what to do, likewise; may be empty
    std::string file;                  ///< file name as the user gave it
    std::int64_t line = 0;             ///< 1-based line, 0 where it is unknown
    std::int64_t column = 0;           ///< 1-based column in that line (bytes), 0 where it is unknown
    std::string path;                  ///< JSON pointer, such as /nodes/3/radius
    std::optional<std::int64_t> node;  ///< id of the node as the file has it

    /// One line for people: `file:line:column: path: node 7: message; cure`, without the parts that are
    /// unknown.
    std::string text() const;
};

/// A remark that does not stop the work: one a kind, with how often it was met.
struct Warning {
    std::string message;     ///< for people, with the count already in it
    std::int64_t count = 1;  ///< how many places it stands for
    std::vector<std::int64_t>
        nodes;  ///< ids of some of the nodes it speaks of (at most 16), for a click in a list
};
using Warnings = std::vector<Warning>;

template <class T>
using Result = tl::expected<T, Error>;

/// `return fail(ErrorKind::input, "...")` from any function that returns a Result.
inline tl::unexpected<Error> fail(Error error) { return tl::unexpected<Error>(std::move(error)); }
inline tl::unexpected<Error> fail(ErrorKind kind, std::string message, std::string cure = {}) {
    return fail(Error{.kind = kind, .message = std::move(message), .cure = std::move(cure)});
}

}  // namespace sinew
