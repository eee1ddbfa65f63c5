#include "apps/mohr/session/practice.h"

#include <algorithm>

#include "apps/mohr/exercise/answer.h"

namespace mohr {

Practice::Practice(Exercise exercise)
    : exercise_(std::move(exercise)),
      answers_(exercise_.asked.size()),
      judgements_(judge(exercise_, answers_)),
      was_wrong_(exercise_.asked.size(), false)
{}

void Practice::answer(std::size_t place, double value)
{
    answers_.at(place) = value;
    judgements_ = judge(exercise_, answers_);
    if (judgements_[place].verdict == Verdict::Wrong) was_wrong_[place] = true;
}

void Practice::give_up()
{
    own_answers_ = answers_;
    for (std::size_t i = 0; i < answers_.size(); ++i) {
        answers_[i] = solution_of(exercise_.asked[i], exercise_);
        if (is_good(i)) continue;
        was_wrong_[i] = true;
        judgements_[i] = {.verdict = Verdict::Shown};
    }
}

bool Practice::is_good(std::size_t place) const
{
    const Verdict verdict = judgements_[place].verdict;
    return verdict == Verdict::Right || verdict == Verdict::FollowsRight || verdict == Verdict::Shown;
}

bool Practice::is_finished() const
{
    for (std::size_t i = 0; i < answers_.size(); ++i)
        if (!is_good(i)) return false;
    return true;
}

std::optional<std::size_t> Practice::next_to_answer() const
{
    for (const Verdict verdict : {Verdict::Open, Verdict::Wrong}) {
        const auto first = std::ranges::find(judgements_, verdict, &Judgement::verdict);
        if (first != judgements_.end()) return static_cast<std::size_t>(first - judgements_.begin());
    }
    return std::nullopt;
}

int Practice::points() const
{
    int points = 0;
    for (std::size_t i = 0; i < answers_.size(); ++i) points += is_good(i) && !was_wrong_[i] ? 1 : 0;
    return points;
}

bool Practice::is_known(std::initializer_list<Asked> all) const
{
    return std::ranges::all_of(all, [this](Asked asked) {
        const auto place = static_cast<std::size_t>(std::ranges::find(exercise_.asked, asked) -
                                                    exercise_.asked.begin());
        return place == judgements_.size() || judgements_[place].verdict == Verdict::Right ||
               judgements_[place].verdict == Verdict::Shown;
    });
}

std::size_t Practice::steps_shown() const
{
    return exercise_.topic == ExerciseTopic::Space ? space_steps_shown() : plane_steps_shown();
}

std::size_t Practice::plane_steps_shown() const
{
    using enum Asked;
    constexpr std::size_t axes = 1, faces = 3, diameter = 4, circle = 5, principal_values = 6, pole = 8,
                          principal_planes = 9;
    const bool has_circle = std::ranges::find(exercise_.asked, Centre) != exercise_.asked.end();
    if (!is_known({StrainX, StrainY, ShearStrain})) return axes;
    if (!is_known({Centre}) || (!has_circle && !is_known({First, Second}))) return faces;
    if (!is_known({Radius})) return diameter;
    if (!is_known({First, Second})) return circle;
    if (std::ranges::find(exercise_.asked, Direction) == exercise_.asked.end()) return principal_values;
    return is_known({Direction}) ? principal_planes : pole;
}

std::size_t Practice::space_steps_shown() const
{
    using enum Asked;
    constexpr std::size_t axes = 1, circles = 5, largest_shear = 6, plane = 9;
    if (!is_known({SpaceFirst, SpaceSecond, SpaceThird})) return axes;
    if (!is_known({LargestShear})) return circles;
    return exercise_.normal != std::array<double, 3>{} && is_known({SpaceNormal, SpaceShear}) ? plane : largest_shear;
}

} // namespace mohr
