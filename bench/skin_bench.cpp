/// How long skinning takes, stage by stage, beside a memcpy of its result: the limit is to write the mesh
/// once.
///
/// Times are the least over all iterations, in nanoseconds of a vertex of the result: processor time with one
/// thread, time on the wall with all. Run with --benchmark_filter=threads=1 for one thread only. Memory stays
/// with the process from one run to the next, as in a program that skins more than once.

#include <benchmark/benchmark.h>
#include <malloc.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <map>
#include <memory>
#include <thread>

#include "models.h"
#include "sinew/sqm/skin.h"

namespace sinew::bench {
namespace {

constexpr std::array<std::string_view, 5> stages{"condition", "polyhedra", "refine", "bridge", "place"};

double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}
double wall_time() {
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Times by stage of one run, taken from the reports of progress.
class StageClock {
  public:
    explicit StageClock(double (*now)()) : now_(now), last_(now()) {}
    void enter(std::string_view stage) {
        const double now = now_();
        if (stage_ < stages.size()) time_[stage_] += now - last_;
        last_ = now;
        stage_ = std::find(stages.begin(), stages.end(), stage) - stages.begin();
    }
    const std::array<double, stages.size()>& times() const { return time_; }

  private:
    double (*now_)();
    double last_;
    std::size_t stage_ = stages.size();
    std::array<double, stages.size()> time_{};
};

template <class T>
std::size_t bytes_of(const std::vector<T>& v) {
    return v.size() * sizeof(T);
}

/// Least time of copying the arrays of a mesh to memory that was touched before.
double copy_time(const QuadMesh& m, double (*now)()) {
    const std::pair<const void*, std::size_t> arrays[] = {
        {m.positions.data(), bytes_of(m.positions)},     {m.face_offsets.data(), bytes_of(m.face_offsets)},
        {m.corners.data(), bytes_of(m.corners)},         {m.vertex_node.data(), bytes_of(m.vertex_node)},
        {m.vertex_bone.data(), bytes_of(m.vertex_bone)}, {m.vertex_along.data(), bytes_of(m.vertex_along)}};
    std::size_t total = 0;
    for (const auto& [data, size] : arrays) total += size;
    std::vector<std::byte> to(total, std::byte{1});
    double least = 1e300;
    for (int round = 0; round < 7; ++round) {
        const double begin = now();
        std::byte* at = to.data();
        for (const auto& [data, size] : arrays) {
            std::memcpy(at, data, size);
            at += size;
        }
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
        least = std::min(least, now() - begin);
    }
    return least;
}

/// The model asked for last is kept, since a benchmark is entered several times.
const Document& document_of(const Model& model) {
    static std::string name;
    static Document document;
    if (name != model.name) document = model.make(), name = model.name;
    return document;
}

void skin_model(benchmark::State& state, const Model& model, int threads) {
    const Document& document = document_of(model);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    double (*const now)() = threads == 1 ? processor_time : wall_time;
    std::array<double, stages.size()> least;
    least.fill(1e300);
    double total = 1e300, copy = 0, vertices = 0;
    for (auto _ : state) {
        double spent = 0;
        for (int round = 0; round < 3; ++round) {  // the first one of a large model meets memory that is new
            const double begin = now();
            StageClock clock(now);
            const auto skin =
                sinew::skin(document, {.repair = model.repair},
                            Progress([&](double, std::string_view stage) { clock.enter(stage); }));
            const double time = now() - begin;
            if (!skin) return state.SkipWithError(skin.error().text().c_str());
            spent += time;
            total = std::min(total, time);
            for (std::size_t s = 0; s < stages.size(); ++s) least[s] = std::min(least[s], clock.times()[s]);
            vertices = static_cast<double>(skin->mesh.vertex_count());
            if (copy == 0) copy = copy_time(skin->mesh, now);
        }
        state.SetIterationTime(spent * 1e-9);
    }
    for (std::size_t s = 0; s < stages.size(); ++s)
        state.counters[std::string(stages[s])] = least[s] / vertices;
    state.counters["nodes"] = static_cast<double>(document.nodes.size());
    state.counters["vertices"] = vertices;
    state.counters["total"] = total / vertices;
    state.counters["ms"] = total * 1e-6;
    state.counters["ratio"] = total / copy;
}

/// One line a model.
class Table : public benchmark::BenchmarkReporter {
  public:
    bool ReportContext(const Context&) override {
        std::printf("%-30s %7s %9s %9s |", "ns a vertex", "nodes", "vertices", "ms");
        for (const std::string_view stage : stages) std::printf(" %9.*s", int(stage.size()), stage.data());
        std::printf(" | %7s %7s %8s\n", "total", "Mvert/s", "/ memcpy");
        return true;
    }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.error_occurred) {
                std::printf("%-30s %s\n", run.run_name.function_name.c_str(), run.error_message.c_str());
                continue;
            }
            const auto value = [&](std::string_view name) {
                return run.counters.at(std::string(name)).value;
            };
            std::printf("%-30s %7.0f %9.0f %9.2f |", run.run_name.function_name.c_str(), value("nodes"),
                        value("vertices"), value("ms"));
            for (const std::string_view stage : stages) std::printf(" %9.1f", value(stage));
            std::printf(" | %7.1f %7.2f %8.1f\n", value("total"), 1e3 / value("total"), value("ratio"));
            std::fflush(stdout);
            milliseconds_[run.run_name.function_name] = value("ms");
        }
    }
    void Finalize() override {
        for (const auto& [name, ms] : milliseconds_) {
            const auto small = name.find("100k");
            if (small == std::string::npos) continue;
            std::string ten = name;
            const auto large = milliseconds_.find(ten.replace(small, 4, "1M"));
            if (large != milliseconds_.end())
                std::printf("growth: %s takes %.2f times as long as %s\n", ten.c_str(), large->second / ms,
                            name.c_str());
        }
    }

  private:
    std::map<std::string, double> milliseconds_;
};

std::vector<Model> all_models() {
    std::vector<Model> models;
    for (const int n : {10, 12, 14, 16})
        models.push_back({"tree n=" + std::to_string(n), [n] { return monopodial_tree(1 << n); }, false});
    for (const int cells : {6, 12})
        models.push_back(
            {"bcc " + std::to_string(cells) + "^3", [cells] { return bcc_lattice(cells); }, false});
    for (Model& model : real_models()) models.push_back(std::move(model));
    models.push_back({"tree 100k", [] { return monopodial_tree(100'000); }, false});
    models.push_back({"tree 1M", [] { return monopodial_tree(1'000'000); }, false});
    return models;
}

}  // namespace
}  // namespace sinew::bench

int main(int argc, char** argv) {
    using namespace sinew::bench;
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);  // never
#endif
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const std::vector<Model> models = all_models();
    for (const int threads : cores > 1 ? std::vector{1, cores} : std::vector{1})
        for (const Model& model : models)
            benchmark::RegisterBenchmark(
                (model.name + ", threads=" + std::to_string(threads)).c_str(),
                [&model, threads](benchmark::State& state) { skin_model(state, model, threads); })
                ->UseManualTime()
                ->MinTime(0.3);
    Table table;
    benchmark::RunSpecifiedBenchmarks(&table);
    return 0;
}
