#include "sinew/render/mesh_buffers.h"

#include "sinew/render/normals.h"

namespace sinew {
namespace {

constexpr Colour few{66, 135, 245}, five{240, 160, 40}, six{226, 58, 58}, many{168, 60, 200},
    pole{40, 170, 110};
constexpr Colour crease_colour{20, 120, 235};

std::uint32_t pack(const Vec3f& n) {
    const auto bits = [](float x) {
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(x * 511 + (x < 0 ? -0.5f : 0.5f))) &
               1023u;
    };
    return bits(n.x()) | bits(n.y()) << 10 | bits(n.z()) << 20;
}

/// Writes the corners and triangles of one face after another, in their order.
class FaceWriter {
  public:
    FaceWriter(const QuadMesh& mesh, MeshBuffers& buffers)
        : mesh_(mesh), buffers_(buffers), normals_(normals_of(mesh)) {
        buffers_.vertices.reserve(mesh.corners.size());
        buffers_.triangles.reserve(6 * mesh.face_count());
        packed_.reserve(mesh.vertex_count());
        for (const Vec3f& normal : normals_.vertices) packed_.push_back(pack(normal));
    }

    void write(std::size_t f) {
        const auto face = mesh_.face(f);
        face_normal_ = pack(normals_.faces[f]);
        first_ = static_cast<std::uint32_t>(buffers_.vertices.size());
        if (face.size() == 4) write_quad(face, mesh_.face_offsets[f]);
        if (face.size() == 3) write_triangle(face, mesh_.face_offsets[f]);
        if (face.size() > 4) write_fan(face, mesh_.face_offsets[f]);
    }

  private:
    using Face = std::span<const std::uint32_t>;

    void add(const Vec3f& p, std::uint32_t normal, int u, int v, FacePart part) {
        buffers_.vertices.push_back({{p.x(), p.y(), p.z()},
                                     normal,
                                     face_normal_,
                                     static_cast<std::uint8_t>(u * 255),
                                     static_cast<std::uint8_t>(v * 255),
                                     part});
    }
    void add_corner(std::uint32_t vertex, std::uint32_t normal, int u, int v, FacePart part) {
        add(mesh_.positions[vertex], normal, u, v, part);
    }
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        buffers_.triangles.insert(buffers_.triangles.end(), {first_ + a, first_ + b, first_ + c});
    }

    /// The normal of the next corner; corners are asked for in their order.
    std::uint32_t normal_of(std::uint32_t vertex, std::uint32_t corner) {
        if (next_split_ < normals_.splits.size() && normals_.splits[next_split_].corner == corner)
            return pack(normals_.splits[next_split_++].normal);
        return normals_.vertices[vertex].isZero(0) ? face_normal_ : packed_[vertex];
    }

    /// Cut along the shorter diagonal: it follows the surface better.
    void write_quad(Face face, std::uint32_t corner) {
        for (std::uint32_t i = 0; i < 4; ++i)
            add_corner(face[i], normal_of(face[i], corner + i), i == 1 || i == 2, i >= 2, FacePart::quad);
        const auto at = [&](std::size_t i) -> const Vec3f& { return mesh_.positions[face[i]]; };
        const std::uint32_t turn = (at(3) - at(1)).squaredNorm() < (at(2) - at(0)).squaredNorm() ? 1 : 0;
        add_triangle(turn, turn + 1, turn + 2);
        add_triangle(turn, turn + 2, (turn + 3) % 4);
    }

    void write_triangle(Face face, std::uint32_t corner) {
        for (std::uint32_t i = 0; i < 3; ++i)
            add_corner(face[i], normal_of(face[i], corner + i), i == 1, i == 2, FacePart::triangle);
        add_triangle(0, 1, 2);
    }

    /// Triangles round the middle; no face of ours is like this, but files of others have them.
    void write_fan(Face face, std::uint32_t corner) {
        const auto n = static_cast<std::uint32_t>(face.size());
        std::vector<std::uint32_t> normals(n);
        Vec3f middle = Vec3f::Zero();
        for (std::uint32_t i = 0; i < n; ++i) {
            normals[i] = normal_of(face[i], corner + i);
            middle += mesh_.positions[face[i]] / static_cast<float>(n);
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t j = (i + 1) % n;
            add(middle, face_normal_, 1, 0, FacePart::fan);
            add_corner(face[i], normals[i], 0, 0, FacePart::fan);
            add_corner(face[j], normals[j], 0, 0, FacePart::fan);
            add_triangle(3 * i, 3 * i + 1, 3 * i + 2);
        }
    }

    const QuadMesh& mesh_;
    MeshBuffers& buffers_;
    Normals normals_;
    std::vector<std::uint32_t> packed_;  ///< the vertices' normals
    std::size_t next_split_ = 0;
    std::uint32_t face_normal_ = 0, first_ = 0;
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
            here.border += scatter(face[i + 1 < n ? i + 1 : 0]) - scatter(face[i > 0 ? i - 1 : n - 1]);
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
