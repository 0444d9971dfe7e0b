#include "cli/jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "sinew/io/files.h"
#include "sinew/io/formats.h"

namespace sinew::cli {
namespace {

namespace fs = std::filesystem;

bool is_folder(const FileOptions& options) {
    std::error_code ignored;
    return options.inputs.size() > 1 || options.output.ends_with('/') ||
           fs::is_directory(options.output, ignored);
}

Result<std::string> extension_in_folder(const FileOptions& options, std::string_view extension) {
    if (!options.to.empty()) {
        const Format* format = find_format(options.to);
        if (!format)
            return fail(ErrorKind::call, fmt::format("there is no format '{}'", options.to),
                        "`sinew formats` lists them");
        return std::string(format->extension);
    }
    if (extension.empty())
        return fail(ErrorKind::call, "an output folder does not say which format is meant",
                    "name one with --to");
    return std::string(extension);
}

Result<std::vector<Job>> jobs_into_folder(const FileOptions& options, std::string_view extension) {
    std::vector<Job> jobs;
    std::map<std::string, std::string> input_of;  // output -> input
    for (const std::string& input : options.inputs) {
        const std::string stem = input == "-" ? "stdin" : fs::path(input).stem().string();
        const std::string output = (fs::path(options.output) / (stem + std::string(extension))).string();
        const auto [earlier, is_new] = input_of.emplace(output, input);
        if (!is_new)
            return fail(ErrorKind::call,
                        fmt::format("{} and {} would both be written to {}", earlier->second, input, output),
                        "give one of them another name or call");
        jobs.push_back({input, output});
    }
    return jobs;
}

/// A file may be written back in its own format; one of another would be lost.
Result<std::vector<Job>> not_over_inputs(const FileOptions& options, std::vector<Job> jobs) {
    const auto format = [](const std::string& path, const std::string& name) {
        return name.empty() ? extension_of(path) : name.starts_with('.') ? name : "." + name;
    };
    for (const Job& job : jobs) {
        std::error_code missing;
        if (job.input == "-" || job.output == "-" || !fs::is_regular_file(job.input, missing) ||
            !fs::equivalent(job.input, job.output, missing))
            continue;
        if (format(job.input, options.from) != format(job.output, options.to))
            return fail(Error{.kind = ErrorKind::call,
                              .message = "the result would replace its own input by another format",
                              .cure = "name another file with -o",
                              .file = job.output});
    }
    return jobs;
}

}  // namespace

Result<std::vector<Job>> plan_jobs(const FileOptions& options, std::string_view extension) {
    if (std::count(options.inputs.begin(), options.inputs.end(), "-") > 1)
        return fail(ErrorKind::call, "standard input can be read once only", "write '-' once");
    if (options.output.empty()) {
        std::vector<Job> jobs;
        for (const std::string& input : options.inputs) jobs.push_back({input, {}});
        return jobs;
    }
    if (options.output == "-" && options.inputs.size() > 1)
        return fail(ErrorKind::call, "several results do not go into one standard output",
                    "name a folder with -o");
    if (options.output == "-" || !is_folder(options))
        return not_over_inputs(options, {{options.inputs.front(), options.output}});

    std::error_code ignored;
    if (fs::exists(options.output, ignored) && !fs::is_directory(options.output, ignored))
        return fail(Error{.kind = ErrorKind::call,
                          .message = "several inputs need a folder to go to, and this is a file",
                          .cure = "name a folder with -o",
                          .file = options.output});
    const auto suffix = extension_in_folder(options, extension);
    if (!suffix) return fail(suffix.error());
    auto jobs = jobs_into_folder(options, *suffix);
    if (!jobs) return jobs;
    return not_over_inputs(options, *std::move(jobs));
}

Result<void> make_folder(const FileOptions& options) {
    if (options.output.empty() || options.output == "-" || !is_folder(options)) return {};
    std::error_code reason;
    fs::create_directories(options.output, reason);
    if (reason)
        return fail(Error{.kind = ErrorKind::call,
                          .message = fmt::format("the folder cannot be made ({})", reason.message()),
                          .cure = "choose another place",
                          .file = options.output});
    return {};
}

}  // namespace sinew::cli
