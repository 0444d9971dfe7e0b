#include "cli/json.h"

#include "cli/terminal.h"

namespace sinew::cli {
namespace {

const char* word(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::input:
            return "input";
        case ErrorKind::call:
            return "call";
        case ErrorKind::program:
            return "program";
        case ErrorKind::cancelled:
            return "cancelled";
    }
    return "";
}

}  // namespace

Json to_json(const Error& error) {
    Json json{{"kind", word(error.kind)}, {"message", error.message}};
    if (!error.cure.empty()) json["cure"] = error.cure;
    if (!error.file.empty()) json["file"] = error.file;
    if (error.line > 0) json["line"] = error.line;
    if (error.column > 0) json["column"] = error.column;
    if (!error.path.empty()) json["path"] = error.path;
    if (error.node) json["node"] = *error.node;
    return json;
}

Json to_json(const Warnings& warnings) {
    Json list = Json::array();
    for (const Warning& warning : warnings)
        list.push_back({{"message", warning.message}, {"count", warning.count}, {"nodes", warning.nodes}});
    return list;
}

std::string line_of(const Json& value) {
    return printable_json(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace sinew::cli
