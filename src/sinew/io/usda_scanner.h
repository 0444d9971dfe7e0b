/// @file usda_scanner.h
/// The words of a USD text file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/base/result.h"

namespace sinew {

enum class UsdaToken : std::uint8_t {
    end,     ///< of the file
    word,    ///< a name with its namespaces, such as xformOp:translate or points.timeSamples; None, true
    number,  ///< also inf and nan
    text,    ///< a string, without its quotes
    other,   ///< a path in angle brackets, or an asset between at signs
    mark,    ///< one character: ( ) [ ] { } = : , ;
};

/// Walks through a file token by token. Comments and blanks are passed over. What cannot be a token ends the
/// walk: then broken() says so.
class UsdaScanner {
  public:
    explicit UsdaScanner(std::string_view text);

    UsdaToken kind() const { return kind_; }  ///< of the token at hand
    std::string_view token() const { return token_; }
    bool is(char mark) const { return kind_ == UsdaToken::mark && token_[0] == mark; }
    bool broken() const { return broken_; }
    std::int64_t line() const { return line_; }  ///< where the token at hand starts
    std::int64_t column() const { return column_; }

    void next();

    /// Passes over the value at hand: a token, or all from a bracket to the one that closes it. False where
    /// it does not end.
    bool skip_value();

    /// Reads all numbers of the value at hand, however its brackets group them, and passes over it; commas,
    /// strings and the like in it are of no interest. False where it does not end, or holds a number that is
    /// out of range.
    bool read_numbers(std::vector<float>& numbers);
    bool read_numbers(std::vector<double>& numbers);
    bool read_numbers(std::vector<std::int64_t>& numbers);

  private:
    template <class Number, class Scan>
    bool read_all(std::vector<Number>& numbers, const Scan& scan);
    void skip_blanks();
    void take(UsdaToken kind, const char* end);
    void take_quoted(UsdaToken kind, std::string_view quote);
    void fail_here();

    const char* at_;
    const char* end_;
    const char* line_start_;
    std::int64_t line_at_ = 1;  ///< of at_
    UsdaToken kind_ = UsdaToken::end;
    std::string_view token_;
    std::int64_t line_ = 1, column_ = 1;
    bool broken_ = false;
};

}  // namespace sinew
