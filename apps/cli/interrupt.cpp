#include "cli/interrupt.h"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaction is POSIX
#include <unistd.h>

#include <string_view>

namespace sinew::cli {
namespace {

std::atomic<bool> flag = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

void note_signal(int) { flag.store(true, std::memory_order_relaxed); }

void end_program(int) {
    constexpr std::string_view words = "sinew: stopped on request\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, words.data(), words.size());
    _exit(3);
}

void handle_with(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);  // the second signal is the system's
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    struct sigaction before {};
    if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler == SIG_IGN)
        return;  // as nohup wants it
    sigaction(SIGHUP, &action, nullptr);
}

}  // namespace

void catch_interrupts() { handle_with(note_signal); }

const std::atomic<bool>& interrupted() { return flag; }

InterruptsEndProgram::InterruptsEndProgram() { handle_with(end_program); }

InterruptsEndProgram::~InterruptsEndProgram() { handle_with(note_signal); }

}  // namespace sinew::cli
