/// @file session.h
/// One call of the program: what its commands say, and its exit status.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "cli/jobs.h"
#include "cli/json.h"
#include "cli/terminal.h"
#include "sinew/base/progress.h"
#include "sinew/base/result.h"

namespace sinew::cli {

/// 0 done, 1 the input is bad, 2 the call is wrong, 3 the program is at fault or was stopped.
int exit_status(ErrorKind kind);

/// What one job found or made, said twice: as text for people and as JSON for programs.
struct Outcome {
    std::string text;  ///< lines; empty: nothing to say
    Json json = Json::object();
    bool good = true;  ///< false: the input was looked at and found wanting, status 1
};

class Session {
  public:
    bool json = false;    ///< --json: one JSON object a job, on standard output
    bool quiet = false;   ///< --quiet: no warnings, no summary, no progress
    bool strict = false;  ///< --strict: a warning is an error
    int status = 0;       ///< of the program, the worst of all jobs

    void error(const Error& error);
    /// Tells of warnings about a file. With --strict the first becomes an error.
    Result<void> warn(const std::string& file, const Warnings& warnings);

    /// Writes results to standard output, text for people as printable() has it. A failure (a full disk) is the
    /// status.
    void put(const std::string& text);
    void put_json(const Json& value);

    /// Progress of a part of the current job: its 0 to 1 is `begin` to `end` of the bar. Stops on Ctrl-C.
    Progress progress(double begin = 0, double end = 1);

    using Work = std::function<Result<Outcome>(const Job&)>;
    /// Plans the jobs, does one after the other, goes on after one that fails, and prints what comes out.
    /// @param extension  see plan_jobs()
    void run(const FileOptions& files, std::string_view extension, const Work& work);

  private:
    void finish(const Job& job, const Result<Outcome>& outcome);
    void print(const Job& job, const Outcome& outcome);
    void print(const Job& job, const Error& error);

    Terminal terminal_;
    Json warnings_ = Json::array();  ///< of the current job
    double share_ = 0;
};

}  // namespace sinew::cli
