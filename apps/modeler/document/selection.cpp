#include "document/selection.h"

#include <algorithm>
#include <numeric>

#include "sinew/skeleton/graph.h"

namespace sinew::modeler {
namespace {

void keep_active_inside(Selection& selection) {
    if (!selection.contains(selection.active))
        selection.active = selection.empty() ? -1 : selection.nodes.back();
}

}  // namespace

bool Selection::contains(std::int32_t node) const {
    return std::binary_search(nodes.begin(), nodes.end(), node);
}

Selection selection_of(std::span<const std::int32_t> nodes) {
    Selection result;
    if (nodes.empty()) return result;
    result.active = nodes.back();
    result.nodes.assign(nodes.begin(), nodes.end());
    std::sort(result.nodes.begin(), result.nodes.end());
    result.nodes.erase(std::unique(result.nodes.begin(), result.nodes.end()), result.nodes.end());
    return result;
}

Selection toggled(const Selection& selection, std::int32_t node) {
    Selection result = selection;
    auto place = std::lower_bound(result.nodes.begin(), result.nodes.end(), node);
    if (place != result.nodes.end() && *place == node) {
        result.nodes.erase(place);
    } else {
        result.nodes.insert(place, node);
        result.active = node;
    }
    keep_active_inside(result);
    return result;
}

Selection united(const Selection& a, const Selection& b) {
    Selection result;
    std::set_union(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
                   std::back_inserter(result.nodes));
    result.active = b.active >= 0 ? b.active : a.active;
    return result;
}

Selection all_nodes(const Document& document) {
    Selection result;
    result.nodes.resize(document.nodes.size());
    std::iota(result.nodes.begin(), result.nodes.end(), 0);
    keep_active_inside(result);
    return result;
}

Selection inverted(const Document& document, const Selection& selection) {
    Selection result, all = all_nodes(document);
    std::set_difference(all.nodes.begin(), all.nodes.end(), selection.nodes.begin(), selection.nodes.end(),
                        std::back_inserter(result.nodes));
    keep_active_inside(result);
    return result;
}

Selection linked(const Document& document, const Selection& selection) {
    std::vector<Bone> bones = bones_of(document);
    Adjacency neighbours = adjacency(static_cast<std::int32_t>(document.nodes.size()), bones);
    std::vector<bool> reached(document.nodes.size(), false);
    std::vector<std::int32_t> queue = selection.nodes;
    for (std::int32_t node : queue) reached[node] = true;
    for (std::size_t i = 0; i < queue.size(); ++i)
        for (std::int32_t b : neighbours.bones(queue[i])) {
            std::int32_t other = bones[b][0] == queue[i] ? bones[b][1] : bones[b][0];
            if (reached[other]) continue;
            reached[other] = true;
            queue.push_back(other);
        }
    Selection result = selection_of(queue);
    result.active = selection.active;
    return result;
}

Selection with_descendants(const Document& document, const Selection& selection) {
    // Parents may come after their children in the array, so pass over it until nothing changes.
    std::vector<bool> inside(document.nodes.size(), false);
    for (std::int32_t node : selection.nodes) inside[node] = true;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < document.nodes.size(); ++i) {
            std::int32_t parent = document.nodes[i].parent;
            if (inside[i] || parent < 0 || !inside[parent]) continue;
            inside[i] = changed = true;
        }
    }
    Selection result{{}, selection.active};
    for (std::size_t i = 0; i < inside.size(); ++i)
        if (inside[i]) result.nodes.push_back(static_cast<std::int32_t>(i));
    return result;
}

Selection stepped(const Document& document, const Selection& selection, Step step) {
    const std::int32_t from = selection.active;
    if (from < 0) return document.nodes.empty() ? selection : selection_of(0);
    const std::int32_t parent = document.nodes[from].parent;
    if (step == Step::parent) return parent < 0 ? selection : selection_of(parent);
    const std::int32_t above = step == Step::child ? from : parent;
    const std::int32_t count = static_cast<std::int32_t>(document.nodes.size());
    const std::int32_t start = step == Step::child ? 0 : from + 1;
    for (std::int32_t i = 0; i < count; ++i) {
        std::int32_t candidate = (start + i) % count;
        if (document.nodes[candidate].parent == above) return selection_of(candidate);
    }
    return selection;
}

Selection remapped(const Selection& selection, std::span<const std::int32_t> new_index) {
    Selection result;
    for (std::int32_t node : selection.nodes)
        if (new_index[node] >= 0) result.nodes.push_back(new_index[node]);
    std::sort(result.nodes.begin(), result.nodes.end());
    result.nodes.erase(std::unique(result.nodes.begin(), result.nodes.end()), result.nodes.end());
    result.active = selection.active >= 0 ? new_index[selection.active] : -1;
    keep_active_inside(result);
    return result;
}

Selection carried(const Document& before, const Selection& selection, const Document& after) {
    std::vector<std::pair<std::int64_t, std::int32_t>> places;
    for (std::int32_t i = 0; i < std::ssize(after.nodes); ++i) places.emplace_back(after.nodes[i].id, i);
    std::sort(places.begin(), places.end());
    std::vector<std::int32_t> new_index(before.nodes.size(), -1);
    for (std::int32_t node : selection.nodes) {
        const auto place =
            std::lower_bound(places.begin(), places.end(), std::pair(before.nodes[node].id, -1));
        if (place != places.end() && place->first == before.nodes[node].id) new_index[node] = place->second;
    }
    return remapped(selection, new_index);
}

}  // namespace sinew::modeler
