// What a person waits for in the modeler.
//
// `drag`: one node of a grown tree is dragged, through tools, model and mesher as in the window; the time is
// that from the pointer's move to the new vertex buffers, and `uploaded` until the graphics card has them.
// The aim is a median under 16 ms at 1,000 nodes and level 1. `processor` is the time of all cores together.
// `frame`: the viewport's picture of 10,000 nodes and a million quads, and its draw calls. There is no
// graphics card where Mesa draws in software: look at the calls, not at the time.
#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <ctime>

#include "live/mesher.h"
#include "models.h"
#include "render/draw_calls.h"
#include "sinew/render/egl_context.h"
#include "sinew/render/offscreen.h"
#include "tools/interaction.h"
#include "viewport/navigation.h"
#include "viewport/scene_view.h"

namespace sinew::modeler {
namespace {

using Clock = std::chrono::steady_clock;

const Vec2 window_size(1440, 900);

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Of all threads: what an edit costs, however busy the machine is with other things.
double processor_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double share_below(std::vector<double> values, double share) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * double(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

Document tree(std::int32_t nodes) { return bench::monopodial_tree(nodes); }

/// The newest mesh, waited for.
class Delivery {
  public:
    void take(std::shared_ptr<const LiveMesh> mesh) {
        const std::lock_guard lock(mutex_);
        mesh_ = std::move(mesh);
        came_.notify_one();
    }
    std::shared_ptr<const LiveMesh> wait_for(std::uint64_t revision) {
        std::unique_lock lock(mutex_);
        came_.wait(lock, [&] { return mesh_ && mesh_->revision >= revision; });
        return mesh_;
    }

  private:
    std::mutex mutex_;
    std::condition_variable came_;
    std::shared_ptr<const LiveMesh> mesh_;
};

/// OpenGL without a window, and the viewport's layers in it.
struct Card {
    EglContext context = EglContext::create().value();
    Offscreen picture =
        Offscreen::create(static_cast<int>(window_size.x()), static_cast<int>(window_size.y())).value();
    SceneView scene = SceneView::create().value();
};

/// A hand that holds a node and moves to and fro.
class Drag {
  public:
    Drag(Model& model, Interaction& tools, std::int32_t node) : tools_(tools) {
        tools.tool = Tool::move;
        const Camera camera = framed(
            home_camera(), bounds_of(model.document(), all_nodes(model.document()).nodes), window_size);
        screen_ = screen_of(camera, window_size);
        start_ = *screen_.project(model.document().nodes[node].position);
        tools.start(Modal::move, {start_}, screen_);
    }
    void move(int step) { tools_.move({start_ + Vec2(3 * (step % 20), 2 * (step % 7))}, screen_); }

  private:
    Interaction& tools_;
    Screen screen_;
    Vec2 start_;
};

void drag(benchmark::State& state) {
    Card card;
    Model model;
    Interaction tools(model);
    Delivery delivery;
    const MeshOptions options{.level = static_cast<int>(state.range(1))};
    Mesher mesher([&](std::shared_ptr<const LiveMesh> mesh) { delivery.take(std::move(mesh)); });
    model.observe([&](const Changes& changes) {
        if (changes.document) mesher.order(model.document(), options, model.revision());
    });
    model.replace(tree(static_cast<std::int32_t>(state.range(0))), true);
    const auto node = static_cast<std::int32_t>(state.range(0) / 3);
    model.select(selection_of(node));
    Drag hand(model, tools, node);
    std::vector<double> made, uploaded, processor;
    std::shared_ptr<const LiveMesh> mesh = delivery.wait_for(model.revision());
    int step = 0;
    for (auto _ : state) {
        const Clock::time_point start = Clock::now();
        const double processor_start = processor_milliseconds();
        hand.move(++step);
        mesh = delivery.wait_for(model.revision());
        made.push_back(milliseconds_since(start));
        processor.push_back(processor_milliseconds() - processor_start);
        state.SetIterationTime(made.back() / 1000);
        card.scene.set_mesh(mesh);
        glFinish();
        uploaded.push_back(milliseconds_since(start));
        if (mesh->error) return state.SkipWithError(mesh->error->text().c_str());
    }
    state.counters["median_ms"] = share_below(made, 0.5);
    state.counters["95%_ms"] = share_below(made, 0.95);
    state.counters["processor"] = share_below(processor, 0.5);
    state.counters["uploaded"] = share_below(uploaded, 0.5);
    state.counters["skin"] = mesh->skin_ms;
    state.counters["subdivide"] = mesh->subdivide_ms;
    state.counters["buffers"] = mesh->buffers_ms;
    state.counters["vertices"] = double(mesh->mesh->vertex_count());
}

void frame(benchmark::State& state) {
    Card card;
    Model model;
    Interaction tools(model);
    ViewSettings view;
    view.opacity = state.range(1) ? 0.5 : 1;
    view.irregular = true;
    model.replace(tree(static_cast<std::int32_t>(state.range(0))), true);
    auto made = std::make_shared<LiveMesh>(Pipeline().run(model.document(), {.level = 2}));
    if (made->error) return state.SkipWithError(made->error->text().c_str());
    card.scene.set_mesh(made);
    Camera camera =
        framed(home_camera(), bounds_of(model.document(), all_nodes(model.document()).nodes), window_size);
    const auto draw = [&] {
        camera = orbited(camera, Vec2(3, 0));
        card.picture.begin({40, 40, 40, 255});
        card.scene.draw(model, tools, view, camera, static_cast<int>(window_size.x()),
                        static_cast<int>(window_size.y()), 1);
        glFinish();
    };
    draw();
    const DrawCalls calls;
    draw();
    const int calls_a_frame = DrawCalls::count;
    for (auto _ : state) draw();
    state.counters["calls"] = calls_a_frame;
    state.counters["faces"] = double(made->mesh->face_count());
    state.counters["nodes"] = double(model.document().nodes.size());
}

BENCHMARK(drag)
    ->ArgNames({"nodes", "level"})
    ->Args({1000, 1})
    ->Args({1000, 2})
    ->Args({10000, 1})
    ->Iterations(200)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(frame)
    ->ArgNames({"nodes", "through"})
    ->Args({10000, 0})
    ->Args({10000, 1})
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sinew::modeler

BENCHMARK_MAIN();
