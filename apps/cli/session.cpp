#include "cli/session.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/interrupt.h"
#include "sinew/io/files.h"

namespace sinew::cli {
namespace {

Error with_file(Error error, const std::string& path) {
    if (error.file.empty() && error.kind == ErrorKind::input) error.file = input_name(path);
    return error;
}

}  // namespace

int exit_status(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::input:
            return 1;
        case ErrorKind::call:
            return 2;
        case ErrorKind::program:
        case ErrorKind::cancelled:
            return 3;
    }
    return 3;
}

void Session::error(const Error& error) {
    terminal_.error(error.text());
    status = std::max(status, exit_status(error.kind));
}

Result<void> Session::warn(const std::string& file, const Warnings& warnings) {
    if (strict && !warnings.empty())
        return fail(Error{.message = warnings.front().message,
                          .cure = "mend the file, or leave out --strict",
                          .file = input_name(file)});
    for (const Json& each : to_json(warnings)) warnings_.push_back(each);
    if (!quiet)
        for (const Warning& each : warnings)
            terminal_.warning(fmt::format("{}: {}", input_name(file), each.message));
    return {};
}

void Session::put(const std::string& text) {
    const InterruptsEndProgram meanwhile;  // nobody may ever read it
    if (const auto written = write_file("-", printable(text, true)); !written) error(written.error());
}

void Session::put_json(const Json& value) {
    const InterruptsEndProgram meanwhile;
    if (const auto written = write_file("-", line_of(value) + "\n"); !written) error(written.error());
}

Progress Session::progress(double begin, double end) {
    if (quiet) return Progress({}, &interrupted());
    return Progress(
        [this, begin, end](double share, std::string_view stage) {
            terminal_.draw_bar(begin + share * (end - begin), stage);
        },
        &interrupted());
}

void Session::run(const FileOptions& files, std::string_view extension, const Work& work) {
    const auto jobs = plan_jobs(files, extension);
    if (!jobs) return error(jobs.error());
    if (json && files.output == "-")
        return error({.kind = ErrorKind::call,
                      .message = "--json and the result cannot both go to standard output",
                      .cure = "name a file with -o"});
    if (const auto made = make_folder(files); !made) return error(made.error());

    for (std::size_t i = 0; i < jobs->size() && !interrupted(); ++i) {
        const Job& job = (*jobs)[i];
        const std::string count = jobs->size() > 1 ? fmt::format("{}/{} ", i + 1, jobs->size()) : "";
        terminal_.start_bar(count + input_name(job.input));
        warnings_ = Json::array();
        const Result<Outcome> outcome = work(job);
        terminal_.clear_bar();
        finish(job, outcome);
    }
    if (interrupted() && status == 0) status = exit_status(ErrorKind::cancelled);
}

void Session::finish(const Job& job, const Result<Outcome>& outcome) {
    if (!outcome) {
        const Error named = with_file(outcome.error(), job.input);
        error(named);
        if (json) print(job, named);
        return;
    }
    if (!outcome->good) status = std::max(status, 1);
    print(job, *outcome);
}

void Session::print(const Job& job, const Outcome& outcome) {
    if (json) {
        Json line{{"input", job.input}};
        if (!job.output.empty()) line["output"] = job.output;
        line.update(outcome.json);
        line["warnings"] = warnings_;
        put_json(line);
    } else if (job.output != "-" && !(quiet && !job.output.empty())) {
        put(outcome.text);
    }
}

void Session::print(const Job& job, const Error& error) {
    put_json({{"input", job.input}, {"error", to_json(error)}});
}

}  // namespace sinew::cli
