/// @file random_mesh.h
/// Polygon meshes of every kind, the same for the same seed.
#pragma once

#include <random>
#include <set>

#include "mesh/shapes.h"
#include "sinew/mesh/topology.h"

namespace sinew::shapes {

class RandomMesh {
  public:
    explicit RandomMesh(unsigned seed) : random_(seed) {}

    /// Mostly quads; triangles, larger polygons, holes, creases of all sharpness and corners as often as
    /// asked for.
    struct Mix {
        double split = 0.1;  ///< share of quads cut into triangles
        double merge = 0.1;  ///< share of edges taken out
        double hole = 0;     ///< share of faces taken out
        double crease = 0;   ///< share of edges
        double corner = 0;   ///< share of vertices
    };

    QuadMesh make(QuadMesh mesh, const Mix& mix) {
        for (Vec3f& p : mesh.positions)
            p += 0.15f * Vec3f(float(number() - 0.5), float(number() - 0.5), float(number() - 0.5));
        mesh = merged(mesh, mix.merge);
        mesh = split_and_cut(mesh, mix);
        for (const MeshEdge& edge : build_topology(mesh).edges)
            if (chance(mix.crease)) mesh.features.creases.push_back({edge, sharpness()});
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
            if (chance(mix.corner)) mesh.features.corners.push_back(v);
        return mesh;
    }

    double number() { return std::uniform_real_distribution<double>(0, 1)(random_); }
    bool chance(double share) { return number() < share; }

  private:
    float sharpness() {
        const float kinds[] = {0.25f, 0.5f, 1, 1.6f, 2, 2.75f, 3.3f, 10, 10, 10};
        return kinds[std::size_t(number() * 10)];
    }

    /// Takes edges out between faces that share no more than that edge's two vertices.
    QuadMesh merged(const QuadMesh& mesh, double share) {
        const Topology topology = build_topology(mesh);
        std::set<std::uint32_t> used;
        QuadMesh result;
        result.positions = mesh.positions;
        std::vector<std::vector<std::uint32_t>> faces;
        for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
            const std::uint32_t twin = topology.twin[h];
            if (twin == no_index || !chance(share)) continue;
            const std::uint32_t f = topology.half_edge_face[h], g = topology.half_edge_face[twin];
            if (used.contains(f) || used.contains(g)) continue;
            std::vector<std::uint32_t> face;
            for (std::uint32_t i = next_half_edge(mesh, topology, h); i != h;
                 i = next_half_edge(mesh, topology, i))
                face.push_back(mesh.corners[i]);
            for (std::uint32_t i = next_half_edge(mesh, topology, twin); i != twin;
                 i = next_half_edge(mesh, topology, i))
                face.push_back(mesh.corners[i]);
            if (std::set(face.begin(), face.end()).size() != face.size()) continue;
            used.insert({f, g});
            faces.push_back(face);
        }
        for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
            if (!used.contains(f)) faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
        for (const auto& face : faces) result.add_face(face);
        return result;
    }

    QuadMesh split_and_cut(const QuadMesh& mesh, const Mix& mix) {
        QuadMesh result;
        result.positions = mesh.positions;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            const auto face = mesh.face(f);
            if (chance(mix.hole)) continue;
            if (face.size() == 4 && chance(mix.split)) {
                result.add_face(std::array{face[0], face[1], face[2]});
                result.add_face(std::array{face[0], face[2], face[3]});
            } else {
                result.add_face(face);
            }
        }
        return result;
    }

    std::mt19937 random_;
};

}  // namespace sinew::shapes
