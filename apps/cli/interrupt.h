/// @file interrupt.h
/// Ctrl-C stops the work where it can be stopped, so that no half file stays behind.
#pragma once

#include <atomic>

namespace sinew::cli {

/// From now on SIGINT, SIGTERM and SIGHUP set interrupted(); the second one ends the program at once.
void catch_interrupts();

/// Set by a signal; hand it to Progress.
const std::atomic<bool>& interrupted();

/// While it lives, a signal ends the program as if nothing had caught it: for waiting on standard input, when
/// there is nothing to clean up yet and nobody looks at interrupted().
class InterruptsEndProgram {
  public:
    InterruptsEndProgram();
    ~InterruptsEndProgram();
    InterruptsEndProgram(const InterruptsEndProgram&) = delete;
    InterruptsEndProgram& operator=(const InterruptsEndProgram&) = delete;
};

}  // namespace sinew::cli
