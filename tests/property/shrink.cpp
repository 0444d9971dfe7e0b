#include "property/shrink.h"

#include <algorithm>
#include <cmath>

#include "sinew/skeleton/graph.h"

namespace sinew::property {
namespace {

class Shrinker {
  public:
    Shrinker(Case failing, const std::function<bool(const Case&)>& fails)
        : best_(std::move(failing)), fails_(fails) {}

    Case run() {
        bool better = true;
        for (int round = 0; better && round < 20; ++round) {
            better = simplify_options();
            better |= remove_nodes();
            better |= remove_bones();
            better |= simplify_nodes();
        }
        return std::move(best_);
    }

  private:
    bool take_if_failing(Case candidate) {
        if (!fails_(candidate)) return false;
        best_ = std::move(candidate);
        return true;
    }
    template <class Change>
    bool attempt(Change change) {
        Case candidate = best_;
        change(candidate);
        return take_if_failing(std::move(candidate));
    }

    bool simplify_options() {
        bool better = false;
        const SkinOptions plain;
        if (best_.options.sides != 0) better |= attempt([](Case& c) { c.options.sides = 0; });
        if (best_.options.repair) better |= attempt([](Case& c) { c.options.repair = false; });
        better |= use_links_only();
        if (best_.document.symmetry.kind != Symmetry::Kind::none)
            better |= attempt([](Case& c) { c.document.symmetry = {}; });
        if (best_.options.fit != plain.fit) better |= attempt([&](Case& c) { c.options.fit = plain.fit; });
        return better;
    }

    /// Without some nodes, whose neighbours are joined to each other in a row where `bridge` says so.
    static void erase_nodes(Case& c, const std::vector<std::int32_t>& gone, bool bridge) {
        std::vector<std::int32_t> moved(c.document.nodes.size(), 0);
        for (const std::int32_t i : gone) moved[i] = -1;
        std::vector<Node> nodes;
        for (std::size_t i = 0; i < moved.size(); ++i) {
            if (moved[i] < 0) continue;
            moved[i] = static_cast<std::int32_t>(nodes.size());
            nodes.push_back(c.document.nodes[i]);
            nodes.back().id = moved[i];
        }
        std::vector<std::array<std::int32_t, 2>> links;
        std::vector<std::int32_t> loose;
        for (const auto& [a, b] : bones_of(c.document))
            if ((moved[a] < 0) != (moved[b] < 0)) loose.push_back(std::max(moved[a], moved[b]));
        for (const auto& [a, b] : c.document.links)
            if (moved[a] >= 0 && moved[b] >= 0) links.push_back({moved[a], moved[b]});
        for (Node& node : nodes)
            if (node.parent >= 0) node.parent = moved[node.parent];
        for (std::size_t i = 0; bridge && i + 1 < loose.size(); ++i)
            if (loose[i] != loose[i + 1]) links.push_back({loose[i], loose[i + 1]});
        c.document.links = std::move(links);
        c.document.nodes = std::move(nodes);
    }
    /// The node that lies where the mirror image of another is, or that one itself: so that symmetric cases
    /// stay so.
    std::int32_t twin(std::int32_t i, int axis) const {
        if (axis < 0) return i;
        Vec3 image = best_.document.nodes[i].position;
        image[axis] = -image[axis];
        for (std::int32_t j = 0; j < node_count(); ++j)
            if (best_.document.nodes[j].position == image) return j;
        return i;
    }
    std::int32_t node_count() const { return static_cast<std::int32_t>(best_.document.nodes.size()); }

    bool use_links_only() {
        const bool any = std::any_of(best_.document.nodes.begin(), best_.document.nodes.end(),
                                     [](const Node& n) { return n.parent >= 0; });
        return any && attempt([](Case& c) {
                   c.document.links = bones_of(c.document);
                   for (Node& node : c.document.nodes) node.parent = -1;
               });
    }

    bool remove_nodes() {
        bool better = false;
        for (std::int32_t size = std::max(1, node_count() / 2); size >= 1; size /= 2)
            for (std::int32_t begin = 0; begin + size <= node_count() && node_count() > size;) {
                const bool removed = remove_some(begin, size);
                better |= removed;
                if (!removed) begin += size;
            }
        return better;
    }
    bool remove_some(std::int32_t begin, std::int32_t size) {
        for (int axis = -1; axis < 3; ++axis) {
            std::vector<std::int32_t> gone;
            for (std::int32_t i = begin; i < begin + size; ++i) gone.insert(gone.end(), {i, twin(i, axis)});
            std::sort(gone.begin(), gone.end());
            gone.erase(std::unique(gone.begin(), gone.end()), gone.end());
            if (std::ssize(gone) >= node_count()) continue;
            if (attempt([&](Case& c) { erase_nodes(c, gone, false); })) return true;
            if (size == 1 && attempt([&](Case& c) { erase_nodes(c, gone, true); })) return true;
        }
        return false;
    }
    bool remove_bones() {
        bool better = false;
        for (std::size_t b = 0; b < best_.document.links.size();) {
            if (remove_bone(b))
                better = true;
            else
                ++b;
        }
        return better;
    }
    bool remove_bone(std::size_t bone) {
        for (int axis = -1; axis < 3; ++axis) {
            const auto [a, b] = best_.document.links[bone];
            const auto [u, v] =
                std::minmax({twin(a, axis), twin(b, axis)});  // values, not references to them
            if (attempt([&, u = u, v = v](Case& c) {
                    auto& links = c.document.links;
                    links.erase(links.begin() + bone);
                    links.erase(std::remove_if(links.begin(), links.end(),
                                               [&](const auto& l) {
                                                   return std::minmax(l[0], l[1]) == std::minmax(u, v);
                                               }),
                                links.end());
                }))
                return true;
        }
        return false;
    }

    bool simplify_nodes() {
        bool better = false;
        for (std::int32_t i = 0; i < node_count(); ++i)
            for (int axis = -1; axis < 3; ++axis) {
                const std::int32_t j = twin(i, axis);
                if (axis >= 0 && j == i) continue;
                better |= simplify_kind(i, j);
                better |= round_number(
                    best_.document.nodes[i].radius,
                    [&](Case& c, double to) { c.document.nodes[i].radius = c.document.nodes[j].radius = to; },
                    0.25);
                for (int k = 0; k < 3; ++k)
                    better |= round_number(
                        best_.document.nodes[i].position[k],
                        [&](Case& c, double to) {
                            c.document.nodes[j].position[k] = k == axis ? -to : to;
                            c.document.nodes[i].position[k] = to;
                        },
                        0);
            }
        return better;
    }
    /// Takes away what makes two nodes (or one) more than balls, one thing after the other.
    bool simplify_kind(std::int32_t i, std::int32_t j) {
        const Node plain, node = best_.document.nodes[i];
        bool better = false;
        const auto reset = [&](auto Node::*member) {
            if (node.*member == plain.*member) return;
            better |= attempt(
                [&](Case& c) { c.document.nodes[i].*member = c.document.nodes[j].*member = plain.*member; });
        };
        reset(&Node::type);
        reset(&Node::section);
        reset(&Node::scale);
        reset(&Node::size);
        reset(&Node::roll);
        reset(&Node::joint);
        if (node.rotation)
            better |= attempt([&](Case& c) {
                c.document.nodes[i].rotation.reset();
                c.document.nodes[j].rotation.reset();
            });
        return better;
    }
    /// The plainest of: a given number, a whole one, one of few digits.
    template <class Set>
    bool round_number(double now, Set set, double plain) {
        if (now == plain) return false;
        for (const double digit : {0.0, 1.0, 10.0, 100.0, 1000.0}) {
            const double rounded = digit == 0 ? plain : std::round(now * digit) / digit;
            if (rounded == now) return false;
            if (plain > 0 && rounded <= 0) continue;
            if (attempt([&](Case& c) { set(c, rounded); })) return true;
        }
        return false;
    }

    Case best_;
    const std::function<bool(const Case&)>& fails_;
};

}  // namespace

Case shrink(Case failing, const std::function<bool(const Case&)>& fails) {
    return Shrinker(std::move(failing), fails).run();
}

}  // namespace sinew::property
