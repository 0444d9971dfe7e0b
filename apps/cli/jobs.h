/// @file jobs.h
/// Which files go in and where each result goes: what all commands share of `IN... -o OUT`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sinew/base/result.h"

namespace sinew::cli {

/// What the user wrote.
struct FileOptions {
    std::vector<std::string> inputs;  ///< "-" is standard input
    std::string output;               ///< a file, "-" or a folder; empty for commands that write none
    std::string from;                 ///< format of the inputs; empty: by their extensions
    std::string to;                   ///< format of the outputs; empty: by their extensions
};

/// One input and where its result goes.
struct Job {
    std::string input;
    std::string output;
};

/// @param extension  of files in an output folder, with the dot, where --to does not say; empty if it must
/// With several inputs the output is a folder; with one it is if it ends in a slash or is one already. A
/// missing folder is made later, by make_folder(). Fails (kind call) for no or two standard inputs, for two
/// inputs of one output, and where several inputs would go into one file.
Result<std::vector<Job>> plan_jobs(const FileOptions& options, std::string_view extension);

/// Makes the folder that `options.output` names, if it is one and missing.
Result<void> make_folder(const FileOptions& options);

}  // namespace sinew::cli
