// A click on a problem goes to its case, its part and the cell of the field.
#include "apps/frame/session/fault_target.h"
#include "apps/frame/tables/columns.h"
#include "femoop/io/model_file.h"
#include "tests/source_folder.h"

#include <doctest/doctest.h>

#include <string>

using namespace frame;
using femoop::CaseId;
using femoop::Quantity;

namespace {

femoop::Model portal() { return femoop::read_model_file(source_folder() + "/examples/portal.json"); }

Workspace workspace_of(femoop::Model model) { return Workspace{Session{{.model = std::move(model), .companion = {}}}}; }

/// "Sections: column, Depth h"
std::string cell(const Workspace& workspace)
{
    if (!workspace.bottom.is_open || !workspace.bottom.wanted) return "nothing";
    const ui::Catalogue english;
    const auto headings = columns(workspace.session.model(), workspace.bottom.table);
    return english(title(workspace.bottom.table)) + ": " +
           english(title(workspace.session.model(), workspace.bottom.wanted->row)) + ", " +
           english(headings[workspace.bottom.wanted->column].heading);
}

std::string selected(const Workspace& workspace)
{
    std::string names;
    for (const Part& part : workspace.session.selection.parts())
        names += (names.empty() ? "" : ", ") + ui::Catalogue()(title(workspace.session.model(), part));
    return names;
}

} // namespace

TEST_SUITE("frame fault target")
{
    TEST_CASE("A fault of an excerpt or of a model that was refused goes to what has its names, else nowhere")
    {
        Workspace workspace = workspace_of(portal());
        const auto about = [&](std::string place) {
            workspace.session.selection.clear();
            go_to(workspace, {femoop::FaultKind::PositionBeyondEnd, {std::move(place), "9 m", "CD", "4.5 m"}});
            return selected(workspace);
        };
        CHECK(about("members[0] \"CD\"") == "Member CD"); // of an excerpt, in which it is the first
        CHECK(about("members[1] \"BC\"") == "Member BC");
        CHECK(about("members[1] \"XY\"") == "");
        workspace.session.selection.clear();
        go_to(workspace, {femoop::FaultKind::CrossRigidMember, {"AB"}});
        CHECK(selected(workspace) == "Member AB");
    }

    TEST_CASE("What a load lacks elsewhere selects the member, shows its case and opens the cell that lacks it")
    {
        femoop::Model model = portal();
        model.combinations.clear();
        for (femoop::Section& section : model.sections)
            section = {.id = section.id, .A = Quantity(0.01), .Iz = Quantity(1e-4)};
        model.load_cases.push_back(
            {.id = "T", .members = {{femoop::MemberId(2), femoop::TemperatureLoad{Quantity(10.0), Quantity(30.0)}}}});
        Workspace workspace = workspace_of(std::move(model));
        REQUIRE(workspace.session.solution().faults.size() == 1);
        workspace.session.view.is_envelope = true;
        go_to(workspace, workspace.session.solution().faults[0]);
        CHECK(workspace.session.view.load_case == CaseId(3));
        CHECK(!workspace.session.view.is_envelope);
        CHECK(selected(workspace) == "Member CD");
        CHECK(cell(workspace) == "Sections: Section column, Depth h");
    }

    TEST_CASE("A load's own fault selects the load and opens its cell")
    {
        femoop::Model model = portal();
        model.load_cases[2].members.push_back(
            {femoop::MemberId(1), femoop::PointLoad{.at = Quantity(9.0), .components = {{femoop::Dof::uy, -4.0}}}});
        Workspace workspace = workspace_of(std::move(model));
        go_to(workspace, workspace.session.solution().faults.at(0));
        CHECK(workspace.session.view.load_case == CaseId(2));
        CHECK(selected(workspace) == "Point load on member BC");
        CHECK(cell(workspace) == "Point loads: Point load on member BC, Distance from the start");
    }

    TEST_CASE("A part's fault selects the part and opens its cell")
    {
        femoop::Model model = portal();
        model.materials[0].E = Quantity(-3.0);
        Workspace workspace = workspace_of(std::move(model));
        go_to(workspace, workspace.session.solution().faults.at(0));
        CHECK(selected(workspace) == "Material steel");
        CHECK(cell(workspace) == "Materials: Material steel, E");
    }

    TEST_CASE("A spring at a member's end stands in the table of releases and springs")
    {
        femoop::Model model = portal();
        model.members[1].start.springs = {{femoop::Dof::rz, Quantity(-5.0)}};
        Workspace workspace = workspace_of(std::move(model));
        go_to(workspace, workspace.session.solution().faults.at(0));
        CHECK(selected(workspace) == "Member BC");
        CHECK(cell(workspace) == "Releases and springs: Member BC, Spring rz, start");
    }

    TEST_CASE("A fault that the analysis found selects the nodes that it names and opens nothing")
    {
        femoop::Model model = portal();
        for (femoop::Member& member : model.members) member.bar = true;
        Workspace workspace = workspace_of(std::move(model));
        REQUIRE(!workspace.session.solution().faults.empty());
        go_to(workspace, workspace.session.solution().faults.back());
        CHECK(!selected(workspace).empty());
        CHECK(cell(workspace) == "nothing");
    }
}
