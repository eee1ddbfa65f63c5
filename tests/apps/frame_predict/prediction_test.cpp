#include "apps/frame/predict/prediction.h"

#include <doctest/doctest.h>

#include "femoop/analysis/linear_static.h"
#include "tests/apps/frame_predict/beams.h"

using namespace predict_test;
using frame::Outcome;
using frame::Prediction;

namespace {

constexpr MemberId AB{0}, BC{1};
constexpr CaseId case_P{0};

/// AB under a uniform load, BC a cantilever beyond it that carries nothing.
Model overhang()
{
    Model model = two_spans({uniform(7.0)});
    model.nodes[2].support.reset();
    return model;
}

Diagram parabola()
{
    return [](double x) { return x * (1.0 - x); };
}
Diagram level(double value)
{
    return [=](double) { return value; };
}

} // namespace

TEST_SUITE("frame predict")
{
    TEST_CASE("Nothing is reported of a prediction without strokes")
    {
        CHECK(!frame::assess({}, analyse(overhang()), case_P));
    }

    TEST_CASE("A member without moments on which nothing is drawn does not count; drawn as zero it is right")
    {
        const Model model = overhang();
        Prediction prediction;
        prediction.draw(model, case_P, AB, stroke(parabola()));
        auto assessment = frame::assess(prediction, analyse(model), case_P);
        REQUIRE(assessment);
        REQUIRE(assessment->members.size() == 1);
        CHECK(assessment->share > 0.99);
        prediction.draw(model, case_P, BC, stroke(level(0.005)));
        assessment = frame::assess(prediction, analyse(model), case_P);
        REQUIRE(assessment->members.size() == 2);
        CHECK(assessment->members[1].outcome == Outcome::RightlyZero);
        CHECK(assessment->share > 0.99);
    }

    TEST_CASE("Moments where there are none, and none where there are some, get nothing")
    {
        const Model model = overhang();
        Prediction prediction;
        prediction.draw(model, case_P, AB, stroke(level(0.0)));
        prediction.draw(model, case_P, BC, stroke(level(0.2)));
        const auto assessment = frame::assess(prediction, analyse(model), case_P);
        REQUIRE(assessment->members.size() == 2);
        CHECK(assessment->members[0].outcome == Outcome::DrawnAsZero);
        CHECK(assessment->members[1].outcome == Outcome::NotZero);
        CHECK(assessment->share == 0.0);
    }

    TEST_CASE("A member with moments on which nothing is drawn counts as nothing")
    {
        const Model model = two_spans({uniform(7.0)});
        Prediction prediction;
        prediction.draw(model, case_P, AB, stroke(true_diagram(moments(model))));
        const auto assessment = frame::assess(prediction, analyse(model), case_P);
        REQUIRE(assessment->members.size() == 2);
        CHECK(assessment->members[1].outcome == Outcome::NotDrawn);
        CHECK(assessment->share == doctest::Approx(0.5).epsilon(0.01));
    }

    TEST_CASE("A model that no load bends has nothing to guess but zero")
    {
        const Model model = beam(simple, {});
        Prediction prediction;
        prediction.draw(model, case_P, AB, stroke(level(0.3)));
        CHECK(frame::assess(prediction, analyse(model), case_P)->share == 0.0);
        prediction.draw(model, case_P, AB, stroke(level(0.0)));
        CHECK(frame::assess(prediction, analyse(model), case_P)->share == 1.0);
    }

    TEST_CASE("A combination is judged like a load case, and a case that is not there not at all")
    {
        Model model = beam(simple, {uniform(7.0)});
        model.combinations.push_back({.id = "C", .terms = {{.of = case_P, .factor = -1.5}}});
        Prediction prediction;
        prediction.draw(model, CaseId(1), AB, stroke([](double x) { return -x * (1.0 - x); }));
        const Results results = analyse(model);
        CHECK(frame::assess(prediction, results, CaseId(1))->share > 0.99);
        CHECK(frame::assess(prediction, results, case_P)->share < 0.55);
        CHECK(!frame::assess(prediction, results, CaseId(2)));
    }

    TEST_CASE("A guess follows its member by name and goes with it")
    {
        const Model model = two_spans({uniform(7.0)});
        Prediction prediction;
        prediction.draw(model, case_P, AB, stroke(level(0.1)));
        prediction.draw(model, case_P, BC, stroke(level(0.2)));
        Model without_first = model;
        without_first.members.erase(without_first.members.begin());
        prediction.follow(model, without_first);
        REQUIRE(prediction.on(MemberId(0)) != nullptr);
        CHECK(prediction.on(MemberId(0))->largest() == doctest::Approx(0.2));
        CHECK(prediction.on(MemberId(1)) == nullptr);
        Model without_any = model;
        without_any.members.clear();
        prediction.follow(without_first, without_any);
        CHECK(prediction.is_empty());
        CHECK(!prediction.is_stale(without_any, case_P));
    }

    TEST_CASE("A guess is stale for another model or another case, and fresh again for its own")
    {
        const Model model = beam(simple, {uniform(7.0)});
        Prediction prediction;
        CHECK(!prediction.is_stale(model, case_P));
        prediction.draw(model, case_P, AB, stroke(parabola()));
        CHECK(!prediction.is_stale(model, case_P));
        CHECK(prediction.is_stale(model, CaseId(1)));
        CHECK(prediction.is_stale(beam(fixed, {uniform(7.0)}), case_P));
        CHECK(!prediction.is_stale(model, case_P));
    }
}
