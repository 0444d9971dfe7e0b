// What subdivision costs, in nanoseconds a vertex of the finest level, beside OpenSubdiv's CPU path on the
// same meshes and levels, and beside a memcpy of the result. Compare within one run:
//     bin/subdivide_bench
// A row `build_and_refine` makes the finer mesh from nothing; `refine` makes other positions of a topology
// that is at hand.
#include <benchmark/benchmark.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/osd/cpuVertexBuffer.h>
#include <opensubdiv/osd/ompEvaluator.h>

#include <chrono>
#include <cstring>
#include <memory>

#include "sinew/mesh/limit.h"
#include "sinew/subdivide/subdivide.h"
#include "subdivide/random_mesh.h"

namespace sinew {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Osd = OpenSubdiv::Osd;
namespace Sdc = OpenSubdiv::Sdc;

enum Model : std::int64_t { quads, mixed, creased, tubes };

QuadMesh make(Model model) {
    shapes::RandomMesh random(1);
    switch (model) {
        case quads:
            return shapes::torus(200, 200);
        case mixed:
            return random.make(shapes::torus(200, 200), {});
        case creased:
            return random.make(shapes::torus(200, 200), {.split = 0, .merge = 0, .crease = 0.1});
        case tubes:
            break;
    }
    QuadMesh mesh;  // as skins are: short tubes of eight with a pole at either end
    for (int i = 0; i < 400; ++i) {
        QuadMesh tube = shapes::moved(shapes::tube(12, 8), Vec3f(3.0f * float(i), 0, 0));
        const auto shift = static_cast<std::uint32_t>(mesh.vertex_count());
        std::vector<std::uint32_t> poles = std::move(mesh.features.poles);
        for (const std::uint32_t pole : tube.features.poles) poles.push_back(pole + shift);
        mesh = shapes::together(std::move(mesh), tube);
        mesh.features.poles = std::move(poles);
    }
    return mesh;
}

const QuadMesh& model_of(const benchmark::State& state) {
    static std::map<std::int64_t, QuadMesh> made;
    const auto [found, fresh] = made.try_emplace(state.range(0));
    if (fresh) found->second = make(static_cast<Model>(state.range(0)));
    return found->second;
}

std::size_t bytes_of(const QuadMesh& mesh) {
    return 12 * mesh.vertex_count() + 4 * (mesh.corners.size() + mesh.face_offsets.size());
}

/// Runs some work, and says what it took beside a memcpy of what it made.
template <class Work>
void run(benchmark::State& state, std::size_t vertices, std::size_t bytes, const Work& work) {
    using Clock = std::chrono::steady_clock;
    const std::vector<char> from(bytes, 1);
    std::vector<char> to(bytes, 2);
    const auto start = Clock::now();
    for (auto _ : state) work();
    const auto middle = Clock::now();
    for (benchmark::IterationCount i = 0; i < state.iterations(); ++i) {
        std::memcpy(to.data(), from.data(), bytes);
        benchmark::ClobberMemory();
    }
    const double spent = std::chrono::duration<double, std::nano>(middle - start).count();
    const double copied = std::chrono::duration<double, std::nano>(Clock::now() - middle).count();
    state.counters["ns_a_vertex"] = spent / (double(vertices) * double(state.iterations()));
    state.counters["to_memcpy"] = spent / copied;
    state.counters["vertices"] = double(vertices);
}

int levels_of(const benchmark::State& state) { return static_cast<int>(state.range(1)); }

void sinew_build_and_refine(benchmark::State& state) {
    const QuadMesh& mesh = model_of(state);
    const SubdivideOptions options{.levels = levels_of(state)};
    const QuadMesh finer = *subdivide(mesh, options);
    run(state, finer.vertex_count(), bytes_of(finer),
        [&] { benchmark::DoNotOptimize(subdivide(mesh, options)->positions.data()); });
}

void sinew_refine(benchmark::State& state) {
    const QuadMesh& mesh = model_of(state);
    auto subdivider = Subdivider::build(mesh, {.levels = levels_of(state)});
    const QuadMesh& finer = subdivider->mesh();
    run(state, finer.vertex_count(), 12 * finer.vertex_count(), [&] {
        (void)subdivider->refine(mesh.positions);
        benchmark::DoNotOptimize(finer.positions.data());
    });
}

void sinew_limit_normals(benchmark::State& state) {
    auto subdivider = Subdivider::build(model_of(state), {.levels = levels_of(state), .limit = true});
    const QuadMesh& finer = subdivider->mesh();
    run(state, finer.vertex_count(), 12 * finer.corners.size(),
        [&] { benchmark::DoNotOptimize(subdivider->limit_normals().data()); });
}

void sinew_fit_step(benchmark::State& state) {
    const QuadMesh& mesh = model_of(state);
    const auto stencils = build_limit_stencils(mesh);
    std::vector<Vec3> control, target;
    for (const Vec3f& p : mesh.positions) control.push_back(p.cast<double>());
    target = control;
    run(state, mesh.vertex_count(), 24 * mesh.vertex_count(), [&] {
        fit_to_limit(*stencils, target, control, 1);
        benchmark::ClobberMemory();
    });
}

void sinew_fit_build(benchmark::State& state) {
    const QuadMesh& mesh = model_of(state);
    run(state, mesh.vertex_count(), 24 * mesh.vertex_count(),
        [&] { benchmark::DoNotOptimize(build_limit_stencils(mesh)->terms.data()); });
}

/// A mesh as OpenSubdiv takes it.
class TheirMesh {
  public:
    explicit TheirMesh(const QuadMesh& mesh) : corners_(mesh.corners.begin(), mesh.corners.end()) {
        for (std::size_t f = 0; f < mesh.face_count(); ++f) sizes_.push_back(int(mesh.face(f).size()));
        for (const Crease& crease : mesh.features.creases) {
            ends_.insert(ends_.end(), {int(crease.edge[0]), int(crease.edge[1])});
            weights_.push_back(crease.sharpness);
        }
        descriptor_.numVertices = int(mesh.vertex_count());
        descriptor_.numFaces = int(mesh.face_count());
        descriptor_.numVertsPerFace = sizes_.data();
        descriptor_.vertIndicesPerFace = corners_.data();
        descriptor_.numCreases = int(weights_.size());
        descriptor_.creaseVertexIndexPairs = ends_.data();
        descriptor_.creaseWeights = weights_.data();
    }

    std::unique_ptr<Far::TopologyRefiner> refiner(int levels) const {
        Sdc::Options options;
        options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
        using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
        std::unique_ptr<Far::TopologyRefiner> refiner(
            Factory::Create(descriptor_, Factory::Options(Sdc::SCHEME_CATMARK, options)));
        refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(levels));
        return refiner;
    }

  private:
    std::vector<int> sizes_, corners_, ends_;
    std::vector<float> weights_;
    Far::TopologyDescriptor descriptor_;
};

struct Point {
    Vec3f p = Vec3f::Zero();
    void Clear(void* = nullptr) { p.setZero(); }
    void AddWithWeight(const Point& other, float weight) { p += weight * other.p; }
};

std::vector<Point> refine_level_by_level(const Far::TopologyRefiner& refiner, const QuadMesh& mesh) {
    const Far::PrimvarRefiner primvars(refiner);
    std::vector<Point> points(mesh.vertex_count()), finer;
    for (std::size_t v = 0; v < points.size(); ++v) points[v].p = mesh.positions[v];
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
        finer.resize(std::size_t(refiner.GetLevel(level).GetNumVertices()));
        primvars.Interpolate(level, points, finer);
        points.swap(finer);
    }
    return points;
}

/// OpenSubdiv level by level, which is its quicker way where positions are refined once.
void open_subdiv_build_and_refine(benchmark::State& state) {
    const QuadMesh& mesh = model_of(state);
    const TheirMesh theirs(mesh);
    const QuadMesh finer = *subdivide(mesh, {.levels = levels_of(state)});
    run(state, finer.vertex_count(), bytes_of(finer), [&] {
        const auto refiner = theirs.refiner(levels_of(state));
        benchmark::DoNotOptimize(refine_level_by_level(*refiner, mesh).data());
    });
}

/// OpenSubdiv by stencils, its way for many positions, evaluated by OpenMP, which is what Debian builds.
void open_subdiv_refine(benchmark::State& state) {
    const QuadMesh& mesh = model_of(state);
    const auto refiner = TheirMesh(mesh).refiner(levels_of(state));
    Far::StencilTableFactory::Options options;
    options.generateIntermediateLevels = false;
    const std::unique_ptr<const Far::StencilTable> stencils(
        Far::StencilTableFactory::Create(*refiner, options));
    const auto from = std::unique_ptr<Osd::CpuVertexBuffer>(
        Osd::CpuVertexBuffer::Create(3, stencils->GetNumControlVertices()));
    const auto to =
        std::unique_ptr<Osd::CpuVertexBuffer>(Osd::CpuVertexBuffer::Create(3, stencils->GetNumStencils()));
    from->UpdateData(mesh.positions[0].data(), 0, int(mesh.vertex_count()));
    const Osd::BufferDescriptor layout(0, 3, 3);
    run(state, std::size_t(stencils->GetNumStencils()), 12 * std::size_t(stencils->GetNumStencils()), [&] {
        Osd::OmpEvaluator::EvalStencils(from.get(), layout, to.get(), layout, stencils.get());
        benchmark::DoNotOptimize(to->BindCpuBuffer());
    });
}

void models_and_levels(benchmark::internal::Benchmark* bench) {
    bench->ArgNames({"model", "levels"})->Unit(benchmark::kMillisecond)->UseRealTime();
    for (const Model model : {quads, mixed, creased, tubes})
        for (const int levels : {1, 2, 3}) bench->Args({model, levels});
}
void models(benchmark::internal::Benchmark* bench) {
    bench->ArgName("model")->Unit(benchmark::kMillisecond)->UseRealTime();
    for (const Model model : {quads, tubes}) bench->Arg(model);
}

BENCHMARK(sinew_build_and_refine)->Apply(models_and_levels);
BENCHMARK(open_subdiv_build_and_refine)->Apply(models_and_levels);
BENCHMARK(sinew_refine)->Apply(models_and_levels);
BENCHMARK(open_subdiv_refine)->Apply(models_and_levels);
BENCHMARK(sinew_limit_normals)
    ->Args({quads, 2})
    ->Args({tubes, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(sinew_fit_build)->Apply(models);
BENCHMARK(sinew_fit_step)->Apply(models);

}  // namespace
}  // namespace sinew

BENCHMARK_MAIN();
