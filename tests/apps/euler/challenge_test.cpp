#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

#include "apps/euler/document/challenge/corrupted_pointer.h"
#include "apps/euler/document/challenge/reach.h"
#include "apps/euler/document/challenge/score.h"
#include "apps/euler/document/challenge/which_operator.h"
#include "topology/halfedge/check/validate.h"
#include "topology/tables/table_text.h"
#include "ui/text/catalogue.h"

using namespace euler;

namespace {

const ui::Catalogue english, portuguese(ui::Language::Portuguese);

bool is_said(const ui::Message& message)
{
    return portuguese.has(message.sentence) && portuguese(message).find('{') == std::string::npos;
}

} // namespace

TEST_SUITE("challenges")
{
    TEST_CASE("Every solid to reach can be reached with the operators that are allowed, and not with fewer steps of it")
    {
        for (const Level level : {Level::Easy, Level::Middle, Level::Hard})
            for (std::uint32_t seed = 1; seed <= 12; ++seed) {
                CAPTURE(seed);
                const ReachChallenge challenge = reach_challenge(seed, level);
                CAPTURE(english(challenge.task));
                CHECK(is_said(challenge.task));
                Stepper way(challenge.way);
                const ReachState end = judged(challenge, way);
                CHECK(end.is_won);
                CHECK(end.n_operators == challenge.most_operators);
                while (way.place() > 0) {
                    way.go_to(way.place() - 1);
                    const ReachState state = judged(challenge, way);
                    CHECK_FALSE(state.is_reached);
                    CHECK(is_said(state.hint));
                }
            }
    }

    TEST_CASE("A lone vertex takes one operator of its own")
    {
        std::set<std::string> tasks;
        for (std::uint32_t seed = 1; seed <= 40; ++seed) tasks.insert(english(reach_challenge(seed, Level::Easy).task));
        CHECK(tasks.contains("Make a lamina of 6 corners with a lone vertex in its front with at most 8 operators."));
        CHECK(tasks.contains("Make a lamina of 6 corners with at most 7 operators."));
    }

    TEST_CASE("SEMV is asked for too, and never beside MEV")
    {
        std::set<std::string> answers;
        for (std::uint32_t seed = 1; seed <= 60; ++seed) {
            const WhichOperator asked = which_operator(seed);
            answers.insert(asked.choices[asked.answer]);
        }
        CHECK(answers.contains("SEMV"));
        CHECK(answers.contains("JEKV"));
    }

    TEST_CASE("A detour reaches the solid but does not win, and places do not matter")
    {
        ReachChallenge challenge = reach_challenge(1, Level::Easy);
        Stepper way("mvfs s f a 0 0 0\nmev s f a b 7 0 0\nmev s f b c 9 9 0\nmev s f c d 1 5 0\nkev s c d\n"
                    "mef s f a c g\n");
        challenge.target = way.runner().solids().front().solid;
        challenge.most_operators = 4;
        CHECK_FALSE(way.apply("move s a -3 -2 0"));
        const ReachState state = judged(challenge, way);
        CHECK(state.is_reached);
        CHECK_FALSE(state.is_won);
        CHECK(state.n_operators == 7);
        CHECK(english(state.hint) == "the solid is right; it takes fewer operators");
    }

    TEST_CASE("The operator that was applied is among four different choices, and the counts of the hint are its own")
    {
        std::set<std::string> asked_for;
        for (std::uint32_t seed = 1; seed <= 200; ++seed) {
            CAPTURE(seed);
            const WhichOperator asked = which_operator(seed);
            const bool is_forward = asked.after > asked.before;
            const StepReport& step = asked.lesson.report(std::max(asked.before, asked.after));
            CHECK(std::set<std::string>(asked.choices.begin(), asked.choices.end()).size() == 4);
            CHECK(asked.choices[asked.answer] == (is_forward ? step.name : step.inverse_name));
            CHECK(asked.lesson.place() == asked.before);
            CHECK(is_said(asked.hint));
            if (asked.choices[asked.answer] == "MEV")
                CHECK(english(asked.hint) == "V, E, F, L, S and G change by +1 +1 0 0 0 0");
            if (asked.choices[asked.answer] == "KEF")
                CHECK(english(asked.hint) == "V, E, F, L, S and G change by 0 -1 -1 -1 0 0");
            asked_for.insert(asked.choices[asked.answer]);
        }
        CHECK(asked_for.size() > 8);
    }

    TEST_CASE("A bent pointer breaks the structure, bending it back mends it, and another one does not")
    {
        for (std::uint32_t seed = 1; seed <= 200; ++seed) {
            CAPTURE(seed);
            const CorruptedPointer broken = broken_pointer(seed);
            CAPTURE(english(broken.message));
            CHECK(topology::why_not_valid(broken.broken));
            CHECK(is_said(broken.message));
            CHECK(is_said(broken.where));
            CHECK_FALSE(is_mended(broken, broken.bent));
            bool has_way_back = false;
            for (std::uint32_t to = 0; to < broken.sound.half_edges().n_rows(); ++to) {
                const topology::CorruptedLink set{.kind = broken.bent.kind, .row = broken.bent.row, .to = to};
                has_way_back = has_way_back || topology::CorruptedSolid(broken.broken, set).solid() == broken.sound;
                if (topology::CorruptedSolid(broken.broken, set).solid() == broken.sound) CHECK(is_mended(broken, set));
            }
            CHECK(has_way_back);
        }
    }

    TEST_CASE("The tables of a broken solid differ from the sound one's in the bent cell")
    {
        for (std::uint32_t seed = 1; seed <= 100; ++seed) {
            CAPTURE(seed);
            const CorruptedPointer broken = broken_pointer(seed);
            CHECK(table_text(broken.broken) != table_text(broken.sound));
        }
        CHECK(link_of(topology::TableKind::HalfEdges, "N") == topology::LinkKind::HalfEdgeNext);
        CHECK_FALSE(link_of(topology::TableKind::Vertices, "N"));
    }

    TEST_CASE("A cell as it is typed mends what was bent, and what is no cell is told")
    {
        for (std::uint32_t seed = 1; seed <= 50; ++seed) {
            CAPTURE(seed);
            const CorruptedPointer broken = broken_pointer(seed);
            CAPTURE(way_back(broken));
            const auto set = link_typed(broken, way_back(broken));
            REQUIRE(std::holds_alternative<topology::CorruptedLink>(set));
            CHECK(is_mended(broken, std::get<topology::CorruptedLink>(set)));
        }
        for (const char* wrong : {"H 3 N", "F 1 LOUT 1", "V 1 N 2", "H 999 N 1", "H 1 N 999"}) {
            CAPTURE(wrong);
            const auto set = link_typed(broken_pointer(1), wrong);
            REQUIRE(std::holds_alternative<ui::Message>(set));
            CHECK(is_said(std::get<ui::Message>(set)));
        }
    }

    TEST_CASE("A hint and a miss cost a point each, and no score is below nothing")
    {
        CHECK(Score{}.points() == 3);
        CHECK(Score{.hints = 1, .misses = 1}.points() == 1);
        CHECK(Score{.hints = 2, .misses = 7}.points() == 0);
    }
}
