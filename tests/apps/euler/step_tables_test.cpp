#include <doctest/doctest.h>

#include "apps/euler/document/step_tables.h"
#include "topology/tables/table_text.h"

using topology::RowMark;
using topology::TableKind;

namespace {

/// The solids before and after a step of a script.
class SeenStep {
public:
    SeenStep(const char* script, std::size_t step)
    {
        euler::Stepper lesson(script);
        const std::vector<euler::Snapshot> end = snapshots(lesson);
        lesson.go_to(step);
        solid_ = lesson.summary(step).solid;
        after_ = snapshots(lesson, end);
        lesson.go_to(step - 1);
        before_ = retaken(lesson, solid_, after_);
    }
    topology::ComparedTables tables() const { return euler::step_tables(before_, after_, solid_); }

private:
    std::size_t solid_ = 0;
    std::vector<euler::Snapshot> before_, after_;
};

} // namespace

TEST_SUITE("step tables")
{
    TEST_CASE("The tables of a step mark what it made")
    {
        const SeenStep mev("mvfs s1 f1 v1 0 0 0\nmev s1 f1 v1 v2 1 0 0\nmvfs s2 g w 5 5 5\nkvfs s2\n", 2);
        CHECK(mev.tables()(TableKind::Vertices, 1).after->mark == RowMark::Created);
        CHECK(line_text(*mev.tables()(TableKind::Solids, 0).after) == "S = 1 (V = 1, F = 1, E = 1) N = 0 P = 0");
    }

    TEST_CASE("A solid has no rows before its first step and after its last, and knows the solids beside it")
    {
        constexpr const char* script = "mvfs s1 f1 v1 0 0 0\nmvfs s2 g w 5 5 5\nkvfs s2\n";
        const SeenStep make(script, 2), kill(script, 3);
        CHECK_FALSE(make.tables()(TableKind::Vertices, 0).before);
        CHECK(make.tables()(TableKind::Vertices, 0).after->mark == RowMark::Created);
        CHECK(line_text(*make.tables()(TableKind::Solids, 0).after) == "S = 2 (V = 1, F = 1, E = 0) N = 1 P = 0");
        CHECK(kill.tables()(TableKind::Faces, 0).before->mark == RowMark::Killed);
        CHECK_FALSE(kill.tables()(TableKind::Faces, 0).after);
    }
}
