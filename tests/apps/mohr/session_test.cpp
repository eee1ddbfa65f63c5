#include <doctest/doctest.h>

#include <string_view>

#include "apps/mohr/session/commands.h"
#include "tests/apps/recovered.h"

using namespace mohr;

TEST_CASE("A state that a crash has cost opens as it was typed, as one that is not saved")
{
    const Folder folder;
    Workspace workspace{Session()};
    CHECK(workspace.unsaved().empty());
    workspace.session.set_number({Group::State, 2}, "33,3 MPa");
    CHECK(recovered(workspace, folder, ".mohr").session.document() == workspace.session.document());
}

TEST_CASE("After the projector the theme and the panels are those from before")
{
    Workspace workspace{Session()};
    const CommandTable commands = command_table();
    const auto do_it = [&](std::string_view id) { CHECK_FALSE(ui::run(*commands.find(id), workspace)); };
    do_it("view.theme.dark");
    do_it("view.project");
    CHECK(workspace.theme() == ui::ThemeName::Projector);
    CHECK_FALSE(workspace.has_panels);
    do_it("view.project");
    CHECK(workspace.theme() == ui::ThemeName::Dark);
    CHECK(workspace.has_panels);
}

TEST_CASE("An answer that is given up is shown, not right, and what the pupil had can still be read")
{
    Session session;
    session.begin_exercise(ExerciseTopic::PlaneStress, Difficulty::Medium, 5);
    const Practice& practice = *session.practice();
    REQUIRE_FALSE(session.answer(0, "12345.5"));
    CHECK(practice.judgements()[0].verdict == Verdict::Wrong);
    session.give_up_exercise();
    CHECK(practice.judgements()[0].verdict == Verdict::Shown);
    CHECK(practice.own_answer(0) == 12345.5);
    CHECK(practice.answers()[0] != 12345.5);
    CHECK(practice.judgements()[1].verdict == Verdict::Shown);
    CHECK_FALSE(practice.own_answer(1));
    CHECK(practice.is_finished());
    CHECK(practice.points() == 0);
}
