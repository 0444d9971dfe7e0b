#include "sinew/sqm/network.h"

#include <algorithm>

namespace sinew::sqm {
namespace {

/// Walks paths and writes them down; each bone is walked once.
class PathWalk {
  public:
    PathWalk(const Plain& skeleton, const Adjacency& adjacency, Network& network)
        : skeleton_(skeleton),
          adjacency_(adjacency),
          network_(network),
          walked_(skeleton.bones.size(), false),
          joint_of_(skeleton.position.size(), -1) {
        for (std::int32_t j = 0; j < network.joint_count(); ++j) joint_of_[network.joint_node[j]] = j;
        network_.path_first = {0};
    }

    bool walked(std::int32_t bone) const { return walked_[bone]; }

    void walk(std::int32_t node, std::int32_t bone) {
        const auto path = network_.path_count();
        const std::int32_t start = node;
        const PathEnd from = arrive(node, bone, {path, 0});
        PathEnd to;
        bool closed = false;
        for (;;) {
            step(node, bone);
            walked_[bone] = true;
            node = other(bone, node);
            if (adjacency_.degree(node) != 2 || joint_of_[node] >= 0) {
                to = arrive(node, bone, {path, 1});
                step(node, -1);
                break;
            }
            if (node == start) {
                closed = true;
                break;
            }
            const auto bones = adjacency_.bones(node);
            bone = bones[0] == bone ? bones[1] : bones[0];
        }
        network_.path_first.push_back(static_cast<std::int32_t>(network_.path_nodes.size()));
        network_.path_end.push_back({from, to});
        network_.path_closed.push_back(closed);
    }

  private:
    std::int32_t other(std::int32_t bone, std::int32_t node) const {
        const Bone& ends = skeleton_.bones[bone];
        return ends[0] == node ? ends[1] : ends[0];
    }
    void step(std::int32_t node, std::int32_t bone) {
        network_.path_nodes.push_back(node);
        network_.path_bones.push_back(bone);
    }
    PathEnd arrive(std::int32_t node, std::int32_t bone, const PathAndEnd& arriving) {
        const std::int32_t joint = joint_of_[node];
        if (joint < 0) return {};
        const auto bones = adjacency_.bones(node);
        const auto slot =
            static_cast<std::int32_t>(std::find(bones.begin(), bones.end(), bone) - bones.begin());
        network_.slot_path[network_.slot_first[joint] + slot] = arriving;
        return {joint, slot};
    }

    const Plain& skeleton_;
    const Adjacency& adjacency_;
    Network& network_;
    std::vector<bool> walked_;
    std::vector<std::int32_t> joint_of_;
};

/// Room for as many joints and paths as there may be: a tree of twigs has a path a bone.
void reserve(Network& n, std::size_t nodes, std::size_t bones) {
    n.joint_node.reserve(nodes);
    n.slot_first.reserve(nodes + 1);
    n.path_first.reserve(bones + 1);
    n.path_nodes.reserve(2 * bones);
    n.path_bones.reserve(2 * bones);
    n.path_end.reserve(bones);
    n.path_closed.reserve(bones);
}

}  // namespace

Network find_network(const Plain& skeleton) {
    Network network;
    const std::int32_t nodes = skeleton.node_count();
    const Adjacency adjacent = adjacency(nodes, skeleton.bones);
    reserve(network, nodes, skeleton.bones.size());
    network.slot_first = {0};
    for (std::int32_t i = 0; i < nodes; ++i) {
        const std::int32_t degree = adjacent.degree(i);
        if (degree == 0) network.lone.push_back(i);
        if (degree < 3 && !(degree > 0 && skeleton.is_body(i))) continue;
        network.joint_node.push_back(i);
        network.slot_first.push_back(network.slot_first.back() + degree);
    }
    network.slot_path.resize(network.slot_first.back());

    PathWalk paths(skeleton, adjacent, network);
    auto walk_from = [&](std::int32_t node) {
        for (const std::int32_t bone : adjacent.bones(node))
            if (!paths.walked(bone)) paths.walk(node, bone);
    };
    for (const std::int32_t node : network.joint_node) walk_from(node);
    for (std::int32_t i = 0; i < nodes; ++i)
        if (adjacent.degree(i) == 1) walk_from(i);
    for (std::int32_t i = 0; i < nodes; ++i)  // what is left are closed paths without a joint
        if (adjacent.degree(i) == 2 && !paths.walked(adjacent.bones(i)[0]))
            paths.walk(i, adjacent.bones(i)[0]);
    return network;
}

}  // namespace sinew::sqm
