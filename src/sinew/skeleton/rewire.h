/// @file rewire.h
/// What operations on documents have in common: nodes come and go, and bones find their parents again.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/skeleton/document.h"
#include "sinew/skeleton/graph.h"

namespace sinew {

/// Gives a document these bones in place of its own; each is taken from the first of its nodes to the second.
/// Bones from a node to itself and repeated ones are dropped. A bone makes the first node the parent of the
/// second where that has none yet and no cycle closes, and is a link otherwise; earlier bones come first.
/// @param links  bones that are links in any case, so that roots stay roots
void set_bones(Document& document, std::span<const Bone> bones, std::span<const Bone> links = {});

/// Appends a copy of a node with its name and unknown keys, under another id, and returns its index. Its
/// parent is the same.
std::int32_t append_copy(Document& document, std::int32_t node, std::int64_t id);

/// Takes out the nodes that are marked. Bones to them must be gone.
void drop_nodes(Document& document, const std::vector<char>& gone);

/// Nodes whose type is for leaves, and which are none (any more), become spheres; so does one of two
/// negatives that have only each other.
void round_off_inner_tips(Document& document);

/// Does the shape of a node depend on its frame (frames.h)?
/// @param bones, around  bones_of(document) and their adjacency
bool has_axes(const Document& document, const std::vector<Bone>& bones, const Adjacency& around,
              std::int32_t node);

/// Chooses a node's roll and rotation so that its frame becomes this one, up to half turns, which no shape
/// shows; a roll of 0, of whole degrees or of plus or minus `likely` is met exactly. Where the frame of the
/// node can only roll (takes_rotation() is false) it comes as near as that allows.
void turn_to(Document& document, const std::vector<Bone>& bones, const Adjacency& around, std::int32_t node,
             const Mat3& frame, double likely);

/// Ids that no node has: those above the highest or, beyond 64 bits, the lowest ones that are free.
class FreshIds {
  public:
    explicit FreshIds(const Document& document);
    std::int64_t next();

  private:
    std::vector<std::int64_t> taken_;  ///< sorted; empty while there is room above
    std::size_t at_ = 0;
    std::int64_t next_ = 0;
};

}  // namespace sinew
