#pragma once

#include <atomic>
#include <cstddef>
#include <future>
#include <limits>
#include <memory>

#include "apps/plane/document/analysed.h"

namespace plane {

/// An analysis in a thread of its own, so that a window is drawn meanwhile. Where there is but one core it is done when it
/// is collected. What is thrown away is given up first, and ends within moments.
class AnalysisRun {
public:
    struct Limits {
        double seconds = std::numeric_limits<double>::infinity();       ///< then it gives itself up
        std::size_t unknowns = std::numeric_limits<std::size_t>::max(); ///< more are not solved for
    };
    struct Result {
        std::shared_ptr<const Analysed> analysed;
        double seconds = 0.0; ///< that it took
    };

    /// \param sizes  in place of the drawing's own; null: those  \pre solution->is_sound()
    AnalysisRun(std::shared_ptr<const Solution> solution, std::shared_ptr<const topology::SizeField> sizes,
                const Limits& limits);
    ~AnalysisRun();
    AnalysisRun(const AnalysisRun&) = delete;
    AnalysisRun& operator=(const AnalysisRun&) = delete;

    const std::shared_ptr<const Solution>& solution() const { return solution_; } ///< that it is of
    void give_up() { watch_->is_given_up = true; }
    /// Whether it is done, or is by then; infinite: waits until it is.
    bool is_done_within(double seconds) const;
    Result result() const { return result_.get(); }               ///< waits for it
    std::size_t n_unknowns() const { return watch_->n_unknowns; } ///< 0 until there is a mesh
    double share() const { return watch_->share; }                ///< of the work that solving is

private:
    std::shared_ptr<const Solution> solution_;
    std::shared_ptr<AnalysisWatch> watch_;
    std::shared_future<Result> result_;
};

} // namespace plane
