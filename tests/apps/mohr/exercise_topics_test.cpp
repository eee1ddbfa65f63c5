// Exercises of every topic: right answers agree with the library, slips are named, wrong numbers are followed through.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "apps/mohr/document/solution.h"
#include "apps/mohr/exercise/answer.h"
#include "apps/mohr/exercise/judge.h"
#include "apps/mohr/exercise/slips.h"
#include "apps/mohr/exercise/words.h"
#include "ui/text/catalogue.h"

using namespace mohr;
using doctest::Approx;
using enum Asked;

TEST_SUITE_BEGIN("mohr");

namespace {

constexpr Difficulty difficulties[] = {Difficulty::Easy, Difficulty::Medium, Difficulty::Hard};

template <class Claim> void for_every_exercise(std::uint32_t n_seeds, const Claim& claim)
{
    for (std::size_t topic = 0; topic < n_exercise_topics; ++topic)
        for (const Difficulty difficulty : difficulties)
            for (std::uint32_t seed = 1; seed <= n_seeds; ++seed) {
                CAPTURE(topic);
                CAPTURE(static_cast<int>(difficulty));
                CAPTURE(seed);
                claim(exercise(static_cast<ExerciseTopic>(topic), difficulty, seed));
            }
}

/// The judgement of one answer alone.
Judgement judged(const Exercise& e, Asked asked, double answer)
{
    std::vector<std::optional<double>> answers(e.asked.size());
    const auto place = static_cast<std::size_t>(std::ranges::find(e.asked, asked) - e.asked.begin());
    REQUIRE(place < answers.size());
    answers[place] = answer;
    return judge(e, answers)[place];
}

std::string slip(const Exercise& e, Asked asked, double answer)
{
    const Judgement judgement = judged(e, asked, answer);
    CHECK(judgement.verdict == Verdict::Wrong);
    return ui::Catalogue()(judgement.words);
}

Exercise hard(ExerciseTopic topic) { return exercise(topic, Difficulty::Hard, 3); }

} // namespace

TEST_CASE("Every exercise can be drawn and asks in order for finite numbers that are judged right")
{
    for_every_exercise(60, [](const Exercise& e) {
        const auto fault = why_not(document_of(e));
        CAPTURE(fault ? ui::Catalogue()(fault->reason) : "");
        REQUIRE_FALSE(fault);
        CHECK(std::ranges::is_sorted(e.asked));
        std::vector<std::optional<double>> answers;
        for (const Asked asked : e.asked) {
            answers.emplace_back(solution_of(asked, e));
            CHECK(std::isfinite(*answers.back()));
            CHECK_FALSE(question(asked, e, ui::Catalogue()).empty());
            CHECK_FALSE(hint(asked, e).empty());
        }
        for (const Judgement& judgement : judge(e, answers)) CHECK(judgement.verdict == Verdict::Right);
    });
}

TEST_CASE("What an exercise holds right is what the app finds of its document")
{
    for_every_exercise(25, [](const Exercise& e) {
        Document document = document_of(e);
        document.angle = e.angle;
        const Solution s = solve(document);
        const auto agrees = [&](Asked asked, double value) {
            CAPTURE(static_cast<int>(asked));
            if (std::ranges::find(e.asked, asked) != e.asked.end()) CHECK(solution_of(asked, e) == Approx(value));
        };
        agrees(First, s.principal.first);
        agrees(Second, s.principal.second);
        agrees(Centre, s.circle.centre);
        agrees(Direction, s.principal.angle.value_or(0.0) * 180.0 / std::numbers::pi);
        agrees(Normal, s.turned.x);
        agrees(Shear, femoop::mohr::given_shear(s.state.kind, s.turned.xy));
        if (e.topic == ExerciseTopic::Inertia) return;
        const auto& v = s.space_principal.values;
        agrees(Third, s.space->z);
        agrees(SpaceFirst, v[0]);
        agrees(SpaceSecond, v[1]);
        agrees(SpaceThird, v[2]);
        agrees(LargestShear, femoop::mohr::absolute_largest_shear(s.space_principal));
        agrees(Mean, s.deviator.mean);
        agrees(VonMises, s.deviator.equivalent);
        agrees(I1, s.invariants.I1);
        agrees(I2, s.invariants.I2);
        agrees(I3, s.invariants.I3);
        agrees(SpaceNormal, s.on_plane.normal_component);
        agrees(SpaceShear, s.on_plane.shear);
        if (!s.stress) return;
        const auto stress = femoop::mohr::principal(femoop::mohr::PlaneState{s.stress->x, s.stress->y, s.stress->xy});
        agrees(StressFirst, stress.first);
        agrees(StressSecond, stress.second);
    });
}

TEST_CASE("The factors of an exercise are those of the criteria")
{
    using femoop::mohr::Criterion;
    for_every_exercise(40, [](const Exercise& e) {
        if (e.topic != ExerciseTopic::Criteria) return;
        const Solution s = solve(document_of(e));
        for (const auto& [asked, criterion] : {std::pair{FactorTresca, Criterion::Tresca},
                                               {FactorVonMises, Criterion::VonMises},
                                               {FactorRankine, Criterion::Rankine},
                                               {FactorCoulomb, Criterion::MohrCoulomb}}) {
            if (std::ranges::find(e.asked, asked) == e.asked.end()) continue;
            const auto safety = femoop::mohr::safety(criterion, e.strength, s.space_principal);
            REQUIRE(safety.factor);
            CHECK(solution_of(asked, e) == Approx(*safety.factor));
        }
    });
}

TEST_CASE("A question in Portuguese has decimal commas")
{
    const ui::Catalogue tr(ui::Language::Portuguese);
    CHECK(question(Third, exercise(ExerciseTopic::PlaneStrain, Difficulty::Easy, 1), tr).find("ν = 0,2") !=
          std::string::npos);
}

TEST_CASE("A slip that is named never names the right answer")
{
    for_every_exercise(25, [](const Exercise& e) {
        const Numbers right = right_numbers(e);
        for (const Asked asked : e.asked)
            for (const Slip& slip : slips(asked, e, right)) {
                CHECK_FALSE(slip.words.empty());
                if (is_near(asked, e, slip.value, right[asked]))
                    CHECK(judged(e, asked, slip.value).verdict == Verdict::Right);
            }
    });
}

TEST_CASE("Of second moments no hint and no slip speaks of a shear, a face or a stress")
{
    for_every_exercise(25, [](const Exercise& e) {
        if (e.topic != ExerciseTopic::Inertia) return;
        std::vector<std::string> told;
        for (const Asked asked : e.asked) {
            told.emplace_back(hint(asked, e));
            for (const Slip& slip : slips(asked, e, right_numbers(e))) told.emplace_back(slip.words);
        }
        for (const std::string& words : told)
            for (const std::string_view strange : {"shear", "face", "stress", "plane", "normal"}) {
                CAPTURE(words);
                CHECK(words.find(strange) == std::string::npos);
            }
    });
}

TEST_CASE("A strain's slips are half of gamma and Hooke's law without Poisson")
{
    const Exercise e = hard(ExerciseTopic::Strain);
    const double e1 = solution_of(First, e), e2 = solution_of(Second, e), E = 1e-3 * e.E;
    const double R = solution_of(Radius, e), half = 0.5 * (e.state.x - e.state.y);
    CHECK(slip(e, Radius, std::hypot(half, 2.0 * e.state.xy)) == "the circle counts half of γ");
    CHECK(slip(e, LargestShearStrain, R) == "this is γ/2, what the circle counts; γ itself is asked");
    CHECK(slip(e, StressFirst, E * e1) == "this is Eε: the strain across counts too, by Poisson's ratio");
    CHECK(slip(e, StressSecond, E * (e2 + e.nu * e1)) == "1 − ν² below is missing");
    CHECK(slip(e, Third, 0.0) == "the surface is free: its stress is 0, not its strain");
}

TEST_CASE("A rosette's wrong gamma is followed to the radius and the stresses")
{
    const Exercise e = hard(ExerciseTopic::Rosette);
    const auto [a, b, c] = e.readings;
    const double ey = (2.0 * b + 2.0 * c - a) / 3.0, gamma = b - c; // without 2/sqrt(3)
    const double centre = 0.5 * (a + ey), radius = std::hypot(0.5 * (a - ey), 0.5 * gamma);
    std::vector<std::optional<double>> answers(e.asked.size());
    answers[0] = a;
    answers[1] = ey;
    answers[2] = gamma;
    answers[3] = centre;
    answers[4] = radius;
    answers[5] = centre + radius;
    const auto verdicts = judge(e, answers);
    CHECK(ui::Catalogue()(verdicts[2].words) == "the factor 2/√3 is missing");
    CHECK(verdicts[3].verdict == Verdict::Right);
    CHECK(verdicts[4].verdict == Verdict::FollowsRight);
    CHECK(verdicts[5].verdict == Verdict::FollowsRight);
}

TEST_CASE("A plane strain without stress across it is told the difference from plane stress")
{
    const Exercise e = exercise(ExerciseTopic::PlaneStrain, Difficulty::Hard, 2);
    CHECK(slip(e, Third, 0.0) == "that is so in plane stress: here the strain is 0, and the stress holds it so");
    CHECK(slip(e, LargestShear, solution_of(Radius, e)) ==
          "this is the largest shear in the plane: the third principal stress lies outside the circle");
}

TEST_CASE("Second moments of area turned the wrong way are told")
{
    const Exercise e = hard(ExerciseTopic::Inertia);
    CHECK(slip(e, Direction, -solution_of(Direction, e)) ==
          "the sense is turned: positive is counter-clockwise, and the product's sign counts");
    CHECK(slip(e, Shear, -solution_of(Shear, e)) == "the sign of the product is turned: the circle counts −Ixy");
}

TEST_CASE("In space the invariants and the order and the unit normal have slips of their own")
{
    const Exercise e = hard(ExerciseTopic::Space);
    const auto& s = e.space;
    CHECK(slip(e, I2, s.x * s.y + s.y * s.z + s.z * s.x) == "the shear is left out");
    CHECK(slip(e, SpaceFirst, solution_of(SpaceThird, e)) ==
          "the order is another: σ1 is the largest and σ3 the smallest, with their signs");
    CHECK(slip(e, LargestShear, solution_of(SpaceFirst, e) - solution_of(SpaceThird, e)) ==
          "the difference of the extreme principal stresses is not halved");
    const auto& n = e.normal;
    const double length = std::hypot(n[0], n[1], n[2]);
    CHECK(slip(e, SpaceNormal, solution_of(SpaceNormal, e) * length * length) == "the normal has not the length 1");
}

TEST_CASE("Whole states in space have whole components and whole principal stresses")
{
    for (std::uint32_t seed = 1; seed < 80; ++seed) {
        const Exercise e = exercise(ExerciseTopic::Space, Difficulty::Hard, seed);
        for (const Asked asked : {I1, I2, I3, SpaceFirst, SpaceSecond, SpaceThird})
            CHECK(solution_of(asked, e) == Approx(std::round(solution_of(asked, e))));
    }
}

TEST_CASE("A safety factor upside down or by another criterion is named")
{
    const Exercise e = exercise(ExerciseTopic::Criteria, Difficulty::Medium, 4);
    CHECK(slip(e, FactorVonMises, 1.0 / solution_of(FactorVonMises, e)) ==
          "it is upside down: the strength is divided by what acts");
    const double mises = solution_of(VonMises, e);
    CHECK(slip(e, VonMises, mises * mises) == "the square root is missing");
    // what follows from a wrong von Mises' stress
    std::vector<std::optional<double>> answers(e.asked.size());
    answers[2] = 2.0 * mises;
    answers[3] = e.strength.fy / (2.0 * mises);
    CHECK(judge(e, answers)[3].verdict == Verdict::FollowsRight);
    const Exercise rock = hard(ExerciseTopic::Criteria);
    CHECK(judged(rock, FactorCoulomb, 0.5 * solution_of(FactorCoulomb, rock)).verdict == Verdict::Wrong);
}

TEST_SUITE_END();
