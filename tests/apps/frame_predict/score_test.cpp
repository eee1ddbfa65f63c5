#include "apps/frame/predict/score.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "tests/apps/frame_predict/beams.h"

using namespace predict_test;
using frame::Flaw;
using frame::Guess;
using frame::Score;

namespace {

constexpr double q = 7.0, P = 13.0, M = 11.0;

struct Example {
    std::string name;
    Model model;
    std::vector<double> jumps{}; ///< x/L
};

std::vector<Example> examples()
{
    Model hinged = two_spans({uniform(q)});
    hinged.members[0].end.release = {Dof::rz};
    Model ground = beam({SupportKind::Pin, SupportKind::Pin}, {force(2.0, P)});
    ground.members[0].foundation = Quantity(5000.0);
    return {{"point load", beam(simple, {force(2.0, P)})},
            {"point load near a support", beam(fixed, {force(0.7, P)})},
            {"uniform", beam(simple, {uniform(q)})},
            {"uniform, fixed", beam(fixed, {uniform(q)})},
            {"uniform, propped", beam(propped, {uniform(q)})},
            {"trapezoid", beam(simple, {trapezoid(2.0, 9.0)})},
            {"triangle, fixed", beam(fixed, {trapezoid(0.0, 9.0)})},
            {"load that changes its side", beam(simple, {trapezoid(-9.0, 8.0)})},
            {"two forces and a uniform load", beam(fixed, {force(1.4, P), force(4.1, 2 * P), uniform(q)})},
            {"applied moment", beam(simple, {moment(2.5, M)}), {2.5 / L}},
            {"applied moment, fixed", beam(fixed, {moment(3.6, M)}), {3.6 / L}},
            {"moments and a uniform load",
             beam(simple, {moment(1.5, M), moment(4.2, -2 * M), uniform(q)}),
             {1.5 / L, 4.2 / L}},
            {"hinged at its end", hinged},
            {"first of two spans", two_spans({uniform(q)})},
            {"on the ground", ground}};
}

Diagram times(double factor, const Diagram& diagram)
{
    return [=](double x) { return factor * diagram(x); };
}

/// A hand that trembles by so much of the largest ordinate, up and down at random and in slow waves.
Guess shaky(const Diagram& diagram, const std::vector<double>& jumps, double share, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform_share(-1.0, 1.0);
    const double phase = 3.0 * uniform_share(random);
    std::vector<frame::StrokePoint> points = stroke(diagram, jumps);
    for (frame::StrokePoint& point : points) {
        const double wave = std::sin(5.0 * std::numbers::pi * point.x + phase);
        point.value += 0.3 * share * (0.5 * wave + 0.5 * uniform_share(random));
    }
    Guess guess;
    guess.draw(points);
    return guess;
}

Score of(const Model& model, const Diagram& diagram) { return scored(moments(model), drawn(diagram)); }

} // namespace

TEST_SUITE("frame predict")
{
    TEST_CASE("The true diagram gets full marks, whatever its size")
    {
        for (const Example& example : examples()) {
            for (const double size : {1.0, 0.2, 5.0}) {
                CAPTURE(example.name);
                CAPTURE(size);
                const Curve curve = moments(example.model);
                const Score score = scored(curve, drawn(times(size, true_diagram(curve)), example.jumps));
                CHECK(score.share > 0.995);
                CHECK(score.zeros.n_found == score.zeros.n_true);
                CHECK(score.zeros.n_extra == 0);
                CHECK(score.jumps.n_true == static_cast<int>(example.jumps.size()));
                CHECK(score.jumps.n_found == score.jumps.n_true);
                CHECK(score.jumps.n_extra == 0);
                for (const frame::PieceMark& mark : score.pieces) CHECK(mark.flaw == Flaw::None);
            }
        }
    }

    TEST_CASE("The true diagram turned over has the wrong sign everywhere, and at most half of the points")
    {
        for (const Example& example : examples()) {
            CAPTURE(example.name);
            const Curve curve = moments(example.model);
            const Score score = scored(curve, drawn(times(-1.0, true_diagram(curve)), example.jumps));
            CHECK(score.sign < 0.01);
            CHECK(score.is_mirrored);
            CHECK(score.share < 0.51);
        }
    }

    TEST_CASE("A hand that trembles by two hundredths of the largest ordinate still scores well")
    {
        for (const Example& example : examples()) {
            for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
                CAPTURE(example.name);
                CAPTURE(seed);
                const Curve curve = moments(example.model);
                CHECK(scored(curve, shaky(true_diagram(curve), example.jumps, 0.01, seed)).share > 0.93);
                CHECK(scored(curve, shaky(true_diagram(curve), example.jumps, 0.02, seed)).share > 0.9);
            }
        }
    }

    TEST_CASE("A triangle in place of a parabola keeps sign and zeros and loses the points for the degree")
    {
        const Score score = of(beam(simple, {uniform(q)}), [](double x) { return 0.5 - std::abs(x - 0.5); });
        CHECK(score.sign == doctest::Approx(1.0));
        CHECK(score.zeros.n_found == 2);
        CHECK(score.degree < 0.3);
        CHECK(score.pieces.at(0).flaw == Flaw::Straight);
        CHECK(score.share < 0.9);
    }

    TEST_CASE("One straight line in place of a parabola has no point for the degree")
    {
        const Score score = of(beam(propped, {uniform(q)}), [](double x) { return 0.3 * (x - 1.0); });
        CHECK(score.degree < 0.05);
        CHECK(score.pieces.at(0).flaw == Flaw::Straight);
    }

    TEST_CASE("A parabola in place of two straight lines loses the points for the degree")
    {
        const Score score = of(beam(simple, {force(3.0, P)}), [](double x) { return x * (1.0 - x); });
        CHECK(score.sign == doctest::Approx(1.0));
        CHECK(score.degree < 0.5);
        CHECK(score.pieces.at(0).flaw == Flaw::Curved);
    }

    TEST_CASE("A parabola that bulges the other way is told so")
    {
        // From -1 at both ends: the true one rises to +1/2 in the middle, this one hangs to -1 between -1/2 at its
        // ends.
        const Score score = of(beam(fixed, {uniform(q)}), [](double x) { return -0.1 - 0.4 * x * (1.0 - x); });
        CHECK(score.degree == 0.0);
        CHECK(score.pieces.at(0).flaw == Flaw::OtherWay);
    }

    TEST_CASE("A slope in place of a constant, and a constant in place of a slope, are told so")
    {
        Model bent = beam({SupportKind::Fixed, SupportKind::Fixed}, {});
        bent.nodes[1].support.reset();
        bent.load_cases[0].nodes.push_back({NodeId(1), {{Dof::rz, M}}});
        CHECK(of(bent, [](double x) { return 0.3 - 0.1 * x; }).pieces.at(0).flaw == Flaw::Sloping);
        CHECK(of(bent, [](double) { return 0.3; }).share > 0.99);
        bent.load_cases[0].nodes[0] = {NodeId(1), {{Dof::uy, -P}}};
        CHECK(of(bent, [](double) { return -0.3; }).pieces.at(0).flaw == Flaw::Level);
    }

    TEST_CASE("A jump that is smoothed over loses its points")
    {
        const Model model = beam(simple, {moment(2.4, M)});
        const Curve curve = moments(model);
        const Diagram truth = true_diagram(curve);
        constexpr double place = 2.4 / L, width = 0.1;
        const Score score = of(model, [&](double x) { // straight from one side to the other
            const double t = std::clamp((x - place + width) / (2.0 * width), 0.0, 1.0);
            return t == 0.0 || t == 1.0 ? truth(x) : std::lerp(truth(place - width), truth(place + width), t);
        });
        CHECK(score.jumps.n_true == 1);
        CHECK(score.jumps.n_found == 0);
        CHECK(score.jumps.share < 0.1);
        CHECK(score.share < 0.88);
    }

    TEST_CASE("A jump to the wrong side, at the wrong place, or where there is none, loses its points")
    {
        const auto jump_at = [](double place, double size) {
            return [=](double x) { return x < place ? -size * x : size * (1.0 - x); };
        };
        const Model model = beam(simple, {moment(3.0, M)});
        const double side = true_diagram(moments(model))(0.49) > 0.0 ? -0.3 : 0.3;
        CHECK(of(model, jump_at(0.5, side)).jumps.share == doctest::Approx(1.0));
        CHECK(of(model, jump_at(0.7, side)).jumps.share == 0.0);
        CHECK(of(model, jump_at(0.5, -side)).sign < 0.01);
        const Score needless = of(beam(simple, {uniform(q)}),
                                  [](double x) { return (x < 0.6 ? 0.3 : 0.2) * 4.0 * x * (1.0 - x); });
        CHECK(needless.jumps.n_extra == 1);
        CHECK(needless.jumps.share == 0.0);
    }

    TEST_CASE("Zeros at wrong places, missing ones and needless ones are counted")
    {
        const Model model = beam(fixed, {uniform(q)}); // zeros at 0.211 and 0.789
        const auto bowl = [](double a) { return [=](double x) { return (x - a) * (1.0 - a - x); }; };
        CHECK(of(model, bowl(0.22)).zeros.n_found == 2);
        CHECK(of(model, bowl(0.05)).zeros.n_found == 0);
        const Score simply = of(model, bowl(0.0));
        CHECK(simply.zeros.n_extra == 2); // the fixed ends
        CHECK(simply.zeros.share == 0.0);
        const Score wavy = of(beam(simple, {uniform(q)}),
                              [](double x) { return 0.3 * std::sin(3.0 * std::numbers::pi * x); });
        CHECK(wavy.zeros.n_found == 2);
        CHECK(wavy.zeros.n_extra == 2);
    }

    TEST_CASE("Half a diagram gets about half of the points for its sign, and the piece is told to be missing")
    {
        const Curve curve = moments(beam(simple, {uniform(q)}));
        std::vector<frame::StrokePoint> half = stroke(true_diagram(curve));
        std::erase_if(half, [](const auto& point) { return point.x > 0.5; });
        Guess guess;
        guess.draw(half);
        const Score score = scored(curve, guess);
        CHECK(score.drawn == doctest::Approx(0.5).epsilon(0.02));
        CHECK(score.sign == doctest::Approx(0.5).epsilon(0.04));
        CHECK(score.zeros.n_found == 1);
        CHECK(score.pieces.at(0).flaw == Flaw::NotDrawn);
        CHECK(score.share < 0.6);
    }

    TEST_CASE("Nothing drawn, a line on the axis, one point and an upright stroke get next to nothing")
    {
        for (const Example& example : examples()) {
            CAPTURE(example.name);
            const Curve curve = moments(example.model);
            CHECK(scored(curve, Guess()).share == 0.0);
            CHECK(scored(curve, drawn([](double) { return 0.0; })).share == 0.0);
            Guess upright;
            upright.draw(std::vector<frame::StrokePoint>{{0.3, -0.4}, {0.3, 0.3}});
            CHECK(scored(curve, upright).share < 0.25);
        }
    }

    TEST_CASE("A scribble up and down scores badly everywhere")
    {
        for (const Example& example : examples()) {
            CAPTURE(example.name);
            const auto scribble = [](double x) { return 0.3 * std::sin(41.0 * x); };
            CHECK(scored(moments(example.model), drawn(scribble)).share < 0.5);
        }
    }

    TEST_CASE("A share is a number between 0 and 1 whatever is drawn")
    {
        std::mt19937 random(17);
        std::uniform_real_distribution<double> x(-0.4, 1.4), value(-2.0, 2.0);
        const std::vector<Example> all = examples();
        for (int i = 0; i < 400; ++i) {
            Guess guess;
            std::vector<frame::StrokePoint> points(static_cast<std::size_t>(i % 13));
            for (auto& point : points) point = {x(random), std::pow(value(random), 3)};
            guess.draw(points);
            const Score score = scored(moments(all[static_cast<std::size_t>(i) % all.size()].model), guess);
            CHECK(score.share >= 0.0);
            CHECK(score.share <= 1.0);
        }
    }
}
