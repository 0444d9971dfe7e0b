#include "live/grower.h"

#include <chrono>

namespace sinew::modeler {

Grower::Grower(Done done) : done_(std::move(done)), thread_([this] { work(); }) {}

Grower::~Grower() {
    {
        const std::lock_guard lock(mutex_);
        quit_ = cancel_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

std::uint64_t Grower::order(std::shared_ptr<const Grammar> grammar, GrowOptions options) {
    const std::lock_guard lock(mutex_);
    waiting_ = Order{++count_, std::move(grammar), std::move(options)};
    cancel_ = true;
    wake_.notify_one();
    return count_;
}

void Grower::work() {
    while (true) {
        Order next;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return quit_ || waiting_; });
            if (quit_) return;
            next = std::move(*waiting_);
            waiting_.reset();
            cancel_ = false;
        }
        const auto start = std::chrono::steady_clock::now();
        Grown grown{next.number, grow(*next.grammar, next.options, Progress({}, &cancel_))};
        grown.ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        if (!cancel_) done_(std::make_shared<const Grown>(std::move(grown)));
    }
}

}  // namespace sinew::modeler
