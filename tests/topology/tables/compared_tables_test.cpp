#include <doctest/doctest.h>

#include "topology/halfedge/operators/euler_operator.h"
#include "topology/tables/compared_tables.h"
#include "topology/tables/table_text.h"

using namespace topology;

TEST_SUITE("compared tables")
{
    TEST_CASE("The second MEV makes a vertex, an edge and two half-edges, and changes the cells that the lecture shows")
    {
        Solid before;
        EulerOperator op(before);
        const NewEdge edge = op.mev(op.mvfs({0, 0, 0}).half_edge, {1, 0, 0});
        Solid after = before;
        EulerOperator(after).mev(edge.plus, {2, 0, 0});
        const ComparedTables both{EntityRows(before), EntityRows(after)};
        const auto new_row = [&](TableKind kind, std::size_t i) { return *both(kind, i).after; };

        const TableRow first = new_row(TableKind::HalfEdges, 0);
        CHECK(new_row(TableKind::HalfEdges, 2).mark == RowMark::Created);
        CHECK(first.mark == RowMark::Changed);
        CHECK(line_text(first) == "H = 1 (V = 1, E = 1, L = 1) N = 3 P = 2");
        CHECK(first.cells[3].is_changed);
        CHECK_FALSE(first.cells[4].is_changed);
        CHECK(both(TableKind::HalfEdges, 0).before->cells[3].is_changed);
        CHECK(new_row(TableKind::Loops, 0).mark == RowMark::Same);
        CHECK(new_row(TableKind::Vertices, 0).mark == RowMark::Same);
        CHECK(new_row(TableKind::Vertices, 1).cells[2].is_changed); // P = 3
        CHECK_FALSE(both.first_changed(TableKind::Loops));
        CHECK(both.first_changed(TableKind::Vertices) == 1);
    }

    TEST_CASE("What an operator kills is marked in the table before it, and its inverse swaps the marks")
    {
        Solid with;
        EulerOperator op(with);
        const NewEdge edge = op.mev(op.mvfs({0, 0, 0}).half_edge, {1, 0, 0});
        Solid without = with;
        EulerOperator(without).kev(edge.plus);
        const ComparedTables kill{EntityRows(with), EntityRows(without)};
        const ComparedTables make{EntityRows(without), EntityRows(with)};
        CHECK(kill(TableKind::Vertices, 1).before->mark == RowMark::Killed);
        CHECK(make(TableKind::Vertices, 1).after->mark == RowMark::Created);
        CHECK(kill(TableKind::Edges, 0).after->number == 0); // the row that says that there is none
        CHECK(kill(TableKind::Edges, 0).after->mark == RowMark::Created);
    }

    TEST_CASE("Every link of a cell leads to the entity of its number")
    {
        Solid solid;
        EulerOperator op(solid);
        const LoneVertex first = op.mvfs({0, 0, 0});
        op.mef(first.half_edge, first.half_edge);
        op.mvr(first.face, {1, 1, 0});
        for (const auto& rows : entity_tables(solid).rows)
            for (const TableRow& row : rows)
                for (const TableCell& cell : row.cells) {
                    CAPTURE(line_text(row));
                    CAPTURE(cell.label);
                    if (cell.label != "S" && cell.number != 0) REQUIRE(cell.link);
                    if (cell.link) CHECK(cell.link->index + 1 == cell.number);
                }
    }
}
