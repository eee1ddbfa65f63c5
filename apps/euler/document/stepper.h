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
#include "ui/text/phrase.h"

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

    std::size_t place() const { return runner_.n_steps(); } ///< how many steps are done
    std::size_t n_steps() const { return steps_.size(); }   ///< with those beyond the place
    void go_to(std::size_t place);                          ///< \pre place <= n_steps()

    /// Does what one more line says, here: what came after is forgotten. `undo n` and `redo n` move the place.
    /// \returns why it cannot be done, nothing then being changed
    std::optional<ui::Phrase> apply(std::string_view line);

    const topology::ScriptRunner& runner() const { return runner_; }
    const StepReport& report(std::size_t i) const { return steps_[i - 1]->report; } ///< \pre 1 <= i <= n_steps()

    /// What is saved: every step with its comments, those beyond the place too.
    std::string script() const;
    /// The comment that the script begins with, up to its first empty line; "" if it begins otherwise.
    const ui::Phrase& heading() const { return heading_; }

private:
    struct TextStep {
        std::string above; ///< comments and empty lines before the line, as they stand in the text
        StepReport report;
    };
    topology::LineKind run(std::string_view line);
    StepReport described(std::string_view line, std::vector<topology::Change> changes) const;
    topology::EulerCounts counts_before(std::size_t solid) const;

    topology::ScriptRunner runner_;
    std::vector<std::shared_ptr<const TextStep>> steps_; ///< never changed, so that copies share them
    std::string above_; ///< of the step that is read next; in the end, what follows the last step
    ui::Phrase heading_;
};

/// The sentence of a line that cannot be run, without its place in the text.
ui::Phrase reason(const topology::LineError& error);

} // namespace euler
