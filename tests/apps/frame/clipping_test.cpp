#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "apps/frame/document/clipping.h"
#include "apps/frame/document/drawing.h"
#include "apps/frame/document/selection.h"
#include "apps/frame/document/solution.h"
#include "apps/frame/session/tabs.h"
#include "apps/frame/session/work.h"
#include "femoop/io/model_file.h"
#include "femoop/model/check/check.h"
#include "tests/apps/frame/example_workspace.h"
#include "tests/source_folder.h"

using namespace frame;
using femoop::MemberId;
using femoop::NodeId;
using frame_test::run;
using frame_test::workspace_with;

namespace {

femoop::Model model_of(const std::string& file)
{
    return femoop::read_model_file(source_folder() + "/examples/" + file);
}

constexpr MemberId loaded_beam{1}; // of the portal: the beam, loaded in G and Q, from B (0, 4.5) to C (8, 4.5)

} // namespace

TEST_SUITE("frame document: clipboard")
{
    TEST_CASE("A structure in space is pasted at a place of three coordinates, its grip the node of least x, y and z")
    {
        Workspace workspace = workspace_with("bent_cantilever.json");
        const femoop::Model before = workspace.session.model();
        workspace.session.selection = Part(MemberId(0));
        CHECK(!run(workspace, "edit.clip"));
        CHECK(!run(workspace, "edit.paste"));
        workspace.tool_controller.type("1,2,9");
        workspace.session.change(*workspace.tool_controller.enter(work_of(workspace.session)));
        REQUIRE(workspace.session.model().members.size() == before.members.size() + 1);
        const femoop::NodeId first(before.nodes.size());
        CHECK(position_of(workspace.session.model(), first).isApprox(Eigen::Vector3d(1, 2, 9)));
        CHECK(workspace.tool_controller.kind() == ToolKind::Select);
    }

    TEST_CASE("A member is copied with its nodes, loads, material and section, and nothing else")
    {
        const femoop::Model model = model_of("portal.json");
        const auto clipping = clipping_of(Document{model}, std::vector<Part>{loaded_beam});
        REQUIRE(clipping);
        CHECK(clipping->holds == Clipping::Holds::Structure);
        CHECK(clipping->model.members.size() == 1);
        CHECK(clipping->model.nodes.size() == 2);
        CHECK(clipping->model.materials.size() == 1);
        CHECK(clipping->model.sections.size() == 1);
        CHECK(clipping->model.combinations.empty());
        CHECK(femoop::check(clipping->model).empty());
    }

    TEST_CASE("Pasted into its own document it shares material, section and load cases, and its loads double")
    {
        Document document{model_of("portal.json")};
        const femoop::Model before = document.model;
        paste(document, *clipping_of(Document{before}, std::vector<Part>{loaded_beam}), {20.0, 1.0, 0.0});
        CHECK(document.model.members.size() == before.members.size() + 1);
        CHECK(document.model.materials == before.materials);
        CHECK(document.model.sections == before.sections);
        CHECK(document.model.n_cases() == before.n_cases());
        const femoop::Member& pasted = document.model.members.back();
        CHECK(document.model[pasted.nodes[0]].at[0] == doctest::Approx(20.0)); // the grip is the end at the left
        CHECK(document.model[pasted.nodes[0]].at[1] == doctest::Approx(1.0));
        CHECK(document.model[pasted.nodes[1]].at[0] == doctest::Approx(20.0 + 8.0));
        CHECK(document.model.load_cases[0].members.size() == before.load_cases[0].members.size() + 1);
    }

    TEST_CASE("The whole of a structure brings its combinations, and load cases that are about it as a whole")
    {
        femoop::Model model = model_of("portal.json");
        model.load_cases.push_back({.id = "weight", .self_weight = 1.0});
        model.materials[0].density = 7850.0;
        model.combinations.clear();
        model.combinations.push_back(
            {.id = "all", .terms = {{femoop::CaseId(0), 1.2}, {femoop::CaseId(model.load_cases.size() - 1), 1.4}}});
        const Selection whole = everything(model);
        Document document;
        document.model.units = model.units;
        paste(document, *clipping_of(Document{model}, whole.parts()), {0.0, 0.0, 0.0});
        CHECK(document.model.load_cases == model.load_cases);
        CHECK(document.model.combinations == model.combinations);
    }

    TEST_CASE("A case with self-weight is not pasted over a material without density, and the remedy is told")
    {
        Workspace workspace = workspace_with("portal.json");
        workspace.session.change({"weigh", [](Document& document) {
                                      document.model.load_cases[0].self_weight = 1.0;
                                      for (femoop::Material& material : document.model.materials)
                                          material.density = 7850.0;
                                  }});
        workspace.session.selection = Part(loaded_beam);
        CHECK(!run(workspace, "edit.clip"));
        CHECK(!run(workspace, "file.new"));
        workspace.session.change({"draw", [](Document& document) {
                                      draw_member(document, {0, 0}, {3, 0});
                                      document.model.materials[0].density.reset();
                                  }});
        workspace.session.notice.reset();
        CHECK(!run(workspace, "edit.paste"));
        CHECK(workspace.tool_controller.kind() == ToolKind::Select);
        REQUIRE(workspace.session.notice);
        CHECK(workspace.session.notice->faults.at(0).kind == femoop::FaultKind::MissingDensity);
    }

    TEST_CASE("In an empty document what is pasted brings all that it needs, and is solved to the same results")
    {
        const femoop::Model model = model_of("portal.json");
        const Selection all = everything(model);
        Document empty;
        paste(empty, *clipping_of(Document{model}, all.parts()), {0.0, 0.0, 0.0});
        CHECK(empty.model.nodes.size() == model.nodes.size());
        const Solution solution = solve(empty), original = solve(Document{model});
        REQUIRE(solution.results);
        const auto moment = [](const Solution& of) {
            return (*of.results)[femoop::CaseId(0)].curve(loaded_beam).extremes(femoop::MemberComponent::Mz).max.value;
        };
        CHECK(moment(solution) == doctest::Approx(moment(original)));
    }

    TEST_CASE("In a document of other units the lengths and forces stay what they were")
    {
        Document inches;
        inches.model.units.length = femoop::LengthUnit::in;
        inches.model.units.force = femoop::ForceUnit::lbf;
        paste(inches, *clipping_of(Document{model_of("portal.json")}, std::vector<Part>{loaded_beam}),
              {100.0, 0.0, 0.0});
        CHECK(inches.model.nodes[0].at[0] == doctest::Approx(100.0));
        CHECK(inches.model.nodes[1].at[0] == doctest::Approx(100.0 + 8.0 / 0.0254));
    }

    TEST_CASE("Dimension lines go with the nodes that they measure, in the units of where they come to")
    {
        Document portal{model_of("portal.json")};
        portal.companion.dimensions = {
            {.nodes = {"B", "C"}, .direction = DimensionDirection::Horizontal, .offset = 1.5},
            {.nodes = {"A", "B"}, .direction = DimensionDirection::Vertical, .offset = 0.75}};
        const Clipping beam = *clipping_of(portal, std::vector<Part>{loaded_beam});
        REQUIRE(beam.dimensions.size() == 1);
        Document inches;
        inches.model.units.length = femoop::LengthUnit::in;
        paste(inches, beam, {100.0, 0.0, 0.0});
        paste(inches, beam, {100.0, 900.0, 0.0});
        REQUIRE(inches.companion.dimensions.size() == 2);
        const DimensionLine& second = inches.companion.dimensions[1];
        CHECK(second.nodes == std::vector{inches.model.nodes[2].id, inches.model.nodes[3].id});
        CHECK(second.direction == DimensionDirection::Horizontal);
        CHECK(second.offset == doctest::Approx(1.5 / 0.0254));
    }

    TEST_CASE("Cut and pasted at the old place a dimension line is there once, and undo brings each state back")
    {
        Workspace workspace = workspace_with("portal.json");
        const DimensionLine span{.nodes = {"B", "C"}, .direction = DimensionDirection::Horizontal, .offset = 1.5};
        workspace.session.change({"Draw", [&](Document& document) { document.companion.dimensions = {span}; }});
        const auto lines = [&] { return workspace.session.document().companion.dimensions; };
        for (const Selection& what : {everything(workspace.session.model()), Selection(Part(loaded_beam))}) {
            workspace.session.selection = what;
            CHECK(!run(workspace, "edit.cut"));
            const std::size_t n_left = workspace.session.model().nodes.empty() ? 0 : 1;
            CHECK(lines().size() == n_left);
            CHECK(!run(workspace, "edit.paste"));
            workspace.tool_controller.type("@0,0");
            workspace.session.change(*workspace.tool_controller.enter(work_of(workspace.session)));
            CHECK(lines() == std::vector{span});
            CHECK(!run(workspace, "edit.undo"));
            CHECK(lines().size() == n_left);
            CHECK(!run(workspace, "edit.undo"));
            CHECK(lines() == std::vector{span});
        }
    }

    TEST_CASE("Loads that are copied alone go onto the members that are selected, in the load case of their name")
    {
        Document document{model_of("portal.json")};
        const femoop::Model before = document.model;
        const std::vector<Part> loads = loads_on(before, loaded_beam);
        REQUIRE(!loads.empty());
        const auto clipping = clipping_of(Document{before}, std::vector<Part>{loads.front()});
        REQUIRE(clipping);
        CHECK(clipping->holds == Clipping::Holds::Loads);
        CHECK(why_not_paste(before, {}, *clipping));
        paste_loads(document, *clipping, std::vector<Part>{MemberId(0), MemberId(2)});
        CHECK(document.model.members.size() == before.members.size());
        CHECK(document.model.load_cases.size() == before.load_cases.size());
        CHECK(loads_on(document.model, MemberId(0)).size() == loads_on(before, MemberId(0)).size() + 1);
        CHECK(loads_on(document.model, MemberId(2)).size() == loads_on(before, MemberId(2)).size() + 1);
    }

    TEST_CASE("Cut, then pasted at its old place, leaves the structure as it was, in two steps")
    {
        Workspace workspace = workspace_with("portal.json");
        CHECK(run(workspace, "edit.paste") == "nothing was copied yet");
        CHECK(run(workspace, "edit.clip") == "nothing is selected that can be copied");
        workspace.session.selection = Part(loaded_beam);
        const std::size_t n_states = workspace.session.history().n_states();
        CHECK(!run(workspace, "edit.cut"));
        CHECK(workspace.session.model().members.size() == 2);
        CHECK(!run(workspace, "edit.paste"));
        REQUIRE(workspace.tool_controller.kind() == ToolKind::Paste);
        workspace.tool_controller.type("0,4.5");
        workspace.session.change(*workspace.tool_controller.enter(work_of(workspace.session)));
        CHECK(workspace.tool_controller.kind() == ToolKind::Select);
        CHECK(workspace.session.model().members.size() == 3);
        CHECK(workspace.session.model().nodes.size() == 4); // joined
        CHECK(workspace.session.history().n_states() == n_states + 2);
        CHECK(ui::Catalogue()(*workspace.session.history().undo_label()) == "Paste");
        REQUIRE(workspace.session.selection.size() > 0);
        const auto part = workspace.session.selection.parts();
        CHECK(std::ranges::any_of(part, [](const Part& p) { return std::holds_alternative<MemberId>(p); }));
    }

    TEST_CASE("What was copied of a truss does not go into a frame, and the reason is told")
    {
        Workspace workspace = workspace_with("truss.json");
        workspace.session.selection = everything(workspace.session.model());
        CHECK(!run(workspace, "edit.clip"));
        REQUIRE(open_file(workspace, source_folder() + "/examples/portal.json"));
        CHECK(run(workspace, "edit.paste") == "what was copied is of another kind of structure");
        new_document(workspace);
        CHECK(!run(workspace, "edit.paste")); // an empty sheet becomes what comes into it
    }
}
