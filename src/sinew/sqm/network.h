/// @file network.h
/// The graph of a skeleton as joints and paths, the two things that the stages work on.
///
/// A joint is a node of three or more bones, or one whose form is a body. A path is a run of bones through
/// nodes of two bones; it ends at joints and leaves, or closes on itself. Nodes without bones are neither:
/// they are lone. Linear in the skeleton.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/extend/plain.h"

namespace sinew::sqm {

/// Where a path ends: at a joint's bone, or (-1, -1) at a leaf or in a closed path.
struct PathEnd {
    std::int32_t joint = -1;
    std::int32_t slot =
        -1;  ///< which of the joint's bones, 0 .. degree - 1, in the order of the bones' indices

    bool at_joint() const { return joint >= 0; }
};

/// A path and one of its ends: how a joint knows what is at its slots.
struct PathAndEnd {
    std::int32_t path = -1;
    std::int32_t end = 0;  ///< 0: the path starts here, 1: it ends here

    bool operator==(const PathAndEnd&) const = default;
};

struct Network {
    std::vector<std::int32_t> joint_node;  ///< joint -> node
    std::vector<std::int32_t> slot_first;  ///< joint -> its first entry in slot_path; joints + 1 entries
    std::vector<PathAndEnd> slot_path;     ///< slot -> what leaves the joint there

    std::vector<std::int32_t> path_first;  ///< path -> its first entry in path_nodes; paths + 1 entries
    std::vector<std::int32_t>
        path_nodes;  ///< nodes from end to end, both ends included; a closed path once round
    std::vector<std::int32_t>
        path_bones;  ///< bone after each node of path_nodes; -1 after the last of an open path
    std::vector<std::array<PathEnd, 2>> path_end;  ///< start and end
    std::vector<std::uint8_t> path_closed;

    std::vector<std::int32_t> lone;  ///< nodes without bones

    std::int32_t joint_count() const { return static_cast<std::int32_t>(joint_node.size()); }
    std::int32_t path_count() const { return static_cast<std::int32_t>(path_end.size()); }
    std::int32_t degree(std::int32_t joint) const { return slot_first[joint + 1] - slot_first[joint]; }
    std::span<const std::int32_t> nodes(std::int32_t path) const {
        return {path_nodes.data() + path_first[path], path_nodes.data() + path_first[path + 1]};
    }
    std::span<const std::int32_t> bones(std::int32_t path) const {
        return {path_bones.data() + path_first[path], path_bones.data() + path_first[path + 1]};
    }
    bool between_joints(std::int32_t path) const {
        return path_end[path][0].at_joint() && path_end[path][1].at_joint();
    }
    /// The joint at a path's other end; -1 where it ends at a leaf.
    std::int32_t joint_beyond(std::int32_t path, std::int32_t joint) const {
        const auto& end = path_end[path];
        return end[0].joint == joint ? end[1].joint : end[0].joint;
    }
    /// The node beyond the first bone that leaves a joint at a slot.
    std::int32_t next_node(std::int32_t slot) const {
        const auto [path, end] = slot_path[slot];
        const auto on_path = nodes(path);
        return end == 0 ? on_path[1] : on_path[on_path.size() - 2];
    }
    /// visit(slot, path) for each bone of a joint.
    template <class Visit>
    void for_slots(std::int32_t joint, Visit visit) const {
        for (std::int32_t s = 0; s < degree(joint); ++s) visit(s, slot_path[slot_first[joint] + s].path);
    }
};

/// Whether no node of a path has a form.
inline bool is_plain(const Plain& skeleton, const Network& network, std::int32_t path) {
    if (skeleton.forms.empty()) return true;
    for (const std::int32_t node : network.nodes(path))
        if (skeleton.form_of[node] >= 0) return false;
    return true;
}

Network find_network(const Plain& skeleton);

}  // namespace sinew::sqm
