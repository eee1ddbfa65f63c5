// The funicular that is looked at: how it is dragged, and how it follows what is asked and what changes.
#include "apps/frame/session/funicular_commands.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "apps/frame/document/command.h"
#include "apps/frame/document/drawing.h"
#include "tests/apps/frame/example_workspace.h"

using namespace frame;
using drawing::FunicularHandle;
using frame_test::run;
using frame_test::workspace_with;

namespace {

const FunicularPicture& shown(const Session& session)
{
    const FunicularPicture* const picture = shown_funicular(session);
    REQUIRE(picture != nullptr);
    return *picture;
}

void erase_member(Session& session, const std::string& name)
{
    const femoop::MemberId member = *session.model().find_member(name);
    session.change({"", [member](Document& document) {
                        const std::vector<Part> parts{member};
                        remove(document, parts);
                    }});
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("A three-hinged arch begins with its line of thrust, and a dragged closing line leaves H and ordinates")
    {
        Workspace workspace = workspace_with("three_hinged_arch.json");
        Session& session = workspace.session;
        CHECK(run(workspace, "view.funicular.hinge") ==
              "no funicular is shown; select an arch or a beam and press Shift+F");
        CHECK_FALSE(run(workspace, "draw.funicular"));
        const double H = shown(session).funicular.H, eta = shown(session).funicular.ordinate(7.3);
        CHECK(H == doctest::Approx(960.0 / 6.0)); // M0 / f at the hinge
        session.funicular.drag(FunicularHandle::LeftEnd, -1.37);
        session.funicular.drag(FunicularHandle::RightEnd, 2.13);
        CHECK(shown(session).funicular.H == doctest::Approx(H));
        CHECK(shown(session).funicular.ordinate(7.3) == doctest::Approx(eta));
        CHECK(shown(session).funicular.closing(24.0) == doctest::Approx(2.13));
        session.funicular.drag(FunicularHandle::Rise, 0.5 * (2.13 - 1.37) + 3.7);
        CHECK(shown(session).funicular.H == doctest::Approx(960.0 / 3.7));
        CHECK_FALSE(run(workspace, "view.funicular.hinge"));
        CHECK(shown(session).funicular.H == doctest::Approx(H));
        CHECK_FALSE(run(workspace, "view.funicular.close"));
        CHECK(shown_funicular(session) == nullptr);
    }

    TEST_CASE("A rise that is dragged onto its closing line stays a hand's breadth off, on the side it came to")
    {
        Workspace workspace = workspace_with("three_hinged_arch.json");
        Session& session = workspace.session;
        run(workspace, "draw.funicular");
        shown(session);
        session.funicular.drag(FunicularHandle::Rise, 0.0);
        CHECK(shown(session).funicular.rise() > 0.0);
        session.funicular.drag(FunicularHandle::Rise, -1e-9);
        CHECK(shown(session).funicular.rise() < 0.0);
        CHECK(shown(session).funicular.H < 0.0);
    }

    TEST_CASE("It follows the load case with the rise that was dragged, and is not shown over an envelope")
    {
        Workspace workspace = workspace_with("three_hinged_arch.json");
        Session& session = workspace.session;
        run(workspace, "draw.funicular");
        shown(session);
        session.funicular.drag(FunicularHandle::Rise, 4.5);
        session.view.load_case = femoop::CaseId(1);
        CHECK(shown(session).funicular.H == doctest::Approx(450.0 / 4.5));
        session.view.is_envelope = true;
        CHECK(shown_funicular(session) == nullptr);
        CHECK(run(workspace, "draw.funicular") == "an envelope is of several cases; choose one");
    }

    TEST_CASE("It ends with the last of its members, and comes back with them")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        session.selection = Part(*session.model().find_member("BC"));
        run(workspace, "draw.funicular");
        CHECK(shown(session).chain.links.size() == 1);
        erase_member(session, "BC");
        CHECK_FALSE(session.funicular.is_on(session.model()));
        CHECK(shown_funicular(session) == nullptr);
        session.undo();
        CHECK(shown(session).chain.links.size() == 1);
    }

    TEST_CASE("A structure that only moves has a funicular too; one without members says that it has no chain")
    {
        Workspace workspace = workspace_with("three_hinged_arch.json");
        Session& session = workspace.session;
        session.change({"", [](Document& document) { document.model.nodes[8].support.reset(); }});
        REQUIRE_FALSE(session.solution().results);
        CHECK_FALSE(run(workspace, "draw.funicular"));
        CHECK(shown(session).funicular.H == doctest::Approx(160.0));
        CHECK_FALSE(shown(session).chain.is_three_hinged_arch);
        for (const char* name : {"AB", "BC", "CD", "DE", "EF", "FG", "GH", "HI"}) erase_member(session, name);
        CHECK(shown_funicular(session) == nullptr);
        Workspace empty{Session{Document{}}};
        CHECK(run(empty, "draw.funicular") == "the model has no members");
    }
}
