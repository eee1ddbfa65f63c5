#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "apps/frame/session/session.h"
#include "femoop/analysis/solver_trace.h"
#include "ui/text/message.h"

namespace frame {

/// The walk of the front that is watched: in which order of elimination, at which step, and whether it goes on by
/// itself. It follows the document; a step that is no more there becomes the last one.
class SolverShow {
public:
    static constexpr double seconds_per_step = 0.8;

    /// Traces the solver anew where the session's document is another than before.
    void follow(const Session& session);

    /// Null where there is nothing to watch: `why_none` says why.
    const femoop::SolverTrace* trace() const { return trace_ ? &*trace_ : nullptr; }
    const std::optional<ui::Message>& why_none() const { return why_none_; }

    femoop::Ordering ordering() const; ///< that was chosen, else the solver's own
    void choose(femoop::Ordering ordering);

    std::size_t n_steps() const; ///< 0 where there is nothing to watch, or too much
    std::size_t step() const { return step_; }
    void go_to(std::size_t step); ///< the last one where it is beyond

    bool is_playing() const { return is_playing_; }
    void play(); ///< from the first step where it stands at the last one
    void rest() { is_playing_ = false; }
    void advance(double seconds); ///< while it plays; it rests at the last step

private:
    std::optional<femoop::SolverTrace> trace_;
    std::optional<ui::Message> why_none_;
    std::optional<std::pair<std::uint64_t, std::uint64_t>> made_for_; ///< session and its generation
    std::optional<femoop::Ordering> ordering_;
    std::size_t step_ = 0;
    bool is_playing_ = false;
    double waited_ = 0.0; ///< since the last step [s]
};

} // namespace frame
