#include "sinew/grow/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace sinew::lsystem {
namespace {

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r#");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t\r") + 1 - first));
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

}  // namespace

Source::Source(std::string_view text, std::string name) : name_(std::move(name)), text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) std::fill_n(text_.begin(), 3, ' ');
    for (std::size_t start = 0; start <= text_.size();) {
        const std::size_t end = std::min(text_.find('\n', start), text_.size());
        const std::size_t comment = std::min(text_.find('#', start), end);
        starts_.push_back(start);
        remarks_.push_back(trimmed(std::string_view(text_).substr(comment, end - comment)));
        std::fill(text_.begin() + static_cast<std::ptrdiff_t>(comment),
                  text_.begin() + static_cast<std::ptrdiff_t>(std::min(end + 1, text_.size())), ' ');
        start = end + 1;
    }
    std::replace_if(
        text_.begin(), text_.end(), [](char c) { return c == '\t' || c == '\r'; }, ' ');
}

std::string_view Source::line(std::size_t index) const {
    const std::size_t end = index + 1 < starts_.size() ? starts_[index + 1] : text_.size();
    return std::string_view(text_).substr(starts_[index], end - starts_[index]);
}

std::size_t Source::line_of(std::size_t offset) const {
    return static_cast<std::size_t>(std::upper_bound(starts_.begin(), starts_.end(), offset) -
                                    starts_.begin()) -
           1;
}

tl::unexpected<Error> Source::error(std::size_t offset, std::string message, std::string cure) const {
    const std::size_t index = line_of(offset);
    return fail(Error{.message = std::move(message),
                      .cure = std::move(cure),
                      .file = name_,
                      .line = static_cast<std::int64_t>(index) + 1,
                      .column = static_cast<std::int64_t>(offset - starts_[index]) + 1});
}

std::string found_at(std::string_view text, std::size_t offset) {
    if (offset >= text.size() || text[offset] == ' ') return "the end of the line";
    if (static_cast<unsigned char>(text[offset]) < 32 || static_cast<unsigned char>(text[offset]) > 126)
        return fmt::format("the byte 0x{:02x}", static_cast<unsigned char>(text[offset]));
    std::size_t end = offset + 1;
    if (is_word(text[offset]))
        while (end < text.size() && end < offset + 40 && is_word(text[end])) ++end;
    return fmt::format("'{}'", text.substr(offset, end - offset));
}

}  // namespace sinew::lsystem
