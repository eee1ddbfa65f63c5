#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "apps/euler/document/palette/pending_operator.h"
#include "topology/halfedge/check/validate.h"
#include "ui/text/catalogue.h"

using namespace euler;
using topology::Entity;

namespace {

/// A square plate of two faces with a lone vertex in f1.
constexpr const char* plate = "mvfs s1 f1 v1 0 0 0\nmev s1 f1 v1 v2 4 0 0\nmev s1 f1 v2 v3 4 4 0\n"
                              "mev s1 f1 v3 v4 0 4 0\nmef s1 f1 v1 v4 f2\nmvr s1 f1 w 1 1 0\n";

const topology::NamedSolid& in(const Stepper& lesson) { return lesson.runner().solids().front(); }
topology::FaceId face(const Stepper& lesson, const char* name)
{
    return *in(lesson).names.faces.find(name, in(lesson).solid);
}
topology::HalfEdgeId corner(const Stepper& lesson, const char* face_name, const char* word)
{
    return find_corner(in(lesson).named(), face(lesson, face_name), word);
}
std::string in_english(const std::optional<ui::Message>& message) { return message ? ui::Catalogue()(*message) : ""; }

bool has(const std::vector<Entity>& list, Entity entity)
{
    return std::find(list.begin(), list.end(), entity) != list.end();
}

} // namespace

TEST_SUITE("palette")
{
    TEST_CASE("The arguments of MEF are asked for one by one, and give its line")
    {
        const Stepper lesson(plate);
        const topology::ScriptRunner& runner = lesson.runner();
        PendingOperator draft(Verb::Mef);
        CHECK(draft.next().kind == ArgumentKind::Solid);
        REQUIRE(draft.suggestion(runner));
        CHECK_FALSE(draft.choose(runner, *draft.suggestion(runner)));
        CHECK(draft.next().kind == ArgumentKind::Corner);
        CHECK_FALSE(draft.choose(runner, corner(lesson, "f1", "v2")));
        CHECK_FALSE(draft.choose(runner, corner(lesson, "f1", "v4")));
        CHECK(std::get<std::string>(*draft.suggestion(runner)) == "f3");
        CHECK_FALSE(draft.choose(runner, *draft.suggestion(runner)));
        REQUIRE(draft.is_complete());
        CHECK(draft.line(runner) == "mef s1 f1 v2 v4 f3");
        const auto after = preview(lesson, draft);
        REQUIRE(after);
        CHECK(in(*after).solid.counts().faces == 3);
        CHECK(in(lesson).solid.counts().faces == 2);
    }

    TEST_CASE("The second corner of MEF lies in the loop of the first, and another one says why not")
    {
        const Stepper lesson(plate);
        PendingOperator draft(Verb::Mef);
        CHECK_FALSE(draft.choose(lesson.runner(), std::string("s1")));
        CHECK(draft.legal_picks(lesson.runner()).size() == 9);
        CHECK_FALSE(draft.choose(lesson.runner(), corner(lesson, "f1", "v2")));
        const std::vector<Entity> legal = draft.legal_picks(lesson.runner());
        CHECK(legal.size() == 4);
        CHECK(has(legal, corner(lesson, "f1", "v4")));
        CHECK(
            in_english(draft.why_not(lesson.runner(), corner(lesson, "f1", "w"))) ==
            "one half-edge lies in loop l1 and the other in loop l3; an operator for two loops is MEKR, for two faces "
            "KEF");
        CHECK(in_english(draft.why_not(lesson.runner(), face(lesson, "f1"))) == "f1 is no half-edge");
    }

    TEST_CASE("MEKR is offered only where a face has two loops, and RINGMV rings alone")
    {
        const Stepper lesson(plate);
        PendingOperator mekr(Verb::Mekr), ringmv(Verb::Ringmv);
        CHECK_FALSE(mekr.choose(lesson.runner(), std::string("s1")));
        CHECK_FALSE(ringmv.choose(lesson.runner(), std::string("s1")));
        CHECK(mekr.legal_picks(lesson.runner()).size() == 5);
        CHECK(in_english(mekr.why_not(lesson.runner(), corner(lesson, "f2", "v1"))) ==
              "face f2 has one loop; MEKR needs two");
        CHECK(ringmv.legal_picks(lesson.runner()) == std::vector<Entity>{corner(lesson, "f1", "w")});
        CHECK(in_english(ringmv.why_not(lesson.runner(), corner(lesson, "f1", "v1"))) ==
              "l1 is the outer loop of face f1; a ring is needed");
        CHECK_FALSE(ringmv.choose(lesson.runner(), corner(lesson, "f1", "w")));
        CHECK(in_english(ringmv.why_not(lesson.runner(), face(lesson, "f1"))) ==
              "f1 is given twice; two faces are needed");
    }

    TEST_CASE("A name in use is refused, and so is a solid that is not there")
    {
        const Stepper lesson(plate);
        PendingOperator draft(Verb::Mvr);
        CHECK(in_english(draft.choose(lesson.runner(), std::string("s7"))) == "there is no solid s7");
        CHECK_FALSE(draft.choose(lesson.runner(), std::string("s1")));
        CHECK_FALSE(draft.choose(lesson.runner(), face(lesson, "f2")));
        CHECK(in_english(draft.choose(lesson.runner(), std::string("v3"))) ==
              "the name v3 is in use in s1; choose another");
        CHECK(draft.chosen().size() == 2);
    }

    TEST_CASE("A place that is too short says which coordinate is missing")
    {
        const Stepper lesson("mvfs s1 f1 v1 0 0 0\n");
        PendingOperator move(Verb::Move);
        CHECK_FALSE(move.choose(lesson.runner(), std::get<Choice>(typed(lesson.runner(), move, "s1"))));
        CHECK_FALSE(move.choose(lesson.runner(), std::get<Choice>(typed(lesson.runner(), move, "v1"))));
        const auto said = [&](const char* text) {
            return ui::Catalogue()(std::get<ui::Message>(typed(lesson.runner(), move, text)));
        };
        CHECK(said("1 0") == "z is missing: write x y z");
        CHECK(said("") == "x is missing: write x y z");
        CHECK(said("1 0 0 2") == "\"2\" is no finite number");
    }

    TEST_CASE("What is typed is read as a script has it")
    {
        const Stepper lesson(plate);
        PendingOperator draft(Verb::Kev);
        CHECK_FALSE(draft.choose(lesson.runner(), std::string("s1")));
        const auto read = [&](const char* text) { return typed(lesson.runner(), draft, text); };
        CHECK(std::get<Choice>(read("v2>v3")) == Choice(Entity(topology::HalfEdgeId{2})));
        CHECK(std::get<Choice>(read("%5")) == Choice(Entity(topology::HalfEdgeId{4})));
        CHECK(std::get<Choice>(read("f1 v3")) == Choice(Entity(corner(lesson, "f1", "v3"))));
        CHECK(ui::Catalogue()(std::get<ui::Message>(read("v2>w"))) == "there is no edge between v2 and w");
        CHECK(ui::Catalogue()(std::get<ui::Message>(read("v2>"))) ==
              "v2> is no corner: a name is missing beside >; write v1, v1>v2, v1>v2>v3 or a number %7");
        CHECK(ui::Catalogue()(std::get<ui::Message>(read("v2>v3>v2"))) == "there is no half-edge v2>v3>v2 in s1");
        CHECK(ui::Catalogue()(std::get<ui::Message>(read("v1"))).starts_with("v1 fits several half-edges: "));
        CHECK(ui::Catalogue()(std::get<ui::Message>(read("%70"))) == "there is no half-edge %70 in s1");
        PendingOperator move(Verb::Move);
        CHECK_FALSE(move.choose(lesson.runner(), std::get<Choice>(typed(lesson.runner(), move, "s1"))));
        CHECK_FALSE(move.choose(lesson.runner(), std::get<Choice>(typed(lesson.runner(), move, "v2"))));
        CHECK(std::get<Choice>(typed(lesson.runner(), move, " 1 2.5 -3 ")) == Choice(topology::Point{1, 2.5, -3}));
        CHECK(ui::Catalogue()(std::get<ui::Message>(typed(lesson.runner(), move, "1 2 x"))) ==
              "\"x\" is no finite number");
    }

    TEST_CASE("Whatever is picked at random among what is legal, the line is never refused and the solid stays sound")
    {
        std::mt19937 random(7);
        const auto below = [&](std::size_t n) { return random() % n; };
        Stepper lesson("mvfs s1 f1 v1 0 0 0\nmev s1 f1 v1 v2 1 0 0\nmev s1 f1 v2 v3 1 1 0\nmef s1 f1 v1 v3 f2\n");
        int n_done = 0;
        for (int i = 0; i < 3000; ++i) {
            PendingOperator draft(static_cast<Verb>(1 + below(n_verbs - 2))); // all but mvfs and sweep
            const topology::ScriptRunner& runner = lesson.runner();
            CHECK_FALSE(draft.choose(runner, std::string("s1")));
            while (!draft.is_complete()) {
                Choice choice = topology::Point{double(below(9)), double(below(9)), double(below(9))};
                const std::vector<Entity> legal = draft.legal_picks(runner);
                if (!legal.empty()) choice = legal[below(legal.size())];
                else if (const auto name = draft.suggestion(runner)) choice = *name;
                else if (draft.next().kind != ArgumentKind::Point) break;
                CHECK_FALSE(draft.choose(runner, choice));
            }
            if (!draft.is_complete() || draft.form().verb == Verb::Kvfs) continue;
            CAPTURE(draft.line(runner));
            REQUIRE(in_english(lesson.apply(draft.line(runner))) == "");
            REQUIRE_FALSE(topology::why_not_valid(in(lesson).solid));
            REQUIRE(lesson.report(lesson.place()).after == topology::euler_counts(in(lesson).solid));
            ++n_done;
        }
        CHECK(n_done > 1000);
        lesson.go_to(0);
        CHECK(in(lesson).solid.is_empty());
    }
}
