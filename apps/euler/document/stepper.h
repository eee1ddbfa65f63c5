#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/euler/document/step_report.h"
#include "topology/script/script_runner.h"
#include "topology/text/line_error.h"
#include "ui/text/message.h"

namespace euler {

/// A lesson: the text of a script with its comments, run as far as a place. The steps beyond it wait, as undone ones.
///
/// Back is by the inverse operators, for that is what is taught; numbers and links are restored bit for bit.
/// `undo` and `redo` are no steps: what a script takes back and does otherwise is not kept.
class Stepper {
public:
    Stepper() = default;
    /// Runs the whole script, so that the place is its end.   \throws topology::LineError with the line's number
    explicit Stepper(std::string_view script);
    /// As far as it can be run, and what stops it.
    struct Begun;
    static Begun as_far_as_it_goes(std::string_view script);

    std::size_t place() const { return runner_.n_steps(); } ///< how many steps are done
    std::size_t n_steps() const { return steps_.size(); }   ///< with those beyond the place
    void go_to(std::size_t place);                          ///< \pre place <= n_steps()

    /// Does what one more line says, here: what came after is forgotten. `undo n` and `redo n` move the place.
    /// \returns why it cannot be done, nothing then being changed
    std::optional<ui::Message> apply(std::string_view line);

    const topology::ScriptRunner& runner() const { return runner_; }
    StepSummary summary(std::size_t i) const; ///< \pre 1 <= i <= n_steps(), likewise of the next
    /// Read off the solid as the step left it: at once at the place, on a copy that goes there elsewhere.
    StepReport report(std::size_t i) const;
    topology::EulerCounts counts(std::size_t solid) const; ///< of one of the runner's solids, at the place
    std::size_t n_operators(std::size_t i) const { return runner_[i - 1].n_operators; } ///< of step i

    bool is_sweep(std::size_t i) const; ///< whether step i is many operators
    /// Writes out the step that was done last, a sweep, as its operators, and goes to before the first of them.
    void open_sweep();

    std::size_t next_line() const; ///< number that one more line would have here, from 1

    class Script;
    /// What is saved: every step with its comments, those beyond the place too.
    Script whole() const;
    std::string script() const; ///< its text
    /// The comment that the script begins with, up to its first empty line; "" if it begins otherwise.
    const ui::Message& heading() const { return heading_; }

private:
    /// What is kept of a step; all else is found again where it is asked for, so that a million steps have room.
    struct Entry {
        std::string text;         ///< the line, after the comments and empty lines above it
        std::size_t line_at = 0;  ///< where the line begins
        std::size_t solid = 0;    ///< its place in the runner's solids()
        std::size_t previous = 0; ///< the last step before on the same solid; 0 for none
        topology::OperatorKind kind = topology::OperatorKind::MVFS; ///< of its first operator
        topology::EulerCounts after;

        std::string_view line() const { return std::string_view(text).substr(line_at); }
        std::string_view above() const { return std::string_view(text).substr(0, line_at); }
    };
    std::optional<topology::LineError> run_all(std::string_view script);
    topology::LineKind run(std::string_view line);
    ui::Message warning(const std::vector<topology::Change>& changes, std::size_t solid) const;
    void forget_undone();
    std::shared_ptr<const Entry> entry(std::string_view line);
    topology::EulerCounts counts_after(std::size_t step) const; ///< all 0 of step 0
    std::vector<topology::Change> changes() const;              ///< of the step at the place

    topology::ScriptRunner runner_;
    std::vector<std::shared_ptr<const Entry>> steps_; ///< never changed, so that copies share them
    std::vector<std::vector<std::size_t>> steps_of_;  ///< by solid: which steps are its, in order
    std::string above_; ///< of the step that is read next; in the end, what follows the last step
    ui::Message heading_;
};

struct Stepper::Begun {
    Stepper lesson;
    std::optional<topology::LineError> fault; ///< with its line's number
};

/// The text of a lesson as it stood. It has the steps in common with the lesson, which never changes them, so that it
/// is cheap to take also of a million steps.
class Stepper::Script {
public:
    std::string text() const;
    bool operator==(const Script& other) const;

private:
    friend class Stepper;
    std::vector<std::shared_ptr<const Entry>> steps_;
    std::string after_; ///< the last step
};

/// The sentence of a line that cannot be run, without its place in the text.
ui::Message reason(const topology::LineError& error);

} // namespace euler
