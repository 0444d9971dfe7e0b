#include "live/mesher.h"

namespace sinew::modeler {
namespace {

/// How long nothing newer must be ordered before a mesh is measured: longer than a hand rests in a drag.
constexpr std::chrono::milliseconds pause{150};

}  // namespace

Mesher::Mesher(Done done) : done_(std::move(done)), thread_([this] { work(); }) {}

Mesher::~Mesher() {
    {
        const std::lock_guard lock(mutex_);
        quit_ = true;
        waiting_.reset();
        cancel_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Mesher::order(Document document, const MeshOptions& options, std::uint64_t revision) {
    {
        const std::lock_guard lock(mutex_);
        waiting_ = Order{std::move(document), options, revision};
        if (working_ && may_cancel_) {
            cancel_ = true;
            may_cancel_ = false;
        }
    }
    wake_.notify_one();
}

void Mesher::stop() {
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    cancel_ = true;
    wake_.notify_one();
}

void Mesher::work() {
    while (true) {
        Order next;
        {
            std::unique_lock lock(mutex_);
            working_ = false;
            wake_.wait(lock, [this] { return quit_ || waiting_; });
            if (quit_) return;
            next = std::move(*waiting_);
            waiting_.reset();
            cancel_ = false;
            working_ = true;
        }
        make(next);
    }
}

bool Mesher::overtaken_soon() {
    std::unique_lock lock(mutex_);
    return wake_.wait_for(lock, pause, [this] { return quit_ || waiting_ || cancel_; });
}

void Mesher::make(const Order& order) {
    LiveMesh mesh = pipeline_.run(order.document, order.options, Progress({}, &cancel_));
    if (mesh.error && mesh.error->kind == ErrorKind::cancelled) return;
    mesh.revision = order.revision;
    {
        const std::lock_guard lock(mutex_);
        if (quit_) return;
        may_cancel_ = true;
        working_ = false;  // what follows cannot be stopped, and must not use up the right to stop the next
    }
    done_(std::make_shared<const LiveMesh>(mesh));
    if (!mesh.mesh || overtaken_soon()) return;
    measure(mesh);
    done_(std::make_shared<const LiveMesh>(std::move(mesh)));
}

}  // namespace sinew::modeler
