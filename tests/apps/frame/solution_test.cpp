// A fault of one load case leaves the others their results.
#include "apps/frame/document/solution.h"
#include "femoop/io/model_file.h"
#include "tests/source_folder.h"

#include <doctest/doctest.h>

#include <functional>
#include <string>

using namespace frame;
using femoop::CaseId;
using femoop::Model;
using femoop::Quantity;

namespace {

/// Cases G, Q, W and combinations ULS, SLS; then T and a combination with it.
Document portal_with(const std::function<void(Model&, femoop::LoadCase&)>& load)
{
    Model model = femoop::read_model_file(source_folder() + "/examples/portal.json");
    model.combinations.clear();
    model.load_cases.push_back({.id = "T"});
    load(model, model.load_cases.back());
    model.combinations.push_back({.id = "ULS", .terms = {{CaseId(0), 1.35}, {CaseId(1), 1.5}}});
    model.combinations.push_back({.id = "ULS T", .terms = {{CaseId(4), 1.0}, {CaseId(3), 0.6}}});
    model.combinations.push_back({.id = "all", .terms = {{CaseId(5), 1.0}}});
    return {.model = std::move(model), .companion = {}};
}

std::string blank_in(const Solution& solution, const Model& model)
{
    std::string names;
    for (const BlankCase& one : solution.blank) names += (names.empty() ? "" : ", ") + model.case_name(one.id);
    return names;
}

double moment(const Solution& solution, CaseId load_case)
{
    return (*solution.results)[load_case].curve(femoop::MemberId(1)).value(femoop::MemberComponent::Mz, 3.0);
}

} // namespace

TEST_SUITE("frame solution")
{
    TEST_CASE("A load case that cannot be solved is blank with its combinations, and the others have their results")
    {
        const Solution sound = solve(portal_with([](Model&, auto&) {}));
        REQUIRE(sound.results);
        REQUIRE(sound.blank.empty());
        using Load = std::function<void(Model&, femoop::LoadCase&)>;
        const std::vector<std::pair<std::string, Load>> faulty{
            {"a section without depth",
             [](Model& model, auto& t) {
                 for (femoop::Section& section : model.sections)
                     section = {.id = section.id, .A = Quantity(0.01), .Iz = Quantity(1e-4)};
                 t.members.push_back({femoop::MemberId(1), femoop::TemperatureLoad{Quantity(10.0), Quantity(30.0)}});
             }},
            {"a load beyond the member",
             [](Model&, auto& t) {
                 t.members.push_back({femoop::MemberId(1),
                                      femoop::PointLoad{.at = Quantity(9.0), .components = {{femoop::Dof::uy, -4.0}}}});
             }},
            {"a settlement of a free node",
             [](Model&, auto& t) {
                 t.settlements.push_back({femoop::NodeId(1), {{femoop::Dof::uy, -0.01}}});
             }},
            {"a force in a direction that a plane frame lacks",
             [](Model&, auto& t) {
                 t.nodes.push_back({femoop::NodeId(1), {{femoop::Dof::uz, 1.0}}});
             }},
            {"a force beyond the range of numbers",
             [](Model&, auto& t) {
                 t.nodes.push_back({femoop::NodeId(1), {{femoop::Dof::ux, 1e300}}});
             }},
        };
        for (const auto& one : faulty) {
            CAPTURE(one.first);
            const Document document = portal_with(one.second);
            const Solution solution = solve(document);
            REQUIRE(solution.results);
            CHECK(solution.has_errors());
            CHECK(blank_in(solution, document.model) == "T, ULS T, all");
            CHECK(solution.solved_cases() == std::vector{CaseId(0), CaseId(1), CaseId(2), CaseId(4)});
            CHECK(!solution.blank.back().faults.empty());
            CHECK(solution.blank_case(CaseId(1)) == nullptr);
            if (one.first == "a section without depth") continue; // of other sections
            for (const CaseId id : solution.solved_cases())
                CHECK(moment(solution, id) == doctest::Approx(moment(sound, id)).epsilon(1e-12));
        }
    }

    TEST_CASE("A case whose loads drive a mechanism is blank and moves, and the others have their results")
    {
        Document document = portal_with([](Model& model, auto& t) {
            femoop::Node hinge = model.nodes[1];
            hinge.id = "H";
            hinge.at = {Quantity(4.0), Quantity(9.0), Quantity(0.0)};
            hinge.hinge = true;
            const femoop::NodeId top = model.add(hinge);
            for (const std::uint32_t foot : {1U, 2U}) {
                femoop::Member member = model.members[1];
                member.id = "H" + std::to_string(foot);
                member.nodes = {femoop::NodeId(foot), top};
                model.add(member);
            }
            t.nodes.push_back({top, {{femoop::Dof::rz, 5.0}}});
        });
        const Solution solution = solve(document);
        REQUIRE(solution.results);
        CHECK(blank_in(solution, document.model) == "T, ULS T, all");
        CHECK(solution.mechanisms.empty());
        CHECK(solution.blank.front().mechanisms.size() == 1);
        CHECK(std::abs(moment(solution, CaseId(1))) > 1.0);
    }

    TEST_CASE("A fault of the structure leaves no case its results, and one of what is expected leaves all")
    {
        Document loose = portal_with([](Model& model, auto&) {
            for (femoop::Node& node : model.nodes) node.support.reset();
        });
        CHECK(!solve(loose).results);
        CHECK(!solve(loose).mechanisms.empty());
        Document free = portal_with([](Model& model, auto&) {
            model.expected[0].node = femoop::NodeId(1); // a reaction where no support is
        });
        const Solution solution = solve(free);
        CHECK(solution.has_errors());
        REQUIRE(solution.results);
        CHECK(solution.blank.empty());
        CHECK(solution.solved_cases().size() == 7);
    }

    TEST_CASE("Where every case has a fault of its own none has results, and each says why")
    {
        Document document = portal_with([](Model& model, auto& t) {
            t.settlements.push_back({femoop::NodeId(1), {{femoop::Dof::uy, -0.01}}});
            model.load_cases = {t};
            model.expected.clear();
        });
        document.model.combinations.resize(1);
        document.model.combinations[0].terms = {{CaseId(0), 1.35}};
        const Solution solution = solve(document);
        CHECK(!solution.results);
        CHECK(blank_in(solution, document.model) == "T, ULS");
        REQUIRE(solution.blank_case(CaseId(0)));
        CHECK(solution.blank_case(CaseId(0))->faults == solution.faults);
    }

    TEST_CASE("A combination that names itself is blank alone")
    {
        Document document = portal_with([](Model&, auto&) {});
        document.model.combinations[2].terms = {{CaseId(6), 1.0}};
        const Solution solution = solve(document);
        REQUIRE(solution.results);
        CHECK(blank_in(solution, document.model) == "all");
    }

    TEST_CASE("What is solved has nothing of the blank cases, so that it can be analysed again")
    {
        const Document document = portal_with([](Model&, auto& t) {
            t.settlements.push_back({femoop::NodeId(1), {{femoop::Dof::uy, -0.01}}});
        });
        const Model rest = solved_model(document.model, solve(document));
        CHECK(solve({.model = rest, .companion = {}}).blank.empty());
        CHECK(rest.n_cases() == document.model.n_cases());
    }
}
