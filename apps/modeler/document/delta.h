/// @file delta.h
/// What changed between two documents: an undo step keeps this, not two copies of the model.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew/skeleton/document.h"

namespace sinew::modeler {

/// Everything that a document says of one node.
struct NodeRecord {
    Node node;
    std::string name;
    std::string extra;

    bool operator==(const NodeRecord&) const;
};

/// The step from one document to another, both ways. Its size is that of what changed.
class DocumentDelta {
  public:
    DocumentDelta(const Document& before, const Document& after);

    Document forward(Document before) const;  ///< gives `after`
    Document backward(Document after) const;  ///< gives `before`
    bool empty() const;
    std::size_t changed_nodes() const { return changed_.size() + tail_before_.size() + tail_after_.size(); }

  private:
    struct Change {
        std::size_t index;
        NodeRecord before, after;
    };
    /// What a document says beside its nodes.
    struct Rest {
        std::string unit, extra;
        Symmetry symmetry;
        std::vector<std::array<std::int32_t, 2>> links;
        bool has_names = false, has_extras = false;
        bool operator==(const Rest&) const = default;
    };
    static Rest rest_of(const Document& document);
    static void put(Document& document, const Rest& rest, const std::vector<NodeRecord>& tail,
                    std::size_t common);

    std::size_t common_ = 0;  ///< nodes that both have; the rest of either is its tail
    std::vector<Change> changed_;
    std::vector<NodeRecord> tail_before_, tail_after_;
    Rest rest_before_, rest_after_;
};

bool same(const Node& a, const Node& b);
/// Equal in everything that is saved.
bool same(const Document& a, const Document& b);

}  // namespace sinew::modeler
