#include <doctest/doctest.h>

#include <string>

#include "apps/euler/document/stepper.h"
#include "tests/apps/euler/first_solid.h"
#include "topology/text/line_error.h"
#include "ui/text/catalogue.h"

using euler::Stepper;

namespace {

constexpr const char* triangle = R"(# A triangle of two sides.

mvfs s1 f1 v1 0 0 0
# Two struts,
# one after the other.
mev s1 f1 v1 v2 1 0 0
mev s1 f1 v2 v3 0 1 0   # the second

mef s1 f1 v1 v3 f2
# That is all.
)";

} // namespace

TEST_SUITE("stepper")
{
    TEST_CASE("A script is kept word for word, and its comments explain the steps that they stand above")
    {
        const Stepper lesson(triangle);
        CHECK(lesson.script() == triangle);
        CHECK(lesson.n_steps() == 4);
        CHECK(lesson.place() == 4);
        CHECK(lesson.heading() == ui::Message("A triangle of two sides."));
        CHECK(lesson.report(1).explanation == ui::Message(""));
        CHECK(lesson.report(2).explanation == ui::Message("Two struts, one after the other."));
        CHECK(lesson.report(3).explanation == ui::Message("the second"));
    }

    TEST_CASE("A step tells its operator, the change of the six counts, and the line that takes it back")
    {
        const Stepper lesson(triangle);
        CHECK(deltas(lesson.report(1)) == "MVFS: +1 0 +1 +1 +1 0");
        CHECK(deltas(lesson.report(2)) == "MEV: +1 +1 0 0 0 0");
        CHECK(deltas(lesson.report(4)) == "MEF: 0 +1 +1 +1 0 0");
        CHECK(lesson.report(4).after == topology::EulerCounts{.V = 3, .E = 3, .F = 2, .L = 2, .S = 1, .G = 0});
        CHECK(lesson.report(2).inverse_name == "KEV");
        CHECK(lesson.report(2).inverse == std::vector<std::string>{"kev s1 v1 v2"});
        CHECK(lesson.report(4).inverse == std::vector<std::string>{"kef s1 f1 v1 v3"});
        CHECK(ui::Catalogue()(lesson.report(4).meaning) ==
              "An edge from v1 to v3 divides face f1; the new face is f2.");
        CHECK(lesson.report(2).changes.front().created.size() ==
              3); // an edge, a half-edge (one was there) and a vertex
    }

    TEST_CASE("Back and forth again every link is as it was")
    {
        Stepper lesson(triangle);
        const topology::Solid end = first_solid(lesson);
        lesson.go_to(2);
        CHECK(lesson.place() == 2);
        CHECK(lesson.n_steps() == 4);
        CHECK(first_solid(lesson).counts().edges == 1);
        CHECK(lesson.script() == triangle);
        lesson.go_to(0);
        CHECK(first_solid(lesson).is_empty());
        lesson.go_to(4);
        CHECK(first_solid(lesson) == end);
    }

    TEST_CASE(
        "A line that is refused changes nothing, not even what could be done again, and says why in both languages")
    {
        Stepper lesson(triangle);
        lesson.go_to(3);
        const auto reason = lesson.apply("mef s1 f1 v1 v9 f2");
        REQUIRE(reason);
        CHECK(ui::Catalogue()(*reason) == "there is no vertex v9 in s1");
        CHECK(ui::Catalogue(ui::Language::Portuguese)(*reason) == "não há vértice v9 em s1");
        CHECK(lesson.n_steps() == 4);
        CHECK(lesson.script() == triangle);
        lesson.go_to(4);
        CHECK(first_solid(lesson).counts().faces == 2);
    }

    TEST_CASE("A new step takes the place of those that were undone, and their comments go with them")
    {
        Stepper lesson(triangle);
        lesson.go_to(2);
        CHECK_FALSE(lesson.apply("mev s1 f1 v2 v4 5 5 0  # elsewhere"));
        CHECK(lesson.n_steps() == 3);
        CHECK(lesson.report(3).explanation == ui::Message("elsewhere"));
        CHECK(lesson.script() == R"(# A triangle of two sides.

mvfs s1 f1 v1 0 0 0
# Two struts,
# one after the other.
mev s1 f1 v1 v2 1 0 0
mev s1 f1 v2 v4 5 5 0  # elsewhere
)");
    }

    TEST_CASE("A step at the end goes before the text's last words")
    {
        Stepper lesson(triangle);
        CHECK_FALSE(lesson.apply("mvr s1 f1 w 0.2 0.2 0"));
        CHECK(lesson.script() ==
              std::string(triangle).insert(std::string(triangle).find("# That"), "mvr s1 f1 w 0.2 0.2 0\n"));
    }

    TEST_CASE("Lines that undo and redo move the place and are no steps")
    {
        Stepper lesson(std::string(triangle) + "undo 2\n");
        CHECK(lesson.place() == 2);
        CHECK(lesson.n_steps() == 4);
        CHECK_FALSE(lesson.apply("redo"));
        CHECK(lesson.place() == 3);
        const auto reason = lesson.apply("redo 7");
        REQUIRE(reason);
        CHECK(ui::Catalogue()(*reason) == "there are 1 steps to redo, not 7");
        CHECK_FALSE(Stepper("mvfs s f v 0 0 0\nundo\nmvfs t g w 1 2 3\n").apply("move t w 4 5 6"));
    }

    TEST_CASE("A copy goes its own way, which is what a preview needs")
    {
        const Stepper lesson(triangle);
        Stepper preview = lesson;
        CHECK_FALSE(preview.apply("mvr s1 f2 w 0.2 0.2 0"));
        CHECK(first_solid(preview).counts().loops == 3);
        CHECK(first_solid(lesson).counts().loops == 2);
    }

    TEST_CASE("A sweep is one step of many operators, taken back by its own lines")
    {
        const Stepper lesson(std::string(triangle) + "sweep s1 f1 0 0 2\n");
        const euler::StepReport& sweep = lesson.report(5);
        CHECK(deltas(sweep) == "SWEEP: +3 +6 +3 +3 0 0");
        CHECK(sweep.changes.size() == 6);
        CHECK(sweep.inverse_name == "KEF, KEV");
        CHECK(sweep.inverse.size() == 6);
        const topology::Change all = euler::together(sweep.changes);
        CHECK(all.created.size() == 3 + 6 + 12 + 3 + 3);
        CHECK(all.killed.empty());
    }

    TEST_CASE("A fault in the script is told with its line")
    {
        CHECK_THROWS_WITH_AS(Stepper("mvfs s1 f1 v1 0 0 0\n\nmev s1 f2 v1 v2 1 0 0\n"),
                             "line 3: mev s1 f2 v1 v2 1 0 0: there is no face f2 in s1", topology::LineError);
    }
}
