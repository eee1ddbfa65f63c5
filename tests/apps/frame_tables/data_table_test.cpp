// Tables of a document: read, copied, pasted back.
#include "apps/frame/tables/data_table.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "apps/frame/document/solution.h"
#include "femoop/io/model_file.h"
#include "tests/source_folder.h"

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
    return sentence(result.faults, data_table(result.document.model, kind, manner), manner.tr);
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
    model.load_cases.front().self_weight = 1.1;
    model.combinations.push_back({"U", {{femoop::CaseId(0), 1.35}, {femoop::CaseId(1), -0.9}}});
    model.combinations.push_back({"S", {{femoop::CaseId(2), 0.7}}}); // of the one before
    model.members[2].end.springs.push_back({femoop::Dof::rz, femoop::Quantity(850.0, "0.85 MN*m/rad")});
    model.members[2].end.offset = {0.1, -0.25};
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
                const std::string text = separated(values(table, whole(table)), tabular::tabs);
                CAPTURE(text);
                const Filled result = filled(document, kind, {}, read_block(text, table, 0), manner);
                CHECK((result.faults.empty() ? "" : sentence(result.faults, table, manner.tr)) == "");
                CHECK(result.document == document);
            }
        }
    }

    TEST_CASE("The tables of every model among the examples and cases can be pasted back")
    {
        for (const char* folder : {"examples", "tests/cases"}) {
            const std::filesystem::path root = std::filesystem::path(source_folder()) / folder;
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
                    const TextBlock texts = read_block(separated(values(table, whole(table)), tabular::tabs), table, 0);
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
        CHECK(first_fault(result, TableKind::Nodes).ends_with(". See also: row 4, x [m]"));
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
        CHECK(first_fault(pasted(document, TableKind::Members, {.row = 3}, "X\tA\tnowhere\n"), TableKind::Members)
                  .find("\"nowhere\" is not there; choose from A, B, C, D") != std::string::npos);
        CHECK(first_fault(pasted({}, TableKind::Members, {}, "X\tA\tB\n"), TableKind::Members)
                  .find("\"A\" is not there, and no other; add one first") != std::string::npos);
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
        const Filled result = pasted(document, TableKind::Members, {.row = 0, .column = 13}, "1\t2\t3\n");
        CHECK(result.document == document);
        REQUIRE(result.faults.size() == 1);
    }

    TEST_CASE("Names are sorted by the numbers in them, numbers by value")
    {
        const Table table{{{"name"}}, {{{}, {{"N10"}}}, {{}, {{"N9"}}}, {{}, {Cell{}}}, {{}, {{"A"}}}}};
        CHECK(sorted_rows(table, 0) == std::vector<std::size_t>{3, 1, 0, 2});
    }

    TEST_CASE("A table as comma-separated values has semicolons where the comma is decimal")
    {
        const Table table{{{"name"}, {"x"}}, {{{}, {{"a;b"}, {"1"}}}}};
        CHECK(csv(table, ui::DecimalMark::Comma) == "name;x\r\n\"a;b\";1\r\n");
        CHECK(csv(table, ui::DecimalMark::Point) == "name,x\r\na;b,1\r\n");
    }

    TEST_CASE("A node that is named like a formula is copied as words and pasted under its own name")
    {
        for (const char* name : {"=1+1", "-N", "+2", "@x", "'=1", "'quoted"}) {
            Document document = starting_document();
            document.model.nodes[1].id = name;
            const Manner manner = english(document.model);
            const Table table = data_table(document.model, TableKind::Nodes, manner);
            const std::string copied = separated(values(table, whole(table)), tabular::tabs);
            CAPTURE(copied);
            CHECK(std::string("=-+@").find(copied[copied.find('\n', copied.find('\n') + 1) + 1]) == std::string::npos);
            document.model.nodes[1].id = "other";
            const Filled result = filled(document, TableKind::Nodes, {0, 0}, read_block(copied, table, 0), manner);
            CHECK(result.faults.empty());
            CHECK(result.document.model.nodes[1].id == name);
        }
    }

    TEST_CASE("Self-weight and the factors of combinations are typed, and a new combination is a new row")
    {
        const Filled heavier = pasted(rich(), TableKind::LoadCases, {0, 0}, "G\t1.35");
        CHECK(first_fault(heavier, TableKind::LoadCases) == "");
        CHECK(heavier.document.model.load_cases[0].id == "G");
        CHECK(heavier.document.model.load_cases[0].self_weight == 1.35);
        const Filled combined = pasted(rich(), TableKind::Combinations, {1, 0}, "S\t1\t\t\nX\t1,25\t2/3\t0.5");
        CHECK(first_fault(combined, TableKind::Combinations) == "");
        const auto& all = combined.document.model.combinations;
        REQUIRE(all.size() == 3);
        CHECK(all[1].terms == std::vector{femoop::Combination::Term{femoop::CaseId(0), 1.0}});
        CHECK(all[2].id == "X");
        REQUIRE(all[2].terms.size() == 3);
        CHECK(all[2].terms[1].factor == doctest::Approx(2.0 / 3.0));
        CHECK(all[2].terms[2].of == femoop::CaseId(2)); // U, which S was made of
    }

    TEST_CASE("A new load case stands before the combinations, which go on meaning what they meant")
    {
        const Document before = rich();
        const Filled result = pasted(before, TableKind::LoadCases, {2, 0}, "snow\t0");
        CHECK(first_fault(result, TableKind::LoadCases) == "");
        const femoop::Model& model = result.document.model;
        REQUIRE(model.load_cases.size() == 3);
        CHECK(model.load_cases[2].id == "snow");
        CHECK(model.combinations[0] == before.model.combinations[0]);
        CHECK(model.case_name(model.combinations[1].terms[0].of) == "U");
    }

    TEST_CASE("Names of load cases and combinations stand once among both, and a combination has a factor")
    {
        CHECK(first_fault(pasted(rich(), TableKind::LoadCases, {0, 0}, "U"), TableKind::LoadCases) ==
              "row 1, Load case: the name \"U\" is taken");
        CHECK(first_fault(pasted(rich(), TableKind::Combinations, {2, 0}, "V"), TableKind::Combinations) ==
              "row 3: the combination has no factor; give it one or delete its row");
    }

    TEST_CASE("A spring at a member's end takes the place of a release, and a release that of a spring")
    {
        const Document document = rich();
        const Manner manner = english(document.model);
        const Table table = data_table(document.model, TableKind::Joints, manner);
        const auto column = [&](std::string_view label) {
            for (std::size_t j = 0; j < table.headings.size(); ++j)
                if (table.headings[j].column.label().starts_with(label)) return j;
            return table.headings.size();
        };
        const Filled sprung = pasted(document, TableKind::Joints, {1, column("Spring rz, start")}, "500");
        CHECK(first_fault(sprung, TableKind::Joints) == "");
        const femoop::MemberEnd& start = sprung.document.model.members[1].start;
        CHECK(start.release.is_empty());
        REQUIRE(start.springs.size() == 1);
        CHECK(start.springs[0].stiffness == 500.0);
        const Filled released = pasted(document, TableKind::Joints, {2, column("Released at end")}, "rz");
        CHECK(released.document.model.members[2].end.springs.empty());
        CHECK(pasted(document, TableKind::Joints, {0, column("Spring rz, end")}, "-3").faults.size() == 1);
        CHECK(first_fault(pasted(document, TableKind::Joints, {3, 1}, "rz"), TableKind::Joints) ==
              "row 4: this table gets its rows from another one");
    }
}
