/// @file terminal.h
/// Messages and progress on standard error. Colours and the progress bar appear on a terminal only.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace sinew::cli {

class Terminal {
  public:
    Terminal();
    ~Terminal() { clear_bar(); }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    void error(std::string_view text);    ///< "sinew: text", the name in red
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
