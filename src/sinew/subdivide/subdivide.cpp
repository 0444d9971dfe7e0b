#include "sinew/subdivide/subdivide.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "sinew/subdivide/carry.h"
#include "sinew/subdivide/limit_surface.h"
#include "sinew/subdivide/refine.h"
#include "sinew/subdivide/room.h"

namespace sinew {

struct Subdivider::Tables {
    std::size_t splits = 0;
    bool limit = false;
    std::vector<Level> levels;            ///< those that are split; the control mesh's also if none is
    std::vector<SurfaceRules> rules;      ///< of those, and of the finest level where the limit is wanted
    Flats finest_flats;                   ///< of the finest level
    Features features;                    ///< of the control mesh, without creases
    std::vector<Table<Vec3f>> positions;  ///< of the levels before the finest
    Table<Vec3f> finest_control;          ///< of the finest, where the mesh has limit positions
    QuadMesh finest;
};

namespace {

constexpr const char* stage = "subdivide";
constexpr const char* half_known = "the mesh tells of some of its vertices only where they came from";

/// Bytes a vertex of what a mesh knows of where its vertices came from.
std::uint64_t origin_bytes(const QuadMesh& mesh) {
    return 4 * (std::uint64_t{!mesh.vertex_node.empty()} + !mesh.vertex_bone.empty() +
                !mesh.vertex_along.empty());
}

/// Do the first vertices of the finer mesh, which are those of the control mesh, say that they came from the
/// same places?
bool begins_with_origins(const QuadMesh& finer, const QuadMesh& control) {
    const auto begins = [](const auto& fine, const auto& coarse) {
        return fine.empty() == coarse.empty() && std::equal(coarse.begin(), coarse.end(), fine.begin());
    };
    return begins(finer.vertex_node, control.vertex_node) && begins(finer.vertex_bone, control.vertex_bone) &&
           begins(finer.vertex_along, control.vertex_along);
}

bool knows_origins_of_all_or_none(const QuadMesh& mesh) {
    const auto fits = [&](std::size_t size) { return size == 0 || size == mesh.vertex_count(); };
    return fits(mesh.vertex_node.size()) && fits(mesh.vertex_bone.size()) && fits(mesh.vertex_along.size());
}

Result<void> check_call(const QuadMesh& mesh, const SubdivideOptions& options) {
    if (options.levels < 0)
        return fail(ErrorKind::call, fmt::format("cannot subdivide {} times", options.levels));
    if (!knows_origins_of_all_or_none(mesh)) return fail(ErrorKind::input, half_known);
    return check_control_mesh(mesh);
}

}  // namespace

/// Builds the tables of a Subdivider, step by step.
class TableBuilder {
  public:
    TableBuilder(const QuadMesh& mesh, const SubdivideOptions& options, const Progress& progress)
        : mesh_(mesh),
          options_(options),
          progress_(progress),
          tables_(std::make_unique<Subdivider::Tables>()) {}

    Result<std::unique_ptr<Subdivider::Tables>> build() {
        if (auto sound = check_call(mesh_, options_); !sound) return fail(sound.error());
        tables_->splits = static_cast<std::size_t>(options_.levels);
        tables_->limit = options_.limit;
        tables_->features = mesh_.features;
        std::vector<Crease>().swap(tables_->features.creases);  // the rules know them
        if (auto done = start(); !done) return fail(done.error());
        if (auto done = split(); !done) return fail(done.error());
        tables_->splits == 0 ? copy() : carry();
        make_room_for_positions();
        return std::move(tables_);
    }

  private:
    /// The level and the rules of the control mesh.
    Result<void> start() {
        const Topology topology = build_topology(mesh_);
        if (options_.detect_poles && mesh_.features.poles.empty())
            tables_->features.poles = detect_poles(mesh_, topology);
        auto rules = resolve_rules(mesh_, topology, tables_->features.poles);
        if (!rules) return fail(rules.error());
        tables_->levels.push_back(control_level(mesh_, topology, rules->fans));
        tables_->rules.push_back(std::move(*rules));
        const std::uint64_t memory = options_.memory > 0 ? options_.memory : bytes_available();
        return check_room(tables_->levels[0], options_.levels, options_.limit, origin_bytes(mesh_), memory);
    }

    Result<void> split() {
        std::vector<Level>& levels = tables_->levels;
        std::vector<SurfaceRules>& rules = tables_->rules;
        for (std::size_t l = 0; l < tables_->splits; ++l) {
            if (progress_.cancelled()) return Progress::stopped();
            progress_(0.4 * static_cast<double>(l) / static_cast<double>(tables_->splits), stage);
            if (l + 1 < tables_->splits || tables_->limit) rules.push_back(finer_rules(levels[l], rules[l]));
            if (l + 1 < tables_->splits) levels.push_back(finer_level(levels[l]));
        }
        return {};
    }

    void copy() {
        tables_->finest = mesh_;
        tables_->finest_flats = tables_->rules[0].flats;
    }

    void carry() {
        const SurfaceRules& rules = tables_->rules[tables_->splits - 1];
        write_finer_faces(tables_->levels.back(), tables_->finest);
        write_origins(tables_->levels, mesh_, tables_->finest);
        tables_->finest.features = finest_features(tables_->levels, rules, tables_->features);
        tables_->finest_flats = finer_flats(tables_->levels.back(), rules.flats);
    }

    void make_room_for_positions() {
        for (std::size_t l = 0; l < tables_->splits; ++l)
            tables_->positions.emplace_back(tables_->levels[l].vertices);
        const Level& last = tables_->levels.back();
        const std::size_t vertices =
            tables_->splits == 0 ? last.vertices : std::size_t{last.face_point(0)} + last.faces;
        if (tables_->splits > 0) reserve_large(tables_->finest.positions, vertices);
        tables_->finest.positions.resize(vertices);
        if (tables_->limit) tables_->finest_control.resize(vertices);
    }

    const QuadMesh& mesh_;
    const SubdivideOptions& options_;
    const Progress& progress_;
    std::unique_ptr<Subdivider::Tables> tables_;
};

Result<Subdivider> Subdivider::build(const QuadMesh& mesh, const SubdivideOptions& options,
                                     const Progress& progress) {
    try {
        auto tables = TableBuilder(mesh, options, progress).build();
        if (!tables) return fail(tables.error());
        Subdivider subdivider(std::move(*tables));
        if (progress.cancelled()) return Progress::stopped();
        progress(0.5, stage);
        if (auto done = subdivider.refine(mesh.positions); !done) return fail(done.error());
        progress(1, stage);
        return subdivider;
    } catch (const std::bad_alloc&) {
        return fail(ErrorKind::program, "there is not enough memory to subdivide", "take fewer levels");
    }
}

Subdivider::Subdivider(std::unique_ptr<Tables> tables) : tables_(std::move(tables)) {}
Subdivider::Subdivider(Subdivider&&) noexcept = default;
Subdivider& Subdivider::operator=(Subdivider&&) noexcept = default;
Subdivider::~Subdivider() = default;

const QuadMesh& Subdivider::mesh() const { return tables_->finest; }
QuadMesh Subdivider::take() && { return std::move(tables_->finest); }

Result<void> Subdivider::refine(std::span<const Vec3f> control) {
    Tables& t = *tables_;
    if (control.size() != t.levels[0].vertices)
        return fail(ErrorKind::call, fmt::format("there are {} positions for {} vertices", control.size(),
                                                 t.levels[0].vertices));
    const std::span<Vec3f> finest = t.limit ? std::span<Vec3f>(t.finest_control) : t.finest.positions;
    const std::span<Vec3f> first = t.splits == 0 ? finest : t.positions[0];
    std::copy(control.begin(), control.end(), first.begin());
    put_on_circles(t.rules[0].rounds, t.features, first);
    for (std::size_t l = 0; l < t.splits; ++l) {
        const bool last = l + 1 == t.splits;
        const Step step{std::span(t.levels).first(l + 1), t.rules[l],
                        last ? t.finest_flats : t.rules[l + 1].flats, t.features};
        refine_positions(step, t.positions[l], last ? finest : std::span<Vec3f>(t.positions[l + 1]));
    }
    if (t.limit)
        find_limit_positions({t.levels, t.splits, t.rules.back(), t.features}, t.finest_control,
                             t.finest.positions);
    return {};
}

Result<void> Subdivider::refine(const QuadMesh& control) {
    Features& features = tables_->features;
    if (control.features.circles.size() != features.circles.size() ||
        control.features.planes.size() != features.planes.size())
        return fail(ErrorKind::call, "the mesh has another number of circles or planes");
    if (control.vertex_count() != tables_->levels[0].vertices) return refine(control.positions);
    if (!knows_origins_of_all_or_none(control)) return fail(ErrorKind::call, half_known);
    const auto move_circles = [&](std::vector<Circle>& circles) {
        for (std::size_t c = 0; c < circles.size(); ++c) {
            const Circle& moved = control.features.circles[c];
            circles[c].centre = moved.centre;
            circles[c].axis = moved.axis;
            circles[c].radius = moved.radius;
        }
    };
    const auto move_planes = [&](std::vector<Plane>& planes) {
        for (std::size_t p = 0; p < planes.size(); ++p) {
            planes[p].point = control.features.planes[p].point;
            planes[p].normal = control.features.planes[p].normal;
        }
    };
    for (Features* moved : {&features, &tables_->finest.features}) {
        move_circles(moved->circles);
        move_planes(moved->planes);
    }
    if (!begins_with_origins(tables_->finest, control)) {
        QuadMesh& finest = tables_->finest;
        finest.vertex_node = control.vertex_node;
        finest.vertex_bone = control.vertex_bone;
        finest.vertex_along = control.vertex_along;
        if (tables_->splits > 0) write_origins(tables_->levels, control, finest);
    }
    return refine(control.positions);
}

std::vector<Vec3f> Subdivider::limit_normals() const {
    const Tables& t = *tables_;  // read only: several threads may ask at once
    const std::span<const Vec3f> control =
        t.limit ? std::span(t.finest_control) : std::span(t.finest.positions);
    if (t.splits == 0 || t.limit)
        return find_limit_normals({t.levels, t.splits, t.rules.back(), t.features}, control, t.finest);
    const SurfaceRules rules = finer_rules(t.levels.back(), t.rules.back());
    return find_limit_normals({t.levels, t.splits, rules, t.features}, control, t.finest);
}

Result<QuadMesh> subdivide(const QuadMesh& mesh, const SubdivideOptions& options, const Progress& progress) {
    auto subdivider = Subdivider::build(mesh, options, progress);
    if (!subdivider) return fail(subdivider.error());
    return std::move(*subdivider).take();
}

}  // namespace sinew
