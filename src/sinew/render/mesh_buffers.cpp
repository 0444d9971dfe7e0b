#include "sinew/render/mesh_buffers.h"

#include <algorithm>
#include <cmath>

#include "sinew/render/normals.h"

namespace sinew {
namespace {

constexpr Colour few{66, 135, 245}, five{240, 160, 40}, six{226, 58, 58}, many{168, 60, 200},
    pole{40, 170, 110};
constexpr Colour crease_colour{20, 120, 235};

std::uint32_t pack(const Vec3f& n) {
    const auto bits = [](float x) {
        return static_cast<std::uint32_t>(std::lrint(std::clamp(x, -1.f, 1.f) * 511)) & 1023u;
    };
    return bits(n.x()) | bits(n.y()) << 10 | bits(n.z()) << 20;
}

/// Writes the corners and triangles of one face after another.
class FaceWriter {
  public:
    FaceWriter(const QuadMesh& mesh, MeshBuffers& buffers) : mesh_(mesh), buffers_(buffers) {
        faces_ = face_normals(mesh);
        corners_ = corner_normals(mesh, faces_);
        buffers_.vertices.reserve(mesh.corners.size());
        buffers_.triangles.reserve(6 * mesh.face_count());
    }

    void write(std::size_t f) {
        const auto face = mesh_.face(f);
        if (face.size() == 4) return write_quad(f);
        if (face.size() == 3) return write_triangle(f);
        if (face.size() > 4) write_fan(f);
    }

  private:
    const Vec3f& position(std::size_t f, std::size_t i) const { return mesh_.positions[mesh_.face(f)[i]]; }

    void add(const Vec3f& position, const Vec3f& normal, std::size_t f, int u, int v, FacePart part) {
        buffers_.vertices.push_back({{position.x(), position.y(), position.z()},
                                     pack(normal),
                                     pack(faces_[f]),
                                     static_cast<std::uint8_t>(u * 255),
                                     static_cast<std::uint8_t>(v * 255),
                                     part});
    }
    void add_corner(std::size_t f, std::size_t i, int u, int v, FacePart part) {
        add(position(f, i), corners_[mesh_.face_offsets[f] + i], f, u, v, part);
    }
    void add_triangle(std::size_t first, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto base = static_cast<std::uint32_t>(first);
        buffers_.triangles.insert(buffers_.triangles.end(), {base + a, base + b, base + c});
    }

    /// Cut along the shorter diagonal: it follows the surface better.
    void write_quad(std::size_t f) {
        const std::size_t first = buffers_.vertices.size();
        for (int i = 0; i < 4; ++i) add_corner(f, i, i == 1 || i == 2, i >= 2, FacePart::quad);
        const float even = (position(f, 2) - position(f, 0)).squaredNorm();
        const float odd = (position(f, 3) - position(f, 1)).squaredNorm();
        const std::uint32_t turn = odd < even ? 1 : 0;
        add_triangle(first, turn, turn + 1, turn + 2);
        add_triangle(first, turn, turn + 2, (turn + 3) % 4);
    }

    void write_triangle(std::size_t f) {
        const std::size_t first = buffers_.vertices.size();
        for (int i = 0; i < 3; ++i) add_corner(f, i, i == 1, i == 2, FacePart::triangle);
        add_triangle(first, 0, 1, 2);
    }

    /// Triangles round the middle; no face of ours is like this, but files of others have them.
    void write_fan(std::size_t f) {
        const std::size_t n = mesh_.face(f).size();
        Vec3f middle = Vec3f::Zero();
        for (std::size_t i = 0; i < n; ++i) middle += position(f, i) / static_cast<float>(n);
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t first = buffers_.vertices.size();
            add(middle, faces_[f], f, 1, 0, FacePart::fan);
            add_corner(f, i, 0, 0, FacePart::fan);
            add_corner(f, (i + 1) % n, 0, 0, FacePart::fan);
            add_triangle(first, 0, 1, 2);
        }
    }

    const QuadMesh& mesh_;
    MeshBuffers& buffers_;
    std::vector<Vec3f> faces_, corners_;
};

/// What is round a vertex. The sums over the neighbours before and after it in its faces cancel where the
/// faces close round it; numbers scattered by a multiplication make a chance zero at a border as good as
/// impossible.
struct Around {
    std::uint32_t faces = 0, triangles = 0;
    std::uint64_t border = 0;
};

std::vector<Around> count_around(const QuadMesh& mesh) {
    const auto scatter = [](std::uint32_t v) { return (v + 1ull) * 0x9e3779b97f4a7c15ull; };
    std::vector<Around> around(mesh.vertex_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0, n = face.size(); i < n; ++i) {
            Around& here = around[face[i]];
            ++here.faces;
            here.triangles += n == 3;
            here.border += scatter(face[(i + 1) % n]) - scatter(face[(i + n - 1) % n]);
        }
    }
    return around;
}

Colour colour_of(const Around& around) {
    if (around.triangles == around.faces) return pole;
    if (around.faces < 4) return few;
    return around.faces == 5 ? five : around.faces == 6 ? six : many;
}

void mark_irregular(const QuadMesh& mesh, std::vector<PointMark>& marks) {
    const std::vector<Around> around = count_around(mesh);
    for (std::size_t v = 0; v < around.size(); ++v) {
        const Around& here = around[v];
        const bool is_pole = here.triangles == here.faces;
        if (here.faces == 0 || here.border != 0 || (here.faces == 4 && !is_pole)) continue;
        marks.push_back({.position = mesh.positions[v], .colour = colour_of(here)});
    }
}

}  // namespace

MeshBuffers mesh_buffers(const QuadMesh& mesh) {
    MeshBuffers buffers;
    FaceWriter writer(mesh, buffers);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) writer.write(f);
    mark_irregular(mesh, buffers.irregular);
    for (const Crease& crease : mesh.features.creases)
        buffers.creases.push_back({.from = mesh.positions[crease.edge[0]],
                                   .to = mesh.positions[crease.edge[1]],
                                   .width = 2.5f,
                                   .colour = crease_colour});
    for (const Vec3f& position : mesh.positions) buffers.bounds.extend(position);
    return buffers;
}

}  // namespace sinew
