// An influence line as what is guessed: what is known of it, and how a sketch of it is judged.
#include <doctest/doctest.h>

#include "apps/frame/predict/prediction.h"
#include "apps/frame/predict/profile.h"
#include "femoop/methods/influence/influence_line.h"
#include "tests/apps/frame_predict/beams.h"

using namespace predict_test;
using femoop::MovingEffect;
using femoop::influence::InfluenceLine;
using femoop::influence::PathLayout;
using frame::Outcome;
using frame::Prediction;
using frame::Truth;

namespace {

constexpr MemberId first{0}, second{1};

struct Line {
    PathLayout path;
    InfluenceLine line;

    Truth on(std::size_t member) const { return frame::truth(line, path.members[member]); }
};

MovingEffect section_force(MemberId member, femoop::MemberComponent component, double percent)
{
    MovingEffect effect;
    effect.member = member;
    effect.component = component;
    effect.at = femoop::Percent{percent};
    return effect;
}

Line line_of(const Model& model, const MovingEffect& effect)
{
    femoop::influence::InfluenceAnalysis analysis(model);
    std::vector<MemberId> members;
    for (std::size_t i = 0; i < model.members.size(); ++i) members.emplace_back(i);
    const PathLayout path = femoop::influence::lay_out(model, members);
    return {path, analysis.line(path, femoop::influence::unit_load(model.analysis, {}), effect)};
}

/// The first member is simply supported, the second an overhang beyond it.
Model span_with_overhang()
{
    Model model = two_spans({uniform(7.0)});
    model.nodes[2].support.reset();
    return model;
}

/// As a hand that knows the line would draw it, an ordinate of 1 so many lengths of the member high.
std::vector<frame::StrokePoint> stroke(const Truth& truth, double scale)
{
    std::vector<frame::StrokePoint> points;
    for (std::size_t i = 0; i < truth.profile.size(); ++i)
        points.push_back({frame::Guess::x(i), scale * truth.largest * truth.profile[i].value_or(0.0)});
    return points;
}

Prediction drawn(const Model& model, const Line& line, double sign = 1.0)
{
    const double scale = sign * 0.3 / line.line.ordinates.largest();
    Prediction prediction;
    for (std::size_t i = 0; i < line.path.members.size(); ++i)
        prediction.draw(model, line.line.effect, line.path.members[i].member, stroke(line.on(i), scale));
    return prediction;
}

} // namespace

TEST_SUITE("frame predict")
{
    TEST_CASE("The moment's line of a simple span is two straight pieces that begin and end at zero")
    {
        const Truth truth =
            line_of(span_with_overhang(), section_force(first, femoop::MemberComponent::Mz, 25.0)).on(0);
        REQUIRE(truth.pieces.size() == 2);
        CHECK(truth.pieces[0].degree == 1);
        CHECK(truth.pieces[1].degree == 1);
        CHECK(truth.pieces[0].to == doctest::Approx(0.25));
        CHECK(truth.zeros == std::vector{0.0, 1.0});
        CHECK(truth.jumps.empty());
    }

    TEST_CASE("The shear's line jumps by one at its section, with a slope to either side")
    {
        const Line line = line_of(span_with_overhang(), section_force(first, femoop::MemberComponent::Vy, 50.0));
        const Truth truth = line.on(0);
        REQUIRE(truth.jumps.size() == 1);
        CHECK(truth.jumps[0].x == doctest::Approx(0.5));
        CHECK(std::abs(truth.jumps[0].size) * truth.largest == doctest::Approx(1.0));
        REQUIRE(truth.pieces.size() == 2);
        CHECK(truth.pieces[0].degree == 1);
    }

    TEST_CASE("Over two spans the lines are cubic parabolas")
    {
        const Line line = line_of(two_spans({uniform(7.0)}), section_force(first, femoop::MemberComponent::Mz, 50.0));
        for (const Truth::Piece& piece : line.on(0).pieces) CHECK(piece.degree == 3);
        REQUIRE(line.on(1).pieces.size() == 1);
        CHECK(line.on(1).pieces.front().degree == 3);
        CHECK(line.on(1).zeros == std::vector{0.0, 1.0});
    }

    TEST_CASE("A line is guessed wholly right, wholly on the wrong side, and not at all")
    {
        const Model model = two_spans({uniform(7.0)});
        for (const auto component : {femoop::MemberComponent::Mz, femoop::MemberComponent::Vy}) {
            const Line line = line_of(model, section_force(first, component, 40.0));
            const auto right = frame::assess(drawn(model, line), line.line, line.path);
            REQUIRE(right);
            CHECK(right->is_of_line);
            CHECK(right->members.size() == 2);
            CHECK(right->share > 0.9);
            const auto wrong = frame::assess(drawn(model, line, -1.0), line.line, line.path);
            CHECK(wrong->share < 0.6);
            CHECK(wrong->members.front().score.is_mirrored);
            CHECK(!frame::assess({}, line.line, line.path));
        }
    }

    TEST_CASE("A member that is passed from its second end has the mirror image, with the signs of its own moments")
    {
        Model turned = span_with_overhang();
        std::swap(turned.members[0].nodes[0], turned.members[0].nodes[1]);
        const Truth plain =
            line_of(span_with_overhang(), section_force(first, femoop::MemberComponent::Mz, 25.0)).on(0);
        const Truth mirrored = line_of(turned, section_force(first, femoop::MemberComponent::Mz, 75.0)).on(0);
        REQUIRE(mirrored.pieces.size() == 2);
        CHECK(mirrored.pieces[0].to == doctest::Approx(0.75));
        for (std::size_t i = 0; i < plain.profile.size(); ++i)
            CHECK(*mirrored.profile[plain.profile.size() - 1 - i] == doctest::Approx(-*plain.profile[i]));
    }

    TEST_CASE("A stroke of a line begins anew after strokes of moments, and is stale for another effect")
    {
        const Model model = two_spans({uniform(7.0)});
        const Line line = line_of(model, section_force(first, femoop::MemberComponent::Mz, 50.0));
        Prediction prediction;
        prediction.draw(model, CaseId(0), second, stroke(line.on(1), 0.2));
        prediction.draw(model, line.line.effect, first, stroke(line.on(0), 0.2));
        CHECK(prediction.is_of_line());
        CHECK(prediction.on(second) == nullptr);
        CHECK(!prediction.is_stale(model, line.line.effect));
        CHECK(prediction.is_stale(model, section_force(second, femoop::MemberComponent::Mz, 50.0)));
        CHECK(!frame::assess(prediction, femoop::analyse(model), CaseId(0)));
    }
}
