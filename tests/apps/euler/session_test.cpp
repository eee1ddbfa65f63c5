#include <doctest/doctest.h>

#include <string>

#include "apps/euler/session/commands.h"
#include "tests/apps/recovered.h"
#include "ui/app/settings.h"

using namespace euler;

TEST_SUITE("euler session")
{
    TEST_CASE("A script that a crash has cost opens with its steps and comments, as one that is not saved")
    {
        const Folder folder;
        Workspace workspace{Session()};
        workspace.session.show(Stepper("# A point\nmvfs s1 f1 v1 0 0 0\n"));
        CHECK(workspace.unsaved().empty());
        REQUIRE(!workspace.session.apply("mev s1 f1 v1 v2 1 0 0"));
        CHECK(recovered(workspace, folder, ".eul").session.stepper().script() == workspace.session.stepper().script());
    }

    TEST_CASE("What was left on the projector without panels begins with the whole window for the picture")
    {
        Workspace workspace{Session()};
        ui::begin_as_left(workspace, {.theme = ui::ThemeName::Projector, .has_panels = false});
        CHECK(!workspace.has_panels);
        CHECK(!workspace.has_tables);
        Workspace other{Session()};
        ui::begin_as_left(other, {.theme = ui::ThemeName::Light, .has_panels = false});
        CHECK(!other.has_panels);
        CHECK(other.has_tables);
    }

    TEST_CASE("A draft has the steps that its script had when it was taken")
    {
        const Folder folder;
        Workspace workspace{Session()};
        workspace.session.apply("mvfs s1 f1 v1 0 0 0");
        const ui::UnsavedDocument before = workspace.unsaved().at(0);
        const ui::WriteDocument write = before.copy();
        workspace.session.apply("kvfs s1 f1");
        CHECK(workspace.unsaved().at(0).state != before.state);
        REQUIRE(!write(folder.path() / "1-0.eul"));
        REQUIRE(workspace.session.open(folder.path() / "1-0.eul"));
        CHECK(workspace.session.stepper().script() == "mvfs s1 f1 v1 0 0 0\n");
    }

    TEST_CASE("Where little is to move a step is done at once, forward and back, and a script is played at its pace")
    {
        Session session;
        session.show(Stepper("mvfs s1 f1 v1 0 0 0\nmev s1 f1 v1 v2 1 0 0\nmev s1 f1 v2 v3 1 2 0\n"));
        session.is_still = true;
        session.go_to(0);
        session.step_forward();
        CHECK_FALSE(session.is_moving());
        session.step_forward();
        session.step_back();
        CHECK_FALSE(session.is_moving());
        CHECK(session.step() == 1);
        CHECK_FALSE(session.transition());
        session.is_playing = true;
        for (int i = 0; i < 9; ++i) session.tick(0.1); // of 0.6 s each
        CHECK(session.step() == 2);
    }

    TEST_CASE("A script is as it was saved when the same step is done again")
    {
        Workspace workspace{Session()};
        workspace.session.show(Stepper("mvfs s1 f1 v1 0 0 0\n"));
        workspace.session.apply("mev s1 f1 v1 v2 1 0 0");
        CHECK(workspace.session.is_dirty());
        workspace.session.go_to(0);
        workspace.session.apply("mvfs s1 f1 v1 0 0 0");
        CHECK(!workspace.session.is_dirty());
    }

    TEST_CASE("A script with a fault is open up to it, under no path until its text is mended")
    {
        const Folder folder;
        const auto file = folder.write("late.eul", "mvfs s1 f1 v1 0 0 0\nmev s1 f1 v9 v2 1 0 0\nkvfs s1 f1\n");
        Workspace workspace{Session()};
        REQUIRE(workspace.session.open(file));
        CHECK(workspace.session.n_steps() == 1);
        CHECK(workspace.session.faulty_line == 2);
        CHECK(workspace.session.file_name() == "late.eul");
        CHECK(!workspace.session.path());
        CHECK(!workspace.session.accept_text());
        CHECK(!workspace.session.path());
        workspace.session.edited_text = "mvfs s1 f1 v1 0 0 0\nmev s1 f1 v1 v2 1 0 0\n";
        REQUIRE(workspace.session.accept_text());
        CHECK(workspace.session.n_steps() == 2);
        CHECK(workspace.session.path() == file);
        CHECK(!workspace.session.faulty_line);
    }

    TEST_CASE("What is neither a script nor a text that can be edited is not opened")
    {
        const Folder folder;
        Workspace workspace{Session()};
        workspace.session.apply("mvfs s1 f1 v1 0 0 0");
        CHECK(!workspace.session.open(folder.write("picture.eul", "\x89PNG\r\n\xff\xfe")));
        CHECK(workspace.session.n_steps() == 1);
        CHECK(workspace.session.notice);
    }

    const std::string line_of_two = "# A line\nmvfs s1 f1 v1 0 0 0\n\n# grows\nmev s1 f1 v1 v2 1 0 0\n";

    TEST_CASE("A written line that cannot be applied is told with the number that it would have, comments counted")
    {
        Workspace workspace{Session()};
        workspace.session.show(Stepper(line_of_two));
        CHECK(!workspace.session.write("mev s1 f1 v9 v3 0 1 0"));
        REQUIRE(workspace.session.script_fault);
        CHECK(ui::Catalogue()(*workspace.session.script_fault) == "line 3: there is no vertex v9 in s1");
        workspace.session.go_to(2);
        CHECK(!workspace.session.script_fault);
        CHECK(!workspace.session.write("# a comment"));
        CHECK(!workspace.session.write("mev s1 f1 v9 v3 0 1 0"));
        CHECK(ui::Catalogue()(*workspace.session.script_fault) == "line 6: there is no vertex v9 in s1");
        CHECK(!workspace.session.is_dirty());
        CHECK(workspace.session.write("mev s1 f1 v2 v3 0 1 0"));
        CHECK(workspace.session.place() == 3);
    }

    TEST_CASE("A text takes the place of the script whole, and who was at its end is at the new end")
    {
        Workspace workspace{Session()};
        workspace.session.show(Stepper(line_of_two));
        workspace.session.edit_text();
        CHECK(*workspace.session.edited_text == line_of_two);
        *workspace.session.edited_text += "mev s1 f1 v2 v3 0 1 0\n";
        CHECK(workspace.session.accept_text()); // at the first step
        CHECK(workspace.session.place() == 1);
        CHECK(workspace.session.n_steps() == 3);
        CHECK(workspace.session.is_dirty());
        workspace.session.go_to(3);
        workspace.session.edit_text();
        *workspace.session.edited_text += "mef s1 f1 v1 v3 f2\n";
        CHECK(workspace.session.accept_text());
        CHECK(workspace.session.place() == 4);
    }

    TEST_CASE("A text with a fault changes nothing and stays to be mended")
    {
        Workspace workspace{Session()};
        workspace.session.show(Stepper(line_of_two));
        workspace.session.edit_text();
        *workspace.session.edited_text = "mvfs s1 f1 v1 0 0 0\nmev s1 f2 v1 v2 1 0 0\n";
        CHECK(!workspace.session.accept_text());
        CHECK(ui::Catalogue()(*workspace.session.script_fault) ==
              "line 2: mev s1 f2 v1 v2 1 0 0: there is no face f2 in s1");
        CHECK(workspace.session.edited_text);
        CHECK(workspace.session.stepper().script() == line_of_two);
        workspace.session.new_document();
        CHECK(!workspace.session.edited_text); // it was another script's
    }

    TEST_CASE("A script longer than a hand edits is not edited as text")
    {
        Workspace workspace{Session()};
        workspace.session.show(Stepper("mvfs s1 f1 v1 0 0 0\n"));
        CHECK(!workspace.session.why_not_edit_text());
        workspace.session.show(
            Stepper("# " + std::string(Session::most_letters_of_line, 'x') + "\nmvfs s1 f1 v1 0 0 0\n"));
        CHECK(workspace.session.why_not_edit_text());
        std::string comments;
        for (std::size_t i = 0; i < Session::most_letters_of_text / 10; ++i) comments += "# comment\n";
        workspace.session.show(Stepper(comments + "mvfs s1 f1 v1 0 0 0\n"));
        CHECK(workspace.session.why_not_edit_text());
    }
}
