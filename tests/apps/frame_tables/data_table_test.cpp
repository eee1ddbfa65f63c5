// Tables of a document: read, copied, pasted back.
#include "apps/frame/tables/data_table.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "apps/frame/document/solution.h"
#include "femoop/io/model_file.h"

using namespace frame;
using femoop::MemberId;
using femoop::NodeId;

namespace {

Manner english(const femoop::Model& model, ui::UnitSystem system = ui::UnitSystem::KnM)
{
    return {{system, base_units(model.units), {}}, ui::Catalogue()};
}

Manner portuguese(const femoop::Model& model)
{
    return {{ui::UnitSystem::KnM, base_units(model.units), {.digits = 4, .mark = ui::DecimalMark::Comma}},
            ui::Catalogue(ui::Language::Portuguese)};
}

/// What `paste` makes of a text in the table's cell.
Filled pasted(const Document& document, TableKind kind, const Target& target, std::string_view text)
{
    const Manner manner = english(document.model);
    const Table table = data_table(document.model, kind, manner);
    return filled(document, kind, target, read_block(text, table, target.column), manner);
}

std::string first_fault(const Filled& result, TableKind kind)
{
    if (result.faults.empty()) return "";
    const Manner manner = english(result.document.model);
    return sentence(result.faults.front(), data_table(result.document.model, kind, manner), manner.tr);
}

/// A frame with something in every table.
Document rich()
{
    Document document = starting_document();
    femoop::Model& model = document.model;
    model.nodes[1].at[0] = 1.0 / 3.0;
    model.nodes[2].hinge = true;
    model.nodes[3].support = femoop::Support{
        .fixed = {femoop::Dof::uy}, .angle = 30.0, .springs = {{femoop::Dof::ux, femoop::Quantity(700.0, "7 kN/cm")}}};
    model.members[1].start.release.insert(femoop::Dof::rz);
    model.members[0].foundation = 120.0;
    model.load_cases.push_back({.id = "W"});
    femoop::LoadCase& wind = model.load_cases.back();
    wind.members.push_back({MemberId(0), femoop::PointLoad{.at = femoop::Percent{37.5},
                                                           .components = {{femoop::Dof::ux, 3.0}},
                                                           .axes = femoop::LoadAxes::Local}});
    wind.members.push_back(
        {MemberId(2), femoop::DistributedLoad{.values = {{femoop::Dof::ux, 1.0, femoop::Quantity(2.5, "25 N/cm")}},
                                              .from = femoop::Position(femoop::Quantity(0.7)),
                                              .to = femoop::Position(femoop::Percent{80.0}),
                                              .axes = femoop::LoadAxes::Global,
                                              .projected = true}});
    wind.members.push_back({MemberId(1), femoop::TemperatureLoad{20.0, 0.1}});
    wind.members.push_back({MemberId(1), femoop::Misfit{-0.004}});
    wind.members.push_back({MemberId(1), femoop::EndLoads{.start = {{femoop::Dof::uy, 7.0}}, .end = {}}});
    wind.settlements.push_back({NodeId(3), {{femoop::Dof::uy, -0.013}}});
    return document;
}

} // namespace

TEST_SUITE("frame tables")
{
    TEST_CASE("What is copied from a table and pasted back changes nothing, in any units and language")
    {
        const Document document = rich();
        for (const TableKind kind : all_table_kinds) {
            if (is_result(kind)) continue;
            for (const Manner& manner : {english(document.model), english(document.model, ui::UnitSystem::Us),
                                         english(document.model, ui::UnitSystem::File), portuguese(document.model)}) {
                CAPTURE(title(kind));
                const Table table = data_table(document.model, kind, manner);
                const std::string text = tsv(table, whole(table));
                CAPTURE(text);
                const Filled result = filled(document, kind, {}, read_block(text, table, 0), manner);
                CHECK((result.faults.empty() ? "" : sentence(result.faults.front(), table, manner.tr)) == "");
                CHECK(result.document == document);
            }
        }
    }

    TEST_CASE("The tables of every model among the examples and cases can be pasted back")
    {
        for (const char* folder : {"examples", "tests/cases"}) {
            const std::filesystem::path root = std::filesystem::path(CREMONA_SOURCE_DIR) / folder;
            for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
                if (entry.path().extension() != ".json") continue;
                const femoop::ModelReading reading = femoop::examine_model_file(entry.path());
                if (!reading.is_sound()) continue;
                CAPTURE(entry.path().string());
                const Document document{reading.model};
                const Manner manner = english(document.model);
                for (const TableKind kind : all_table_kinds) {
                    if (is_result(kind)) continue;
                    const Table table = data_table(document.model, kind, manner);
                    const TextBlock texts = read_block(tsv(table, whole(table)), table, 0);
                    CHECK(filled(document, kind, {}, texts, manner).document == document);
                }
            }
        }
    }

    TEST_CASE("A wrong text changes nothing, and every wrong one is told by row and column")
    {
        const Document document = starting_document();
        const Filled result = pasted(document, TableKind::Nodes, {.row = 1, .column = 1}, "5\t6\n7\tseven\nx\t9\n");
        CHECK(result.document == document);
        REQUIRE(result.faults.size() == 2);
        CHECK(result.faults[0].row == 2);
        CHECK(result.faults[0].column == 2);
        CHECK(result.faults[1].row == 3);
        CHECK(result.faults[1].column == 1);
        CHECK(first_fault(result, TableKind::Nodes).starts_with("row 3, y [m]: "));
    }

    TEST_CASE("Numbers are typed with units, as calculations and with a decimal comma")
    {
        const Document document = starting_document();
        const Filled result = pasted(document, TableKind::Nodes, {.row = 1, .column = 1}, "350 cm\t2*3,5\n1/3\t12,5\n");
        const auto& nodes = result.document.model.nodes;
        CHECK(first_fault(result, TableKind::Nodes) == "");
        CHECK(nodes[1].at[0] == doctest::Approx(3.5));
        CHECK(nodes[1].at[0].text() == "350 cm");
        CHECK(nodes[1].at[1] == 7.0);
        CHECK(nodes[2].at[0] == 1.0 / 3.0);
        CHECK(nodes[2].at[1] == 12.5);
    }

    TEST_CASE("Lines below the last row become new nodes and members, and the structure can be solved")
    {
        Document document = starting_document();
        document = pasted(document, TableKind::Nodes, {.row = 4}, "\t12\t4\nK\t12\t0\tfixed\n").document;
        REQUIRE(document.model.nodes.size() == 6);
        CHECK(document.model.nodes[4].id == "E");
        const Filled result = pasted(document, TableKind::Members, {.row = 3, .column = 1}, "C\tE\nE\tK\n");
        CHECK(first_fault(result, TableKind::Members) == "");
        REQUIRE(result.document.model.members.size() == 5);
        CHECK(result.document.model.members[3].id == "CE");
        CHECK(result.document.model.members[4].section == document.model.members[2].section);
        CHECK(solve(result.document).results.has_value());
    }

    TEST_CASE("A whole structure is pasted into an empty document, in space too")
    {
        Document document;
        document.model.analysis = femoop::AnalysisKind::Truss3d;
        const auto put = [&](TableKind kind, std::string_view text) {
            const Filled result = pasted(document, kind, {}, text);
            CHECK(first_fault(result, kind) == "");
            document = result.document;
        };
        put(TableKind::Nodes, "A\t0\t0\t0\tpin\nB\t4\t0\t0\tpin\nC\t0\t3\t0\tpin\nD\t1\t1\t5\n");
        put(TableKind::Materials, "steel\t205 GPa\n");
        put(TableKind::Sections, "bar\t12 cm^2\n");
        put(TableKind::Members, "AD\tA\tD\nBD\tB\tD\nCD\tC\tD\n");
        put(TableKind::NodeLoads, "\tD\t\t3\t-20\n");
        const Solution solution = solve(document);
        REQUIRE(solution.results);
        CHECK((*solution.results)[femoop::CaseId(0)].equilibrium().residual < 1e-9);
    }

    TEST_CASE("A new row without what it needs is refused with the column that lacks it")
    {
        const Document document = starting_document();
        const Filled result = pasted(document, TableKind::Nodes, {.row = 4, .column = 1}, "3\n");
        CHECK(result.document == document);
        CHECK(first_fault(result, TableKind::Nodes) == "row 5, y [m]: a value is needed here");
        CHECK(!pasted(document, TableKind::Members, {.row = 3}, "X\tA\tnowhere\n").faults.empty());
    }

    TEST_CASE("Two parts of one name, and a member from a node to itself, are refused")
    {
        const Document document = starting_document();
        CHECK(first_fault(pasted(document, TableKind::Nodes, {.row = 2}, "A"), TableKind::Nodes) ==
              "row 3, Node: the name \"A\" is taken");
        CHECK(first_fault(pasted(document, TableKind::Members, {.row = 0, .column = 2}, "A"), TableKind::Members) ==
              "row 1, End: the member starts and ends at one node");
        CHECK(pasted(document, TableKind::Nodes, {}, "B\nA").faults.empty()); // names may be exchanged
    }

    TEST_CASE("Supports are typed as words of either language, as directions, and with springs")
    {
        const Document document = starting_document();
        const auto support = [&](std::string_view text) {
            const Manner manner = portuguese(document.model);
            const Filled result = filled(document, TableKind::Nodes, {.row = 1, .column = 3}, {{std::string(text)}},
                                         manner);
            CHECK(result.faults.empty());
            const auto& found = result.document.model.nodes[1].support;
            return found ? names_of(found->blocked(document.model.analysis)) : "";
        };
        CHECK(support("Fixed") == "ux uy rz");
        CHECK(support("engaste") == "ux uy rz");
        CHECK(support("uy, rz") == "uy rz");
        CHECK(support("pin") == "ux uy");
        CHECK(support("") == "");
        const Filled spring = pasted(document, TableKind::Nodes, {.row = 0, .column = 6}, "300");
        CHECK(spring.document.model.nodes[0].support->fixed == femoop::DofSet{femoop::Dof::uy, femoop::Dof::rz});
    }

    TEST_CASE("Loads go to another case as one step, whichever come first")
    {
        Document document = rich();
        document.model.load_cases[0].nodes.push_back({NodeId(2), {{femoop::Dof::uy, -3.0}}});
        const Filled result = pasted(document, TableKind::NodeLoads, {}, "W\nW\n");
        CHECK(first_fault(result, TableKind::NodeLoads) == "");
        const auto& cases = result.document.model.load_cases;
        CHECK(cases[0].nodes.empty());
        REQUIRE(cases[1].nodes.size() == 2);
        CHECK(cases[1].nodes[0] == document.model.load_cases[0].nodes[0]);
        CHECK(cases[1].nodes[1] == document.model.load_cases[0].nodes[1]);
    }

    TEST_CASE("Rows are filled in the order in which they are seen")
    {
        const Document document = starting_document();
        const Filled result = pasted(document, TableKind::Nodes, {.row = 0, .column = 1, .order = {3, 2, 1, 0}},
                                     "8\n9");
        CHECK(result.document.model.nodes[3].at[0] == 8.0);
        CHECK(result.document.model.nodes[2].at[0] == 9.0);
        CHECK(result.document.model.nodes[0].at[0] == 0.0);
    }

    TEST_CASE("A block that is wider than the table is refused")
    {
        const Document document = starting_document();
        const Filled result = pasted(document, TableKind::Members, {.row = 0, .column = 11}, "1\t2\t3\n");
        CHECK(result.document == document);
        REQUIRE(result.faults.size() == 1);
    }

    TEST_CASE("Names are sorted by the numbers in them, numbers by value")
    {
        const auto cell = [](const char* text) { return Cell{.shown = text, .typed = text, .plain = text}; };
        const Table table{{{"name"}}, {{{}, {cell("N10")}}, {{}, {cell("N9")}}, {{}, {Cell{}}}, {{}, {cell("A")}}}};
        CHECK(sorted_rows(table, 0) == std::vector<std::size_t>{3, 1, 0, 2});
    }

    TEST_CASE("A text with a tab, a quote or a line end in it comes back from the clipboard as it was")
    {
        const std::string odd = "a\tb\"c\nd";
        const Table table{{{"name"}, {"x"}}, {{{}, {Cell{.plain = odd}, Cell{.plain = "1"}}}}};
        const TextBlock block = read_tsv(tsv(table, whole(table)));
        CHECK(block == TextBlock{{"name", "x"}, {odd, "1"}});
        CHECK(csv(table, ui::DecimalMark::Comma).starts_with("name;x\r\n"));
    }
}
