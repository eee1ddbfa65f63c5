#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "apps/mohr/exercise/judge.h"

namespace mohr {

/// An exercise that is being done.
class Practice {
public:
    explicit Practice(Exercise exercise);

    const Exercise& exercise() const { return exercise_; }
    const std::vector<std::optional<double>>& answers() const { return answers_; }
    const std::vector<Judgement>& judgements() const { return judgements_; }
    /// \pre place < exercise().asked.size()
    void answer(std::size_t place, double value);
    void give_up(); ///< the right answers stand there, without a point
    /// What stood there before they were shown, if anything did.
    std::optional<double> own_answer(std::size_t place) const
    {
        return place < own_answers_.size() ? own_answers_[place] : std::nullopt;
    }

    bool is_finished() const; ///< every answer is right, follows, or is shown
    /// The first question without an answer, then the first whose answer is wrong.
    std::optional<std::size_t> next_to_answer() const;
    int points() const; ///< one for each answer that was right the first time
    /// How far the construction may be shown without telling an answer.
    std::size_t steps_shown() const;

private:
    bool is_good(std::size_t place) const;
    bool is_known(std::initializer_list<Asked> all) const; ///< right or shown, or not asked
    std::size_t plane_steps_shown() const;
    std::size_t space_steps_shown() const;

    Exercise exercise_;
    std::vector<std::optional<double>> answers_;
    std::vector<std::optional<double>> own_answers_; ///< empty until they are given up
    std::vector<Judgement> judgements_;
    std::vector<bool> was_wrong_;
};

} // namespace mohr
