/// An arm that waves: skins a skeleton, moves a node of it, skins it again, subdivides and writes.
#include <cmath>
#include <cstdio>
#include <string>

#include "sinew/io/mesh_formats.h"
#include "sinew/smooth/smooth_skin.h"

namespace {

/// A trunk with an arm of three bones. Parents are indices into the nodes; bones run from them.
sinew::Document figure() {
    sinew::Document figure;
    figure.nodes = {{.id = 10, .position = {0, 0, 0}, .radius = 0.5},
                    {.id = 11, .parent = 0, .position = {0, 0, 2}, .radius = 0.4},
                    {.id = 12, .parent = 1, .position = {0, 0, 3}, .radius = 0.35},
                    {.id = 13, .parent = 1, .position = {1, 0, 2}, .radius = 0.2},
                    {.id = 14, .parent = 3, .position = {2, 0, 2}, .radius = 0.15},
                    {.id = 15, .parent = 4, .position = {3, 0, 2}, .radius = 0.12}};
    return figure;
}

int complain(const sinew::Error& error) {
    std::fprintf(stderr, "%s\n", error.text().c_str());
    return 1;
}

}  // namespace

int main(int count, char** arguments) {
    const std::string folder = count > 1 ? arguments[1] : ".";
    sinew::Document document = figure();

    // The control mesh, as one would sculpt or rig it.
    const auto control = sinew::skin(document);
    if (!control) return complain(control.error());
    if (const auto written = sinew::write_mesh(control->mesh, folder + "/control.obj"); !written)
        return complain(written.error());

    // Smooth surfaces of what changes: the skinner remembers what a move does not change.
    sinew::SmoothSkinner skinner;
    for (int frame = 0; frame < 3; ++frame) {
        const double angle = 0.4 * frame;
        document.nodes[4].position = {1 + std::cos(angle), 0, 2 + std::sin(angle)};
        const auto smooth = skinner(document, {.levels = 2});
        if (!smooth) return complain(smooth.error());
        const sinew::QuadMesh& mesh = smooth->skin.mesh;
        const std::string file = folder + "/frame" + std::to_string(frame) + ".obj";
        if (const auto written = sinew::write_mesh(mesh, file); !written) return complain(written.error());
        std::printf("%s: %zu vertices, %zu faces\n", file.c_str(), mesh.vertex_count(), mesh.face_count());
    }

    // What cannot be is told, and where: errors are values.
    document.nodes[4].radius = -1;
    const auto refused = sinew::skin(document);
    std::printf("refused: %s\n", refused ? "nothing" : refused.error().text().c_str());
}
