#include "sinew/io/usda_scanner.h"

#include "sinew/io/text_numbers.h"

namespace sinew {
namespace {

bool is_decimal(char c) { return c >= '0' && c <= '9'; }
bool begins_word(char c) {
    // Names may hold any letter beyond ASCII, too.
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}
bool continues_word(char c) { return begins_word(c) || is_decimal(c) || c == ':' || c == '.'; }

}  // namespace

UsdaScanner::UsdaScanner(std::string_view text)
    : at_(text.data()), end_(text.data() + text.size()), line_start_(text.data()) {
    next();
}

void UsdaScanner::skip_blanks() {
    while (at_ < end_) {
        if (*at_ == '\n') {
            ++at_;
            ++line_at_;
            line_start_ = at_;
        } else if (*at_ == ' ' || *at_ == '\t' || *at_ == '\r') {
            ++at_;
        } else if (*at_ == '#') {
            while (at_ < end_ && *at_ != '\n') ++at_;
        } else {
            return;
        }
    }
}

void UsdaScanner::take(UsdaToken kind, const char* end) {
    kind_ = kind;
    token_ = {at_, static_cast<std::size_t>(end - at_)};
    at_ = end;
}

void UsdaScanner::fail_here() {
    broken_ = true;
    at_ = end_;
    kind_ = UsdaToken::end;
    token_ = {};
}

void UsdaScanner::take_quoted(UsdaToken kind, std::string_view quote) {
    at_ += quote.size();
    const char* end = at_;
    for (;; ++end) {
        const std::string_view rest(end, static_cast<std::size_t>(end_ - end));
        if (rest.empty() || (quote.size() == 1 && rest[0] == '\n')) return fail_here();
        if (rest.starts_with(quote)) break;
        if (rest[0] == '\\' && rest.size() > 1 && kind == UsdaToken::text) ++end;
        if (*end == '\n') {
            ++line_at_;
            line_start_ = end + 1;
        }
    }
    take(kind, end);
    at_ += quote.size();
}

void UsdaScanner::next() {
    skip_blanks();
    line_ = line_at_;
    column_ = at_ - line_start_ + 1;
    if (at_ == end_) return take(UsdaToken::end, at_);
    const char c = *at_;
    const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
    if (std::string_view("()[]{}=:,;").find(c) != std::string_view::npos)
        return take(UsdaToken::mark, at_ + 1);
    for (const std::string_view quote : {"\"\"\"", "'''", "\"", "'"})
        if (rest.starts_with(quote)) return take_quoted(UsdaToken::text, quote);
    for (const std::string_view quote : {"@@@", "@"})
        if (rest.starts_with(quote)) return take_quoted(UsdaToken::other, quote);
    if (c == '<') {
        const std::size_t close = rest.find_first_of(">\n");
        return close < rest.size() && rest[close] == '>' ? take(UsdaToken::other, at_ + close + 1)
                                                         : fail_here();
    }
    double unused = 0;
    if (begins_word(c)) {
        const char* end = at_;
        while (end < end_ && continues_word(*end)) ++end;
        const std::string_view word(at_, static_cast<std::size_t>(end - at_));
        return take(word == "inf" || word == "nan" ? UsdaToken::number : UsdaToken::word, end);
    }
    if (const char* end = scan_double(at_, end_, unused)) return take(UsdaToken::number, end);
    fail_here();
}

bool UsdaScanner::skip_value() {
    std::size_t depth = 0;
    do {
        if (kind_ == UsdaToken::end) return false;
        if (is('(') || is('[') || is('{')) ++depth;
        if (is(')') || is(']') || is('}')) {
            if (depth == 0) return false;
            --depth;
        }
        const bool asset = kind_ == UsdaToken::other && token_.substr(0, 1) != "<";
        next();
        // An asset may be followed by a path in it.
        if (depth == 0 && asset && kind_ == UsdaToken::other && token_.starts_with('<')) next();
    } while (depth > 0);
    return true;
}

template <class Number, class Scan>
bool UsdaScanner::read_all(std::vector<Number>& numbers, const Scan& scan) {
    std::size_t depth = 0;
    do {
        if (kind_ == UsdaToken::end) return false;
        if (is('(') || is('[') || is('{')) ++depth;
        if (is(')') || is(']') || is('}')) {
            if (depth == 0) return false;
            --depth;
        }
        if (kind_ == UsdaToken::number) {
            Number value{};
            if (scan(token_.data(), token_.data() + token_.size(), value) != token_.data() + token_.size())
                return false;
            numbers.push_back(value);
        }
        next();
    } while (depth > 0);
    return true;
}

bool UsdaScanner::read_numbers(std::vector<float>& numbers) { return read_all(numbers, scan_float); }
bool UsdaScanner::read_numbers(std::vector<double>& numbers) { return read_all(numbers, scan_double); }
bool UsdaScanner::read_numbers(std::vector<std::int64_t>& numbers) { return read_all(numbers, scan_integer); }

}  // namespace sinew
