#include "files/load.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "document/references.h"
#include "sinew/io/skeleton_formats.h"

namespace sinew::modeler {
namespace {

bool parents_end(const Document& document) {
    // 0 not seen, 1 on the way now, 2 known to end at a root
    std::vector<char> state(document.nodes.size(), 0);
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
        std::vector<std::int32_t> way;
        std::int32_t at = i;
        for (; at >= 0 && state[at] == 0; at = document.nodes[at].parent) {
            state[at] = 1;
            way.push_back(at);
        }
        if (at >= 0 && state[at] == 1) return false;
        for (std::int32_t node : way) state[node] = 2;
    }
    return true;
}

}  // namespace

Result<void> can_be_edited(const Document& document) {
    for (const Node& node : document.nodes) {
        if (!node.position.allFinite())
            return fail(Error{.message = "a position is not finite", .node = node.id});
        if (!(node.radius > 0)) return fail(Error{.message = "a radius is not positive", .node = node.id});
    }
    if (!parents_end(document)) return fail(ErrorKind::input, "some nodes are their own ancestors");
    return {};
}

Result<ReadSkeleton> load(const std::string& path) {
    auto read = read_skeleton(path);
    if (!read) {
        auto loose = read_skeleton(path, {.validate = false});
        if (!loose || !can_be_edited(loose->document)) return fail(read.error());
        read = std::move(loose);
    }
    const std::string folder = std::filesystem::absolute(path).parent_path().string();
    read->document = with_absolute_files(std::move(read->document), folder);
    return read;
}

Document added(Document document, const Document& more) {
    const auto first = static_cast<std::int32_t>(document.nodes.size());
    if (first == 0) return more;
    std::set<std::int64_t> taken;
    std::int64_t next = 0;
    for (const Node& node : document.nodes) {
        taken.insert(node.id);
        next = std::max(next, node.id + 1);
    }
    for (const Node& node : more.nodes) next = std::max(next, node.id + 1);
    for (Node node : more.nodes) {
        if (node.parent >= 0) node.parent += first;
        if (!taken.insert(node.id).second) node.id = next++;
        document.nodes.push_back(node);
    }
    for (auto [a, b] : more.links) document.links.push_back({a + first, b + first});
    if (!document.names.empty() || !more.names.empty()) {
        document.names.resize(first);
        document.names.insert(document.names.end(), more.names.begin(), more.names.end());
        document.names.resize(document.nodes.size());
    }
    if (!document.extras.empty() || !more.extras.empty()) {
        document.extras.resize(first);
        document.extras.insert(document.extras.end(), more.extras.begin(), more.extras.end());
        document.extras.resize(document.nodes.size());
    }
    return document;
}

}  // namespace sinew::modeler
