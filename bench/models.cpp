#include "models.h"

#include <cmath>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace sinew::bench {
namespace {

/// Where the turtle of figure 2.6 stands: heading, left and up, as columns.
struct Turtle {
    std::int32_t node = 0;
    Mat3 frame = Mat3::Identity();
    double length = 1, width = 10;
    char symbol = 'A';
};

Mat3 turned(const Turtle& turtle, double degrees, int column) {
    const Eigen::AngleAxisd turn(degrees * M_PI / 180, turtle.frame.col(column));
    return turn.toRotationMatrix() * turtle.frame;
}

/// $: rolls about the heading until the turtle's left is level (the world's up is y).
Mat3 levelled(const Mat3& frame) {
    const Vec3 heading = frame.col(0), left = Vec3::UnitY().cross(heading);
    if (left.norm() < 1e-9) return frame;
    Mat3 level;
    level << heading, left.normalized(), heading.cross(left.normalized());
    return level;
}

Document read_graph(const std::filesystem::path& path) {
    Document document;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        std::string kind;
        fields >> kind;
        if (kind == "n") {
            Node node;
            node.id = static_cast<std::int64_t>(document.nodes.size());
            fields >> node.position.x() >> node.position.y() >> node.position.z() >> node.radius;
            document.nodes.push_back(node);
        } else if (kind == "c") {
            std::array<std::int32_t, 2> link{};
            fields >> link[0] >> link[1];
            if (link[0] != link[1]) document.links.push_back(link);
        }
    }
    return document;
}

}  // namespace

Document monopodial_tree(std::int32_t nodes) {
    constexpr double r1 = 0.9, r2 = 0.6, a0 = 45, a2 = 45, d = 137.5, wr = 0.707;
    Document document;
    document.nodes.resize(1);
    Turtle seed;  // heading up, left to -x, as in the book
    seed.frame << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    document.nodes[0].radius = seed.width / 200;
    std::deque<Turtle> apices{seed};
    while (std::ssize(document.nodes) < nodes) {
        const Turtle at = apices.front();
        apices.pop_front();
        Node node;
        node.id = static_cast<std::int64_t>(document.nodes.size());
        node.parent = at.node;
        node.position = document.nodes[at.node].position + at.length * at.frame.col(0);
        node.radius = at.width / 200;
        document.nodes.push_back(node);

        Turtle side = at, on = at;
        side.node = on.node = static_cast<std::int32_t>(node.id);
        side.length *= r2, on.length *= r1;
        side.width *= wr, on.width *= wr;
        if (at.symbol == 'A') {
            side.symbol = 'B';
            side.frame = turned(at, a0, 1);
            on.frame = turned(at, d, 0);
        } else {
            side.symbol = at.symbol == 'B' ? 'C' : 'B';
            on.symbol = side.symbol;
            side.frame = levelled(turned(at, at.symbol == 'B' ? -a2 : a2, 2));
        }
        apices.push_back(side);
        apices.push_back(on);
    }
    return document;
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
            models.push_back({name, [path] { return read_graph(path); }, true});
    return models;
}

}  // namespace sinew::bench
