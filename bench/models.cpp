#include "models.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numeric>

#include "sinew/grow/grow.h"
#include "sinew/io/files.h"
#include "sinew/io/skeleton_formats.h"

namespace sinew::bench {
namespace {

Grammar figure_2_6a() {
    const std::string text = read_file(std::string(SINEW_LSYSTEMS) + "/honda_a.lsys").value();
    return parse_grammar(text, "honda_a.lsys").value();
}

/// The nodes in the order of their depth, as if all twigs grew at once; so the first n are a tree as well.
Document by_depth(const Document& grown, std::int32_t nodes) {
    std::vector<std::int32_t> depth(grown.nodes.size(), 0), order(grown.nodes.size()),
        place(grown.nodes.size());
    for (std::size_t i = 1; i < depth.size(); ++i) depth[i] = depth[grown.nodes[i].parent] + 1;
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return depth[a] < depth[b]; });
    Document document;
    for (std::int32_t i = 0; i < nodes; ++i) {
        Node node = grown.nodes[order[i]];
        place[node.id] = i;
        node.id = i;
        if (node.parent >= 0) node.parent = place[node.parent];
        document.nodes.push_back(std::move(node));
    }
    return document;
}

}  // namespace

Document monopodial_tree(std::int32_t nodes) {
    const int steps = static_cast<int>(std::ceil(std::log2(nodes)));
    return by_depth(grow(figure_2_6a(), {.steps = steps, .constants = {{"w0", 0.05}}}).value(), nodes);
}

Document bcc_lattice(int cells, double radius) {
    Document document;
    const auto add = [&](double x, double y, double z) {
        Node node;
        node.id = static_cast<std::int64_t>(document.nodes.size());
        node.position = {x, y, z};
        node.radius = radius;
        document.nodes.push_back(node);
    };
    const int side = cells + 1;
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) add(x, y, z);
    for (int z = 0; z < cells; ++z)
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x) {
                const auto centre = static_cast<std::int32_t>(document.nodes.size());
                add(x + 0.5, y + 0.5, z + 0.5);
                for (int corner = 0; corner < 8; ++corner)
                    document.links.push_back(
                        {centre, ((z + corner / 4) * side + y + corner / 2 % 2) * side + x + corner % 2});
            }
    return document;
}

std::vector<Model> real_models() {
    const char* shared = std::getenv("SINEW_SHARED");
    const std::filesystem::path folder =
        std::filesystem::path(shared ? shared : SINEW_SHARED_DEFAULT) / "data" / "graph";
    std::vector<Model> models;
    for (const auto& [name, file] : {
             std::pair{"lattice, Kelvin cells",
                       "lattice/NTNU_metamaterials_workshop__run_kelvin_uniform_t0010.graph"},
             {"plant, beech", "plant/canopyHydrodynamics__10_MediumCollection.graph"},
             {"neuron, fruit fly", "neuron/navis__754538881.graph"},
             {"vessels, brain", "vascular/VessMorphoVis__BG0002.CNG.graph"},
         })
        if (const auto path = folder / file; std::filesystem::exists(path))
            models.push_back({name, [path] { return read_skeleton(path.string()).value().document; }, true});
    return models;
}

}  // namespace sinew::bench
