#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "apps/mohr/exercise/exercise.h"
#include "ui/text/message.h"

namespace mohr {

/// What becomes of an answer.
enum class Verdict : std::uint8_t {
    Open, ///< there is none yet
    Right,
    FollowsRight, ///< from numbers before that are wrong, by the right operation
    Wrong,
    Shown ///< the pupil gave up
};
struct Judgement {
    Verdict verdict = Verdict::Open;
    ui::Message words{}; ///< of a wrong answer: the slip where it is known, else which operation gives it
};

/// Answers by their places in `asked`; absent ones are not judged.
std::vector<Judgement> judge(const Exercise& exercise, const std::vector<std::optional<double>>& answers);

} // namespace mohr
