#include "cli/mesh_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "sinew/io/files.h"

namespace sinew::cli {
namespace {

constexpr std::size_t most_pairs = 1000;  // a mesh all in knots has millions

/// "3 (edges 4-7, 7-9 ...)"
template <class Place, class Name>
std::string places(const Faults<Place>& faults, std::string_view what, const Name& name) {
    if (!faults) return "0";
    std::vector<std::string> names;
    for (const Place& place : faults.examples) names.push_back(name(place));
    const bool more = faults.count > std::ssize(names);
    return fmt::format("{} ({} {}{})", faults.count, what, fmt::join(names, ", "), more ? " ..." : "");
}
std::string places(const EdgeFaults& edges) {
    return places(edges, "between vertices",
                  [](const MeshEdge& e) { return fmt::format("{}-{}", e[0], e[1]); });
}
std::string places(const IndexFaults& faults, std::string_view what) {
    return places(faults, what, [](std::uint32_t i) { return std::to_string(i); });
}

std::string verdict(const Validation& v) {
    if (!v.well_formed()) return "not well formed: corners name vertices that do not exist";
    std::vector<std::string_view> wrong;
    if (!v.finite()) wrong.push_back("not finite");
    if (!v.closed()) wrong.push_back("not closed");
    if (!v.manifold()) wrong.push_back("not manifold");
    if (!v.oriented()) wrong.push_back("not oriented alike");
    if (v.oriented() && !v.outward()) wrong.push_back("inside out");
    return wrong.empty() ? "closed, manifold, oriented outwards" : fmt::format("{}", fmt::join(wrong, ", "));
}

/// Lines of a report, the names in one column.
struct Lines {
    std::string text;
    void add(std::string_view name, const std::string& value) {
        text += fmt::format("  {:<22}{}\n", name, value);
    }
    template <class Faults, class... What>
    void add_fault(std::string_view name, const Faults& faults, What... what) {
        if (faults) add(name, places(faults, what...));
    }
};

void add_faults(Lines& lines, const Validation& v) {
    lines.add_fault("not finite", v.non_finite, "vertices");
    lines.add_fault("boundary edges", v.boundary_edges);
    lines.add_fault("non-manifold edges", v.nonmanifold_edges);
    lines.add_fault("non-manifold vertices", v.nonmanifold_vertices, "vertices");
    lines.add_fault("flipped edges", v.flipped_edges);
    lines.add_fault("inside out", v.inward_components, "components at vertices");
    lines.add_fault("faces below 3 corners", v.small_faces, "faces");
    lines.add_fault("faces that repeat", v.repeating_faces, "faces");
    lines.add_fault("loose vertices", v.loose_vertices, "vertices");
}

std::string intersections_text(const std::vector<FacePair>& pairs) {
    IndexFaults firsts;
    for (const FacePair& pair : pairs) firsts.add(pair[0]);
    return places(firsts, "the first of each pair: faces");
}

void add_measures(Lines& lines, const MeshReport& report, const std::optional<SkeletonFacts>& skeleton) {
    const Measures& m = report.measures;
    lines.add("vertices", fmt::format("{}", report.validation.vertices));
    lines.add("faces",
              fmt::format("{}: {} quads, {} triangles ({} outside the fans of poles), {} larger",
                          report.validation.faces, m.quads, m.triangles, m.stray_triangles, m.ngons));
    lines.add("components", fmt::format("{}", report.validation.components));
    lines.add("Euler number", fmt::format("{}", report.validation.euler));
    std::string irregular = fmt::format("{} ({} poles)", m.irregular_vertices, m.poles);
    if (skeleton && skeleton->plain)
        irregular += fmt::format(", the skeleton allows {}", skeleton->irregular);
    lines.add("irregular vertices", irregular);
    lines.add("largest valence", fmt::format("{}, of poles {}", m.max_valence, m.max_pole_valence));
    lines.add("faces of no area", places(m.zero_area, "faces"));
    lines.add("folded quads", places(m.folded_quads, "faces"));
    lines.add("quality of quads",
              fmt::format("{:.3f} in the mean, {:.3f} at least", m.quad_quality.mean, m.quad_quality.min));
    lines.add("area, volume", fmt::format("{:.6g}, {:.6g}", m.area, m.volume));
    if (report.intersections) {
        const std::string given_up =
            report.all_intersections ? "" : "; too many faces lie over each other to find all";
        lines.add("self-intersections", intersections_text(*report.intersections) + given_up);
    }
    if (const auto& d = report.deviation)
        lines.add("|d|/r from the cones",
                  fmt::format("{:.4f} in the mean, 95 % within {:.4f}, {:.4f} at vertex {}", d->mean_abs,
                              d->p95_abs, d->max_abs, d->worst));
}

Json validation_json(const Validation& v) {
    return {{"closed", v.closed()},
            {"manifold", v.manifold()},
            {"oriented", v.oriented()},
            {"outward", v.outward()},
            {"finite", v.finite()},
            {"vertices", v.vertices},
            {"edges", v.edges},
            {"faces", v.faces},
            {"components", v.components},
            {"euler", v.euler},
            {"boundary_edges", v.boundary_edges.count},
            {"nonmanifold_edges", v.nonmanifold_edges.count},
            {"nonmanifold_vertices", v.nonmanifold_vertices.count},
            {"flipped_edges", v.flipped_edges.count},
            {"inward_components", v.inward_components.count},
            {"loose_vertices", v.loose_vertices.count}};
}

Json measures_json(const Measures& m) {
    return {{"quads", m.quads},
            {"triangles", m.triangles},
            {"larger_faces", m.ngons},
            {"poles", m.poles},
            {"stray_triangles", m.stray_triangles},
            {"irregular", m.irregular_vertices},
            {"max_valence", m.max_valence},
            {"max_pole_valence", m.max_pole_valence},
            {"zero_area_faces", m.zero_area.count},
            {"folded_quads", m.folded_quads.count},
            {"quad_quality", {{"min", m.quad_quality.min}, {"mean", m.quad_quality.mean}}},
            {"area", m.area},
            {"volume", m.volume}};
}

}  // namespace

std::string mesh_text(const std::string& name, const MeshReport& report,
                      const std::optional<SkeletonFacts>& skeleton) {
    Lines lines{fmt::format("{}: {}\n", input_name(name), verdict(report.validation))};
    add_faults(lines, report.validation);
    if (report.validation.well_formed()) add_measures(lines, report, skeleton);
    return lines.text;
}

Json mesh_json(const MeshReport& report, const std::optional<SkeletonFacts>& skeleton) {
    Json json{{"kind", "mesh"}};
    json.update(validation_json(report.validation));
    json.update(measures_json(report.measures));
    if (report.intersections) {
        json["self_intersections"] = report.intersections->size();
        if (!report.all_intersections) json["self_intersections_complete"] = false;
        const std::size_t listed = std::min(report.intersections->size(), most_pairs);
        json["intersecting_pairs"] = std::span(*report.intersections).first(listed);
    }
    if (skeleton && skeleton->plain) json["irregular_at_most"] = skeleton->irregular;
    if (const auto& d = report.deviation)
        json["deviation"] = {{"mean", d->mean},
                             {"mean_abs", d->mean_abs},
                             {"p95_abs", d->p95_abs},
                             {"max_abs", d->max_abs},
                             {"worst_vertex", d->worst}};
    return json;
}

}  // namespace sinew::cli
