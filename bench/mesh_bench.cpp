// What looking at a mesh and writing it costs, in nanoseconds a face: closed grids on a torus, which nobody
// has an unfair advantage on. Sizes grow tenfold, so that growth shows.
#include <benchmark/benchmark.h>

#include <chrono>

#include "mesh/shapes.h"
#include "sinew/io/mesh_formats.h"
#include "sinew/mesh/check.h"
#include "sinew/mesh/normals.h"
#include "sinew/mesh/triangulate.h"

namespace sinew {
namespace {

/// About `faces` quads, made once for each size.
const QuadMesh& grid(std::int64_t faces) {
    static std::map<std::int64_t, QuadMesh> made;
    const auto [found, fresh] = made.try_emplace(faces);
    const auto side = static_cast<std::size_t>(std::sqrt(double(faces)));
    if (fresh) found->second = shapes::torus(side, side);
    return found->second;
}

template <class Work>
void run(benchmark::State& state, const Work& work) {
    const QuadMesh& mesh = grid(state.range(0));
    const auto start = std::chrono::steady_clock::now();
    for (auto _ : state) work(mesh);
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    state.counters["ns_a_face"] = spent.count() / (double(mesh.face_count()) * double(state.iterations()));
}

void topology(benchmark::State& state) {
    run(state, [](const QuadMesh& mesh) { benchmark::DoNotOptimize(build_topology(mesh)); });
}
void validation(benchmark::State& state) {
    const Topology topology = build_topology(grid(state.range(0)));
    run(state, [&](const QuadMesh& mesh) { benchmark::DoNotOptimize(validate(mesh, topology)); });
}
void measures(benchmark::State& state) {
    const Topology topology = build_topology(grid(state.range(0)));
    run(state, [&](const QuadMesh& mesh) { benchmark::DoNotOptimize(measure(mesh, topology)); });
}
void self_intersections(benchmark::State& state) {
    run(state, [](const QuadMesh& mesh) { benchmark::DoNotOptimize(find_self_intersections(mesh)); });
}
void triangles(benchmark::State& state) {
    run(state, [](const QuadMesh& mesh) { benchmark::DoNotOptimize(triangulate(mesh)); });
}
void normals(benchmark::State& state) {
    run(state, [](const QuadMesh& mesh) { benchmark::DoNotOptimize(vertex_normals(mesh)); });
}

/// The torus beside its own spine: as many bones as there are rings.
void deviation(benchmark::State& state) {
    const auto rings = static_cast<std::size_t>(std::sqrt(double(state.range(0))));
    RoundCones cones;
    auto at = [&](std::size_t i) {
        const double a = 2 * std::numbers::pi * double(i) / double(rings);
        return Vec3(3 * std::cos(a), 3 * std::sin(a), 0);
    };
    for (std::size_t i = 0; i < rings; ++i) cones.add(at(i), 1, at(i + 1), 1);
    run(state, [&](const QuadMesh& mesh) { benchmark::DoNotOptimize(measure_deviation(mesh, cones)); });
}

void write(benchmark::State& state, FormatName format) {
    std::size_t bytes = 0;
    run(state, [&](const QuadMesh& mesh) { bytes = mesh_bytes(mesh, format)->size(); });
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
}
void read(benchmark::State& state, FormatName format) {
    const std::string bytes = *mesh_bytes(grid(state.range(0)), format);
    run(state, [&](const QuadMesh&) { benchmark::DoNotOptimize(parse_mesh(bytes, format, "mesh")); });
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes.size()) * state.iterations());
}

void sizes(benchmark::internal::Benchmark* bench) {
    bench->Arg(10'000)
        ->Arg(100'000)
        ->Arg(1'000'000)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
}

BENCHMARK(topology)->Apply(sizes);
BENCHMARK(validation)->Apply(sizes);
BENCHMARK(measures)->Apply(sizes);
BENCHMARK(self_intersections)->Apply(sizes);
BENCHMARK(deviation)->Apply(sizes);
BENCHMARK(triangles)->Apply(sizes);
BENCHMARK(normals)->Apply(sizes);
BENCHMARK_CAPTURE(write, obj, FormatName::obj)->Apply(sizes);
BENCHMARK_CAPTURE(write, ply, FormatName::ply)->Apply(sizes);
BENCHMARK_CAPTURE(write, stl, FormatName::stl)->Apply(sizes);
BENCHMARK_CAPTURE(write, glb, FormatName::glb)->Apply(sizes);
BENCHMARK_CAPTURE(write, gltf, FormatName::gltf)->Apply(sizes);
BENCHMARK_CAPTURE(write, usda, FormatName::usda)->Apply(sizes);
BENCHMARK_CAPTURE(read, obj, FormatName::obj)->Apply(sizes);
BENCHMARK_CAPTURE(read, ply, FormatName::ply)->Apply(sizes);
BENCHMARK_CAPTURE(read, glb, FormatName::glb)->Apply(sizes);
BENCHMARK_CAPTURE(read, usda, FormatName::usda)->Apply(sizes);

}  // namespace
}  // namespace sinew

BENCHMARK_MAIN();
