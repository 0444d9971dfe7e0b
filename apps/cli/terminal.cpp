#include "cli/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace sinew::cli {
namespace {

using namespace std::chrono_literals;
constexpr auto patience = 300ms;  // work that is done sooner shows no bar
constexpr auto refresh = 100ms;
constexpr int bar_width = 30;

// https://no-color.org
bool wants_colours() {
    const char* no_colour = std::getenv("NO_COLOR");
    const std::string_view kind = std::getenv("TERM") ? std::getenv("TERM") : "";
    return !(no_colour && *no_colour) && !kind.empty() && kind != "dumb";
}

/// The bytes of the UTF-8 character (RFC 3629) at the start of a text, and its code; 0 bytes where there is none.
std::pair<std::size_t, char32_t> first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char head = byte(0);
    const std::size_t length = head < 0x80                   ? 1
                               : head >= 0xc2 && head < 0xe0 ? 2
                               : head >= 0xe0 && head < 0xf0 ? 3
                               : head >= 0xf0 && head < 0xf5 ? 4
                                                             : 0;
    if (length == 0 || length > text.size()) return {0, 0};
    char32_t code = length == 1 ? head : head & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {0, 0};
        code = code << 6 | (byte(i) & 0x3fu);
    }
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    if (code < least[length] || code > 0x10ffff || surrogate) return {0, 0};
    return {length, code};
}

/// Terminals obey control characters, also those from 0x80 on, and follow marks of direction.
bool is_obeyed(char32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x61c || code == 0x200e ||
           code == 0x200f || (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

/// Without the middle, where it is too long. Cuts between characters.
std::string shortened(const std::string& line) {
    if (line.size() <= longest_line) return line;
    const auto inside = [&](std::size_t at) { return (static_cast<unsigned char>(line[at]) & 0xc0) == 0x80; };
    std::size_t head = longest_line * 2 / 3, tail = line.size() - longest_line / 3;
    while (head > 0 && inside(head)) --head;
    while (tail < line.size() && inside(tail)) ++tail;
    return line.substr(0, head) + " [...] " + line.substr(tail);
}

}  // namespace

std::string printable(std::string_view text, bool lines) {
    std::string all, line;
    while (!text.empty()) {
        if (lines && text[0] == '\n') {
            all += shortened(line) + "\n";
            line.clear();
            text.remove_prefix(1);
            continue;
        }
        const auto [length, code] = first_character(text);
        if (length == 0)
            line += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
        else if (code != '\t' && is_obeyed(code))
            line += code < 0x80 ? fmt::format("\\x{:02x}", static_cast<unsigned>(code))
                                : fmt::format("\\u{:04x}", static_cast<unsigned>(code));
        else
            line += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return all + shortened(line);
}

std::string printable_json(std::string_view text) {
    std::string line;
    while (!text.empty()) {
        const auto [length, code] = first_character(text);
        const std::size_t taken = std::max<std::size_t>(length, 1);
        if (length > 0 && is_obeyed(code))
            line += fmt::format("\\u{:04x}", static_cast<unsigned>(code));
        else
            line += text.substr(0, taken);
        text.remove_prefix(taken);
    }
    return line;
}

Terminal::Terminal() : is_terminal_(isatty(STDERR_FILENO) != 0), colours_(is_terminal_ && wants_colours()) {}

void Terminal::say(std::string_view head, std::string_view colour, std::string_view text) {
    clear_bar();
    if (colours_)
        fmt::print(stderr, "\033[{}m{}:\033[0m {}\n", colour, head, printable(text, false));
    else
        fmt::print(stderr, "{}: {}\n", head, printable(text, false));
}

void Terminal::error(std::string_view text, std::string_view advice) {
    say("sinew", "1;31", text);
    if (!advice.empty()) fmt::print(stderr, "{}\n", printable(advice, false));
}
void Terminal::warning(std::string_view text) { say("warning", "33", text); }

void Terminal::start_bar(std::string title) {
    title_ = printable(title, false);
    next_draw_ = Clock::now() + patience;
}

void Terminal::draw_bar(double share, std::string_view stage) {
    if (!is_terminal_ || Clock::now() < next_draw_) return;
    next_draw_ = Clock::now() + refresh;
    share = std::clamp(share, 0.0, 1.0);
    const int full = static_cast<int>(share * bar_width);
    fmt::print(stderr, "\r\033[K{} [{:=>{}}{:>{}}] {:3.0f}% {}", title_, "", full, "", bar_width - full,
               100 * share, stage);
    std::fflush(stderr);
    bar_is_drawn_ = true;
}

void Terminal::clear_bar() {
    if (!bar_is_drawn_) return;
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
    bar_is_drawn_ = false;
}

}  // namespace sinew::cli
