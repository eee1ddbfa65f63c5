// What stands in place of the results of a case: what was asked for last is what one sees.
#include "apps/frame/session/shown_method.h"

#include <doctest/doctest.h>

#include "apps/frame/session/funicular_commands.h"
#include "apps/frame/session/truss_commands.h"
#include "apps/frame/session/virtual_work_commands.h"
#include "tests/apps/frame/example_workspace.h"
#include "tests/latex_document.h"

using namespace frame;
using frame_test::run;
using frame_test::workspace_with;

namespace {

void lift_first_node(Session& session) { session.free_body.lift(session.model(), femoop::NodeId(0)); }

void ask_for_line(Session& session)
{
    session.influence.ask(session.model(), drawing::Cut{*session.model().find_member("BC"), 2.4});
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("A Cremona diagram that is asked for while a free body is shown is seen, and a click drags a node again")
    {
        Workspace workspace = workspace_with("pratt_truss.json");
        Session& session = workspace.session;
        CHECK_FALSE(run(workspace, "draw.free_body"));
        lift_first_node(session);
        CHECK_FALSE(run(workspace, "view.cremona"));
        CHECK_FALSE(session.free_body.is_on(session.model()));
        CHECK(shown_truss(session) != nullptr);
        CHECK(workspace.tool_controller.kind() == ToolKind::Select);
    }

    TEST_CASE("A frame has none of the methods of a plane truss, and the refusal names each of them")
    {
        Workspace workspace = workspace_with("portal.json");
        for (const char* method : {"view.zero_forces", "view.joints", "view.cremona"}) {
            CAPTURE(method);
            CHECK(run(workspace, method) == "zero-force bars, joints and Cremona diagrams are those of a plane truss");
        }
    }

    TEST_CASE("Whatever method is shown can be written as LaTeX, and nothing where none is")
    {
        Workspace truss = workspace_with("pratt_truss.json");
        CHECK(shown_method_latex(truss.session).empty());
        for (const char* method : {"view.zero_forces", "view.joints", "view.cremona"}) {
            CAPTURE(method);
            CHECK_FALSE(run(truss, method));
            CHECK(shown_method_latex(truss.session).starts_with("\\section*{"));
            CHECK(fault_of_latex(shown_method_latex(truss.session)) == "");
        }
        lift_first_node(truss.session);
        truss.session.truss.close();
        CHECK(shown_method_latex(truss.session).starts_with("\\section*{Free body: node L0}\n"));
        CHECK(fault_of_latex(shown_method_latex(truss.session)) == "");
        Workspace arch = workspace_with("three_hinged_arch.json");
        begin_funicular(arch);
        CHECK(shown_method_latex(arch.session).starts_with("\\section*{Funicular over "));
        begin_virtual_work(arch);
        arch.session.virtual_work.ask(arch.session.model(), femoop::NodeId(2));
        CHECK(shown_method_latex(arch.session).starts_with("\\section*{uy(C) = "));
        arch.session.hidden.emplace();
        CHECK(shown_method_latex(arch.session).empty());
    }

    TEST_CASE("The degree of indeterminacy is counted where a truss was worked out, or a free body lifted")
    {
        Workspace workspace = workspace_with("pratt_truss.json");
        Session& session = workspace.session;
        CHECK_FALSE(run(workspace, "view.cremona"));
        CHECK_FALSE(run(workspace, "view.show.counting"));
        CHECK(shown_truss(session) == nullptr);
        CHECK(session.view.show.contains(Show::Counting));
        lift_first_node(session);
        CHECK_FALSE(run(workspace, "view.show.counting"));
        CHECK(session.free_body.is_on(session.model())); // which comes to the fore as the count ends
        CHECK_FALSE(run(workspace, "view.show.counting"));
        CHECK_FALSE(session.free_body.is_on(session.model()));
    }

    TEST_CASE("A free body that is lifted out while an influence line is shown takes its place, and the other way")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        CHECK_FALSE(run(workspace, "draw.influence"));
        ask_for_line(session);
        CHECK_FALSE(run(workspace, "draw.free_body"));
        CHECK_FALSE(session.influence.is_on(session.model()));
        lift_first_node(session);
        ask_for_line(session);
        session.selection = Part(femoop::NodeId(1));
        CHECK_FALSE(run(workspace, "view.free_body.selected"));
        CHECK_FALSE(session.influence.is_on(session.model()));
        CHECK(session.free_body.is_on(session.model()));
        CHECK_FALSE(run(workspace, "draw.influence"));
        CHECK_FALSE(session.free_body.is_on(session.model()));
    }
}
