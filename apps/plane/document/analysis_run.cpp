#include "apps/plane/document/analysis_run.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "ui/files/in_background.h"

namespace plane {

AnalysisRun::AnalysisRun(std::shared_ptr<const Solution> solution, std::shared_ptr<const topology::SizeField> sizes,
                         const Limits& limits)
    : solution_(std::move(solution)), watch_(std::make_shared<AnalysisWatch>())
{
    watch_->most_unknowns = limits.unknowns;
    const auto analyse = [of = solution_, sizes = std::move(sizes), watch = watch_, most = limits.seconds] {
        using Clock = std::chrono::steady_clock;
        const auto seconds = [start = Clock::now()] {
            return std::chrono::duration<double>(Clock::now() - start).count();
        };
        const auto is_cancelled = [&] { return watch->is_given_up || seconds() > most; };
        auto analysed = std::make_shared<const Analysed>(of, is_cancelled, sizes, watch.get());
        return Result{std::move(analysed), seconds()};
    };
    result_ = std::async(ui::in_background(), analyse).share();
}

AnalysisRun::~AnalysisRun() { give_up(); }

bool AnalysisRun::is_done_within(double seconds) const
{
    if (std::isinf(seconds)) {
        result_.wait();
        return true;
    }
    return result_.wait_for(std::chrono::duration<double>(seconds)) != std::future_status::timeout;
}

} // namespace plane
