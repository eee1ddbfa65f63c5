#include <doctest/doctest.h>

#include <string>

#include "apps/euler/session/commands.h"
#include "tests/apps/recovered.h"

using namespace euler;

TEST_SUITE("euler session")
{
    TEST_CASE("A script that a crash has cost opens with its steps and comments, as one that is not saved")
    {
        const Folder folder;
        Desk desk{Session()};
        desk.session.show(Stepper("# A point\nmvfs s1 f1 v1 0 0 0\n"));
        CHECK(desk.unsaved().empty());
        REQUIRE(!desk.session.apply("mev s1 f1 v1 v2 1 0 0"));
        CHECK(recovered(desk, folder, ".eul").session.stepper().script() == desk.session.stepper().script());
    }

    TEST_CASE("A draft has the steps that its script had when it was taken")
    {
        const Folder folder;
        Desk desk{Session()};
        desk.session.apply("mvfs s1 f1 v1 0 0 0");
        const ui::Unsaved before = desk.unsaved().at(0);
        const ui::WriteDocument write = before.copy();
        desk.session.apply("kvfs s1 f1");
        CHECK(desk.unsaved().at(0).state != before.state);
        REQUIRE(!write(folder.path() / "1-0.eul"));
        REQUIRE(desk.session.open(folder.path() / "1-0.eul"));
        CHECK(desk.session.stepper().script() == "mvfs s1 f1 v1 0 0 0\n");
    }

    TEST_CASE("A script is as it was saved when the same step is done again")
    {
        Desk desk{Session()};
        desk.session.show(Stepper("mvfs s1 f1 v1 0 0 0\n"));
        desk.session.apply("mev s1 f1 v1 v2 1 0 0");
        CHECK(desk.session.is_dirty());
        desk.session.go_to(0);
        desk.session.apply("mvfs s1 f1 v1 0 0 0");
        CHECK(!desk.session.is_dirty());
    }
}
