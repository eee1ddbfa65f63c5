// One model put into another.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "femoop/analysis/linear_static.h"
#include "femoop/edit/condense.h"
#include "femoop/edit/insert.h"
#include "femoop/edit/member_line.h"
#include "femoop/model/check/check.h"
#include "femoop/model/quantity/in_units.h"
#include "femoop/typical/typical.h"
#include "tests/femoop/analysis/random_structure.h"

using namespace femoop;

namespace {

const Placement unmoved = Placement::Identity();
const Placement far_away = moved_by({700, 0, 0});

/// The displacements of a model's nodes, those of the inserted ones by their names in their own model.
double difference(const Model& a, const Model& b, std::string_view case_id)
{
    const Results results_a = analyse(a), results_b = analyse(b);
    double largest = 0.0;
    for (std::size_t i = 0; i < a.nodes.size(); ++i)
        for (const Dof dof : all_dofs) {
            if (!dofs(a.analysis).contains(dof)) continue;
            const auto u = [&](const Model& model, const Results& results) {
                return results[*model.find_case(case_id)].displacement(NodeId(i))[index(dof)];
            };
            const double u_a = u(a, results_a), u_b = u(b, results_b);
            largest = std::max(largest, std::abs(u_a - u_b) / (1e-9 + std::abs(u_a)));
        }
    return largest;
}

} // namespace

TEST_SUITE("edit: inserting")
{
    TEST_CASE("A model that is inserted into an empty one has the results that it had")
    {
        for (const AnalysisKind kind : every_model) {
            CAPTURE(name(kind));
            const Model other = random_structure(kind, 17);
            Model model;
            model.analysis = kind;
            model.units = other.units;
            insert(model, other, unmoved);
            for (const char* const load_case : {"P", "Q"}) CHECK(difference(other, model, load_case) < 1e-9);
        }
    }

    TEST_CASE("What is inserted far away changes no result of what was there")
    {
        for (const AnalysisKind kind : every_model) {
            CAPTURE(name(kind));
            const Model before = random_structure(kind, 5);
            Model model = before;
            insert(model, random_structure(kind, 29), far_away);
            CHECK(model.nodes.size() > before.nodes.size());
            for (const char* const load_case : {"P", "Q"}) CHECK(difference(before, model, load_case) < 1e-6);
        }
    }

    TEST_CASE("A model of other units is counted in those of the model")
    {
        const Model beam = ContinuousBeam{.spans = 2, .span = 6.0, .load = 13.0}.model();
        Model model;
        model.units = {.length = LengthUnit::cm, .force = ForceUnit::N};
        insert(model, beam, unmoved);
        CHECK(model.nodes[1].at[0] == 600.0);
        CHECK(model.sections[0].A->value() == 100.0);
        const Results inserted = analyse(model), own = analyse(beam);
        const double M = own[CaseId(0)].curve(MemberId(0)).forces(6.0).Mz; // kN m
        CHECK(inserted[CaseId(0)].curve(MemberId(0)).forces(600.0).Mz == doctest::Approx(M * 1e5));
    }

    TEST_CASE("Materials and sections that are alike are shared, others keep their own")
    {
        Model model = ContinuousBeam{}.model();
        Model other = ContinuousBeam{}.model();
        other.sections[0].A = 0.02;
        const Parts added = insert(model, other, far_away);
        CHECK(model.materials.size() == 1);
        CHECK(added.materials.empty());
        REQUIRE(model.sections.size() == 2);
        CHECK(model.sections[1].id == "s2");
        CHECK(model[added.members[0]].section == SectionId(1));
        CHECK(model.load_cases.size() == 1);
    }

    TEST_CASE("No name is given twice, and free names are kept")
    {
        Model model = StoreyFrame{}.model();
        insert(model, StoreyFrame{}.model(), far_away);
        const Parts girder = insert(model, VierendeelGirder{}.model(), moved_by({0, 50, 0}));
        for (const Fault& fault : check(model)) CHECK(severity(fault.kind) != Severity::Error);
        CHECK(model[girder.nodes[0]].id == "L0");
        CHECK(model[girder.members[0]].id == "L0U0");
    }

    TEST_CASE("Load cases of one name but another self-weight stay apart: neither result would be its own")
    {
        Model model = ContinuousBeam{}.model();
        Model other = ContinuousBeam{}.model();
        other.load_cases[0].self_weight = 1.0;
        const Parts added = insert(model, other, far_away);
        REQUIRE(model.load_cases.size() == 2);
        CHECK(model.load_cases[1].id == "G2");
        CHECK(added.cases == std::vector{CaseId(1)});
    }

    TEST_CASE("Combinations keep what they combine, though there are more load cases before them")
    {
        Model model = ContinuousBeam{}.model();
        model.combinations = {{"U", {{CaseId(0), 1.4}}}, {"UU", {{CaseId(1), 2.0}}}};
        Model other = ContinuousBeam{}.model();
        other.load_cases.push_back({.id = "W"});
        other.combinations = {{"U", {{CaseId(3), 1.5}}}, {"V", {{CaseId(1), 0.9}}}};
        insert(model, other, far_away);
        // G W | U UU U2 V
        REQUIRE(model.n_cases() == 6);
        CHECK(model.combinations[0].terms[0].of == CaseId(0));
        CHECK(model.combinations[1].terms[0].of == CaseId(2));
        CHECK(model.combinations[2].id == "U2");
        CHECK(model.combinations[2].terms[0].of == CaseId(5));
        CHECK(model.combinations[3].terms[0].of == CaseId(1));
    }

    TEST_CASE("Combinations of one name and the same terms are one")
    {
        Model model = ContinuousBeam{}.model();
        model.combinations = {{"U", {{CaseId(0), 1.4}}}};
        const Model other = model;
        insert(model, other, far_away);
        CHECK(model.combinations.size() == 1);
    }

    TEST_CASE("A model of another analysis is refused")
    {
        Model model = ContinuousBeam{}.model();
        const Model before = model;
        CHECK_THROWS_AS(insert(model, PlaneTruss{}.model(), unmoved), std::invalid_argument);
        CHECK(model == before);
    }
}
