/// @file terminal.h
/// Messages and progress on standard error. Colours and the progress bar appear on a terminal only.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace sinew::cli {

/// Most characters of a line that are shown; of a longer one the middle is left out.
inline constexpr std::size_t longest_line = 2000;

/// Text that may hold what somebody else wrote (names of files and of types, pieces of a file), made fit for a
/// terminal: control characters, bytes that are no UTF-8 and marks that turn the direction of writing are shown by
/// their codes, such as \x1b, so that none is obeyed; longer lines than longest_line are cut. All that the program
/// says goes through here. Tabs stay, and with `lines` line ends, too.
std::string printable(std::string_view text, bool lines);

/// The same of a line of JSON, in which such characters stand in strings only: their codes mean the same.
std::string printable_json(std::string_view text);

class Terminal {
  public:
    Terminal();
    ~Terminal() { clear_bar(); }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    /// "sinew: text", the name in red.
    /// @param advice  a line of its own below
    void error(std::string_view text, std::string_view advice = {});
    void warning(std::string_view text);  ///< "warning: text", the word in yellow

    /// What the bar names in front: "3/12 horse.graph".
    void start_bar(std::string title);
    /// Draws the bar, a few times a second, once the work has taken a moment.
    void draw_bar(double share, std::string_view stage);
    void clear_bar();

  private:
    using Clock = std::chrono::steady_clock;
    void say(std::string_view head, std::string_view colour, std::string_view text);

    bool is_terminal_ = false;
    bool colours_ = false;
    bool bar_is_drawn_ = false;
    std::string title_;
    Clock::time_point next_draw_;
};

}  // namespace sinew::cli
