/// @file cursor.h
/// A place in one statement of a .lsys file that moves on as parts of the statement are recognised.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sinew/grow/source.h"

namespace sinew::lsystem {

/// Offsets are those of the whole source. Once something was not as expected, error() says what and where.
class Cursor {
  public:
    Cursor(const Source& source, std::size_t begin, std::size_t end)
        : source_(source), at_(begin), end_(end) {
        skip_space();
    }

    bool at_end() const { return at_ >= end_; }
    char peek(std::size_t ahead = 0) const { return at_ + ahead < end_ ? source_.text()[at_ + ahead] : '\0'; }
    std::string_view rest() const { return std::string_view(source_.text()).substr(at_, end_ - at_); }
    std::size_t offset() const { return at_; }
    void advance(std::size_t count) { at_ += count, skip_space(); }
    /// Moves past `word` if it stands here.
    bool accept(std::string_view word);
    /// A name: a letter or _, then letters, digits and _. Empty if none stands here.
    Text name();
    /// Everything up to the first of `stops` outside parentheses, or to the end of the statement.
    Text formula(std::string_view stops);
    /// Everything up to an offset, without spaces at its end.
    Text until(std::size_t offset);

    /// Notes `expected ..., found ...` here. Returns false, so that `return cursor.expected("...")` reads
    /// well.
    bool expected(std::string_view what, std::string cure = {});
    bool wrong(std::size_t offset, std::string message, std::string cure = {});
    bool wrong(Error error);
    const std::optional<Error>& error() const { return error_; }

  private:
    void skip_space() {
        while (at_ < end_ && source_.text()[at_] == ' ') ++at_;
    }

    const Source& source_;
    std::size_t at_, end_;
    std::optional<Error> error_;
};

}  // namespace sinew::lsystem
