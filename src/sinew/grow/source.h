/// @file source.h
/// The text of a .lsys file, and places in it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/base/result.h"

namespace sinew::lsystem {

/// A part of the source, by the offset of its first byte. Kept with everything that can be wrong later.
struct Text {
    std::string text;
    std::size_t offset = 0;

    bool empty() const { return text.empty(); }
};

/// The source with comments and line ends blanked out; every byte stays at its offset.
class Source {
  public:
    Source() = default;
    Source(std::string_view text, std::string name);

    const std::string& text() const { return text_; }
    const std::string& name() const { return name_; }
    /// Line as it was written, without its comment.
    std::string_view line(std::size_t index) const;
    std::string_view remark(std::size_t index) const {
        return remarks_[index];
    }  ///< what follows its #, trimmed
    std::size_t line_count() const { return starts_.size(); }
    std::size_t line_of(std::size_t offset) const;  ///< 0-based
    std::size_t start_of(std::size_t index) const { return starts_[index]; }

    /// An error of kind input at a place, with file, line and column.
    tl::unexpected<Error> error(std::size_t offset, std::string message, std::string cure = {}) const;

  private:
    std::string name_, text_;
    std::vector<std::size_t> starts_;
    std::vector<std::string> remarks_;
};

/// What stands at an offset, for "found ..." in messages: a word, a number, a character, or "the end of the
/// line".
std::string found_at(std::string_view text, std::size_t offset);

}  // namespace sinew::lsystem
