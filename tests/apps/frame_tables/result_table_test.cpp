// Tables of results.
#include "apps/frame/tables/result_table.h"

#include <doctest/doctest.h>

#include <cmath>

#include "apps/frame/document/number.h"
#include "apps/frame/document/solution.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/result/components.h"

using namespace frame;
using femoop::CaseId;

namespace {

Manner in_english(const femoop::Model& model)
{
    return {{ui::UnitSystem::KnM, base_units(model.units), {}}, ui::Catalogue()};
}

/// A column by its heading.
std::vector<double> column(const Table& table, std::string_view label)
{
    std::vector<double> values;
    for (std::size_t j = 0; j < table.headings.size(); ++j) {
        if (table.headings[j].column.label() != label) continue;
        for (const Row& row : table.rows) values.push_back(row.cells[j].value.number.value());
    }
    return values;
}

/// The starting portal, and a combination of its load with others.
Document combined()
{
    Document document = starting_document();
    document.model.load_cases.push_back({.id = "W", .nodes = {{femoop::NodeId(1), {{femoop::Dof::ux, 13.0}}}}});
    document.model.combinations.push_back({"C", {{CaseId(0), 1.35}, {CaseId(1), -1.5}}});
    return document;
}

} // namespace

TEST_SUITE("frame tables: results")
{
    TEST_CASE("Reactions in the table balance the loads")
    {
        const Document document = starting_document();
        const Solution solution = solve(document);
        const Table table = result_table({document.model, *solution.results, CaseId(0)}, TableKind::Reactions,
                                         in_english(document.model));
        const std::vector<double> fy = column(table, "fy [kN]");
        REQUIRE(fy.size() == 2);
        CHECK(fy[0] + fy[1] == doctest::Approx(20.0 * 6.0));
        CHECK(table.rows[1].part == Part(femoop::NodeId(3)));
    }

    TEST_CASE("Every number of a table of one case is known as the number of the results that it shows")
    {
        const Document document = starting_document();
        const Solution solution = solve(document);
        const femoop::CaseResult result = (*solution.results)[CaseId(0)];
        for (const TableKind kind : {TableKind::Displacements, TableKind::Reactions, TableKind::MemberEnds}) {
            const Table table = result_table({document.model, *solution.results, CaseId(0)}, kind,
                                             in_english(document.model));
            for (const Row& row : table.rows)
                for (std::size_t j = 1; j < row.cells.size(); ++j) {
                    REQUIRE(row.cells[j].number);
                    const double value = femoop::influence::effect_in(*row.cells[j].number, result);
                    const double written = row.cells[j].value.number.value();
                    const double factor = kind == TableKind::Displacements && j < 3 ? 1000.0 : 1.0; // mm
                    CHECK(std::abs(written - factor * value) < 1e-9 * (1.0 + std::abs(written)));
                }
        }
        const Table extremes = result_table({document.model, *solution.results, CaseId(0)}, TableKind::Extremes,
                                            in_english(document.model));
        for (const Row& row : extremes.rows)
            for (std::size_t j = 1; j < row.cells.size(); ++j)
                CHECK(row.cells[j].number.has_value() == (j % 2 == 1)); // a value, then its place
    }

    TEST_CASE("The reaction of a slanting roller stands in the table as the one force that it is, too")
    {
        Document document = starting_document();
        const auto reactions = [&] {
            const Solution solution = solve(document);
            return result_table({document.model, *solution.results, CaseId(0)}, TableKind::Reactions,
                                in_english(document.model));
        };
        CHECK(reactions().headings.size() == 4);
        document.model.nodes[3].support->kind = femoop::SupportKind::Roller;
        CHECK(reactions().headings.size() == 4);
        document.model.nodes[3].support->angle = femoop::Quantity(30.0);
        const Table table = reactions();
        REQUIRE(table.headings.size() == 5);
        CHECK(table.headings[4].column.label() == "R [kN]");
        const double fy = table.rows[1].cells[2].value.number.value();
        CHECK(table.rows[1].cells[4].value.number.value() == doctest::Approx(std::abs(fy) / std::sqrt(0.75))); // cos 30
        CHECK_FALSE(table.rows[0].cells[4].value.number.has_value());
    }

    TEST_CASE("The extremes of a member are no smaller than its ends, and the envelope's no smaller than a case's")
    {
        const Document document = combined();
        const Solution solution = solve(document);
        const Manner manner = in_english(document.model);
        const auto of = [&](TableKind kind, std::size_t load_case, std::string_view label) {
            const TabledResults results{document.model, *solution.results, CaseId(load_case)};
            return column(result_table(results, kind, manner), label);
        };
        const std::vector<double> all = of(TableKind::Envelope, 0, "M max [kN·m]");
        for (std::size_t load_case = 0; load_case < 3; ++load_case) {
            const std::vector<double> most = of(TableKind::Extremes, load_case, "M max [kN·m]");
            const std::vector<double> start = of(TableKind::MemberEnds, load_case, "M, start [kN·m]");
            for (std::size_t i = 0; i < most.size(); ++i) {
                CHECK(most[i] >= start[i] - 1e-9);
                CHECK(all[i] >= most[i] - 1e-9);
            }
        }
    }

    TEST_CASE("A combination is tabled as the sum of its cases")
    {
        const Document document = combined();
        const Solution solution = solve(document);
        const auto ux = [&](std::size_t load_case) {
            const TabledResults results{document.model, *solution.results, CaseId(load_case)};
            return column(result_table(results, TableKind::Displacements, in_english(document.model)), "ux [mm]")[1];
        };
        CHECK(ux(2) == doctest::Approx(1.35 * ux(0) - 1.5 * ux(1)));
    }

    TEST_CASE("A spreadsheet gets numbers with every digit and a plain minus sign")
    {
        const Document document = starting_document();
        const Solution solution = solve(document);
        const Table table = result_table({document.model, *solution.results, CaseId(0)}, TableKind::MemberEnds,
                                         in_english(document.model));
        const std::string text = separated(values(table, whole(table)), tabular::tabs);
        CHECK(text.starts_with("Member\tN, start [kN]\tV, start [kN]\tM, start [kN·m]"));
        CHECK(text.find("−") == std::string::npos);
        const double V = (*solution.results)[CaseId(0)].curve(femoop::MemberId(1)).forces(0.0).Vy;
        CHECK(std::stod(table.rows[1].cells[2].value.exact) == doctest::Approx(V).epsilon(1e-13));
    }
}
