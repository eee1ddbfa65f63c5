// The tables at the bottom of the window, played by scenarios.
#include "tests/apps/frame_window/played.h"
#include "tests/folder.h"

#include <doctest/doctest.h>

TEST_SUITE("frame window: tables")
{
    TEST_CASE("A cell is typed with a unit or as a calculation, Tab goes right and Enter down, a row is a selection")
    {
        check_window("window_table_nodes", opened("examples/portal.json"), R"(
            key F4
            wait 0.1
            key Down
            key Right
            type "350 cm"
            key Tab
            type "2*2,5"
            key Enter
            hover pixel 600 500
            expect undo Change table: Nodes
            expect selection Node C
        )");
    }

    TEST_CASE("What is no number stays in its cell with the reason, and no letter reaches the tools")
    {
        check_window("window_table_wrong", opened("examples/portal.json"), R"(
            command view.theme.dark
            command view.table.distributed_loads
            wait 0.1
            key Right
            key Right
            key Right
            key Right
            key Right
            type "12 mules"
            key Enter
            hover pixel 600 500
            expect undo nothing
        )");
    }

    TEST_CASE("Nodes and members are added in the rows at the end, with the keyboard alone")
    {
        check_window("window_table_new_rows", opened("examples/portal.json"), R"(
            command view.table.nodes
            wait 0.1
            key Ctrl+Down
            type "K"
            key Tab
            type "12"
            key Tab
            expect undo nothing
            type "0"
            key Tab
            type "fixed"
            key Enter
            command view.table.members
            wait 0.1
            key Ctrl+Down
            key Tab
            type "C"
            key Tab
            type "K"
            key Enter
            expect undo Change table: Members
            key Esc
            hover pixel 600 500
        )");
    }

    TEST_CASE("What is copied is pasted back as it was; whole rows are deleted, and undone as one step")
    {
        check_window("window_table_block", opened("examples/portal.json"), R"(
            command view.table.nodes
            wait 0.1
            key Ctrl+A
            key Ctrl+C
            key Ctrl+V
            expect undo nothing
            key Del
            expect undo Delete rows: Nodes
            key Ctrl+Z
            expect undo nothing
            click pixel 130 570
            drag pixel 130 612 to pixel 200 654
            hover pixel 600 500
            expect selection Node B, Node C, Node D
        )");
    }

    TEST_CASE("A space truss is edited by its table of nodes")
    {
        check_window("window_table_space", opened("tests/cases/members/F3-001.json"), R"(
            command view.table.nodes
            wait 0.1
            key Ctrl+Down
            key Up
            key Right
            key Right
            key Right
            type "1,5"
            key Enter
            hover pixel 600 500
            expect undo Change table: Nodes
        )");
    }

    TEST_CASE("Ctrl+Z within a cell or a field undoes nothing of what was typed there before")
    {
        check_window("window_table_undo", opened("examples/portal.json"), R"(
            command view.table.nodes
            wait 0.1
            type "a rather long name"
            key Enter
            key Up
            type "B"
            key Ctrl+Z
            key Ctrl+Z
            key Ctrl+Z
            type "K"
            key Enter
            expect undo Change table: Nodes
            command view.tables
            click node BK
            click pixel 1190 97
            key Ctrl+A
            type "1.23456789"
            key Enter
            click pixel 1190 97
            key Ctrl+A
            type "2"
            key Ctrl+Z
            key Ctrl+Z
            key Ctrl+Z
            key Ctrl+Z
            key Esc
            wait 0.1
        )");
    }

    TEST_CASE("The diagrams of the selected member share an axis; a click pins the section, the arrows move it")
    {
        check_window("window_member", opened("examples/portal.json"), R"(
            click member BC 30%
            key Shift+F4
            wait 0.1
            click pixel 400 600
            key Right
            hover pixel 700 750
            wait 0.1
        )");
    }

    TEST_CASE("Extremes of all section forces in Portuguese, and the table as a file that a spreadsheet reads")
    {
        const Folder folder;
        frame::Session session = opened("examples/portal.json");
        session.set_language(ui::Language::Portuguese);
        check_window("window_table_extremes", std::move(session),
                     "command view.table.extremes\ncommand file.export_table " + folder.path("extremos.csv") +
                         "\nwait 0.1\n");
        const std::string text = folder.read("extremos.csv");
        CHECK(text.starts_with("Barra;N máx [kN];x [m];"));
        CHECK(text.find("4,5") != std::string::npos);
    }
}
