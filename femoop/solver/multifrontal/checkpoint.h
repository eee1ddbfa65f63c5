#pragma once

#include <atomic>

#include "femoop/solver/progress.h"

namespace femoop {

/// Where the members of a team pass between fronts: tells how far they are, and stops them.
class Checkpoint {
public:
    Checkpoint(const Progress& progress, double all_work) : progress_(progress), all_work_(all_work) {}

    /// \throws Cancelled once progress was answered with false.
    void pass(int member, double work)
    {
        if (!progress_) return;
        const double share = (done_ += work) / all_work_;
        // Member 0 is the thread that asked; a thousand times is often enough.
        if (member == 0 && share >= told_ + 1e-3) {
            told_ = share;
            if (!progress_(share)) is_cancelled_ = true;
        }
        if (is_cancelled_) throw Cancelled();
    }

private:
    const Progress& progress_;
    double all_work_;
    double told_ = 0.0;
    std::atomic<double> done_ = 0.0;
    std::atomic<bool> is_cancelled_ = false;
};

} // namespace femoop
