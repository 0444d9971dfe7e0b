/// @file field_reader.h
/// Text of lines and fields, as instruments write it. For the sources of this folder only.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sinew/base/result.h"

namespace sinew {

/// Goes through a text line by line (ends: LF, CRLF, CR) and through the fields of a line, which spaces and
/// tabs part. What follows a # is a comment. A byte order mark at the start is skipped.
class FieldReader {
  public:
    explicit FieldReader(std::string_view text);

    /// Goes to the next line that has a field; false at the end of the text.
    bool next_line();
    /// The next field of the line; empty at the line's end.
    std::string_view next_field();

    /// The next field as a number of at most 1e30 in size, or as an integer, which may be written as 1.0.
    /// `name` is for the error.
    Result<double> number(std::string_view name);
    Result<std::int64_t> integer(std::string_view name);

    std::int64_t line() const { return line_; }
    /// An Error at the field read last.
    tl::unexpected<Error> fail_here(std::string message, std::string cure) const;

  private:
    const char* at_;   ///< behind the line
    const char* end_;  ///< of the text
    const char* line_start_;
    const char* line_end_;  ///< or where its comment starts
    const char* field_;     ///< the field read last
    const char* next_;      ///< behind it
    std::int64_t line_ = 0;
};

/// Text from a file for a message: of a bearable length, and without what a terminal might obey.
std::string shown(std::string_view text);

}  // namespace sinew
