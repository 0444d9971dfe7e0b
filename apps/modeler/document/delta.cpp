#include "document/delta.h"

#include <algorithm>

namespace sinew::modeler {
namespace {

NodeRecord record(const Document& document, std::size_t i) {
    return {document.nodes[i], document.names.empty() ? "" : document.names[i],
            document.extras.empty() ? "" : document.extras[i]};
}

void write(Document& document, std::size_t i, const NodeRecord& record) {
    document.nodes[i] = record.node;
    if (!document.names.empty()) document.names[i] = record.name;
    if (!document.extras.empty()) document.extras[i] = record.extra;
}

}  // namespace

bool same(const Node& a, const Node& b) {
    const bool turned_alike = a.rotation.has_value() == b.rotation.has_value() &&
                              (!a.rotation || a.rotation->coeffs() == b.rotation->coeffs());
    return a.id == b.id && a.parent == b.parent && a.position == b.position && a.radius == b.radius &&
           a.type == b.type && a.section == b.section && a.scale == b.scale && a.size == b.size &&
           a.roll == b.roll && turned_alike && a.joint == b.joint;
}

bool NodeRecord::operator==(const NodeRecord& other) const {
    return same(node, other.node) && name == other.name && extra == other.extra;
}

bool same(const Document& a, const Document& b) { return DocumentDelta(a, b).empty(); }

DocumentDelta::Rest DocumentDelta::rest_of(const Document& document) {
    return {document.unit,  document.extra,          document.symmetry,
            document.links, !document.names.empty(), !document.extras.empty()};
}

DocumentDelta::DocumentDelta(const Document& before, const Document& after)
    : common_(std::min(before.nodes.size(), after.nodes.size())),
      rest_before_(rest_of(before)),
      rest_after_(rest_of(after)) {
    for (std::size_t i = 0; i < common_; ++i) {
        NodeRecord old_record = record(before, i), new_record = record(after, i);
        if (!(old_record == new_record))
            changed_.push_back({i, std::move(old_record), std::move(new_record)});
    }
    for (std::size_t i = common_; i < before.nodes.size(); ++i) tail_before_.push_back(record(before, i));
    for (std::size_t i = common_; i < after.nodes.size(); ++i) tail_after_.push_back(record(after, i));
}

bool DocumentDelta::empty() const {
    return changed_.empty() && tail_before_.empty() && tail_after_.empty() && rest_before_ == rest_after_;
}

void DocumentDelta::put(Document& document, const Rest& rest, const std::vector<NodeRecord>& tail,
                        std::size_t common) {
    document.unit = rest.unit;
    document.extra = rest.extra;
    document.symmetry = rest.symmetry;
    document.links = rest.links;
    document.nodes.resize(common + tail.size());
    document.names.resize(rest.has_names ? document.nodes.size() : 0);
    document.extras.resize(rest.has_extras ? document.nodes.size() : 0);
    for (std::size_t i = 0; i < tail.size(); ++i) write(document, common + i, tail[i]);
}

Document DocumentDelta::forward(Document before) const {
    put(before, rest_after_, tail_after_, common_);
    for (const Change& change : changed_) write(before, change.index, change.after);
    return before;
}

Document DocumentDelta::backward(Document after) const {
    put(after, rest_before_, tail_before_, common_);
    for (const Change& change : changed_) write(after, change.index, change.before);
    return after;
}

}  // namespace sinew::modeler
