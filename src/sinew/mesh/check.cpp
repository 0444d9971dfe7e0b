#include "sinew/mesh/check.h"

namespace sinew {

Result<MeshReport> check(const QuadMesh& mesh, const CheckOptions& options, const Progress& progress) {
    MeshReport report;
    if (!well_formed(mesh)) {
        report.validation = validate(mesh);
        return report;
    }
    const Topology topology = build_topology(mesh);
    report.validation = validate(mesh, topology);
    report.measures = measure(mesh, topology);
    if (options.cones && options.cones->size() > 0)
        report.deviation = measure_deviation(mesh, *options.cones);
    if (!options.self_intersections) return report;
    Result<SelfIntersections> found = find_self_intersections_within_bounds(mesh, progress);
    if (!found) return tl::unexpected(found.error());
    report.intersections = std::move(found->pairs);
    report.all_intersections = found->complete;
    return report;
}

}  // namespace sinew
