#include "sinew/sqm/outward.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "sinew/sqm/counts/regions.h"

namespace sinew::sqm {
namespace {

/// A sum smaller than this part of what it is made of may owe its sign to the order of its terms: a thousand
/// million terms of double precision change it by 1e-7 of that.
constexpr double sign_is_sure = 1e-6;

/// Faces that follow each other in the mesh and belong to one component.
struct FaceRun {
    std::uint32_t begin = 0, end = 0;
    std::int32_t component = 0;
};

/// Six times a signed volume, and what it would be if all its terms had one sign.
struct Volume {
    double sum = 0, size = 0;
};

/// The runs of the mesh in the order of their faces, and what their components are.
class Components {
  public:
    Components(const Parts& d, const Bridge& b) : d_(d), b_(b), regions_(find_regions(d.network)) {
        origin.assign(regions_.components, no_vertex);
        for (std::int32_t j = d.network.joint_count() - 1; j >= 0; --j)
            origin[regions_.component[j]] = d.points.first[j];
        paths();
        capped();
        lone();
    }

    std::vector<FaceRun> runs;
    std::vector<std::uint32_t> origin;  ///< component -> its lowest vertex

  private:
    void add(std::uint32_t faces, std::int32_t component) {
        const std::uint32_t begin = runs.empty() ? 0 : runs.back().end;
        runs.push_back({begin, begin + faces, component});
    }
    std::int32_t new_component(std::uint32_t lowest_vertex) {
        origin.push_back(lowest_vertex);
        return static_cast<std::int32_t>(origin.size()) - 1;
    }
    void paths() {
        for (std::int32_t p = 0; p < d_.network.path_count(); ++p) {
            const std::int32_t known = regions_.component_of(d_.network, p);
            add(b_.path_face[p + 1] - b_.path_face[p], known < 0 ? new_component(b_.path_vertex[p]) : known);
        }
    }
    /// Cells without a bone come joint after joint, as Bridge::capped has them.
    void capped() {
        std::int32_t joint = 0;
        for (const std::int32_t cell : b_.capped) {
            while (d_.polyhedra.cell_first[joint + 1] <= cell) ++joint;
            std::uint32_t faces = 0;
            for (const CellSide& side : d_.polyhedra.cell(cell)) faces += d_.refinement.pieces[side.arc];
            add(faces, regions_.component[joint]);
        }
    }
    void lone() {
        const auto points = static_cast<std::uint32_t>(lone_sphere_points().size()),
                   faces = static_cast<std::uint32_t>(lone_sphere_faces().size());
        for (std::uint32_t i = 0; i < d_.network.lone.size(); ++i)
            add(faces, new_component(b_.lone_vertex + i * points));
    }

    const Parts& d_;
    const Bridge& b_;
    Regions regions_;
};

/// Adds the wedges between the faces of a run and the lowest vertex of its component.
void add_wedges(const QuadMesh& mesh, const FaceRun& run, std::uint32_t origin, Volume& volume) {
    const Vec3 from = mesh.positions[origin].cast<double>();
    for (std::uint32_t f = run.begin; f < run.end; ++f) {
        const auto face = mesh.face(f);
        const auto corner = [&](std::size_t i) -> Vec3 {
            return mesh.positions[face[i]].cast<double>() - from;
        };
        double wedge = 0;
        for (std::size_t i = 2; i < face.size(); ++i) {
            const double part = corner(0).dot(corner(i - 1).cross(corner(i)));
            wedge += part;
            volume.size += std::abs(part);
        }
        volume.sum += wedge;
    }
}

/// Component -> whether it is inside out.
std::vector<std::uint8_t> find_inward(const QuadMesh& mesh, const Components& components) {
    const auto& runs = components.runs;
    std::vector<Volume> of_run(runs.size()), total(components.origin.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, runs.size(), 128), [&](const auto& range) {
        for (std::size_t r = range.begin(); r < range.end(); ++r)
            add_wedges(mesh, runs[r], components.origin[runs[r].component], of_run[r]);
    });
    for (std::size_t r = 0; r < runs.size(); ++r) {
        total[runs[r].component].sum += of_run[r].sum;
        total[runs[r].component].size += of_run[r].size;
    }
    const auto is_sure = [&](const Volume& v) { return std::abs(v.sum) > sign_is_sure * v.size; };
    std::vector<Volume> again(total.size());
    for (const FaceRun& run : runs)
        if (!is_sure(total[run.component]))
            add_wedges(mesh, run, components.origin[run.component], again[run.component]);
    std::vector<std::uint8_t> inward(total.size());
    for (std::size_t c = 0; c < total.size(); ++c)
        inward[c] = (is_sure(total[c]) ? total[c] : again[c]).sum < 0;
    return inward;
}

void turn_faces(const FaceRun& run, QuadMesh& mesh) {
    for (std::uint32_t f = run.begin; f < run.end; ++f)
        std::reverse(mesh.corners.begin() + mesh.face_offsets[f] + 1,
                     mesh.corners.begin() + mesh.face_offsets[f + 1]);
}

}  // namespace

std::int64_t turn_outward(const Parts& parts, Bridge& bridge) {
    QuadMesh& mesh = bridge.mesh;
    const Components components(parts, bridge);
    const std::vector<std::uint8_t> inward = find_inward(mesh, components);
    const auto turned = std::count(inward.begin(), inward.end(), 1);
    if (turned == 0) return 0;
    for (const FaceRun& run : components.runs)
        if (inward[run.component]) turn_faces(run, mesh);
    for (Plane& plane : mesh.features.planes) {
        if (plane.faces.empty()) continue;
        const auto run = std::partition_point(components.runs.begin(), components.runs.end(),
                                              [&](const FaceRun& r) { return r.end <= plane.faces[0]; });
        if (inward[run->component]) plane.normal = -plane.normal;
    }
    return turned;
}

}  // namespace sinew::sqm
