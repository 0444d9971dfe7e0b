#include "sinew/grow/cursor.h"

#include <fmt/format.h>

#include <cctype>

namespace sinew::lsystem {

bool Cursor::accept(std::string_view word) {
    if (!rest().starts_with(word)) return false;
    advance(word.size());
    return true;
}

Text Cursor::name() {
    const std::size_t begin = at_;
    const auto in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    if (std::isdigit(static_cast<unsigned char>(peek()))) return {{}, begin};
    while (at_ < end_ && in_name(peek())) ++at_;
    Text result{source_.text().substr(begin, at_ - begin), begin};
    skip_space();
    return result;
}

Text Cursor::formula(std::string_view stops) {
    std::size_t stop = at_;
    for (int depth = 0; stop < end_; ++stop) {
        const char c = source_.text()[stop];
        if (depth == 0 && stops.find(c) != std::string_view::npos) break;
        if (c == '(') ++depth;
        if (c == ')') --depth;
    }
    return until(stop);
}

Text Cursor::until(std::size_t offset) {
    Text result{source_.text().substr(at_, offset - at_), at_};
    result.text.erase(result.text.find_last_not_of(' ') + 1);
    at_ = offset;
    skip_space();
    return result;
}

bool Cursor::expected(std::string_view what, std::string cure) {
    return wrong(at_, fmt::format("expected {}, found {}", what, found_at(rest(), 0)), std::move(cure));
}

bool Cursor::wrong(std::size_t offset, std::string message, std::string cure) {
    return wrong(source_.error(offset, std::move(message), std::move(cure)).value());
}

bool Cursor::wrong(Error error) {
    if (!error_) error_ = std::move(error);
    return false;
}

}  // namespace sinew::lsystem
