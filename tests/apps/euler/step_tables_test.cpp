#include <doctest/doctest.h>

#include "apps/euler/document/step_tables.h"
#include "topology/tables/table_text.h"

using topology::RowMark;
using topology::TableKind;

TEST_SUITE("step tables")
{
    TEST_CASE("The tables of any step are shown wherever the lesson stands, which stays there")
    {
        euler::Stepper lesson("mvfs s1 f1 v1 0 0 0\nmev s1 f1 v1 v2 1 0 0\nmvfs s2 g w 5 5 5\nkvfs s2\n");
        lesson.go_to(0);
        const auto mev = step_tables(lesson, 2);
        CHECK(mev.after[TableKind::Vertices][1].mark == RowMark::Created);
        CHECK(line_text(mev.after[TableKind::Solids][0]) == "S = 1 (V = 1, F = 1, E = 1) N = 0 P = 0");
        CHECK(lesson.place() == 0);
    }

    TEST_CASE("A solid has no rows before its first step and after its last, and knows the solids beside it")
    {
        const euler::Stepper lesson("mvfs s1 f1 v1 0 0 0\nmvfs s2 g w 5 5 5\nkvfs s2\n");
        const auto make = step_tables(lesson, 2), kill = step_tables(lesson, 3);
        CHECK(make.before[TableKind::Vertices].empty());
        CHECK(make.after[TableKind::Vertices].front().mark == RowMark::Created);
        CHECK(line_text(make.after[TableKind::Solids].front()) == "S = 2 (V = 1, F = 1, E = 0) N = 1 P = 0");
        CHECK(kill.before[TableKind::Faces].front().mark == RowMark::Killed);
        CHECK(kill.after[TableKind::Faces].empty());
    }
}
