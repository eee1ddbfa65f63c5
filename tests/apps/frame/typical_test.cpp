// Typical structures: their numbers, and what becomes of a document that one of them is put into.
#include <doctest/doctest.h>

#include <algorithm>

#include "apps/frame/document/solution.h"
#include "apps/frame/document/typical.h"
#include "femoop/model/check/check.h"

using namespace frame;

namespace {

const TypicalStructure& named(std::string_view id)
{
    return *std::ranges::find(typical_structures(), id, &TypicalStructure::id);
}

femoop::Model made(std::string_view id) { return named(id).model(first_numbers(named(id))); }

double moment(const Document& document, std::string_view member, double x)
{
    const Solution solution = solve(document);
    return (*solution.results).at("G").curve(*document.model.find_member(member)).forces(x).Mz;
}

bool has_errors(const femoop::Model& model)
{
    return std::ranges::any_of(check(model), [](const femoop::Fault& fault) {
        return femoop::severity(fault.kind) == femoop::Severity::Error;
    });
}

} // namespace

TEST_SUITE("frame: typical structures")
{
    TEST_CASE("Each of the fourteen can be solved with the numbers that it starts with")
    {
        CHECK(typical_structures().size() == 14);
        for (const TypicalStructure& structure : typical_structures()) {
            CAPTURE(structure.id);
            CHECK(solve({structure.model(first_numbers(structure))}).results);
        }
    }

    TEST_CASE("At either end of every slider there is a sound structure, and one step beyond the end of a count none")
    {
        for (const TypicalStructure& structure : typical_structures())
            for (std::size_t i = 0; i < structure.numbers.size(); ++i) {
                const TypicalNumber& number = structure.numbers[i];
                CAPTURE(structure.id);
                CAPTURE(number.id);
                std::vector<double> numbers = first_numbers(structure);
                for (const double end : {number.least, number.most}) {
                    numbers[i] = end;
                    CHECK_FALSE(why_not(number, end));
                    CHECK_FALSE(has_errors(structure.model(numbers)));
                }
                if (!number.is_count()) continue;
                for (const double beyond : {number.least - 1.0, number.most + 1.0}) CHECK(why_not(number, beyond));
            }
    }

    TEST_CASE("A number that no structure can have is answered with what is wanted")
    {
        const auto& panels = named("pratt").numbers[0];
        CHECK(why_not(panels, 7.0) ==
              ui::Message("wanted an even number from {least} to {most}", {{"least", "4"}, {"most", "40"}}));
        CHECK(why_not(named("warren").numbers[0], 2.5));
        CHECK(why_not(named("warren").numbers[1], -3.0));
        CHECK(why_not(named("warren").numbers[1], 0.0));
        CHECK_FALSE(why_not(named("warren").numbers[1], 137.5));
        CHECK_FALSE(why_not(named("warren").numbers[3], -12.0));
    }

    TEST_CASE("A structure beside another changes no moment of it, and its loads join the case that is looked at")
    {
        Document document = starting_document();
        document.model.materials[0].density = 7.85;
        document.model.load_cases.insert(document.model.load_cases.begin(), {.id = "weight", .self_weight = 1.0});
        const double before = moment(document, "BC", 2.5);
        insert_beside(document, made("portal"), {.distance = 3.0, .load_case = femoop::CaseId(1)});
        CHECK(document.model.nodes.size() == 8);
        CHECK(document.model.load_cases.size() == 2);
        CHECK(document.model.load_cases[1].members.size() == 2);
        CHECK(moment(document, "BC", 2.5) == doctest::Approx(before));
        CHECK(document.model.nodes[4].at[0] == 9.0);
        CHECK_FALSE(has_errors(document.model));
    }

    TEST_CASE("A structure at no distance is joined to what it meets")
    {
        Document document = starting_document();
        insert_beside(document, made("beam"), {.distance = 0.0, .load_case = femoop::CaseId(0)});
        CHECK(document.model.nodes.size() == 7); // 4 + 4 less the one that both have
        CHECK(document.model.nodes[3].support->kind == femoop::SupportKind::Fixed);
    }

    TEST_CASE("A structure stands on the level of the lowest node, in the units of the document")
    {
        Document document;
        document.model.units = {.length = femoop::LengthUnit::cm, .force = femoop::ForceUnit::kN};
        put_in_place(document, made("portal"));
        for (femoop::Node& node : document.model.nodes) node.at[1] = node.at[1] - 250.0;
        insert_beside(document, made("gable"), {.distance = 125.0, .load_case = femoop::CaseId(0)});
        CHECK(document.model.nodes[4].at == std::array<femoop::Quantity, 3>{725.0, -250.0, 0.0});
        CHECK(document.model.nodes[8].at[0] == 1925.0);
    }

    TEST_CASE("In place of a structure of another analysis it is the document, in the units that were there")
    {
        Document document = starting_document();
        document.model.notes = "homework";
        document.model.units.force = femoop::ForceUnit::N;
        put_in_place(document, made("grillage"));
        CHECK(document.model.analysis == femoop::AnalysisKind::Grillage);
        CHECK(document.model.units.force == femoop::ForceUnit::N);
        CHECK(document.model.notes == "homework");
        CHECK(document.model.load_cases[0].nodes[0].components[0].value == -20e3);
        CHECK(solve(document).results);
    }
}
