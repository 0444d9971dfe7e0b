#include "sinew/render/mesh_buffers.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>

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

/// Faces of three and four sides have a vertex a corner, and two triangles less than corners. Those of more
/// are drawn as triangles round their middle, and those of less not at all.
struct OddFaces {
    struct More {
        std::int64_t vertices = 0, triangles = 0;
    };
    std::vector<std::uint32_t> faces;
    std::vector<More> more{{}};  ///< of those before each, and of all
};
OddFaces find_odd_faces(const QuadMesh& mesh) {
    OddFaces odd;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::int64_t size = std::int64_t{mesh.face_offsets[f + 1]} - mesh.face_offsets[f];
        if (size == 3 || size == 4) continue;
        const auto& [vertices, triangles] = odd.more.back();
        odd.faces.push_back(static_cast<std::uint32_t>(f));
        odd.more.push_back(size > 4 ? OddFaces::More{vertices + 2 * size, triangles + 2}
                                    : OddFaces::More{vertices - size, triangles - size + 2});
    }
    return odd;
}

/// What all writers share. A face's place in the buffers is known from its number, so that many can write.
struct Source {
    const QuadMesh& mesh;
    Normals normals;
    std::vector<std::uint32_t> packed;  ///< the vertices' normals; 0 where there is none
    OddFaces odd;
};

/// Where a face's vertices and triangles are, behind how many odd faces.
std::size_t vertices_before(const Source& s, std::size_t face, std::size_t odd) {
    return static_cast<std::size_t>(s.mesh.face_offsets[face] + s.odd.more[odd].vertices);
}
std::size_t triangles_before(const Source& s, std::size_t face, std::size_t odd) {
    return static_cast<std::size_t>(s.mesh.face_offsets[face] - 2 * static_cast<std::int64_t>(face) +
                                    s.odd.more[odd].triangles);
}

/// Writes the corners and triangles of one face after another, in their order.
class FaceWriter {
  public:
    /// @param first  the face that is written first
    FaceWriter(const Source& source, std::size_t first, MeshBuffers& buffers)
        : mesh_(source.mesh), source_(source) {
        const auto& odd = source.odd.faces;
        const auto odd_before =
            static_cast<std::size_t>(std::lower_bound(odd.begin(), odd.end(), first) - odd.begin());
        const std::size_t vertices = vertices_before(source, first, odd_before);
        first_ = static_cast<std::uint32_t>(vertices);
        vertex_ = buffers.vertices.data() + vertices;
        index_ = buffers.triangles.data() + 3 * triangles_before(source, first, odd_before);
        const auto& splits = source.normals.splits;
        next_split_ =
            static_cast<std::size_t>(std::lower_bound(splits.begin(), splits.end(), mesh_.face_offsets[first],
                                                      [](const SplitNormal& split, std::uint32_t corner) {
                                                          return split.corner < corner;
                                                      }) -
                                     splits.begin());
    }

    void write(std::size_t f) {
        const auto face = mesh_.face(f);
        face_normal_ = pack(source_.normals.faces[f]);
        const MeshVertex* const begin = vertex_;
        if (face.size() == 4) write_quad(face, mesh_.face_offsets[f]);
        if (face.size() == 3) write_triangle(face, mesh_.face_offsets[f]);
        if (face.size() > 4) write_fan(face, mesh_.face_offsets[f]);
        first_ += static_cast<std::uint32_t>(vertex_ - begin);
    }

  private:
    using Face = std::span<const std::uint32_t>;

    void add(const Vec3f& p, std::uint32_t normal, int u, int v, FacePart part) {
        MeshVertex& vertex = *vertex_++;
        vertex.position[0] = p.x();
        vertex.position[1] = p.y();
        vertex.position[2] = p.z();
        vertex.normal = normal;
        vertex.face_normal = face_normal_;
        vertex.u = static_cast<std::uint8_t>(u * 255);
        vertex.v = static_cast<std::uint8_t>(v * 255);
        vertex.part = part;
        vertex.unused = 0;
    }
    void add_corner(std::uint32_t vertex, std::uint32_t normal, int u, int v, FacePart part) {
        add(mesh_.positions[vertex], normal, u, v, part);
    }
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        *index_++ = first_ + a;
        *index_++ = first_ + b;
        *index_++ = first_ + c;
    }

    /// The normal of the next corner; corners are asked for in their order.
    std::uint32_t normal_of(std::uint32_t vertex, std::uint32_t corner) {
        const auto& splits = source_.normals.splits;
        if (next_split_ < splits.size() && splits[next_split_].corner == corner)
            return pack(splits[next_split_++].normal);
        const std::uint32_t packed = source_.packed[vertex];
        return packed == 0 ? face_normal_ : packed;
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
    const Source& source_;
    MeshVertex* vertex_;
    std::uint32_t* index_;
    std::size_t next_split_ = 0;
    std::uint32_t face_normal_ = 0, first_ = 0;
};

void write_faces(const QuadMesh& mesh, MeshBuffers& buffers) {
    Source source{mesh, normals_of(mesh), {}, find_odd_faces(mesh)};
    source.packed.resize(mesh.vertex_count());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.vertex_count(), 4096), [&](const auto& range) {
        for (std::size_t v = range.begin(); v < range.end(); ++v)
            source.packed[v] = pack(source.normals.vertices[v]);
    });
    const std::size_t faces = mesh.face_count(), odd = source.odd.faces.size();
    buffers.vertices.resize(vertices_before(source, faces, odd));
    buffers.triangles.resize(3 * triangles_before(source, faces, odd));
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces, 4096), [&](const auto& range) {
        FaceWriter writer(source, range.begin(), buffers);
        for (std::size_t f = range.begin(); f < range.end(); ++f) writer.write(f);
    });
}

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
    tbb::parallel_invoke([&] { write_faces(mesh, buffers); },
                         [&] { mark_irregular(mesh, buffers.irregular); });
    for (const Crease& crease : mesh.features.creases)
        buffers.creases.push_back({.from = mesh.positions[crease.edge[0]],
                                   .to = mesh.positions[crease.edge[1]],
                                   .width = 2.5f,
                                   .colour = crease_colour});
    for (const Vec3f& position : mesh.positions) buffers.bounds.extend(position);
    return buffers;
}

}  // namespace sinew
