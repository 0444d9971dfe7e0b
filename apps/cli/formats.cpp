#include "sinew/io/formats.h"

#include "cli/commands.h"

namespace sinew::cli {
namespace {

constexpr const char* formats_examples = R"(Examples:
  sinew formats
  sinew formats --json | python3 -m json.tool)";

Json uses_of(const Format& format) {
    Json uses = Json::array();
    if (format.reads_skeleton) uses.push_back("read skeleton");
    if (format.writes_skeleton) uses.push_back("write skeleton");
    if (format.reads_mesh) uses.push_back("read mesh");
    if (format.writes_mesh) uses.push_back("write mesh");
    return uses;
}

Json formats_json() {
    Json list = Json::array();
    for (const Format& format : formats())
        list.push_back({{"name", format.name},
                        {"extension", format.extension},
                        {"about", format.about},
                        {"uses", uses_of(format)},
                        {"measured", format.measured}});
    return list;
}

}  // namespace

void add_formats(CLI::App& program, Session& session) {
    CLI::App& app = *program.add_subcommand("formats", "List the file formats and what each can carry");
    app.footer(formats_examples);
    app.add_flag("--json", session.json, "Print the list as JSON");
    app.callback([&session] {
        if (session.json)
            session.put_json(formats_json());
        else
            session.put(formats_text());
    });
}

}  // namespace sinew::cli
