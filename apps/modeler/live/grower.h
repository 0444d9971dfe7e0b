/// @file grower.h
/// The skeleton of an L-system, grown on a thread of its own while one turns its figures.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "sinew/grow/grow.h"

namespace sinew::modeler {

struct Grown {
    std::uint64_t order = 0;  ///< as returned by Grower::order
    Result<Document> document;
    double ms = 0;
};

/// Only the newest order is grown; an older one stops where it is.
class Grower {
  public:
    /// @param done  called on the grower's thread, for orders that nothing newer has overtaken
    using Done = std::function<void(std::shared_ptr<const Grown>)>;
    explicit Grower(Done done);
    ~Grower();  ///< stops what grows and waits for it

    /// @return a number that counts up
    std::uint64_t order(std::shared_ptr<const Grammar> grammar, GrowOptions options);

  private:
    struct Order {
        std::uint64_t number = 0;
        std::shared_ptr<const Grammar> grammar;
        GrowOptions options;
    };
    void work();

    Done done_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<Order> waiting_;
    std::uint64_t count_ = 0;
    bool quit_ = false;
    std::atomic<bool> cancel_{false};
    std::thread thread_;
};

}  // namespace sinew::modeler
