#include "apps/frame/view/predict/score_words.h"

#include <doctest/doctest.h>

#include "apps/drawing/sketch/scene.h"
#include "tests/apps/drawing/view_model.h"

using namespace frame;
using femoop::MemberId;

namespace {

/// Sentences about the portal frame of examples/.
class Words {
public:
    std::vector<std::string> faults(const Score& score) const
    {
        return words().faults({MemberId(1), Outcome::Judged, score});
    }
    std::vector<std::string> lines(const Assessment& assessment) const { return words().lines(assessment); }

private:
    ScoreWords words() const { return {model_, shape_, units_, tr_}; }

    femoop::Model model_ = view_test::example("portal");
    StructureShape shape_ = shape_of(model_);
    ui::DisplayUnits units_ = display_units(model_, {});
    ui::Catalogue tr_;
};

Score right() { return {.share = 1.0, .drawn = 1.0, .sign = 1.0, .degree = 1.0, .extreme = 1.0}; }
using Lines = std::vector<std::string>;

} // namespace

TEST_SUITE("frame view")
{
    TEST_CASE(
        "Of a guess that is right there is nothing to say, and one that lost a point here and there is nearly right")
    {
        CHECK(Words().faults(right()).empty());
        Score nearly = right();
        nearly.share = 0.9;
        CHECK(Words().faults(nearly) == Lines{"nearly right"});
    }

    TEST_CASE("What is wrong is said in the order in which a teacher looks")
    {
        Score score = right();
        score.sign = 0.7;
        score.zeros = {.n_true = 2, .n_found = 1, .n_extra = 3};
        score.pieces = {{{0.0, 0.25, 1}, Flaw::None, 1.0}, {{0.25, 1.0, 2}, Flaw::Straight, 0.0}};
        score.jumps = {.n_true = 1, .n_found = 0, .n_extra = 1};
        score.extreme = 0.0;
        CHECK(Words().faults(score) == Lines{"along 30 % of its length on the wrong side",
                                             "1 of 2 zeros at their places", "2 zeros too many",
                                             "straight where it is a parabola (x = 2 m to 8 m)", "without the jump",
                                             "a jump where there is none", "largest at another place"});
    }

    TEST_CASE("A guess on the wrong side throughout is not told so in parts")
    {
        Score score = right();
        score.sign = 0.0;
        score.is_mirrored = true;
        CHECK(Words().faults(score) == Lines{"on the wrong side throughout"});
    }

    TEST_CASE("Where half is drawn the rest is missing, not wrong")
    {
        Score score = right();
        score.sign = score.drawn = 0.5;
        score.pieces = {{{0.0, 1.0, 2}, Flaw::NotDrawn, 0.0}};
        CHECK(Words().faults(score) == Lines{"along 50 % of its length nothing drawn"});
    }

    TEST_CASE("The worst member stands first, those that are right in one line")
    {
        Score fair = right();
        fair.share = 0.8;
        fair.extreme = 0.0;
        CHECK(Words().lines({{{MemberId(0), Outcome::Judged, right()},
                              {MemberId(1), Outcome::Judged, fair},
                              {MemberId(2), Outcome::NotDrawn, {}}},
                             0.6}) ==
              Lines{"Prediction: 60 %", "CD:  0 %  nothing drawn", "BC:  80 %  largest at another place", "right: AB"});
    }

    TEST_CASE("There are never more than six lines")
    {
        Assessment many;
        for (int i = 0; i < 20; ++i) many.members.push_back({MemberId(2), Outcome::NotDrawn, {}});
        CHECK(Words().lines(many).size() == 6);
        CHECK(Words().lines(many).back() == "and 16 more");
    }
}
