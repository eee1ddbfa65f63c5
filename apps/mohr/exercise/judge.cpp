#include "apps/mohr/exercise/judge.h"

#include "apps/mohr/exercise/answer.h"
#include "apps/mohr/exercise/slips.h"
#include "apps/mohr/exercise/words.h"
#include "ui/text/catalogue.h"

namespace mohr {

namespace {

Judgement judged(Asked asked, const Exercise& e, double answer, const Numbers& right, const Numbers& own)
{
    if (is_near(asked, e, answer, right[asked])) return {Verdict::Right};
    if (is_near(asked, e, answer, answer_from(asked, e, own)))
        return {Verdict::FollowsRight, ui::translatable("right for the numbers that you had")};
    for (const Numbers& numbers : {right, own})
        for (const Slip& slip : slips(asked, e, numbers))
            if (is_near(asked, e, answer, slip.value)) return {Verdict::Wrong, slip.words};
    return {Verdict::Wrong, hint(asked, e)};
}

} // namespace

std::vector<Judgement> judge(const Exercise& e, const std::vector<std::optional<double>>& answers)
{
    std::vector<Judgement> all;
    const Numbers right = right_numbers(e), own = own_numbers(e, answers);
    for (std::size_t i = 0; i < e.asked.size(); ++i) {
        const auto answer = i < answers.size() ? answers[i] : std::nullopt;
        all.push_back(answer ? judged(e.asked[i], e, *answer, right, own) : Judgement{});
    }
    return all;
}

} // namespace mohr
