/// @file mesher.h
/// The mesh of the newest snapshot, made on a thread of its own.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "live/pipeline.h"

namespace sinew::modeler {

/// Orders replace each other: only the newest is made. A newer one stops the one in the making, but not twice
/// in a row: while one drags, the mesh keeps up, if behind the pointer.
class Mesher {
  public:
    /// @param done  called on the mesher's thread: when there is something to draw, and once more, with
    ///              measures, where nothing newer is ordered for a moment
    using Done = std::function<void(std::shared_ptr<const LiveMesh>)>;
    explicit Mesher(Done done);
    ~Mesher();  ///< stops what is in the making and waits for it

    void order(Document document, const MeshOptions& options, std::uint64_t revision);
    /// Forgets what waits and stops what is in the making; nothing is delivered for it.
    void stop();

  private:
    struct Order {
        Document document;
        MeshOptions options;
        std::uint64_t revision = 0;
    };
    void work();
    void make(const Order& order);
    bool overtaken_soon();

    Done done_;
    Pipeline pipeline_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<Order> waiting_;
    bool working_ = false, quit_ = false, may_cancel_ = true;
    std::atomic<bool> cancel_{false};
    std::thread thread_;
};

}  // namespace sinew::modeler
