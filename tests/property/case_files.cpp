#include "property/case_files.h"

#include <nlohmann/json.hpp>

#include "sinew/io/files.h"
#include "sinew/io/sinew_format.h"

namespace sinew::property {

std::string print_case(const Case& tried) {
    nlohmann::ordered_json options;
    options["kind"] = tried.kind;
    if (tried.options.sides != 0) options["sides"] = tried.options.sides;
    if (tried.options.repair) options["repair"] = true;
    if (tried.options.fit == Fit::limit) options["fit"] = "limit";
    Document document = tried.document;
    document.extra = nlohmann::ordered_json{{"skin", options}}.dump();
    const auto written = print_sinew(document);
    return written ? written->text : written.error().text();
}

Result<Case> read_case(const std::filesystem::path& file) {
    const auto text = read_file(file.string());
    if (!text) return fail(text.error());
    auto read = parse_sinew(*text, {.validate = false});
    if (!read) return fail(read.error());
    Case made;
    made.document = std::move(read->document);
    const auto extra = nlohmann::json::parse(made.document.extra, nullptr, false);
    if (!extra.is_object() || !extra.contains("skin")) return fail(ErrorKind::input, "no key \"skin\"");
    const auto& options = extra["skin"];
    made.kind = options.value("kind", "");
    made.options.sides = options.value("sides", 0);
    made.options.repair = options.value("repair", false);
    if (options.value("fit", "control") == "limit") made.options.fit = Fit::limit;
    return made;
}

}  // namespace sinew::property
