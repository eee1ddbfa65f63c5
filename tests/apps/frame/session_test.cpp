#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

#include "apps/frame/document/command.h"
#include "apps/frame/document/drawing.h"
#include "apps/frame/document/load_cases.h"
#include "apps/frame/document/loading.h"
#include "apps/frame/session/case_commands.h"
#include "apps/frame/session/edit_commands.h"
#include "apps/frame/session/tabs.h"
#include "femoop/edit/naming.h"
#include "femoop/io/model_file.h"
#include "tests/apps/frame/example_workspace.h"
#include "tests/folder.h"
#include "tests/source_folder.h"

using namespace frame;
using femoop::MemberId;
using femoop::NodeId;
using frame_test::workspace_with;

namespace {

const std::string examples = source_folder() + "/examples/";

void touch(Workspace& workspace)
{
    workspace.session.change({ui::translatable("Change"), [](Document& document) { set_title(document, "Changed"); }});
}

std::string names(const Workspace& workspace)
{
    std::string all;
    for (std::size_t i = 0; i < n_tabs(workspace); ++i)
        all += (i == workspace.tab ? "*" : "") + tab(workspace, i).file_name() + " ";
    return all;
}

void run_soundly(Workspace& workspace, std::string_view id) { CHECK(!ui::run(*command_table().find(id), workspace)); }

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("A file opens in a tab of its own, but in the place of a sheet that nobody has touched")
    {
        Workspace workspace = workspace_with("portal.json");
        CHECK(names(workspace) == "*portal.json ");
        REQUIRE(open_file(workspace, examples + "truss.json"));
        CHECK(names(workspace) == "portal.json *truss.json ");
        REQUIRE(open_file(workspace, examples + "portal.json"));
        CHECK(names(workspace) == "*portal.json truss.json ");
        new_document(workspace);
        CHECK(names(workspace) == "portal.json *Untitled truss.json ");
        CHECK(workspace.session.model().nodes.empty());
        REQUIRE(open_file(workspace, examples + "gerber_beam.json"));
        CHECK(names(workspace) == "portal.json *gerber_beam.json truss.json ");
    }

    TEST_CASE(
        "Beside a case that is kept the model in words tells what changes most, and a case by itself changes nothing")
    {
        Workspace workspace = workspace_with("portal.json");
        CHECK(description(workspace.session).find("changes most") == std::string::npos);
        run_soundly(workspace, "view.compare_case");
        CHECK(description(workspace.session).find("No change: N, V, M, fx, fy, mz, ux, uy, rz.") != std::string::npos);
        workspace.session.view.load_case = femoop::CaseId(1);
        const std::string words = description(workspace.session);
        CHECK(words.find("\nQ: Compared with G\n") != std::string::npos);
        CHECK(words.find("M changes most in member BC at x = 4 m: 83.2702 kN·m now, 58.5228 kN·m before") !=
              std::string::npos);
    }

    TEST_CASE("Units that were chosen follow into another tab, whatever it opens")
    {
        Workspace workspace = workspace_with("portal.json");
        REQUIRE(workspace.session.view.unit_choices.choose("moment", "kN·cm"));
        REQUIRE(open_file(workspace, examples + "truss.json"));
        CHECK(workspace.session.view.unit_choices.text() == "moment=kN·cm");
        CHECK(workspace.session.notice.has_value());
    }

    TEST_CASE("A draft is told by the title of its document, and by its size")
    {
        Workspace workspace = workspace_with("portal.json");
        const auto told = [&] { return workspace.unsaved().at(0).about(ui::Catalogue(ui::Language::English)); };
        workspace.session.change({"Title", [](Document& document) { set_title(document, "Roof over the market"); }});
        CHECK(told() == "Roof over the market: 4 nodes, 3 members");
        workspace.session.change({"Title", [](Document& document) { set_title(document, ""); }});
        CHECK(told() == "4 nodes, 3 members");
    }

    TEST_CASE("A tab without a file is called by its title, and tabs that would be called alike are told apart")
    {
        Workspace workspace = workspace_with("portal.json");
        const auto begin = [&](const char* title) {
            new_document(workspace);
            workspace.session.change({"Title", [&](Document& document) {
                                          set_title(document, title);
                                          document.model.add(femoop::Node{.id = "A"});
                                      }});
        };
        const auto all_names = [&] {
            std::string all;
            for (std::size_t i = 0; i < n_tabs(workspace); ++i) all += tab_name(workspace, i) + "; ";
            return all;
        };
        begin("Roof over the market");
        CHECK(all_names() == "portal.json; Roof over the market; ");
        begin("");
        CHECK(all_names() == "portal.json; Roof over the market; Untitled; ");
        begin("Roof over the market");
        begin("");
        CHECK(all_names() ==
              "portal.json; Roof over the market (1); Untitled (1); Roof over the market (2); Untitled (2); ");
        const Folder folder;
        const std::filesystem::path path = folder.path() / "portal.json";
        std::filesystem::copy_file(examples + "portal.json", path);
        REQUIRE(open_file(workspace, path));
        CHECK(tab_name(workspace, 0) == "examples/portal.json");
        CHECK(tab_name(workspace, 5) == folder.path().filename().string() + "/portal.json");
        REQUIRE(workspace.save_as(folder.path() / "other.json"));
        CHECK(tab_name(workspace, 0) == "portal.json");
    }

    TEST_CASE("A document is saved over its own file and not over that of another tab")
    {
        const Folder folder;
        const std::filesystem::path path = folder.path() / "portal.json";
        std::filesystem::copy_file(examples + "portal.json", path);
        Workspace workspace{Session{Document{}}};
        REQUIRE(open_file(workspace, path));
        touch(workspace);
        CHECK(workspace.save_as(path));
        new_document(workspace);
        touch(workspace);
        CHECK(!workspace.save_as(path));
        REQUIRE(workspace.session.notice);
        CHECK(ui::Catalogue()(workspace.session.notice->sentence) ==
              "portal.json is open in another tab; close it or choose another name");
        CHECK(femoop::read_model_file(path).nodes.size() == 4);
        CHECK(workspace.save_as(folder.path() / "other.json"));
    }

    TEST_CASE("Every order of showing and closing tabs keeps their order and their documents")
    {
        Workspace workspace = workspace_with("portal.json");
        for (const char* file : {"truss.json", "gerber_beam.json", "mechanism.json"})
            REQUIRE(open_file(workspace, examples + file));
        for (const std::size_t place : {0U, 3U, 1U, 2U, 0U, 2U, 1U}) {
            show_tab(workspace, place);
            CHECK(workspace.tab == place);
            CHECK(tab(workspace, 0).file_name() == "portal.json");
            CHECK(tab(workspace, 3).file_name() == "mechanism.json");
        }
        close_tab(workspace); // the second
        CHECK(names(workspace) == "portal.json *gerber_beam.json mechanism.json ");
        show_tab(workspace, 2);
        close_tab(workspace);
        CHECK(names(workspace) == "portal.json *gerber_beam.json ");
        close_tab(workspace);
        close_tab(workspace);
        CHECK(names(workspace) == "*Untitled ");
    }

    TEST_CASE("Who leaves all is asked about each document that is not saved, and what is given up is closed")
    {
        Workspace workspace = workspace_with("portal.json");
        touch(workspace);
        REQUIRE(open_file(workspace, examples + "truss.json"));
        REQUIRE(open_file(workspace, examples + "gerber_beam.json"));
        touch(workspace);
        bool is_left = false;
        workspace.leave_all([&](Workspace&) { is_left = true; });
        CHECK(names(workspace) == "portal.json truss.json *gerber_beam.json ");
        for (const char* left : {"*portal.json truss.json ", "*truss.json "}) {
            CHECK(!is_left);
            REQUIRE(workspace.after_question);
            std::exchange(workspace.after_question, {})(workspace);
            CHECK(names(workspace) == left);
        }
        CHECK(is_left);
        CHECK(!workspace.after_question);
    }

    TEST_CASE("A file that cannot be read leaves every tab as it is and says why")
    {
        Workspace workspace = workspace_with("portal.json");
        touch(workspace);
        CHECK(!open_file(workspace, examples + "no such file.json"));
        CHECK(names(workspace) == "*portal.json ");
        CHECK(workspace.session.model().title == "Changed");
        REQUIRE(workspace.session.notice);
        CHECK(!workspace.session.notice->faults.empty());
    }

    TEST_CASE("What was saved while it was drawn opens again to be mended, though it cannot be solved")
    {
        const Folder folder;
        Workspace workspace{Session{Document{}}};
        workspace.session.change({ui::translatable("Add a node"), [](Document& document) {
                                      add_node(document, {1.0, 2.0});
                                      add_node_load(document, load_case_for(document, femoop::CaseId(0)), NodeId(0),
                                                    {femoop::Dof::uy, femoop::Quantity(-5.0)});
                                  }});
        const Document drawn = workspace.session.document();
        REQUIRE(workspace.session.save(folder.path() / "begun.json"));
        Workspace later = workspace_with("portal.json");
        CHECK(!open_file(later, folder.path() / "begun.json"));
        REQUIRE(later.session.notice);
        CHECK(later.session.notice->to_mend);
        REQUIRE(open_file(later, folder.path() / "begun.json", Session::Purpose::Mend));
        CHECK(later.session.document() == drawn);
    }

    TEST_CASE("Language, theme and units go along from tab to tab, the load case and the camera stay")
    {
        Workspace workspace = workspace_with("portal.json");
        workspace.session.view.load_case = femoop::CaseId(2);
        new_document(workspace);
        workspace.session.set_language(ui::Language::Portuguese);
        workspace.session.view.theme = ui::ThemeName::Dark;
        workspace.session.view.units = ui::UnitSystem::KnCm;
        show_tab(workspace, 0);
        CHECK(workspace.session.view.tr.language() == ui::Language::Portuguese);
        CHECK(workspace.session.view.theme == ui::ThemeName::Dark);
        CHECK(workspace.session.view.load_case == femoop::CaseId(2));
        CHECK(workspace.session.view.units == ui::UnitSystem::KnCm);
        REQUIRE(open_file(workspace, examples + "truss.json"));
        CHECK(workspace.session.view.units == ui::UnitSystem::KnCm);
        close_tab(workspace);
        close_tab(workspace);
        CHECK(workspace.session.view.units == ui::UnitSystem::KnCm);
    }

    TEST_CASE("Of a truss the normal forces are shown where moments were shown of a frame, and the other way")
    {
        Workspace workspace = workspace_with("portal.json");
        workspace.session.view.show = {Show::Loads, Show::M};
        REQUIRE(open_file(workspace, examples + "truss.json"));
        CHECK(workspace.session.view.show == ShowSet{Show::Loads, Show::N});
        show_tab(workspace, 0);
        CHECK(workspace.session.view.show == ShowSet{Show::Loads, Show::M});
        workspace.session.view.show = {Show::N, Show::M};
        show_tab(workspace, 1);
        CHECK(workspace.session.view.show == ShowSet{Show::N, Show::M});
    }

    TEST_CASE("Results that are hidden are hidden in every tab, and revealed in every tab")
    {
        Workspace workspace = workspace_with("portal.json");
        workspace.session.view.show = {Show::Loads, Show::M};
        run_soundly(workspace, "view.hide_results");
        REQUIRE(open_file(workspace, examples + "truss.json"));
        CHECK(workspace.session.view.show == ShowSet{Show::Loads});
        run_soundly(workspace, "view.hide_results");
        CHECK(workspace.session.view.show == ShowSet{Show::Loads, Show::N});
        show_tab(workspace, 0);
        CHECK(workspace.session.view.show == ShowSet{Show::Loads, Show::M});
        CHECK(!workspace.session.hidden);
    }

    TEST_CASE("A few seconds after a change there is a draft, which goes when the document is saved or closed")
    {
        const Folder folder;
        Workspace workspace = workspace_with("portal.json");
        ui::Autosave autosave({folder.path() / "state", ".json"});
        const auto n_drafts = [&] {
            autosave.tick([&] { return workspace.unsaved(); }, ui::Autosave::interval);
            autosave.wait();
            autosave.tick([&] { return workspace.unsaved(); }, ui::Autosave::interval);
            std::size_t n = 0;
            std::error_code none;
            for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "state", none))
                n += entry.path().extension() == ".json" ? 1U : 0U;
            return n;
        };
        CHECK(n_drafts() == 0);
        touch(workspace);
        CHECK(n_drafts() == 1);
        REQUIRE(workspace.session.save(folder.path() / "saved.json"));
        CHECK(n_drafts() == 0);
        workspace.session.undo();
        new_document(workspace);
        CHECK(n_drafts() == 1); // of the tab on the shelf
    }

    TEST_CASE("What a program left behind opens as a document that is not saved, under its own name")
    {
        const Folder folder;
        Document document = starting_document();
        set_title(document, "Left behind");
        const std::filesystem::path draft = folder.path() / "1-0.json";
        femoop::write_model_file(document.model, draft);
        Workspace workspace{Session{Document{}}};
        const auto number = workspace.recover({draft, folder.path() / "lesson.json"});
        REQUIRE(number == workspace.session.number());
        CHECK(workspace.session.file_name() == "lesson.json");
        CHECK(workspace.session.is_dirty());
        CHECK(workspace.session.document() == document);
    }

    TEST_CASE("Work that was kept survives, and is the same bit for bit")
    {
        const Folder folder;
        const ui::DraftFolder drafts{folder.path() / "state", ".json"};
        Workspace workspace = workspace_with("portal.json");
        workspace.session.change({"Move", [](Document& document) { document.model.nodes[1].at[0] = 0.1 + 0.2; }});
        {
            ui::Draft draft(drafts);
            REQUIRE_FALSE(draft.keep(workspace.unsaved().at(0).copy(), workspace.session.path()));
        }
        const auto found = ui::recoverable_files(drafts);
        REQUIRE(found.size() == 1);
        Workspace next{Session{Document{}}};
        REQUIRE(next.recover(found[0]));
        CHECK(next.session.document() == workspace.session.document());
        CHECK(next.session.path() == workspace.session.path());
    }

    TEST_CASE("A transformation shows at once what it does, and is one step when it is accepted, none when it is not")
    {
        Workspace workspace = workspace_with("portal.json");
        const Document before = workspace.session.document();
        run_soundly(workspace, "edit.select_all");
        const Selection selected = workspace.session.selection;
        run_soundly(workspace, "edit.mirror");
        CHECK(workspace.session.model().members.size() == 5); // the columns at the mirror are one
        CHECK(workspace.session.model().members.back().id == "FC");
        run_soundly(workspace, "edit.deselect");
        CHECK(workspace.session.document() == before);
        CHECK(workspace.session.selection == selected);
        CHECK(!workspace.session.history().can_undo());
        CHECK(!workspace.transform);
        run_soundly(workspace, "edit.copy");
        workspace.transform->times = 3;
        change_transform(workspace);
        run_soundly(workspace, "edit.accept");
        CHECK(workspace.session.model().members.size() == 9);
        CHECK(workspace.session.model().nodes.size() == 10); // neighbours share a column
        CHECK(workspace.session.history().n_states() == 2);
        run_soundly(workspace, "edit.undo");
        CHECK(workspace.session.document() == before);
    }

    TEST_CASE("A node is not taken so far off that others could not be told apart, by whatever numbers")
    {
        Workspace workspace = workspace_with("portal.json"); // its shortest member is 4.5 m long
        const Document before = workspace.session.document();
        const auto moved_to = [&](double x) {
            return workspace.session.change({"Move", [x](Document& document) { document.model.nodes[2].at[0] = x; }});
        };
        REQUIRE(moved_to(-1e100));
        CHECK(ui::Catalogue()(*moved_to(-1e100)) ==
              "nothing was changed: node C would lie 1e100 m off, where nodes beside each other are one; "
              "stay within 100000 m, and check the unit");
        CHECK(moved_to(-100001.0));
        CHECK(workspace.session.document() == before);
        CHECK(!workspace.session.history().can_undo());
        CHECK(!moved_to(-99999.0));
        CHECK(workspace.session.model().members.size() == before.model.members.size());
    }

    TEST_CASE("Where a file has a node very far off it may stay and come nearer, while others move")
    {
        Document document = starting_document();
        document.model.nodes[3].at[0] = 1e9;
        Session session(document);
        const auto moved = [&](std::size_t node, double x) {
            return session.change({"Move", [=](Document& next) { next.model.nodes[node].at[0] = x; }});
        };
        CHECK(!moved(0, -2.0));
        CHECK(!moved(3, 0.9e9));
        CHECK(moved(3, 1e9));
    }

    TEST_CASE("A transformation with numbers that lead too far keeps what was shown before")
    {
        Workspace workspace = workspace_with("portal.json");
        run_soundly(workspace, "edit.select_all");
        run_soundly(workspace, "edit.move");
        const Document shown = workspace.session.document();
        for (const double far : {1e7, 1e100, 1e300}) {
            workspace.transform->at[0] = far;
            CHECK(change_transform(workspace));
            CHECK(workspace.session.document() == shown);
        }
        run_soundly(workspace, "edit.deselect");
        run_soundly(workspace, "edit.scale");
        workspace.transform->factor = 1e9;
        CHECK(change_transform(workspace));
    }

    TEST_CASE("What was mirrored and joined is selected, and its members have the names of their nodes")
    {
        Workspace workspace = workspace_with("portal.json");
        run_soundly(workspace, "edit.select_all");
        run_soundly(workspace, "edit.mirror"); // about the right column
        run_soundly(workspace, "edit.accept");
        const femoop::Model& model = workspace.session.model();
        REQUIRE(model.members.size() == 5);
        for (const femoop::Member& member : model.members) CHECK(femoop::is_named_after_nodes(model, member));
        CHECK(model.nodes.back().id == "F");
        CHECK(workspace.session.selection.contains(NodeId(5)));
        CHECK(workspace.session.selection.contains(MemberId(4)));
        CHECK(!workspace.session.selection.contains(MemberId(0)));
    }

    TEST_CASE("A load case that goes out of combinations with its deletion is told, by drag or by click")
    {
        Workspace workspace = workspace_with("portal.json");
        const std::string name = workspace.session.model().load_cases[0].id;
        workspace.session.selection = Part(LoadCasePlace{0});
        run_soundly(workspace, "edit.delete");
        REQUIRE(workspace.session.notice);
        const std::string words = ui::Catalogue()(workspace.session.notice->sentence);
        CAPTURE(words);
        CHECK(words.starts_with(name + " went out of the combinations "));
        run_soundly(workspace, "edit.undo");
        CHECK(!workspace.session.notice); // it is back
        workspace.session.selection = Part(NodeId(0));
        run_soundly(workspace, "edit.nudge_up");
        CHECK(!workspace.session.notice);
    }

    TEST_CASE("Expected results that go with the part that they are about are told")
    {
        Workspace workspace = workspace_with("portal.json");
        workspace.session.change({"check", [](Document& document) {
                                      document.model.expected = {{.member = MemberId(1)}, {.member = MemberId(1)}};
                                  }});
        workspace.session.selection = Part(MemberId(1));
        run_soundly(workspace, "edit.delete");
        REQUIRE(workspace.session.notice);
        CHECK(ui::Catalogue()(workspace.session.notice->sentence).find("belong to: 2.") != std::string::npos);
    }

    TEST_CASE("A change that must be sound runs its command once")
    {
        Workspace workspace = workspace_with("portal.json");
        int n_runs = 0;
        CHECK(workspace.session.change_soundly(
            {"title", [&](Document& document) { document.model.title = std::to_string(++n_runs); }}));
        CHECK(n_runs == 1);
        CHECK(workspace.session.model().title == "1");
    }

    TEST_CASE("A quarter turn is exact: what stood upright lies level")
    {
        Workspace workspace = workspace_with("portal.json");
        workspace.session.selection = Part(MemberId(0));
        workspace.session.selection.add(NodeId(0));
        Transform transform = transform_of(Transform::Kind::Rotate, workspace.session.model(),
                                           workspace.session.selection);
        transform.at = {0.0, 0.0, 0.0};
        workspace.session.change(transform.change(workspace.session.model()));
        const auto& at = workspace.session.model().nodes[1].at;
        CHECK(at[0] == -4.5);
        CHECK(at[1] == 0.0);
    }

    TEST_CASE("Undoing a new, copied or deleted case shows again what was shown, and redoing shows the new one")
    {
        Workspace workspace = workspace_with("portal.json");
        const auto shown = [&] { return workspace.session.model().case_name(workspace.session.view.load_case); };
        for (const char* const command : {"case.new", "case.combination", "case.copy", "case.delete"}) {
            CAPTURE(command);
            show_case(workspace.session, *workspace.session.model().find_case("Q"));
            run_soundly(workspace, command);
            const std::string after = shown();
            CHECK(after != "Q");
            workspace.session.undo();
            CHECK(shown() == "Q");
            workspace.session.redo();
            CHECK(shown() == after);
            workspace.session.undo();
        }
        workspace.session.view.is_envelope = true;
        run_soundly(workspace, "case.combination");
        workspace.session.undo();
        CHECK(workspace.session.view.is_envelope);
    }

    TEST_CASE("In space a selection is copied, mirrored at a plane, turned about an axis and moved by the arrow keys")
    {
        Workspace workspace = workspace_with("bent_cantilever.json");
        const femoop::Model before = workspace.session.model();
        const auto place = [&](std::size_t node) { return position_of(workspace.session.model(), NodeId(node)); };
        const auto transformed = [&](Transform::Kind kind, const auto& set) {
            workspace.session.selection = Part(MemberId(0));
            Transform transform = transform_of(kind, before, workspace.session.selection);
            set(transform);
            workspace.session.change(transform.change(before));
        };
        const Eigen::Vector3d a = position_of(before, NodeId(0)), b = position_of(before, NodeId(1));
        const std::size_t n = before.nodes.size();
        transformed(Transform::Kind::Copy, [](Transform& transform) { transform.at = {0.0, 0.0, 7.0}; });
        REQUIRE(workspace.session.model().nodes.size() == n + 2);
        CHECK(place(n).isApprox(a + Eigen::Vector3d(0, 0, 7)));
        workspace.session.cancel();
        transformed(Transform::Kind::Mirror, [](Transform& transform) {
            transform.normal = WorkingPlane::Normal::Y;
            transform.at[1] = 11.0;
        });
        REQUIRE(workspace.session.model().nodes.size() == n + 2);
        CHECK(place(n + 1).isApprox(Eigen::Vector3d(b.x(), 22.0 - b.y(), b.z())));
        workspace.session.cancel();
        transformed(Transform::Kind::Rotate, [](Transform& transform) {
            transform.normal = WorkingPlane::Normal::X;
            transform.at = {0.0, 0.0, 0.0};
        });
        CHECK(place(1).isApprox(Eigen::Vector3d(b.x(), -b.z(), b.y())));
        workspace.session.cancel();
        workspace.session.selection = Part(NodeId(1));
        workspace.tool_controller.settings().grid = 0.5;
        workspace.tool_controller.settings().plane.normal = WorkingPlane::Normal::Y;
        run_soundly(workspace, "edit.nudge_up");
        CHECK(place(1).isApprox(b + Eigen::Vector3d(0, 0, 0.5)));
    }

    TEST_CASE("Arrow keys move the selection by the grid, and what it meets is joined")
    {
        Workspace workspace = workspace_with("portal.json");
        workspace.session.selection = Part(NodeId(1));
        workspace.tool_controller.settings().grid = 0.5;
        const double before = workspace.session.model().nodes[1].at[0];
        run_soundly(workspace, "edit.nudge_right");
        CHECK(workspace.session.model().nodes[1].at[0] == before + 0.5);
    }

    TEST_CASE("Deleting is one step, and nothing is selected then")
    {
        Workspace workspace = workspace_with("portal.json");
        workspace.session.selection = Part(MemberId(1));
        run_soundly(workspace, "edit.delete");
        CHECK(workspace.session.model().members.size() == 2);
        CHECK(workspace.session.selection.is_empty());
        CHECK(ui::why_not(*command_table().find("edit.delete"), workspace));
    }
}

TEST_CASE("A moment stands where its menu was asked for, and from the palette at the middle")
{
    const auto place = [](std::optional<Cut> menu_cut) {
        Workspace workspace = workspace_with("portal.json");
        workspace.session.selection = Part(MemberId(1));
        workspace.menu_cut = menu_cut;
        run_soundly(workspace, "load.moment");
        const auto& loads = workspace.session.model().load_cases.front().members;
        return femoop::along(std::get<femoop::PointLoad>(loads.back().load).at, 8.0);
    };
    CHECK(place(Cut{MemberId(1), 2.24}) == doctest::Approx(2.24));
    CHECK(place(Cut{MemberId(0), 2.24}) == doctest::Approx(4.0));
    CHECK(place(std::nullopt) == doctest::Approx(4.0));
}

TEST_CASE("The properties of a case are those of the case that is shown")
{
    Workspace workspace = workspace_with("portal.json");
    run_soundly(workspace, "case.combination");
    const Part first = *workspace.session.selection.only();
    run_soundly(workspace, "case.copy");
    REQUIRE(workspace.session.selection.only());
    CHECK(*workspace.session.selection.only() != first);
    CHECK(case_id_of(workspace.session.model(), *workspace.session.selection.only()) ==
          workspace.session.view.load_case);
    show_case(workspace.session, femoop::CaseId(0));
    CHECK(workspace.session.selection.only() == Part(LoadCasePlace{0}));
    workspace.session.selection = Part(MemberId(1));
    show_case(workspace.session, femoop::CaseId(1));
    CHECK(workspace.session.selection.only() == Part(MemberId(1)));
}

TEST_CASE("A window opens with the table that it was left with")
{
    Workspace left = workspace_with("portal.json");
    const std::string without = left.kept_tools();
    run_soundly(left, "view.table.node_loads");
    CHECK(left.kept_tools() == without + " table node_loads");
    Workspace next = workspace_with("portal.json");
    next.take_up_tools(left.kept_tools());
    CHECK(next.bottom.is_open);
    CHECK(next.bottom.table == TableKind::NodeLoads);
    CHECK(next.kept_tools() == left.kept_tools());

    Workspace other = workspace_with("portal.json");
    other.take_up_tools(without);
    CHECK_FALSE(other.bottom.is_open);
    other.take_up_tools(without + " table of a later version");
    CHECK_FALSE(other.bottom.is_open);
    run_soundly(left, "view.member_results"); // of one member, which another model lacks
    CHECK(left.kept_tools() == without);
}

TEST_CASE("Nothing can be taken over where no linked window offers a change")
{
    Workspace workspace = workspace_with("portal.json");
    for (const char* const id : {"edit.take_over", "edit.keep"}) {
        CAPTURE(id);
        CHECK(ui::why_not(*command_table().find(id), workspace));
    }
    workspace.offer = "Moment distribution has changed the structure";
    run_soundly(workspace, "edit.take_over");
    CHECK(workspace.asked == std::vector{ui::Request::TakeOver});
}

TEST_CASE("Where little is to move a mechanism rests at its largest displacement until it is animated, in every tab")
{
    Workspace workspace = workspace_with("mechanism.json");
    workspace.tick(0.7);
    CHECK(std::abs(workspace.session.draw_state.phase) < 0.9);
    workspace.session.is_still = true;
    workspace.tick(0.7);
    CHECK(workspace.session.draw_state.phase == 1.0);
    CHECK_FALSE(workspace.is_moving());
    run_soundly(workspace, "view.animate");
    workspace.tick(0.7);
    CHECK(std::abs(workspace.session.draw_state.phase) < 0.9);
    REQUIRE(open_file(workspace, examples + "truss.json"));
    CHECK(workspace.session.is_still);
}
