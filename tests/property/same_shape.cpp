#include "property/same_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "sinew/mesh/topology.h"

namespace sinew::property {
namespace {

/// The vertices of a mesh, to be found by place.
class Places {
  public:
    Places(const std::vector<Vec3f>& positions, float tolerance)
        : positions_(positions), tolerance_(tolerance), order_(positions.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        std::sort(order_.begin(), order_.end(),
                  [&](auto a, auto b) { return positions_[a].x() < positions_[b].x(); });
    }
    /// The lowest vertex at a place; no_index if there is none.
    std::uint32_t find(const Vec3f& place) const {
        auto at = std::lower_bound(order_.begin(), order_.end(), place.x() - tolerance_,
                                   [&](auto v, float x) { return positions_[v].x() < x; });
        std::uint32_t lowest = no_index;
        for (; at != order_.end() && positions_[*at].x() <= place.x() + tolerance_; ++at)
            if ((positions_[*at] - place).cwiseAbs().maxCoeff() <= tolerance_) lowest = std::min(lowest, *at);
        return lowest;
    }

  private:
    const std::vector<Vec3f>& positions_;
    float tolerance_;
    std::vector<std::uint32_t> order_;
};

using Face = std::vector<std::uint32_t>;

/// Faces by places, each from its lowest corner on, in order.
std::vector<Face> faces_of(const QuadMesh& mesh, const std::vector<std::uint32_t>& place) {
    std::vector<Face> faces;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        Face face;
        for (const std::uint32_t v : mesh.face(f)) face.push_back(place[v]);
        Face least = face;
        for (std::size_t k = 1; k < face.size(); ++k) {
            std::rotate(face.begin(), face.begin() + 1, face.end());
            least = std::min(least, face);
        }
        faces.push_back(least);
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

float size_of(const QuadMesh& mesh) {
    Vec3f low = Vec3f::Constant(std::numeric_limits<float>::max()), high = -low;
    for (const Vec3f& p : mesh.positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
    return mesh.positions.empty() ? 0 : std::max((high - low).maxCoeff(), 1e-3f * high.cwiseAbs().maxCoeff());
}

}  // namespace

Mat3 mirror_of(int axis) {
    Mat3 mirror = Mat3::Identity();
    mirror(axis, axis) = -1;
    return mirror;
}

QuadMesh moved(const QuadMesh& mesh, const Mat3& by) {
    QuadMesh image = mesh;
    for (Vec3f& p : image.positions) p = (by * p.cast<double>()).cast<float>();
    if (by.determinant() > 0) return image;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        std::reverse(image.corners.begin() + mesh.face_offsets[f],
                     image.corners.begin() + mesh.face_offsets[f + 1]);
    return image;
}

std::string difference_of(const QuadMesh& a, const QuadMesh& b, double tolerance) {
    if (a.vertex_count() != b.vertex_count() || a.face_count() != b.face_count())
        return fmt::format("{} vertices and {} faces, not {} and {}", b.vertex_count(), b.face_count(),
                           a.vertex_count(), a.face_count());
    const Places places(b.positions, static_cast<float>(tolerance) * size_of(b));
    std::vector<std::uint32_t> of_a, of_b;
    for (const Vec3f& p : b.positions) of_b.push_back(places.find(p));
    for (std::size_t v = 0; v < a.vertex_count(); ++v) {
        const std::uint32_t found = places.find(a.positions[v]);
        if (found == no_index) return fmt::format("nothing at vertex {}", v);
        of_a.push_back(of_b[found]);
    }
    return faces_of(a, of_a) == faces_of(b, of_b) ? "" : "faces between the same places";
}

}  // namespace sinew::property
