/// @file progress.h
/// Progress and cancellation, passed explicitly to whatever can take long.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

#include "sinew/base/result.h"

namespace sinew {

/// A cheap value: copy it freely. The default one reports to nobody and never stops.
class Progress {
  public:
    /// Called with the share done in [0, 1] and the name of the stage, from the thread that works.
    using Report = std::function<void(double share, std::string_view stage)>;

    Progress() = default;
    /// @param report   may be empty
    /// @param cancel   set it from any thread to stop the work; may be null; must outlive the work
    explicit Progress(Report report, const std::atomic<bool>* cancel = nullptr)
        : report_(std::move(report)), cancel_(cancel) {}

    void operator()(double share, std::string_view stage) const {
        if (report_) report_(share, stage);
    }
    /// Progress of a part of the work: its 0 to 1 is `begin` to `end` of this one.
    Progress part(double begin, double end) const {
        if (!report_) return *this;
        return Progress(
            [report = report_, begin, end](double share, std::string_view stage) {
                report(begin + share * (end - begin), stage);
            },
            cancel_);
    }
    bool cancelled() const { return cancel_ && cancel_->load(std::memory_order_relaxed); }

    /// What a function returns once it finds cancelled() true.
    static tl::unexpected<Error> stopped() { return fail(ErrorKind::cancelled, "stopped on request"); }

  private:
    Report report_;
    const std::atomic<bool>* cancel_ = nullptr;
};

}  // namespace sinew
