#include "cli/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

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

}  // namespace

Terminal::Terminal() : is_terminal_(isatty(STDERR_FILENO) != 0), colours_(is_terminal_ && wants_colours()) {}

void Terminal::say(std::string_view head, std::string_view colour, std::string_view text) {
    clear_bar();
    if (colours_)
        fmt::print(stderr, "\033[{}m{}:\033[0m {}\n", colour, head, text);
    else
        fmt::print(stderr, "{}: {}\n", head, text);
}

void Terminal::error(std::string_view text) { say("sinew", "1;31", text); }
void Terminal::warning(std::string_view text) { say("warning", "33", text); }

void Terminal::start_bar(std::string title) {
    title_ = std::move(title);
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
