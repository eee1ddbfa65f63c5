#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "apps/mohr/document/solution.h"
#include "apps/mohr/exercise/answer.h"
#include "apps/mohr/exercise/judge.h"
#include "apps/mohr/exercise/words.h"
#include "ui/text/catalogue.h"

using namespace mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("mohr");

namespace {

constexpr Difficulty all_difficulties[] = {Difficulty::Easy, Difficulty::Medium, Difficulty::Hard};

std::vector<std::optional<double>> right_answers(const Exercise& e)
{
    std::vector<std::optional<double>> answers;
    for (const Asked asked : e.asked) answers.emplace_back(solution_of(asked, e));
    return answers;
}

/// A state with σx = 50, σy = -10, τ = 40: C = 20, R = 50, 70, -30, 26.57 degrees.
Exercise beer()
{
    Exercise e = exercise(ExerciseTopic::PlaneStress, Difficulty::Hard, 1);
    e.state = {50.0, -10.0, 40.0};
    e.angle = 30.0;
    return e;
}

std::string words(const Judgement& judgement) { return ui::Catalogue()(judgement.words); }

} // namespace

TEST_CASE("An exercise is the same for its seed and another for the next one")
{
    for (const Difficulty d : all_difficulties) {
        CHECK(exercise(ExerciseTopic::PlaneStress, d, 7).state == exercise(ExerciseTopic::PlaneStress, d, 7).state);
        CHECK_FALSE(exercise(ExerciseTopic::PlaneStress, d, 7).state ==
                    exercise(ExerciseTopic::PlaneStress, d, 8).state);
    }
}

TEST_CASE("Every exercise has a circle; easy ones whole answers, hard ones a shear that the third stress governs")
{
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        for (const Difficulty d : all_difficulties) {
            const Exercise e = exercise(ExerciseTopic::PlaneStress, d, seed);
            CHECK_FALSE(why_not(document_of(e)));
            CHECK(solution_of(Asked::Radius, e) > 5.0);
        }
        const Exercise easy = exercise(ExerciseTopic::PlaneStress, Difficulty::Easy, seed),
                       hard = exercise(ExerciseTopic::PlaneStress, Difficulty::Hard, seed);
        for (const Asked asked : easy.asked)
            CHECK(solution_of(asked, easy) == Approx(std::round(solution_of(asked, easy))));
        CHECK(solution_of(Asked::LargestShear, hard) > 1.01 * solution_of(Asked::Radius, hard));
    }
}

TEST_CASE("The right answers of every exercise are judged right and agree with the circle")
{
    for (std::uint32_t seed = 0; seed < 50; ++seed)
        for (const Difficulty d : all_difficulties) {
            const Exercise e = exercise(ExerciseTopic::PlaneStress, d, seed);
            for (const Judgement& judgement : judge(e, right_answers(e))) CHECK(judgement.verdict == Verdict::Right);
            Document document = document_of(e);
            document.angle = e.angle;
            const Solution s = solve(document);
            CHECK(solution_of(Asked::First, e) == Approx(s.principal.first));
            CHECK(solution_of(Asked::Normal, e) == Approx(s.turned.x));
            CHECK(solution_of(Asked::Shear, e) == Approx(s.turned.xy));
        }
}

TEST_CASE("What follows from a wrong number by the right operation is right for the numbers that one had")
{
    // centre 30 is wrong; radius by the formula is right; 30 + 50 and 30 - 50 follow
    const auto all_judged = judge(beer(), {30.0, 50.0, 80.0, -20.0});
    CHECK(all_judged[0].verdict == Verdict::Wrong);
    CHECK(all_judged[1].verdict == Verdict::Right);
    CHECK(all_judged[2].verdict == Verdict::FollowsRight);
    CHECK(all_judged[3].verdict == Verdict::FollowsRight);
    CHECK(all_judged[4].verdict == Verdict::Open);
}

TEST_CASE("Common slips are recognized by name and the others get the operation as a hint")
{
    const auto at = [](std::size_t place, double answer) {
        std::vector<std::optional<double>> answers(8);
        answers[place] = answer;
        return judge(beer(), answers)[place];
    };
    CHECK(words(at(0, 40.0)) == "the sum is not halved");
    CHECK(words(at(0, 30.0)) == "this is half the difference: the centre is half the sum");
    CHECK(words(at(1, 70.0)) == "the legs are added: the radius is the hypotenuse");
    CHECK(words(at(1, 2500.0)) == "the square root is missing");
    CHECK(words(at(2, -30.0)) == "this is the smaller one: the first is the larger, counted with its sign");
    CHECK(words(at(4, 53.13)) == "this is 2θp, the angle on the circle: the element turns by half of it");
    CHECK(words(at(4, -26.57)) == "the sense is turned: positive is counter-clockwise, and the shear's sign counts");
    CHECK(at(4, 206.57).verdict == Verdict::Right); // half a turn more
    CHECK(words(at(5, 20.0 + 30.0 * std::cos(std::acos(-1.0) / 6.0) + 20.0)) ==
          "x′ turns by θ, the point on the circle by 2θ");
    CHECK(words(at(0, 77.0)) == "add both normal components and halve");
    CHECK(words(at(7, 100.0)) == "the difference of the extreme principal stresses is not halved");
}

TEST_SUITE_END();
