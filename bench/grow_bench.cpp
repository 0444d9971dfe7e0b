/// How fast skeletons grow: nodes a second, from the grammar to the document, with compiling and counting in
/// it.
#include <benchmark/benchmark.h>

#include "sinew/grow/grow.h"
#include "sinew/io/files.h"

namespace sinew::bench {
namespace {

Grammar parsed(const std::string& text) {
    auto grammar = parse_grammar(text, "bench");
    if (!grammar) throw std::runtime_error(grammar.error().text());
    return *std::move(grammar);
}

Grammar example(const std::string& name) {
    return parsed(read_file(std::string(SINEW_LSYSTEMS) + "/" + name + ".lsys").value());
}

void grow_steps(benchmark::State& state, const Grammar& grammar) {
    std::size_t nodes = 0;
    for (auto _ : state) {
        const auto document = grow(grammar, {.steps = static_cast<int>(state.range(0))});
        if (!document) return state.SkipWithError(document.error().text().c_str());
        nodes = document->nodes.size();
    }
    state.counters["nodes"] = static_cast<double>(nodes);
    state.counters["nodes/s"] =
        benchmark::Counter(static_cast<double>(nodes), benchmark::Counter::kIsIterationInvariantRate);
}

void figure_2_6a(benchmark::State& state) { grow_steps(state, example("honda_a")); }
void bush(benchmark::State& state) { grow_steps(state, example("bush")); }
void chain(benchmark::State& state) { grow_steps(state, parsed("%axiom A\nA -> F A\n")); }
void in_context(benchmark::State& state) {
    grow_steps(state, parsed("%axiom BF\nB < F -> F F\nF < F -> F F\n"));
}

/// The guard alone: a tree of 2^steps nodes is refused.
void refuse(benchmark::State& state) {
    const Grammar grammar = example("honda_a");
    for (auto _ : state) {
        const auto document = grow(grammar, {.steps = static_cast<int>(state.range(0))});
        if (document) return state.SkipWithError("this should not grow");
    }
}

void parse_bush(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(example("bush"));
}

BENCHMARK(figure_2_6a)->DenseRange(10, 18, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(bush)->DenseRange(5, 9, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(chain)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(in_context)->DenseRange(10, 16, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(refuse)->Arg(60)->Unit(benchmark::kMillisecond);
BENCHMARK(parse_bush)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sinew::bench

BENCHMARK_MAIN();
